# What is shown in which units: --units us leaves no SI unit in anything that people read, files stay as they are; and
# American units in cases.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

# without_si: no word of the last page is an SI unit.
without_si() {
    awk -f "$source/tests/cli/si_units.awk" "$work/out" >"$work/si" || {
        fail "$what: SI units in US output:"
        sed 's/^/    /' "$work/si" >&2
    }
}

# every column and every sentence of check and theory, over all examples and the cases that have every key
n=0
for file in "$source"/cases/*.yaml "$source"/tests/data/full-*.yaml; do
    for command in check theory; do
        what="hawser $command $file --units us"
        "$hawser" $command "$file" --units us >"$work/out" 2>"$work/err" || continue # a rod has no theory
        n=$((n + 1))
        without_si
        [ "$(awk 'length > 118 && FNR > 1' "$work/out" | wc -l)" = 0 ] || fail "$what: lines wider than a page"
    done
done
[ "$n" -ge 30 ] || fail "only $n pages were looked at"
# the check itself sees what it should
run_hawser 0 theory pull.yaml
awk -f "$source/tests/cli/si_units.awk" "$work/out" >"$work/si" && fail "si_units.awk finds nothing in SI output"

# runs: limits that are broken and not judged, a verdict of every kind, machines, rods
run_hawser 0 run "$source/cases/limits.yaml" -o us --units us --verbose
without_si
says out "NOT SAFE" "lbf" "lbf/ft" "kcmil" "psi" "ft in 'bend'"
run_hawser 0 run "$source/cases/limits.yaml" -o metric-run --units si --tables limits
says out "kN" "630 mm2"
for file in series.csv stations.csv rollers.csv; do
    cmp -s "$work/us/$file" "$work/metric-run/$file" || fail "$what: $file is not the same in other units"
done
grep -q '"steady_mean_N": 4597' "$work/us/summary.json" || fail "$what: summary.json is not in SI"
run_hawser 3 run pull.yaml -o few --set solver.max_steps=10 --units us
without_si
run_hawser 0 run "$source/cases/conveyors.yaml" -o belts --units us --tables machines --set run.duration='1 s' --set run.steady_from='500 ms'
without_si
says out "conveyors:" "lbf"
run_hawser 0 run "$source/cases/rod-cantilever.yaml" -o rod --units us
without_si

# for programs there is SI alone
run_hawser 2 theory pull.yaml --units us --format json
says err "--units us is for tables"
run_hawser 2 theory pull.yaml --units imperial
says err "--units imperial: 'si' or 'us' can be used"
run_hawser 0 validate --filter straight --units us
says out "lbf" "ft/min"

# American units in a case: the same scene, the same answer
run_hawser 0 theory pull.yaml --format json --set cables.power.mass='20 kg/m' --set 'limits={sidewall: 4.378 kN/m}'
cp "$work/out" "$work/metric"
run_hawser 0 theory pull.yaml --format json --set cables.power.mass='196.133 N/m' --set 'limits={sidewall: 4.378 kN/m}'
cmp -s "$work/out" "$work/metric" || fail "$what: a weight per length is not its mass"
run_hawser 0 theory "$source/tests/data/us-pull.yaml" --units us --tables all
says out "pull           200 lbf at the winch" "allowed 4000 lbf: 95 % left" "300  lbf/ft"
without_si

# what is questioned, in words that name the quantity
run_hawser 2 check pull.yaml --set 'limits.sidewall=300 lb/ft'
says err "not that of a force per length" "write 'lbf/ft' for pounds of force" "such as 5 kN/m"
grep -q stiffness "$work/err" && fail "$what: a sidewall pressure is called a stiffness"
run_hawser 2 check pull.yaml --set 'route.pieces=[{straight: 10 m}, {bend: 5, radius: 3 m, plane: left}]'
says err "route.pieces.1.bend" "'5' has no unit: is that degrees? write '5 deg' or '5 rad'"
run_hawser 2 check pull.yaml --set route.slope=0.5
says err "write '0.5 deg' or '0.5 rad'"
run_hawser 2 check pull.yaml --set 'route.pieces=[{straight: 10 m}, {bend: 5 deg, radius: 3 m, plane: 90}]'
says err "write '90 deg' or '90 rad'" "up, down, left, right"
finish
