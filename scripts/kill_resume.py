#!/usr/bin/env python3
"""Kills runs at random moments, goes on with them, and compares all that they leave with what an uninterrupted run leaves.

Usage: kill_resume.py PROGRAM [--kills N] [--seed S] [--threads 1,2] [--planar auto,off] [--set KEY=VALUE]... [CASE...]

Each case is run once without a checkpoint. Then, N times in all, it is run with a checkpoint as often as possible, killed by SIGKILL
at a random moment (one time in four it is interrupted by SIGINT instead), and resumed; one resumed run in three is killed again. After
every kill results.h5 must be readable and series.csv end with a whole line; after the last resumption every file must be that of the
first run, byte by byte, but for what tells the time on the wall: of results.h5 the contents (h5diff), of summary.json all other keys.
Ends with 1 if anything differs, and says what."""
import argparse
import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

# Of summary.json: what depends on the wall clock, and on how many threads were asked for.
CLOCK = {"wall_time_s", "real_time_factor", "steps_per_second", "phases", "phases_s", "performance", "threads", "message"}


def without_clock(value):
    if isinstance(value, dict):
        return {k: without_clock(v) for k, v in value.items() if k not in CLOCK}
    return [without_clock(v) for v in value] if isinstance(value, list) else value


def comparable(summary):
    """What has to be the same: the sums, too, but for that of the keys, which say from which file they were read."""
    summary["files"] = [f for f in summary.get("files", []) if f["file"] != "inputs.csv"]
    return without_clock(summary)


def unequal(a, b, key=""):
    """The first key of two JSON values where they differ, or None."""
    if isinstance(a, dict) and isinstance(b, dict):
        return next((k for k in (unequal(a.get(n), b.get(n), f"{key}.{n}") for n in sorted({*a, *b})) if k), None)
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return next((k for k in (unequal(x, y, f"{key}.{i}") for i, (x, y) in enumerate(zip(a, b))) if k), None)
    return None if a == b else f"{key}: {str(a)[:100]} and {str(b)[:100]}"


def same_file(name, a, b):
    if name == "inputs.csv":
        with open(a) as f, open(b) as g:
            return [x for x in f if "run.checkpoint" not in x] == [x for x in g if "run.checkpoint" not in x]
    if name.endswith(".h5"):
        return subprocess.run(["h5diff", "-q", a, b], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
    return filecmp.cmp(a, b, shallow=False)


def differences(whole, other):
    names = sorted(set(os.listdir(whole)) | set(os.listdir(other)))
    out = []
    for name in names:
        a, b = os.path.join(whole, name), os.path.join(other, name)
        if not (os.path.exists(a) and os.path.exists(b)):
            out.append(f"{name} is only in one folder")
        elif name == "summary.json":
            with open(a) as f, open(b) as g:
                found = unequal(comparable(json.load(f)), comparable(json.load(g)))
            if found:
                out.append(f"{name} differs in {found}")
        elif not same_file(name, a, b):
            out.append(f"{name} differs")
    return out


def unreadable(folder):
    """What a reader stumbles over in the folder of a run that was killed."""
    out = []
    h5, series = os.path.join(folder, "results.h5"), os.path.join(folder, "series.csv")
    if os.path.exists(h5):
        read = subprocess.run(["h5dump", "-d", "/time", h5], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if read.returncode:
            out.append("results.h5 cannot be read")
    if os.path.exists(series):
        with open(series, "rb") as f:
            text = f.read()
        if text and not text.endswith(b"\n"):
            out.append("series.csv ends within a line")
    return out


class Trials:
    def __init__(self, args, work):
        self.args, self.work = args, work
        self.random = random.Random(args.seed)
        self.kills = self.resumed = self.early = self.late = 0
        self.faults = []

    def run(self, words, kill_after=None, by=signal.SIGKILL):
        """Returns the exit status, None if it was ended by us."""
        process = subprocess.Popen([self.args.program, "run", *words, "-q"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            _, self.said = process.communicate(timeout=kill_after)
            return process.returncode
        except subprocess.TimeoutExpired:
            process.send_signal(by)
            _, self.said = process.communicate()
            self.kills += 1
            return None

    def settings(self, case, planar):
        words = [w for s in self.args.set for w in ("--set", s)]
        return [case, "--set", f"solver.planar={planar}", *words]

    def whole(self, case, planar):
        folder = os.path.join(self.work, f"{os.path.basename(case)}-{planar}")
        start = time.monotonic()
        if not os.path.isdir(folder):
            if self.run([*self.settings(case, planar), "--set", "run.checkpoint=0", "-o", folder]):
                return None, 0
        return folder, time.monotonic() - start

    def trial(self, case, planar, whole, length):
        threads = self.random.choice(self.args.threads)
        folder = os.path.join(self.work, "killed")
        shutil.rmtree(folder, ignore_errors=True)
        words = [*self.settings(case, planar), "--set", "run.checkpoint=1 ms", "-o", folder, "--threads", threads]
        what = f"{case} planar {planar} threads {threads} kill {self.kills}"
        by = signal.SIGINT if self.random.random() < 0.25 else signal.SIGKILL
        status = self.run(words, self.random.uniform(0.02, 1.1 * length + 0.1), by)
        killed = 0
        while status is None:
            killed += 1
            for fault in unreadable(folder) if os.path.isdir(folder) else []:
                self.faults.append(f"{what}: {fault}")
            if not os.path.exists(os.path.join(folder, "checkpoint.hawser")):
                self.early += 1
                return
            again = self.random.random() < 1 / 3 and killed < 4
            threads = self.random.choice(self.args.threads)
            self.resumed += 1
            status = self.run(["--resume", folder, "--threads", threads],
                              self.random.uniform(0.02, length + 0.1) if again else None)
        if not killed:
            self.late += 1
        if status:
            self.faults.append(f"{what}: status {status}, {self.said.decode(errors='replace').strip()[-300:]}")
            shutil.copytree(folder, os.path.join(self.work, f"fault-{len(self.faults)}"), dirs_exist_ok=True)
            return
        for difference in differences(whole, folder):
            self.faults.append(f"{what}: {difference}")
            shutil.copytree(folder, os.path.join(self.work, f"fault-{len(self.faults)}"), dirs_exist_ok=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("case", nargs="*")
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=lambda t: t.split(","), default=["1", "2"])
    parser.add_argument("--planar", type=lambda t: t.split(","), default=["auto", "off"])
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--seconds", type=float, default=1e9, help="stop after that long")
    parser.add_argument("--keep", action="store_true", help="leave the folders, and say where they are")
    args = parser.parse_intermixed_args()
    work = tempfile.mkdtemp(prefix="kill-resume-")
    trials = Trials(args, work)
    start = time.monotonic()
    scenes = []
    for case in args.case:
        for planar in args.planar:
            whole, length = trials.whole(case, planar)
            if whole:
                scenes.append((case, planar, whole, length))
            else:
                print(f"{case} planar {planar}: {trials.said.decode(errors='replace').strip()[-200:]}", flush=True)
    while scenes and trials.kills < args.kills and time.monotonic() - start < args.seconds:
        for scene in scenes:
            if trials.kills < args.kills and time.monotonic() - start < args.seconds:
                before = len(trials.faults)
                trials.trial(*scene)
                for fault in trials.faults[before:]:
                    print(fault, flush=True)
    print(f"{len(scenes)} scenes, {trials.kills} kills, {trials.resumed} resumed, {trials.early} before a checkpoint, "
          f"{trials.late} runs ended before; {len(trials.faults)} faults")
    if args.keep:
        print(work)
    else:
        shutil.rmtree(work)
    return 1 if trials.faults or not scenes else 0


if __name__ == "__main__":
    sys.exit(main())
