#!/bin/sh
# Makes the site: one folder with documents, references of C and Python, search, and every example with its calculation and the desk, for
# any web server or opened from a disk (docs/packaging.md). Needs no network once its packages are there.
# Usage: sh scripts/site.sh [FOLDER [--runs SECONDS]]      (default: build/site; runs that take longer than SECONDS, 2, are left out)
set -eu

cd "$(dirname "$0")/.."
folder=${1:-build/site}
[ $# = 0 ] || shift
sh scripts/setup.sh --site
sh scripts/build.sh release hawser hawser_python
exec /usr/bin/python3 -B packaging/site/make.py . build/release "$folder" "$@"
