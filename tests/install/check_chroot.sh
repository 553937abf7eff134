#!/bin/sh
# Debian's packages in a clean chroot: installed, tested by autopkgtest (packaging/debian/tests), used by a static consumer, removed without a
# trace, and without MPI. Usage: check_chroot.sh SOURCE_DIR [DEBS]     (DEBS: what packaging/deb.sh wrote; default: they are built)
# Skipped (77) without mmdebstrap, autopkgtest, debhelper, root or the archive of packages. HAWSER_SUITE: another suite than bookworm.
set -eu
export LC_ALL=C
source_dir=$1 debs=${2-}
command -v mmdebstrap >/dev/null 2>&1 && command -v autopkgtest >/dev/null 2>&1 && command -v dh >/dev/null 2>&1 && [ "$(id -u)" -eq 0 ] || {
    echo "skipped: mmdebstrap, autopkgtest, debhelper and root are needed (sh scripts/setup.sh --deb)"
    exit 77
}
work=$(mktemp -d)
root=$work/root
tidy() {
    umount "$root/proc" 2>/dev/null || true
    rm -rf --one-file-system "$work"
}
trap tidy EXIT
if [ -z "$debs" ]; then
    debs=$work/deb
    git clone -q "$source_dir" "$work/clone"
    sh "$work/clone/packaging/deb.sh" "$debs" >"$work/deb.log" 2>&1 || { tail -n 20 "$work/deb.log" >&2; exit 1; }
fi
mmdebstrap --variant=minbase "${HAWSER_SUITE:-bookworm}" "$root" >"$work/chroot.log" 2>&1 || {
    tail -n 3 "$work/chroot.log"
    echo "skipped: no chroot could be made"
    exit 77
}
mkdir "$root/debs" "$root/try"
cp "$debs"/*.deb "$debs"/*.dsc "$debs"/*.tar.* "$root/debs"
rm -f "$root"/debs/*dbgsym*
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
for file in /etc/apt/apt.conf.d/*proxy*; do [ ! -e "$file" ] || cp -n "$file" "$root/etc/apt/apt.conf.d/"; done
fail() {
    echo "check_chroot: $*" >&2
    exit 1
}
# inside NAME: standard input, run in the chroot; what apt says is in /try/log.
inside() {
    { echo "set -eu; export DEBIAN_FRONTEND=noninteractive"; cat; } >"$root/try/$1"
    chroot "$root" sh "/try/$1" || { tail -n 5 "$root/try/log" >&2; fail "$1"; }
}
mount -t proc proc "$root/proc" # the program finds its catalogue from its own place
inside install <<'END'
apt-get update -q >/try/log 2>&1
apt-get install -y -q --no-install-recommends /debs/hawser_*.deb /debs/libhawser*.deb gcc libc6-dev pkg-config >>/try/log 2>&1
if dpkg -l | grep -i -e openmpi -e mpich; then exit 1; fi
echo "installed: $(dpkg -l | grep -c '^ii') packages, no MPI"
END
autopkgtest -q "$root"/debs/*.deb "$root"/debs/*.dsc --summary-file "$work/summary" -- chroot "$root" >"$work/autopkgtest.log" 2>&1 || {
    tail -n 60 "$work/autopkgtest.log" >&2
    fail "autopkgtest"
}
cat "$work/summary"
inside static <<'END'
apt-get install -y -q --no-install-recommends $(dpkg -s libhawser-dev | sed -n 's/^Suggests: //p' | tr -d ',') >>/try/log 2>&1
printf '#include <hawser/hawser.h>\n#include <stdio.h>\nint main(void) { return puts(hawser_version()) < 0; }\n' >/try/v.c
gcc /try/v.c -o /try/v $(pkg-config --cflags --static --libs hawser | sed 's/-lhawser/-l:libhawser.a/')
/try/v
END
inside purge <<'END'
apt-get install -y -q --no-install-recommends /debs/*.deb >>/try/log 2>&1 # what autopkgtest has removed again
apt-get purge -y -q python3-hawser hawser libhawser-dev libhawser0.2 >>/try/log 2>&1
find /usr /etc /var/lib /opt -name '*hawser*' ! -path '/var/lib/apt/*' ! -path '/var/lib/dpkg/*' >/try/left
cat /try/left
[ ! -s /try/left ]
echo "removed"
END
