#!/bin/sh
# What a stranger types: `cmake -B b && cmake --build b -j2`, in a copy of the sources, with Make, without presets and Python.
# Usage: check_build.sh SOURCE_DIR COMPILER
set -eu
source_dir=$1 compiler=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
    echo "check_build: $*" >&2
    exit 1
}
# run LOG COMMAND...: the end of its output is shown only if it fails.
run() {
    log=$work/$1
    shift
    "$@" >"$log" 2>&1 || { tail -n 40 "$log" >&2; fail "failed: $*"; }
}

# The library and the program need these and nothing else of the tree.
(cd "$source_dir" && tar cf - CMakeLists.txt LICENSE NOTICE CHANGELOG.md cmake include core def survey contact linsolve theory sim validate io study fmi mpi \
    cli web/dist cases/capstan.yaml) | (cd "$work" && tar xf -)
unset CMAKE_GENERATOR CMAKE_BUILD_TYPE CMAKE_C_COMPILER_LAUNCHER
cd "$work"
run configure.log cmake -B b -G "Unix Makefiles" -DCMAKE_C_COMPILER="$compiler" -DHAWSER_TESTS=OFF -DHAWSER_PYTHON=OFF \
    -DCMAKE_DISABLE_FIND_PACKAGE_Python3=ON -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
grep -q '^CMAKE_BUILD_TYPE:STRING=Release$' b/CMakeCache.txt || fail "the build type is not Release when none is asked for"
run build.log cmake --build b -j2
[ -f b/libhawser.so ] && [ -f b/libhawser.a ] || fail "the libraries were not built"
run run.log b/cli/hawser run -q -o results cases/capstan.yaml
[ -s results/series.csv ] || fail "the program computes nothing"
echo "check_build: fine"
