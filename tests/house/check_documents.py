"""What the documents point to is there: files behind links, and paths in backticks below the project's folders.

Usage: check_documents.py ROOT
A path in backticks counts if it begins with a folder of the project ("`sim/solve/newton.c`", "`bench/results/`"); it may hold
"*" and "{a,b}", and words in capitals ("`cases/NAME.yaml`") stand for anything.
"""
import glob
import os
import re
import sys

import tree

TOPS = "|".join([*tree.BELOW, "tests", "bench", "scripts", "cases", "cmake", "docs"])
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
PATH = re.compile(rf"`((?:{TOPS})/[\w./*{{}},-]*)`")
MADE = re.compile(r"bench/results/[A-Z]|build/")  # by a run, elsewhere


def documents(root):
    """Paths of all documents: those at the top, and those of docs/ and bench/."""
    found = [name for name in os.listdir(root) if name.endswith(".md")]
    for top in ("docs", "bench"):
        for folder, _, names in os.walk(os.path.join(root, top)):
            found += [os.path.relpath(os.path.join(folder, n), root) for n in names if n.endswith(".md")]
    return sorted(found)


def braces(path):
    """'a/{b,c}.h' -> a/b.h, a/c.h."""
    found = re.search(r"\{([^{}]*)\}", path)
    if not found:
        return [path]
    return [p for word in found.group(1).split(",") for p in braces(path[:found.start()] + word + path[found.end():])]


def is_there(root, path):
    pattern = re.sub(r"(?<![A-Za-z0-9])[A-Z]{2,}(?![a-z])", "*", path)
    return all(glob.glob(os.path.join(root, p)) for p in braces(pattern))


def check(root):
    complaints = []
    for document in documents(root):
        text = tree.read(root, document)

        def complain(at, what):
            complaints.append(f"{document}:{text.count(chr(10), 0, at) + 1}: {what}, which is not there")
        for m in LINK.finditer(text):
            if "://" not in m.group(1) and not os.path.exists(os.path.join(root, os.path.dirname(document), m.group(1))):
                complain(m.start(), f"links to {m.group(1)}")
        for m in PATH.finditer(text):
            if not MADE.match(m.group(1)) and not is_there(root, m.group(1)):
                complain(m.start(), f"names {m.group(1)}")
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("documents", check(sys.argv[1])))
