#!/bin/sh
# Two clones at different places and times give the same archive, bit for bit, which has what is needed to build.
# Usage: test_dist.sh SOURCE_DIR
set -eu
git -C "$1" rev-parse HEAD >/dev/null 2>&1 || {
    echo "skipped: not a git checkout"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for clone in one elsewhere/two; do
    git clone -q "$1" "$work/$clone"
    touch -d 2001-02-03 "$work/$clone/README.md"
    (umask 077 && sh "$work/$clone/packaging/dist.sh" "$work/$clone.out" >"$work/path")
    sha256sum <"$(cat "$work/path")" >>"$work/sums"
    sleep 1
done
[ "$(sort -u "$work/sums" | wc -l)" = 1 ] || {
    echo "two archives of one commit differ"
    exit 1
}
tar -tzf "$(cat "$work/path")" >"$work/list"
for file in CMakeLists.txt LICENSE NOTICE cli/main.c web/dist/report.js library/ropes.yaml scripts/run.sh docs/guide/README.md; do
    grep -q "^hawser-[0-9.]*/$file\$" "$work/list" || {
        echo "the archive has no $file"
        exit 1
    }
done
