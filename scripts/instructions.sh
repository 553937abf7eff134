#!/bin/sh
# Counts the instructions of the hot phases (bench/phases.c) under valgrind and compares them with the reference of this
# compiler and instruction set in bench/instructions: more than 3 % more in any phase is a failure. Counts, unlike
# times, do not depend on what else the machine does.
# Usage: sh scripts/instructions.sh [--update] [--program FILE] [--counts FILE] [--references DIR]
#   --update          writes the reference instead of comparing: after a change that is meant to cost or to save
#   --program FILE    a bench_phases that is built already (default: builds the bench preset's)
#   --counts FILE     compares these counts instead of measuring
#   --references DIR  where the references are (default: bench/instructions)
# Status: 0 fine, or skipped (no reference for this target, or no valgrind that runs it); 1 a phase has grown;
# 2 it could not be measured.
set -eu
export LC_ALL=C

margin=3 # %
calls=10 # of each phase that are counted
root=$(cd "$(dirname "$0")/.." && pwd)
update=no program='' counts='' references=$root/bench/instructions
fail() {
    echo "instructions.sh: $*" >&2
    exit 2
}
while [ $# -gt 0 ]; do
    case $1 in
    --update) update=yes ;;
    --program | --counts | --references)
        [ $# -ge 2 ] || fail "$1 needs a value"
        case $1 in
        --program) program=$2 ;;
        --counts) counts=$2 ;;
        --references) references=$2 ;;
        esac
        shift
        ;;
    *) fail "unknown option '$1'" ;;
    esac
    shift
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# measure: writes "target NAME" and a line "PHASE INSTRUCTIONS" for each phase to $counts. bench_phases calls bench_mark
# before and after each phase; callgrind writes its counters, and starts again from zero, whenever that happens. So the
# dumps of even number hold the phases, in the order in which the program names them.
measure() {
    counts=$work/counts
    valgrind --quiet --tool=callgrind --dump-before=bench_mark --callgrind-out-file="$work/dump" \
        "$program" all $calls >"$work/phases" 2>"$work/log" || {
        target=$(sed -n 's/^target //p' "$work/phases")
        if grep -q 'Illegal opcode' "$work/log" && [ ! -f "$references/$target.txt" ]; then
            echo "skipped: $(valgrind --version) does not know all instructions of $target"
            exit 0
        fi
        cat "$work/log" >&2
        fail "$program did not run under valgrind"
    }
    sed -n 1p "$work/phases" >"$counts"
    sed 1d "$work/phases" | {
        part=2
        while read -r phase _; do
            total=$(sed -n 's/^totals: //p' "$work/dump.$part") || fail "valgrind wrote no counters for $phase"
            echo "$phase $((total / calls))"
            part=$((part + 2))
        done
    } >>"$counts"
}

# write_reference FILE: the counts, under a note on where they come from.
write_reference() {
    mkdir -p "$references"
    {
        echo "# Instructions a call of each phase of bench/phases.c: 370 segments, 98 rollers, one thread."
        echo "# Written by scripts/instructions.sh --update with $(valgrind --version), $(getconf GNU_LIBC_VERSION)."
        cat "$counts"
    } >"$1"
}

# compare FILE: prints the table, fails if a phase has grown by more than the margin or has gone.
compare() {
    awk -v margin="$margin" '
        BEGIN { printf "| phase | reference | now | change |\n|---|---|---|---|\n" }
        /^#/ || $1 == "target" { next }
        FILENAME == ARGV[1] { reference[$1] = $2; next }
        { now[$1] = 1 }
        !($1 in reference) { printf "| %s | - | %d | new |\n", $1, $2; next }
        {
            change = 100 * ($2 / reference[$1] - 1)
            note = ""
            if (100 * $2 > (100 + margin) * reference[$1]) { note = ", grown"; grown = grown " " $1 }
            if (100 * $2 < (100 - margin) * reference[$1]) { note = ", less"; less = less " " $1 }
            printf "| %s | %d | %d | %+.2f %%%s |\n", $1, reference[$1], $2, change, note
        }
        END {
            for (phase in reference) if (!(phase in now)) gone = gone " " phase
            if (less) printf "less than before, --update keeps it so:%s\n", less
            if (gone) printf "no longer measured:%s\n", gone
            if (grown) printf "grown by more than %g %%:%s\n", margin, grown
            exit (grown || gone) ? 1 : 0
        }' "$1" "$counts"
}

if [ -z "$counts" ]; then
    if ! command -v valgrind >/dev/null 2>&1; then
        echo "skipped: valgrind is not installed"
        exit 0
    fi
    if [ -z "$program" ]; then
        sh "$root/scripts/build.sh" bench bench_phases
        program=$root/build/bench/bench/bench_phases
    fi
    measure
fi
target=$(sed -n 's/^target //p' "$counts")
[ -n "$target" ] || fail "$counts does not say for which target it is"
reference=$references/$target.txt
echo "Instructions a call, $target"
if [ "$update" = yes ]; then
    write_reference "$reference"
    cat "$reference"
elif [ ! -f "$reference" ]; then
    echo "skipped: no reference for $target; sh scripts/instructions.sh --update makes one"
else
    compare "$reference"
fi
