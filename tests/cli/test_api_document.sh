# The program of docs/api.md, compiled against the header and the library, prints what it should.
library=$1 source=$2
hawser=
. "$source/tests/cli/common.sh"
what="the program of docs/api.md"

sed -n '/^```c$/,/^```$/p' "$source/docs/api.md" | sed '/^```/d' >"$work/example.c"
${CC:-cc} -std=c11 -Wall -Wextra -Werror -I"$source/include" "$work/example.c" -o "$work/example" "$library" \
    -Wl,-rpath,"$(dirname "$library")" || { fail "$what: does not compile"; finish; }
"$work/example" >"$work/out" 2>"$work/err" || fail "$what: does not run"
silent err
# mu m g = 0.2 * 200 kg * 9.81 m/s2; the simulated pull lies below by what the winch carries of a span
says out "theory 392.4 N" "middle:" "t = 1.0 s" "t = 3.0 s: winch pulls"
awk '$1 == "pull" && ($2 < 382 || $2 > 394) { exit 1 }
     /t = 3.0 s/ && ($7 < 573 || $7 > 591) { exit 1 }' "$work/out" || {
    fail "$what: pulls are not mu m g:"
    cat "$work/out" >&2
}
finish
