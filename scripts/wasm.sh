#!/bin/sh
# Builds the desk's engine: theory, cases and routes as WebAssembly, by Debian's emscripten, with libraries from Debian's source packages; then
# web/dist/desk.html, the page that has it inside. Who only uses the page needs none of this.
# Usage: sh scripts/wasm.sh [--engine]        --engine: without the page
set -eu

cd "$(dirname "$0")/.."
root=$(pwd) work=$(pwd)/build/wasm
mkdir -p "$work/sources" "$work/lib" "$work/include"
sh scripts/setup.sh --wasm
sh scripts/setup.sh --web
# Node's own modules, which Debian keeps in a place that other builds of Node do not know.
export NODE_PATH=/usr/share/nodejs

# What is linked, and the versions that were tried: another one of Debian's gives a message, not another page.
packages="libyaml=0.2.5-1 expat=2.5.0-1+deb12u2 jansson=2.14-2 zlib=1:1.2.13.dfsg-1 libzip=1.7.3-1"
if [ ! -f "$work/sources/.done" ]; then
    lists=$work/sources/apt
    mkdir -p "$lists/lists/partial" "$lists/cache/archives/partial"
    echo "deb-src http://deb.debian.org/debian bookworm main" >"$lists/sources.list"
    echo "deb-src http://deb.debian.org/debian-security bookworm-security main" >>"$lists/sources.list"
    set -- -o Dir::Etc::sourcelist="$lists/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$lists/lists" \
        -o Dir::Cache="$lists/cache" -o APT::Sandbox::User=root -q
    apt-get "$@" update >/dev/null
    (cd "$work/sources" && for package in $packages; do apt-get "$@" source --download-only "$package" >/dev/null; done &&
        for file in *.orig.tar.*; do tar xf "$file"; done && touch .done)
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
        emcc -O2 -w -DNDEBUG -fmacro-prefix-map="$root"=. $flags -I"$work/include" -c "$file" -o "$objects/$(basename "$file" .c).o"
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
compile z "" $(for f in adler32 crc32 deflate inffast inflate inftrees trees zutil; do echo "$s"/zlib-1.2.13*/$f.c; done)
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

emcmake cmake --preset wasm >"$work/build.log"
cmake --build --preset wasm >>"$work/build.log"
# What is inside, each under its own licence.
for file in "$s"/libyaml-0.2.5/License "$s"/libexpat-R_2_5_0/COPYING "$s"/jansson-2.14/LICENSE "$s"/zlib-1.2.13*/LICENSE "$s"/libzip-1.7.3/LICENSE \
    /usr/share/emscripten/system/lib/libc/musl/COPYRIGHT; do
    echo "== $(basename "$(dirname "$file")")"
    cat "$file"
done >"$work/desk/licences.txt"
echo "== emscripten 3.1.6: Copyright 2010-2022 Emscripten authors, under the Expat (MIT) licence, as jansson" >>"$work/desk/licences.txt"
[ "${1-}" != --engine ] || exit 0
cd web
node desk.mjs "$work/desk"
python3 manifest.py --write
ls -l dist/desk.html
