#!/bin/sh
# Every C file is as clang-format would write it; names those that are not.     Usage: check_format.sh ROOT
set -eu
cd "$1"
complaints=$(find include core contact linsolve survey def theory sim validate io study mpi fmi cli tests bench -name '*.[ch]' -print0 |
    xargs -0 clang-format --dry-run 2>&1 | sed -n 's/^\([^ :]*\):[0-9:]* warning: code should be.*/\1/p' | sort | uniq -c)
[ -z "$complaints" ] && exit 0
echo "places that clang-format would change (sh scripts/lint.sh --fix):"
echo "$complaints"
exit 1
