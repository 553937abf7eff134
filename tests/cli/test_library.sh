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
finish
