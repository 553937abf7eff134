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

# states that are damaged are refused before anything is changed: 9.8 MB of them became 0 bytes; through a link those of others
what="hawser run --resume of damaged states"
for at in 0 8 24 96 200; do
    rm -rf "$work/broken"
    cp -r "$work/kept-KILL" "$work/broken"
    printf '\377' | dd of="$work/broken/results.h5" bs=1 seek=$at conv=notrunc 2>/dev/null
    sum=$(cd "$work/broken" && cksum ./*)
    (cd "$work" && "$hawser" run --resume broken -q >out 2>err)
    case $? in
    0) ;; # a byte that says nothing
    4) [ "$(cd "$work/broken" && cksum ./*)" = "$sum" ] || fail "$what, byte $at: refused, and changed" ;;
    *) fail "$what, byte $at: another status than 4" ;;
    esac
done
for file in results.h5 series.csv results.xdmf; do
    rm -rf "$work/led"
    cp -r "$work/kept-KILL" "$work/led"
    mv "$work/led/$file" "$work/victim"
    cp "$work/victim" "$work/victim.was"
    ln -s ../victim "$work/led/$file"
    run_hawser 4 run --resume led
    cmp "$work/victim" "$work/victim.was" || fail "$what: $file outside of it was changed"
    says err "$file" "symbolic link"
done
# a journal that somebody has put there, of 2^60 bytes or of pages elsewhere, changes nothing before all is known
printf 'no journal' >"$work/led/results.h5.journal"
run_hawser 4 run --resume led

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
