# hawser run --resume: what a kill or an interruption leaves is gone on with, and what cannot be is refused.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

settings="--set run.duration=1000s --set run.checkpoint=1ms"
# shellcheck disable=SC2086 # words of options
(cd "$work" && "$hawser" run pull.yaml -q -o whole $settings) || fail "the run that nobody interrupts"
[ ! -e "$work/whole/checkpoint.hawser" ] || fail "a checkpoint of a run that has ended"

for signal in KILL INT; do
    what="hawser run, SIG$signal, hawser run --resume"
    # shellcheck disable=SC2086
    (cd "$work" && exec env --default-signal=INT "$hawser" run pull.yaml -q -o $signal $settings >out 2>err) &
    pid=$!
    wait_until '[ -e "$work/$signal/checkpoint.hawser" ]'
    kill -$signal $pid 2>/dev/null || fail "$what: the run was over already"
    wait $pid
    cp -r "$work/$signal" "$work/kept-$signal"
    run_hawser 0 run --resume $signal --threads 2
    [ ! -e "$work/$signal/checkpoint.hawser" ] || fail "$what: the checkpoint is still there"
    for file in series.csv stations.csv rollers.csv inputs.csv route.csv results.xdmf; do
        [ ! -e "$work/whole/$file" ] || cmp "$work/whole/$file" "$work/$signal/$file" || fail "$what: $file"
    done
done

# a checkpoint of another run does no harm to the results beside it
run_hawser 0 run pull.yaml -q -o foreign --set friction.mu=0.3
cp "$work/kept-KILL/checkpoint.hawser" "$work/foreign/"
(cd "$work/foreign" && cksum series.csv results.h5 summary.json >../sums 2>/dev/null)
run_hawser 4 run --resume foreign
says err "its results are of another run than its checkpoint"
(cd "$work/foreign" && cksum series.csv results.h5 summary.json 2>/dev/null) | cmp - "$work/sums" || fail "$what: changed"

run_hawser 2 run --resume KILL
says err "cannot read the checkpoint 'KILL/checkpoint.hawser'"
run_hawser 2 run --resume nowhere
says err "nowhere/checkpoint.hawser"
run_hawser 2 run pull.yaml --resume kept-KILL
says err "goes on with the case and the settings of the run" "'pull.yaml' cannot be given"
run_hawser 2 run --resume kept-KILL --set run.duration=1s
says err "'--set' cannot be given"
run_hawser 2 run --resume kept-KILL -o elsewhere
says err "'--output' cannot be given"

# refused without a change: a damaged checkpoint, one of other kernels, a folder that somebody has cut
before=$(cat "$work/kept-KILL/series.csv" "$work/kept-KILL/summary.json" | cksum)
cp -r "$work/kept-KILL" "$work/damaged"
printf x | dd of="$work/damaged/checkpoint.hawser" bs=1 seek=3000 conv=notrunc 2>/dev/null
run_hawser 2 run --resume damaged
says err "the checkpoint 'damaged/checkpoint.hawser' is damaged or cut off"
printf 'winch: 3\n' >"$work/damaged/checkpoint.hawser"
run_hawser 2 run --resume damaged
says err "is not a checkpoint of hawser"
after=$(cat "$work/damaged/series.csv" "$work/damaged/summary.json" | cksum)
[ "$before" = "$after" ] || fail "a refused checkpoint: the folder has changed"
cp -r "$work/kept-KILL" "$work/cut"
printf 'time_s\n' >"$work/cut/series.csv"
run_hawser 4 run --resume cut
says err "cut/series.csv"
finish
