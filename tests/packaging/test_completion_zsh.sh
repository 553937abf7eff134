#!/bin/sh
# zsh takes the completion as a function, and its arguments are as _arguments wants them. Usage: test_completion_zsh.sh COMPLETION
set -eu
command -v zsh >/dev/null 2>&1 || {
    echo "skipped: there is no zsh"
    exit 77
}
zsh -n "$1"
for command in $(sed -n "s/^    \([a-z]*\))$/\1/p" "$1"); do
    zsh -f -c '
        _describe() { print -l -- ${(P)2} }
        _arguments() { print -l -- "$@" }
        CURRENT=3 words=(hawser '"$command"' "")
        _it() { source '"$1"' }
        _it' >"${TMPDIR:-/tmp}/zsh_$$" || exit 1
    grep -q '^--help\[' "${TMPDIR:-/tmp}/zsh_$$" || {
        echo "$command offers no --help"
        exit 1
    }
    # NAME[TEXT] or NAME[TEXT]:WHAT:ACTION
    if grep -Ev '^(\*:[^:]*:.*|-{1,2}[a-z-]+[a-zA-Z]?\[.*\](:[^:]*:.*)?|-V\[.*\])$' "${TMPDIR:-/tmp}/zsh_$$"; then
        echo "that is not how $command's arguments are written"
        exit 1
    fi
    rm -f "${TMPDIR:-/tmp}/zsh_$$"
done
