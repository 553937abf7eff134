# Runs: the report, the folder, where it goes by default, quiet, settings, equal results on one and two threads.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
files="series.csv stations.csv rollers.csv results.h5 results.xdmf summary.json"

run_hawser 0 run pull.yaml
for file in $files; do exists results/pull/$file; done
# half a metre from roller to roller is too coarse for two seconds of it: the answer says so, and by how much
sed -n 3p "$work/out" | grep -q "^NOT TRUSTED, for [12] reason" || fail "$what: the verdict is not at the top"
says out "the mean pull may be off by" "use a shorter chain.segment"
says out "A short pull" "Steady pull from 1.5 s to 2 s" "reference theory" "Results: results/pull"
says err "t = 2.00 s of 2 s, 100 %"
run_hawser 0 run pull.yaml --set chain.0.segment=250mm -o fine
# the answer comes first: the verdict, the pull with its bar, what to do; no solver's work unless it is asked for
sed -n 3p "$work/out" | grep -q "^NOT JUDGED" || fail "$what: the verdict is not at the top"
sed -n 4p "$work/out" | grep -q "^  pull  *mean .* +- " || fail "$what: the pull is not below the verdict"
says out "the figures are to be trusted: all" "give the allowed values in the case's section 'limits'"
for text in "40 segments" "Where the time went" "Work:" "Balances:" "right-hand sides"; do
    grep -qF "$text" "$work/out" && fail "$what: '$text' is said unasked"
done
tail -n 1 "$work/out" | grep -q "^Results: " || fail "$what: the report goes on behind the results"
[ "$(wc -l <"$work/out")" -le 20 ] || fail "$what: the report of a short pull has more than 20 lines"
grep -q '"outcome": "finished"' "$work/results/pull/summary.json" || fail "$what: not finished in summary.json"
# t = 0 and forty steps of the interval under a line of names; a row a station
[ "$(wc -l <"$work/results/pull/series.csv")" = 42 ] || fail "$what: series.csv has not 41 rows"
[ "$(wc -l <"$work/results/pull/stations.csv")" = 2 ] || fail "$what: stations.csv has not one row"
[ "$(grep -c '<Time ' "$work/results/pull/results.xdmf")" = 5 ] || fail "$what: results.xdmf has not 5 states"
awk -F, 'NR > 1 && $1 <= last { exit 1 } { last = NR > 1 ? $1 : -1 }' "$work/results/pull/series.csv" ||
    fail "$what: times do not rise"

# for a program: what summary.json holds, and nothing else
run_hawser 0 run pull.yaml -o json --format json
says out '"format": 2' '"verdict_code": "not_trusted"'
[ "$(head -c 1 "$work/out")" = "{" ] || fail "$what: something is said before the summary"
run_hawser 2 run pull.yaml -o json --format csv
says err "'table' or 'json' can be used"

for flag in -v --verbose; do
    run_hawser 0 run $flag -o chatty pull.yaml
    says out "20 segments" "Where the time went" "Work: 2 s in" "Balances: energy" "right-hand sides" "linear solver"
done
grep -q '"rhs_evals"' "$work/results/pull/summary.json" || fail "$what: the work is not in summary.json"

run_hawser 0 run -q -o deep/er/quiet pull.yaml
silent out
silent err
exists deep/er/quiet/summary.json
for file in series.csv stations.csv rollers.csv; do
    cmp -s "$work/results/pull/$file" "$work/deep/er/quiet/$file" || fail "$what: $file differs from run to run"
done
run_hawser 0 run --quiet --threads 2 --output two pull.yaml
for file in series.csv stations.csv rollers.csv; do
    cmp -s "$work/results/pull/$file" "$work/two/$file" || fail "$what: $file differs between one and two threads"
done

# without a winch there is no pull to set beside a theory
run_hawser 0 run -o still "$source/cases/slope-stick.yaml" --set run.duration="2 s" --set run.steady_from="1 s"
says out "nothing was pulled"
if grep -q "reference theory" "$work/out"; then fail "$what: a theory of what is not pulled"; fi

# into a folder that is there: files are replaced, others stay
echo mine >"$work/two/notes.txt"
run_hawser 0 run -q --linear-solver=klu --set run.duration=1s --set run.steady_from='0.5 s' --set output.states='0 s' -o two pull.yaml
exists two/notes.txt
[ "$(wc -l <"$work/two/series.csv")" = 22 ] || fail "$what: series.csv has not 21 rows"
grep -q '"linear_solver": "klu"' "$work/two/summary.json" || fail "$what: not solved by klu"

# a wrong case leaves them alone
cp -r "$work/two" "$work/before"
run_hawser 2 run -q --set run.duration=never -o two pull.yaml
diff -r "$work/two" "$work/before" >/dev/null || fail "$what: results were touched"

# an integration that cannot finish says so and keeps what it has
run_hawser 3 run -o stuck --set solver.tolerances.position='1e-25 m' pull.yaml
says err "hawser: integration failed at t =" "segment" "try"
says out "Results: stuck"
grep -q '"outcome": "failed"' "$work/stuck/summary.json" || fail "$what: not failed in summary.json"
[ "$(wc -l <"$work/stuck/series.csv")" -ge 2 ] || fail "$what: nothing was kept"
# a run that never came to its speed has not settled when it ends
run_hawser 0 run pull.yaml -o unsettled --set run.duration='800 ms' --set run.steady_from='400 ms'
says out "from 0.4 s to 0.8 s" "not settled when the run ended"
# reasons, one a line; the verdict names the first and counts the others
run_hawser 3 run pull.yaml -o few --set solver.max_steps=10
says out "NOT TRUSTED, for 3 reasons" "  finished       the run ended at" "  steady_window  the steady window was never" \
    "no mean: its window begins at 1.5 s, the run ended at 0."
grep -q "Steady pull from" "$work/out" && fail "$what: a steady pull of a window that was never reached"
grep -q '"steady_mean_N": null' "$work/few/summary.json" || fail "$what: a mean of a window that was never reached"

finish
