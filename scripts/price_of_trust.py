#!/usr/bin/env python3
"""The price of trust: which share of a run's instructions is spent on asking whether the run is right.

Counts the instructions of whole runs of example cases under valgrind's callgrind, and of them those that functions spend (with all that
they call) which are there for the conditions and error bars alone: FUNCTIONS. Prints a table, or writes it into a document:

    python3 scripts/price_of_trust.py --program build/release/cli/hawser [--document docs/performance.md] [CASE ...]

valgrind knows no AVX-512: the runs take AVX2. Status 1: a case pays more than ALLOWED; 2: it could not be measured.
"""
import argparse
import collections
import os
import re
import subprocess
import sys
import tempfile

from document import replace_between

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ALLOWED = 0.10
# What is counted, by the column that it stands in.
FUNCTIONS = {
    "books": r"balance_\w+",
    "passed": r"passing_\w+|overlap_\w+",
    "on route": r"stray_\w+",
    "stability": r"stability_\w+|critical_\w+",
    "peaks": r"stats_step|stats_peak|\w+_glance|steadiness_held",
    "rest": r"steadiness_(record|drift|spike)|turned\w*|error_(shares|of_mean|of_peak)|trust_judge|mesh_(find|given|free)",
}
# A row's look is everybody's; one that is taken for a peak between rows is not.
LOOKS = {("sim_advance", "look_now"): "peaks"}
# Cases as they stand, or with these lines changed so that one takes less than two minutes here.
CASES = {
    "straight": {},
    "huangjiahu": {},
    "huangjiahu, planar off": {"solver: {": "solver: {planar: off, "},
    "conveyors": {},
    "tray": {},
    "duct-bends": {},
    "rollers-spinning": {},
    "reel": {},
    "rod-cantilever": {},
    "rod-rollup": {},
}


def read_calls(path):
    """A file of callgrind: {(caller, called): instructions}, and instructions in all."""
    names, calls, total = {}, collections.Counter(), 0
    caller = called = None
    of_call = False

    def name(text):
        number, new = re.fullmatch(r"\((\d+)\)(?: (.*))?", text).groups()
        if new:
            names[number] = new.split("'")[0]  # a number behind ' counts levels of recursion
        return names[number]

    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.rstrip("\n")
            if line.startswith("fn="):
                caller = name(line[3:])
            elif line.startswith("cfn="):
                called = name(line[4:])
            elif line.startswith("calls="):
                of_call = True
            elif re.match(r"[0-9+*-]", line):
                cost = int((line.split() + ["0"])[1])
                if of_call:
                    calls[caller, called] += cost
                else:
                    total += cost
                of_call = False
    return calls, total


def shares(calls, total):
    """{column: share of all instructions}: of calls from outside, so that what one of them calls counts once."""
    every = re.compile("|".join(FUNCTIONS.values()))
    found = dict.fromkeys(FUNCTIONS, 0.0)
    for (caller, called), cost in calls.items():
        if (caller, called) in LOOKS:
            found[LOOKS[caller, called]] += cost / total
        if not every.fullmatch(called) or every.fullmatch(caller):
            continue
        column = next(key for key, pattern in FUNCTIONS.items() if re.fullmatch(pattern, called))
        found[column] += cost / total
    return found


def measure(program, title):
    """Shares of one case's run, and its instructions."""
    with open(os.path.join(ROOT, "cases", title.split(",")[0] + ".yaml"), encoding="utf-8") as file:
        text = file.read()
    for old, new in CASES.get(title, {}).items():
        if old not in text:
            sys.exit(f"price_of_trust.py: {title}: no '{old}' in the case")
        text = text.replace(old, new)
    with tempfile.TemporaryDirectory() as folder:
        case, counts = os.path.join(folder, "case.yaml"), os.path.join(folder, "counts")
        with open(case, "w", encoding="utf-8") as file:
            file.write(text)
        command = ["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={counts}", program, "run", case, "--quiet",
                   "--threads", "1", "-o", os.path.join(folder, "out")]
        done = subprocess.run(command, env={**os.environ, "HAWSER_ISA": "avx2"}, capture_output=True, text=True)
        if done.returncode:
            print(f"price_of_trust.py: {title}: {done.stderr.strip()[:300]}", file=sys.stderr)
            sys.exit(2)
        calls, total = read_calls(counts)
    return shares(calls, total), total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--document", help="write the table between the markers of this document")
    parser.add_argument("cases", nargs="*", default=list(CASES))
    args = parser.parse_args()
    lines = ["| case | 10^9 instructions | " + " | ".join(FUNCTIONS) + " | all |", "|---|" + "---:|" * (len(FUNCTIONS) + 2)]
    worst = 0.0
    for title in args.cases:
        found, total = measure(args.program, title)
        whole = sum(found.values())
        worst = max(worst, whole)
        cells = [f"{100 * share:.2f}" for share in found.values()] + [f"{100 * whole:.2f} %"]
        lines.append(f"| {title} | {total / 1e9:.2f} | " + " | ".join(cells) + " |")
        print(lines[-1], flush=True)
    text = "\n".join(lines)
    if args.document:
        with open(args.document, encoding="utf-8") as file:
            old = file.read()
        with open(args.document, "w", encoding="utf-8") as file:
            file.write(replace_between(old, "price of trust", text))
    return 1 if worst > ALLOWED else 0


if __name__ == "__main__":
    sys.exit(main())
