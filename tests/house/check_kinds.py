"""A kind of limit or condition is said once: limits by the rows of def/limit_kinds.h, conditions of trust by the tables of
sim/run/trust.c and theory/conditions.c. From these are the public enumerations; docs/reference/limits.md has a word on each.

Usage: check_kinds.py ROOT [--update]     (--update: writes the enumerations)
The comment of a row says what the kind is. Numbers stay: limits follow their rows, conditions that are new come behind.
"""
import re
import sys

import tree

LIMITS, CONDITIONS, DOCUMENT = "def/limit_kinds.h", ("sim/run/trust.c", "theory/conditions.c"), "docs/reference/limits.md"
LIMIT = re.compile(r'(?:/\* ((?:(?!\*/).)*?) \*/\n)?^LIMIT\((\w+), "(\w+)"', re.M | re.S)
CONDITION = re.compile(r'\[HAWSER_CONDITION_(\w+)\]\s*=\s*\{"(\w+)",\s*"[^"]+"\},(?:\s*/\* ((?:(?!\*/).)*?) \*/)?', re.S)
ENUM = r"(typedef enum hawser_%s_kind \{\n)(.*?)(\} hawser_%s_kind;)"
WIDE = 120


def limits(root):
    """[(KIND, name, what it is)], in order."""
    return [(kind, name, text) for text, kind, name in LIMIT.findall(tree.read(root, LIMITS))]


def conditions(root):
    found = {kind: (kind, name, text) for path in CONDITIONS for kind, name, text in CONDITION.findall(tree.read(root, path))}
    there = re.search(ENUM % ("condition", "condition"), tree.read(root, "include/hawser/tables.h"), re.S).group(2)
    order = [kind for kind in re.findall(r"HAWSER_CONDITION_(\w+)", there) if kind in found]
    return [found[kind] for kind in order + [kind for kind in found if kind not in order]]


def lines(what, rows):
    """The enumeration's members, as clang-format has them."""
    names = [f"    HAWSER_{what.upper()}_{kind}{',' if i < len(rows) - 1 else ''}" for i, (kind, _, _) in enumerate(rows)]
    column = max(len(name) for name in names) + 1
    return [f"{name:{column}}/* {' '.join(text.split())} */\n" for name, (_, _, text) in zip(names, rows)]


def expected(root):
    """{path: its text as it should be}, and complaints."""
    texts, complaints, document = {}, [], tree.read(root, DOCUMENT)
    for what, path, rows in (("limit", "include/hawser/limits.h", limits(root)), ("condition", "include/hawser/tables.h", conditions(root))):
        members = lines(what, rows)
        complaints += [f"{what} {name}: nothing says what it is" for _, name, text in rows if not text]
        complaints += [f"{what} {name}: longer than a line of the header" for (_, name, _), line in zip(rows, members) if len(line) > WIDE + 1]
        complaints += [f"{what} {name}: {DOCUMENT} says nothing of it" for _, name, _ in rows if f"`{name}`" not in document]
        texts[path] = re.sub(ENUM % (what, what), lambda m: m.group(1) + "".join(members) + m.group(3), tree.read(root, path), flags=re.S)
    return texts, complaints


def check(root):
    texts, complaints = expected(root)
    return complaints + [f"{path}: is not what the rows of kinds say: check_kinds.py ROOT --update"
                         for path, text in texts.items() if tree.read(root, path) != text]


def main():
    root = sys.argv[1]
    if "--update" in sys.argv:
        for path, text in expected(root)[0].items():
            if tree.read(root, path) != text:
                with open(f"{root}/{path}", "w", encoding="utf-8") as file:
                    file.write(text)
    return tree.report("kinds", check(root))


if __name__ == "__main__":
    sys.exit(main())
