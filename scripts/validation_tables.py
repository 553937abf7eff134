#!/usr/bin/env python3
"""Writes the tables of docs/validation.d from what `hawser validate --format csv` printed.

Usage: validation_tables.py RESULTS.csv FOLDER
  40-paper.md    the paper's case and its variants, one a line
  50-results.md  every quantity of every case
"""
import csv
import os
import sys

CAUSES = [
    ("paper", "as it is: the solid bar of table 1"),
    ("paper-real-cable", "bending stiffness of a real cable, EI / 20"),
    ("paper-limp", "next to no bending stiffness, EI / 200"),
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
               f"{number(r['found'])} | {error} | {limit} | {r['verdict']} | {r['source']} |")


def write(folder, name, heading, lines):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(heading + "\n\n" + "\n".join(lines) + "\n")


def main(results, folder):
    with open(results, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    outside = sum(r["verdict"] == "OUTSIDE" for r in rows)
    cases = len({r["case"] for r in rows})
    write(folder, "40-paper.md", "### The variants", paper_table(rows))
    write(folder, "50-results.md",
          f"## Results\n\n{cases} cases, {len(rows)} quantities, {outside} outside their tolerance. "
          "Written by `sh scripts/validation.sh`.", result_table(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
