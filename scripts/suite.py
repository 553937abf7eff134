"""Prints the processor times of the tests as a table: those of each folder, and the 30 slowest.

Usage: suite.py TIMES >bench/results/MACHINE/suite.md      TIMES: what tests/support/timed.c wrote; of a name that stands twice the last counts
"""
import collections
import datetime
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SLOWEST = 30


def tier_of(test, tiers):
    for tier, pattern in tiers:
        if re.fullmatch(pattern, test):
            return tier
    return {"sanitized": "default", "sanitizers": "full"}.get(test.split("/")[0], "quick")


def main():
    times = {}
    for line in pathlib.Path(sys.argv[1]).read_text().splitlines():
        test, seconds = line.split()
        times[test] = float(seconds)
    lines = (ROOT / "tests" / "tiers.txt").read_text().splitlines()
    tiers = [line.split()[:2] for line in lines if line and not line.startswith("#")]
    processor = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name"))
    print(f"# Processor time of the tests\n\n{processor}, {datetime.date.today()}; made by `sh scripts/test.sh full`. A test of the tiers "
          "`quick` and `default` that takes more than 20 s is moved or made smaller.\n")
    by_tier, by_folder = collections.Counter(), collections.Counter()
    for test, seconds in times.items():
        by_tier[tier_of(test, tiers)] += seconds
        by_folder[test.rsplit("/", 1)[0], tier_of(test, tiers)] += seconds
    print("| tier | s |\n|---|---|")
    for tier in ("quick", "default", "full"):
        print(f"| {tier} | {by_tier[tier]:.0f} |")
    print("\n| folder | tier | s |\n|---|---|---|")
    for (folder, tier), seconds in by_folder.most_common(SLOWEST):
        print(f"| {folder} | {tier} | {seconds:.1f} |")
    print("\n| test | tier | s |\n|---|---|---|")
    for test, seconds in sorted(times.items(), key=lambda item: -item[1])[:SLOWEST]:
        print(f"| {test} | {tier_of(test, tiers)} | {seconds:.1f} |")


if __name__ == "__main__":
    main()
