"""Lengths that nobody may pass: a function 80 lines, a .c file 600, a header 250, a folder 24 files; `#if` stays rare, and so do
headers of a few lines.

Usage: check_sizes.py ROOT      (the targets, which are lower, stand in CONTRIBUTING.md)
"""
import collections
import os
import re
import sys

import tree

FUNCTION_MAX, SOURCE_MAX, HEADER_MAX, IF_MAX_PER_1000 = 80, 600, 250, 1.0
FOLDER_MAX = 24  # .c and .h files directly in a folder
SHORT_HEADER, SHORT_HEADERS_MAX = 30, 24  # lines; how many such headers there may be
HEAD = re.compile(r"(\w+)\s*\([^{};]*\)\s*$", re.S)


def functions(code):
    """(name, first line, lines of the body) of every function in code without comments."""
    depth, start, head, found = 0, 0, 0, []
    for i, ch in enumerate(code):
        if ch == "{":
            if depth == 0:
                start = i
            depth += 1
        elif ch == "}":
            depth -= 1
            name = HEAD.search(code[head:start].rstrip()) if depth == 0 else None
            if name:
                found.append((name.group(1), code.count("\n", 0, start) + 1, code.count("\n", start, i) + 1))
            if depth == 0:
                head = i + 1
        elif ch == ";" and depth == 0:
            head = i + 1
    return found


def check(root):
    complaints, lines, ifs, short = [], 0, 0, 0
    paths = tree.sources(root, tree.BELOW)
    for folder, files in sorted(collections.Counter(map(os.path.dirname, paths)).items()):
        if files > FOLDER_MAX:
            complaints.append(f"{folder}/: {files} files (at most {FOLDER_MAX})")
    for path in paths:
        text = tree.read(root, path)
        count, limit = text.count("\n"), HEADER_MAX if path.endswith(".h") else SOURCE_MAX
        if count > limit:
            complaints.append(f"{path}: {count} lines (at most {limit})")
        for name, line, length in functions(tree.code_only(text)):
            if length > FUNCTION_MAX:
                complaints.append(f"{path}:{line}: {name} has {length} lines (at most {FUNCTION_MAX})")
        lines += count
        short += path.endswith(".h") and count <= SHORT_HEADER
        ifs += len(re.findall(r"^[ \t]*#[ \t]*if(?!ndef HAWSER_\w+_H$)", text, re.M))
    if ifs > max(3.0, IF_MAX_PER_1000 * lines / 1000):
        complaints.append(f"{ifs} #if in {lines} lines (at most {IF_MAX_PER_1000:g} in 1000)")
    if SHORT_HEADERS_MAX is not None and short > SHORT_HEADERS_MAX:
        complaints.append(f"{short} headers of at most {SHORT_HEADER} lines (at most {SHORT_HEADERS_MAX})")
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("sizes", check(sys.argv[1])))
