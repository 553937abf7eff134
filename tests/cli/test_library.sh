# The catalogue as its users see it: lists, a case that takes all of it by name, what check and a run say of it, files of one's own.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
unset HAWSER_LIBRARY

run_hawser 0 library
says out "xlpe-110kv-800-cu" "steel-6x36-14" "straight-120" "pe-160-sdr17" "pe-jacket/pvc-duct/lubricated"
silent err
run_hawser 0 library friction pe-jacket --format csv
says out "kind,name,figures,ranges,estimated,mark,note,source" "friction,pe-jacket/pe-duct/dry,mu 0.35,mu 0.3 to 0.4,,typical"
run_hawser 0 library cables 110kv-800 --format json
says out '"name": "xlpe-110kv-800-cu"' '"mark": "estimated"'
run_hawser 2 library cabels
says err "'cabels' is no kind of the catalogue"
run_hawser 2 library cables hemp
says err "no entry of the catalogue has 'hemp' in its name"
run_hawser 2 library cables 110kv more
says err "takes a kind and a pattern"

cat >"$work/mine.yaml" <<'YAML'
cables:
  drum-17: {d: 50 mm, mass: 4 kg/m, source: data sheet 17}
YAML
cat >"$work/typed.yaml" <<'YAML'
include: mine.yaml
cables: {power: {type: drum-17}, rope: {type: steel-6x36-14}}
chain: [{cable: power, length: 6 m}, {cable: rope, length: 4 m}]
route: {pieces: [{straight: 12 m}]}
rollers: {along: {type: straight-60, spacing: 500 mm}}
drive: {winch: {speed: 6 m/min}}
limits: {}
run: {duration: 2 s}
YAML
run_hawser 0 check typed.yaml
says out "Given, from the catalogue, estimated" "drum-17 (typical): data sheet 17" "rollers.along.rating" "strength"
tr -s "\n " " " <"$work/out" | grep -q "good within a factor of" || fail "$what: it does not say how good its stiffness is"
run_hawser 0 theory typed.yaml
run_hawser 0 run typed.yaml -o results
says out "Assumed: 9 values from the catalogue, 7 estimated (hawser check lists them)" "cables.power.EI = "
grep -q '"key": "cables.power.EI"' "$work/results/summary.json" || fail "summary.json has no assumptions"
grep -q '"origin": "estimated"' "$work/results/summary.json" || fail "summary.json has no estimates"
run_hawser 0 run pull.yaml -o pull
grep -q assumptions "$work/pull/summary.json" && fail "a case that says all of it has assumptions"

run_hawser 2 check typed.yaml --set cables.rope.type=steel-6x36-15
says err "--set cables.rope.type: key 'cables.rope.type': value 'steel-6x36-15' is not in the catalogue: did you mean 'steel-6x36-1"
run_hawser 2 check typed.yaml --set include=their.yaml
says err "their.yaml' cannot be read"

# A data sheet's values into a catalogue of one's own, new and grown; a case takes them. Nothing is written over.
run_hawser 0 library add sheet.yaml cables drum-18 d=91.5mm mass=15.2kg/m "conductor={material: copper, area: 800 mm2}" \
    "source=sheet 4711: \"our\" maker's" "range={d: 1 %}" mark=typical
says out "'drum-18' is among its cables" "include: sheet.yaml"
printf '# ours\nducts:\n    old: {radius: 70 mm} # by hand\n\n# the end\n' >"$work/own.yaml"
run_hawser 0 library add own.yaml ducts pe-160 radius=65mm
run_hawser 0 library add own.yaml reels big barrel=1.2m flange=2.4m width=1m
printf '# ours\nducts:\n    old: {radius: 70 mm} # by hand\n    pe-160:\n        radius: 65mm\n\n# the end\nreels:\n  big:\n    barrel: 1.2m\n    flange: 2.4m\n    width: 1m\n' >"$work/expected.yaml"
cmp "$work/own.yaml" "$work/expected.yaml" || fail "the file is not what it was and the entries"
cat >"$work/taken.yaml" <<'YAML'
include: [sheet.yaml, own.yaml]
cables: {power: {type: drum-18}}
route: {pieces: [{straight: 20 m}]}
surfaces: {ducts: [{type: pe-160}]}
friction: {mu: 0.3}
YAML
run_hawser 0 check taken.yaml
says out "sheet 4711: \"our\" maker's" "800 mm2"
refused() { # WHAT WORDS...: the file stays as it is
    what_is_said=$1
    shift
    run_hawser 2 library add "$@"
    says err "$what_is_said"
    cmp "$work/own.yaml" "$work/expected.yaml" || fail "$what: the file was changed"
}
refused "own.yaml:4: key 'ducts.pe-160': is there already" own.yaml ducts pe-160 radius=66mm
refused "expected a mass per length, such as" own.yaml cables x d=9mm "mass=15.2 kN"
refused "unknown key: did you mean 'mass'" own.yaml cables x d=9mm mas=15kg/m
refused "key 'cables.c.mass': missing" own.yaml cables x d=9mm
refused "'cable' is no kind" own.yaml cable x d=9mm
refused "is no KEY=VALUE" own.yaml ducts x radius
refused "is no KEY=VALUE" own.yaml ducts x "radius=65 mm
width: 3"
refused "'a b' is no name" own.yaml ducts "a b" radius=65mm
refused "expected typical or estimated" own.yaml ducts x radius=65mm mark=sure
refused "needs a file, a kind, a name and values" own.yaml ducts x
printf 'ducts: {old: {radius: 70 mm}}\n' >"$work/own.yaml" && cp "$work/own.yaml" "$work/expected.yaml"
refused "'ducts' stands in brackets" own.yaml ducts x radius=65mm
printf 'title: a case\n' >"$work/own.yaml" && cp "$work/own.yaml" "$work/expected.yaml"
refused "own.yaml:1: key 'title': unknown key" own.yaml ducts x radius=65mm
finish
