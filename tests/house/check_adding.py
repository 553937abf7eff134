"""The lists of files in docs/adding.md are those of the tree: no file is missing, none too many, each says what goes there.

Usage: check_adding.py ROOT [--update]     (--update: writes the lists; texts of files that stay are kept)
A recipe follows an example that exists: the product files whose code (comments left out) holds the example's word, in any
case of letters. Its list stands between "<!-- files with WORD -->" and "<!-- end -->", a line a file: "- `path`: what".
"""
import os
import re
import sys

import tree

LIST = re.compile(r"(<!-- files with (\S+) -->\n)(.*?)(<!-- end -->)", re.S)
ROW = re.compile(r"^- `([^`]+)`(?:: (.*))?$", re.M)
DOCUMENT = "docs/adding.md"


def code(root):
    """{path: text without comments} of the product's files; strings and includes stay. What is made of the documents follows them."""
    def kept(m):
        return " " if m.group(0).startswith("/") else m.group(0)
    texts = {path: tree.read(root, path) for path in tree.sources(root, tree.BELOW)}
    return {path: tree.TOKENS.sub(kept, text) for path, text in texts.items() if not text.startswith("/* Made by packaging/")}


def files_with(word, sources):
    return [path for path, text in sources.items() if re.search(word, text, re.I)]


def rows(paths, told):
    """The lines of a list."""
    return "".join(f"- `{path}`" + (f": {told[path]}" if told.get(path) else "") + "\n" for path in paths)


def check(root):
    text, sources, complaints = tree.read(root, DOCUMENT), code(root), []
    if not LIST.search(text):
        return [f"{DOCUMENT}: has no list of files"]
    for m in LIST.finditer(text):
        word, told = m.group(2), dict(ROW.findall(m.group(3)))
        expected = files_with(word, sources)
        if not expected:
            complaints.append(f"{DOCUMENT}: no product file has '{word}': take another example")
        complaints += [f"{DOCUMENT}: {word}: says nothing about {path}" for path in expected if told.get(path) == ""]
        if set(told) != set(expected):
            complaints += [f"{DOCUMENT}: {word}: {path} is missing" for path in expected if path not in told]
            complaints += [f"{DOCUMENT}: {word}: {path} does not belong there" for path in told if path not in expected]
            complaints.append(f"the list expected:\n{rows(expected, told)}")
    return complaints


def update(root):
    sources = code(root)

    def written(m):
        return m.group(1) + rows(files_with(m.group(2), sources), dict(ROW.findall(m.group(3)))) + m.group(4)
    text = LIST.sub(written, tree.read(root, DOCUMENT))
    with open(os.path.join(root, DOCUMENT), "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    if sys.argv[2:] == ["--update"]:
        update(sys.argv[1])
    sys.exit(tree.report("adding", check(sys.argv[1])))
