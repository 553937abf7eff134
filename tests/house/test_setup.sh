#!/bin/sh
# scripts/setup.sh against a made-up package system: quiet when all is there, installs just what is missing, uses sudo
# when it is not root, and says what to do when it can do neither.          Usage: test_setup.sh ROOT
set -eu
root=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/bin"

fake() { # fake NAME: a command of that name from standard input
    { echo '#!/bin/sh'; cat; } >"$work/bin/$1"
    chmod +x "$work/bin/$1"
}
fake dpkg-query <<'EOF'
for package in "$@"; do :; done
case " $MISSING " in
*" $package "*) echo "no packages found" >&2; exit 1 ;;
*) echo "${STATUS:-install ok installed}" ;;
esac
EOF
fake apt-get <<'EOF'
echo "$DEBIAN_FRONTEND apt-get $*" >>"$CALLS"
exit "${APT_EXIT:-0}"
EOF
fake npm <<'EOF'
echo "npm $*" >>"$CALLS"
exit 1
EOF
fake sudo <<'EOF'
echo sudo >>"$CALLS"
exec "$@"
EOF
fake id <<'EOF'
echo "$USER_ID"
EOF

CALLS=$work/calls MISSING="" USER_ID=0
export CALLS MISSING USER_ID
setup() {
    : >"$CALLS"
    PATH=$work/bin:$PATH sh "$root/scripts/setup.sh" "$@" >"$work/out" 2>&1
}
fail() {
    echo "test_setup: $*" >&2
    cat "$work/out" "$CALLS" >&2
    exit 1
}

setup || fail "failed with everything installed"
[ ! -s "$work/out" ] && [ ! -s "$CALLS" ] || fail "was not quiet with everything installed"

MISSING="ninja-build libmetis-dev"
setup || fail "failed to install"
printf '%s\n' "noninteractive apt-get update -q" \
    "noninteractive apt-get install -q -y --no-install-recommends ninja-build libmetis-dev" >"$work/expected"
cmp -s "$CALLS" "$work/expected" || fail "did not install just what is missing"

USER_ID=1000
setup || fail "failed as a user with sudo"
[ "$(grep -c '^sudo$' "$CALLS")" = 2 ] || fail "did not go through sudo"
USER_ID=0

MISSING="clang-tidy"
setup && [ ! -s "$CALLS" ] || fail "clang-tidy is for linting only"
setup --lint && [ -s "$CALLS" ] || fail "--lint did not install clang-tidy"

MISSING="libsimbody-dev"
setup && [ ! -s "$CALLS" ] || fail "the programs to compare with are for the benchmarks only"
setup --bench && [ -s "$CALLS" ] || fail "--bench did not install libsimbody-dev"
APT_EXIT=100
export APT_EXIT
setup --bench || fail "the benchmarks need no programs to compare with"
grep -q "will be skipped" "$work/out" || fail "did not say what is missing"
unset APT_EXIT

MISSING="chromium"
setup && [ ! -s "$CALLS" ] || fail "Chromium is for the tests of the report's page only"
setup --web && grep -q "apt-get install .*chromium" "$CALLS" || fail "--web did not install chromium"
APT_EXIT=100
export APT_EXIT
setup --web || fail "the other tests need no Chromium"
grep -q "will be skipped" "$work/out" || fail "did not say that the page's tests are skipped"
unset APT_EXIT

MISSING="python3-cffi"
setup && [ ! -s "$CALLS" ] || fail "Python's packages are for the Python package only"
setup --python && grep -q "apt-get install .*python3-cffi" "$CALLS" || fail "--python did not install python3-cffi"
APT_EXIT=100
export APT_EXIT
setup --python || fail "everything else needs no Python packages"
grep -q "will be left out" "$work/out" || fail "did not say what is left out"
unset APT_EXIT

# A package that was removed but left its configuration is not installed.
MISSING="" STATUS="deinstall ok config-files"
export STATUS
setup && [ -s "$CALLS" ] || fail "took a removed package for an installed one"
unset STATUS

MISSING=cmake APT_EXIT=100
export APT_EXIT
! setup || fail "ignored that apt-get failed"
unset APT_EXIT
! setup --bogus || fail "took an unknown option"

# No sudo and not root: a clear message, nothing run. The path holds only what the script needs.
rm "$work/bin/sudo"
for tool in sh env cat; do ln -s "$(command -v "$tool")" "$work/bin/$tool"; done
: >"$CALLS"
USER_ID=1000
! PATH=$work/bin sh "$root/scripts/setup.sh" >"$work/out" 2>&1 || fail "went on without being able to install"
grep -q "apt-get install cmake" "$work/out" || fail "did not say what to install"
echo "setup: fine"
