#!/usr/bin/env python3
"""Figures 7-13 and tables 2-3 of the paper from runs of hawser, as CSV and SVG, and the experiments beside them.

Usage: python3 scripts/figures.py --hawser PROGRAM [--out DIR] [--document FILE] [--quick]

Runs cases/huangjiahu.yaml and variants of it (figures_runs.py), writes fig07..fig13 into DIR (default docs/figures), and
the tables between the marks of FILE (docs/paper.md). --quick: one run, pictures only. Standard library only.
"""
import argparse
import bisect
import csv
import math
import os
import tempfile

from document import replace_in_file
from figures_runs import EXPERIMENTS, FIGURE_RUNS, ROPE, SECTIONS, WATCHED, run_case
from svgplot import Panel, write_svg

ALLOWABLE = 70 * 800  # N: the paper's eq. 11 and table 4, K = 1, a copper conductor of 800 mm2 on a pulling head
SEGMENT, EYE = 0.5, 305  # m; the first segment of rope
PULLEYS = ("P32", "P31", "P30", "P29")  # the paper's No. 1-4, from right to left
TABLE_2 = ((1, 12200.36, 5.4), (9, 12290.10, 4.7), (17, 12590.64, 2.4), (89, 12770.32, 1.1), (121, 13000.25, 0.8),
           (197, 13100.22, 1.5), (237, 13150.98, 1.9), (379, 13440.74, 4.2))
PAPER_TOTAL = 12903.21
TABLE_3 = (("Reference [4] of the paper", "3.89", "-"), ("Reference [5]", "3.21", "8.9"),
           ("Reference [7]", "3.18", "6.3"), ("The paper", "2.75", "5.4"))


def kilo(values):
    return [value / 1e3 for value in values]


def write_csv(path, columns):
    """Columns {name: values} of equal length; six digits, and an empty cell for what is not known."""
    def cell(value):
        if isinstance(value, str):
            return value
        return f"{value:.6g}" if math.isfinite(value) else ""

    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([[cell(v) for v in row] for row in zip(*columns.values())])


def at(x, y, where):
    """y at `where` between rising x; the nearest end's outside."""
    k = bisect.bisect_left(x, where)
    if k == 0 or k == len(x):
        return y[min(k, len(x) - 1)]
    return y[k - 1] + (y[k] - y[k - 1]) * (where - x[k - 1]) / (x[k] - x[k - 1])


def mean_over(t, y, start, end):
    """Mean in time between two times, by the trapezoidal rule over the rows there."""
    rows = [k for k in range(len(t)) if start <= t[k] <= end]
    if len(rows) < 2:
        return math.nan
    area = sum((t[b] - t[a]) * (y[a] + y[b]) / 2 for a, b in zip(rows, rows[1:]))
    return area / (t[rows[-1]] - t[rows[0]])


def segment_places(run, segment):
    """Where along the route the segment is, row by row: so far behind the cable's front."""
    behind = (EYE - 0.5 - segment) * SEGMENT
    return [head - behind for head in run.series["head_at_m"]]


def figure_7(runs, out):
    """Axial speeds of rope and cable."""
    s, panels, columns = runs["case"].series, [], {"time_s": runs["case"].series["time_s"]}
    for title, segments in (("rope", ROPE), ("cable", (0, 100, *SECTIONS.values()))):
        panel = Panel("time, s", f"{title}, m/s", bottom=0, top=0.12)
        for k in segments:
            columns[f"{title}_{k}_m_per_s"] = s[f"speed_{k}_m_per_s"]
            panel.add(f"segment {k}", s["time_s"], s[f"speed_{k}_m_per_s"])
        panels.append(panel.add("winch", s["time_s"], s["winch_speed_m_per_s"], "#333333", dash="4 3"))
    if "sudden" in runs:
        late = runs["sudden"].series
        panel = Panel("time, s", "winch at once, m/s")
        for k in (0, SECTIONS["level"], 304, 369):
            panel.add(f"segment {k}", late["time_s"], late[f"speed_{k}_m_per_s"])
        panels.append(panel)
    out("fig07-speeds", "Figure 7: axial speed of rope and cable", panels, columns)


def figure_8(runs, out):
    """Axial tension of the rope and of the cable in the three sections of the route."""
    s, panels, columns = runs["case"].series, [], {"time_s": runs["case"].series["time_s"]}
    sudden = runs["sudden"].series if "sudden" in runs else None
    groups = [("rope", ROPE)] + [(name, (k - 8, k, k + 8)) for name, k in SECTIONS.items()]
    for name, segments in groups:
        panel = Panel("time, s", f"{name}, kN", height=170)
        for k in segments:
            columns[f"{name}_{k}_N"] = s[f"tension_{k}_N"]
            panel.add(f"segment {k}", s["time_s"], kilo(s[f"tension_{k}_N"]))
        if sudden:
            k = segments[1]
            panel.add(f"segment {k}, winch at once", sudden["time_s"], kilo(sudden[f"tension_{k}_N"]), "#aaaaaa")
        panels.append(panel)
    out("fig08-tensions", "Figure 8: axial tension of the rope and of the cable up, level, down", panels, columns)


def figure_9(runs, out):
    """Errors of the stations' mean tension."""
    st = runs["case"].stations
    columns = {"s_m": st["s_m"], "mean_N": st["mean_N"], "paper_N": st["paper_N"], "reference_N": st["reference_N"],
               "error_paper_pct": st["error_paper_pct"], "error_reference_pct": st["error_reference_pct"]}
    panel = Panel("position along the route, m", "error of the tension, %")
    panel.add("table 1's EI, against the bend equation", st["s_m"], st["error_reference_pct"])
    panel.add("against the paper's formulas", st["s_m"], st["error_paper_pct"], dash="5 3")
    if "flexible" in runs:
        soft = runs["flexible"].stations
        columns["error_reference_pct_EI_20"] = soft["error_reference_pct"]
        panel.add("EI/20, against the bend equation", soft["s_m"], soft["error_reference_pct"])
    out("fig09-errors", "Figure 9: error of the simulated tension by position", [panel], columns)


def figure_10(runs, out):
    """Tension of the cable just behind the eye while the pull starts, and what it may be."""
    panel, columns = Panel("time, s", "cable behind the eye, kN", height=300, bottom=0), {"time_s": []}
    times = [0.01 * k for k in range(0, 2001)]
    for name, label in (("case", "STEP over 13 s, tail too"), ("step1", "winch 1 s, full tail from the start"),
                        ("sudden", "winch at once, full tail from the start")):
        if name in runs:
            s = runs[name].series
            end = min(20, s["time_s"][-1])
            columns["time_s"] = times
            columns[f"{name}_N"] = [at(s["time_s"], s["tension_304_N"], t) if t <= end else math.nan for t in times]
            panel.add(label, times, kilo(columns[f"{name}_N"]))
    panel.level("allowable, 56 kN", ALLOWABLE / 1e3).level("the paper's peak, 49 kN", 49, "#c03030")
    out("fig10-start", "Figure 10: tension while the pull starts", [panel], columns)


def crossings(run):
    """Every passing of a watched segment over a pulley after the start-up: pulley, segment, time, place, tension in the
    half second around it (mean, largest) and the bend equation's there."""
    s, st, found = run.series, run.stations, []
    for pulley, place in zip(run.rollers["name"], run.rollers["s_m"]):
        for k in WATCHED:
            where = segment_places(run, k)
            t = at(where, s["time_s"], place)
            if not (where[0] < place < where[-1] and t > run.steady_from):
                continue
            near = [s[f"tension_{k}_N"][i] for i, time in enumerate(s["time_s"]) if abs(time - t) <= 0.25]
            found.append((pulley, k, t, place, sum(near) / len(near), max(near), at(st["s_m"], st["reference_N"], place)))
    return sorted(found, key=lambda row: row[3])


def figure_11(runs, out):
    """Tension at the moment at which a segment crosses a pulley, with the smooth contact line and with cylinders."""
    names = ("pulley", "segment", "time_s", "s_m", "mean_N", "largest_N", "reference_N")
    st = runs["case"].stations
    panel = Panel("position along the route, m", "tension, kN", height=260)
    panel.add("bend equation", st["s_m"], kilo(st["reference_N"]), "#333333")
    below = Panel("position along the route, m", "largest / mean")
    columns = {"contact": [], **{name: [] for name in names}, "largest_by_mean": []}
    for label, name in (("smooth line", "fine" if "fine" in runs else "case"), ("cylinders", "cylinders")):
        rows = crossings(runs[name]) if name in runs else []
        columns["contact"] += [label] * len(rows)
        for i, column in enumerate(names):
            columns[column] += [row[i] for row in rows]
        ratio = [row[5] / row[4] for row in rows]
        columns["largest_by_mean"] += ratio
        places = [row[3] for row in rows]
        panel.add(f"on a pulley, {label}", places, [row[5] / 1e3 for row in rows], marks=True)
        below.add(label, places, ratio, ("#c03030" if name == "cylinders" else "#0060b0"), marks=True)
    out("fig11-crossing", "Figure 11: largest tension as a segment crosses a pulley", [panel, below], columns)


def figure_12(runs, out):
    """The ratio alpha of the largest tension to theory, by position."""
    st = runs["case"].stations
    columns, panel = {"s_m": st["s_m"]}, Panel("position along the route, m", "alpha = T_max / T", height=280)
    for name, label in (("case", "STEP over 13 s, tail too"), ("step2", "winch 2 s, full tail"),
                        ("step1", "winch 1 s, full tail"), ("sudden", "winch at once, full tail")):
        if name in runs:
            columns[f"{name}_alpha"] = runs[name].stations["peak_ratio"]
            panel.add(label, st["s_m"], runs[name].stations["peak_ratio"])
    panel.level("the paper: 1.2", 1.2).level("to 1.5", 1.5)
    out("fig12-alpha", "Figure 12: ratio of the largest tension to theory", [panel], columns)


def figure_13(runs, out):
    """Loads of the paper's four pulleys while the cable's front comes over them; without such a run, the case's."""
    run = runs.get("front") or runs["case"]
    columns, panels = {"time_s": run.series["time_s"]}, []
    for number, name in enumerate(PULLEYS, 1):
        load = run.series[f"load_{name}_N"]
        columns[f"{name}_N"] = load
        i = run.rollers["name"].index(name)
        panel = Panel("time, s", f"pulley {number} ({name}), kN", height=140)
        panel.add("load", run.series["time_s"], kilo(load))
        panel.level(f"steady {run.rollers['steady_N'][i] / 1e3:.2f} kN", run.rollers["steady_N"][i] / 1e3)
        panel.level(f"peak {run.rollers['peak_N'][i] / 1e3:.2f} kN", run.rollers["peak_N"][i] / 1e3, "#c03030")
        panels.append(panel)
    out("fig13-pulleys", "Figure 13: loads of the first four pulleys", panels, columns)


def table_rows(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] +
                     ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def table_2(runs):
    """The paper's locations as numbers of segments, from 1 at the tail."""
    run, rows = runs["case"], []
    for location, simulated, error in TABLE_2:
        k = min(location, 370) - 1
        tension = mean_over(run.series["time_s"], run.series[f"tension_{k}_N"], run.steady_from, math.inf)
        place = mean_over(run.series["time_s"], segment_places(run, k), run.steady_from, math.inf)
        theory, here = at(run.stations["s_m"], run.stations["reference_N"], place), f"{place:.1f} m"
        if k >= EYE:  # the rope beyond its drag
            theory, here = run.summary["theory"]["reference_total_N"], "rope at the winch"
        elif place < 0:
            here = "lead-in"
        rows.append((str(location), f"{simulated:,.2f}", f"{error:.1f} %", here, f"{theory:,.0f}", f"{tension:,.0f}",
                     f"{100 * (tension / theory - 1):+.2f} %"))
    return table_rows(("location", "paper: simulated, N", "paper: error", "hawser: where the segment is", "theory there, N",
                       "hawser, N", "error"), rows)


def table_3(runs):
    """Mean and largest error, the paper's and ours."""
    rows = list(TABLE_3)
    for name, label in (("case", "hawser, table 1's EI"), ("flexible", "hawser, EI/20")):
        e = runs[name].summary["tension_error"]
        rows.append((label + ", against the bend equation", f"{e['mean_pct']:.2f}", f"{e['max_pct']:.2f}"))
        rows.append((label + ", against eq. 3-10", f"{e['mean_pct_paper']:.2f}", f"{e['max_pct_paper']:.2f}"))
    return table_rows(("method", "mean error, %", "largest error, %"), rows)


def overload(run, pulley):
    """Steady load and by how much the peak exceeds it; a pulley that the cable hardly touches has no ratio."""
    i = run.rollers["name"].index(pulley)
    steady, peak = run.rollers["steady_N"][i], run.rollers["peak_N"][i]
    return f"{steady:,.0f} +{100 * (peak / steady - 1):.0f} %" if steady > 200 else f"{steady:,.0f}, peak {peak:,.0f}"


JOLT = 0.05  # s: what a winch that starts at once does to the rope's first half bushing is over


def trusted(run):
    """Whether the program trusts its figures, or the conditions that fail."""
    failed = [c["name"] for c in run.summary["trust"] if not c["holds"]]
    return "no: " + ", ".join(failed) if failed else "yes"


def pulls_row(label, run):
    """alpha is the largest of all stations; the drive has its own line in the table because the rope sees it first."""
    pull, st, time = run.summary["pull_force"], run.stations, run.series["time_s"]
    alpha = max(value for value in st["peak_ratio"] if math.isfinite(value))
    behind = max(run.series["tension_304_N"])
    later = max(p for t, p in zip(time, run.series["winch_force_N"]) if t > JOLT)
    return (label, f"{pull['steady_mean_N']:,.0f}", f"{pull['peak_N']:,.0f}", f"{later:,.0f}", f"{behind:,.0f}", f"{alpha:.2f}", trusted(run))


PULLS_HEAD = ("experiment", "steady pull, N", "peak pull, N", "after 0.05 s, N", "peak of the cable behind the eye, N", "alpha", "trusted")


def loads_row(label, run):
    return (label, f"{run.summary['pull_force']['steady_mean_N']:,.0f}", *(overload(run, name) for name in PULLEYS[:3]), trusted(run))


LOADS_HEAD = ("experiment", "steady pull, N", *(f"pulley {i} ({p}), N" for i, p in enumerate(PULLEYS[:3], 1)), "trusted")


def experiments(program, group):
    """Rows of all runs of a group: loads of pulleys where the front crosses them, else pulls."""
    rows, (row, head) = [], (loads_row, LOADS_HEAD) if group == "front" else (pulls_row, PULLS_HEAD)
    for label, settings in EXPERIMENTS[group]:
        with tempfile.TemporaryDirectory() as folder:
            rows.append(row(label, run_case(program, folder, settings)))
    return table_rows(head, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hawser", required=True, metavar="PROGRAM")
    parser.add_argument("--out", default="docs/figures", metavar="DIR")
    parser.add_argument("--document", default="docs/paper.md", metavar="FILE")
    parser.add_argument("--quick", action="store_true", help="one run, pictures only")
    args = parser.parse_args()
    os.makedirs(args.out, exist_ok=True)

    def out(name, title, panels, columns):
        write_csv(os.path.join(args.out, name + ".csv"), columns)
        write_svg(os.path.join(args.out, name + ".svg"), title, panels)
        print(os.path.join(args.out, name + ".svg"))

    runs = {}
    for name, settings in FIGURE_RUNS.items():
        if name == "case" or not args.quick:
            with tempfile.TemporaryDirectory() as folder:
                runs[name] = run_case(args.hawser, folder, settings)
    for figure in (figure_7, figure_8, figure_9, figure_10, figure_11, figure_12, figure_13):
        figure(runs, out)
    if args.quick:
        return
    replace_in_file(args.document, {"table 2": table_2(runs), "table 3": table_3(runs),
                                    **{group: experiments(args.hawser, group) for group in EXPERIMENTS}})


if __name__ == "__main__":
    main()
