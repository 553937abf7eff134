#!/usr/bin/env python3
"""Writes what `hawser validate --format csv` printed into a document, between the markers `variants` (the paper's case and
its variants, one a line) and `results` (every quantity of every case), and draws the errors of the cases of convergence
into img/convergence.svg beside it.

Usage: validation_tables.py RESULTS.csv DOCUMENT
"""
import csv
import math
import os
import sys

from document import replace_in_file

CAUSES = [
    ("paper", "as it is: the solid bar of table 1"),
    ("paper-real-cable", "bending stiffness of a real cable, EI / 20"),
    ("paper-limp", "next to no bending stiffness, EI / 200"),
    ("paper-limp-rollers", "EI / 200, and a roller every 0.5 m"),
    ("paper-onward", "EI / 200, and a roller every 0.5 m all the way to the winch"),
    ("paper-segments-2", "discretisation: segments of 0.25 m"),
    ("paper-segments-4", "discretisation: segments of 0.125 m"),
    ("paper-accuracy", "time integration: accuracy 1e-5 in place of 1e-3"),
    ("paper-friction", "friction regularised over 0.1 mm/s in place of 1 mm/s"),
    ("paper-rollers", "a roller every 0.5 m in place of 1.9 m"),
    ("paper-contacts", "contacts ten times as stiff"),
    ("paper-capsules", "contact line of straight segments"),
    ("paper-all", "limp, fine, tight, sharp and on many rollers at once"),
]


def number(text, digits=6):
    """A number for people; what is not known stays a dash."""
    return f"{float(text):.{digits}g}" if text else "-"


def percent(row):
    return f"{float(row['error']):.2f}" if row["error"] else "-"


def paper_table(rows):
    """One line a variant: the largest and the mean error of the tensions, and the winch's force."""
    found = {(r["case"], r["quantity"]): r for r in rows}
    yield "| changed | largest error, % | mean error, % | winch force, N | against the theory, % |"
    yield "|---|---|---|---|---|"
    for name, what in CAUSES:
        largest, mean, pull = (found.get((name, q)) for q in
                               ("largest tension error", "mean tension error", "winch force"))
        if not pull:
            continue
        yield f"| {what} | {percent(largest)} | {percent(mean)} | {float(pull['found']):.2f} | {percent(pull)} |"


def result_table(rows):
    yield "| case | quantity | expected | found | error | tolerance | | source |"
    yield "|---|---|---|---|---|---|---|---|"
    for r in rows:
        unit = r["unit"] if r["unit"] != "1" else ""
        of = r["in"] if r["in"] != "1" else ""
        error = f"{number(r['error'], 2)} {of}".strip() if r["error"] else "-"
        limit = f"{number(r['tolerance'], 3)} {of}".strip() if r["tolerance"] else "-"
        yield (f"| {r['case']} | {r['quantity']}{', ' + unit if unit else ''} | {number(r['expected'])} | "
               f"{number(r['found'])} | {error} | {limit} | {r['verdict'].lstrip(chr(39))} | {r['source']} |")


def refinements(rows):
    """{case: [(what was refined, error in %)]} of the cases of convergence."""
    found = {}
    for r in rows:
        if r["case"].startswith("convergence-") and r["quantity"].startswith("error at"):
            found.setdefault(r["case"], []).append((float(r["quantity"].split()[-1]), float(r["found"])))
    return found


def plot(series, names, label, left):
    """One panel: errors over x, both logarithmic, 240 pixels wide, with a line a decade."""
    colours = ("#0b5394", "#b45f06", "#38761d", "#741b47", "#666666", "#cc0000")
    xs, ys = zip(*(p for name in names for p in series.get(name, [])))
    x0, x1 = math.floor(math.log10(min(xs))), math.ceil(math.log10(max(xs)))
    y0, y1 = math.floor(math.log10(min(ys))), math.ceil(math.log10(max(ys)))

    def place(x, y):
        return (left + 240 * (math.log10(x) - x0) / (x1 - x0), 230 - 210 * (math.log10(y) - y0) / (y1 - y0))
    for e in range(y0, y1 + 1):
        y = place(10.0 ** x0, 10.0 ** e)[1]
        yield f'<path d="M{left} {y:.1f}h240" stroke="#ccc"/>'
        yield f'<text x="{left - 4}" y="{y + 4:.1f}" text-anchor="end">1e{e} %</text>'
    for e in range(x0, x1 + 1):
        x = place(10.0 ** e, 10.0 ** y0)[0]
        yield f'<path d="M{x:.1f} 20v210" stroke="#ccc"/><text x="{x:.1f}" y="246" text-anchor="middle">1e{e}</text>'
    yield f'<text x="{left + 120}" y="262" text-anchor="middle">{label}</text>'
    for i, name in enumerate(names):
        points = [place(x, y) for x, y in series.get(name, [])]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        yield f'<path d="M{path}" fill="none" stroke="{colours[i % 6]}" stroke-width="1.5"/>'
        yield from (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colours[i % 6]}"/>' for x, y in points)
        yield f'<text x="{left + 236}" y="{196 + 12 * i - 12 * len(names) + 30}" text-anchor="end" ' \
              f'fill="{colours[i % 6]}">{name.removeprefix("convergence-")}</text>'


def draw(path, rows):
    """Errors over segment lengths, and over the integrator's accuracy."""
    series = refinements(rows)
    lengths = [name for name in series if name != "convergence-accuracy"]
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" width="660" height="270" font-family="sans-serif" font-size="11">',
             '<rect width="660" height="270" fill="white"/>']
    lines += plot(series, lengths, "segment length over the rod's", 60)
    lines += plot(series, ["convergence-accuracy"], "accuracy", 400)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines + ["</svg>"]) + "\n")


def main(results, document):
    with open(results, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    outside = sum(r["verdict"] == "OUTSIDE" for r in rows)
    cases = len({r["case"] for r in rows})
    replace_in_file(document, {
        "variants": "\n".join(paper_table(rows)),
        "results": "\n".join([f"{cases} cases, {len(rows)} quantities, {outside} outside their tolerance.", "",
                              *result_table(rows)])})
    draw(os.path.join(os.path.dirname(document), "img", "convergence.svg"), rows)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
