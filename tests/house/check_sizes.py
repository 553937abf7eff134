"""A function has at most 120 lines. A file is as long as its story.

Usage: check_sizes.py ROOT
"""
import re
import sys

import tree

FUNCTION_MAX = 120
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
    return [f"{path}:{line}: {name} has {length} lines (at most {FUNCTION_MAX})"
            for path in tree.sources(root, tree.BELOW)
            for name, line, length in functions(tree.code_only(tree.read(root, path))) if length > FUNCTION_MAX]


if __name__ == "__main__":
    sys.exit(tree.report("sizes", check(sys.argv[1])))
