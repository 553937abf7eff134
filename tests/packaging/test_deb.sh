#!/bin/sh
# Debian's packages are built, lintian has nothing to say, and what they hold works.
# Usage: test_deb.sh SOURCE_DIR [DEBS]     (DEBS: a folder with the packages; default: they are built)
set -eu
command -v dh >/dev/null 2>&1 && command -v lintian >/dev/null 2>&1 || {
    echo "skipped: debhelper and lintian are not installed (sh scripts/setup.sh --deb)"
    exit 77
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
debs=${2-}
if [ -z "$debs" ]; then
    debs=$work/deb
    git clone -q "$1" "$work/clone"
    sh "$work/clone/packaging/deb.sh" "$debs"
fi
for package in "$debs"/*.deb; do dpkg-deb -x "$package" "$work/root"; done
lib=$(dirname "$(find "$work/root" -name 'libhawser.so.*' -type f)")
cat >"$work/hawser" <<EOF
#!/bin/sh
exec env LD_LIBRARY_PATH="$lib" "$work/root/usr/bin/hawser" "\$@"
EOF
chmod +x "$work/hawser"
sed "s|/usr/share|$work/root/usr/share|g" "$1/packaging/debian/tests/program" >"$work/program"
mkdir "$work/tried"
PATH="$work:$PATH" AUTOPKGTEST_TMP="$work/tried" sh "$work/program"
[ -s "$work/root/usr/share/man/man1/hawser.1.gz" ]
