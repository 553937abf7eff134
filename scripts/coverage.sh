#!/bin/sh
# Which lines and branches the tests reach, folder by folder, and whether that is enough (docs/reliability.md).
# Usage: sh scripts/coverage.sh [CTEST OPTIONS]        (default: -LE "full|house|web|python|inject|fuzz")
#   The build is build/coverage; a page for each file is build/coverage/html/index.html. Status 1: a folder is below its floor.
set -eu

cd "$(dirname "$0")/.."
sh scripts/setup.sh --coverage
sh scripts/build.sh coverage
find build/coverage -name '*.gcda' -delete
[ $# -gt 0 ] || set -- -LE "full|house|web|python|inject|fuzz"
# a test that fails is no reason to measure nothing: the tests proper are another script's
ctest --test-dir build/coverage -j "$(nproc)" "$@" >build/coverage/tests.log || tail -n 12 build/coverage/tests.log
mkdir -p build/coverage/html
gcovr --root . --object-directory build/coverage --exclude-throw-branches --exclude-unreachable-branches \
    --gcov-ignore-parse-errors --exclude 'tests/' --exclude 'build/' --exclude 'bench/' \
    --json-summary build/coverage/summary.json --html-details build/coverage/html/index.html >build/coverage/gcovr.log
exec python3 scripts/coverage_floors.py build/coverage/summary.json
