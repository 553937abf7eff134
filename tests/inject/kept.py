#!/usr/bin/env python3
"""Good results outlive a run that is killed while it puts them aside, wherever that is, and so does a second one: the next run
that does not end well has them in `earlier`, every file as it was.

Usage: kept.py HAWSER SHIM SOURCE_DIR
"""
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile

SHORT = ["--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "output.states=0.1 s", "--quiet"]
FAILS = ["--set", "solver.max_steps=1", "--set", "friction.mu=0.31"]  # the run ends with status 3
BEYOND = 3  # calls that are tried behind those that put results aside


class Bench:
    def __init__(self, hawser, shim, source, work):
        self.hawser, self.shim, self.work = hawser, shim, work
        self.case = os.path.join(source, "tests", "data", "cli-pull.yaml")
        self.good, self.out = os.path.join(work, "good"), os.path.join(work, "out")

    def run(self, folder, settings, kill=0):
        env = dict(os.environ)
        if kill:
            env.update(LD_PRELOAD=self.shim, INJECT_KIND="disk", INJECT_AT=str(kill), INJECT_KILL="1")
        words = [self.hawser, "run", self.case, "-o", folder, *SHORT, *settings]
        return subprocess.run(words, env=env, capture_output=True, timeout=60, check=False).returncode

    def is_moved(self):
        there = os.path.join(self.out, "earlier")
        return os.path.exists(os.path.join(there, "summary.json")) and not os.path.exists(os.path.join(there, "moving"))

    def fault(self, *kills):
        """What is wrong after runs that were killed at these calls, and one that fails."""
        shutil.rmtree(self.out, ignore_errors=True)
        shutil.copytree(self.good, self.out)
        for k, kill in enumerate(kills):
            self.run(self.out, FAILS, kill)
            self.moved = self.is_moved() if k == 0 else self.moved
        if self.run(self.out, FAILS) != 3:
            return "the last run does not end with status 3"
        found, wanted = contents(os.path.join(self.out, "earlier")), contents(self.good)
        wrong = [name for name in sorted(wanted.keys() | found.keys()) if wanted.get(name) != found.get(name)]
        return f"not as they were in earlier: {', '.join(wrong)}" if wrong else ""


def contents(folder):
    found = {}
    for name in os.listdir(folder) if os.path.isdir(folder) else ():
        with open(os.path.join(folder, name), "rb") as file:
            found[name] = hashlib.sha256(file.read()).hexdigest()
    return found


def main():
    bad, tried, k, beyond = 0, 0, 0, 0
    with tempfile.TemporaryDirectory(prefix="hawser_kept_") as work:
        bench = Bench(*sys.argv[1:], work)
        if bench.run(bench.good, []) or subprocess.run([bench.hawser, "report", bench.good, "--quiet"], check=False).returncode:
            sys.exit("no good results to begin with")
        while beyond < BEYOND and k < 100:
            k += 1
            for kills in ((k,), (k, 1 + 7 * k % 20)):
                wrong = bench.fault(*kills)
                tried += 1
                bad += wrong != ""
                if wrong:
                    print(f"killed at {', then at '.join(map(str, kills))}: {wrong}")
            beyond += bench.moved
    print(f"{tried} sequences of kills, {bad} lost good results")
    return bad > 0 or not 2 * BEYOND + 30 < tried < 200


if __name__ == "__main__":
    sys.exit(main())
