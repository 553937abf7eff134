"""Every equation number and section that the code cites is in docs/model.md, and no number is given twice.

Usage: check_equations.py ROOT
A number is given where it ends a line after at least two spaces, or begins one: "(B7)". Code cites it in comments.
"""
import os
import re
import sys

import tree

NUMBER = re.compile(r"\(([A-Z]{1,2}\d+[a-z]?)\)")
GIVEN = re.compile(r"^.*\s{2}\(([A-Z]{1,2}\d+[a-z]?)\)\s*$|^\W*\(([A-Z]{1,2}\d+[a-z]?)\)\s", re.M)
SECTION = re.compile(r'docs/model\.md, "([^"]+)"')
HEADING = re.compile(r"^#+\s+(.*?)\s*$", re.M)
TOPS = list(tree.BELOW) + ["tests", "bench"]


def check(root):
    with open(os.path.join(root, "docs/model.md"), encoding="utf-8") as file:
        model = file.read()
    given = [a or b for a, b in GIVEN.findall(model)]
    headings = set(HEADING.findall(model))
    complaints = [f"docs/model.md: ({n}) is given {given.count(n)} times" for n in sorted(set(given))
                  if given.count(n) > 1]
    complaints += [f"docs/model.md: refers to ({n}), which it does not give"
                   for n in sorted(set(NUMBER.findall(model)) - set(given))]
    for path in tree.sources(root, TOPS):
        for line, comment in tree.comments(tree.read(root, path)):
            comment = re.sub(r"\s*\n[\s*]*", " ", comment)
            complaints += [f"{path}:{line}: ({n}) is not in docs/model.md"
                           for n in NUMBER.findall(comment) if n not in given]
            complaints += [f'{path}:{line}: docs/model.md has no section "{s}"'
                           for s in SECTION.findall(comment) if s not in headings]
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("equations", check(sys.argv[1])))
