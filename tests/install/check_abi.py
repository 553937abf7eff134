"""What a program that was built against an older header of the same SONAME relies on: every function's prototype, the
place and size of every member, the size of every struct, the value of every constant. The headers are compared with
tests/install/abi.txt; what has been added is fine, what has moved is not.

Usage: check_abi.py ROOT [--update]     (--update: after a change of the SONAME, or to take in what is new)
"""
import os
import re
import subprocess
import sys
import tempfile

# What may grow at its end: the caller says how large his is, or the library hands out a single one.
GROWS = {"hawser_options", "hawser_summary", "hawser_sample", "hawser_geometry", "hawser_certificate"}


def preprocessed(root):
    """The interface as the compiler sees it, in one line, without what the system's headers bring."""
    text = subprocess.run(["cc", "-E", "-I", f"{root}/include", f"{root}/include/hawser/hawser.h"], check=True,
                          capture_output=True, text=True).stdout
    ours, kept = False, []
    for line in text.splitlines():
        marker = re.match(r'# \d+ "([^"]*)"', line)
        if marker:
            ours = "/hawser/" in marker.group(1)
        elif ours:
            kept.append(line)
    return re.sub(r"\s+", " ", " ".join(kept))


def members(body):
    """Names of a struct's members."""
    found = []
    for declaration in body.split(";"):
        declarators = re.sub(r"\[[^\]]*\]", "", declaration).split(",")
        names = [re.search(r"(\w+)\s*$", part) for part in declarators]
        found += [name.group(1) for name in names if name]
    return found


def interface(text):
    """Structs with their members, constants, prototypes."""
    structs = {m.group(2): members(m.group(1))
               for m in re.finditer(r"typedef struct \w+ \{([^{}]*)\} (hawser_\w+);", text)}
    constants = []
    for m in re.finditer(r"enum (?:\w+ )?\{([^{}]*)\}", text):
        constants += [part.split("=")[0].strip() for part in m.group(1).split(",") if part.strip()]
    bare = re.sub(r"\{[^{}]*\}", "", text).replace('extern "C"', "")
    prototypes = {}
    for statement in bare.split(";"):
        m = re.match(r"\s*(?:const )?[\w ]*?\**\s*(hawser_\w+)\s*\(", statement)
        if m and "typedef" not in statement and "(*" not in statement.split("(")[0]:
            prototypes[m.group(1)] = re.sub(r"\s*([(),*])\s*", r"\1", statement.strip())
    return structs, constants, prototypes


def measured(root, structs, constants):
    """Lines that a program of the compiler's prints about them."""
    lines = ["#include <stddef.h>", "#include <stdio.h>", "#include <hawser/hawser.h>", "int main(void) {"]
    for struct, names in sorted(structs.items()):
        lines.append(f'printf("struct {struct} %zu\\n", sizeof({struct}));')
        lines += [f'printf("member {struct} {name} %zu %zu\\n", offsetof({struct}, {name}), '
                  f'sizeof((({struct} *)0)->{name}));' for name in names]
    lines += [f'printf("constant {name} %d\\n", (int){name});' for name in constants]
    lines.append("return 0; }")
    with tempfile.TemporaryDirectory() as work:
        source, program = os.path.join(work, "abi.c"), os.path.join(work, "abi")
        with open(source, "w", encoding="utf-8") as out:
            out.write("\n".join(lines) + "\n")
        subprocess.run(["cc", "-I", f"{root}/include", source, "-o", program], check=True)
        return subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines()


def soname(root):
    """The number in the SONAME that the version asks for."""
    with open(os.path.join(root, "CMakeLists.txt"), encoding="utf-8") as f:
        major, minor = re.search(r"project\(hawser VERSION (\d+)\.(\d+)", f.read()).groups()
    return f"{major}.{minor}" if major == "0" else major


def compare(old, new):
    """Complaints about what old programs rely on."""
    now = {tuple(line.split()[:3]) if line.startswith("member") else tuple(line.split()[:2]): line for line in new}
    complaints = []
    for line in old:
        words = line.split()
        key = tuple(words[:3]) if words[0] == "member" else tuple(words[:2])
        if key not in now:
            complaints.append(f"gone: {line}")
        elif now[key] != line:
            grown = words[0] == "struct" and words[1] in GROWS and int(now[key].split()[2]) > int(words[2])
            if not grown:
                complaints.append(f"was: {line}\n     is: {now[key]}")
    return complaints


def main():
    root, update = sys.argv[1], "--update" in sys.argv
    structs, constants, prototypes = interface(preprocessed(root))
    new = [f"soname {soname(root)}"] + measured(root, structs, constants)
    new += [f"function {name} {text}" for name, text in sorted(prototypes.items())]
    path = os.path.join(root, "tests/install/abi.txt")
    if update:
        with open(path, "w", encoding="utf-8") as out:
            out.write("\n".join(new) + "\n")
        return 0
    with open(path, encoding="utf-8") as f:
        old = f.read().splitlines()
    if old[0] != new[0]:
        print(f"abi: {old[0]} is recorded, this is {new[0]}: check_abi.py ROOT --update")
        return 1
    complaints = compare(old, new)
    for complaint in complaints:
        print(complaint)
    print(f"abi: {len(complaints)} complaint(s)" if complaints else f"abi: fine, {len(new) - len(old)} new lines")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
