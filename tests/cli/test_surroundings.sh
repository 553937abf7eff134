# Where a run takes place: another locale, no home, another user, folders that may not be written, no descriptors.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

# same_as DIR OTHER: the same numbers are in both.
same_as() {
    for file in series.csv stations.csv rollers.csv route.csv inputs.csv; do
        cmp -s "$work/$1/$file" "$work/$2/$file" || fail "$what: $file is not the same"
    done
}
short="--set run.duration=0.3s --set run.steady_from=0.2s"
run_hawser 0 run pull.yaml -o plain $short
cp "$work/out" "$work/plain.out"
run_hawser 0 theory pull.yaml --format json
cp "$work/out" "$work/plain.json"

# decimal commas: through all the program
if command -v localedef >/dev/null 2>&1 && localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" >"$work/log" 2>&1; then
    # the C library keeps what it has read of LOCPATH to the end
    export LOCPATH="$work" LC_ALL=de_DE.UTF-8 LANG=de_DE.UTF-8 ASAN_OPTIONS="${ASAN_OPTIONS-}:detect_leaks=0"
    run_hawser 0 run pull.yaml -o german $short
    same_as german plain
    run_hawser 0 theory pull.yaml --format json
    cmp -s "$work/out" "$work/plain.json" || fail "$what: theory is not the same"
    run_hawser 0 check pull.yaml --set 'friction.mu=0.25'
    says out "0.25"
    run_hawser 2 check pull.yaml --set 'friction.mu=0,25'
    run_hawser 0 report german -o german.html
    run_hawser 0 plot german tension
    grep -q '[0-9],[0-9]* *L' "$work/out" && fail "$what: commas in the figure's path"
    run_hawser 0 library cables
    unset LOCPATH LC_ALL LANG
    ASAN_OPTIONS="${ASAN_OPTIONS%:detect_leaks=0}"
else
    echo "skipped: no localedef, or no sources of de_DE; decimal commas are not tried"
fi

# nothing in the environment
what="hawser run without an environment"
(cd "$work" && env -i "$hawser" run pull.yaml -o bare $short --quiet >"$work/out" 2>"$work/err") || fail "$what: it failed"
same_as bare plain
what="hawser run without HOME"
(cd "$work" && unset HOME && "$hawser" run pull.yaml -o homeless $short --quiet >"$work/out" 2>"$work/err") || fail "$what"
what="hawser run with a HOME that is not there"
(cd "$work" && HOME=/nowhere "$hawser" run pull.yaml -o homeless $short --quiet >"$work/out" 2>"$work/err") || fail "$what"

# neither output nor errors can be written anywhere
what="hawser run with standard output and error closed"
(cd "$work" && exec "$hawser" run pull.yaml -o mute $short >&- 2>&-)
status=$?
[ $status = 0 ] || [ $status = 4 ] || fail "$what: status $status"
same_as mute plain
what="hawser run with standard input, output and error closed"
(cd "$work" && exec "$hawser" run pull.yaml -o mute $short --quiet <&- >&- 2>&-) || fail "$what: status $?"
same_as mute plain
what="hawser check into a pipe that is closed after a line"
(cd "$work" && { "$hawser" theory pull.yaml 2>err; echo $? >status; } | head -1 >out)
[ "$(cat "$work/status")" -lt 128 ] || fail "$what: status $(cat "$work/status")"

# files of two runs in one folder
run_hawser 0 run pull.yaml -o other --set friction.mu=0.31 $short
cp -r "$work/plain" "$work/mixed"
cp "$work/other/series.csv" "$work/mixed/series.csv"
printf 'time_s,pull_N\n0,0\n1,10\n2,20\n' >"$work/log.csv"
for call in "report mixed -o mixed.html" "plot mixed tension" "compare mixed log.csv"; do
    run_hawser 2 $call
    says err "series.csv' does not belong to the summary beside it: it is of another run"
done
missing mixed.html

# nothing is written over what is read: a case, its route and catalogue, a study's list, a log, results
mkdir "$work/own" "$work/links" "$work/hard" "$work/alone"
sed 's/power: {EA.*/power: {type: own}/; s/pieces: .*/file: route.csv/; s/^title/include: inputs.csv\ntitle/' "$work/pull.yaml" >"$work/own/case.yaml"
sed -n 's/  power: /cables: {own: /; s/kg\/m}$/kg\/m}}/p' "$work/pull.yaml" | grep own: >"$work/own/inputs.csv"
printf 'x [m],y [m],z [m]\n0,0,0\n10,0,0\n20,0,0\n' >"$work/own/route.csv"
printf 'friction.mu\n0.2\n0.3\n' >"$work/own/samples.csv"
printf 'case: case.yaml\nlist: {file: samples.csv}\n' >"$work/own/study.yaml"
awk 'BEGIN {print "time [s],pull [kN]"; for (i = 0; i < 90; i++) print i / 300 "," 2 + i / 1000}' >"$work/own/log.csv"
cp "$work/pull.yaml" "$work/alone/series.csv"
ln -s own "$work/folder"
ln -s ../own/route.csv "$work/links/stations.csv"
ln "$work/own/inputs.csv" "$work/hard/report.html"
run_hawser 0 check own/case.yaml
run_hawser 0 run own/case.yaml -o shown $short --quiet
ln -s summary.json "$work/shown/tension.svg"
all_sums() { (cd "$work" && find own links hard alone shown -type f -exec cksum {} + | sort); }
all_sums >"$work/sums"
while read -r file call; do
    run_hawser 2 $call
    says err "cannot write '" "$file', which is an input"
    all_sums | cmp -s - "$work/sums" || fail "$what: something was written, moved or made"
done <<CALLS
inputs.csv run own/case.yaml -o own
inputs.csv run own/case.yaml -o links/../own
inputs.csv run own/case.yaml -o folder
route.csv run own/case.yaml -o links
inputs.csv run own/case.yaml -o hard --report
series.csv run alone/series.csv -o alone
own/route.csv route own/route.csv -o own/../own/route.csv
own/route.csv route own/route.csv -o links/stations.csv
samples.csv study own/study.yaml -o own
shown/summary.json report shown -o shown/summary.json
shown/series.csv report shown plain -o shown/series.csv
shown/summary.json plot shown
own/log.csv compare shown own/log.csv --align start --page own/log.csv
shown/series.csv compare shown own/log.csv --align start --page shown/series.csv
own/case.yaml fmu own/case.yaml -o own/case.yaml
inputs.csv theory own/case.yaml --crew hard/report.html
own/case.yaml theory own/case.yaml --report -o own/case.yaml
CALLS
run_hawser 0 route own/route.csv -o own/other.csv
run_hawser 0 study own/study.yaml -o own/study --quiet

# links to links: as many as the system follows
cd "$work"
ln -s pull.yaml link-0
k=0
while [ $k -lt 45 ]; do
    ln -s link-$k link-$((k + 1))
    k=$((k + 1))
done
run_hawser 0 check link-30
run_hawser 2 check link-45
says err "Too many levels of symbolic links"
mkdir real
ln -s real folder-0
ln -s folder-0 folder-1
run_hawser 0 run pull.yaml -o folder-1/deep $short --quiet
exists real/deep/summary.json

# another user's files, and a folder that may only be read; root may write everywhere
user="setpriv --reuid=65534 --regid=65534 --clear-groups"
mkdir "$work/theirs"
chmod 755 "$work" "$work/theirs"
if [ "$(id -u)" != 0 ]; then
    chmod 555 "$work/theirs"
    user=
fi
cp "$hawser" "$work/hawser"
if (cd "$work" && $user ./hawser --version >/dev/null 2>&1); then
    what="hawser run into another user's folder"
    (cd "$work" && $user ./hawser run pull.yaml -o theirs $short >out 2>err)
    [ $? = 4 ] || fail "$what: not 4"
    says err "cannot write 'theirs/" "Permission denied"
    what="hawser run into a folder that cannot be made"
    (cd "$work" && $user ./hawser run pull.yaml -o theirs/new $short >out 2>err)
    [ $? = 4 ] || fail "$what: not 4"
    says err "Permission denied"
    missing theirs/new theirs/summary.json
    what="hawser check of another user's case"
    cp "$work/pull.yaml" "$work/secret.yaml"
    chmod 000 "$work/secret.yaml"
    (cd "$work" && $user ./hawser check secret.yaml >out 2>err)
    [ $? = 2 ] || fail "$what: not 2"
    says err "secret.yaml" "Permission denied"
else
    echo "skipped: the program cannot be run as another user here"
fi

# a stack that would not do is told
what="hawser check with a stack of 64 KiB"
(cd "$work" && ulimit -s 64 && exec "$hawser" check pull.yaml >out 2>err)
[ $? = 5 ] || fail "$what: not 5"
says err "stack is limited to 64 KiB" "ulimit -s" "512"

# shows_unended WHAT: pages and figures of the folder `twice` are made, and say that its run has no end.
shows_unended() {
    run_hawser 0 report twice -o unended.html --quiet
    what="$what, $1"
    grep -q "This run has not ended: it is under way, or it was cut off" "$work/unended.html" || fail "$what: not said"
    run_hawser 0 plot twice series -o unended --quiet
    grep -q "run not ended" "$work/unended/series.svg" || fail "$what, $1: not said"
    awk 'BEGIN {print "time [s],pull [kN]"; for (i = 0; i < 90; i++) print i / 100 "," 2 + i / 1000}' >"$work/unended.csv"
    run_hawser 0 compare twice unended.csv --align start
    says out "the run has not ended"
}

# good results stay until others are whole
run_hawser 0 run pull.yaml -o twice $short --quiet
cp "$work/twice/series.csv" "$work/first.csv"
what="hawser run over good results, killed"
(cd "$work" && exec "$hawser" run pull.yaml -o twice --set run.duration=100000s --quiet) &
pid=$!
wait_until 'grep -q running "$work/twice/summary.json"'
wait_until '[ "$(wc -l <"$work/twice/series.csv")" -ge 100 ]'
shows_unended "under way"
kill -KILL $pid
wait $pid 2>/dev/null
shows_unended "killed"
cmp -s "$work/twice/earlier/series.csv" "$work/first.csv" || fail "$what: the good results are lost"
grep -q '"finished"' "$work/twice/earlier/summary.json" || fail "$what: their summary is lost"
run_hawser 4 run pull.yaml -o twice/summary.json $short --quiet
rm "$work/twice/series.csv"
ln -s /dev/full "$work/twice/series.csv"
run_hawser 0 run pull.yaml -o twice $short --quiet # a link is replaced, not followed
[ -L "$work/twice/series.csv" ] && fail "$what: written through a link"
cmp -s "$work/twice/series.csv" "$work/first.csv" || fail "$what: other results"
missing twice/earlier
finish
