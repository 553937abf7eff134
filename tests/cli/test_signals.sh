# SIGINT and SIGTERM: the run ends cleanly with exit status 130, and what was computed is in the folder.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

for signal in INT TERM; do
    what="hawser run, then SIG$signal"
    # an hour of simulated time; a shell lets a background program ignore SIGINT, so the trap is given back by env
    (cd "$work" && exec env --default-signal=INT "$hawser" run pull.yaml -o $signal --set run.duration='10000 s' \
        >out 2>err) &
    pid=$!
    # wait until it computes
    wait_until '[ "$(wc -l <"$work/$signal/series.csv")" -ge 3 ]'
    kill -$signal $pid
    wait $pid
    status=$?
    [ $status = 130 ] || fail "$what: exit status $status, not 130"
    says err "stopped at t ="
    says out "NOT TRUSTED" "  pull           " "Results: $signal"
    exists $signal/stations.csv $signal/rollers.csv
    grep -q '"outcome": "stopped"' "$work/$signal/summary.json" || fail "$what: not stopped in summary.json"
    tail -c 8 "$work/$signal/results.xdmf" | grep -qF '</Xdmf>' || fail "$what: results.xdmf is cut off"
    # the last row is whole
    tail -1 "$work/$signal/series.csv" | awk -F, 'NF != 15 { exit 1 }' || fail "$what: series.csv is cut off"
done

# signals while results are written: a row and a state every millisecond, so that there is always something on
# its way; what is left can be read, by who reads results
for after in 0 0.03 0.1 0.17 0.31; do
    what="hawser run that writes all the time, then SIGTERM after $after s"
    (cd "$work" && exec "$hawser" run pull.yaml -q -o writes --set run.duration='10000 s' --set output.interval='1 ms' \
        --set output.states='1 ms' >out 2>err) &
    pid=$!
    wait_until '[ "$(wc -l <"$work/writes/series.csv")" -ge 3 ]'
    sleep $after
    kill -TERM $pid
    wait $pid
    status=$?
    [ $status = 130 ] || fail "$what: exit status $status, not 130"
    grep -q '"outcome": "stopped"' "$work/writes/summary.json" || fail "$what: not stopped in summary.json"
    run_hawser 0 report writes -o writes.html
    grep -q 'no view' "$work/writes.html" && fail "$what: no states in the page"
    rm -rf "$work/writes" "$work/writes.html"
done

# a relaxation that takes many seconds is left at once; the folder is there before it begins
what="hawser run, then SIGTERM while the cable comes to rest"
(cd "$work" && exec "$hawser" run "$source/tests/data/passing-slow.yaml" -o slow >out 2>err) &
pid=$!
wait_until '[ -s "$work/slow/summary.json" ]'
kill -TERM $pid
wait $pid
status=$?
[ $status = 130 ] || fail "$what: exit status $status, not 130"
says err "stopped on the way to equilibrium"
# commands that only print end at once: a case that is a pipe without a writer holds them up for seconds
mkfifo "$work/pipe"
for signal in INT TERM HUP; do
    what="hawser check, then SIG$signal"
    (cd "$work" && exec env --default-signal=INT --default-signal=HUP "$hawser" check pipe >out 2>err) &
    pid=$!
    # until it is the program, with its handlers of SIGTERM, SIGINT and SIGHUP; a sanitizer has others besides
    while [ -d /proc/$pid ] && ! grep -q '^SigCgt:.*[4-7c-f]..[37bf]$' /proc/$pid/status; do sleep 0.02; done
    kill -$signal $pid
    wait $pid
    status=$?
    [ $status = 130 ] || fail "$what: exit status $status, not 130"
    says err "hawser: stopped"
done

# a run that would take for ever says what holds it up, on standard error, while it goes on
what="hawser run with steps of a millionth of a second"
(cd "$work" && exec env --default-signal=INT "$hawser" run pull.yaml -o held --set run.duration='100000 s' \
    --set solver.max_step='1 us' >out 2>err) &
pid=$!
wait_until 'grep -q "held up" "$work/err"'
kill -INT $pid
wait $pid
says err "held up: steps of 1e-06 s" "no step may be longer than 1e-06 s (solver.max_step" "at segment" "it takes another"
grep -q '"cause": "longest step"' "$work/held/summary.json" || fail "$what: summary.json does not say what held it up"
finish
