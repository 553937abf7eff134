# What bash completes of a line of hawser's. Usage: bash test_completion.bash COMPLETION
set -u
compopt() { :; } # known only while a line is being completed
# shellcheck source=/dev/null
source "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
touch pull.yaml notes.txt
mkdir results
failures=0

# completes EXPECTED WORD...: the words up to the cursor; the last one is being completed.
completes() {
    local expected=$1
    shift
    COMP_WORDS=("$@")
    COMP_CWORD=$(($# - 1))
    _hawser
    local found
    found=$(printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ')
    [ "$found" = "$expected " ] && return
    echo "'$*' completes to '$found', not '$expected'"
    failures=$((failures + 1))
}
completes "report route run" hawser r
completes "--certify" hawser run --c
completes "--fast --filter --format" hawser validate --f
completes "csv json table" hawser theory --format ""
completes "si us" hawser run --units ""
completes "pull.yaml" hawser check pu
completes "results" hawser run -o re
completes "notes.txt pull.yaml results" hawser route ""
completes "reels rollers ropes" hawser library r
completes "study" hawser help st
exit $((failures > 0))
