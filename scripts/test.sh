#!/bin/sh
# Builds and runs the tests: everything in release, the folders' own tests again under the sanitizers (debug).
# Usage: sh scripts/test.sh [--ci] [--long] [CTEST OPTIONS]
#   --ci     also those labelled `ci`: a build by clang with Make, Debian's packages; installs what these need
#   --long   also those labelled `long` (minutes each), and `ci` where what they need is there
#   Further options go to ctest, e.g. -R linsolve
set -eu

cd "$(dirname "$0")/.."
left='^(long|ci)$'
while :; do
    case "${1-}" in
    --ci)
        sh scripts/setup.sh --lint
        sh scripts/setup.sh --deb
        left='^long$'
        ;;
    --long) left= ;;
    *) break ;;
    esac
    shift
done

sh scripts/setup.sh --web
sh scripts/setup.sh --python
sh scripts/build.sh release
sh scripts/build.sh debug

# One ctest over both build folders, so that its summary, the last thing printed, counts every test.
mkdir -p build/tests
printf 'subdirs("../release" "../debug")\n' >build/tests/CTestTestfile.cmake
[ -z "$left" ] || set -- -LE "$left" "$@"

# A leak or an overflow must end the test that has it; leak reports name the place.
ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1
UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS UBSAN_OPTIONS
exec ctest --test-dir build/tests --output-on-failure --no-tests=error -j "$(nproc)" "$@"
