"""The commands of documents, run as they stand, and what they print against what the documents say they do.

Usage: check_tutorial.py HAWSER SOURCE [--update]
The tutorial's commands run among the files of docs/tutorial/, those of docs/routes.md among cases/routes/. A block ```console
holds commands ("$ hawser ...") and lines of what each prints, in order; "..." stands for lines that are left out. Words must be the same; numbers may differ by 1 % or 0.3, as they do between processors. A block ```yaml must stand in a file of
the folder. --update puts the lines that the program prints now in the place of those that begin with the same words.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

DOCUMENTS = (("docs/tutorial.md", "docs/tutorial"), ("docs/routes.md", "cases/routes"))
NEAR, SMALL = 0.01, 0.3
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def same(said, printed):
    """Whether a printed line is the one that is said: the same words, numbers near each other."""
    if re.sub(r"\s+", " ", NUMBER.sub("#", said)).strip() != re.sub(r"\s+", " ", NUMBER.sub("#", printed)).strip():
        return False
    pairs = zip(map(float, NUMBER.findall(said)), map(float, NUMBER.findall(printed)))
    return all(abs(a - b) <= max(NEAR * abs(a), SMALL) for a, b in pairs)


def label(line):
    """What a line begins with: its words up to the first number or wide gap."""
    return re.split(r"\s{2,}|\s*[-+]?\d", line.strip())[0]


def answer(command, folder, hawser):
    environment = dict(os.environ, PATH=os.path.dirname(os.path.abspath(hawser)) + os.pathsep + os.environ["PATH"])
    run = subprocess.run(command, shell=True, cwd=folder, env=environment, capture_output=True, text=True)
    return (run.stdout + run.stderr).splitlines()


def follow(block, folder, hawser, complaints):
    """The block with the program's own lines; complains about those that it does not print (any more)."""
    lines, left, command = [], [], ""
    for said in block.splitlines():
        if said.startswith("$ "):
            command = said[2:]
            left = answer(command, folder, hawser)
        elif said.strip() not in ("...", ""):
            found = next((i for i, line in enumerate(left) if same(said, line)), None)
            if found is None:
                complaints.append(f"{command}\n    does not print '{said.strip()}'")
                found = next((i for i, line in enumerate(left) if label(line) == label(said)), None)
                said = said if found is None else left[found].rstrip()
            left = left[found + 1:] if found is not None else left
        lines.append(said)
    return "\n".join(lines) + "\n"


def check(hawser, document, cases, update, complaints):
    """Runs what one document says in a copy of its folder."""
    with open(document, encoding="utf-8") as f:
        text = f.read()
    with tempfile.TemporaryDirectory() as folder:
        files = ""
        for name in os.listdir(cases):
            shutil.copy(os.path.join(cases, name), folder)
            with open(os.path.join(cases, name), encoding="utf-8") as f:
                files += f.read()
        for block in re.findall(r"```yaml\n(.*?)```", text, re.S):
            if block not in files:
                complaints.append(f"no file of {cases} holds\n{block}")
        new = re.sub(r"(?<=```console\n).*?(?=```)", lambda m: follow(m.group(0), folder, hawser, complaints), text, flags=re.S)
    if update:
        with open(document, "w", encoding="utf-8") as f:
            f.write(new)


def main(hawser, source, update):
    complaints = []
    for document, cases in DOCUMENTS:
        check(hawser, os.path.join(source, document), os.path.join(source, cases), update, complaints)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], "--update" in sys.argv[3:]))
