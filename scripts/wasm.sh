#!/bin/sh
# Builds the desk's engine: theory, cases and routes as WebAssembly, by Debian's emscripten, with libraries from Debian's source packages; then
# web/dist/desk.html, the page that has it inside. Who only uses the page needs none of this.
# Usage: sh scripts/wasm.sh [--engine | --check]        --engine: without the page; --check: compares with web/dist/desk.html bit for bit
set -eu

cd "$(dirname "$0")/.."
root=$(pwd) work=$(pwd)/build/wasm only=${1-}
mkdir -p "$work/sources" "$work/lib" "$work/include"
sh scripts/setup.sh --wasm
sh scripts/setup.sh --web
# Node's own modules, which Debian keeps in a place that other builds of Node do not know.
export NODE_PATH=/usr/share/nodejs

# What is linked, and the versions that were tried: another one of Debian's gives a message, not another page.
packages="libyaml=0.2.5-1 expat=2.5.0-1+deb12u2 jansson=2.14-2 zlib=1:1.2.13.dfsg-1 libzip=1.7.3-1
    sundials=6.4.1+dfsg1-3 suitesparse=1:5.12.0+dfsg-2 metis=5.1.0.dfsg-7"
if [ "$(cat "$work/sources/.done" 2>/dev/null || true)" != "$packages" ]; then
    lists=$work/sources/apt
    mkdir -p "$lists/lists/partial" "$lists/cache/archives/partial"
    echo "deb-src http://deb.debian.org/debian bookworm main" >"$lists/sources.list"
    echo "deb-src http://deb.debian.org/debian-security bookworm-security main" >>"$lists/sources.list"
    set -- -o Dir::Etc::sourcelist="$lists/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$lists/lists" \
        -o Dir::Cache="$lists/cache" -o APT::Sandbox::User=root -q
    apt-get "$@" update >/dev/null
    (cd "$work/sources" && for package in $packages; do apt-get "$@" source --download-only "$package" >/dev/null; done &&
        for file in *.orig.tar.*; do tar xf "$file"; done && echo "$packages" >.done)
fi

# compile NAME "FLAGS" FILES...: one static library.
compile() {
    name=$1 flags=$2
    shift 2
    [ ! -f "$work/lib/lib$name.a" ] || return 0
    objects=$work/objects/$name
    mkdir -p "$objects"
    for file in "$@"; do
        # shellcheck disable=SC2086 # words of flags
        emcc -O2 -w -DNDEBUG -fmacro-prefix-map="$root"=. $flags -I"$work/include" -c "$file" \
            -o "$objects/$(basename "$(dirname "$file")")-$(basename "$file" .c).o"
    done
    emar rcs "$work/lib/lib$name.a" "$objects"/*.o
}

s=$work/sources
cp "$s"/libyaml-0.2.5/include/yaml.h "$s"/libexpat-R_2_5_0/expat/lib/expat.h "$s"/libexpat-R_2_5_0/expat/lib/expat_external.h \
    "$s"/jansson-2.14/src/jansson.h "$s"/jansson-2.14/android/jansson_config.h "$s"/zlib-1.2.13*/zlib.h "$s"/zlib-1.2.13*/zconf.h \
    "$s"/libzip-1.7.3/lib/zip.h "$work/include"
compile yaml '-DYAML_VERSION_MAJOR=0 -DYAML_VERSION_MINOR=2 -DYAML_VERSION_PATCH=5 -DYAML_VERSION_STRING="0.2.5"' \
    "$s"/libyaml-0.2.5/src/api.c "$s"/libyaml-0.2.5/src/parser.c "$s"/libyaml-0.2.5/src/reader.c "$s"/libyaml-0.2.5/src/scanner.c \
    "$s"/libyaml-0.2.5/src/loader.c
: >"$work/include/expat_config.h"
: >"$work/include/jansson_private_config.h"
compile expat "-DXML_DTD=1 -DXML_NS=1 -DXML_CONTEXT_BYTES=1024 -DXML_POOR_ENTROPY -DBYTEORDER=1234" \
    "$s"/libexpat-R_2_5_0/expat/lib/xmlparse.c "$s"/libexpat-R_2_5_0/expat/lib/xmlrole.c "$s"/libexpat-R_2_5_0/expat/lib/xmltok.c
compile jansson "-DHAVE_STDINT_H -DHAVE_UNISTD_H -DHAVE_SYS_TIME_H -DHAVE_LOCALECONV -DHAVE_LOCALE_H -DHAVE_STRTOLL \
    -DINITIAL_HASHTABLE_ORDER=3" "$s"/jansson-2.14/src/*.c
compile z "" $(for f in adler32 compress crc32 deflate inffast inflate inftrees trees zutil; do echo "$s"/zlib-1.2.13*/$f.c; done)
if [ ! -f "$work/lib/libzip.a" ]; then
    # its own CMake makes the headers (but for the sizes, which it cannot find out here); no encryption, no other compression
    emcmake cmake -S "$s/libzip-1.7.3" -B "$work/objects/zip" -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF \
        -DZLIB_LIBRARY="$work/lib/libz.a" -DZLIB_INCLUDE_DIR="$work/include" -DENABLE_BZIP2=OFF -DENABLE_LZMA=OFF -DENABLE_ZSTD=OFF \
        -DENABLE_COMMONCRYPTO=OFF -DENABLE_GNUTLS=OFF -DENABLE_MBEDTLS=OFF -DENABLE_OPENSSL=OFF -DENABLE_WINDOWS_CRYPTO=OFF \
        -DHAVE_SIZEOF_OFF_T=1 -DSIZEOF_OFF_T=8 -DHAVE_SIZEOF_SIZE_T=1 -DSIZEOF_SIZE_T=4 -DBUILD_TOOLS=OFF -DBUILD_REGRESS=OFF -DBUILD_EXAMPLES=OFF -DBUILD_DOC=OFF >"$work/zip.log" 2>&1
    cmake --build "$work/objects/zip" --target zip -j "$(nproc)" >>"$work/zip.log" 2>&1
    cp "$work/objects/zip/lib/libzip.a" "$work/lib"
    cp "$work/objects/zip/zipconf.h" "$work/include"
fi

# CVODE with 64-bit indices, as Debian builds it, whose settings are taken; without what needs MPI or a message log.
cp -r "$s"/sundials-6.4.1/include/* "$work/include"
grep -v MPI_ENABLED /usr/include/sundials/sundials_config.h >"$work/include/sundials/sundials_config.h"
cp /usr/include/sundials/sundials_export.h "$work/include/sundials"
cv=$s/sundials-6.4.1/src
compile sundials "-I$cv/sundials -I$cv/cvode" "$cv"/cvode/cvode.c "$cv"/cvode/cvode_io.c "$cv"/cvode/cvode_ls.c "$cv"/cvode/cvode_nls.c \
    "$cv"/cvode/cvode_proj.c "$cv"/nvector/serial/nvector_serial.c "$cv"/sunmatrix/band/sunmatrix_band.c "$cv"/sunmatrix/dense/sunmatrix_dense.c \
    "$cv"/sunnonlinsol/newton/sunnonlinsol_newton.c \
    $(for f in context direct dense band iterative linearsolver logger math matrix memory nonlinearsolver nvector nvector_senswrapper \
        version; do echo "$cv"/sundials/sundials_$f.c; done)
# KLU: the functions on 32-bit integers and real numbers, and what they stand on.
ss=$s/SuiteSparse-5.12.0
cp "$ss"/SuiteSparse_config/SuiteSparse_config.h "$ss"/AMD/Include/*.h "$ss"/COLAMD/Include/*.h "$ss"/BTF/Include/*.h "$ss"/KLU/Include/*.h \
    "$work/include"
compile suitesparse "-DNTIMER" "$ss"/SuiteSparse_config/SuiteSparse_config.c "$ss"/AMD/Source/*.c "$ss"/COLAMD/Source/colamd.c \
    "$ss"/BTF/Source/*.c "$ss"/KLU/Source/*.c
m=$s/metis-5.1.0
cp "$m/include/metis.h" "$work/include"
compile metis "-I$m/GKlib -I$m/libmetis -DLINUX -D_GNU_SOURCE -DNDEBUG2" "$m"/libmetis/*.c \
    $(for f in b64 blas csr error evaluate fkvkselect fs getopt graph htable io itemsets mcore memory omp pdb pqueue random rw seq sort \
        string timers tokenizer util; do echo "$m/GKlib/$f.c"; done)

emcmake cmake --preset wasm -DHAWSER_CVODE_SOURCES="$s/sundials-6.4.1" >"$work/build.log"
cmake --build --preset wasm >>"$work/build.log" || { tail -n 40 "$work/build.log" >&2; exit 1; }
# What is inside, each under its own licence.
for file in "$s"/libyaml-0.2.5/License "$s"/libexpat-R_2_5_0/COPYING "$s"/jansson-2.14/LICENSE "$s"/zlib-1.2.13*/LICENSE "$s"/libzip-1.7.3/LICENSE \
    "$s"/sundials-6.4.1/LICENSE "$s"/SuiteSparse-5.12.0/LICENSE.txt "$s"/metis-5.1.0/LICENSE.txt \
    /usr/share/emscripten/system/lib/libc/musl/COPYRIGHT; do
    echo "== $(basename "$(dirname "$file")")"
    cat "$file"
done >"$work/desk/licences.txt"
echo "== emscripten 3.1.6: Copyright 2010-2022 Emscripten authors, under the Expat (MIT) licence, as jansson" >>"$work/desk/licences.txt"
[ "$only" != --engine ] || exit 0
cd web
if [ "$only" = --check ]; then
    node desk.mjs "$work/desk" "$work/desk.html"
    cmp "$work/desk.html" dist/desk.html || {
        echo "wasm.sh: web/dist/desk.html is not what is in the tree: run sh scripts/wasm.sh and commit web/dist" >&2
        exit 1
    }
    exit 0
fi
node desk.mjs "$work/desk"
python3 manifest.py --write
ls -l dist/desk.html
