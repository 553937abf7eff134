# Derivatives: of theory, and of a run beside it; the page of a study's folder.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 theory "$source/cases/huangjiahu.yaml" --sensitivities
says out "What the winch's force changes by" "tension at the start" "friction" "weight along the route" "two-sided" "winch by a newton here"
run_hawser 0 theory pull.yaml --sensitivities --format json
says out '"name": "friction"' '"forward_N_per_unit"' '"winch_by_tension"'
run_hawser 2 theory pull.yaml --sensitivity
says err "unknown option '--sensitivity'"

# a run with them: the run's own results do not change by it
run_hawser 0 run pull.yaml --quiet -o plain
run_hawser 0 run pull.yaml --sensitivities friction.mu,cables.power.mass -o with
says out "What a run's figures change by" "pull" "tension at middle" "friction.mu" "cables.power.mass"
exists with/sensitivities.json
cmp -s "$work/plain/series.csv" "$work/with/series.csv" || fail "the run is another with sensitivities"
run_hawser 2 run pull.yaml --quiet --sensitivities friction.my -o bad
says err "friction.my: the case gives no number other than 0 there"
run_hawser 2 run pull.yaml --quiet --sensitivities route.pieces.0.straight -o bad
says err "route.pieces.0.straight: the route's shape opens and closes contacts"

# one position by every number of the case
run_hawser 0 run pull.yaml --sensitivities all -o all
says out "What the figures of a position change by" "friction.mu" "cables.power.EI" "drive.winch.speed"
exists all/sensitivities.json
! grep -q '"route\.' "$work/all/sensitivities.json" || fail "a slope by the route's shape"
keys=$(awk 'BEGIN { for (k = 0; k < 65; k++) printf "friction.mu,"; }')
run_hawser 2 run pull.yaml --quiet --sensitivities "$keys" -o bad
says err "--sensitivities: more than 64 keys"

# the page of a study, anew
sed "s|\.\./|$source/cases/|; s/samples: 1024/samples: 64/" "$source/cases/studies/friction.yaml" >"$work/study.yaml"
run_hawser 0 study study.yaml --quiet -o study
run_hawser 0 report study -o page.html
cmp -s "$work/page.html" "$work/study/study.html" || fail "the page is not the study's"
rm "$work/study.yaml"
run_hawser 2 report study -o other.html
says err "study.yaml"
finish
