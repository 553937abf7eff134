"""Reading the tree for the checks: which files belong to it, their includes, their code without comments."""
import os
import re

# Every folder with the project's own code, and how far up it is: a file includes its own folder and lower ones only.
# Numbers of one level tell contact and linsolve (which never meet) from the strict order theory < sim < validate < io.
BELOW = {
    "include": (),
    "core": ("include",),
    "contact": ("include", "core"),
    "linsolve": ("include", "core"),
    "theory": ("include", "core"),
    "sim": ("include", "core", "contact", "linsolve", "theory"),
    "validate": ("include", "core", "contact", "linsolve", "theory", "sim"),
    "io": ("include", "core", "contact", "linsolve", "theory", "sim", "validate"),
    "cli": ("include",),
}
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)


def sources(root, tops):
    """Paths, relative to root, of the .c and .h files below the folders `tops`, sorted."""
    found = []
    for top in tops:
        for folder, _, names in os.walk(os.path.join(root, top)):
            found += [os.path.relpath(os.path.join(folder, n), root) for n in names if n.endswith((".c", ".h"))]
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


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
