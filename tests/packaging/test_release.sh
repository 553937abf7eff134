#!/bin/sh
# A release: made by the script, with sums that hold and one version in every part; refused where a part has another one, or is missing.
# Usage: test_release.sh SOURCE_DIR FOLDER       FOLDER: gets the release; tests of Debian's packages take them from there
set -eu
for needs in dh lintian git; do
    command -v $needs >/dev/null 2>&1 || {
        echo "skipped: no $needs (sh scripts/setup.sh --deb)"
        exit 77
    }
done
source_dir=$1 folder=$2
rm -rf "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    echo "test_release: $*" >&2
    exit 1
}
git clone -q "$source_dir" "$work/clone"
release="sh $work/clone/scripts/release.sh"

# refused WHY PATTERN...: no release, and each pattern in what is said.
refused() {
    why=$1
    shift
    if $release "$work/none" >"$work/said" 2>&1; then fail "made a release $why"; fi
    [ ! -e "$work/none" ] || fail "left something behind $why"
    for pattern in "$@"; do grep -q "$pattern" "$work/said" || { cat "$work/said"; fail "did not name '$pattern' $why"; }; done
}
echo >>"$work/clone/README.md"
refused "of a tree with changes" "commit them first"
sed -i 's/^project(hawser VERSION [0-9.]*/project(hawser VERSION 9.8.7/' "$work/clone/CMakeLists.txt"
git -C "$work/clone" -c user.name=test -c user.email=test@localhost commit -qam "cmake: another version"
refused "whose version is only CMake's" "CMakeLists.txt: 9.8.7$" "status.h: .*, not 9.8.7" "CHANGELOG.md: .*, not 9.8.7" "debian/changelog: .*, not 9.8.7" \
    "engine: .*, not 9.8.7"

git -C "$work/clone" reset -q --hard HEAD~1
$release "$folder"
(cd "$folder" && sha256sum --quiet -c SHA256SUMS)
[ "$(wc -l <"$folder/SHA256SUMS")" = "$(find "$folder" -type f ! -name SHA256SUMS | wc -l)" ] || fail "files without a sum"
if $release "$folder" >"$work/said" 2>&1; then fail "wrote over a release"; fi

# Each part is looked into: asked for another version, all of them are wrong. (25 lines today)
versions="/usr/bin/env python3 -B $work/clone/packaging/versions.py"
if $versions 9.8.7 "$folder" >"$work/said"; then fail "took a release of another version"; fi
! grep -v ", not 9.8.7$" "$work/said" || fail "parts that are not looked into"
[ "$(wc -l <"$work/said")" -ge 20 ] || fail "only $(wc -l <"$work/said") parts"
for part in hawser-desk-*.html deb/python3-hawser_*.deb python/*.whl; do
    cp -R "$folder" "$work/copy"
    rm "$work"/copy/$part
    if $versions "$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' "$work/clone/CMakeLists.txt")" "$work/copy" >"$work/said"; then fail "$part is not missed"; fi
    rm -r "$work/copy"
done
