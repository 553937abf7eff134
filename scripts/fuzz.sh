#!/bin/sh
# Feeds the fuzz targets (tests/fuzz) with inputs that find new ways through the program, and says what broke.
# Usage: sh scripts/fuzz.sh [--engine libfuzzer|afl] [MINUTES] [TARGET...]
#        sh scripts/fuzz.sh --keep
#   --engine afl: AFL++ (preset `afl`, no sanitizers, no mutator of the project's own); what it finds: build/afl/found/TARGET
#   MINUTES  for each target (default 1)
#   TARGET   units, yaml, case, set, run, api, route, model, results, folder, states, hostile, checkpoint, study, arguments, library, fmu (default: all); one reader of routes: route-csv, route-landxml,
#            route-ifc, route-dxf, route-gpx, route-geojson; route-all: each of these with minutes of its own
#   --keep   takes what was found along the way into the tree: of each target the inputs that reach all that its corpus reaches,
#            packed as tests/fuzz/kept/TARGET.tar.xz, the sums of the ledgers in tests/fuzz/ledger.csv
# What is found along the way stays in build/fuzz/corpus/TARGET, which begins with what is kept in the tree, so that the next call
# goes on from there; an input that breaks something is left in build/fuzz/found, also one that takes 1000 s by the clock: so long, as the machine may be busy. Status 1 if
# there is one. Inputs and processor time of each go to build/ENGINE/ledger.csv (scripts/fuzz_ledger.py). HAWSER_FUZZ_JOBS: how many at once (default 1).
set -eu

cd "$(dirname "$0")/.."
minutes=1
engine=libfuzzer
keep=no
if [ "${1-}" = --keep ]; then
    keep=yes
    shift
fi
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
[ $# -gt 0 ] || set -- units yaml case set run api route model results folder states hostile checkpoint study arguments library fmu
# shellcheck disable=SC2086 # one word a reader
[ $keep = no ] || set -- "$@" $readers
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
# what is written while inputs are tried need not reach a disk
[ ! -w /dev/shm ] || TMPDIR=${TMPDIR-/dev/shm}
export TMPDIR

# pack_kept TARGET PROGRAM: the fewest inputs of its corpus that reach as much, the smallest first.
pack_kept() {
    [ -n "$(ls $build/corpus/"$1" 2>/dev/null)" ] || return 0
    rm -rf $build/least && mkdir -p $build/least tests/fuzz/kept
    $build/tests/fuzz/fuzz_"$2" -merge=1 -set_cover_merge=1 -timeout=100 -rss_limit_mb=2048 $build/least $build/corpus/"$1" >$build/"$1".merge 2>&1
    (cd $build/least && tar --create --xz --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --file ../kept.tar.xz -- *)
    mv $build/kept.tar.xz tests/fuzz/kept/"$1".tar.xz
    echo "fuzz.sh: $1: $(ls $build/least | wc -l) of $(ls $build/corpus/"$1" | wc -l) inputs kept, $(wc -c <tests/fuzz/kept/"$1".tar.xz) bytes"
}

status=0
for target in "$@"; do
    mkdir -p $build/corpus/"$target"
    kept=tests/fuzz/kept/$target.tar.xz
    if [ -f "$kept" ] && [ ! "$build/corpus/$target.kept" -nt "$kept" ]; then
        tar --extract --file "$kept" --directory $build/corpus/"$target"
        touch $build/corpus/"$target".kept
    fi
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
    if [ $keep = yes ]; then
        pack_kept "$target" $program
        continue
    fi
    echo "fuzz.sh: $target, $minutes min"
    if [ $preset = afl ]; then
        # one folder of all seeds; AFL++ wants none of them empty
        rm -rf $build/seeds && mkdir -p $build/seeds
        # shellcheck disable=SC2086 # one word a folder
        find $seeds $build/corpus/"$target" -maxdepth 1 -type f -size +0 -size -16k -exec cp {} $build/seeds \;
        unset ASAN_OPTIONS UBSAN_OPTIONS
        AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_AFFINITY=1 \
            python3 scripts/fuzz_ledger.py run $build/ledger.csv "$target" AFL++ $build/"$target".log $build/found/"$target" \
            nice -n 19 afl-fuzz -i $build/seeds -o $build/found/"$target" -V $((60 * minutes)) -t 10000 -m none -x $words \
            -- $build/tests/fuzz/fuzz_"$program" || status=1
        continue
    fi
    # shellcheck disable=SC2086 # one word a folder
    python3 scripts/fuzz_ledger.py run $build/ledger.csv "$target" libFuzzer $build/"$target".log $build/found \
        nice -n 19 $build/tests/fuzz/fuzz_"$program" -max_total_time=$((60 * minutes)) -timeout=1000 -report_slow_units=100 -rss_limit_mb=2048 \
        -max_len=16384 -dict=$words -artifact_prefix=$build/found/"$target"- -print_final_stats=1 \
        -fork="${HAWSER_FUZZ_JOBS-1}" -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 \
        $build/corpus/"$target" $seeds || status=1
done
if [ $keep = yes ]; then
    for ledger in build/fuzz/ledger.csv build/afl/ledger.csv; do
        [ ! -f $ledger ] || python3 scripts/fuzz_ledger.py keep $ledger
    done
    exit 0
fi
found=$(find $build/found -type f \( -path '*/crashes/id*' -o -path '*/hangs/id*' -o -path "build/fuzz/*" \) | wc -l)
if [ "$found" -gt 0 ]; then
    echo "fuzz.sh: $found inputs broke something: $build/found"
    status=1
fi
exit $status
