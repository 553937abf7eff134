#!/bin/sh
# Feeds the fuzz targets (tests/fuzz) with inputs that find new ways through the program, and says what broke.
# Usage: sh scripts/fuzz.sh [--engine libfuzzer|afl] [MINUTES] [TARGET...]
#   --engine afl: AFL++ (preset `afl`, no sanitizers, no mutator of the project's own); what it finds: build/afl/found/TARGET
#   MINUTES  for each target (default 1)
#   TARGET   units, yaml, case, set, run, api, route, results, folder, checkpoint, study, arguments, library, fmu (default: all); one reader of routes: route-csv, route-landxml,
#            route-ifc, route-dxf, route-gpx, route-geojson; route-all: each of these with minutes of its own
# What is found along the way stays in build/fuzz/corpus/TARGET, so that the next call goes on from there; an input that breaks
# something is left in build/fuzz/found, also one that takes 100 s by the clock: so long, as the machine may be busy. Status 1 if
# there is one. Inputs and processor time of each go to build/ENGINE/ledger.csv (scripts/fuzz_ledger.py). HAWSER_FUZZ_JOBS: how many at once (default 1).
set -eu

cd "$(dirname "$0")/.."
minutes=1
engine=libfuzzer
if [ "${1-}" = --engine ]; then
    engine=$2
    shift 2
fi
case "${1-}" in
"" | *[!0-9]*) ;;
*)
    minutes=$1
    shift
    ;;
esac
readers="route-csv route-landxml route-ifc route-dxf route-gpx route-geojson"
[ $# -gt 0 ] || set -- units yaml case set run api route results folder checkpoint study arguments library fmu
# shellcheck disable=SC2086 # one word a reader
[ "$*" != route-all ] || set -- $readers

command -v clang >/dev/null 2>&1 && ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-x86_64.a >/dev/null 2>&1 ||
    sh scripts/setup.sh --fuzz
preset=fuzz
[ "$engine" = libfuzzer ] || preset=afl
[ "$preset" = fuzz ] || command -v afl-fuzz >/dev/null 2>&1 || sh scripts/setup.sh --fuzz
cmake --preset $preset >/dev/null
# shellcheck disable=SC2046,SC2086 # one word a target
cmake --build --preset $preset -j "$(nproc)" --target fuzz_dictionary $(printf 'fuzz_%s ' "$@" | sed 's/route-[a-z]*/route/g')

build=build/$preset
mkdir -p $build/found
$build/tests/fuzz/fuzz_dictionary >$build/case.dict
ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1
UBSAN_OPTIONS=print_stacktrace=1
export ASAN_OPTIONS UBSAN_OPTIONS
status=0
for target in "$@"; do
    mkdir -p $build/corpus/"$target"
    seeds="tests/fuzz/corpus/$target"
    words=$build/case.dict
    program=$target
    unset HAWSER_FUZZ_READER
    case "$target" in
    yaml | case | run) seeds="$seeds tests/data cases" ;;
    route | route-*)
        program=route
        seeds="tests/fuzz/corpus/route cases/routes"
        [ "$target" = route ] || export HAWSER_FUZZ_READER="${target#route-}"
        words=tests/fuzz/route.dict
        ;;
    esac
    echo "fuzz.sh: $target, $minutes min"
    if [ $preset = afl ]; then
        # one folder of all seeds; AFL++ wants none of them empty
        rm -rf $build/seeds && mkdir -p $build/seeds
        # shellcheck disable=SC2086 # one word a folder
        find $seeds -maxdepth 1 -type f -size +0 -size -16k -exec cp {} $build/seeds \;
        unset ASAN_OPTIONS UBSAN_OPTIONS
        AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_AFFINITY=1 \
            python3 scripts/fuzz_ledger.py run $build/ledger.csv "$target" AFL++ $build/"$target".log $build/found/"$target" \
            nice -n 19 afl-fuzz -i $build/seeds -o $build/found/"$target" -V $((60 * minutes)) -t 10000 -m none -x $words \
            -- $build/tests/fuzz/fuzz_"$program" || status=1
        continue
    fi
    # shellcheck disable=SC2086 # one word a folder
    python3 scripts/fuzz_ledger.py run $build/ledger.csv "$target" libFuzzer $build/"$target".log $build/found \
        nice -n 19 $build/tests/fuzz/fuzz_"$program" -max_total_time=$((60 * minutes)) -timeout=100 -report_slow_units=100 -rss_limit_mb=2048 \
        -max_len=16384 -dict=$words -artifact_prefix=$build/found/"$target"- -print_final_stats=1 \
        -fork="${HAWSER_FUZZ_JOBS-1}" -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 \
        $build/corpus/"$target" $seeds || status=1
done
found=$(find $build/found -type f \( -path '*/crashes/id*' -o -path '*/hangs/id*' -o -path "build/fuzz/*" \) | wc -l)
if [ "$found" -gt 0 ]; then
    echo "fuzz.sh: $found inputs broke something: $build/found"
    status=1
fi
exit $status
