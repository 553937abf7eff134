"""A table as a picture: rows of cells with a colour each, as SVG with the standard library alone."""
import math
import os
import sys
from html import escape

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scripts"))
from svgplot import text  # noqa: E402

LEFT, TOP, CELL, HEIGHT = 150, 58, 72, 30
# From few to many: light blue over yellow to red.
SCALE = ((222, 235, 247), (158, 202, 225), (254, 227, 145), (254, 153, 41), (204, 76, 2))
MARKS = {"ok": "", "reported": "reported", "missed": "MISSED", "failed": "FAILED"}
EDGES = {"ok": "#ffffff", "reported": "#7040a0", "missed": "#c03030", "failed": "#c03030"}


def colour(value, low, high):
    """The colour of a value on a logarithmic scale from `low` to `high`."""
    if not (value > 0):
        return "#eeeeee"
    share = min(max((math.log(value) - math.log(low)) / (math.log(high) - math.log(low)), 0), 1) * (len(SCALE) - 1)
    first = min(int(share), len(SCALE) - 2)
    mixed = [a + (share - first) * (b - a) for a, b in zip(SCALE[first], SCALE[first + 1])]
    return "#" + "".join(f"{round(part):02x}" for part in mixed)


def short(value):
    """A number in a cell: three figures at most."""
    return f"{value:.0f}" if 1 <= value < 1e4 else f"{value:.2g}"


def draw_cell(x, y, cell, ends):
    """One cell: `label` above; below it the number, or how it ended if not well; `words` for who points at it."""
    edge, width = EDGES[cell["outcome"]], 1 if cell["outcome"] == "ok" else 3
    below = MARKS[cell["outcome"]] or short(cell["number"])
    return [f'<g><title>{escape(cell["words"])}</title>',
            f'<rect x="{x + width / 2}" y="{y + width / 2}" width="{CELL - width}" height="{HEIGHT - width}" '
            f'fill="{colour(cell["number"], *ends)}" stroke="{edge}" stroke-width="{width}"/>',
            text(x + CELL / 2, y + 12, cell["label"], size=10), text(x + CELL / 2, y + 25, below, size=10), "</g>"]


def draw_scale(y, ends, unit):
    """What the colours mean."""
    out, count = [text(LEFT, y + 12, unit, "start", 11)], 7
    x = LEFT + 6.3 * len(unit) + 10
    for k in range(count):
        value = ends[0] * (ends[1] / ends[0]) ** (k / (count - 1))
        out.append(f'<rect x="{x + 48 * k:.1f}" y="{y}" width="46" height="16" fill="{colour(value, *ends)}"/>')
        out.append(text(x + 48 * k + 23, y + 12, short(value), size=10))
    return out


def write_heatmap(path, title, unit, rows, ends):
    """rows: (name, cells), a cell a dict with label, number, outcome (a key of MARKS) and words; ends of the scale."""
    width = LEFT + CELL * max(len(cells) for _, cells in rows) + 10
    height = TOP + HEIGHT * len(rows) + 10
    body = [text(10, 20, title, "start", 14), *draw_scale(30, ends, unit)]
    for k, (name, cells) in enumerate(rows):
        y = TOP + HEIGHT * k
        body.append(text(LEFT - 8, y + 19, name, "end", 11))
        for c, cell in enumerate(cells):
            body += draw_cell(LEFT + CELL * c, y, cell, ends)
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
            'font-family="sans-serif" fill="#222222">')
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([head, f'<rect width="{width}" height="{height}" fill="#ffffff"/>', *body, "</svg>"]) + "\n")
