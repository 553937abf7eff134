#!/bin/sh
# scripts/instructions.sh with made-up counts: silent about noise, fails on growth and on a lost phase, skips without a
# reference, and writes one when asked.          Usage: test_instructions.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "test_instructions: $*" >&2
    cat "$work/out" >&2
    exit 1
}
# counts RHS SOLVE: measured counts of two phases
counts() { printf 'target gcc99-test\nrhs %s\nsolve %s\n' "$1" "$2" >"$work/counts"; }
run() {
    status=0
    sh "$root/scripts/instructions.sh" --counts "$work/counts" --references "$work/references" "$@" >"$work/out" 2>&1 ||
        status=$?
}
says() { grep -q -- "$1" "$work/out" || fail "does not say '$1'"; }

counts 1000 500
run
[ $status = 0 ] || fail "a missing reference is not a failure"
says "^skipped: no reference for gcc99-test"

run --update
[ $status = 0 ] || fail "--update failed"
[ -f "$work/references/gcc99-test.txt" ] || fail "wrote no reference"
run
[ $status = 0 ] || fail "the same counts are not a failure"
says "| rhs | 1000 | 1000 | +0.00 % |"

counts 1030 490
run
[ $status = 0 ] || fail "failed at the margin"
counts 1031 500
run
[ $status = 1 ] || fail "let 3.1 % pass"
says "^grown by more than 3 %: rhs$"
counts 1000 400
run
[ $status = 0 ] || fail "failed because of a saving"
says "less than before, --update keeps it so: solve"

printf 'target gcc99-test\nrhs 1000\nform 7\n' >"$work/counts"
run
[ $status = 1 ] || fail "did not miss a phase"
says "^no longer measured: solve"
says "| form | - | 7 | new |"

echo "rhs 1000" >"$work/counts"
run
[ $status = 2 ] || fail "took counts of no target"
run --bogus
[ $status = 2 ] || fail "took an unknown option"
run --program
[ $status = 2 ] || fail "took an option without its value"

counts 1000 500
status=0
sh "$root/scripts/instructions.sh" --program /bin/false --references "$work/references" >"$work/out" 2>&1 || status=$?
[ $status = 2 ] || grep -q "^skipped: valgrind" "$work/out" || fail "took a program that fails for one that ran"
echo "instructions: fine"
