#!/bin/sh
# Debian's source and binary packages of the last commit.
# Usage: sh packaging/deb.sh [FOLDER]        (default: build/deb)
# Needs debhelper, lintian and fakeroot (installed when missing and root). Ends with lintian's verdict: 1 if it complains.
set -eu
export LC_ALL=C
folder=${1:-$(dirname "$0")/../build/deb}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
here=$(cd "$(dirname "$0")" && pwd)

sh "$here/../scripts/setup.sh" --deb
rm -rf "${folder:?}"/*
archive=$(sh "$here/dist.sh" "$folder")
version=$(basename "$archive" .tar.gz)
version=${version#hawser-}
mv "$archive" "$folder/hawser_$version.orig.tar.gz"
tar -C "$folder" -xzf "$folder/hawser_$version.orig.tar.gz"
cp -R "$folder/hawser-$version/packaging/debian" "$folder/hawser-$version/debian"
(cd "$folder/hawser-$version" && dpkg-buildpackage -us -uc) >"$folder/build.log" 2>&1 || {
    tail -n 40 "$folder/build.log" >&2
    echo "deb.sh: the packages were not built; all of it is in $folder/build.log" >&2
    exit 1
}
ls "$folder"/*.deb "$folder"/*.dsc
# The project has no public address, and this is no upload to Debian.
private=bogus-mail-host,bogus-mail-host-in-debian-changelog,initial-upload-closes-no-bugs
lintian --allow-root --fail-on error,warning --suppress-tags "$private" "$folder"/*.changes
