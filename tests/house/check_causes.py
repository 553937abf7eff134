"""What a run was once wrong about, the table at the top of tests/io/test_trust.c, is tested where its rows say.

Usage: check_causes.py ROOT
A row is " *   CAUSE   PLACE, TEST, TEST; PLACE, TEST": a place is "here" or a file below tests/ without its ".c", a test a function that is
run there; of a script (".sh") and a file that is named alone the file is enough.
"""
import os
import re
import sys

TABLE = "tests/io/test_trust.c"
ROW = re.compile(r"^ \*   (\S.{46,47}) *(here\b|\w+/\w+)(.*)$", re.M)


def rows(text):
    """[(cause, [(file, [tests])])] of the file's first comment."""
    found = []
    for cause, first, rest in ROW.findall(text[:text.index("*/")]):
        places = [part.split(":")[0].split(", ") for part in (first + rest).split("; ")]
        found.append((cause.strip(), [(TABLE if place == "here" else "tests/" + place + ("" if place.endswith(".sh") else ".c"),
                                       [name.strip() for name in names]) for place, *names in places]))
    return found


def complaints(root):
    """One line for each place or test that is not there, and for a table of which nothing was read."""
    with open(os.path.join(root, TABLE), encoding="utf-8") as file:
        text = file.read()
    table = rows(text)
    out = [] if table else [f"{TABLE}: no table of what runs were wrong about"]
    for cause, places in table:
        for path, names in places:
            full = os.path.join(root, path)
            if not os.path.exists(full):
                out.append(f"{TABLE}: '{cause}': there is no {path}")
                continue
            with open(full, encoding="utf-8") as file:
                body = file.read()
            out += [f"{TABLE}: '{cause}': {path} runs no test {name}" for name in names
                    if not re.search(rf"^TEST(?:_WITH)?\({re.escape(name)}\b", body, re.M)]
    return out


def main():
    found = complaints(sys.argv[1])
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
