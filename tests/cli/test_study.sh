# The command study: the examples, its answers and files, stops and goes on, what is refused.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"

run_hawser 0 study "$source/cases/studies/friction.yaml" -o friction
says out "Friction of the Huangjiahu tunnel" "P(NOT SAFE) is at least 4 % (3-5.4 % with 95 % confidence), limited by winch in 41" \
    "samples  1024 of 1024, by theory" "reference_total_N" "The estimate by the first samples"
says err "1024 of 1024 samples, 41 not safe, 0 without an answer"
exists friction/samples.csv friction/study.h5 friction/summary.json friction/workers/study
[ "$(wc -l <"$work/friction/samples.csv")" = 1025 ] || fail "samples.csv has not a row a sample"
grep -q '"not_safe_pct": 4.00390625' "$work/friction/summary.json" || fail "summary.json has not the probability"

# again: nothing is left to do, and nothing changes
cp "$work/friction/samples.csv" "$work/before"
run_hawser 0 study "$source/cases/studies/friction.yaml" -o friction --quiet
silent out
silent err
cmp -s "$work/before" "$work/friction/samples.csv" || fail "the second time the table is another"

# for a program: what summary.json holds, and nothing else
run_hawser 0 study "$source/cases/studies/friction.yaml" -o friction --format json
cmp -s "$work/out" "$work/friction/summary.json" || fail "--format json is not summary.json"
run_hawser 2 study "$source/cases/studies/friction.yaml" -o friction --format csv
says err "'table' or 'json' can be used"

# rows that cannot be read are not taken for rows that are not there
mkdir "$work/friction/workers/zz.rows"
run_hawser 4 study "$source/cases/studies/friction.yaml" -o friction --quiet
says err "zz.rows': not a file"
rmdir "$work/friction/workers/zz.rows"

run_hawser 0 study "$source/cases/studies/what-matters.yaml" -o matters --quiet --jobs 2
grep -q '"parameter": "friction"' "$work/matters/summary.json" || fail "no indices in summary.json"
run_hawser 0 study "$source/cases/studies/spacing.yaml" --units us
says out "2 of 4 variants are NOT SAFE, limited by roller_steady in 2" "count = 18" "count = 48" "lbf" "Results in results/spacing/"
exists results/spacing/samples.csv

# a measured pull: fitted, and laid beside a run
run_hawser 0 study "$source/cases/studies/calibrate.yaml" -o fitted
says out "FITTED: RMS" "friction.mu" "Results in fitted/"
exists fitted/study.html
run_hawser 0 run "$source/cases/huangjiahu.yaml" --quiet --set run.duration=25s --set output.states=0 -o pulled
run_hawser 0 compare pulled "$source/cases/studies/pull.csv" --page pulled.html --band 30%
says out "The run pulls" "Force from column 'winch pull [kN]'" "within 30 %"
exists pulled.html
run_hawser 0 compare pulled "$source/cases/studies/pull.csv" --align start --json
says out '"aligned_by": "start"'
run_hawser 2 compare pulled
says err "compare needs results or a case, and a log"
run_hawser 2 compare pulled "$source/cases/studies/pull.csv" --align end
says err "--align end: 'length' or 'start' can be used"
run_hawser 2 compare pulled "$source/cases/studies/friction.yaml"
says err "no row names a force and a time or a length"

# stopped by a signal: the rows so far are kept, and it goes on
sed "s|\.\./|$source/cases/|; s/samples: 1024/samples: 20000/" "$source/cases/studies/friction.yaml" >"$work/long.yaml"
what="hawser study, then SIGTERM"
(cd "$work" && exec "$hawser" study long.yaml -o long >out 2>err) &
pid=$!
wait_until '[ "$(cat "$work"/long/workers/*.rows | wc -c)" -ge 5000 ]'
kill -TERM $pid
wait $pid
[ $? = 130 ] || fail "$what: not 130"
says err "the same command continues"
says out "of 20000, by theory"

# what is wrong
run_hawser 2 study
says err "study needs a study file"
run_hawser 2 study long.yaml --jobs 0
says err "--jobs 0: must be a number of processes from 1 to 1024"
run_hawser 2 study pull.yaml
says err "pull.yaml:3: key 'cables': unknown key"
sed "s/friction.mu:/friction.my:/" "$work/long.yaml" >"$work/bad.yaml"
run_hawser 2 study bad.yaml -o bad
says err "bad.yaml:12: with every parameter in its middle the case is refused" "key 'friction.my': unknown key"
missing bad
sed "s/seed: 1/seed: 2/" "$work/long.yaml" >"$work/other.yaml"
run_hawser 2 study other.yaml -o long
says err "'long' holds the samples of another study" "--fresh"
# a Slurm in whose time the folder becomes another study's
mkdir "$work/slurm"
printf '#!/bin/sh\n[ ! -e asked ] || echo 1\n' >"$work/slurm/squeue"
printf '#!/bin/sh\necho 1 >asked\necho another >far/workers/study\necho 1\n' >"$work/slurm/sbatch"
chmod +x "$work/slurm/squeue" "$work/slurm/sbatch"
path=$PATH
PATH=$work/slurm:$path
run_hawser 2 study long.yaml -o far --slurm
says err "far' holds the samples of another study"
PATH=$path
run_hawser 4 study other.yaml -o pull.yaml/x
says err "cannot write"
finish
