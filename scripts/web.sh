#!/bin/sh
# Builds the page of the report: web/src -> web/dist/report.js, report.css, MANIFEST. The result is committed, so that who only
# runs hawser needs no Node (docs/report.md). Needs Node and npm (sh scripts/setup.sh --web).
# Usage: sh scripts/web.sh [--check]     (--check: builds into a scratch folder and compares with web/dist bit for bit)
set -eu

cd "$(dirname "$0")/../web"
[ -z "$(find package-lock.json -newer node_modules/.package-lock.json 2>/dev/null)" ] && [ -d node_modules/esbuild ] ||
    npm ci --ignore-scripts --no-audit --no-fund --silent
npx --no-install tsc --noEmit
npx --no-install prettier --check --log-level warn src build.mjs package.json tsconfig.json

if [ "${1-}" = --check ]; then
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    node build.mjs "$scratch"
    for file in report.js report.css; do
        cmp "$scratch/$file" "dist/$file" || {
            echo "web.sh: web/dist/$file is not what web/src makes: run sh scripts/web.sh and commit web/dist" >&2
            exit 1
        }
    done
else
    node build.mjs
    python3 manifest.py --write
fi
