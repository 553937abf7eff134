"""Looks for the version in every part of a release: each must say the one that is asked for.

Usage: versions.py VERSION FOLDER [PART...]     FOLDER: as scripts/release.sh makes it; PART: source, desk, deb, sdist, wheel (default: all)
Prints a line for each part; those that say something else, or are missing, end it with 1.
"""
from __future__ import annotations

import base64
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import zipfile
import zlib
from collections.abc import Iterator


def found(pattern: str, text: str) -> str:
    match = re.search(pattern, text, re.M)
    return match.group(1) if match else "none"


def of_source(archive: pathlib.Path) -> Iterator[tuple[str, str]]:
    """CMake's, the public header's, and the newest ones of the two lists of changes; Python's source archive says it once more."""
    with tarfile.open(archive) as packed:
        def text(name: str) -> str:
            (member,) = [m for m in packed.getmembers() if m.name.partition("/")[2] == name] or [None]
            return packed.extractfile(member).read().decode() if member else ""

        yield "CMakeLists.txt", found(r"^project\(hawser VERSION ([0-9.]+)", text("CMakeLists.txt"))
        header = text("include/hawser/status.h")
        yield "status.h", ".".join(found(rf"^#define HAWSER_VERSION_{part} +([0-9]+)$", header) for part in ("MAJOR", "MINOR", "PATCH"))
        yield "CHANGELOG.md", found(r"^## ([0-9.]+)$", text("CHANGELOG.md"))
        if archive.parent.name == "python":
            yield "PKG-INFO", found(r"^Version: (.*)$", text("PKG-INFO"))
        else:
            yield "packaging/debian/changelog", found(r"\Ahawser \(([0-9.]+)-[0-9]+\)", text("packaging/debian/changelog"))


def of_program(program: pathlib.Path, libraries: pathlib.Path) -> str:
    """What `hawser --version` prints."""
    program.chmod(0o755)
    return subprocess.run([program, "--version"], check=True, capture_output=True, text=True,
                          env={**os.environ, "LD_LIBRARY_PATH": str(libraries)}).stdout.removeprefix("hawser ").strip()


def of_packages(folder: pathlib.Path, version: str, work: pathlib.Path) -> Iterator[tuple[str, str]]:
    """Debian's: the control file of each, then the files of all of them together."""
    for package in sorted(folder.glob("*.deb")):
        yield f"{package.name}: control", found(r"^([0-9.]+)-[0-9]+$", subprocess.run(["dpkg-deb", "-f", package, "Version"], check=True, capture_output=True, text=True).stdout)
        if "-dbgsym" not in package.name:
            subprocess.run(["dpkg-deb", "-x", package, work], check=True)
    so = re.sub(r"^(0\.[0-9]+|[0-9]+)\..*", r"\1", version)  # cmake/Install.cmake: the SONAME's number
    for name in ("hawser", "libhawser-dev", f"libhawser{so}", "python3-hawser"):
        if not list(folder.glob(f"{name}_*.deb")):
            yield name, "none"
    for source in folder.glob("*.dsc"):
        yield source.name, found(r"^Version: ([0-9.]+)-[0-9]+$", source.read_text())
    for name, pattern in (("hawser.pc", r"^Version: (.*)$"), ("_declared.py", r"^VERSION: str = '(.*)'$"), ("hawserConfigVersion.cmake", r'set\(PACKAGE_VERSION "(.*)"\)')):
        yield f"Debian's {name}", found(pattern, "".join(file.read_text() for file in work.rglob(name)))
    for library in work.rglob("libhawser.so.*.*.*"):
        yield "Debian's hawser --version", of_program(work / "usr/bin/hawser", library.parent)


def of_wheel(wheel: pathlib.Path, work: pathlib.Path) -> Iterator[tuple[str, str]]:
    yield "its name", wheel.name.split("-")[1]
    with zipfile.ZipFile(wheel) as packed:
        (info,) = (name for name in packed.namelist() if name.endswith(".dist-info/METADATA"))
        yield "METADATA", found(r"^Version: (.*)$", packed.read(info).decode())
        yield "_declared.py", found(r"^VERSION: str = '(.*)'$", packed.read("hawser/_declared.py").decode())
        yield "hawser --version", of_program(pathlib.Path(packed.extract("hawser/bin/hawser", work)), work)


def of_desk(page: pathlib.Path, version: str) -> str:
    """The engine inside is C, which has its version as a text of its own; nothing else in the page has one."""
    engine = zlib.decompress(base64.b64decode(found(r'id="engine">\s*([A-Za-z0-9+/=]+)', page.read_text())), wbits=-15)
    texts = [text.decode() for text in re.findall(rb"(?<=\0)[0-9]+\.[0-9]+\.[0-9]+(?=\0)", engine)]
    return version if version in texts else " or ".join(texts) or "none"


def versions(folder: pathlib.Path, version: str, wanted: list[str], work: pathlib.Path) -> Iterator[tuple[str, str]]:
    """Each part and the version that it has; "none" where the part is missing."""
    parts = {"source": ("hawser-*.tar.gz", of_source), "desk": ("hawser-desk-*.html", lambda page: [("engine", of_desk(page, version))]),
             "deb": ("deb", lambda packages: of_packages(packages, version, work / "deb")), "sdist": ("python/hawser-*.tar.gz", of_source),
             "wheel": ("python/*.whl", lambda wheel: of_wheel(wheel, work))}
    for name in wanted or parts:
        pattern, reader = parts[name]
        paths = list(folder.glob(pattern))
        if len(paths) != 1:
            yield pattern, f"{len(paths)} files" if paths else "none"
        for path in paths:
            for part, says in reader(path):
                yield f"{path.relative_to(folder)}: {part}", says


def main(version: str, folder: str, *wanted: str) -> int:
    with tempfile.TemporaryDirectory() as work:
        table = list(versions(pathlib.Path(folder), version, list(wanted), pathlib.Path(work)))
    for part, says in table:
        print(f"{part}: {says}" + ("" if says == version else f", not {version}"))
    return int(any(says != version for _, says in table))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
