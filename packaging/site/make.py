"""The site: one folder that any web server can serve, or a disk. Documents, the references of C and Python, a search that needs no
server, and each example with its calculation, the desk with it inside and, where that is cheap, its run.

Usage: make.py TREE BUILD FOLDER [--runs SECONDS]      (scripts/site.sh; BUILD has cli/hawser and python/package)
Runs whose computing is estimated at no more than SECONDS are computed (default 2; 0: none).
"""
import argparse
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DOCUMENTS = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "docs/**/*.md")
PICTURES = ("docs/**/*.png", "docs/**/*.svg", "docs/**/*.csv")
LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s#]+)(#[^)\s]*)?\)")
FENCE = re.compile(r"^(```.*?^```)", re.M | re.S)


class Site:
    def __init__(self, tree, build, runs):
        self.tree, self.runs = tree, runs
        self.program, self.package = build / "cli" / "hawser", build / "python" / "package"
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix="hawser-site-"))
        self.source, self.extra = self.scratch / "source", self.scratch / "extra"
        self.extra.mkdir()

    def hawser(self, *words, **how):
        """The program; None: it refuses. What it says of a case that is not SAFE is no refusal."""
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, cwd=self.tree, **how)
        return done.stdout if done.returncode == 0 else None

    # ------------------------------------------------------------------------------------------------ documents

    def documents(self):
        pages = [page for pattern in DOCUMENTS for page in sorted(self.tree.glob(pattern))]
        for page in pages:
            to = self.source / page.relative_to(self.tree)
            to.parent.mkdir(parents=True, exist_ok=True)
            to.write_text(self.linked(page, pages), encoding="utf-8")
        for picture in (picture for pattern in PICTURES for picture in self.tree.glob(pattern)):
            to = self.source / picture.relative_to(self.tree)
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(picture, to)
        return [str(page.relative_to(self.tree).with_suffix("")) for page in pages]

    def linked(self, page, pages):
        """The text, with links to what is no page (a licence, a figure's table) as HTML, which MyST leaves alone; those files come along."""
        def link(match):
            words, target, anchor = match[1], match[2], match[3] or ""
            path = (page.parent / target).resolve()
            if ":" in target or path in pages:
                return match[0]
            if not path.is_relative_to(self.tree) or not path.exists():
                raise ValueError(f"{page}: nothing is at {target}")
            self.bring(path)
            return f'<a href="{html.escape(target)}{anchor}">{words}</a>'
        parts = FENCE.split(page.read_text(encoding="utf-8"))
        return "".join(part if k % 2 else LINK.sub(link, part) for k, part in enumerate(parts))

    def bring(self, path):
        to = self.extra / path.relative_to(self.tree)
        to.parent.mkdir(parents=True, exist_ok=True)
        if path.is_file():
            shutil.copy(path, to)

    def contents(self, pages):
        """What stands at the side: the documents in the order in which README.md names them, then what it does not name."""
        named = re.findall(r"\]\((docs/[^)#\s]+)\.md", (self.tree / "README.md").read_text(encoding="utf-8"))
        guides = [page for page in dict.fromkeys(named + pages) if page in pages and page.startswith("docs/") and not page.startswith("docs/theory")]
        parts = {"Guides": ["examples", *guides], "References": ["api/python", "api/c"],
                 "The model": ["docs/theory", *[page for page in pages if page.startswith("docs/theory/")]],
                 "The project": [page for page in pages if "/" not in page and page != "README"]}
        text = "".join(f"\n```{{toctree}}\n:hidden:\n:maxdepth: 1\n:caption: {caption}\n\n" + "\n".join(part) + "\n```\n" for caption, part in parts.items())
        with (self.source / "README.md").open("a", encoding="utf-8") as readme:
            readme.write(text)

    # ----------------------------------------------------------------------------------------------- references

    def reference_of_c(self):
        headers = self.tree / "include" / "hawser"
        settings = (HERE / "Doxyfile").read_text(encoding="utf-8") + (
            f"INPUT = {headers}\nINPUT_FILTER = \"{sys.executable} -B {HERE / 'header.py'}\"\nOUTPUT_DIRECTORY = {self.scratch}\n"
            f"STRIP_FROM_PATH = {self.tree / 'include'}\n")
        subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=self.scratch)
        folder = self.source / "api"
        (folder / "c").mkdir(parents=True)
        names = ["hawser", *sorted(path.stem for path in headers.glob("*.h") if path.stem != "hawser")]
        listed = "".join(f"   c/{name}\n" for name in names)
        (folder / "c.rst").write_text("C reference\n===========\n\n:doc:`/docs/guide/c` has programs. Each header is a page; ``hawser/hawser.h`` includes all of them.\n\n"
                                      f".. toctree::\n   :maxdepth: 1\n\n{listed}", encoding="utf-8")
        for name in names:
            title = f"hawser/{name}.h"
            self.bring(headers / f"{name}.h")
            (folder / "c" / f"{name}.rst").write_text(
                f"{title}\n{'=' * len(title)}\n\n.. raw:: html\n\n   <p><a href=\"../../include/hawser/{name}.h\">The header</a></p>\n\n"
                f".. doxygenfile:: {name}.h\n   :sections: briefdescription detaileddescription innerclass public-attrib enum typedef define func\n", encoding="utf-8")

    def reference_of_python(self):
        sys.path.insert(0, str(self.package))
        import hawser

        kinds = {"Functions": [], "Classes": [], "Exceptions": []}
        for name in hawser.__all__:
            thing = getattr(hawser, name)
            if not name.startswith("__"):
                kinds["Functions" if not isinstance(thing, type) else "Exceptions" if issubclass(thing, BaseException) else "Classes"].append(name)
        directive = {"Functions": "autofunction", "Classes": "autoclass", "Exceptions": "autoexception"}
        text = "Python reference\n================\n\n:doc:`/docs/guide/python` has examples. Units are SI.\n\n.. currentmodule:: hawser\n"
        for kind, names in kinds.items():
            text += f"\n{kind}\n{'-' * len(kind)}\n" + "".join(f"\n.. {directive[kind]}:: {name}\n" for name in names)
        (self.source / "api" / "python.rst").write_text(text, encoding="utf-8")

    # ------------------------------------------------------------------------------------------------- examples

    def example(self, path):
        """A row of the list of examples: title, verdict, links."""
        name, title = path.relative_to(self.tree / "cases").with_suffix(""), None
        flat, text = str(name).replace("/", "-"), path.read_text(encoding="utf-8")
        self.bring(path)
        links = [(f"cases/{name}.yaml", "case")]
        page = {part: self.extra / "examples" / f"{flat}-{part}.html" for part in ("calculation", "desk", "run", "job")}
        if re.search(r"^pulls:", text, re.M):
            if self.hawser("job", path, "--report", "-q", "-o", page["job"]) is not None:
                links.append((f"examples/{page['job'].name}", "calculations"))
            return self.row(path, re.search(r"^title: *(.+)$", text, re.M)[1], "", links)
        if re.search(r"^parameters:|^list:", text, re.M):
            return self.row(path, re.search(r"^title: *(.+)$", text, re.M)[1], "study", links)
        told = self.hawser("theory", path, "--format", "json")
        if told is not None:
            theory = json.loads(told)
            if self.hawser("theory", path, "--report", "-q", "-o", page["calculation"]) is not None:
                links.append((f"examples/{page['calculation'].name}", "calculation"))
            if not re.search(r"^\s*(- )?\{?\s*(file|include):|[{,] *file:", text, re.M) and self.hawser("desk", path, "-q", "-o", page["desk"]) is not None:
                links.append((f"examples/{page['desk'].name}", "desk"))
        checked = self.hawser("check", path, "--format", "json")
        facts = json.loads(checked) if checked else {}
        verdict = json.loads(told).get("verdict_forward", "") if told else ""
        if facts.get("time_s") is not None and facts["time_s"] <= self.runs:
            with tempfile.TemporaryDirectory() as out:
                if self.hawser("run", path, "-q", "--report", "-o", out) is not None:
                    shutil.copy(pathlib.Path(out) / "report.html", page["run"])
                    links.append((f"examples/{page['run'].name}", "run"))
        return self.row(path, facts.get("title") or title or str(name), verdict, links)

    @staticmethod
    def row(path, title, verdict, links):
        told = ", ".join(f'<a href="{where}">{what}</a>' for where, what in links)
        word = verdict.split(":")[0]
        return f"<tr><td>{html.escape(title.strip(chr(34)))}</td><td>{html.escape(word)}</td><td>{told}</td></tr>\n"

    def examples(self):
        (self.extra / "examples").mkdir()
        shutil.copy(self.tree / "web" / "dist" / "desk.html", self.extra)
        for file in (self.tree / "cases").rglob("*"):
            if file.is_file():
                self.bring(file)
        cases = sorted(path for path in (self.tree / "cases").rglob("*.yaml"))
        rows = "".join(self.example(path) for path in cases)
        (self.source / "examples.md").write_text(
            "# Examples\n\nEach case of `cases/`: the file, its pulling calculation, <a href=\"desk.html\">the desk</a> with the case in it (not of cases that name other files, which the desk asks for), and, where computing it takes "
            "a moment, the report of its run. The verdict is theory's, pulled forward.\n\n"
            f"<table><thead><tr><th>case</th><th>verdict</th><th>see</th></tr></thead><tbody>\n{rows}</tbody></table>\n", encoding="utf-8")

    # ------------------------------------------------------------------------------------------------------ all

    def make(self, folder):
        pages = self.documents()
        self.contents(pages)
        self.reference_of_c()
        self.reference_of_python()
        self.examples()
        environment = {**os.environ, "PYTHONPATH": str(self.package), "HAWSER_SITE_XML": str(self.scratch / "xml"), "HAWSER_SITE_EXTRA": str(self.extra),
                       "HAWSER_SITE_VERSION": sys.modules["hawser"].__version__}
        subprocess.run([sys.executable, "-B", "-m", "sphinx", "-q", "-b", "html", "-d", self.scratch / "trees", "-c", HERE, self.source, folder],
                       check=True, env=environment)
        shutil.copy(folder / "README.html", folder / "index.html")
        shutil.rmtree(folder / ".doctrees", ignore_errors=True)
        print(f"{len(list(folder.rglob('*.html')))} pages in {folder / 'index.html'}")


def main():
    words = argparse.ArgumentParser()
    for name in ("tree", "build", "folder"):
        words.add_argument(name, type=lambda text: pathlib.Path(text).resolve())
    words.add_argument("--runs", type=float, default=2.0)
    given = words.parse_args()
    if given.folder.exists() and not (given.folder / "searchindex.js").is_file() and (not given.folder.is_dir() or any(given.folder.iterdir())):
        words.error(f"{given.folder}: there is something else than a site: name a folder that is empty or not there")
    site = Site(given.tree, given.build, given.runs)
    try:
        shutil.rmtree(given.folder, ignore_errors=True)
        site.make(given.folder)
    finally:
        shutil.rmtree(site.scratch, ignore_errors=True)


if __name__ == "__main__":
    main()
