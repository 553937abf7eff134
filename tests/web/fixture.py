#!/usr/bin/env python3
"""The page's data from results folders, and a page with them, without the program: for work on the page, and for its tests.

Usage: python3 tests/web/fixture.py DIR... -o OUT.json [--html OUT.html]

It has what the CSV files, summary.json and results.h5 (with h5py) say, and what else the page can show is made up from these: the route is
the chain at rest, rollers hang below it. What `hawser report` writes is made from the scene itself. With --html the JSON and web/dist become one page.
"""
import argparse
import csv
import json
import sys
from pathlib import Path

WEB = Path(__file__).resolve().parents[2] / "web"
POLICY = ("default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; worker-src blob:; "
          "base-uri 'none'; form-action 'none'")


def value(text):
    """A cell: a number, None if it is empty, or a text."""
    if text == "":
        return None
    try:
        return float(text)
    except ValueError:
        return text[1:] if text[:1] == "'" else text


def table(path):
    """Columns of a CSV file; None if there is none."""
    if not path.exists():
        return None
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file))
    return {name: [value(row[i]) if name != "name" else row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}


def theory_along(stations):
    """Both theories where the stations are; backward is not in the files."""
    if not stations or not stations["s_m"]:
        return None
    order = sorted(range(len(stations["s_m"])), key=lambda i: stations["s_m"][i])
    return {"s_m": [stations["s_m"][i] for i in order], "forward_N": [stations["reference_N"][i] for i in order],
            "paper_N": [stations["paper_N"][i] for i in order]}


def round_to(number, digits):
    return None if number != number else float(f"{number:.{digits}g}")


def shape(folder, rollers, series):
    """Geometry and envelope from results.h5: the chain at rest as the route, tension by place over all states."""
    try:
        import h5py
        import numpy
    except ImportError:
        return None, None
    if not (folder / "results.h5").exists():
        return None, None
    with h5py.File(folder / "results.h5", "r", locking=False) as file:
        position, tension = file["position"][:], file["tension"][:]
    head0 = series["head_at_m"][0] if series and "head_at_m" in series else None
    start = position[0]
    arc = numpy.concatenate([[0], numpy.cumsum(numpy.linalg.norm(numpy.diff(start, axis=0), axis=1))])
    s = arc - arc[-1] + (head0 or 0) + (arc[-1] - arc[int(len(arc) * 0.8)] if head0 else 0)
    keep = numpy.flatnonzero(s >= -5)[:: max(1, len(s) // 300)]
    route = {"s_m": [round_to(float(x), 8) for x in s[keep]], "position_m": [[round(float(c), 4) for c in p] for p in start[keep]],
             "curvature_per_m": [0.0 for _ in keep]}
    placed = [(n, x) for n, x in zip(rollers["name"], rollers["s_m"]) if x is not None] if rollers else []
    geometry = {"origin_m": [0, 0, 0], "up": [0, 0, 1], "route": route, "surfaces": [], "conveyors": [], "reel": None,
                "winch": {"position_m": [float(c) for c in start[-1]], "direction": [1, 0, 0]},
                "rollers": [{"name": n, "s_m": x, "kind": "roller", "axis": [0, 1, 0], "radius_m": 0.06, "width_m": 0.4, "rating_N": None,
                             "position_m": [float(numpy.interp(x, s, start[:, c])) - (0.1 if c == 2 else 0) for c in range(3)]}
                            for n, x in placed]}
    grid = numpy.linspace(max(0.0, s[0]), s[-1], 150)
    at = numpy.array([numpy.interp(grid, s, row[1:]) for row in tension])
    envelope = {"s_m": [round_to(float(x), 7) for x in grid]}
    for name, least in (("tension_min_N", at.min(0)), ("tension_mean_N", at.mean(0)), ("tension_max_N", at.max(0))):
        envelope[name] = [round_to(float(x), 6) for x in least]
    return geometry, {"place": envelope}


def run(folder):
    """The data of one results folder."""
    with open(folder / "summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    stations, rollers, series = (table(folder / f"{name}.csv") for name in ("stations", "rollers", "series"))
    geometry, envelope = shape(folder, rollers, series)
    return {"label": folder.name, "summary": summary, "stations": stations, "rollers": rollers, "series": series,
            "inputs": (table_rows(folder / "inputs.csv")), "theory_along": theory_along(stations), "geometry": geometry,
            "envelope": envelope, "chain": None, "states": None}


def table_rows(path):
    """A CSV file as a list of objects; None if there is none."""
    if not path.exists():
        return None
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def page(text):
    """One HTML file of the data and the bundle."""
    escaped = text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
    escaped = escaped.replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")
    return (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="{POLICY}">'
            '<meta name="viewport" content="width=device-width, initial-scale=1"><title>hawser</title>'
            f'<style>{(WEB / "dist/report.css").read_text()}</style></head><body><main id="hawser"></main>'
            f'<script type="application/json" id="hawser-data">{escaped}</script>'
            f'<script>{(WEB / "dist/report.js").read_text()}</script></body></html>\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", metavar="DIR", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    parser.add_argument("--html", type=Path)
    args = parser.parse_args()
    runs = [run(folder) for folder in args.folders]
    text = json.dumps({"format": 1, "hawser": runs[0]["summary"].get("version", ""), "runs": runs}, separators=(",", ":"), ensure_ascii=False)
    if args.output:
        args.output.write_text(text + "\n", encoding="utf-8")
    if args.html:
        args.html.write_text(page(text), encoding="utf-8")
    if not (args.output or args.html):
        sys.stdout.write(text + "\n")


if __name__ == "__main__":
    main()
