#!/usr/bin/env python3
"""Runs random pulls that theory knows well, and compares the two.

Usage: check_pulls.py PROGRAM FIRST COUNT [--scene N FILE]

Pulls FIRST to FIRST + COUNT - 1, drawn by their numbers: soft cables in close ducts, up to six straights, bends and slopes, to either side and back again, with and without rope
ahead, drawn by a winch off a tail or a reel. The mean pull of each must be trusted; the tension at every station and at the winch is within 4 % of the theory that knows
no stiffness and no room in the duct, the capstan's exponent being smaller by the radius of the cable over that of the bend (docs/validation.md, `capstan-thick`). A line for each that is not; then ends with 1.
--scene writes the case of one to a file.
"""
import csv
import json
import math
import os
import random
import subprocess
import sys
import tempfile

TOLERANCE = 0.04
DIAMETER, CLEARANCE = 0.05, 0.01  # m
BEHIND = 9  # m of cable behind the route's start, at most
APART = 1.5  # m, between what lies beside each other
STEP = 0.25  # m, at which that is asked
PEAKS = ("peak", "numerical_peak")  # a reel's brake grabs as the drum begins to turn: theory knows no peaks


def draw_route(r):
    """Pieces, their length, the largest angle over radius of all bends, and the line from above."""
    pieces, line, heading, thick, slope = [], [(-BEHIND, 0.0)], 0.0, 0.0, 0.0

    def go(length, turn):
        nonlocal heading
        parts = max(1, math.ceil(length / STEP))
        for _ in range(parts):
            heading += turn / parts
            x, y = line[-1]
            line.append((x + length / parts * math.cos(heading), y + length / parts * math.sin(heading)))
        return length

    go(BEHIND, 0)
    length = go(r.uniform(3, 20), 0)
    pieces.append(f"{{straight: {length:.3f} m}}")
    for _ in range(r.randint(1, 4)):
        kind = r.random()
        if kind < 0.6:
            radius, angle, side = r.uniform(3, 8), math.radians(r.uniform(15, 175)), r.choice((1, -1))
            length += go(radius * angle, side * angle)
            pieces.append(f"{{bend: {math.degrees(angle):.3f} deg, radius: {radius:.3f} m, plane: {'left' if side > 0 else 'right'}}}")
            thick += angle * DIAMETER / 2 / radius
            straight = r.uniform(4, 30)
            pieces.append(f"{{straight: {straight:.3f} m}}")
        else:  # the corner's length is the straights' own; up again the cable would cut it in the duct's room
            straight, slope = r.uniform(14, 30), min(slope, r.choice((-6, -3, 0)))
            pieces.append(f"{{straight: {straight:.3f} m, slope: {slope} deg}}")
        length += go(straight, 0)
    return pieces, length, thick, line


def crosses(line):
    """Whether the line comes near itself elsewhere."""
    far = int(4 * APART / STEP)
    return any(math.dist(line[i], line[j]) < APART for i in range(len(line)) for j in range(i + far, len(line)))


def case_of(number):
    """The case's text, and by how much its theory knows too much: mu times the bends' angles times r/R."""
    r = random.Random(number)
    while True:
        pieces, length, thick, line = draw_route(r)
        if not crosses(line) and thick < 0.06:
            break
    mu, rope, behind = r.uniform(0.1, 0.35), r.choice((0, 0, 4, 8)), r.uniform(3.5, BEHIND)
    head = length - max(rope, 1) - r.uniform(1, 3)
    segment = r.choice((250, 300, 400))
    chain = [f"{{cable: power, length: {head + behind:.3f} m, segment: {segment} mm}}"]
    if rope:
        chain.append(f"{{cable: rope, length: {rope} m, segment: {segment} mm, swivel: true}}")
    held, hold = r.choice(("tail", "reel")), r.uniform(1, 3)
    radius = 0.5 + DIAMETER / 2
    lines = [
        f"title: 'Random pull {number}'",
        "cables:",
        f"  power: {{d: {DIAMETER * 1e3:g} mm, EA: 50 MN, GA: 20 MN, GJ: 2 kN m2, EI: 50 N m2, mass: {r.uniform(2, 10):.3f} kg/m, damping: 2 ms}}",
        "  rope: {d: 20 mm, EA: 8 MN, GA: 3 MN, GJ: 100 N m2, EI: 20 N m2, mass: 0.9 kg/m, damping: 2 ms}",
        f"chain: [{', '.join(chain)}]",
        f"route: {{head_at: {head:.3f} m, transition_radius: 10 m, pieces: [{', '.join(pieces)}]}}",
        f"friction: {{mu: {mu:.4f}, v_s: 0.5 mm/s}}",
        f"surfaces: {{ducts: [{{radius: {(DIAMETER / 2 + CLEARANCE) * 1e3:g} mm, place: resting}}]}}",
        f"drive: {{winch: {{speed: {r.uniform(0.05, 0.2):.3f} m/s, to: 1 s}}"
        + (f", tail: {{tension: {hold:.3f} kN, ramp: none}}}}" if held == "tail" else "}"),
        "limits: {pull: 1 MN, sidewall: 1 MN/m}",
        "run: {duration: 5 s, steady_from: 3 s}",
        "output: {stations: {spacing: 3 m}}",
    ]
    lines.append("lead_in: {}" if held == "tail" else
                 f"reel: {{model: payout, distance: {behind - 2:.3f} m, barrel: 1 m, flange: 3 m, width: 1 m, inertia: 5 kg m2, "
                 f"back_tension: {{tension: {hold:.3f} kN, ramp: none}}, brake: {{torque: {100 * radius:.3f} N m}}}}")
    return "\n".join(lines) + "\n", mu * thick


def judge(folder, too_much):
    """What is wrong with the results; "" if nothing is."""
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    with open(os.path.join(folder, "stations.csv"), newline="", encoding="utf-8") as file:
        stations = [row for row in csv.DictReader(file) if row["mean_N"] and row["reference_N"]]
    broken = [row["name"] for row in summary["trust"] if not row["holds"] and row["name"] not in PEAKS]
    if broken:
        return f"not trusted: {broken}"
    pairs = [(row["name"], float(row["mean_N"]), float(row["reference_N"])) for row in stations]
    pairs.append(("the winch", summary["pull_force"]["steady_mean_N"], summary["theory"]["reference_total_N"]))
    if len(pairs) < 2:
        return f"only {len(pairs)} places to compare"
    for name, found, theory in pairs:
        least, most = theory * math.exp(-too_much) * (1 - TOLERANCE), theory * (1 + TOLERANCE)
        if not least <= found <= most:
            return f"at {name} {found:.1f} N, by theory {theory:.1f} N: {100 * (found / theory - 1):+.1f} %"
    return ""


def main():
    if len(sys.argv) > 3 and sys.argv[1] == "--scene":
        with open(sys.argv[3], "w", encoding="utf-8") as file:
            file.write(case_of(int(sys.argv[2]))[0])
        return 0
    program, first, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    bad = 0
    for number in range(first, first + count):
        text, too_much = case_of(number)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "case.yaml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            done = subprocess.run([program, "run", path, "-q", "-o", os.path.join(folder, "out")], capture_output=True, text=True,
                                  errors="replace", check=False)
            wrong = f"status {done.returncode}: {done.stderr.strip()}" if done.returncode else judge(os.path.join(folder, "out"), too_much)
        if wrong:
            print(f"{number}: {wrong}", flush=True)
        bad += bool(wrong)
    print(f"{count} pulls, {bad} of them wrong")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
