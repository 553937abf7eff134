"""The commands of the guide, run as they stand, and what they print against what the guide says they do.

Usage: check_guide.py HAWSER SOURCE [--update] [PAGE ...]
Each page of docs/guide/, and README.md, has a folder of its own with the files of docs/tutorial/ and the tree cases/. A block ```console holds
commands ("$ hawser ...") and lines of what each prints, in order; "..." stands for lines that are left out. Words must be the
same; numbers may differ by 1 % or 0.3, as they do between processors. A block ```sh is run by the shell and must end with
status 0. A block ```yaml must stand in a file of docs/tutorial/ or cases/. --update writes the lines that the program prints now
in the place of those that begin with the same words.
"""
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

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


class Page:
    """A page's folder, in which its commands run, and what is wrong with the page."""

    def __init__(self, name, folder, hawser):
        self.name, self.folder, self.complaints = name, folder, []
        path = os.path.dirname(os.path.abspath(hawser)) + os.pathsep + os.environ["PATH"]
        self.environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")} | {"PATH": path}

    def complain(self, what):
        self.complaints.append(f"{self.name}: {what}")

    def run(self, command):
        return subprocess.run(["sh", "-e", "-c", command], cwd=self.folder, env=self.environment, capture_output=True, text=True)

    def follow(self, block):
        """A block of commands and lines with the program's own lines; complains about those that it does not print."""
        lines, left, command = [], [], ""
        for said in block.splitlines():
            if said.startswith("$ "):
                command = said[2:]
                run = self.run(command)
                left = (run.stdout + run.stderr).splitlines()
            elif said.strip() not in ("...", ""):
                found = next((i for i, line in enumerate(left) if same(said, line)), None)
                if found is None:
                    self.complain(f"{command}\n    does not print '{said.strip()}'")
                    found = next((i for i, line in enumerate(left) if label(line) == label(said)), None)
                    said = said if found is None else left[found].rstrip()
                left = left[found + 1:] if found is not None else left
            lines.append(said)
        return "\n".join(lines) + "\n"

    def block(self, kind, text, files):
        """A fenced block as the page should have it."""
        if kind == "console":
            return self.follow(text)
        if kind == "sh":
            run = self.run(text)
            if run.returncode:
                self.complain(f"status {run.returncode} of\n{text}{run.stderr}")
        elif kind == "yaml" and text not in files:
            self.complain(f"no file of docs/tutorial or cases holds\n{text}")
        return text


def check(hawser, source, page, files, update):
    """Complaints about one page."""
    with open(page, encoding="utf-8") as f:
        text = f.read()
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(os.path.join(source, "docs", "tutorial"), folder, dirs_exist_ok=True)
        shutil.copytree(os.path.join(source, "cases"), os.path.join(folder, "cases"))
        at = Page(os.path.relpath(page, source), folder, hawser)
        new = re.sub(r"^```(\w+)\n(.*?)^```", lambda m: f"```{m.group(1)}\n{at.block(m.group(1), m.group(2), files)}```", text,
                     flags=re.S | re.M)
    if update:
        with open(page, "w", encoding="utf-8") as f:
            f.write(new)
    return at.complaints


def main(hawser, source, options):
    pages = [o for o in options if o != "--update"] or [
        os.path.join(source, "README.md"), *sorted(glob.glob(os.path.join(source, "docs", "guide", "*.md")))]
    files = ""
    for path in glob.glob(os.path.join(source, "docs/tutorial/*.yaml")) + glob.glob(os.path.join(source, "cases/**/*.yaml"), recursive=True):
        with open(path, encoding="utf-8") as f:
            files += f.read()
    complaints = [c for page in pages for c in check(hawser, source, page, files, "--update" in options)]
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
