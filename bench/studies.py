#!/usr/bin/env python3
"""What studies cost: 100 000 samples by theory and 2 000 runs of huangjiahu, or fewer.

    python3 bench/studies.py build/release/cli/hawser [--samples 100000] [--runs 2000] [--jobs 2]

Clock and processor time, how long the workers were busy, and the largest memory of a process (docs/guide/studies-and-measured-pulls.md); on a
machine that does nothing else the clock counts.
"""
from __future__ import annotations

import argparse
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

CASES = pathlib.Path(__file__).resolve().parents[1] / "cases"
STUDY = """
case: {case}
set: {{limits.winch_capacity: 17 kN}}
fidelity: {fidelity}
parameters:
  friction.mu: {{triangular: {{from: 0.08, mode: 0.12, to: 0.25}}}}
  reel: {{key: drive.tail.tension, normal: {{mean: 6.9 kN, sd: 1 kN, from: 3 kN, to: 11 kN}}}}
monte-carlo: {{samples: {samples}}}
"""


def measure(hawser: str, folder: pathlib.Path, fidelity: str, samples: int, jobs: int) -> str:
    file = folder / f"{fidelity}.yaml"
    file.write_text(STUDY.format(case=CASES / "huangjiahu.yaml", fidelity=fidelity, samples=samples))
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    said = subprocess.run([hawser, "study", file, "--jobs", str(jobs), "-o", folder / fidelity], check=True, capture_output=True,
                          text=True).stdout
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    found = re.search(r"Workers were busy for (\d+) % of the time", said)
    busy = f"{found[1]} %" if found else "-"
    return (f"| {fidelity} | {samples} | {wall:.1f} s | {spent:.1f} s | {1e3 * spent / samples:.3f} ms | {busy} | "
            f"{after.ru_maxrss / 1024:.0f} MB |")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("hawser")
    parser.add_argument("--samples", type=int, default=100000)
    parser.add_argument("--runs", type=int, default=2000)
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    print("| by | samples | clock | processor | a sample | workers busy | memory |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for fidelity, samples in (("theory", args.samples), ("run", args.runs)):
            if samples > 0:
                print(measure(args.hawser, pathlib.Path(folder), fidelity, samples, args.jobs), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
