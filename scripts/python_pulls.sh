#!/bin/sh
# Many pulls in four Python threads over shared cases, under a sanitizer: the same bits as alone, and no report (tests/python/pulls.py).
# Usage: sh scripts/python_pulls.sh asan|tsan [PULLS [SECONDS]]      (100000 pulls by default; seconds of processor time)
set -eu

cd "$(dirname "$0")/.."
preset=$1
library=libasan.so
[ "$preset" = asan ] || library=libtsan.so
build=$PWD/build/$preset
cmake --preset "$preset" >/dev/null
cmake --build "$build" --target hawser_shared
package=$build/python
rm -rf "$package" && mkdir -p "$package/hawser/share/hawser"
cp -r python/hawser/. "$package/hawser"
cp python/*.py python/*.toml "$package"
cp -r library "$package/hawser/share/hawser/library"
cat >"$package/native.json" <<JSON
{"version": "0", "include": "$PWD/include", "objects": [], "link": ["-L$build", "-lhawser", "-Wl,-rpath,$build"]}
JSON
(cd "$package" && /usr/bin/python3 -B setup.py -q build_ext --inplace)
LD_PRELOAD=$(gcc -print-file-name=$library) ASAN_OPTIONS=detect_leaks=0 TSAN_OPTIONS=halt_on_error=1 PYTHONPATH=$package PYTHONSAFEPATH=1 \
    /usr/bin/python3 -B tests/python/pulls.py "${2-100000}" ${3-}
