"""What libabigail says of the interface: a library whose functions do nothing is made of the headers, so that it has their types
and nothing else, and compared with what abidw wrote of one before. Complements check_abi.py, which looks at the headers itself.

Usage: check_abigail.py ROOT [--update]     (--update: after a change of the SONAME, or to take in what is new)
"""
import os
import re
import subprocess
import sys
import tempfile

import check_abi

# What is as it should be: growth at the end where the caller says how large his is, or the library hands out a single one.
GROWTH = "".join(f"[suppress_type]\n  name = {name}\n  has_data_member_inserted_at = end\n\n" for name in sorted(check_abi.GROWS))
WRITE = ["--no-show-locs", "--no-corpus-path", "--no-comp-dir-path", "--no-write-default-sizes"]
CHANGED = 4 | 8  # of abidiff's status; 1 and 2: it could not do its work


def hollow(prototypes):
    """The source of the library: every function, with nothing in it."""
    lines = ["#include <hawser/hawser.h>"]
    for name, text in sorted(prototypes.items()):
        gives = text[:text.index(name + "(")].strip()
        kept = gives if gives.endswith("*") else re.sub(r"\bconst ", "", gives)
        lines.append(f"{text} {{}}" if gives == "void" else f"{text} {{ static {kept} nothing; return nothing; }}")
    return "\n".join(lines) + "\n"


def library(root, work):
    _, _, prototypes = check_abi.interface(check_abi.preprocessed(root))
    source, made = os.path.join(work, "hollow.c"), os.path.join(work, "hollow.so")
    with open(source, "w", encoding="utf-8") as out:
        out.write(hollow(prototypes))
    subprocess.run(["cc", "-g", "-w", "-shared", "-fPIC", "-I", f"{root}/include", source, "-o", made], check=True)
    return made


def main():
    root, update = sys.argv[1], "--update" in sys.argv
    record = os.path.join(root, "tests/install/hawser.abi")
    with tempfile.TemporaryDirectory() as work:
        made, growth = library(root, work), os.path.join(work, "growth")
        if update:
            text = subprocess.run(["abidw", *WRITE, made], check=True, capture_output=True, text=True).stdout
            with open(record, "w", encoding="utf-8") as out:
                out.write(text.replace(work + "/", ""))
            return 0
        with open(growth, "w", encoding="utf-8") as out:
            out.write(GROWTH)
        found = subprocess.run(["abidiff", "--no-added-syms", "--suppressions", growth, record, made], check=False, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(found.stdout, end="")
    print("abigail: changed" if found.returncode & CHANGED else f"abigail: status {found.returncode}")
    return 1 if found.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
