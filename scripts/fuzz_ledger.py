#!/usr/bin/env python3
"""Runs a fuzzer and adds a row to a ledger: what was tried, for how long, with how many inputs.

Usage: fuzz_ledger.py run LEDGER TARGET ENGINE LOG FOUND COMMAND...    the fuzzer's output goes to LOG; FOUND: folder of what it found
       fuzz_ledger.py sum LEDGER...                                    a table of all rows by target, in Markdown
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


def run(ledger, target, engine, log, found, *command):
    before, start = left(found), time.monotonic()
    with open(log, "wb") as file:
        status = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT, check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    row = [time.strftime("%Y-%m-%d %H:%M:%S", time.gmtime()), target, engine, inputs_of(log, found),
           round(used.ru_utime + used.ru_stime, 1), round(time.monotonic() - start, 1), len(left(found) - before), status]
    new = not os.path.exists(ledger)
    with open(ledger, "a", newline="", encoding="ascii") as file:
        writer = csv.writer(file)
        if new:
            writer.writerow(FIELDS)
        writer.writerow(row)
    print(f"{target}, {engine}: {row[3]} inputs in {row[4]} s of processor time, {row[6]} broke something")
    return status


def total(*ledgers):
    sums = collections.defaultdict(lambda: [0, 0.0, 0])
    for ledger in ledgers:
        with open(ledger, newline="", encoding="ascii") as file:
            for row in csv.DictReader(file):
                for key in ((row["target"], row["engine"]), ("all", "")):
                    sums[key][0] += int(row["inputs"])
                    sums[key][1] += float(row["processor_s"])
                    sums[key][2] += int(row["found"])
    print("| target | engine | inputs | hours of processor time | broke something |\n|---|---|---|---|---|")
    for (target, engine), (inputs, seconds, found) in sorted(sums.items()):
        print(f"| `{target}` | {engine} | {inputs} | {seconds / 3600:.2f} | {found} |")
    return 0


if __name__ == "__main__":
    sys.exit({"run": run, "sum": total}[sys.argv[1]](*sys.argv[2:]))
