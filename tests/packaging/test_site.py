"""The site: every page can be parsed, every link and anchor in it leads somewhere, what people look for is in its search, and each
example has its pages. Usage: test_site.py TREE BUILD PYTHON"""
import html.parser
import importlib.util
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

ALONE = ("-desk.html", "-calculation.html", "-run.html", "-job.html")  # pages of their own, which lead nowhere


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.names = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for key, value in attrs:
            if key in ("href", "src") and value:
                self.links.append(value)
            if key in ("id", "name"):
                self.names.add(value)


def broken(folder):
    """Links that lead nowhere, of all pages but those that are files of their own."""
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in folder.rglob("*.html")
             if not path.name.endswith(ALONE) and path.name != "desk.html"}
    bad = []
    for path, page in pages.items():
        for link in page.links:
            if ":" in link or link.startswith("//"):
                continue
            file, _, anchor = link.partition("#")
            target = (path.parent / file.partition("?")[0]).resolve() if file else path
            if not target.exists() or not target.is_relative_to(folder) or (anchor and target in pages and anchor not in pages[target].names):
                bad.append(f"{path.relative_to(folder)}: {link}")
    return pages, bad


def others(folder):
    """Requests to other machines, of Sphinx's pages."""
    return [f"{path.name}: {word}" for path in folder.glob("*.html") if path.name != "desk.html"
            for word in ('src="http', "cdn.", "googleapis") if word in path.read_text(encoding="utf-8")]


def main():
    tree, build, python = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    missing = [name for name in ("sphinx", "myst_parser", "breathe", "pandas") if importlib.util.find_spec(name) is None]
    if missing or not shutil.which("doxygen") or not (build / "python" / "package").is_dir():
        print(f"skipped: without {' '.join(missing)} doxygen or the Python package (sh scripts/setup.sh --site)")
        return 77
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work).resolve() / "site"
        other = pathlib.Path(work) / "other"  # a folder of somebody's, which was deleted
        other.mkdir()
        (other / "own.txt").write_text("kept", encoding="utf-8")
        refused = subprocess.run([python, "-B", tree / "packaging" / "site" / "make.py", tree, build, other], capture_output=True, text=True)
        if refused.returncode != 2 or "something else than a site" not in refused.stderr or (other / "own.txt").read_text(encoding="utf-8") != "kept":
            print(f"a folder that is no site: status {refused.returncode}, {refused.stderr}")
            return 1
        made = subprocess.run([python, "-B", tree / "packaging" / "site" / "make.py", tree, build, folder, "--runs", "0.5"], capture_output=True, text=True)
        print(made.stdout, made.stderr)
        bad = [f"warned: {line}" for line in made.stderr.splitlines()]
        if made.returncode:
            return 1
        pages, wrong = broken(folder)
        bad += wrong + others(folder)
        index = json.loads((folder / "searchindex.js").read_text(encoding="utf-8").removeprefix("Search.setIndex(").removesuffix(")"))
        bad += [f"the search does not find {word}" for word in ("capstan", "sidewal", "friction") if word not in index["terms"]]
        bad += [f"the search does not find {name}" for name in ("hawser_sim_advance", "hawser.Simulation.roller") if name.split(".")[-1] not in json.dumps(index["objects"])]
        for name, words in (("api/python.html", ("hawser.Simulation.roller", "hawser.study", "hawser.CaseError")),
                            ("api/c/hawser.html", ("hawser_sim_advance", "positive in tension", "Errors: RUN")),
                            ("examples.html", ("huangjiahu-calculation.html", "huangjiahu-desk.html", "jobs-ducts-job.html", "-run.html"))):
            text = (folder / name).read_text(encoding="utf-8")
            bad += [f"{name} has no {word}" for word in words if word not in text]
        desk = (folder / "examples" / "huangjiahu-desk.html").read_text(encoding="utf-8")
        if "Huangjiahu" not in desk.partition('id="case">')[2][:2000]:
            bad.append("the desk of an example has no case in it")
        (folder / "index.html").write_text("<a href='nowhere.html'>x</a><a href='docs/limits.html#nothing'>y</a>", encoding="utf-8")
        if len(broken(folder)[1]) - len(wrong) < 2:
            bad.append("a broken link is not found")
        print("\n".join(bad))
        return 1 if bad or len(pages) < 80 else 0


if __name__ == "__main__":
    sys.exit(main())
