"""What the documents point to is there: files and headings behind links, and paths in backticks below the project's folders;
sections that comments in the sources cite, as in docs/formats.md, "The checkpoint".

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
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?[^)]*\)")
HEADING = re.compile(r"^#+ +(.*)$", re.M)
BLOCK = re.compile(r"^```.*?^```", re.M | re.S)
PATH = re.compile(rf"`((?:{TOPS})/[\w./*{{}},-]*)`")
CITED = re.compile(r'(docs/(?!theory)[\w/-]+\.md),[\s*]*"([^"]+)"')  # check_equations.py reads the theory's
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


def anchors(root, document):
    """The names by which links reach the headings of a document, as GitHub and the site make them."""
    found = []
    for heading in HEADING.findall(BLOCK.sub("", tree.read(root, document))):
        name = re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()).strip().replace(" ", "-")
        found.append(f"{name}-{found.count(name)}" if name in found else name)
    return found


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
            target, anchor = m.groups()
            if "://" in target:
                continue
            path = os.path.normpath(os.path.join(os.path.dirname(document), target)) if target else document
            if not os.path.exists(os.path.join(root, path)):
                complain(m.start(), f"links to {target}")
            elif anchor and path.endswith(".md") and anchor not in anchors(root, path):
                complain(m.start(), f"links to {target}#{anchor}")
        for m in PATH.finditer(text):
            if not MADE.match(m.group(1)) and not is_there(root, m.group(1)):
                complain(m.start(), f"names {m.group(1)}")
    for source in tree.sources(root, [*tree.BELOW, "tests", "bench"]):
        for line, comment in tree.comments(tree.read(root, source)):
            for document, section in CITED.findall(comment):
                there = os.path.exists(os.path.join(root, document))
                headings = HEADING.findall(tree.read(root, document).replace("`", "").lower()) if there else []
                if not any(heading.startswith(section.lower()) for heading in headings):
                    complaints.append(f'{source}:{line}: cites {document}, "{section}", which is not there')
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("documents", check(sys.argv[1])))
