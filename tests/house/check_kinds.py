"""A kind of limit or condition is said once: limits by the rows of def/limit_kinds.h, conditions of trust by the tables of
sim/run/trust.c and theory/conditions.c. From these are the public enumerations and docs/reference/limits.md, which has the usual
ranges of io/api/api_case.c too.

Usage: check_kinds.py ROOT [--update]     (--update: writes both)
The comment above a row says what the kind is, and then, for users, `Found:` and `Allowed:` of a limit, `Holds if:` and `Fails because:`
of a condition, and the `Remedy:`. Numbers stay: limits follow their rows, conditions that are new come behind.
"""
import re
import sys

import tree

LIMITS, TRUST, THEORY, RANGES = "def/limit_kinds.h", "sim/run/trust.c", "theory/conditions.c", "io/api/api_case.c"
DOCUMENT = "docs/reference/limits.md"
COMMENT = r"/\* ((?:(?!\*/).)*?)\s*\*/\s*"
LIMIT = re.compile(rf'{COMMENT}^LIMIT\((\w+), "(\w+)", "([^"]+)"', re.M | re.S)
CONDITION = re.compile(rf'(?:{COMMENT})?\[HAWSER_CONDITION_(\w+)\]\s*=\s*\{{"(\w+)",\s*"([^"]+)"\}}', re.S)
RANGE = re.compile(rf'{COMMENT}\[PLAUSIBLE_\w+\] = \{{"([^"]+)", "([^"]*)", ([\d.]+), ([\d.]+)\}}', re.S)
ENUM = r"(typedef enum hawser_%s_kind \{\n)(.*?)(\} hawser_%s_kind;)"
WIDE = 120
OF_THEORY = "of theory: "
LIMIT_FIELDS, CONDITION_FIELDS = ("Found", "Allowed", "Remedy"), ("Holds if", "Fails because", "Remedy")
HEAD = """# Limits and conditions of trust

What each limit and condition compares, and what to do if it fails. [Read the verdict](../guide/read-the-verdict.md) begins there, with examples.
This page is made from the tables of the program by `tests/house/check_kinds.py`.

## Limits

A case is judged if it has the section `limits`. Its own values go first: `pull`, `sidewall` and `bend_radius` are on most data sheets. Where it has none, [codes](codes.md)
lists the value of each code with its clause. The equations are in [the theory](../theory/62-limits.md). Limits for which the case has nothing (no rollers, one cable) are not listed.

"""
TRUST_HEAD = """
## Trust

Conditions of trust decide whether the figures can be believed. If one fails, the verdict is NOT TRUSTED, whatever the limits are. A condition is listed where it applies; it holds if the value
found is at most the allowed one. `summary.json` has all under `trust`. The order is that of repair.

### Of a simulation

"""
THEORY_HEAD = "\n### Of a calculation\n\n"
RANGES_HEAD = """
## Unusual figures

`hawser check` lists figures outside these ranges as "Hardly ever so: is the unit right?" (`unusual` in JSON); `theory` and `run` print them above the verdict. They are notes: a wrong
unit usually gives a factor of ten or a thousand. Rods are not checked.

"""


def parts(comment, fields):
    """What a comment above a row says: the kind itself, then each field's text."""
    text = re.sub(r"\s*\n\s*\*?\s*", " ", comment).strip()
    found = re.split(rf"\s*\b({'|'.join(fields)}):\s+", text)
    return found[0].strip(), {name: said.strip().removesuffix(".") for name, said in zip(found[1::2], found[2::2])}


def limits(root):
    """[(KIND, name, unit, what it is, {field: text})], in order."""
    return [(kind, name, unit, *parts(comment, LIMIT_FIELDS)) for comment, kind, name, unit in LIMIT.findall(tree.read(root, LIMITS))]


def conditions(root, path):
    return [(kind, name, unit, *parts(comment, CONDITION_FIELDS)) for comment, kind, name, unit in CONDITION.findall(tree.read(root, path))]


def numbered(root):
    """Conditions in the order of their numbers."""
    found = {row[0]: row for path in (TRUST, THEORY) for row in conditions(root, path)}
    there = re.search(ENUM % ("condition", "condition"), tree.read(root, "include/hawser/tables.h"), re.S).group(2)
    order = [kind for kind in re.findall(r"HAWSER_CONDITION_(\w+)", there) if kind in found]
    return [found[kind] for kind in order + [kind for kind in found if kind not in order]]


def lines(what, rows):
    """The enumeration's members, as clang-format has them."""
    names = [f"    HAWSER_{what.upper()}_{kind}{',' if i < len(rows) - 1 else ''}" for i, (kind, *_) in enumerate(rows)]
    column = max(len(name) for name in names) + 1
    return [f"{name:{column}}/* {text} */\n" for name, (_, _, _, text, _) in zip(names, rows)]


def table(head, rows, fields):
    text = f"| {' | '.join(head)} |\n|{'---|' * len(head)}\n"
    for _, name, unit, _, said in rows:
        text += f"| `{name}`{', ' + unit if unit != '1' else ''} | {' | '.join(said.get(field, '') for field in fields)} |\n"
    return text


def ranges(root):
    rows = [(f"{what}{', ' + unit if unit else ''}", said.get("Of", ""), least, most, said.get("Known", ""))
            for comment, what, unit, least, most in RANGE.findall(tree.read(root, RANGES)) for _, said in [parts(comment, ("Of", "Known"))]]
    return "| figure | of | from | to | known values |\n|---|---|---:|---:|---|\n" + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def page(root):
    theory = conditions(root, THEORY)
    of_run = conditions(root, TRUST) + [row for row in theory if not row[3].startswith(OF_THEORY)]
    head = ("condition", "holds if", "usual reason of a failure", "what to do")
    return (HEAD + table(("limit", "found", "allowed, unless the case gives it", "what to do if it is broken"), limits(root), LIMIT_FIELDS) +
            TRUST_HEAD + table(head, of_run, CONDITION_FIELDS) + THEORY_HEAD + table(head, theory, CONDITION_FIELDS) + RANGES_HEAD + ranges(root))


def expected(root):
    """{path: its text as it should be}, and complaints."""
    texts, complaints = {DOCUMENT: page(root)}, []
    for what, path, rows, fields in (("limit", "include/hawser/limits.h", limits(root), LIMIT_FIELDS),
                                     ("condition", "include/hawser/tables.h", numbered(root), CONDITION_FIELDS)):
        members = lines(what, rows)
        complaints += [f"{what} {name}: nothing says what it is" for _, name, _, text, _ in rows if not text]
        complaints += [f"{what} {name}: its comment has no '{field}:'" for _, name, _, _, said in rows for field in fields if not said.get(field)]
        complaints += [f"{what} {row[1]}: longer than a line of the header" for row, line in zip(rows, members) if len(line) > WIDE + 1]
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
