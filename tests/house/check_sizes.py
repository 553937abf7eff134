"""Lengths that nobody may pass: a function 80 lines, a .c file 600, a header 250; and `#if` stays rare.

Usage: check_sizes.py ROOT      (the targets, which are lower, stand in CONTRIBUTING.md)
"""
import re
import sys

import tree

FUNCTION_MAX, SOURCE_MAX, HEADER_MAX, IF_MAX_PER_1000 = 80, 600, 250, 1.0
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
    complaints, lines, ifs = [], 0, 0
    for path in tree.sources(root, tree.BELOW):
        text = tree.read(root, path)
        count, limit = text.count("\n"), HEADER_MAX if path.endswith(".h") else SOURCE_MAX
        if count > limit:
            complaints.append(f"{path}: {count} lines (at most {limit})")
        for name, line, length in functions(tree.code_only(text)):
            if length > FUNCTION_MAX:
                complaints.append(f"{path}:{line}: {name} has {length} lines (at most {FUNCTION_MAX})")
        lines += count
        ifs += len(re.findall(r"^[ \t]*#[ \t]*if(?!ndef HAWSER_\w+_H$)", text, re.M))
    if ifs > max(3.0, IF_MAX_PER_1000 * lines / 1000):
        complaints.append(f"{ifs} #if in {lines} lines (at most {IF_MAX_PER_1000:g} in 1000)")
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("sizes", check(sys.argv[1])))
