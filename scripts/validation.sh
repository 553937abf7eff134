#!/bin/sh
# Runs the validation suite and writes its tables into docs/validation-tables.md.
# Usage: sh scripts/validation.sh [PROGRAM]     (PROGRAM: build/release/cli/hawser)
set -eu
export LC_ALL=C

cd "$(dirname "$0")/.."
program=${1-build/release/cli/hawser}
results=$(mktemp)
trap 'rm -f "$results"' EXIT

# The table is written even if something is outside its tolerance: it says so.
status=0
"$program" validate --format csv >"$results" || status=$?
[ "$status" -le 1 ] || exit "$status"
python3 scripts/validation_tables.py "$results" docs/validation-tables.md
exit "$status"
