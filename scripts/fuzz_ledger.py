#!/usr/bin/env python3
"""Runs a fuzzer and adds a row to a ledger: what was tried, for how long, with how many inputs.

Usage: fuzz_ledger.py run LEDGER TARGET ENGINE LOG FOUND COMMAND...    the fuzzer's output goes to LOG; FOUND: folder of what it found
       fuzz_ledger.py keep LEDGER...     adds the sums of these by target to the tree's own ledger (tests/fuzz/ledger.csv) and removes them
       fuzz_ledger.py sum LEDGER...      prints a table of the sums by target
"""
import collections
import csv
import os
import re
import resource
import subprocess
import sys
import time

FIELDS = ["end_utc", "target", "engine", "inputs", "processor_s", "clock_s", "found", "status"]
KEPT = ["end_utc", "commit", "target", "engine", "inputs", "processor_s", "found"]
TREE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OWN = os.path.join(TREE, "tests", "fuzz", "ledger.csv")


def inputs_of(log, found):
    """How many inputs the fuzzer says that it has tried: libFuzzer alone or with forks, AFL++'s fuzzer_stats."""
    stats = os.path.join(found, "default", "fuzzer_stats")
    if os.path.exists(stats):
        with open(stats, encoding="ascii", errors="replace") as f:
            said = re.search(r"^execs_done\s*:\s*(\d+)", f.read(), re.M)
            return int(said[1]) if said else 0
    with open(log, encoding="utf-8", errors="replace") as f:
        text = f.read()
    said = re.findall(r"^#(\d+)[:\s]", text, re.M) + re.findall(r"number_of_executed_units:\s*(\d+)", text)
    return max(map(int, said), default=0)


def left(found):
    """Names of the inputs that broke something."""
    return {os.path.join(where, name) for where, _, names in os.walk(found) for name in names
            if name != "README.txt" and (os.path.basename(where) in ("crashes", "hangs") or "default" not in where)}


def rows_of(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def rows_add(path, fields, rows):
    new = not os.path.exists(path)
    with open(path, "a", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, fields, lineterminator="\n")
        if new:
            writer.writeheader()
        writer.writerows(rows)


def stands(name, command):
    """Whether what was found breaks something. A job of libFuzzer that is at work as its time ends leaves the input that it
    has not begun: an empty one, which the program takes. Such are taken away."""
    if os.path.getsize(name) > 0 or "-fork=1" not in command:
        return True
    program = next(word for word in command if os.path.basename(word).startswith("fuzz_"))
    if subprocess.run([program, name], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode:
        return True
    os.remove(name)
    return False


def run(ledger, target, engine, log, found, *command):
    before, start = left(found), time.monotonic()
    with open(log, "wb") as file:
        status = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT, check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    row = dict(zip(FIELDS, [time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime()), target, engine, inputs_of(log, found),
                            round(used.ru_utime + used.ru_stime, 1), round(time.monotonic() - start, 1),
                            sum((name.startswith(os.path.join(found, target)) or "default" in name) and stands(name, command)
                                for name in left(found) - before),
                            status]))
    rows_add(ledger, FIELDS, [row])
    print(f"{target}, {engine}: {row['inputs']} inputs in {row['processor_s']} s of processor time, {row['found']} broke something")
    return status


def keep(*ledgers):
    """One row for each target and what was tried since. Those that found something come last: nothing of what was tried
    meanwhile counts as time without a finding."""
    commit = subprocess.run(["git", "-C", TREE, "rev-parse", "--short=8", "HEAD"], capture_output=True, text=True, check=True)
    sums = {}
    for row in (row for ledger in ledgers for row in rows_of(ledger)):
        of = sums.setdefault((row["target"], row["engine"]), {"end_utc": "", "inputs": 0, "processor_s": 0.0, "found": 0})
        of["end_utc"] = max(of["end_utc"], row["end_utc"])
        of["inputs"] += int(row["inputs"])
        of["processor_s"] = round(of["processor_s"] + float(row["processor_s"]), 1)
        of["found"] += int(row["found"])
    rows = [{"commit": commit.stdout.strip(), "target": target, "engine": engine, **of} for (target, engine), of in sums.items()]
    rows_add(OWN, KEPT, sorted(rows, key=lambda row: (row["found"], row["end_utc"])))
    for ledger in ledgers:
        os.replace(ledger, ledger + ".kept")
    return 0


def by_target(rows):
    """Markdown; rows without a time are of inputs that were counted with others."""
    sums = collections.defaultdict(lambda: [0, 0.0, 0])
    quiet = 0.0
    for row in rows:
        quiet = 0.0 if int(row["found"]) else quiet + float(row["processor_s"] or 0)
        for key in ((row["target"], row["engine"]), ("all", "")):
            sums[key][0] += int(row["inputs"])
            sums[key][1] += float(row["processor_s"] or 0)
            sums[key][2] += int(row["found"])
    lines = ["| target | engine | inputs | hours of processor time | broke something |", "|---|---|---|---|---|"]
    lines += [f"| `{target}` | {engine} | {inputs:,} | {f'{seconds / 3600:.2f}' if seconds else ''} | {found} |".replace(",", " ")
              for (target, engine), (inputs, seconds, found) in sorted(sums.items()) if target != "all"]
    inputs, seconds, found = sums["all", ""]
    lines.append(f"| all |  | {inputs:,} | {seconds / 3600:.2f} | {found} |".replace(",", " "))
    lines += ["", f"{seconds / 3600:.1f} hours of processor time; since the last finding {quiet / 3600:.1f}."]
    return "\n".join(lines)


def total(*ledgers):
    print(by_target([row for ledger in ledgers for row in rows_of(ledger)]))
    return 0


if __name__ == "__main__":
    sys.exit({"run": run, "sum": total, "keep": keep}[sys.argv[1]](*sys.argv[2:]))
