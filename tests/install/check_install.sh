#!/bin/sh
# Installs a build into a temporary prefix and uses it from outside the tree.
# Usage: check_install.sh SOURCE_DIR BUILD_DIR
set -eu
source_dir=$1 build_dir=$2
here=$source_dir/tests/install/consumer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

fail() {
    echo "check_install: $*" >&2
    exit 1
}
# run LOG COMMAND...: its output is shown only if it fails.
run() {
    log=$work/$1
    shift
    "$@" >"$log" 2>&1 || { cat "$log" >&2; fail "failed: $*"; }
}

# The tree is moved after the installation: neither package may remember where it was.
run install.log cmake --install "$build_dir" --prefix "$work/first"
mv "$work/first" "$prefix"
lib=$(dirname "$(find "$prefix" -name libhawser.a)")
version=$(sed -n 's/^project(hawser VERSION \([0-9.]*\).*/\1/p' "$source_dir/CMakeLists.txt")
for file in "$prefix/bin/hawser" "$prefix/include/hawser/hawser.h" "$prefix/include/hawser/tables.h" "$prefix/include/hawser/numerics.h" "$lib/libhawser.so" "$lib/pkgconfig/hawser.pc" \
    "$lib/cmake/hawser/hawserConfig.cmake" "$prefix/share/doc/hawser/LICENSE" "$prefix/share/doc/hawser/CHANGELOG.md" "$prefix/share/hawser/library/cables-by-makers.yaml" \
    "$prefix/include/hawser/library.h" "$prefix/include/hawser/report.h" \
    "$prefix/include/hawser/route.h"; do
    [ -e "$file" ] || fail "not installed: $file"
done
# The catalogue is found from the program's own place, whatever the folder is called.
(cd / && env -u HAWSER_LIBRARY "$prefix/bin/hawser" library ducts pe-160-sdr17 | grep -q "MS 1058") || fail "the installed program does not find its catalogue"
"$prefix/bin/hawser" --version | grep -qF "$version" || fail "hawser --version is not $version"

grep -q "^## $version" "$prefix/share/doc/hawser/CHANGELOG.md" || fail "CHANGELOG.md does not speak of $version"
# NOTICE names every library of others that the static library needs.
sed -n 's/^Requires.private: //p; s/^Libs.private: //p' "$lib/pkgconfig/hawser.pc" | tr ' ' '\n' | sed 's/^-l/lib/' |
    grep -v -x -e libm -e libpthread -e libdl -e '' | while read -r library; do
    grep -qw -e "$library" "$prefix/share/doc/hawser/NOTICE" || fail "NOTICE does not name $library"
done

# The shared library: its soname carries the major version, below 1.0 the minor one too; it exports what the header declares and nothing else.
so=${version%%.*}
[ "$so" -gt 0 ] || so=${version%.*}
readelf -d "$lib/libhawser.so" | grep -qF "Library soname: [libhawser.so.${so}]" || fail "wrong soname"
cc -E -P -I "$prefix/include" "$prefix/include/hawser/hawser.h" | grep -o 'hawser_[a-z0-9_]* *(' | tr -d ' (' | sort -u >"$work/declared"
nm -D --defined-only "$lib/libhawser.so" | awk '{print $NF}' | sort -u >"$work/exported"
diff "$work/declared" "$work/exported" >"$work/symbols" || { cat "$work/symbols"; fail "exports (>) differ from header (<)"; }

# The static library keeps its internals to itself too.
nm -g --defined-only "$lib/libhawser.a" 2>/dev/null | awk 'NF == 3 {print $3}' | sort -u >"$work/static"
diff "$work/declared" "$work/static" >"$work/symbols" || { cat "$work/symbols"; fail "libhawser.a's symbols (>) differ"; }

# The header alone, as strict C and as C++.
echo '#include <hawser/hawser.h>' >"$work/header.c"
cp "$work/header.c" "$work/header.cc"
run c.log cc -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/header.c"
run cxx.log c++ -std=c++98 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/header.cc"

run c11.log cc -std=c11 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/header.c"
run cxx17.log c++ -std=c++17 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/header.cc"

# And each of the others by itself: checkpoint.h, certify.h, library.h, report.h and sweep.h named types of headers that they did not include.
for header in "$prefix"/include/hawser/*.h; do
    echo "#include <hawser/${header##*/}>" >"$work/alone.c"
    cp "$work/alone.c" "$work/alone.cc"
    run alone_c.log cc -std=c99 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/alone.c"
    run alone_cxx.log c++ -std=c++98 -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$prefix/include" "$work/alone.cc"
done

# pkg-config, shared and then, with the shared library out of the way, static.
PKG_CONFIG_PATH=$lib/pkgconfig
export PKG_CONFIG_PATH
# shellcheck disable=SC2046 # one word a flag
compile() { # compile PROGRAM [--static]
    cc "$here/consumer.c" -o "$1" $(pkg-config ${2-} --cflags --libs hawser)
}
run pc.log compile "$work/pc_shared"
[ "$(LD_LIBRARY_PATH=$lib "$work/pc_shared")" = "$version" ] || fail "the pkg-config consumer does not work"
mkdir "$work/aside"
mv "$lib"/libhawser.so* "$work/aside"
run pc_static.log compile "$work/pc_static" --static
[ "$("$work/pc_static")" = "$version" ] || fail "the static pkg-config consumer does not work"
mv "$work/aside"/* "$lib"

# find_package, shared and static in one project.
run cmake.log cmake -S "$here" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$prefix"
run build.log cmake --build "$work/cmake"
for kind in shared static; do
    [ "$("$work/cmake/consumer_$kind")" = "$version" ] || fail "the find_package consumer ($kind) does not work"
done
echo "check_install: fine"
