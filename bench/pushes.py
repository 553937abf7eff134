#!/usr/bin/env python3
"""Pushed cables: theory and runs against converged runs, five pushes of one duct, and pushes drawn at random.

The five are 0.5, 0.8, 1.2, 1.5 and 3 times the load of snaking, 2 sqrt(EI w/r), left ahead of a pusher in a level straight duct. The
random ones are ducts and rollers with bends, slopes and 5 to 100 mm of room; `draw(number)` depends on the number alone. Every scene is run
as its case says, and with better settings (truth.better): `fine` and, for the five and wherever that differs from the run by more than half
of what is allowed, `finest`, which is then the truth; where the two differ by more than that there is none. Rows are appended to a file of
JSON lines, and what is there is not run again (theory is):

    python3 bench/pushes.py --build build/release --rows pushes.jsonl --five --document bench/results/epyc-2core/pushes.md
    python3 bench/pushes.py --build build/release --rows pushes.jsonl --scenes 0-99 --document bench/results/epyc-2core/pushes.md

Its status is 1 if theory says SAFE of a scene whose converged run breaks a limit, or a run is trusted and more than 5 % off.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile

import truth
import truth_scenes
from common import table
from document import replace_between
from stress_random import Draw

ALLOWED = 0.05
G = truth_scenes.GRAVITY
LEVELS = {"fine": {"mesh": 2, "accuracy": 10, "slower": 2, "step": 1}, "finest": {"mesh": 3, "accuracy": 30, "slower": 4, "step": 1}}
SHARES = (0.5, 0.8, 1.2, 1.5, 3.0)
REGIMES = ("straight", "straight", "snaking (BK6)", "snaking, part of it on its way to the helix (BK6)", "helix (BK5), then snaking (BK6)")


def five(share):
    """The duct of ../shared/traps/pushed-straight-duct.yaml with so many times the load of snaking ahead of the pusher at 22 m."""
    weight = 22 * G
    push = share * 2 * math.sqrt(1000 * weight / 0.03) + 0.2 * weight * 22
    return {"title": f"{share} times the load of snaking", "cables": {"p": {"d": 0.1, "mass": 22, "EI": 1000, "EA": 60e6, "GA": 20e6, "GJ": 1000}},
            "chain": [{"cable": "p", "length": 400}], "route": {"head_at": 402, "pieces": [{"straight": 420}]},
            "surfaces": {"ducts": [{"radius": 0.08}]}, "friction": {"mu": 0.2, "mu_s": 0.2},
            "drive": {"winch": {"speed": 0.2, "to": 5, "grip": "axial"}, "tail": {"tension": 0}},
            "conveyors": [{"name": "pusher", "from": 20, "to": 24, "clamp": 120e3, "mu": 0.3, "factor": 1.05, "limit": push}],
            "limits": {"pull": 56e3, "sidewall": 3e3, "bend_radius": 2, "push": 25e3}, "run": {"duration": 60, "steady_from": 40}}


def wall(x):
    """N/N0 of (BK6), x = (F/F_s)^2."""
    end = (2 * math.sqrt(2) - 1) ** 2
    if x <= 1 or x >= end:
        return max(x, 1)
    part = max(0, (math.sqrt(x) - math.sqrt(2)) / (math.sqrt(end) - math.sqrt(2)))
    return (1 - part) * (1 + 0.18 * (x - 1) + 0.1 * (x - 1) ** 2) + part * x


def used_up(push, snakes, rubs):
    """m of level straight duct in which friction takes a push; rubs: mu w, N/m."""
    return sum(push / 400 / (rubs * wall((push * (i + 0.5) / 400 / snakes) ** 2)) for i in range(400))


def bend(r, d):
    """A bend to a side, up or down, no tighter than 20 diameters."""
    radius = truth_scenes.round_to(max(20 * d, r.decades(2, 30)), 0.1)
    plane = r.choice(["left", "right", "left", "right", "up", "down"])
    most = 90 if plane in truth_scenes.SIDEWAYS else 12
    return {"bend": f"{round(r.even(5, most))} deg", "radius": radius, "plane": plane}


def draw(number):
    """The scene of that number, as a dict."""
    r = Draw(f"a push, number {number}")
    cable = truth_scenes.power_cable(r)
    cable.pop("bending", None)
    cable["EI"] = cable.get("EI", 800.0)
    weight, mu = cable["mass"] * G, round(r.even(0.15, 0.35), 3)
    kind = r.choice(["straight", "straight", "bends", "bends", "slope", "guided", "rollers"])
    room, share = round(r.decades(0.005, 0.1), 4), r.decades(0.3, 3)
    on_rollers = kind in ("guided", "rollers")
    at, speed, duration = 6.0, 0.1, 16
    travel = speed * (duration - 1)
    pitch = round(r.even(1, 2), 2)
    slope = round(r.even(-6, 8), 1) if kind == "slope" else 0.0
    if on_rollers:
        load = math.pi ** 2 * cable["EI"] / (pitch if kind == "guided" else 60) ** 2
    else:
        load = 2 * math.sqrt(cable["EI"] * weight * math.cos(math.radians(slope)) / room)
    rubs = weight * (mu * math.cos(math.radians(slope)) + math.sin(math.radians(slope)))
    rubs = max(rubs, 0.05 * weight)
    left = share * load
    if on_rollers:  # its friction does not grow with the push
        left = min(left, 0.8 * rubs * 60)
        length = left / rubs
    else:
        while used_up(left, load, rubs) > 70:
            left *= 0.8
        length = used_up(left, load, rubs)
    straight = round(at + 1.15 * length + r.even(5, 15) + travel)
    pieces = [{"straight": straight}]
    if kind == "bends":
        before = round(r.even(0.2, 0.6) * straight, 1)
        pieces = [{"straight": max(before, at + 4)}, bend(r, cable["d"]), {"straight": max(round(straight - before, 1), travel + 4)}]
    parts = truth_scenes.stretches([{**p, "bend": float(p["bend"].split()[0])} if "bend" in p else p for p in pieces], slope)
    head = round(parts[-1][1] - travel - 1, 2)
    limit = left + rubs * at
    case = {"title": f"push {number}: {kind}, {left / load:.2f} of the load", "cables": {"cable": cable}, "chain": [{"cable": "cable", "length": round(head - 1, 2)}],
            "route": {"head_at": head, "slope": f"{slope} deg", "pieces": pieces}, "friction": {"mu": mu, "mu_s": mu},
            "drive": {"winch": {"speed": speed, "to": 2, "grip": "clamp" if on_rollers else "axial"},
                      "tail": {"tension": round(2 * weight) if on_rollers else 0, "ramp": "none"}},  # a free tail tips off its rollers
            "conveyors": [{"name": "pusher", "from": at - 1, "to": at + 1, "clamp": round(4 * limit), "mu": 0.3, "factor": 1.5, "limit": round(limit, 1)}],
            "limits": {"pull": round(weight * mu * head * r.decades(0.3, 3) + 200), "push": round(limit * r.decades(0.8, 3))},
            "run": {"duration": duration, "steady_from": 9}}
    if on_rollers:
        row = {"spacing": pitch, "radius": 0.06, "where": [[0, straight]]}
        guides = {**row, "guide": "both", "gap": 0.005, "name": "G"}
        case["rollers"] = {"along": [{**row, "width": 0.5, "name": "R"}] + [guides] * (kind == "guided")}
    else:
        case["surfaces"] = {"ducts": [{"radius": round(cable["d"] / 2 + room, 4)}]}
    return case


def theory(program, case):
    """(verdict, pull in N), or (what it says, None)."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.yaml")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(case, file)
        done = subprocess.run([program, "theory", path, "--format", "json"], capture_output=True, text=True, check=False)
    if done.returncode:
        return done.stderr.strip().replace(path, "case.yaml")[:300], None
    answer = json.loads(done.stdout)
    return answer["verdict_forward"], answer["reference_total_N"]


def examine(program, name, case, seconds):
    """A scene's row."""
    said, total = theory(program, case)
    row = {"name": name, "title": case["title"], "theory": said, "theory_N": total, "run": truth.launch(program, case, seconds), "floor": truth.scale(case)}
    if not truth.complete(row["run"]):
        return row
    for level, by in LEVELS.items():
        row[level] = truth.launch(program, truth.better(case, row["run"], **{"slower_by" if k == "slower" else k: v for k, v in by.items()}), 4 * seconds)
        near = truth.complete(row[level]) and abs(row["run"]["mean"] - row[level]["mean"]) < ALLOWED / 2 * max(abs(row[level]["mean"]), row["floor"])
        if not truth.complete(row[level]) or (near and name not in SHARES):
            break
    if name in SHARES and name > 0.7:
        for level, imperfection in (("larger", 1e-2), ("smaller", 1e-4)):
            other = truth.better(case, row["run"], 2, 10, 2, 1)
            other["solver"]["imperfection"] = imperfection
            row[level] = truth.launch(program, other, 4 * seconds)
    return row


def judge(row):
    """How it ended, and by how much the run is off, as a share; NaN where nothing is known."""
    run, fine, finest = row["run"], row.get("fine"), row.get("finest")
    row["trusted"] = truth.complete(run) and not run["failing"]
    row["off"] = math.nan
    if not truth.complete(run):
        row["ended"] = "refused" if run["status"] == 2 else "unfinished"
        return row
    best = finest if truth.complete(finest) else fine
    if not truth.complete(best):
        row["ended"] = "no oracle"
        return row
    scale = max(abs(best["mean"]), row["floor"])
    row["off"] = (run["mean"] - best["mean"]) / scale
    doubt = abs(fine["mean"] - best["mean"]) / scale
    row["ended"] = "right" if abs(row["off"]) <= ALLOWED else "wrong"
    if doubt > ALLOWED / 2 and abs(row["off"]) < doubt + ALLOWED:
        row["ended"] = "no oracle"
    row["broken"] = [name for name in best["broken"] if name != "alpha"]  # theory has no alpha
    row["safe"] = row["theory"].startswith("SAFE: all")
    return row


def misses(rows):
    """One line each for what must not be."""
    bad = [f"{row['title']}: trusted with {100 * row['off']:+.1f} %" for row in rows if row["ended"] == "wrong" and row["trusted"]]
    return bad + [f"{row['title']}: SAFE by theory, the converged run breaks {', '.join(row['broken'])}" for row in rows
                  if row.get("safe") and row.get("broken")]


def kilo(run):
    return f"{run['mean'] / 1e3:.3f}" if truth.complete(run) else "-"


def report_five(rows):
    body = []
    for row in rows:
        best = row["finest"] if truth.complete(row.get("finest")) else row["fine"]
        body.append([f"{row['name']:g}", REGIMES[SHARES.index(row["name"])], f"{row['run']['theory'] / 1e3:.3f}",
                     f"{kilo(row['run'])} +- {row['run']['bars'].get('mean', 0) / 1e3:.3f}", "yes" if row["trusted"] else ", ".join(row["run"]["failing"]),
                     kilo(row["fine"]), kilo(row.get("finest")), kilo(row.get("larger")), kilo(row.get("smaller")),
                     f"{100 * (row['run']['theory'] / best['mean'] - 1):+.1f} %", f"{100 * row['off']:+.1f} %"])
    return table(["F/F_s", "regime", "theory, kN", "run, kN", "trusted", "fine", "finest", "fine, imperfection 1/100", "fine, 1/10 000",
                  "theory is off by", "run is off by"], body)


def report_random(rows):
    kinds = [[ended, str(sum(r["ended"] == ended and r["trusted"] for r in rows)), str(sum(r["ended"] == ended and not r["trusted"] for r in rows))]
             for ended in ("right", "wrong", "no oracle", "unfinished", "refused")]
    text = f"{len(rows)} random pushes:\n\n" + table(["the run was", "trusted", "not trusted"], kinds)
    safe = [row for row in rows if row.get("safe")]
    starts = [row for row in rows if row["theory"].startswith("NOT TRUSTED: at the start")]
    text += (f"\n\nSAFE by theory: {len(safe)}, of which the converged run breaks a limit: {sum(bool(row['broken']) for row in safe)}. Not trusted by theory "
             f"for their start beside belts (WI24): {len(starts)}, of which {sum('pull' in row.get('broken', []) for row in starts)} break the pull that is allowed.")
    beyond = [row for row in rows if row["ended"] == "right" and row["theory_N"]]
    if beyond:
        off = sorted(abs(row["run"]["theory"] - row["run"]["mean"]) / (abs(row["run"]["mean"]) + row["pushed"]) for row in beyond)
        text += (f" Theory of the way up to where the front came is off by {100 * off[len(off) // 2]:.1f} % in the median, {100 * off[-1]:.0f} % "
                 "at most, of pull and push together.")
    return text + "".join(f"\n- {line}" for line in misses(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="a build, such as build/release")
    parser.add_argument("--rows", help="file of rows; appended to (default: none is kept)")
    parser.add_argument("--five", action="store_true", help="the five pushes of one duct")
    parser.add_argument("--scenes", help="numbers A-B of random ones")
    parser.add_argument("--seconds", type=int, default=60, help="processor time that a run may take; a better one four times as much")
    parser.add_argument("--report", action="store_true", help="of what is in the rows alone: nothing is run")
    parser.add_argument("--document", help="write the tables between the markers of this document")
    args = parser.parse_args()
    program = os.path.join(args.build, "cli/hawser")
    known = {}
    if args.rows and os.path.exists(args.rows):
        with open(args.rows, encoding="utf-8") as file:
            known = {row["name"]: row for row in map(json.loads, file)}
    jobs = [(share, five(share)) for share in SHARES] if args.five else []
    if args.scenes:
        first, last = (int(word) for word in args.scenes.split("-"))
        jobs += [(f"random {number}", draw(number)) for number in range(first, last + 1)]
    for name, case in jobs:
        if name in known:
            known[name]["theory"], known[name]["theory_N"] = theory(program, case)  # of today: it takes milliseconds
        if name in known or args.report:
            continue
        known[name] = examine(program, name, case, args.seconds)
        if args.rows:
            with open(args.rows, "a", encoding="utf-8") as file:
                file.write(json.dumps(known[name]) + "\n")
    rows = [judge({**known[name], "pushed": case["conveyors"][0]["limit"]}) for name, case in jobs if name in known]
    parts = {"five": report_five([row for row in rows if row["name"] in SHARES]) if args.five else None,
             "random": report_random([row for row in rows if row["name"] not in SHARES]) if args.scenes else None}
    for name, text in parts.items():
        if not text:
            continue
        print(text)
        if args.document:
            with open(args.document, encoding="utf-8") as file:
                old = file.read()
            with open(args.document, "w", encoding="utf-8") as file:
                file.write(replace_between(old, name, text))
    bad = misses(rows)
    for line in bad:
        print(f"pushes.py: {line}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
