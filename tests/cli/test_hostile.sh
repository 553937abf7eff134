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
cp -r "$work/good" "$work/linked"
for name in report.html.part report.html tension.svg.part tension.svg; do
    precious "$name"
    ln -sf "../victims/$name" "$work/linked/$name"
done
run_hawser 0 report linked --quiet
run_hawser 0 plot linked --quiet
untouched
rm -r "$work/linked"
# the summary by itself: without it the others are not those of a run
for names in summary.json \
    "series.csv stations.csv rollers.csv inputs.csv route.csv results.xdmf results.h5 summary.json.part results.h5.part"; do
    cp -r "$work/good" "$work/linked"
    sed -i 's/"finished"/"stopped"/' "$work/linked/summary.json" # nothing is kept of it
    for name in $names; do
        precious "$name"
        ln -sf "../victims/$name" "$work/linked/$name"
    done
    # shellcheck disable=SC2086
    run_hawser 0 run pull.yaml -o linked $short
    untouched
    rm -r "$work/linked"
done
# files of somebody's, in a folder in which no run has begun, are not written over or taken away
for name in route.csv report.pdf results.h5 checkpoint.hawser earlier/series.csv earlier/report.html; do
    mkdir -p "$work/own/earlier"
    echo mine >"$work/own/$name"
    # shellcheck disable=SC2086
    run_hawser 4 run pull.yaml -o own $short
    says err "own/$name' is there, and no summary.json of a run"
    [ "$(cd "$work/own" && find . -type f -exec cat {} +)" = mine ] || fail "$what: $name is gone"
    rm -r "$work/own"
done
# a second name of a file is left what it was, too
cp -r "$work/good" "$work/linked"
rm "$work/linked/series.csv"
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

# a study's files: each a link that leads out, in a folder that a study has written
printf 'case: pull.yaml\nparameters:\n  friction.mu: {uniform: {from: 0.2, to: 0.3}}\nmonte-carlo: {samples: 2}\nfidelity: theory\n' >"$work/study.yaml"
run_hawser 0 study study.yaml -o rows --jobs 1 --quiet
[ -f "$work/rows/workers/worker-0.rows" ] || fail "a study without rows of workers"
for name in $(cd "$work/rows" && find . -type f); do
    cp -r "$work/rows" "$work/linked"
    precious rows
    ln -sf "$work/victims/rows" "$work/linked/$name"
    for fresh in "" --fresh; do
        what="hawser study $fresh with $name that leads out"
        # shellcheck disable=SC2086
        (cd "$work" && "$hawser" study study.yaml -o linked --jobs 1 --quiet $fresh >out 2>err </dev/null)
        status=$?
        case $status in 0 | 2 | 4) ;; *) fail "$what: status $status" ;; esac
        untouched
    done
    rm -r "$work/linked"
done
mkdir "$work/linked" "$work/victims.d"
ln -s ../victims.d "$work/linked/workers"
run_hawser 2 study study.yaml -o linked --jobs 1 --quiet
[ -z "$(ls "$work/victims.d")" ] || fail "a study's workers wrote outside of its folder"
rm -r "$work/linked" "$work/rows"

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
# An empty path becomes the system's, whose browser ends at once when it may open no more than 32 files.
for path in "" . ":" "here:."; do
    (ulimit -n 32 && cd "$work/here" && PATH=$path "$hawser" report ../good --pdf >/dev/null 2>&1)
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
