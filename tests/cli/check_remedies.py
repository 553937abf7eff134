#!/usr/bin/env python3
"""Random planner's cases in which several bends are too tight, and what `hawser theory` proposes for them: put into the case by its
keys, the first proposal (table `remedies`) must make the verdict SAFE in most, the second (less friction alone, table `answers`, or the
other direction) in all others that can be mended; of the rest the text must say what cannot.

Usage: check_remedies.py HAWSER [--cases N] [--seed S]
"""
import argparse
import json
import math
import os
import random
import subprocess
import sys
import tempfile

SHARE = 0.8  # of the first proposals


def case(r):
    diameter = r.uniform(0.04, 0.14)
    mass = 1400 * diameter**2 * r.uniform(0.6, 1.6)
    pieces = [f"{{straight: {r.uniform(50, 400):.2f} m}}"]
    for k in range(r.randint(2, 6)):
        radius = r.uniform(12, 60) * diameter
        plane = r.choice(["left", "right", "left", "right", "up", "down"])
        angle = r.uniform(20, 90) if plane in ("left", "right") else r.uniform(2, 12)
        pieces.append(f"{{name: b{k}, bend: {angle:.1f} deg, radius: {radius:.3f} m, plane: {plane}}}")
        pieces.append(f"{{straight: {r.uniform(5, 120):.2f} m}}")
        if r.random() < 0.15:
            pieces.append(f"{{straight: {r.uniform(20, 60):.2f} m, slope: {r.uniform(-4, 4):.2f} deg}}")
    mu = r.uniform(0.12, 0.4)
    area = 900e-6 * (diameter / 0.09) ** 2 * r.uniform(0.4, 1.4)
    return f"""cables: {{power: {{d: {diameter!r}, mass: {mass!r}, conductor: {{material: {r.choice(['copper', 'aluminium'])}, area: {area!r}}}}}}}
route:
  pieces:
""" + "".join(f"    - {p}\n" for p in pieces) + f"""surfaces: {{ducts: [{{radius: {diameter * r.uniform(0.8, 1.3)!r}}}]}}
friction: {{mu_s: {mu:.3f}, mu_d: {mu:.3f}}}
drive: {{tail: {{tension: {r.uniform(0.2, 2):.2f} kN}}}}
limits: {{code: {r.choice(['paper', 'tb889', 'iec', 'gb50217', 'aeic'])}, winch_capacity: {r.uniform(30, 100):.0f} kN}}
"""


def theory(hawser, path, settings=()):
    words = [w for key, value in settings for w in ("--set", f"{key}={value}")]
    done = subprocess.run([hawser, "theory", path, "--format", "json", *words], capture_output=True, text=True, timeout=120, check=False)
    if done.returncode:
        sys.exit(f"{path}: {done.stderr}")
    return json.loads(done.stdout)


def answer(hawser, path):
    return subprocess.run([hawser, "theory", path], capture_output=True, text=True, timeout=120, check=False).stdout


def broken_bends(o):
    wall = next(l for l in o["limits"] if l["name"] == "sidewall" and l["direction"] == "forward")
    bend = next(l for l in o["limits"] if l["name"] == "bend_radius" and l["direction"] == "forward")
    tight = sum((p["forward_sidewall_N_per_m"] or 0) > wall["limit"] for p in o["pieces"])
    return tight + (bend["ok"] == "NO")


def safe(o):
    return o["verdict_code"] == "safe"


def proposal(o, direction="forward"):
    rows = [row for row in o.get("remedies", []) if row["direction"] == direction and row["remedy"] != "none"]
    units = {"m": " m", "1": "", None: ""}
    return rows, {row["key"]: f"{row['value']!r}{units[row['unit']]}" for row in rows if row["key"]}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("hawser")
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=58)
    arguments = parser.parse_args()
    r = random.Random(arguments.seed)
    first = second = told = n = drawn = 0
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.yaml")
        while n < arguments.cases:
            drawn += 1
            text = case(r)
            with open(path, "w", encoding="utf-8") as out:
                out.write(text)
            o = theory(arguments.hawser, path)
            if safe(o) or broken_bends(o) < 2:
                continue
            n += 1
            rows, settings = proposal(o)
            if rows and safe(theory(arguments.hawser, path, settings.items())):
                first += 1
                continue
            if rows and all(row["holds"] == "yes" for row in rows):
                failures.append(f"proposed as safe and not:\n{text}{settings}")
                continue
            way = next((a for a in o["answers"] if a["direction"] == "forward" and "friction" in a["question"]), None)
            if way and way["value"] and safe(
                    theory(arguments.hawser, path, [(f"friction.mu_{k}", math.floor(1e3 * way["value"]) / 1e3) for k in "ds"])):
                second += 1
            elif o["verdict_code_backward"] == "safe":
                second += 1
            elif "still broken" in answer(arguments.hawser, path):
                told += 1
            else:
                failures.append(f"neither mended nor told:\n{text}")
    print(f"{n} cases of {drawn}: first proposal {first}, second {second}, told what cannot {told}, failures {len(failures)}")
    for failure in failures[:3]:
        print(failure)
    return int(bool(failures) or first < SHARE * n)


sys.exit(main())
