"""Reading the tree for the checks: which files belong to it, their includes, their code without comments."""
import os
import re

RULE = re.compile(r"^(\w+) +sees (\w+(?:, \w+)*)(?: {2,}(\S.*))?$", re.M)


def rule(text):
    """The include rule as docs/architecture.md's block has it: (below, stages). below: the folders that each folder at the
    top sees, itself left out. stages: for those with sub-folders, tuples of them from the uppermost down; those of one
    tuple do not know each other, "" is the files directly in the folder."""
    block = re.search(r"^#+ .*include rule\n.*?^```\n(.*?)^```", text, re.M | re.S).group(1)
    below, stages = {}, {}
    for top, sees, parts in RULE.findall(block):
        below[top] = () if sees == "nothing" else tuple(sees.split(", "))
        stages[top] = [tuple("" if p == "itself" else p for p in stage.split(", "))
                       for stage in (parts or "itself").split(" -> ")]
    return below, stages


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


# Every folder with the project's own code, and how far up it is.
BELOW, STAGES = rule(read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."), "docs/architecture.md"))
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def sources(root, tops):
    """Paths, relative to root, of the .c and .h files below the folders `tops`, sorted."""
    found = []
    for top in tops:
        for folder, _, names in os.walk(os.path.join(root, top)):
            found += [os.path.relpath(os.path.join(folder, n), root) for n in names if n.endswith((".c", ".h"))]
    return sorted(found)


def includes(text):
    """(line, quoted?, name) of every include."""
    return [(text.count("\n", 0, m.start(1)) + 1, m.group(1) == '"', m.group(2)) for m in INCLUDE.finditer(text)]


def comments(text):
    """(line, comment) of every comment."""
    return [(text.count("\n", 0, m.start()) + 1, m.group(0)) for m in TOKENS.finditer(text)
            if m.group(0).startswith("/")]


def code_only(text):
    """The text with comments, strings and preprocessor lines blanked; line breaks stay."""
    def blank(m):
        return re.sub(r"[^\n]", " ", m.group(0))
    text = TOKENS.sub(blank, text)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, text, flags=re.M)


def report(name, complaints):
    """Prints the complaints; the exit status."""
    for complaint in complaints:
        print(complaint)
    print(f"{name}: {len(complaints)} complaint(s)" if complaints else f"{name}: fine")
    return 1 if complaints else 0
