#!/bin/sh
# The source archive of the last commit, the same bits wherever and whenever it is made.
# Usage: sh packaging/dist.sh [FOLDER]        (default: build/dist) - writes hawser-VERSION.tar.gz and prints its path
set -eu
export LC_ALL=C TZ=UTC
folder=${1:-$(dirname "$0")/../build/dist}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$(dirname "$0")/.."

version=$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
archive=$folder/hawser-$version.tar.gz
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git archive --format=tar --prefix="hawser-$version/" -o "$work/archive.tar" HEAD
gzip -9n "$work/archive.tar"
mv "$work/archive.tar.gz" "$archive"
echo "$archive"
