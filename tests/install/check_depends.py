"""What pkg-config asks for (Requires.private, of the shared library too) Debian's libhawser-dev brings along: seven packages were missing.
What the static library alone needs (Libs.private) is suggested: libsundials-dev brings MPI, which nobody gets by accident, nor because the
machine that builds the packages has one.

Usage: check_depends.py SOURCE_DIR BUILD_DIR      (77: this is no Debian)
"""
import pathlib
import re
import shutil
import subprocess
import sys

SYSTEM = {"m", "pthread", "dl"}  # of the C library


def owner(pattern):
    """The package that has a file whose path ends so."""
    said = subprocess.run(["dpkg", "-S", pattern], capture_output=True, text=True, check=False).stdout
    return {line.split(":")[0] for line in said.splitlines()}


def main(source, build):
    if not shutil.which("dpkg"):
        return 77
    source, complaints = pathlib.Path(source), []
    text = pathlib.Path(build, "hawser.pc").read_text(encoding="utf-8")
    control = (source / "packaging/debian/control").read_text(encoding="utf-8")
    paragraph = next(p for p in control.split("\n\n") if p.startswith("Package: libhawser-dev"))
    depends, suggests = (set(re.findall(r"[a-z0-9][a-z0-9.+-]+-dev\b", part)) for part in
                         paragraph.split("Depends:", 1)[1].split("Description:")[0].split("Suggests:"))
    static = {}
    wanted = {name: owner(f"*/pkgconfig/{name}.pc") for name in re.search(r"^Requires.private: (.*)$", text, re.M).group(1).split()}
    for name in re.findall(r"-l(\S+)", re.search(r"^Libs.private: (.*)$", text, re.M).group(1)):
        if name not in SYSTEM:
            static[name] = owner(f"*/lib{name}.so") | owner(f"*/lib{name}.a")
    for name, packages in wanted.items():
        if not packages & depends:
            complaints.append(f"libhawser-dev does not depend on {' or '.join(sorted(packages)) or 'anything'}, which has {name}")
    for name, packages in static.items():
        if not packages & (depends | suggests):
            complaints.append(f"libhawser-dev does not suggest {' or '.join(sorted(packages)) or 'anything'}, which has {name}")
    if len(wanted) < 7 or len(static) < 5:
        complaints.append(f"only {sorted(wanted)} and {sorted(static)} are wanted")
    if "libsundials-dev" in depends:
        complaints.append("libhawser-dev brings MPI, which libsundials-dev depends on")
    if "-DHAWSER_MPI=OFF" not in (source / "packaging/debian/rules").read_text(encoding="utf-8"):
        complaints.append("the packages have MPI where the machine that builds them has it")
    for complaint in complaints:
        print(complaint)
    print("depends:", f"{len(complaints)} complaint(s)" if complaints else f"fine, {len(wanted)} and {len(static)} libraries")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
