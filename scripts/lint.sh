#!/bin/sh
# Format, static analysis, a second compiler.
# Usage: sh scripts/lint.sh [--fix]        (--fix: formats the files instead of complaining)
set -eu

case "${1-}" in
'' | --fix) ;;
*)
    echo "usage: sh scripts/lint.sh [--fix]" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
sh scripts/setup.sh --lint
each_source() { # each_source COMMAND...: the command with every C file of the tree
    find include core contact linsolve def sim theory survey validate io study cli fmi mpi tests bench -name '*.[ch]' -print0 | xargs -0 "$@"
}
if [ "${1-}" = --fix ]; then
    each_source clang-format -i
fi
each_source clang-format --dry-run -Werror

# The clang build compiles with the same warnings as gcc's, and its compile commands are what clang-tidy understands.
sh scripts/build.sh clang
# Asserts stay in (-UNDEBUG): they tell the analyser what cannot happen.
# One file a call, and each once, also those that two libraries have: with several, clang-tidy 14 takes the second one's va_list for uninitialised.
mkdir -p build/clang/tidy
python3 -c 'import json, sys; json.dump(list({each["file"]: each for each in reversed(json.load(sys.stdin))}.values()), sys.stdout)' \
    <build/clang/compile_commands.json >build/clang/tidy/compile_commands.json
echo "Running clang-tidy (.clang-tidy)"
find core contact linsolve def sim theory survey validate io study cli fmi mpi -name '*.c' -print0 |
    xargs -0 -P "$(nproc)" -n 1 clang-tidy -p build/clang/tidy --quiet --extra-arg=-UNDEBUG --warnings-as-errors='*' \
        2>build/clang/tidy.log
echo "lint: nothing to complain about"
