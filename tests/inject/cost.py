#!/usr/bin/env python3
"""What `hawser check` says a run needs, against the memory that it took.

Usage: cost.py HAWSER SHIM SOURCE_DIR
"""
import json
import os
import subprocess
import sys
import tempfile

ALLOWED = 0.30  # the estimate's share of what was measured, more or less
SHORT = ["run.duration=20 ms", "run.steady_from=10 ms", "output.interval=10 ms", "output.states=0 s", "output.stations=[]",
         "output.speeds_of=[0]", "solver.relax=false"]


def chain(length, segment, *more):
    """A straight row of rollers with a chain of that length."""
    return [*SHORT, f"chain.0.length={length} m", f"chain.0.segment={segment} m", f"route.pieces.0.straight={length + 50} m",
            f"route.head_at={length + 2} m", *more]


def triangle(length, segment, *more):
    """Three cables that press on each other in a duct, and the rope that pulls them."""
    quick = ["run.duration=20 ms", "run.steady_from=10 ms", "output.interval=10 ms"]
    return [*quick, f"chain.0.length={length} m", f"chain.0.segment={segment} m", *more]


PULL, THREE = ["tests", "data", "cli-pull.yaml"], ["cases", "bundles", "three-in-a-duct.yaml"]
SCENES = {
    "20 segments": chain(10, 0.5),
    "20 segments with states": chain(10, 0.5, "output.states=10 ms"),
    "5000 segments in the plane": chain(500, 0.1),
    "5000 segments in space, with states": chain(500, 0.1, "solver.planar=off", "output.states=10 ms"),
    "20000 segments in the plane": chain(500, 0.025),
    "2000 segments, 5500 rollers": chain(500, 0.25, "rollers.along.spacing=0.1 m"),
    "2000 segments in space, KLU": chain(500, 0.25, "solver.planar=off", "solver.linear_solver=klu"),
    "three cables of 60 segments, with states": triangle(3, 0.05, "output.states=10 ms"),
    "three cables of 300 segments": triangle(3, 0.01, "output.states=0 s"),
}


def main():
    hawser, shim, source = sys.argv[1:]
    bad = 0
    for name, settings in SCENES.items():
        case = THREE if name.startswith("three") else PULL
        words = [os.path.join(source, *case), *(w for s in settings for w in ("--set", s))]
        said = json.loads(subprocess.run([hawser, "check", *words, "--format", "json"], check=True, capture_output=True).stdout)
        with tempfile.TemporaryDirectory(prefix="hawser_cost_") as folder:
            count = os.path.join(folder, "count")
            env = dict(os.environ, LD_PRELOAD=shim, INJECT_KIND="resident", INJECT_COUNT=count, OPENBLAS_NUM_THREADS="1")
            subprocess.run([hawser, "run", *words, "-o", os.path.join(folder, "out"), "--quiet"], check=True, env=env)
            with open(count, encoding="ascii") as file:
                taken = int(file.read()) * 1024 / 1e6
        off = said["memory_MB"] / taken - 1
        print(f"{name}: {taken:.1f} MB, estimated {said['memory_MB']:.1f} MB: {100 * off:+.0f} %", flush=True)
        bad += abs(off) > ALLOWED
    # beyond any machine: refused at once, by what the three do to each other
    far = [hawser, "check", os.path.join(source, *THREE), "--set", "chain.0.segment=0.05 mm"]
    told = subprocess.run(far, capture_output=True, text=True, timeout=60)
    refused = told.returncode == 5 and "the run needs" in told.stderr
    print(f"three cables of 168000 segments: status {told.returncode}: {told.stderr.strip()}")
    return bad > 0 or not refused


if __name__ == "__main__":
    sys.exit(main())
