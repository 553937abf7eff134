#!/bin/sh
# Does everything for a first look: installs what is missing, builds hawser, runs the paper's pull, writes its report.
# Usage: sh scripts/run.sh [CASE]          (default: cases/huangjiahu.yaml; results go to results/NAME)
set -eu

# A case is named from where the caller stands; everything else from the project's root.
case_file=${1-}
if [ -n "$case_file" ]; then
    case_file=$(cd "$(dirname "$case_file")" && pwd)/$(basename "$case_file")
fi
cd "$(dirname "$0")/.."
case_file=${case_file:-cases/huangjiahu.yaml}
name=$(basename "$case_file")
results=results/${name%.*}

sh scripts/setup.sh
sh scripts/build.sh release hawser
build/release/cli/hawser run "$case_file" -o "$results" --report
echo "Results: $(pwd)/$results (docs/reference/results.md explains every file)"
echo "The report, for any browser: $(pwd)/$results/report.html"
