"""The documents as a static site that needs no network: every Markdown page as HTML, pictures beside them, one list of
pages at the side of each. Usage: site.py TREE FOLDER. Needs cmark-gfm (package cmark-gfm)."""
import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

STYLE = """:root{color-scheme:light dark}body{font:16px/1.55 system-ui,sans-serif;margin:0;display:flex;justify-content:center}
nav{flex:0 0 13rem;padding:1.5rem 1rem;font-size:.9em;border-right:1px solid #8884}nav a{display:block;padding:.15rem 0}
nav a[aria-current]{font-weight:600}main{flex:0 1 52rem;min-width:0;padding:1rem 2rem}img{max-width:100%}
pre{overflow-x:auto;padding:.8rem;background:#8881;border-radius:.3rem}code{font-size:.92em}
table{border-collapse:collapse;display:block;overflow-x:auto}td,th{border:1px solid #8885;padding:.25rem .6rem;text-align:left}
@media(max-width:50rem){body{display:block}nav{border:0;columns:2}}"""
LINK = re.compile(r'(href|src)="([^"#:]+)(#[^"]*)?"')
HEADING = re.compile(r"<h([1-6])>(.*?)</h\1>", re.S)


def pages_of(tree):
    first = [tree / "README.md", tree / "CHANGELOG.md"]
    return first + sorted((tree / "docs").glob("*.md")) + sorted((tree / "docs" / "model").glob("*.md"))


def title_of(page):
    head = next(line for line in page.read_text(encoding="utf-8").split("\n") if line.startswith("# "))
    return head[2:].strip().replace("`", "")


def anchored(body):
    """Headings with the names by which links of Markdown find them."""
    def name(match):
        words = html.unescape(re.sub(r"<[^>]+>", "", match[2])).lower()
        words = re.sub(r"[^\w\- ]", "", words).strip().replace(" ", "-")
        return f'<h{match[1]} id="{html.escape(words)}">{match[2]}</h{match[1]}>'
    return HEADING.sub(name, body)


def place(tree, page):
    path = page.relative_to(tree)
    return pathlib.Path("index.html") if path.name == "README.md" and len(path.parts) == 1 else path.with_suffix(".html")


def render(tree, folder, pages, page):
    """The HTML of one page, and what it shows or links to of the tree that is no page."""
    to, others = place(tree, page), set()

    def link(match):
        target = (page.parent / match[2]).resolve()
        if target in pages:
            path = place(tree, target)
        else:
            path = target.relative_to(tree) if target.is_relative_to(tree) else None
            if path is None or not target.exists():
                raise ValueError(f"{page}: nothing is at {match[2]}")
            others.add(path)
        return f'{match[1]}="{os.path.relpath(path, to.parent)}{match[3] or ""}"'

    body = subprocess.run(["cmark-gfm", "--unsafe", "-e", "table", "-e", "strikethrough", "-e", "autolink", page],
                          check=True, capture_output=True, text=True).stdout
    body = anchored(LINK.sub(link, body))
    entries = "".join(f'<a href="{os.path.relpath(place(tree, p), to.parent)}"{" aria-current=page" if p == page else ""}>'
                      f"{html.escape(title_of(p))}</a>" for p in pages)
    text = (f'<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            f"<title>{html.escape(title_of(page))}</title><style>{STYLE}</style><nav>{entries}</nav><main>{body}</main></html>\n")
    (folder / to).parent.mkdir(parents=True, exist_ok=True)
    (folder / to).write_text(text, encoding="utf-8")
    return others


def main():
    tree, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    pages, others = pages_of(tree), set()
    for page in pages:
        others |= render(tree, folder, pages, page)
    for path in others:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        if (tree / path).is_dir():
            shutil.copytree(tree / path, folder / path, dirs_exist_ok=True)
        else:
            shutil.copy(tree / path, folder / path)
    print(f"{len(pages)} pages in {folder / 'index.html'}")


if __name__ == "__main__":
    main()
