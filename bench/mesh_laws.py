#!/usr/bin/env python3
"""What long segments add to a pull through one bend: measured against segments of 62.5 mm, and what the laws of docs/theory/12-mesh.md
foretell (the value of the condition `mesh`).

    python3 bench/mesh_laws.py --build build/release [--rows FILE] [--document bench/results/mesh_laws.md] [--jobs 1]

Rows are kept in a file of JSON lines, and what is there already is not run again. A run takes 0.2 to 20 s, all of them about ten minutes.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import tempfile
import threading

from common import table
from document import replace_between

FINE = 62.5
LENGTHS = [250, 354, 500, 707, 1000]  # mm
SHORT = [100, 200, 400]
FINEST = 50


def case(segment, radius, angle=90, room=None, ei=5, tension=2000, plane="left", slope=0, rollers=None, mass=20.387, mu=0.2):
    """A bend between two straights, with the cable through it and 2 m to go; lengths in m, room in mm."""
    arc = radius * angle * 3.14159265 / 180
    out = {
        "cables": {"c": {"d": 0.06, "mass": mass, "EA": 1e7, "GA": 4e6, "GJ": 1e3, "EI": ei, "damping": 0.005}},
        "chain": [{"cable": "c", "length": round(arc + 5, 3), "segment": segment / 1000}],
        "route": {"head_at": round(arc + 4, 3), "slope": f"{slope} deg",
                  "pieces": [{"straight": 2}, {"bend": f"{angle} deg", "radius": radius, "plane": plane}, {"straight": 6}]},
        "lead_in": {"weight": "carried"},
        "friction": {"mu": mu},
        "drive": {"winch": {"speed": 0.2, "to": 1}, "tail": {"tension": tension, "ramp": "none"}},
        "run": {"duration": 8, "steady_from": 3},
        "solver": {"passes": 1},
    }
    if room is not None:
        out["surfaces"] = {"ducts": [{"radius": 0.03 + room / 1000, "place": "centred"}]}
    if rollers is not None:
        out["rollers"] = {"along": rollers}
    return out


def hold_downs(spacing):
    return {"spacing": spacing, "radius": 0.06, "hold_down": "sag"}


def guided(spacing):
    carriers = {"spacing": spacing, "radius": 0.06, "width": 0.6}
    return [carriers, {"guide": "both", "spacing": spacing, "radius": 0.06, "width": 0.6}]


BENDS = {
    "duct R 3 m, room 0.2 mm": {"radius": 3, "room": 0.2},
    "room 1 mm": {"radius": 3, "room": 1},
    "room 5 mm": {"radius": 3, "room": 5},
    "room 30 mm": {"radius": 3, "room": 30},
    "room 1 mm, EI 500 N m²": {"radius": 3, "room": 1, "ei": 500},
    "room 1 mm, T 10 kN": {"radius": 3, "room": 1, "tension": 10000},
    "room 1 mm, R 10 m, 45 deg": {"radius": 10, "angle": 45, "room": 1},
    "room 1 mm, R 1.5 m": {"radius": 1.5, "room": 1},
    "hold-downs, R 6 m, a 0.5 m": {"radius": 6, "angle": 60, "plane": "up", "slope": -30, "rollers": hold_downs(0.5)},
    "a 0.25 m": {"radius": 6, "angle": 60, "plane": "up", "slope": -30, "rollers": hold_downs(0.25)},
    "R 3 m, a 0.5 m": {"radius": 3, "angle": 60, "plane": "up", "slope": -30, "rollers": hold_downs(0.5)},
    "guides on both sides, R 6 m, a 0.5 m": {"radius": 6, "angle": 60, "rollers": guided(0.5)},
    "crest, R 6 m, a 1 m": {"radius": 6, "angle": 60, "plane": "down", "slope": 30, "rollers": {"spacing": 1, "radius": 0.06}},
    "crest, R 12 m, a 2 m": {"radius": 12, "angle": 60, "plane": "down", "slope": 30, "rollers": {"spacing": 2, "radius": 0.06}},
}
# Stiff cables at little tension: EI from the bending length over the radius.
STIFF = {f"R {radius} m, {ratio}": {"radius": radius, "angle": 60, "room": 15, "tension": 300, "ei": round(300 * (ratio * radius) ** 2, 1),
                                    "mass": 10.194, "mu": 0.15}
         for radius, ratio in [(1.5, 1.4), (1.5, 0.7), (1.5, 0.5), (3, 0.7)]}


def run(program, bend, segment):
    """(mean pull, N; foretold share of it), or None."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.yaml")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(case(segment, **bend), file)
        try:
            done = subprocess.run([program, "run", path, "-q", "-o", folder], capture_output=True, text=True, timeout=110, check=False)
        except subprocess.TimeoutExpired:
            return None
        if done.returncode != 0:
            return None
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    foretold = {c["name"]: c["value"] for c in summary["trust"]}.get("mesh", 0)
    return summary["pull_force"]["steady_mean_N"], foretold


def digits(percent):
    return f"{percent:.1f}" if abs(percent) < 9.95 else f"{percent:.0f}"


def cell(rows, name, segment, fine):
    """What the segments add, %, and what is foretold, of the same pull."""
    this, best = rows.get((name, segment)), rows.get((name, fine))
    if not this or not best:
        return "-"
    return f"{digits(100 * (this[0] / best[0] - 1))} ({digits(100 * this[1])})"


def tables(rows):
    def one(bends, lengths, fine):
        return table([""] + [f"{length} mm" for length in lengths],
                     [[name] + [cell(rows, name, length, fine) for length in lengths] for name in bends])
    return one(BENDS, LENGTHS, FINE), one(STIFF, SHORT, FINEST)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True)
    parser.add_argument("--rows")
    parser.add_argument("--document")
    parser.add_argument("--jobs", type=int, default=1)
    args = parser.parse_args()
    program, rows, lock = os.path.join(args.build, "cli/hawser"), {}, threading.Lock()
    if args.rows and os.path.exists(args.rows):
        with open(args.rows, encoding="utf-8") as file:
            for line in file:
                name, segment, result = json.loads(line)
                rows[name, segment] = result
    jobs = [(name, bend, length) for bends, lengths, fine in ((BENDS, LENGTHS, FINE), (STIFF, SHORT, FINEST))
            for name, bend in bends.items() for length in [fine] + lengths]

    def one(job):
        name, bend, segment = job
        result = run(program, bend, segment)
        with lock:
            rows[name, segment] = result
            if args.rows:
                with open(args.rows, "a", encoding="utf-8") as file:
                    file.write(json.dumps([name, segment, result]) + "\n")

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(one, [job for job in jobs if (job[0], job[2]) not in rows]))
    for key, text in zip(("mesh bends", "mesh stiff"), tables(rows)):
        print(text + "\n")
        if args.document:
            with open(args.document, encoding="utf-8") as file:
                old = file.read()
            with open(args.document, "w", encoding="utf-8") as file:
                file.write(replace_between(old, key, text))


if __name__ == "__main__":
    main()
