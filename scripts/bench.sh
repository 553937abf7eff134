#!/bin/sh
# Runs the benchmarks of docs/performance.md: the linear solvers alone, then whole runs. Wants a machine that does nothing
# else; takes two to three minutes.
# Usage: sh scripts/bench.sh [--quick]     (--quick: does everything work? Seconds, changes no document)
# Writes bench/results/MACHINE/runs.csv and linsolve.md, the tables of docs/performance.d/20-runs.md, docs/performance.md.
set -eu

quick=no
case "${1-}" in
"") ;;
--quick) quick=yes ;;
*)
    echo "bench.sh: unknown option '$1' (only --quick)" >&2
    exit 2
    ;;
esac
cd "$(dirname "$0")/.."
sh scripts/setup.sh
sh scripts/build.sh bench

if [ $quick = yes ]; then
    results=build/bench/results
    mkdir -p "$results"
    build/bench/bench/bench_linsolve 10 >"$results/linsolve.md"
    python3 bench/bench_runs.py --build build/bench --results "$results" --quick
    echo "Results: $results"
    exit 0
fi

results=bench/results/$(python3 bench/bench_runs.py --machine)
mkdir -p "$results"
echo "Linear solvers"
build/bench/bench/bench_linsolve 2000 >"$results/linsolve.md"
echo "Whole runs"
python3 bench/bench_runs.py --build build/bench --results "$results" --document docs/performance.d/20-runs.md
sh scripts/model.sh
echo "Results: $results (the tables of the linear solvers go into docs/performance.d/10-linsolve.md by hand)"
