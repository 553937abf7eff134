"""A simulation's handle may stand for its second pass: every function of the interface that takes one asks SHOWN for it
before it looks inside.

Usage: check_handles.py ROOT
"""
import os
import re
import sys

import tree

# Those that need both passes: the end of all, and what is told apart before.
EXEMPT = {"hawser_sim_free"}
DECLARED = re.compile(r"\b(hawser_\w+)\((?:[^()]*, )?(?:const )?(?:struct )?hawser_sim \*(\w+)\b[^()]*\);")
DEFINED = re.compile(r"^[a-z][\w \*]*\b(hawser_\w+)\(([^()]*)\)\s*\{(.*?)(?:\}$|^\})", re.M | re.S)
HANDLE = re.compile(r"\b(?:hawser_sim|Sim) \*(\w+)")


def check(root):
    declared = set()
    for path in tree.sources(root, ["include"]):
        declared |= {m.group(1) for m in DECLARED.finditer(tree.code_only(tree.read(root, path)))}
    complaints, found = [], set()
    for path in tree.sources(root, [top for top in tree.BELOW if top != "include"]):
        for name, arguments, body in DEFINED.findall(tree.code_only(tree.read(root, path))):
            handle = HANDLE.search(arguments)
            if name not in declared or not handle:
                continue
            found.add(name)
            # handed on whole to a function that asks, or asked here
            if name not in EXEMPT and f"SHOWN({handle.group(1)})" not in body:
                complaints.append(f"{path}: {name} looks into a handle without SHOWN({handle.group(1)})")
    complaints += [f"{name} is declared and not found" for name in sorted(declared - found)]
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("handles", check(sys.argv[1])))
