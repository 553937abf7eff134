#!/bin/sh
# Runs the benchmarks of bench/README.md, all of them or the parts that are named, one after the other. Wants a machine
# that does nothing else.
# Usage: sh scripts/bench.sh [--quick] [PART...]
#   --quick   does everything work? Under three minutes; results go to build/bench/results
#   PART      linsolve, steps, precision, methods, peers, scale, stress or long
# Writes bench/results/MACHINE (rows, pictures, tables) and, on the machine that it is about, the verdicts in
# docs/performance.md.
# Status: 0; 1 if a part missed a condition that does not depend on time; 2 wrong usage.
set -eu

parts="linsolve steps precision methods peers scale stress long"
cd "$(dirname "$0")/.."
quick=no wanted=''
for word in "$@"; do
    case " $parts " in
    *" $word "*) wanted="$wanted $word" ;;
    *)
        [ "$word" = --quick ] || {
            echo "bench.sh: '$word' is neither --quick nor one of the parts: $parts" >&2
            exit 2
        }
        quick=yes
        ;;
    esac
done
sh scripts/setup.sh --bench
sh scripts/build.sh bench
results=bench/results/$(python3 -c 'import sys; sys.path.insert(0, "bench")
import os, common; print(common.machine_name(common.processor(), os.cpu_count()))')
options=
[ $quick = no ] || results=build/bench/results options=--quick
mkdir -p "$results"

status=0
for part in ${wanted:-$parts}; do
    echo "== $part"
    start=$(date +%s)
    # shellcheck disable=SC2086 # no option or one
    python3 -B "bench/$part.py" --build build/bench --results "$results" $options || status=1
    seconds=$(($(date +%s) - start))
    echo "== $part: $seconds s"
    { grep -v "^$part," "$results/seconds.csv" 2>/dev/null || echo part,seconds; } >"$results/seconds.new"
    echo "$part,$seconds" >>"$results/seconds.new"
    mv "$results/seconds.new" "$results/seconds.csv"
done
[ $quick = yes ] || python3 -B bench/machine.py "$results"
echo "Results: $results"
exit $status
