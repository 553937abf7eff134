# A case in today's words: other names of keys become their own, the format gets its number, comments stay.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

cat >"$work/old.yaml" <<'CASE'
# a café's duct, 400 m
cables: {c: {d: 50 mm, mass: 10 kg/m}} # one
route: {pieces: [{length: 400 m}, {angle: 30 deg, radius: 5 m, turn: left}, {straight: 5 m}]}
surfaces:
  ducts:
    - {diameter: 160 mm} # wide
CASE
cat >"$work/new.yaml" <<'CASE'
# a café's duct, 400 m
format: 1
cables: {c: {d: 50 mm, mass: 10 kg/m}} # one
route: {pieces: [{straight: 400 m}, {bend: 30 deg, radius: 5 m, plane: left}, {straight: 5 m}]}
surfaces:
  ducts:
    - {radius: 80 mm} # wide
CASE
cp "$work/old.yaml" "$work/kept.yaml"
run_hawser 0 upgrade old.yaml -o out.yaml
says out "out.yaml: rewritten in 6 places"
cmp "$work/out.yaml" "$work/new.yaml" || fail "$what: not what was expected"
cmp "$work/old.yaml" "$work/kept.yaml" || fail "$what: the case has changed"
run_hawser 0 upgrade old.yaml
cmp "$work/old.yaml" "$work/new.yaml" || fail "$what: not rewritten"
run_hawser 0 upgrade old.yaml
says out "old.yaml: nothing to rewrite"
# both are the same pull
"$hawser" theory "$work/kept.yaml" --format csv >"$work/a.csv"
"$hawser" theory "$work/new.yaml" --format csv >"$work/b.csv"
cmp "$work/a.csv" "$work/b.csv" || fail "the rewritten case is another one"

# a case that is JSON, with a byte order mark
printf '\357\273\277{"cables": {"c": {"d": "50 mm", "mass": "10 kg/m"}}, "route": {"pieces": [{"length": "40 m"}]}}\n' >"$work/flow.yaml"
run_hawser 0 upgrade flow.yaml
grep -q '{format: 1, "cables"' "$work/flow.yaml" && grep -q '{"straight": "40 m"}' "$work/flow.yaml" || fail "$what: not rewritten"
[ "$(head -c 3 "$work/flow.yaml" | od -An -tx1 | tr -d ' ')" = efbbbf ] || fail "$what: the byte order mark is gone"
run_hawser 0 theory flow.yaml
printf 'cables: {c: {d: 50 mm, mass: 10 kg/m}}\r\nroute: {pieces: [{length: 40 m}]}\r\n' >"$work/crlf.yaml"
run_hawser 0 upgrade crlf.yaml
[ "$(grep -c "$(printf '\r')\$" "$work/crlf.yaml")" = 3 ] || fail "$what: the ends of lines have changed"

# what cannot be done, and what is newer
cp "$work/old.yaml" "$work/today.yaml"
printf 'd: &d 100 mm\nsurfaces: {ducts: [{diameter: *d}]}\n' >"$work/alias.yaml"
run_hawser 2 upgrade alias.yaml
says err "alias.yaml:2: 'diameter' cannot be rewritten"
# an item that stands twice, quotes, a text of several lines
printf 'cables: {c: {d: 50 mm, mass: 10 kg/m}}\nroute: {pieces: [&s {"length":"200 m"}, *s]}\nsurfaces: {ducts: [{"diameter":"160 mm"}]}\n' >"$work/twice.yaml"
run_hawser 0 upgrade twice.yaml
grep -q '&s {"straight":"200 m"}, \*s' "$work/twice.yaml" && grep -q '{"radius":"80 mm"}' "$work/twice.yaml" || fail "$what: not rewritten"
run_hawser 0 theory twice.yaml
printf 'surfaces:\n  ducts:\n    - diameter: >-\n        160 mm\nfriction: {mu: 0.3}\n' >"$work/folded.yaml"
cp "$work/folded.yaml" "$work/kept.yaml"
run_hawser 2 upgrade folded.yaml
says err "folded.yaml:3: 'diameter' cannot be rewritten"
cmp "$work/folded.yaml" "$work/kept.yaml" || fail "$what: the case has changed"

printf 'cables: [\n' >"$work/broken.yaml"
run_hawser 2 upgrade broken.yaml
says err "broken.yaml:2"
run_hawser 2 upgrade none.yaml
run_hawser 2 theory new.yaml --set format=2
says err "'format': value '2' is out of range: must be at least 1, at most 1"
run_hawser 4 upgrade today.yaml -o today.yaml/out.yaml
says err "cannot write"
finish
