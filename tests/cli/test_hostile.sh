# A folder, a current folder, a PATH and a locale from somebody else: nothing leads out, nothing is destroyed, nothing hangs.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

short="--set run.duration=200ms --set run.steady_from=100ms --quiet"
# shellcheck disable=SC2086
run_hawser 0 run pull.yaml -o good $short
mkdir "$work/victims"

# precious FILE: a file that nobody may touch; untouched: whether it is as it was.
precious() { echo precious >"$work/victims/$1"; }
untouched() {
    for file in "$work"/victims/*; do [ "$(cat "$file")" = precious ] || fail "$what: $file was written over"; done
}

# symbolic links in place of files; each of these replaced what it leads to, with status 0
for name in report.html.part report.html tension.svg.part tension.svg; do
    cp -r "$work/good" "$work/linked"
    precious "$name"
    ln -s "../victims/$name" "$work/linked/$name"
    run_hawser 0 report linked --quiet
    run_hawser 0 plot linked --quiet
    untouched
    rm -r "$work/linked"
done
for name in series.csv stations.csv rollers.csv inputs.csv route.csv results.xdmf results.h5 summary.json summary.json.part results.h5.part; do
    cp -r "$work/good" "$work/linked"
    rm -f "$work/linked/summary.json" "$work/linked/$name" # it has not ended: nothing is kept of it
    precious "$name"
    ln -s "../victims/$name" "$work/linked/$name"
    # shellcheck disable=SC2086
    run_hawser 0 run pull.yaml -o linked $short
    untouched
    rm -r "$work/linked"
done
# a second name of a file is left what it was, too
cp -r "$work/good" "$work/linked"
rm "$work/linked/series.csv" "$work/linked/summary.json"
precious second
ln "$work/victims/second" "$work/linked/series.csv"
# shellcheck disable=SC2086
run_hawser 0 run pull.yaml -o linked $short
untouched
rm -r "$work/linked"

# `earlier` as a link: all results there were deleted
cp -r "$work/good" "$work/others"
cp -r "$work/good" "$work/linked"
ln -s ../others "$work/linked/earlier"
# shellcheck disable=SC2086
run_hawser 4 run pull.yaml -o linked $short
diff -r "$work/good" "$work/others" >/dev/null || fail "$what: results were deleted through earlier"
rm -r "$work/linked"

# FIFOs: each hung for ever
for name in results.h5 series.csv summary.json; do
    cp -r "$work/good" "$work/piped"
    rm "$work/piped/$name"
    mkfifo "$work/piped/$name"
    run_hawser 2 report piped -o page.html
    says err "not a file"
    rm -r "$work/piped"
done
mkdir "$work/piped"
mkfifo "$work/piped/checkpoint.hawser"
run_hawser 2 run --resume piped
says err "not a file"

# a study's rows
printf 'case: pull.yaml\nparameters:\n  friction.mu: {uniform: [0.2, 0.3]}\nsamples: 2\nanswer: theory\n' >"$work/study.yaml"
mkdir -p "$work/rows/workers"
precious rows
ln -s ../../victims/rows "$work/rows/workers/worker-0.rows"
(cd "$work" && "$hawser" study study.yaml -o rows --jobs 1 --quiet >out 2>err </dev/null)
what="hawser study with rows that lead out"
untouched
rm -r "$work/rows"
mkdir "$work/rows" "$work/victims.d"
ln -s ../victims.d "$work/rows/workers"
(cd "$work" && "$hawser" study study.yaml -o rows --jobs 1 --quiet >out 2>err </dev/null)
[ -z "$(ls "$work/victims.d")" ] || fail "a study's workers wrote outside of its folder"

# several pages of one folder at once: 20 of 75 failed, as all wrote under one name
for round in 1 2 3; do
    pids=
    for k in 1 2 3; do
        (cd "$work" && exec "$hawser" report good --quiet) &
        pids="$pids $!"
    done
    for pid in $pids; do wait "$pid" || fail "one of three reports at once"; done
done
ls "$work/good" | grep -q part && fail "parts are left"

# --pdf without a browser: the one that was there was deleted
precious report.pdf
cp "$work/victims/report.pdf" "$work/good/report.pdf"
mkdir "$work/empty"
what="hawser report --pdf without a browser"
(cd "$work" && PATH=$work/empty "$hawser" report good --pdf >out 2>err) && fail "$what: status 0"
[ "$(cat "$work/good/report.pdf")" = precious ] || fail "$what: the PDF that was there is gone"

# programs and libraries of the current folder, for which a PATH and a RUNPATH had empty elements
mkdir "$work/here"
printf '#!/bin/sh\ntouch "%s/was-run"\n' "$work" >"$work/here/chromium"
chmod +x "$work/here/chromium"
for path in "" . ":" "here:."; do
    (cd "$work/here" && PATH=$path "$hawser" report ../good --pdf >/dev/null 2>&1)
done
[ ! -e "$work/was-run" ] || fail "a browser of the current folder was run"
for name in libnlopt.so.0 libyaml-0.so.2 libhdf5_serial.so.103; do echo none >"$work/here/$name"; done
(cd "$work/here" && "$hawser" --version >/dev/null 2>&1) || fail "a library of the current folder was loaded"
ln -s /nowhere "$work/here/results.h5"
(cd "$work/here" && "$hawser" report ../good --quiet -o ../page.html) || fail "a file of the current folder was followed"
grep -q '"states":' "$work/page.html" || fail "results.h5 of the current folder hides that of the results"
(cd "$work" && LC_ALL=de_DE.UTF-8 LANGUAGE=de "$hawser" theory pull.yaml >german 2>/dev/null; "$hawser" theory pull.yaml | cmp -s - german) ||
    fail "a locale changes what is printed"

# bytes of a name that a terminal would obey
odd=$(printf 'odd\033]0;x\007')
run_hawser 0 report good -o "$odd.html"
says out "Report: odd?]0;x?.html"
finish
