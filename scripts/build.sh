#!/bin/sh
# Configures and builds one preset into build/PRESET, quietly: the output goes to a log whose end is shown if something fails.
# Usage: sh scripts/build.sh PRESET [TARGET...]        (presets: CMakePresets.json; default: every target)
set -eu

preset=${1:?"usage: sh scripts/build.sh PRESET [TARGET...]"}
shift
[ $# -gt 0 ] || set -- all
cd "$(dirname "$0")/.."
mkdir -p "build/$preset"
log=build/$preset/build.log

echo "Building $preset (log: $log)"
if ! { cmake --preset "$preset" && cmake --build --preset "$preset" --target "$@"; } >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "build.sh: the $preset build failed; all of it is in $log" >&2
    exit 1
fi
