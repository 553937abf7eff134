#!/usr/bin/env python3
"""Runs the program again and again, each time with another of its calls failing (inject.h), and judges how it ended.

Usage: inject.py HAWSER SHIM SOURCE_DIR [--sites | --all] [--kind KIND]... [--scene TEXT]... [--jobs N]

A call is told by where it comes from, its call stack. --sites: of each place the first call fails, and the last one; what another
scene of the same command has tried is not tried again. --all: every call. Else a few of the places, evenly, of one kind
for each scene. Memory that is
refused from a size on (heap) and a disk that is full after so many bytes (full) are tried at even distances.

Memory that is refused must end with status 5 and "out of memory", a disk with status 4 and the file, a file that cannot be read with its reason;
what can be done without may be missed (status 0, the same figures). Interrupted and short transfers change nothing. A signal,
another status, memory that is not given back, or a file that is cut off under its final name is a failure.
"""
import argparse
import array
import concurrent.futures
import os
import sys
import tempfile

import judge
import scenes

FEW = 3  # places of a scene and kind that are sampled
PARTS = 40  # of the memory, and of the bytes written, where all places are tried
COUNTED = {"heap": "KiB", "full": "bytes"}


class Trial:
    """The program with the library that lets calls fail."""

    def __init__(self, program, shim):
        self.program, self.shim = program, shim

    def run(self, scene, kind, at, sites=False):
        """How it ended, the number of calls, where they came from, and who has not given back memory."""
        with tempfile.TemporaryDirectory(prefix="hawser_inject_count_") as folder:
            paths = {name: os.path.join(folder, name) for name in ("COUNT", "SITES", "LEFT")}
            env = dict(os.environ, LD_PRELOAD=self.shim, INJECT_KIND=kind, INJECT_AT=str(at), OPENBLAS_NUM_THREADS="1")
            env.update({f"INJECT_{name}": path for name, path in paths.items() if sites or name != "SITES"})
            end = scene.run(self.program, env)
            return end, int(read(paths["COUNT"]) or 0), array.array("Q", read(paths["SITES"])), read(paths["LEFT"]).decode().split()


def read(path):
    if not os.path.exists(path):
        return b""
    with open(path, "rb") as file:
        return file.read()


def evenly(n, most):
    """At most so many of 1 to n."""
    return sorted({1 + i * (n - 1) // max(most - 1, 1) for i in range(most)}) if n > 0 else []


def choose(kind, calls, sites, tried, how):
    """Which calls are to fail."""
    if kind in COUNTED:
        return evenly(calls, PARTS if how else FEW)
    if how == "all":
        return range(1, calls + 1)
    first, last = {}, {}
    for k, site in enumerate(sites, 1):
        first.setdefault(site, k)
        last[site] = k
    new = [site for site in first if site not in tried]
    if not how:
        new = [new[k - 1] for k in evenly(len(new), FEW)]
        return sorted({first[site] for site in new})
    tried.update(new)
    return sorted({k for site in new for k in (first[site], last[site])})


def judged(trial, scene, kind, at, references):
    end, _, _, left = trial.run(scene, kind, at)
    wrong = judge.faults(kind, end, *references, scene.files_before())
    # a file that HDF5 does not close may still ask for what belongs to it: that is left
    if left and kind != "hdf5" and end[0] is not None and end[0] >= 0:
        wrong.append(f"memory is not given back: {' '.join(sorted(set(left)))}")
    return wrong


def look(trial, scene, kind, tried, how, pool):
    """Runs tried, runs that ended badly."""
    counted, calls, sites, left = trial.run(scene, kind, 0, True)
    references = counted, trial.run(scene, kind, 0)[0] if counted[3] else counted
    if counted[0] != 0 or left:
        print(f"{scene.name}: status {counted[0]} when nothing fails: {counted[2]} {left}")
        return 1, 1
    chosen = choose(kind, calls, sites, tried, how)
    bad = 0
    for at, wrong in zip(chosen, pool.map(lambda k: judged(trial, scene, kind, k, references), chosen)):
        bad += bool(wrong)
        if wrong:
            print(f"  {scene.name}, {kind} {at}: {'; '.join(wrong)}", flush=True)
    unit = COUNTED.get(kind, f"calls from {len(set(sites))} places")
    print(f"{scene.name}, {kind}: {len(chosen)} of {calls} {unit}, {bad} badly", flush=True)
    return len(chosen), bad


def kinds_of(number, how):
    """The kinds that are tried on a scene: of a sample memory on every other one, and on those between the others in turns."""
    others = [kind for kind in judge.STATUS if kind != "memory"]
    return judge.STATUS if how else ["memory" if number % 2 else others[number // 2 % len(others)]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("hawser")
    parser.add_argument("shim")
    parser.add_argument("source")
    parser.add_argument("--sites", dest="how", action="store_const", const="sites")
    parser.add_argument("--all", dest="how", action="store_const", const="all")
    parser.add_argument("--kind", action="append", choices=sorted(judge.STATUS))
    parser.add_argument("--scene", action="append", help="those whose name begins so")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    total = bad = 0
    with tempfile.TemporaryDirectory(prefix="hawser_inject_work_") as work, concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        trial, tried = Trial(args.hawser, args.shim), {}
        for number, scene in enumerate(scenes.all_scenes(args.hawser, args.source, work)):
            if args.scene and not scene.name.startswith(tuple(args.scene)):
                continue
            for kind in args.kind or kinds_of(number, args.how):
                n, wrong = look(trial, scene, kind, tried.setdefault((scene.command, kind), set()), args.how, pool)
                total, bad = total + n, bad + wrong
    print(f"{total} runs, {bad} ended badly")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
