# The programs in docs/tutorial/ that docs/guide/c.md names, compiled against the header and the library, print what they should.
library=$1 source=$2
hawser=
. "$source/tests/cli/common.sh"
what="a program of docs/guide/c.md"

shown=$(sed -n '/^```c$/,/^```$/p' "$source/docs/guide/c.md" | sed '/^```/d') program=$(cat "$source/docs/tutorial/run.c")
[ -n "$shown" ] && [ "${program#*"$shown"}" != "$program" ] || fail "docs/guide/c.md does not show a part of docs/tutorial/run.c"
cp "$source/docs/tutorial/run.c" "$source/docs/tutorial/controller.c" "$source/docs/tutorial/contacts.c" "$work"
for name in run controller contacts; do
    ${CC:-cc} -std=c11 -Wall -Wextra -Werror -I"$source/include" "$work/$name.c" -o "$work/$name" "$library" \
        -Wl,-rpath,"$(dirname "$library")" || { fail "$what: $name does not compile"; finish; }
    "$work/$name" >"$work/out" 2>"$work/err" || fail "$what: $name does not run"
    silent err
    mv "$work/out" "$work/$name.out"
done

# mu m g = 0.2 * 200 kg * 9.81 m/s2; the simulated pull lies below by what the winch carries of a span
mv "$work/run.out" "$work/out"
says out "theory 392.4 N" "middle:" "t = 1.0 s" "t = 3.0 s: winch pulls"
awk '$1 == "pull" && ($2 < 382 || $2 > 394) { exit 1 }
     /t = 3.0 s/ && ($7 < 573 || $7 > 591) { exit 1 }' "$work/out" || {
    fail "$what: pulls are not mu m g:"
    cat "$work/out" >&2
}
# 3 kN within 2 %
awk '/t = 20 s/ && $5 > 2940 && $5 < 3060 { held = 1 } END { exit !held }' "$work/controller.out" || {
    fail "$what: the controller does not hold the pull:"
    cat "$work/controller.out" >&2
}
# ten or so rollers carry 200 kg less what the winch holds
awk '/^t = / { n++; if ($8 < 1700 || $8 > 2100) exit 1 } END { exit n != 3 }' "$work/contacts.out" || {
    fail "$what: contacts do not carry the cable:"
    cat "$work/contacts.out" >&2
}
finish
