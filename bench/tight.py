#!/usr/bin/env python3
"""Limp cables in tight ducts: does the error bound hold the converged pull?

`draw(number)` is a scene of the number alone: a duct with 0.5 to 10 mm of room, a cable or a fibre in a microduct with EI of 0.1 to
500 N m2, one to eight bends in all planes, level or on a slope; most leave their segments to the program, some have `auto` or a length of
their own. Each is run as it is, then with segments cut by half again and again, at a tenth of the accuracy, until two meshes in a row
agree within 0.15 % in the mean and 0.75 % in the peak: the finer one is the truth. Where none do within 4000 segments there is no oracle. Rows are
appended to a file of JSON lines, and what is there is not run again:

    python3 bench/tight.py --build build/release --rows tight.jsonl --scenes 0-399 [--positions] --document bench/results/epyc-2core/tight.md

`--truths` takes the oracles over from other rows, which is how two programs are compared scene by scene. A run is wrong if its mean is off by more
than 3 % or its peak by more than 10 %. The status is 1 if such a run is trusted, bounds hold less than 95 % of the truths, or fewer than 85 %
of those that are right are trusted.
"""
import argparse
import json
import os
import statistics
import sys

import truth
from common import table
from document import replace_between
from stress_random import Draw

AGREE = {"mean": 0.0015, "peak": 0.0075}  # of two meshes in a row
SEGMENTS = 4000
HOLD, TRUSTED = 0.95, 0.85
PLANES = ("left", "right", "up", "down", "30 deg", "120 deg", "225 deg", "300 deg")


def cable_of(r):
    """A cable without stiffness to speak of, or a bundle of fibres; the room on either side of it, m."""
    if r.chance(0.2):
        d = round(r.decades(0.003, 0.012), 4)
        return {"d": d, "mass": round(1400 * d ** 2, 4), "EA": 2e10 * d ** 2, "GA": 1e10 * d ** 2, "GJ": 1.0, "EI": r.decades(0.1, 3),
                "damping": 0.002}, round(r.decades(0.0005, 0.5 * d + 0.001), 5)
    d = round(r.decades(0.02, 0.08), 4)
    return {"d": d, "mass": round(d ** 2 * r.even(2000, 8000), 2), "EA": 5e7, "GA": 2e7, "GJ": 200.0, "EI": r.decades(1, 500),
            "damping": 0.002}, round(r.decades(0.0005, 0.01), 5)


def draw(number, positions=False):
    """The scene of that number, as a dict."""
    r = Draw(f"a tight duct, number {number}")
    cable, room = cable_of(r)
    mu, tension = round(r.even(0.1, 0.5), 3), round(cable["mass"] * truth.GRAVITY * r.decades(3, 150) + 20)
    bends, pieces, length, turned = r.choice([1, 1, 2, 2, 3, 4, 6, 8]), [], 0.0, 0.0
    for _ in range(bends):
        straight = round(r.even(2, 8), 2)
        radius = round(r.decades(max(20 * cable["d"], 0.5), 8), 2)
        angle = round(min(r.even(8, 90), 57.3 * 12 / radius))
        if mu * (turned + angle / 57.3) > 2.5 and pieces:  # nobody pulls thirty times the back tension
            break
        turned += angle / 57.3
        pieces += [{"straight": straight}, {"bend": f"{angle} deg", "radius": radius, "plane": r.choice(PLANES)}]
        length += straight + radius * angle / 57.29578
    longer = 0.3 * sum(piece["radius"] * float(piece["bend"].split()[0]) / 57.3 for piece in pieces if "bend" in piece)  # on a grade
    pieces.append({"straight": round(r.even(3, 6) + longer, 2)})
    head = round(length + pieces[-1]["straight"] - 1.6, 3)
    piece = {"cable": "c", "length": round(head - 1, 3)}
    segment = r.choice([None, None, None, "auto", round(r.even(0.1, 0.5), 2)])
    if segment:
        piece["segment"] = segment
    run = {"duration": 12, "steady_from": 3}
    if positions:
        run = {"analysis": "positions", "duration": 12, "positions": {"from": head + 0.3, "to": round(head + 1.1, 3), "step": 0.4}}
    return {"title": f"tight duct {number}: {len(pieces) // 2} bends, room {1e3 * room:.3g} mm, EI {cable['EI']:.3g} N m2", "cables": {"c": cable}, "chain": [piece],
            "route": {"head_at": head, "slope": r.choice(["0 deg", "0 deg", f"{round(r.even(-8, 8))} deg"]), "pieces": pieces},
            "surfaces": {"ducts": [{"radius": round(cable["d"] / 2 + room, 6), "place": "centred", "friction": {"mu": mu}}]},
            "lead_in": {"weight": "full"}, "drive": {"winch": {"speed": 0.1, "to": 1}, "tail": {"tension": tension, "ramp": "none"}},
            "run": run, "output": {"states": 0}}


def finer(case, segments, accuracy):
    """The case with so many segments and an accuracy of its own, in one pass."""
    out = json.loads(json.dumps(case))
    out["chain"][0]["segment"] = out["chain"][0]["length"] / segments
    out["solver"] = {"accuracy": accuracy, "passes": 1, "relax_iterations": truth.REST}
    return out


def oracles(program, case, run, seconds):
    """Finer and finer meshes, until two in a row agree or there is no more to be had."""
    found, segments = [], max(2 * run.get("segments", 1), round(case["chain"][0]["length"] / 0.1))
    while segments <= SEGMENTS:
        found.append(truth.launch(program, finer(case, segments, 1e-4), seconds))
        if not truth.complete(found[-1]):
            break
        if len(found) > 1 and agree(*found[-2:]):
            break
        segments *= 2
    for one in found:
        one.pop("others", None)
    return found


def agree(coarse, fine):
    return all(abs(coarse[name] - fine[name]) <= share * abs(fine[name]) for name, share in AGREE.items())


def judge(row):
    """How it ended, and what mean and peak are off by as shares."""
    run, found = row["run"], row["oracles"]
    row["trusted"] = truth.complete(run) and not run["failing"]
    if not truth.complete(run):
        row["ended"] = "refused" if run["status"] == 2 else "unfinished"
    elif len(found) < 2 or not all(map(truth.complete, found[-2:])) or not agree(*found[-2:]):
        row["ended"] = "no oracle"
    else:
        row["off"] = truth.off(run, found[-1], 0)
        row["ended"] = "right" if truth.within(row["off"]) else "wrong"
    return row


def bounds(rows):
    """Lines of a table: of mean and peak, the bounds, how many hold, and the medians of width over error."""
    body = []
    trusted = [row for row in rows if row["trusted"]]
    for names, kind, ours in ((["mean"], "all", rows), (["peak"], "all", rows), (["mean"], "trusted", trusted), (["peak"], "trusted", trusted),
                              (["mean", "peak"], "trusted", trusted)):
        held, ratio = [], []
        for row in ours:
            for name in names:
                if "off" not in row or name not in row["run"]["bars"]:
                    continue
                coarse, fine = row["oracles"][-2:]
                error, bound = abs(row["run"][name] - fine[name]), row["run"]["bars"][name]
                held.append(error <= bound + abs(coarse[name] - fine[name]) / 3)  # what is left of second order
                ratio.append(bound / max(error, 1e-6 * abs(fine[name])))
        if held:
            body.append([f"{' and '.join(names)}, {kind}", str(len(held)), f"{100 * sum(held) / len(held):.1f} %", f"{statistics.median(ratio):.1f}"])
    return body


def report(rows):
    kinds = [[ended, str(sum(r["ended"] == ended and r["trusted"] for r in rows)), str(sum(r["ended"] == ended and not r["trusted"] for r in rows))]
             for ended in ("right", "wrong", "no oracle", "unfinished", "refused")]
    cpu = [row["run"]["cpu_s"] for row in rows if "cpu_s" in row["run"]]
    return (f"{len(rows)} scenes, {sum(cpu):.0f} s of processor time:\n\n" + table(["the run was", "trusted", "not trusted"], kinds)
            + "\n\n" + table(["figure", "bounds", "hold the truth", "width over error, median"], bounds(rows)))


def misses(rows):
    """One line each for what must not be."""
    bad = [f"{row['title']}: trusted with {100 * row['off'][0]:+.1f} % mean, {100 * row['off'][1]:+.1f} % peak"
           for row in rows if row["ended"] == "wrong" and row["trusted"]]
    right = [row for row in rows if row["ended"] == "right"]
    if right and sum(row["trusted"] for row in right) < TRUSTED * len(right):
        bad.append(f"trusted: {sum(row['trusted'] for row in right)} of {len(right)} that are right")
    return bad + [f"bounds of the {line[0]}: {line[2]} hold" for line in bounds(rows) if float(line[2].split()[0]) < 100 * HOLD]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="a build, such as build/release, or a program")
    parser.add_argument("--rows", help="file of rows; appended to (default: none is kept)")
    parser.add_argument("--truths", help="file of rows whose oracles are taken over")
    parser.add_argument("--scenes", default="0-39", help="numbers A-B")
    parser.add_argument("--positions", action="store_true", help="run.analysis: positions")
    parser.add_argument("--seconds", type=int, default=60, help="processor time that a run may take")
    parser.add_argument("--document", help="write the tables between the markers of this document")
    args = parser.parse_args()
    program = args.build if os.path.isfile(args.build) else os.path.join(args.build, "cli/hawser")

    def read(path):
        if not path or not os.path.exists(path):
            return {}
        with open(path, encoding="utf-8") as file:
            return {row["number"]: row for row in map(json.loads, file)}

    known, truths, rows = read(args.rows), read(args.truths), []
    first, last = (int(word) for word in args.scenes.split("-"))
    for number in range(first, last + 1):
        row = known.get(number)
        if not row:
            case = draw(number, args.positions)
            row = {"number": number, "title": case["title"], "run": truth.launch(program, case, args.seconds)}
            row["run"].pop("others", None)
            row["oracles"] = truths[number]["oracles"] if number in truths else oracles(program, case, row["run"], args.seconds)
            if args.rows:
                with open(args.rows, "a", encoding="utf-8") as file:
                    file.write(json.dumps(row) + "\n")
        rows.append(judge(row))
    text = report(rows)
    print(text)
    if args.document:
        with open(args.document, encoding="utf-8") as file:
            old = file.read()
        with open(args.document, "w", encoding="utf-8") as file:
            file.write(replace_between(old, "positions" if args.positions else "runs", text))
    bad = misses(rows)
    for line in bad:
        print(f"tight.py: {line}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
