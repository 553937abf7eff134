#!/bin/sh
# Debian's packages in a clean chroot: installed, used by the program, a shared and a static consumer, removed without a trace, and
# without MPI. Usage: check_chroot.sh SOURCE_DIR [DEBS]     (DEBS: a folder with the packages; default: they are built)
# Skipped (77) without mmdebstrap, debhelper, root or the archive of packages. HAWSER_SUITE: another suite than bookworm.
set -eu
export LC_ALL=C
source_dir=$1 debs=${2-}
command -v mmdebstrap >/dev/null 2>&1 && command -v dh >/dev/null 2>&1 && [ "$(id -u)" -eq 0 ] || {
    echo "skipped: mmdebstrap, debhelper and root are needed"
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
cp "$debs"/hawser_*.deb "$debs"/libhawser*.deb "$root/debs"
rm -f "$root"/debs/*dbgsym*
cp "$source_dir/packaging/debian/tests/program" "$source_dir/packaging/debian/tests/library" "$root/try"
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
for file in /etc/apt/apt.conf.d/*proxy*; do [ ! -e "$file" ] || cp -n "$file" "$root/etc/apt/apt.conf.d/"; done
cat >"$root/try/all" <<'END'
set -eu
export DEBIAN_FRONTEND=noninteractive
fail() {
    echo "check_chroot: $*" >&2
    exit 1
}
apt-get update -q >/try/log 2>&1
apt-get install -y -q --no-install-recommends /debs/*.deb gcc libc6-dev pkg-config >>/try/log 2>&1 || { tail -n 5 /try/log; fail "not installed"; }
! dpkg -l | grep -q -i -e openmpi -e mpich || fail "MPI came along"
sh /try/program || fail "the program's test"
sh /try/library || fail "the library's test"
echo "installed, used: $(dpkg -l | grep -c '^ii') packages, no MPI"
apt-get install -y -q --no-install-recommends $(dpkg -s libhawser-dev | sed -n 's/^Suggests: //p' | tr -d ',') >>/try/log 2>&1
printf '#include <hawser/hawser.h>\n#include <stdio.h>\nint main(void) { return puts(hawser_version()) < 0; }\n' >/try/v.c
gcc /try/v.c -o /try/v $(pkg-config --cflags --static --libs hawser | sed 's/-lhawser/-l:libhawser.a/') && /try/v || fail "the static consumer"
apt-get purge -y -q hawser libhawser-dev libhawser0.2 >>/try/log 2>&1
left=$(find /usr /etc /var/lib /opt -name '*hawser*' ! -path '/var/lib/apt/*' ! -path '/var/lib/dpkg/*')
[ -z "$left" ] || fail "left behind: $left"
echo "removed"
END
mount -t proc proc "$root/proc" # the program finds its catalogue from its own place
chroot "$root" sh /try/all
