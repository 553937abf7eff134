#!/usr/bin/env python3
"""Lines and branches that tests reach by folder, from gcovr's summary, and the floors below which none may fall.

Usage: coverage_floors.py SUMMARY.json
"""
import collections
import json
import sys

# Per cent of lines and of branches. The aim is 97 and 90.
FLOORS = {"core": (97, 92), "contact": (97, 90), "linsolve": (97, 90), "theory": (97, 90), "sim": (97, 90)}


def main():
    sums = collections.defaultdict(lambda: [0, 0, 0, 0])
    with open(sys.argv[1], encoding="utf-8") as file:
        for found in json.load(file)["files"]:
            folder = found["filename"].split("/")[0]
            for k, key in enumerate(("line_covered", "line_total", "branch_covered", "branch_total")):
                sums[folder][k] += found[key]
    below = 0
    print("| folder | lines | reached | branches | reached | |\n|---|---|---|---|---|---|")
    for folder, (lines, line_total, branches, branch_total) in sorted(sums.items()):
        shares = 100 * lines / max(1, line_total), 100 * branches / max(1, branch_total)
        floor = FLOORS.get(folder, (0, 0))
        low = any(share < least for share, least in zip(shares, floor))
        below += low
        print(f"| `{folder}` | {line_total} | {shares[0]:.1f} % | {branch_total} | {shares[1]:.1f} % | {'below its floor' if low else ''} |")
    return below > 0


if __name__ == "__main__":
    sys.exit(main())
