#!/bin/sh
# Is NEW faster or slower than OLD? Builds both, runs the tracked scenes in pairs that take turns, counts instructions, and
# says for every scene and phase whether it is faster, slower, or no different beyond noise (bench/paired.py says how).
# Usage: sh scripts/bench_compare.sh [OLD [NEW]] [-- OPTION...]
#   OLD, NEW   commits, or "tree": the working tree with its changes
#              default: OLD is HEAD and NEW the tree if the tree has changes, else OLD is HEAD~1 and NEW is HEAD
#   OPTION     for bench/compare.py: --pairs N (40), --scenes A,B, --rows FILE, --no-counts, --quick
# Both run the case files of OLD. They are built in folders of their own below TMPDIR, which are gone afterwards.
# Status: 0; 1 a scene is slower beyond noise and takes more instructions; 2 it could not be measured.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
fail() {
    echo "bench_compare.sh: $*" >&2
    exit 2
}
old='' new=''
while [ $# -gt 0 ] && [ "$1" != -- ]; do
    case $1 in
    -*) fail "unknown option '$1': those for the comparison stand behind --" ;;
    esac
    if [ -z "$old" ]; then
        old=$1
    elif [ -z "$new" ]; then
        new=$1
    else
        fail "one commit too many: '$1'"
    fi
    shift
done
[ $# -eq 0 ] || shift
changed=$(git -C "$root" status --porcelain -uno)
if [ -n "$old" ]; then
    new=${new:-tree}
elif [ -n "$changed" ]; then
    old=HEAD new=tree
else
    old=HEAD~1 new=HEAD
fi

work=$(mktemp -d)
# Leaves nothing behind, whatever ends the script.
clean() {
    for side in old new; do
        [ ! -d "$work/$side" ] || git -C "$root" worktree remove --force "$work/$side" 2>/dev/null || rm -rf "${work:?}/$side"
    done
    rm -rf "$work"
    git -C "$root" worktree prune
}
trap clean EXIT
trap 'exit 2' HUP INT TERM

# place SIDE COMMIT: the sources of a commit in $work/SIDE. The tree is the commit that it would be, kept by no branch.
place() {
    commit=$2
    if [ "$commit" = tree ]; then
        commit=$(git -C "$root" stash create)
        commit=${commit:-HEAD}
    fi
    git -C "$root" rev-parse --quiet --verify "$commit^{commit}" >/dev/null || fail "there is no commit '$2'"
    git -C "$root" worktree add --quiet --detach "$work/$1" "$commit" || fail "cannot check out '$2'"
    echo "$1: $2 ($(git -C "$root" rev-parse --short "$commit"))"
    # a compiler cache, if one is used, need not mind the folder's name
    (cd "$work/$1" && CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1 sh scripts/build.sh bench hawser) || fail "'$2' could not be built"
}
place old "$old"
place new "$new"
status=0
python3 -B "$root/bench/compare.py" "$work/old/build/bench" "$work/new/build/bench" --cases "$work/old/cases" "$@" ||
    status=$?
[ $status -le 1 ] || exit 2
exit $status
