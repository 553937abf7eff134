#!/usr/bin/env python3
"""Draws the results of a run: tension along the route, winch force and speeds over time, roller loads.

Usage: python3 scripts/plot.py DIR [-o OUTDIR]

Reads stations.csv, series.csv, rollers.csv and summary.json of a results folder DIR and writes tension, series and rollers
as SVG and PNG into OUTDIR (default: DIR). A file that is missing or empty leaves its picture out. Needs matplotlib only.
"""
import argparse
import math
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)

from results_tables import read_summary, read_table  # noqa: E402

COLOURS = {"paper": "#b08000", "reference": "#333333", "mean": "#0060b0", "peak": "#c03030"}


def save(figure, folder, name):
    """Writes the figure in both formats, the same bytes for the same data, and says so."""
    figure.tight_layout()
    for kind in ("svg", "png"):
        path = os.path.join(folder, f"{name}.{kind}")
        metadata = {"Date": None} if kind == "svg" else None
        figure.savefig(path, dpi=120, metadata=metadata)
        print(path)
    plt.close(figure)


def decorate(axes, xlabel, ylabel):
    axes.set_xlabel(xlabel)
    axes.set_ylabel(ylabel)
    axes.grid(True, alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)


def draw_tension(stations, summary, folder):
    """Tension along the route: both theories, simulated mean and peak; below, the errors of the mean."""
    s = stations["s_m"]
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, height_ratios=(3, 1))
    kilo = {key: [value / 1e3 for value in stations[key]] for key in ("paper_N", "reference_N", "mean_N", "peak_N")}
    top.plot(s, kilo["peak_N"], ".:", color=COLOURS["peak"], label="simulated, peak of the run")
    top.plot(s, kilo["reference_N"], "-", color=COLOURS["reference"], label="reference theory")
    top.plot(s, kilo["paper_N"], "--", color=COLOURS["paper"], label="paper's formulas")
    top.plot(s, kilo["mean_N"], "o", ms=4, color=COLOURS["mean"], label="simulated, steady mean")
    top.set_title(summary.get("title") or "Tension along the route", loc="left")
    decorate(top, "", "tension, kN")
    top.set_ylim(bottom=0)
    top.legend(frameon=False)
    bottom.axhline(0, color="#888888", lw=0.8)
    bottom.plot(s, stations["error_reference_pct"], "o-", ms=3, color=COLOURS["reference"], label="against reference")
    bottom.plot(s, stations["error_paper_pct"], "s--", ms=3, color=COLOURS["paper"], label="against paper")
    decorate(bottom, "position along the route, m", "error, %")
    bottom.legend(frameon=False, ncols=2)
    save(figure, folder, "tension")


def mark_steady(axes, summary):
    """Shades the steady window."""
    window = summary.get("steady_window") or {}
    if window.get("from_s") is not None and window.get("to_s") is not None and window["to_s"] > window["from_s"]:
        axes.axvspan(window["from_s"], window["to_s"], color="#0060b0", alpha=0.06, lw=0)


def draw_series(series, summary, folder):
    """Over time: winch force, tail tension and largest tension; speeds of the winch and of the watched segments."""
    t = series["time_s"]
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(8, 6), sharex=True)
    lines = (("max_tension_N", "largest tension", COLOURS["peak"]), ("winch_force_N", "winch force", COLOURS["mean"]),
             ("tail_tension_N", "tail tension", COLOURS["paper"]))
    for key, label, colour in lines:
        top.plot(t, [value / 1e3 for value in series[key]], lw=1, color=colour, label=label)
    top.set_title(summary.get("title") or "Force and speed over time", loc="left")
    decorate(top, "", "force, kN")
    watched = [key for key in series if key.startswith("speed_")]
    for key in watched:
        bottom.plot(t, series[key], lw=0.8, label="segment " + key.split("_")[1])
    bottom.plot(t, series["winch_speed_m_per_s"], "k--", lw=1, label="winch")
    decorate(bottom, "time, s", "speed, m/s")
    for axes in (top, bottom):
        mark_steady(axes, summary)
        axes.legend(frameon=False, ncols=2, fontsize="small")
    save(figure, folder, "series")


def draw_rollers(rollers, summary, folder):
    """Loads roller by roller, and how far the peak exceeds the steady load."""
    place = [i if math.isnan(s) else s for i, s in enumerate(rollers["s_m"])]
    figure, (top, bottom) = plt.subplots(2, 1, figsize=(8, 6), sharex=True, height_ratios=(2, 1))
    for key, label, colour, mark in (("peak_N", "peak of the run", COLOURS["peak"], "^"),
                                     ("steady_N", "steady mean", COLOURS["mean"], "o"),
                                     ("initial_N", "at rest", COLOURS["paper"], "_")):
        top.plot(place, [value / 1e3 for value in rollers[key]], mark, ms=5, color=colour, label=label)
    top.set_title(summary.get("title") or "Roller loads", loc="left")
    decorate(top, "", "load, kN")
    top.legend(frameon=False)
    bottom.plot(place, rollers["peak_ratio"], "o", ms=4, color=COLOURS["reference"])
    bottom.axhline(1.6, color=COLOURS["peak"], lw=0.8, ls=":")
    decorate(bottom, "position along the route, m", "peak / steady")
    save(figure, folder, "rollers")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", metavar="DIR", help="results folder of a run")
    parser.add_argument("-o", "--output", metavar="OUTDIR", help="where the pictures go (default: DIR)")
    args = parser.parse_args()
    if not os.path.isdir(args.folder):
        sys.exit(f"plot.py: {args.folder} is not a folder")
    plt.rcParams.update({"svg.hashsalt": "hawser", "font.size": 9})
    output = args.output or args.folder
    os.makedirs(output, exist_ok=True)
    summary = read_summary(args.folder)
    drawn = 0
    for name, draw in (("stations.csv", draw_tension), ("series.csv", draw_series), ("rollers.csv", draw_rollers)):
        table = read_table(args.folder, name)
        if table:
            draw(table, summary, output)
            drawn += 1
    if not drawn:
        sys.exit(f"plot.py: {args.folder} has none of stations.csv, series.csv, rollers.csv with data")


if __name__ == "__main__":
    main()
