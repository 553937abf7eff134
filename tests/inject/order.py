#!/usr/bin/env python3
"""A loss of power keeps what was fsynced, and may keep any part of the rest: what is renamed has been fsynced before, and when
summary.json gets its name for the last time every other file has.

Usage: order.py HAWSER SHIM SOURCE_DIR
"""
import os
import subprocess
import sys
import tempfile

RUNS = [["--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "output.states=0.1 s"],
        ["--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "solver.passes=1"]]


def faults(log, folder):
    """What a loss of power at some moment would do harm to."""
    last, found, renamed = {}, [], []
    for line in log:
        what, path, *other = line.split()
        if what == "unlink":
            last.pop(path, None)
        elif what != "rename":
            last[path] = what
        if what != "rename":
            continue
        to = other[0]
        # a file that moves as a whole has been there, unchanged, since it was fsynced
        # and a journal has a sum of its own: one that is not whole says nothing
        if last.get(path, "fsync") != "fsync" and not to.endswith(".journal"):
            found.append(f"{path} is renamed before it is on the disk")
        last[to] = "fsync"
        last.pop(path, None)
        renamed.append(to)
        if os.path.dirname(to) == folder and os.path.basename(to) == "summary.json":
            unsafe = [p for p, w in last.items() if os.path.dirname(p) == folder and w == "write"]
    if not renamed or os.path.basename(renamed[-1]) != "summary.json":
        found.append(f"the last name given is {renamed[-1:]}, not that of summary.json")
    else:
        found += [f"{p} is not on the disk when summary.json says how the run ended" for p in unsafe]
    named = max((k for k, line in enumerate(log) if line.startswith("rename ")), default=0)
    if f"fsync {folder}" not in log[named:]:
        found.append("the folder is not on the disk at the end")
    return found


def main():
    hawser, shim, source = sys.argv[1:]
    bad = 0
    for settings in RUNS:
        with tempfile.TemporaryDirectory(prefix="hawser_order_") as work:
            work = os.path.realpath(work)
            folder, path = os.path.join(work, "out"), os.path.join(work, "log")
            for again in range(2):  # the second time over the results of the first
                env = dict(os.environ, LD_PRELOAD=shim, INJECT_LOG=path)
                subprocess.run([hawser, "run", os.path.join(source, "tests", "data", "cli-pull.yaml"), "-o", folder, "--quiet",
                                *settings], check=True, env=env)
                with open(path, encoding="utf-8") as file:
                    wrong = faults(file.read().splitlines(), folder)
                print(f"{' '.join(settings)}, {'again' if again else 'new'}: {'; '.join(wrong) or 'fine'}")
                bad += len(wrong)
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
