#!/bin/sh
# Every C file is as clang-format would write it.     Usage: check_format.sh ROOT
set -eu
cd "$1"
find include core contact linsolve sim theory io cli tests bench -name '*.[ch]' -print0 |
    xargs -0 clang-format --dry-run -Werror
