#!/usr/bin/env python3
"""What k cables beside each other cost, as instructions of whole runs over those of one cable: apart (0.1 mm between their
surfaces, on a floor, within each other's reach all along) and touching (laid in a row with 0.1 mm of overlap, so that all
pieces press). Counts of callgrind do not depend on what else the machine does; the settings of the run are the same for all k.

Usage: beside.py PROGRAM [--segments N] [--chains 1 2 3 5] [--gap MM ...]
"""

import argparse
import json
import os
import re
import subprocess
import tempfile

DIAMETER = 41  # mm
SEGMENT = 0.25  # m


def scene(chains, segments, gap, duration):
    """A case: `chains` cables side by side on a floor, `gap` mm between their surfaces, pulled for `duration` seconds."""
    length = segments * SEGMENT
    beside = ""
    if chains > 1:
        names = ", ".join(f"c{i}: {{}}" for i in range(chains))
        beside = f"chains: {{{names}}}\nlay: {{pattern: flat, spacing: {DIAMETER + gap} mm}}\n"
    return f"""cables:
  power: {{d: {DIAMETER} mm, mass: 3 kg/m, EA: 27 MN, GA: 9 MN, GJ: 100 N m2, EI: 200 N m2, damping: 2 ms}}
chain: [{{cable: power, length: {length} m, segment: {SEGMENT} m}}]
{beside}route: {{head_at: {length} m, pieces: [{{straight: {length + 4} m}}]}}
surfaces: {{planes: [{{name: floor, point: [0 m, 0 m, -{DIAMETER / 2} mm], normal: [0, 0, 1]}}]}}
friction: {{mu: 0.3}}
drive: {{winch: {{speed: 0.1 m/s, to: 1 s}}, tail: {{tension: 100 N}}}}
run: {{duration: {duration} s, steady_from: {duration / 2} s}}
solver: {{passes: 1, planar: off, relax: false}}
"""


def count(program, text, folder):
    """Instructions of a run, and its steps."""
    case, results = os.path.join(folder, "case.yaml"), os.path.join(folder, "results")
    with open(case, "w", encoding="utf-8") as file:
        file.write(text)
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "run", case, "-q", "-o", results]
    # valgrind does not know the widest instructions
    done = subprocess.run(command, env={**os.environ, "HAWSER_ISA": "avx2"}, capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if not found or not os.path.exists(os.path.join(results, "summary.json")):
        raise SystemExit(f"beside.py: the run failed: {done.stderr[-300:]}")
    with open(os.path.join(results, "summary.json"), encoding="utf-8") as file:
        summary = json.load(file)
    return int(found.group(1)), summary


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("--segments", type=int, default=370)
    parser.add_argument("--chains", type=int, nargs="+", default=[1, 2, 3, 5])
    parser.add_argument("--gap", type=float, nargs="+", default=[0.1, -0.1], help="mm; negative: they press")
    parser.add_argument("--duration", type=float, default=0.5, help="s")
    arguments = parser.parse_args()
    print("| chains | gap, mm | steps | evaluations | instructions, million | to one chain's | each step to one's |")
    print("|---|---|---|---|---|---|---|")
    for gap in arguments.gap:
        one = None
        for chains in arguments.chains:
            with tempfile.TemporaryDirectory() as folder:
                text = scene(chains, arguments.segments, gap, arguments.duration)
                instructions, summary = count(os.path.realpath(arguments.program), text, folder)
            now = instructions, summary["steps"]
            one = one or now
            ratio, each = now[0] / one[0], now[0] / now[1] / (one[0] / one[1])
            print(f"| {chains} | {gap:g} | {now[1]} | {summary['rhs_evals']} | {now[0] / 1e6:.0f} | {ratio:.2f} | {each:.2f} |", flush=True)


if __name__ == "__main__":
    main()
