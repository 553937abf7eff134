# Results that cannot be written: exit status 4, with the file and the reason.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

touch "$work/file"
run_hawser 4 run pull.yaml -o file
says err "'file'" "Not a directory"
run_hawser 4 run pull.yaml -o file/below
says err "'file'" "Not a directory"
run_hawser 4 run pull.yaml -o ''
says err "cannot write"
run_hawser 4 run pull.yaml -o /proc/nowhere/below
says err "/proc/nowhere"
if [ "$(id -u)" != 0 ]; then
    mkdir "$work/locked"
    chmod 555 "$work/locked"
    run_hawser 4 run pull.yaml -o locked
    says err "locked/" "Permission denied"
fi
# a link within the folder is replaced; it was followed, and what it led to written over
for name in series.csv stations.csv rollers.csv summary.json results.h5 results.xdmf; do
    mkdir "$work/link-$name"
    echo precious >"$work/victim"
    ln -s ../victim "$work/link-$name/$name"
    run_hawser 0 run pull.yaml -o "link-$name" --quiet
    [ "$(cat "$work/victim")" = precious ] && [ ! -L "$work/link-$name/$name" ] || fail "$what: it leads out"
done

# a folder holds the results of one run
run_hawser 0 run pull.yaml -o twice --certify
exists twice/results.h5 twice/results.xdmf twice/certificate.json
run_hawser 0 run pull.yaml -o twice --set output.states=0
missing twice/results.h5 twice/results.xdmf twice/certificate.json
exists twice/series.csv twice/summary.json

# and two at once are refused, until the first has ended, however it did
(cd "$work" && exec "$hawser" run pull.yaml -o shared --quiet --set run.duration='100000 s' --set output.states=0) &
first=$!
wait_until '[ -s "$work/shared/series.csv" ]'
run_hawser 4 run pull.yaml -o shared
says err "'shared'" "in use by another run"
kill -KILL "$first"
wait "$first" 2>"$work/wait"
run_hawser 0 run pull.yaml -o shared
awk -F, 'NR == 1 {n = NF} NF != n {exit 1}' "$work/shared/series.csv" || fail "$what: rows are ragged"

# a folder that is renamed while a run writes into it, and another run that makes the name anew: each has its own
sums() { (cd "$work/$1" && find . -type f -exec cksum {} + | sort); }
# stopped_run DURATION MORE...: the first run, stopped while it writes; 1 where it was at its end before that
stopped_run() {
    duration=$1
    shift
    rm -rf "$work/moved" "$work/kept"
    (cd "$work" && exec "$hawser" run pull.yaml -o moved "$@" --set run.duration="$duration" --set run.checkpoint='1 ms' \
        >out 2>first) &
    first=$!
    wait_until '[ -s "$work/moved/series.csv" ] && [ -s "$work/moved/checkpoint.hawser" ] || ! kill -0 $first'
    kill -STOP $first 2>"$work/wait" && grep -q '"outcome": "running"' "$work/moved/summary.json" && return
    kill -CONT $first 2>"$work/wait"
    wait $first
    return 1
}
for more in "" "--certify"; do
    stopped_run '60 s' $more || stopped_run '600 s' $more || stopped_run '6000 s' $more ||
        fail "hawser run $more: it ended before it could be stopped"
    mv "$work/moved" "$work/kept"
    run_hawser 0 run pull.yaml -o moved --set friction.mu=0.31
    sums moved >"$work/second.sums"
    kill -CONT $first
    wait $first
    status=$?
    what="hawser run $more, its folder renamed and its name made anew"
    [ $status = 4 ] || fail "$what: exit status $status, not 4"
    grep -q "'moved' was renamed or replaced while the run went on: its results are in '.*/kept'" "$work/first" ||
        fail "$what: $(cat "$work/first")"
    sums moved | cmp -s - "$work/second.sums" || fail "$what: the second run's results are not as they were"
    grep -q '"outcome": "finished"' "$work/kept/summary.json" || fail "$what: the first run's results are not whole"
    missing kept/second-pass kept/checkpoint.hawser kept/results.h5.journal
    run_hawser 0 report kept -o kept.html
    run_hawser 0 report moved -o moved.html
done

# standard descriptors that are closed are not taken by files of results
for closed in 0 2; do
    what="hawser run with descriptor $closed closed"
    (cd "$work" && eval "exec $closed<&-" && exec "$hawser" run pull.yaml -o "closed-$closed" --quiet)
    [ $? = 0 ] || fail "$what: it failed"
    (cd "$work" && eval "exec $closed<&-" && exec "$hawser" run pull.yaml -o "closed-$closed" >out)
    awk -F, 'NR == 1 {n = NF} NF != n {exit 1}' "$work/closed-$closed/series.csv" || fail "$what: rows are ragged"
    grep -q "t =" "$work/closed-$closed/series.csv" && fail "$what: progress is in series.csv"
done

# the disk fills while it runs (a limit on the size of a file, in blocks of 512 bytes, stands in for it)
what="hawser run under ulimit -f"
(cd "$work" && ulimit -f 400 && exec "$hawser" run pull.yaml -o small --set output.states='5 ms' >out 2>err)
status=$?
[ $status = 4 ] || fail "$what: exit status $status, not 4"
says err "small/results.h5" "File too large"
grep -q '"outcome": "failed"' "$work/small/summary.json" || fail "$what: not failed in summary.json"
what="hawser run under a ulimit -f that leaves no room for a summary"
(cd "$work" && ulimit -f 1 && exec "$hawser" run pull.yaml -o tiny >out 2>err)
status=$?
[ $status = 4 ] || fail "$what: exit status $status, not 4"
says err "tiny/" "File too large"
missing tiny/summary.json.part
what="hawser run under a ulimit -f that leaves no room for the last summary"
one="--set output.states=0 --set solver.passes=1 --quiet"
run_hawser 0 run pull.yaml -o ample $one
blocks=$(($(wc -c <"$work/ample/summary.json") / 512 - 1))
(cd "$work" && ulimit -f $blocks && exec "$hawser" run pull.yaml -o endless $one 2>err)
status=$?
[ $status = 4 ] || fail "$what: exit status $status, not 4"
says err "endless/summary.json" "File too large"
grep -q '"outcome": "running"' "$work/endless/summary.json" || fail "$what: the summary is not the first one"
run_hawser 0 report endless
run_hawser 0 plot endless
what="hawser report under ulimit -f"
run_hawser 0 run pull.yaml -o paged
(cd "$work" && ulimit -f 8 && exec "$hawser" report paged >out 2>err)
status=$?
[ $status = 4 ] || fail "$what: exit status $status, not 4"
says err "paged/report.html" "File too large"
missing paged/report.html paged/report.html.part
finish
