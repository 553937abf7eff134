#!/bin/sh
# Makes docs/model.md, docs/performance.md, docs/equipment.md and docs/validation.md from the fragments in docs/*.d.
# Usage: sh scripts/model.sh [--check]     (--check: changes nothing, fails if a document is not up to date)
set -eu
export LC_ALL=C

cd "$(dirname "$0")/.."
mode=${1-}
status=0
new=$(mktemp)
trap 'rm -f "$new"' EXIT

# make_document NAME: the fragments of docs/NAME.d in the order of their names, under a note that says so.
make_document() {
    set -- "$1" docs/"$1".d/*.md
    [ -f "$2" ] || return 0
    document=docs/$1.md
    printf '<!-- Made from docs/%s.d/*.md by scripts/model.sh: edit those. -->\n' "$1" >"$new"
    shift
    for fragment in "$@"; do
        echo >>"$new"
        cat "$fragment" >>"$new"
    done
    if cmp -s "$new" "$document"; then
        return 0
    elif [ "$mode" = --check ]; then
        echo "$document is not up to date: run sh scripts/model.sh" >&2
        status=1
    else
        cat "$new" >"$document"
        echo "$document written"
    fi
}

make_document model
make_document performance
make_document equipment
make_document validation
exit $status
