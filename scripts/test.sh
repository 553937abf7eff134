#!/bin/sh
# Builds and runs tests. CONTRIBUTING.md says what each tier is for.
# Usage: sh scripts/test.sh [quick|full [PART]] [CTEST OPTIONS]
#   quick       what takes a moment, of the release build alone; `-L theory` takes one folder's
#   (nothing)   the default tier: quick, the longer tests of the release build, and AddressSanitizer over readers and engine
#   full        everything; PART 1 to 4 takes a quarter (about an hour each): 1 the default tier and the release build's rest, 2 both
#               sanitizers with all instruction sets, 3 what builds and packages, failing calls, random inputs, 4 ThreadSanitizer,
#               MemorySanitizer, mutants. Writes the processor times of the slowest tests to build/tests/suite.md
#   Further options go to ctest, e.g. -R linsolve
set -eu

cd "$(dirname "$0")/.."
tier=default
part=all
case "${1-}" in
quick | default | full)
    tier=$1
    shift
    case "${1-}" in
    [1-4])
        part=$1
        shift
        ;;
    esac
    ;;
esac

# A leak or an overflow must end the test that has it; leak reports name the place. Freed blocks are kept until 32 MB more are freed: with
# the usual 256 MB the tests spend a third of their time on fresh pages.
ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:quarantine_size_mb=32
UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS UBSAN_OPTIONS

# run_tests "PRESET..." CTEST OPTIONS: one ctest over several build folders, so that its summary, the last thing printed, counts every test.
run_tests() {
    presets=$1
    shift
    mkdir -p build/tests
    for preset in $presets; do
        sh scripts/build.sh "$preset" >&2 || return
        echo "subdirs(\"../$preset\")"
    done >build/tests/CTestTestfile.cmake
    # one more than there are cores, since several tests only wait
    ctest --test-dir build/tests --output-on-failure --no-tests=error -j "$(($(nproc) + 1))" "$@"
}

# ThreadSanitizer, MemorySanitizer, mutants.
run_others() {
    for preset in tsan msan; do
        cmake --preset $preset >/dev/null && cmake --build --preset $preset >build/$preset.log && ctest --preset $preset "$@" || return
    done
    for step in "make --count 200" "run --minutes 45" report; do
        # shellcheck disable=SC2086 # words of options
        /usr/bin/python3 scripts/mutants.py $step || return
    done
}

sh scripts/setup.sh --python
[ $tier = quick ] || sh scripts/setup.sh --web
if [ $tier = quick ]; then
    run_tests release -L '^quick$' "$@"
elif [ $tier = default ]; then
    run_tests "release asan" -LE '^full$' "$@"
else
    for needs in --lint --deb --clusters --mutants; do sh scripts/setup.sh $needs; done
    builds='^(install|packaging|inject|memcheck|fuzz)/'
    HAWSER_TEST_TIMES=$(pwd)/build/tests/times
    export HAWSER_TEST_TIMES
    status=0
    for one in 1 2 3 4; do
        [ $part = all ] || [ $part = $one ] || continue
        case $one in
        1) run_tests "release asan" -E "$builds" "$@" ;;
        2) run_tests debug "$@" ;;
        3) run_tests release -R "$builds" "$@" ;;
        4) run_others "$@" ;;
        esac || status=$?
    done
    python3 scripts/suite.py "$HAWSER_TEST_TIMES" >build/tests/suite.md
    exit $status
fi
