#!/bin/sh
# Makes a release of the last commit in one folder: source archive, desk page, Debian's packages, Python's wheel and source archive, SHA256SUMS.
# Usage: sh scripts/release.sh [FOLDER]      (default: build/hawser-VERSION; it must not be there yet or be empty)
# Nothing is left in FOLDER if a part was not built, lintian complains, or a part has another version than CMakeLists.txt (packaging/versions.py).
# Needs what `scripts/setup.sh --deb` and `--python` install.
set -eu
export LC_ALL=C
tree=$(cd "$(dirname "$0")/.." && pwd)
version=$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' "$tree/CMakeLists.txt")
folder=${1:-$tree/build/hawser-$version}

fail() {
    echo "release.sh: $*" >&2
    exit 1
}
[ -z "$(git -C "$tree" status --porcelain)" ] || fail "the work tree has changes that a release of the last commit would not have; commit them first"
[ ! -e "$folder" ] || [ -z "$(ls -A "$folder")" ] || fail "$folder is not empty"
sh "$tree/scripts/setup.sh" --python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# step NAME COMMAND...: its output is shown only if it fails.
step() {
    echo "$1"
    shift
    "$@" >"$work/log" 2>&1 || {
        tail -n 40 "$work/log" >&2
        fail "'$*' failed"
    }
}
python=/usr/bin/python3 # Debian's, which has Debian's cffi and setuptools
[ -x $python ] || python=python3
git clone -q "$tree" "$work/clone"
mkdir -p "$work/release/deb" "$work/release/python" "$work/wheel"
step "source archive" sh "$work/clone/packaging/dist.sh" "$work/release"
step "desk page" cp "$work/clone/web/dist/desk.html" "$work/release/hawser-desk-$version.html"
step "their versions" $python -B "$work/clone/packaging/versions.py" "$version" "$work/release" source desk
step "Debian packages, lintian" sh "$work/clone/packaging/deb.sh" "$work/deb"
cp "$work/deb"/*.deb "$work/deb"/*.dsc "$work/deb"/*.tar.* "$work/release/deb"
step "Python source archive" env PYTHONPATH="$work/clone/python" $python -B -c 'import backend, sys; backend.build_sdist(sys.argv[1])' "$work/release/python"
tar -C "$work/wheel" -xzf "$work/release/python/hawser-$version.tar.gz"
step "Python wheel, from it" $python -m pip --disable-pip-version-check wheel --no-index --no-deps --no-build-isolation -w "$work/release/python" \
    "$work/wheel/hawser-$version"
step "all versions" $python -B "$work/clone/packaging/versions.py" "$version" "$work/release"
(cd "$work/release" && find . -type f | sort | sed 's|^\./||' | xargs sha256sum) >"$work/sums"
mv "$work/sums" "$work/release/SHA256SUMS"
mkdir -p "$folder"
cp -R "$work/release/." "$folder"
echo "Release $version: $folder"
