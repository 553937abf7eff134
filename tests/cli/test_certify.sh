# --certify on the command line: the table, the file, the exit statuses, and Ctrl-C.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
cp "$source/tests/data/certify.yaml" "$source/tests/data/certify-rod.yaml" "$work"

run_hawser 0 run certify.yaml -o good --certify --strict
says out "SAFE: all" "Errors by source" "pull, mean" "CERTIFIED: all 7 figures hold to 1 %"
says err "certifying, round 1: 3 of 3 runs over"
exists good/certificate.json good/summary.json good/series.csv
grep -q '"verdict": "CERTIFIED: ' "$work/good/certificate.json" || fail "certificate.json has no verdict"
[ "$(ls "$work/good" | grep -c certificate)" = 1 ] || fail "more than one file was written"

# a tolerance that first order steps do not reach; not certified is a result like any other without --strict
run_hawser 0 run certify.yaml -o bad --tolerance 0.001% --quiet
silent out
silent err
grep -q '"verdict": "NOT CERTIFIED: to 0.001 % do not hold: ' "$work/bad/certificate.json" || fail "it should not hold"
run_hawser 7 run certify.yaml -o bad --tolerance 0.00001 --quiet --strict
says err "NOT CERTIFIED: to 0.001 % do not hold: "
# what is not safe or not to be trusted weighs more
run_hawser 1 run certify.yaml -o bad --certify --quiet --strict --set limits.pull=100N
run_hawser 6 run certify.yaml -o bad --certify --quiet --strict --set friction.v_d=400mm/s --set friction.v_s=200mm/s
says err "NOT TRUSTED"
grep -q '"verdict": "NOT CERTIFIED: the run is not to be trusted (friction_speed' "$work/bad/certificate.json" ||
    fail "a run that is not trusted was certified"

# a rod's tip, statics
run_hawser 0 run certify-rod.yaml -o rod --certify
says out "displacement of tip, z" "CERTIFIED: all 12 figures hold"

# a run that fails is not certified, and stays what it is
run_hawser 3 run certify.yaml -o failed --certify --set solver.max_steps=10
missing failed/certificate.json
for wrong in 0% 60% x 1e9 ''; do
    run_hawser 2 run certify.yaml -o wrong --tolerance "$wrong"
    says err "must be a share from 0.0001% to 50%"
done
for wrong in 0 -1 x ''; do
    run_hawser 2 run certify.yaml -o wrong --effort "$wrong"
    says err "--effort $wrong: must be a number from 1 to 1000000"
done
run_hawser 0 run certify.yaml -o more --effort 30 --tolerance 0.2% --quiet
run_hawser 2 theory certify.yaml --certify
missing wrong
run_hawser 0 run --help
says out "--certify" "--tolerance SHARE" "--effort N" "7 if the run is not certified"

# Ctrl-C while the case is computed again: the results of the run are there, a certificate is not
(cd "$work" && exec "$hawser" run certify.yaml -o cut --tolerance 0.0001% >cut.out 2>cut.err) &
pid=$!
wait_until 'grep -q certifying "$work/cut.err"'
kill -INT "$pid"
wait "$pid"
status=$?
[ "$status" = 130 ] || fail "a certificate that was interrupted ends with $status"
grep -q "stopped while the figures were being certified" "$work/cut.err" || fail "nothing was said of it"
exists cut/summary.json
missing cut/certificate.json

finish
