#!/bin/sh
# scripts/bench_compare.sh in a made-up repository: which commits it takes, that both run OLD's cases, that it leaves
# nothing behind, and its status.          Usage: test_bench_compare.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "test_bench_compare: $*" >&2
    cat "$work/out" >&2
    exit 1
}
repo=$work/repo
mkdir -p "$repo/scripts" "$repo/bench" "$repo/cases" "$work/tmp"
cp "$root/scripts/bench_compare.sh" "$repo/scripts/"
# building copies the program's text; comparing prints both, and fails as the file `status` says
echo 'mkdir -p build/bench && cp program build/bench/program && [ ! -f broken ]' >"$repo/scripts/build.sh"
cat >"$repo/bench/compare.py" <<'EOF'
import os, sys
old, new, _, cases, *rest = sys.argv[1:]
print(*(open(os.path.join(build, "program")).read().strip() for build in (old, new)), open(os.path.join(cases, "a")).read().strip(), *rest)
sys.exit(int(os.environ.get("COMPARE", "0")))
EOF
cd "$repo"
git init -q .
git config user.email a@b.c
git config user.name a
for version in one two three; do
    echo $version >program
    echo "cases-$version" >cases/a
    git add -A
    git commit -q -m $version
done
# run WORD...: the command in the repository; its output in $work/out, its status in $status
run() {
    status=0
    TMPDIR=$work/tmp sh "$repo/scripts/bench_compare.sh" "$@" >"$work/out" 2>&1 || status=$?
    [ -z "$(ls "$work/tmp")" ] || fail "left files behind"
    [ "$(git worktree list | wc -l)" = 1 ] || fail "left a worktree behind"
}
says() { grep -qx "$1" "$work/out" || fail "does not say '$1'"; }

run
[ $status = 0 ] || fail "status $status"
says "two three cases-two"
run HEAD~2 HEAD~1 -- --pairs 3
says "one two cases-one --pairs 3"
echo changed >program
run
says "three changed cases-three"
run HEAD~1
says "two changed cases-two"
[ "$(cat program)" = changed ] || fail "touched the working tree"
[ -z "$(git stash list)" ] || fail "left a stash"
COMPARE=1 run
[ $status = 1 ] || fail "status $status for a slower program"
COMPARE=5 run
[ $status = 2 ] || fail "status $status for a comparison that failed"
touch broken && git add broken
run
[ $status = 2 ] || fail "status $status for a tree that cannot be built"
run nonsense
[ $status = 2 ] || fail "took a commit that is none"
run HEAD HEAD HEAD
[ $status = 2 ] || fail "took three commits"
run --pairs 3
[ $status = 2 ] || fail "took an option before --"
echo "bench_compare: fine"
