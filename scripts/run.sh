#!/bin/sh
# Does everything for a first look: installs what is missing, builds hawser, runs the paper's pull, draws its plots.
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
build/release/cli/hawser run "$case_file" -o "$results"

# Debian's matplotlib belongs to Debian's Python, which need not be the first one on the path.
python=
for candidate in /usr/bin/python3 python3; do
    if "$candidate" -c 'import matplotlib' 2>/dev/null; then
        python=$candidate
        break
    fi
done
if [ -n "$python" ]; then
    "$python" scripts/plot.py "$results"
else
    echo "run.sh: no plots, because python3-matplotlib is not there"
fi
echo "Results and plots: $(pwd)/$results (docs/results.md explains every file)"
