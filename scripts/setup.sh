#!/bin/sh
# Installs the Debian packages that building, running and testing hawser needs and that are not there yet.
# Usage: sh scripts/setup.sh [--lint | --bench | --fuzz | --mutants | --coverage | --web | --wasm | --deb | --python | --clusters | --site]
#   --lint      also what scripts/lint.sh needs
#   --fuzz      also what scripts/fuzz.sh needs
#   --mutants   also what scripts/mutants.py needs
#   --coverage  also what scripts/coverage.sh needs
#   --web       also what scripts/web.sh and the tests of the report's page need: Node, Chromium, and npm's packages in
#               web/node_modules; goes on without them where they are not to be had
#   --wasm      also what scripts/wasm.sh needs
#   --deb       also what packaging/deb.sh and the test of its packages in a chroot need
#   --python    also what the Python package, its tests and its notebooks need; goes on without what is not to be had
#   --clusters  also what `hawser study --mpi` is built with, and OpenMPI and Slurm for the tests of studies
#   --site      also what scripts/site.sh needs, and what --python does
#   --bench     also the programs that scripts/bench.sh compares with; goes on without them where they are not to be had
# Says nothing and calls no apt-get when everything is there. Needs root or sudo only when something is missing.
set -eu

packages="build-essential cmake ninja-build pkg-config clang-format
    libsundials-dev libsuitesparse-dev libmetis-dev libyaml-dev libexpat1-dev libjansson-dev libhdf5-dev zlib1g-dev libzip-dev libshp-dev
    libmeshoptimizer-dev libnlopt-dev libcmocka-dev liblapacke-dev python3 valgrind cmark-gfm abigail-tools"
lint_packages="clang clang-tidy"
fuzz_packages="clang libclang-rt-dev afl++"
mutants_packages="python3-clang-14"
coverage_packages="gcovr"
python_packages="python3-dev python3-cffi python3-setuptools python3-wheel python3-pip python3-numpy python3-pandas python3-h5py
    python3-xarray python3-netcdf4 python3-jsonschema python3-yaml python3-pytest python3-matplotlib python3-nbclient python3-nbformat python3-ipykernel mypy"
site_packages="doxygen python3-sphinx python3-myst-parser python3-breathe"
cluster_packages="libopenmpi-dev openmpi-bin slurmctld slurmd slurm-client"
wasm_packages="emscripten dpkg-dev"
deb_packages="autopkgtest debhelper dh-python lintian fakeroot mmdebstrap python3-cffi python3-dev python3-setuptools"
peer_packages="libmujoco-dev libsimbody-dev"

peers=no
web=no
python=no
case "${1-}" in
"") ;;
--lint) packages="$packages $lint_packages" ;;
--fuzz) packages="$packages $fuzz_packages" ;;
--mutants) packages="$packages $mutants_packages" ;;
--coverage) packages="$packages $coverage_packages" ;;
--wasm) packages="$packages $wasm_packages" ;;
--deb) packages="$packages $deb_packages" ;;
--clusters) packages="$packages $cluster_packages" ;;
--site) packages="$packages $python_packages $site_packages" ;;
--bench) peers=yes ;;
--web) web=yes ;;
--python) python=yes ;;
*)
    echo "setup.sh: unknown option '$1' (only --lint, --bench, --fuzz, --mutants, --coverage, --web, --wasm, --deb, --python, --clusters, --site)" >&2
    exit 2
    ;;
esac

# Prints those of the given packages that are not installed; build-essential and the like count as packages here.
list_missing() {
    for package in "$@"; do
        case "$(dpkg-query -W -f='${Status}\n' "$package" 2>/dev/null || true)" in
        *"install ok installed"*) ;;
        *) printf '%s ' "$package" ;;
        esac
    done
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        env DEBIAN_FRONTEND=noninteractive "$@"
    elif command -v sudo >/dev/null 2>&1; then
        sudo env DEBIAN_FRONTEND=noninteractive "$@"
    else
        echo "setup.sh: these Debian packages are missing: $missing" >&2
        echo "setup.sh: install them as root (there is no sudo here): apt-get install $missing" >&2
        exit 1
    fi
}

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "setup.sh: this is not a Debian system; see that it has what these packages offer:" $packages >&2
    exit 0
fi
# install PACKAGE...: those that are missing.
install() {
    missing=$(list_missing "$@")
    [ -n "$missing" ] || return 0
    echo "setup.sh: installing $missing"
    as_root apt-get update -q
    # shellcheck disable=SC2086 # one word a package
    as_root apt-get install -q -y --no-install-recommends $missing
}

# shellcheck disable=SC2086 # one word a package
install $packages
if [ $peers = yes ]; then
    # shellcheck disable=SC2086
    (install $peer_packages) || echo "setup.sh: without $peer_packages: the comparison with them will be skipped" >&2
fi
if [ $web = yes ]; then
    # Node may be there from elsewhere than Debian, with an npm of its own.
    set -- chromium
    command -v node >/dev/null 2>&1 || set -- "$@" nodejs
    command -v npm >/dev/null 2>&1 || set -- "$@" npm
    (install "$@" && sh "$(dirname "$0")/web.sh" --packages) ||
        echo "setup.sh: without $* and the packages of web/: the tests of the report's page will be skipped" >&2
fi
if [ $python = yes ]; then
    # shellcheck disable=SC2086
    (install $python_packages) ||
        echo "setup.sh: without all of $python_packages: the Python package or some of its tests will be left out" >&2
fi
