#!/bin/sh
# The manual page is taken by groff without a warning, and has every command. Usage: test_manual.sh PAGE
set -eu
command -v groff >/dev/null 2>&1 || {
    echo "skipped: there is no groff"
    exit 77
}
warnings=$(groff -man -Tutf8 -ww "$1" 2>&1 >/dev/null)
[ -z "$warnings" ] || {
    echo "$warnings"
    exit 1
}
for command in run check theory validate library route report plot study; do
    groff -man -Tascii -P-cbou "$1" | grep -q "hawser $command" || {
        echo "nothing is said of $command"
        exit 1
    }
done
