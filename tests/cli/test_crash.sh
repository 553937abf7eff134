# Whatever ends a run, whatever a path leads to: results up to the last flush can be read, the folder is free for the next
# run, and nothing waits for ever.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
long="--set run.duration=1000s --set output.states=1ms --quiet"

# kills at moments of all kinds, the file of states compressed
if command -v h5dump >/dev/null 2>&1; then
    for moment in 0.05 0.11 0.2 0.33 0.5 0.56 0.8 1.05; do
        what="hawser run, killed after $moment s"
        (cd "$work" && exec "$hawser" run pull.yaml -o killed $long) &
        pid=$!
        sleep $moment
        kill -KILL $pid
        wait $pid 2>"$work/wait"
        [ -s "$work/killed/results.h5" ] || continue
        h5dump "$work/killed/results.h5" >"$work/dump" 2>"$work/err" || fail "$what: results.h5 cannot be read"
        awk -F, 'NR == 1 {n = NF} NF != n {exit 1}' "$work/killed/series.csv" || fail "$what: rows are ragged"
    done
fi
run_hawser 0 run pull.yaml -o killed --quiet

# freed memory holds other things
what="hawser run, freed memory overwritten"
(cd "$work" && MALLOC_PERTURB_=165 "$hawser" run pull.yaml -o perturbed --quiet) || fail "$what: it failed"

# SIGHUP as SIGTERM, but not under nohup; a step that takes long is not waited for
what="hawser run, then SIGHUP"
(cd "$work" && exec "$hawser" run pull.yaml -o hup $long 2>err) &
pid=$!
wait_until '[ "$(wc -l <"$work/hup/series.csv")" -ge 3 ]'
kill -HUP $pid
wait $pid
[ $? = 130 ] || fail "$what: not 130"
what="hawser run with a large dense matrix, then SIGTERM"
(cd "$work" && exec "$hawser" run "$source/cases/tunnel-879.yaml" -o dense --quiet --linear-solver dense 2>err) &
pid=$!
wait_until '[ -s "$work/dense/summary.json" ]'
sleep 1
kill -TERM $pid
wait $pid
[ $? = 130 ] || fail "$what: not 130"
grep -q stopped "$work/err" || fail "$what: nothing is said"

# nobody reads what is printed
what="hawser run into a closed pipe"
(cd "$work" && { "$hawser" run pull.yaml -o head 2>err; echo $? >status; } | head -1 >out)
grep -q '"outcome": "finished"' "$work/head/summary.json" || fail "$what: results are not whole"

# the folder vanishes while it runs
what="hawser run, its folder removed"
(cd "$work" && exec "$hawser" run pull.yaml -o gone --set output.interval=1ms --quiet --set run.duration=300s 2>err) &
pid=$!
wait_until '[ "$(wc -l <"$work/gone/series.csv")" -ge 3 ]'
rm -rf "$work/gone"
wait $pid
status=$?
[ $status = 4 ] || [ $status = 0 ] || fail "$what: status $status"
[ $status != 0 ] || exists gone/summary.json

# what is no file, or none of a case's size
mkdir "$work/folder"
mkfifo "$work/fifo"
truncate -s 2G "$work/large"
ln -s loop "$work/loop"
run_hawser 2 check folder
says err "folder: cannot be read: Is a directory"
run_hawser 2 check fifo
says err "nothing was written into it"
run_hawser 2 check /dev/zero
says err "not a file"
run_hawser 2 check large
says err "File too large"
run_hawser 2 check loop
says err "Too many levels of symbolic links"
what="hawser check of a pipe"
(cd "$work" && cat pull.yaml | "$hawser" check /dev/stdin >out) || fail "$what: it failed"

# no HOME, no environment at all
what="hawser check without an environment"
(cd "$work" && env -i "$hawser" check pull.yaml >out) || fail "$what: it failed"

# refused before memory is taken; a sanitizer keeps terabytes of addresses for itself and limits what is used instead
limit="ulimit -v 1000000"
(cd "$work" && $limit && exec "$hawser" --version >out 2>err) || {
    limit=:
    export ASAN_OPTIONS="${ASAN_OPTIONS-}:hard_rss_limit_mb=1000:max_allocation_size_mb=1000"
}
for setting in run.duration=1e300s output.interval=1e-9s output.states=1e-9s chain.0.segment=1um \
    rollers.along.spacing=1um chain.0.length=1e300m 'rollers.along.rating=1e400N'; do
    what="hawser check --set $setting"
    (cd "$work" && $limit && exec "$hawser" check pull.yaml --set "$setting" >out 2>err)
    [ $? = 2 ] || fail "$what: not 2"
    grep -q "out of range\|too short\|too many\|too large" "$work/err" || fail "$what: $(cat "$work/err")"
    case $setting in
    *segment* | *spacing* | output*) grep -q "needs [0-9.e+]* GB" "$work/err" || fail "$what: not what it needs" ;;
    esac
done
# within the bounds, and more than the machine may give
if [ "$limit" != : ]; then
    what="hawser run of a chain that needs more than there is"
    (cd "$work" && ulimit -v 300000 && exec "$hawser" run pull.yaml -o much --quiet --set chain.0.length=500m \
        --set chain.0.segment=5mm --set route.pieces.0.straight=550m --set route.head_at=502m >out 2>err)
    [ $? = 5 ] || fail "$what: not 5"
    says err "out of memory: the run needs 4" "there are 0.3"
    missing much
fi

# text that would command a terminal or a spreadsheet
run_hawser 2 check pull.yaml --set 'title="a\e[31mb"'
says err "control character"
run_hawser 0 run pull.yaml -o cells --quiet --set 'output.stations=[{name: "=1+1", at: 7 m}]'
grep -q "^'=1+1," "$work/cells/stations.csv" || fail "$what: a formula is in stations.csv"
finish
