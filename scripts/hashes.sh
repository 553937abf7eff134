#!/bin/sh
# Prints a hash of every result of every case: the tables (series, stations, rollers, ...) and the data sets of results.h5,
# for space and plane, one and two threads, and each instruction set that the machine has. Two programs whose lines are the
# same compute the same bits: `sh scripts/hashes.sh A >a; sh scripts/hashes.sh B >b; diff a b`.
# Usage: sh scripts/hashes.sh PROGRAM [CASE...]      (default: cases/*.yaml; long ones are cut short)
#   HASHES_SETTINGS="isa:threads:planar ..."         which settings (default: all of generic avx2 avx512, 1 2, auto off)
set -eu
export LC_ALL=C

program=$(realpath "${1:?usage: sh scripts/hashes.sh PROGRAM [CASE...]}")
shift
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- cases/*.yaml
settings=${HASHES_SETTINGS-}
if [ -z "$settings" ]; then
    for isa in generic avx2 avx512; do
        for threads in 1 2; do settings="$settings $isa:$threads:auto $isa:$threads:off"; done
    done
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

command -v h5dump >/dev/null || {
    echo "hashes.sh: needs h5dump (Debian: apt-get install hdf5-tools)" >&2
    exit 2
}

# The data of a file of results, without its name and the version that wrote it.
content() {
    case $1 in
    *.h5) h5dump -m '%.17g' "$1" | grep -v -e '^HDF5' -e '^ *(0): "[0-9a-f.]*"$' ;;
    *) cat "$1" ;;
    esac
}

for case_file; do
    # what the hours of a long pull compute shows in its first seconds
    cut=
    case $case_file in
    *tunnel-879*) cut='--set run.duration=30s --set run.steady_from=10s' ;;
    *slope-stick*) cut='--set run.duration=120s --set run.steady_from=60s' ;;
    esac
    for setting in $settings; do
        isa=${setting%%:*} rest=${setting#*:}
        threads=${rest%%:*} planar=${rest#*:}
        rm -rf "$work/results"
        # shellcheck disable=SC2086 # words of options
        if ! HAWSER_ISA=$isa "$program" run "$case_file" -q --threads "$threads" --set solver.planar="$planar" $cut \
            -o "$work/results" >"$work/log" 2>&1; then
            echo "$case_file $setting: status, $(tail -n 1 "$work/log" | cut -c 1-100)"
            continue
        fi
        for file in "$work"/results/*.csv "$work"/results/*.h5; do
            [ -f "$file" ] || continue
            echo "$case_file $setting ${file##*/} $(content "$file" | sha256sum | cut -c 1-16)"
        done
    done
done
