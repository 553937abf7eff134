#!/usr/bin/env python3
"""Sums of what the page is made of and of what was made: web/dist/MANIFEST.

Also whether the files that the desk's engine is built of, cmake/Desk.cmake, are there: the build that names them is no part of the default one.

Usage: python3 web/manifest.py [--write]    (without --write: compares; status 1 and the names of the files that differ)
"""
import hashlib
import re
import sys
from pathlib import Path

WEB = Path(__file__).resolve().parent
MANIFEST = WEB / "dist" / "MANIFEST"
MADE_OF = ("package.json", "package-lock.json", "tsconfig.json", "build.mjs", "desk.mjs", "convert.mjs", "licence.mjs")
MADE = ("dist/report.js", "dist/report.css", "dist/desk.html", "dist/convert.cjs")


def sums():
    """The manifest's text: a line a file, as sha256sum writes it, by name."""
    folders = [path for folder in ("src", "engine") for path in (WEB / folder).rglob("*") if path.is_file()]
    names = [*MADE_OF, *MADE, *(str(path.relative_to(WEB)) for path in folders)]
    return "".join(f"{hashlib.sha256((WEB / name).read_bytes()).hexdigest()}  {name}\n" for name in sorted(names))


def main():
    found = sums()
    if sys.argv[1:] == ["--write"]:
        MANIFEST.write_text(found)
        return
    root = WEB.parent
    gone = [name for name in re.findall(r"[\w/]+\.c\b", (root / "cmake" / "Desk.cmake").read_text()) if not (root / name).is_file()]
    if gone:
        sys.exit(f"manifest.py: cmake/Desk.cmake names files that are gone: {', '.join(gone)}")
    written = MANIFEST.read_text()
    if found == written:
        return
    differing = sorted({line.split("  ")[1] for line in set(found.splitlines()) ^ set(written.splitlines())})
    sys.exit(f"manifest.py: not what web/dist was made of: {', '.join(differing)}; run sh scripts/web.sh and commit web/dist")


if __name__ == "__main__":
    main()
