#!/bin/sh
# bench_phases: every phase runs alone and in the row, and wrong usage is refused.          Usage: test_phases.sh PROGRAM
set -eu
program=$1
fail() {
    echo "test_phases: $*" >&2
    exit 1
}
refused() {
    status=0
    "$program" "$@" >/dev/null 2>&1 || status=$?
    [ $status = 2 ] || fail "status $status after: $*"
}

names=$("$program" list)
for name in kinematics rhs contacts blocks form factor solve vector plane-rhs plane-solve plane-row; do
    echo "$names" | grep -qx $name || fail "has no phase $name"
    lines=$("$program" $name 2)
    echo "$lines" | sed -n 1p | grep -Eqx 'target [a-z]+[0-9]+-(generic|avx2|avx512)' || fail "target: $lines"
    echo "$lines" | sed -n 2p | grep -Eqx "$name 2 [0-9.]+" || fail "$name: $lines"
done
[ "$("$program" all 1 | sed 1d | cut -d' ' -f1)" = "$names" ] || fail "all is not all phases in their order"
refused
refused rhs
refused rhs 0
refused bogus 3
refused all 3 4
echo "phases: fine"
