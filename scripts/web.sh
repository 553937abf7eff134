#!/bin/sh
# Builds the page of the report and the converter of models: web/src -> web/dist/report.js, report.css, convert.cjs, MANIFEST. The result is committed, so that who only
# runs hawser needs no Node (web/README.md). Needs Node and npm (sh scripts/setup.sh --web).
# Usage: sh scripts/web.sh [--check | --packages]
#   --check      builds into a scratch folder and compares with web/dist bit for bit
#   --packages   only installs npm's packages, those of package-lock.json, where they are not there yet
set -eu

cd "$(dirname "$0")/../web"
if [ ! -f node_modules/.package-lock.json ] || [ package-lock.json -nt node_modules/.package-lock.json ]; then
    npm ci --ignore-scripts --no-audit --no-fund --loglevel=error
    touch node_modules/.package-lock.json
fi
[ "${1-}" != --packages ] || exit 0

node_modules/.bin/tsc --noEmit
node_modules/.bin/eslint --max-warnings 0 src
node_modules/.bin/prettier --config .prettierrc.json --check --log-level warn src '*.mjs' package.json tsconfig.json '../tests/web/**/*.mjs'
if [ "${1-}" != --check ]; then
    node build.mjs
    node convert.mjs
    python3 manifest.py --write
    exit 0
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
node build.mjs "$scratch"
node convert.mjs "$scratch"
for file in report.js report.css convert.cjs; do
    cmp "$scratch/$file" "dist/$file" || {
        echo "web.sh: web/dist/$file is not what web/src makes: run sh scripts/web.sh and commit web/dist" >&2
        exit 1
    }
done
