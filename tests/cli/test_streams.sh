# Standard input and output as `-`, formats, --quiet, the nearest word, progress over passes: what scripts rely on.
hawser=$1 source=$2
. "$source/tests/cli/common.sh"
cp "$source/cases/capstan.yaml" "$source/tests/data/passing-guides.yaml" "$source/cases/routes/tunnel.csv" "$source/docs/tutorial/duct.yaml" "$work"
mkdir "$work/sub"
commands=$("$hawser" --help | sed -n 's/^  \([a-z]*\) .*/\1/p')
[ "$(echo "$commands" | wc -l)" -ge 16 ] || fail "the usage lists too few commands: $commands"

# piped FILE STATUS ARGUMENTS...: the program with the file behind a pipe.
piped() {
    from=$1 expected=$2
    shift 2
    what="cat $from | hawser $*"
    (cd "$work" && cat "$from" | "$hawser" "$@" >"$work/out" 2>"$work/err")
    status=$?
    [ "$status" = "$expected" ] || fail "$what: exit status $status, not $expected: $(cat "$work/err")"
}

# A help was up to 161 columns wide (report), which a terminal of 80 breaks within words.
for command in "" $commands; do
    run_hawser 0 $command --help
    wide=$(awk 'length > 80' "$work/out")
    [ -z "$wide" ] || fail "$what: wider than 80 columns: $wide"
    [ -z "$command" ] || says out "-q, --quiet"
done

# `-` was the name of a file: "-: cannot be opened: No such file or directory".
run_hawser 0 theory capstan.yaml --format json
cp "$work/out" "$work/by_name"
piped capstan.yaml 0 theory - --format json
cmp -s "$work/out" "$work/by_name" || fail "$what: another answer than by name"
for command in check theory place; do
    piped duct.yaml 0 $command -
done
piped capstan.yaml 0 run - -q
exists results/stdin/summary.json
# what such a text names is in the current folder
(cd "$source/cases/jobs" && "$hawser" job ducts.yaml --format json >"$work/by_name" && cat ducts.yaml | "$hawser" job - --format json >"$work/out") ||
    fail "a job from standard input: it failed"
cmp -s "$work/out" "$work/by_name" || fail "a job from standard input: another answer than by name"
piped tunnel.csv 0 route - --format json
says out '"length_m"'
piped tunnel.csv 0 route - -o -
says out "route:"
sed 's/^format:.*//' "$work/capstan.yaml" >"$work/old.yaml"
piped old.yaml 0 upgrade -
cp "$work/out" "$work/new.yaml"
run_hawser 0 upgrade new.yaml -o -
cmp -s "$work/out" "$work/new.yaml" || fail "$what: the text changed"
run_hawser 0 theory capstan.yaml --crew -
says out "number,kind,name,"
run_hawser 0 theory capstan.yaml --report -o -
says out "<!doctype html>"
[ "$(head -c 9 "$work/out")" = "<!doctype" ] || fail "$what: something stands before the page"
missing - -.html
piped capstan.yaml 2 study -
says err "standard input cannot be used"
run_hawser 2 theory - # from /dev/null
says err "/dev/stdin:1: nothing is in it"
for command in run fmu; do
    run_hawser 2 $command capstan.yaml -o -
    says err "is not written to standard output"
done

# --quiet was refused by nine commands, --format json by compare; the summary of --strict omitted SAFE ONLY IF.
for words in "check capstan.yaml" "theory capstan.yaml" "place duct.yaml" "library cables" "route tunnel.csv" "validate --fast --filter catenary"; do
    run_hawser 0 $words -q
    silent out
    silent err
    run_hawser 0 $words -q --format json
    [ -s "$work/out" ] || fail "$what: nothing is printed"
done
run_hawser 0 run --help
says out "SAFE ONLY IF"

# A wrong value of an option had no nearest word.
run_hawser 2 check capstan.yaml --format jsno
says err "did you mean 'json'?"
run_hawser 2 run capstan.yaml --tables limts
says err "did you mean 'limits'?"
run_hawser 2 theory capstan.yaml --tables limts
says err "did you mean 'limits'?"
run_hawser 2 library cabels
says err "did you mean 'cables'?"
run_hawser 2 check capstan.yaml --set solver.linear_solver=blok
says err "did you mean 'block'?"
run_hawser 2 check capstan.yaml --set solver.linear_solvre=block
says err "did you mean 'linear_solver'?"
run_hawser 2 compare a b --align lenght
says err "did you mean 'length'?"

# A second pass went from 0 to 100 % again; it is the last three quarters of both.
run_hawser 0 run passing-guides.yaml
says err "100 %, " "second pass, finer: " "100 % of both passes"
finish
