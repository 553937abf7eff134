# What the tests of the program share. Usage: hawser=PROGRAM source=SOURCE_DIR; . common.sh
# Every check_* prints what it expected when it fails and goes on; `finish` at the end sets the exit status.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

fail() {
    echo "FAILED: $*" >&2
    failures=$((failures + 1))
}

# run_hawser STATUS ARGUMENTS...: runs the program; its output is in $work/out and $work/err afterwards.
run_hawser() {
    expected=$1
    shift
    what="hawser $*"
    (cd "$work" && "$hawser" "$@" >"$work/out" 2>"$work/err" </dev/null)
    status=$?
    if [ "$status" != "$expected" ]; then
        fail "$what: exit status $status, not $expected"
        sed 's/^/    /' "$work/err" >&2
    fi
}

# says FILE TEXT...: the file (out or err) holds every text.
says() {
    file=$1
    shift
    # sentences of an answer go on in lines that are indented
    awk '{ sub(/^ +/, " "); printf "%s", $0 }' "$work/$file" >"$work/flowed"
    for text in "$@"; do
        grep -qF -- "$text" "$work/$file" "$work/flowed" || {
            fail "$what: '$text' is not in its $file:"
            sed 's/^/    /' "$work/$file" >&2
        }
    done
}

# silent FILE: the file is empty.
silent() {
    [ ! -s "$work/$1" ] || {
        fail "$what: its $1 is not empty:"
        sed 's/^/    /' "$work/$1" >&2
    }
}

exists() {
    for path in "$@"; do [ -e "$work/$path" ] || fail "$what: $path is missing"; done
}

missing() {
    for path in "$@"; do [ ! -e "$work/$path" ] || fail "$what: $path was made"; done
}

# wait_until CONDITION: until this shell command succeeds. There is a limit only so that nothing waits for ever.
wait_until() {
    tries=0
    until eval "$1" 2>/dev/null; do
        sleep 0.05
        tries=$((tries + 1))
        [ $tries -lt 30000 ] || { fail "$what: never: $1"; break; }
    done
}

finish() {
    [ "$failures" = 0 ] || exit 1
    echo "fine"
}

cp "$source/tests/data/cli-pull.yaml" "$work/pull.yaml"
