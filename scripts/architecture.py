#!/usr/bin/env python3
"""Draws docs/img/architecture.svg: the folders of docs/architecture.md's table as they include each other.

Usage: architecture.py ROOT [--check]
A band for every folder at the top, in the table's order; in it a box for every sub-folder with what the table says, to the right of
all that it includes within the band; an arrow for each include that no longer way stands for.
--check changes nothing, and fails if the picture is another one. Either complains about a table whose folders are not those of the
tree, and about a folder that includes one above it in the table.
"""
import os
import re
import sys
import textwrap

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "house"))
import tree  # noqa: E402

TOGETHER = {("linsolve/block", "linsolve")}  # a part and its contract: includes go both ways, between files without a circle
ROW = re.compile(r"^\| `([\w/]+)/` \| (.*) \|$", re.M)
BOX, GAP, LINE, LEFT, TOP = 150, 22, 14, 92, 10  # px
STYLE = """
  text { font: 11px sans-serif; fill: #1f2328 } .name { font-weight: bold } .top { font: bold 14px sans-serif }
  .band { fill: #f3f4f6 } .box { fill: #ffffff; stroke: #8b949e } .arrow { stroke: #57606a; fill: none } .tip { fill: #57606a }
  .page { fill: #ffffff }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3 } .band { fill: #1c2128 } .box { fill: #2d333b; stroke: #768390 } .arrow { stroke: #adbac7 }
    .tip { fill: #adbac7 } .page { fill: #0d1117 } }
"""


def folders_of(root):
    """Folders with sources, and {folder: folders that it includes}."""
    links = {}
    for path in tree.sources(root, tree.BELOW):
        mine = links.setdefault(os.path.dirname(path), set())
        for _, quoted, name in tree.includes(tree.read(root, path)):
            if quoted or name.startswith("hawser/"):
                mine.add(os.path.dirname("include/" + name if name.startswith("hawser/") else name))
    return {a: {b for b in to if b != a} for a, to in links.items()}


def columns_of(links, order):
    """{folder: its column, 0 on the left}. What includes nothing in the band stands next to who includes it."""
    depth = {}
    for folder in reversed(order):  # what is included stands lower in the table
        depth[folder] = max((1 + depth[b] for b in links[folder] if b in depth), default=0)
    for folder in order:
        users = [depth[a] for a in order if folder in links[a] and depth[a] > depth[folder]]
        if not links[folder]:
            depth[folder] = min(users, default=1) - 1
    return depth


def reached(links, start, without):
    """Whether `without` is reached from `start` by way of another folder."""
    todo, seen = [b for b in links[start] if b != without], set()
    while todo:
        at = todo.pop()
        if at == without:
            return True
        if at not in seen and at in links and start != at:
            seen.add(at)
            todo += links[at]
    return False


def band(top, rows, links, y):
    """A band's elements and its height."""
    order = [folder for folder, _ in rows]
    mine = {a: {b for b in links.get(a, ()) if b in order} for a in order}
    depth = columns_of(mine, order)
    lines = {folder: textwrap.wrap(text.replace("`", ""), 24) for folder, text in rows}
    height = {folder: (len(lines[folder]) + 1) * LINE + 12 for folder in order}
    columns = [[f for f in reversed(order) if depth[f] == column] for column in range(1 + max(depth.values()))]
    tall = max(sum(height[f] for f in column) + GAP * (len(column) - 1) for column in columns) + 2 * TOP
    place, shapes, arrows = {}, [], []
    for number, column in enumerate(columns):
        at = y + (tall - sum(height[f] for f in column) - GAP * (len(column) - 1)) / 2
        for folder in column:
            place[folder] = (LEFT + number * (BOX + GAP + 6), at)
            at += height[folder] + GAP
    for folder in order:
        x, at = place[folder]
        shapes.append(f'<rect class="box" x="{x}" y="{at:g}" width="{BOX}" height="{height[folder]}" rx="4"/>')
        shapes.append(f'<text class="name" x="{x + 7}" y="{at + LINE + 3:g}">{folder}/</text>')
        shapes += [f'<text x="{x + 7}" y="{at + LINE * (k + 2) + 3:g}">{line}</text>' for k, line in enumerate(lines[folder])]
    for a in order:
        for b in sorted(mine[a]):
            if depth[b] < depth[a] and not reached(mine, a, b):
                x0, y0 = place[a][0], place[a][1] + height[a] / 2
                x1, y1 = place[b][0] + BOX, place[b][1] + height[b] / 2
                bend = (x0 - x1) / 2
                arrows.append(f'<path class="arrow" d="M{x0} {y0:g}C{x0 - bend:g} {y0:g} {x1 + bend:g} {y1:g} {x1 + 6} {y1:g}"/>')
                arrows.append(f'<path class="tip" d="M{x1} {y1:g}l7 -3.5v7z"/>')
    label = f'<text class="top" x="14" y="{y + tall / 2 + 5:g}">{top}</text>'
    return [label, *arrows, *shapes], tall, LEFT + len(columns) * (BOX + GAP + 6)


def draw(rows, links):
    """The picture's text."""
    tops, y, shapes, bands, width = list(dict.fromkeys(folder.split("/")[0] for folder, _ in rows)), TOP, [], [], 0
    for top in tops:
        found, tall, right = band(top, [row for row in rows if row[0].split("/")[0] == top], links, y)
        shapes += found
        bands.append((y, tall))
        width = max(width, right)
        y += tall + 6
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{y:g}" viewBox="0 0 {width} {y:g}">\n'
            f'<style>{STYLE}</style>\n<rect class="page" width="{width}" height="{y:g}"/>')
    back = [f'<rect class="band" x="4" y="{at:g}" width="{width - 8}" height="{tall:g}" rx="6"/>' for at, tall in bands]
    return "\n".join([head, *back, *shapes, "</svg>"]) + "\n"


def check(root, write):
    """Complaints; `write` draws the picture where there are none."""
    rows = ROW.findall(tree.read(root, "docs/architecture.md"))
    links = folders_of(root)
    told = [folder for folder, _ in rows]
    complaints = [f"docs/architecture.md: {f}/ is missing from the table" for f in sorted(set(links) - set(told))]
    complaints += [f"docs/architecture.md: {f}/ is not a folder with sources" for f in told if f not in links]
    complaints += [f"docs/architecture.md: {a}/ includes {b}/, which the table has above it"
                   for a in told for b in sorted(links.get(a, ()))
                   if b in told and told.index(b) < told.index(a) and (a, b) not in TOGETHER]
    if not complaints:
        picture = draw(rows, links)
        path = os.path.join(root, "docs/img/architecture.svg")
        if write:
            with open(path, "w", encoding="utf-8") as file:
                file.write(picture)
        elif not os.path.exists(path) or tree.read(root, path) != picture:
            complaints.append("docs/img/architecture.svg: draw it again: python3 scripts/architecture.py .")
    return complaints


if __name__ == "__main__":
    sys.exit(tree.report("architecture", check(sys.argv[1], sys.argv[2:] != ["--check"])))
