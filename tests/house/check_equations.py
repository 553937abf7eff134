"""Every equation number and section that the code cites is in the model, no number is given twice, and the model's index
(docs/theory.md) names every chapter with its letters.

Usage: check_equations.py ROOT
The model is docs/theory.md with its chapters docs/theory/*.md. A number is given where it ends a line after at least two
spaces, or begins one: "(B7)". Code cites it in comments. A row of the index is "| [file](theory/file) | ... | B, HY |".
"""
import glob
import os
import re
import sys

import tree

NUMBER = re.compile(r"\(([A-Z]{1,2}\d+[a-z]?)\)")
GIVEN = re.compile(r"^.*\s{2}\(([A-Z]{1,2}\d+[a-z]?)\)\s*$|^\W*\(([A-Z]{1,2}\d+[a-z]?)\)\s", re.M)
SECTION = re.compile(r'docs/theory\.md, "([^"]+)"')
HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.M)
ROW = re.compile(r"^\| \[[^]]*\]\((theory/[^)]+)\) \| ([^|]*?) \|$", re.M)
TOPS = list(tree.BELOW) + ["tests", "bench"]


def given_in(text):
    """The numbers that a text gives, in order."""
    return [a or b for a, b in GIVEN.findall(text)]


def letters(numbers):
    """'E, F, N' of E1, F1, F2, N3."""
    return ", ".join(sorted({re.match(r"[A-Z]+", n).group() for n in numbers}))


def check_index(index, chapters):
    """Complaints about the index: {path: letters} of its rows against those of the chapters."""
    rows = {"docs/" + path: cell for path, cell in ROW.findall(index)}
    complaints = [f"docs/theory.md: has a row for {path}, which is not a chapter" for path in sorted(set(rows) - set(chapters))]
    for path, text in sorted(chapters.items()):
        expected = letters(given_in(text))
        if rows.get(path) != expected:
            complaints.append(f"docs/theory.md: wants a row for {path} with the letters: {expected}")
    return complaints


def check(root):
    index = tree.read(root, "docs/theory.md")
    chapters = {path: tree.read(root, path) for path in
                sorted(os.path.relpath(p, root) for p in glob.glob(os.path.join(root, "docs/theory/*.md")))}
    model = "\n".join([index, *chapters.values()])
    given = given_in(model)
    headings = set(HEADING.findall(model))
    complaints = check_index(index, chapters)
    complaints += [f"docs/theory.md: ({n}) is given {given.count(n)} times" for n in sorted(set(given))
                   if given.count(n) > 1]
    complaints += [f"docs/theory.md: refers to ({n}), which it does not give"
                   for n in sorted(set(NUMBER.findall(model)) - set(given))]
    for path in tree.sources(root, TOPS):
        for line, comment in tree.comments(tree.read(root, path)):
            comment = re.sub(r"\s*\n[\s*]*", " ", comment)
            complaints += [f"{path}:{line}: ({n}) is not in docs/theory.md"
                           for n in NUMBER.findall(comment) if n not in given]
            complaints += [f'{path}:{line}: docs/theory.md has no section "{s}"'
                           for s in SECTION.findall(comment) if s not in headings]
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("equations", check(sys.argv[1])))
