"""Plots as SVG with the standard library alone: panels below each other, each with lines, marks and a legend.

The same data give the same bytes, so that a picture that is kept under version control changes only with its data.
"""
import math
from html import escape

WIDTH, LEFT, RIGHT, TOP, GAP = 760, 70, 16, 34, 44  # of the picture and its margins, in pixels
COLOURS = ("#0060b0", "#c03030", "#2a8a3a", "#b08000", "#7040a0", "#333333", "#0aa0a0", "#d06090")


class Panel:
    """One pair of axes. `add` a line or marks; values that are not finite leave gaps.

    On a logarithmic axis those that are not above 0 do too. log: "", "x", "y" or "xy", the axes that are logarithmic. Series
    without a label are not in the legend.
    """

    def __init__(self, xlabel, ylabel, height=230, bottom=None, top=None, log=""):
        self.xlabel, self.ylabel, self.height = xlabel, ylabel, height
        self.log = log
        self.bottom, self.top = (None if end is None else self.scaled((1, end))[1] for end in (bottom, top))  # of the y axis
        self.series = []

    def scaled(self, point):
        """A point in the axes' own coordinates: decades where they are logarithmic."""
        return tuple(decades(value) if axis in self.log else value for axis, value in zip("xy", point))

    def add(self, label, x, y, colour=None, marks=False, dash=""):
        colour = colour or COLOURS[len(self.series) % len(COLOURS)]
        points = [self.scaled((a, b)) for a, b in zip(x, y)]
        self.series.append((label, points, colour, marks, dash))
        return self

    def level(self, label, value, colour="#888888"):
        """A dashed line over the whole width."""
        xs = [p[0] for _, points, *_ in self.series for p in points if math.isfinite(p[0])] or [0, 1]
        xs = [10**x for x in xs] if "x" in self.log else xs
        return self.add(label, [min(xs), max(xs)], [value, value], colour, dash="6 3")

    def ends(self):
        """Smallest and largest x and y that are shown, with a little room above and below."""
        known = [p for _, points, *_ in self.series for p in points if math.isfinite(p[0]) and math.isfinite(p[1])]
        xs, ys = [p[0] for p in known] or [0, 1], [p[1] for p in known] or [0, 1]
        room = 0.06 * (max(ys) - min(ys) or abs(max(ys)) or 1)
        low = min(ys) - room if self.bottom is None else self.bottom
        high = max(ys) + room if self.top is None else self.top
        return min(xs), max(xs) if max(xs) > min(xs) else min(xs) + 1, low, high


def decades(value):
    """log10 of it; not a number where there is none."""
    return math.log10(value) if value > 0 else math.nan


def marked(low, high, log, wanted=6):
    """(place, label) of an axis' ticks: round numbers, or on a logarithmic axis decades and, if these are few, 2 and 5."""
    if not log:
        return [(value, f"{value:.6g}") for value in ticks(low, high, wanted)]
    step = max(1, round((high - low) / (2 * wanted)))
    places = [k for k in range(math.ceil(low - 1e-9), math.floor(high + 1e-9) + 1) if k % step == 0]
    if high - low < 3:
        places = sorted(places + [k + math.log10(m) for k in range(math.floor(low), math.ceil(high)) for m in (2, 5)])
    return [(place, f"{10**place:.6g}") for place in places if low - 1e-9 <= place <= high + 1e-9]


def ticks(low, high, wanted=6):
    """Round numbers between two ends."""
    raw = (high - low) / wanted
    power = 10 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, math.floor(high / step + 1e-9) + 1)]


def text(x, y, words, anchor="middle", size=12, extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}"{extra}>{escape(words)}</text>'


def thin(points, limit=900):
    """Not more points than can be seen: of every group the lowest and the highest, in their order."""
    if len(points) <= limit:
        return points
    size, kept = math.ceil(2 * len(points) / limit), []
    for k in range(0, len(points), size):
        group = points[k:k + size]
        known = [p for p in group if math.isfinite(p[1])] or group
        pair = {known.index(min(known, key=lambda p: p[1])), known.index(max(known, key=lambda p: p[1]))}
        kept += [known[i] for i in sorted(pair)]
    return kept


def draw_series(series, place):
    """A line with gaps where values are not known, or a mark for each value."""
    _, points, colour, marks, dash = series
    out, run = [], []
    for point in (points if marks else thin(points)) + [(math.nan, math.nan)]:
        if math.isfinite(point[0]) and math.isfinite(point[1]):
            run.append(place(point))
            continue
        if marks:
            out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.8" fill="{colour}"/>' for x, y in run]
        elif run:
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in run)
            style = f' stroke-dasharray="{dash}"' if dash else ""
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.3"{style}/>')
        run = []
    return out


def draw_legend(panel, y):
    """Above the axes, in one row that breaks where it is full."""
    out, x = [], LEFT
    for label, _, colour, marks, dash in panel.series:
        if not label:
            continue
        length = 30 + 6.3 * len(label)
        if x + length > WIDTH - RIGHT and x > LEFT:
            x, y = LEFT, y + 15
        if marks:
            out.append(f'<circle cx="{x + 9:.1f}" cy="{y - 4:.1f}" r="2.8" fill="{colour}"/>')
        else:
            style = f' stroke-dasharray="{dash}"' if dash else ""
            out.append(f'<line x1="{x:.1f}" y1="{y - 4:.1f}" x2="{x + 18:.1f}" y2="{y - 4:.1f}" stroke="{colour}" '
                       f'stroke-width="1.6"{style}/>')
        out.append(text(x + 22, y, label, "start", 11))
        x += length
    return out, y


def draw_panel(panel, y0):
    """The panel's elements with its upper edge at y0; and where its lower edge is."""
    legend, y = draw_legend(panel, y0 + 12)
    x_low, x_high, y_low, y_high = panel.ends()
    upper, lower = y + 10, y + 10 + panel.height

    def place(point):
        x = LEFT + (point[0] - x_low) / (x_high - x_low) * (WIDTH - LEFT - RIGHT)
        share = (point[1] - y_low) / (y_high - y_low)
        return x, lower - min(max(share, 0), 1) * panel.height

    out = legend
    for value, label in marked(y_low, y_high, "y" in panel.log):
        _, height = place((x_low, value))
        out.append(f'<line x1="{LEFT}" y1="{height:.1f}" x2="{WIDTH - RIGHT}" y2="{height:.1f}" stroke="#dddddd"/>')
        out.append(text(LEFT - 6, height + 4, label, "end", 11))
    for value, label in marked(x_low, x_high, "x" in panel.log, 10):
        across, _ = place((value, y_low))
        out.append(f'<line x1="{across:.1f}" y1="{lower}" x2="{across:.1f}" y2="{lower + 4}" stroke="#333333"/>')
        out_there = across + 3.2 * len(label) > WIDTH  # half of a label that would leave the picture
        out.append(text(WIDTH - 2 if out_there else across, lower + 16, label, "end" if out_there else "middle", 11))
    out.append(f'<path d="M{LEFT} {upper}V{lower}H{WIDTH - RIGHT}" fill="none" stroke="#333333"/>')
    for series in panel.series:
        out += draw_series(series, place)
    middle = (upper + lower) / 2
    out.append(text(18, middle, panel.ylabel, extra=f' transform="rotate(-90 18 {middle:.1f})"'))
    out.append(text((LEFT + WIDTH - RIGHT) / 2, lower + 32, panel.xlabel))
    return out, lower + GAP


def write_svg(path, title, panels):
    """The picture of all panels."""
    body, y = [text(LEFT, 20, title, "start", 14)], TOP
    for panel in panels:
        elements, y = draw_panel(panel, y)
        body += elements
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{y:.0f}" viewBox="0 0 {WIDTH} {y:.0f}" '
            'font-family="sans-serif" fill="#222222">')
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join([head, f'<rect width="{WIDTH}" height="{y:.0f}" fill="#ffffff"/>', *body, "</svg>"]) + "\n")
