#!/bin/sh
# Makes the paper's figures 7-13 (docs/figures) and the tables of docs/paper.md from runs of hawser.
# Usage: sh scripts/figures.sh [--quick] [--out DIR]     (--quick: one run, no tables; see scripts/figures.py)
set -eu
cd "$(dirname "$0")/.."
sh scripts/build.sh release hawser
python3 -B scripts/figures.py --hawser build/release/cli/hawser "$@"
