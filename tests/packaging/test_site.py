"""Every page of the site is well-formed enough to be parsed, and every link and anchor in it leads somewhere."""
import html.parser
import pathlib
import shutil
import subprocess
import sys
import tempfile


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.names = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for key, value in attrs:
            if key in ("href", "src"):
                self.links.append(value)
            if key in ("id", "name"):
                self.names.add(value)


def main():
    if not shutil.which("cmark-gfm"):
        print("skipped: there is no cmark-gfm")
        return 77
    tree = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as work:
        subprocess.run([sys.executable, "-B", tree / "packaging" / "site.py", tree, work], check=True)
        pages = {p: Page(p.read_text(encoding="utf-8")) for p in pathlib.Path(work).resolve().rglob("*.html")}
        bad = []
        for path, page in pages.items():
            for link in page.links:
                if ":" in link:
                    continue
                file, _, anchor = link.partition("#")
                target = (path.parent / file).resolve() if file else path
                if not target.exists() or (anchor and target in pages and anchor not in pages[target].names):
                    bad.append(f"{path.name}: {link}")
        print("\n".join(bad))
        return 1 if bad or len(pages) < 40 else 0


if __name__ == "__main__":
    sys.exit(main())
