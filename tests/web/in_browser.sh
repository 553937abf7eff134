#!/bin/sh
# Runs a command that needs Node, the packages of web/ and Chromium; status 77 (skipped) and what is missing where they are not there.
# Usage: in_browser.sh COMMAND...     (from the project's root)
set -eu
missing=
command -v node >/dev/null 2>&1 || missing="$missing node"
[ -d web/node_modules/playwright-core ] || missing="$missing web/node_modules"
[ -x /usr/bin/chromium ] || [ -x /usr/bin/chromium-browser ] || missing="$missing chromium"
if [ -n "$missing" ]; then
    echo "skipped, because there is no$missing: sh scripts/setup.sh --web"
    exit 77
fi
exec "$@"
