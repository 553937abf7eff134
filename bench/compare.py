#!/usr/bin/env python3
"""Compares two builds of hawser on the tracked scenes: times in pairs that take turns, instructions, results.

scripts/bench_compare.sh builds two commits and calls this. Status 1 if a scene's process takes more
processor time beyond noise and more instructions too; bench/paired.py says what "beyond noise" means. Processor time, because
it does not count the time in which others had the processor.
"""
import argparse
import csv
import math
import os
import random
import sys

import counts
import history
import paired
from common import ROOT, run_case, table
from steps import COUNTED, PHASES

ERROR = 0.05  # probability that a report calls anything in two equal programs different
LEAST = 0.01  # changes below this share are not called changes
LEAST_COUNT = 0.001  # growth of instructions that counts as growth
SMALL = 0.01  # phases below this share of the old run's time are shown, not judged
QUICK = ["run.duration=1 s", "run.steady_from=500 ms"]
NAMES = {**PHASES, "process": "CPU of the process", "all": "all phases", "integration": "integration"}
RESULTS = ("steps", "newton_iters", "rhs_evals")


def run_one(build, cases, case, settings):
    summary = run_case(build, os.path.join(cases, case + ".yaml"), settings, ["--threads", "1"], timeout=600)
    pull = summary["pull_force"]
    row = {"process": summary["cpu_s"], "all": summary["wall_time_s"], **{phase: summary["phases_s"][phase] for phase in PHASES}}
    row["integration"] = sum(row[phase] for phase in PHASES if phase not in ("relax", "output", "other"))
    return {**row, **{key: summary[key] for key in RESULTS}, "pull": pull["steady_mean_N"], "peak": pull["peak_N"]}


def run_pairs(builds, cases, scenes, pairs, settings, chance):
    """{scene: [(old, new)]}: in every pair one program follows the other, in an order drawn by lot; scenes take turns.
    A first pair warms up."""
    found = {scene: [] for scene in scenes}
    for number in range(pairs + 1):
        for scene in scenes:
            case, planar = history.TRACKED[scene]
            order = [0, 1]
            chance.shuffle(order)
            pair = [None, None]
            for which in order:
                pair[which] = run_one(builds[which], cases, case, [*settings, "solver.planar=" + planar])
            if number > 0:
                found[scene].append(tuple(pair))
        print(f"compare.py: pair {number} of {pairs}", file=sys.stderr)
    return found


def judged(found):
    """The figures that get a verdict: (scene, phase), from 1 % of the old run's time on."""
    keys = []
    for scene, pairs in found.items():
        whole = sum(old["all"] for old, _ in pairs)
        keys += [(scene, phase) for phase in ("process", "all", "integration", *PHASES)
                 if sum(old[phase] for old, _ in pairs) > SMALL * whole]
    return keys


def judge_all(found, error=ERROR):
    """{(scene, phase): verdict of bench/paired.py}; the error is shared among all figures."""
    keys = judged(found)
    return {(scene, phase): paired.judge([old[phase] for old, _ in found[scene]], [new[phase] for _, new in found[scene]],
                                         error / len(keys), LEAST) for scene, phase in keys}


def count_both(builds, cases, scenes, settings):
    """{scene: (old, new)} of instructions by phase; scenes that could not be counted with both programs are missing."""
    counted = {}
    for scene in scenes:
        case, planar = history.TRACKED[scene]
        both = [counts.count_case(os.path.join(build, "cli/hawser"), os.path.join(cases, case + ".yaml"),
                                  [*settings, "solver.planar=" + planar]) for build in builds]
        if None not in both:
            counted[scene] = tuple(both)
        print(f"compare.py: instructions of {scene}", file=sys.stderr)
    return counted


def growth(counted, scene, phase):
    """new / old - 1 of the instructions; NaN if they were not counted."""
    old, new = counted.get(scene, ({}, {}))
    phase = "all" if phase == "process" else phase
    # the integration has no door of its own
    if phase == "integration":
        inside = ("rhs", "jacobian", "factor", "solve", "vector")
        old, new = ({phase: sum(side[name] for name in inside)} if all(name in side for name in inside) else {}
                    for side in (old, new))
    return new[phase] / old[phase] - 1 if old.get(phase) and phase in new else math.nan


def percent(value):
    return "-" if math.isnan(value) else f"{100 * value:+.2f} %"


def times_table(found, verdicts, counted):
    body = []
    for (scene, phase), it in verdicts.items():
        old, new = (sorted(pair[which][phase] for pair in found[scene])[len(found[scene]) // 2] for which in (0, 1))
        range_ = f"{percent(it['low'])} .. {percent(it['high'])}" if math.isfinite(it["high"]) else "too few pairs"
        verdict = f"**{it['verdict']}**" if it["verdict"] != "no change beyond noise" else it["verdict"]
        body.append([f"{scene}, {NAMES.get(phase, phase)}", f"{1e3 * old:.2f}", f"{1e3 * new:.2f}", percent(it["change"]),
                     range_, percent(growth(counted, scene, phase)), verdict])
    return table(["scene, phase", "old ms", "new ms", "change", "interval", "instructions", "verdict"], body)


def results_lines(found):
    """Whether both programs say the same, scene by scene."""
    lines = []
    for scene, pairs in found.items():
        old, new = pairs[0]
        changed = [f"{key} {old[key]} -> {new[key]}" for key in RESULTS if old[key] != new[key]]
        changed += [f"{key} {old[key]:.9g} -> {new[key]:.9g} N ({percent(new[key] / old[key] - 1)})" for key in ("pull", "peak")
                    if old[key] != new[key]]
        lines.append(f"- {scene}: results " + ("differ: " + ", ".join(changed) if changed else "agree to the last digit"))
    return "\n".join(lines)


def worse(verdicts, counted):
    """Scenes that are slower beyond noise and whose instructions have grown too (or could not be counted)."""
    found = []
    for (scene, phase), it in verdicts.items():
        grown = growth(counted, scene, phase)
        if phase == "process" and it["verdict"] == "slower" and not grown <= LEAST_COUNT:
            found.append(scene)
    return found


def write_pairs(path, found):
    """All raw figures, one row a run."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = [{"scene": scene, "pair": k + 1, "program": name, **row} for scene, pairs in found.items()
                for k, pair in enumerate(pairs) for name, row in zip(("old", "new"), pair)]
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", help="build folder of the old program")
    parser.add_argument("new", help="build folder of the new program")
    parser.add_argument("--cases", default=os.path.join(ROOT, "cases"), help="the case files that both run")
    parser.add_argument("--pairs", type=int, default=40)
    parser.add_argument("--scenes", default=",".join(history.TRACKED))
    parser.add_argument("--rows", help="file for the raw figures")
    parser.add_argument("--no-counts", action="store_true", help="do not count instructions")
    parser.add_argument("--quick", action="store_true", help="one second of each scene")
    args = parser.parse_args()
    builds, scenes = (args.old, args.new), args.scenes.split(",")
    unknown = [scene for scene in scenes if scene not in history.TRACKED]
    if unknown or args.pairs < 1:
        parser.error(f"scenes are {', '.join(history.TRACKED)}; at least one pair")
    settings = QUICK if args.quick else []
    found = run_pairs(builds, args.cases, scenes, args.pairs, settings, random.Random(1))
    counted = {} if args.no_counts else count_both(builds, args.cases, scenes, QUICK if args.quick else COUNTED)
    verdicts = judge_all(found)
    if args.rows:
        write_pairs(args.rows, found)
    need = paired.least_pairs(ERROR / len(verdicts))
    print(f"{args.pairs} pairs, one thread; medians of new / old - 1 in pairs; intervals hold together with "
          f"{100 * (1 - ERROR):g} %" + (f"; {need} pairs are the fewest for a verdict" if args.pairs < need else ""))
    print()
    print(times_table(found, verdicts, counted))
    print()
    print(results_lines(found))
    bad = worse(verdicts, counted)
    print(f"\nSlower beyond noise with more instructions: {', '.join(bad) or 'none'}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
