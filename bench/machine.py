#!/usr/bin/env python3
"""Writes what the machine is, and how long each part took, into RESULTS/README.md, and the verdicts over the goals of all
parts into docs/performance.md if that page is about this machine, each between its markers; and prints them.

Usage: machine.py [RESULTS [DOCUMENT]]     (without them: prints what the machine is)
"""
import csv
import glob
import os
import re
import subprocess
import sys

from common import ROOT, machine_name, processor, write_document

PACKAGES = {"SUNDIALS": "libsundials-dev", "SuiteSparse": "libsuitesparse-dev", "HDF5": "libhdf5-dev",
            "LAPACK": "liblapacke-dev", "glibc": "libc6"}


def output_of(*words):
    """What a command prints; nothing if it is not there."""
    try:
        return subprocess.run(words, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    except OSError:
        return ""


def facts_of(lscpu):
    """Family, caches and hypervisor as lscpu prints them."""
    wanted = ("CPU family", "Model", "Thread(s) per core", "L1d cache", "L2 cache", "L3 cache", "Hypervisor vendor")
    found = dict(line.split(":", 1) for line in lscpu.splitlines() if ":" in line)
    return [f"{name} {found[name].strip()}" for name in wanted if name in found]


def system():
    found = re.search(r'^PRETTY_NAME="(.*)"', output_of("cat", "/etc/os-release"), re.M)
    return found.group(1) if found else "an unknown system"


def versions():
    """Versions of the libraries that count, as the package manager knows them."""
    found = [(name, output_of("dpkg-query", "-W", "-f=${Version}", package)) for name, package in PACKAGES.items()]
    return [f"{name} {version}" for name, version in found if version]


def machine_text():
    cores = os.cpu_count()
    compiler = output_of("cc", "--version").splitlines()
    kernel = os.uname().release.split("-")[0]
    parts = [f"`{machine_name(processor(), cores)}`: {processor()}, {cores} cores; {'; '.join(facts_of(output_of('lscpu')))}.",
             f"Linux {kernel}, {system()}; {compiler[0] if compiler else 'no compiler'}; {', '.join(versions())}."]
    return "\n".join(parts)


def seconds_text(results):
    """How long the parts took when they were last run here, as scripts/bench.sh noted."""
    path = os.path.join(results, "seconds.csv")
    if not os.path.exists(path):
        return ""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    parts = ", ".join(f"`{row['part']}` {row['seconds']} s" for row in rows)
    return f"The parts took, when each was last run here: {parts}; together {sum(int(row['seconds']) for row in rows) / 60:.0f} min."


def goals(text):
    """[({header: cell}, reached?)] of every row of a part's tables whose last column is called `reached`."""
    found = []
    for table in re.findall(r"(?:^\|.*\n)+", text, re.M):
        lines = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in table.splitlines()]
        if lines[0][-1].strip() == "reached":
            found += [(dict(zip(lines[0][:-1], line)), line[-1] == "yes") for line in lines[2:]]
    return found


def missed_text(rows):
    """The goals that were missed, each with its goal and what was found; a table's heading stands before its first."""
    notes, heading = [], ""
    for row in rows:
        (what, name), *rest = row.items()
        found = [f"{header} {cell}" for header, cell in rest if header.startswith("goal")]
        found.append("measured " + row["measured"] if "measured" in row else " ".join(rest[-1]))
        tells = what != heading and what.split(",")[0] not in ("goal", "condition")
        heading = what
        notes.append(f"{what + ': ' if tells else ''}{name} ({', '.join(found)})")
    return "; ".join(notes)


def verdicts_text(results):
    """A row for every part that has goals: how many are reached, and which are not."""
    lines = ["| part | goals reached | missed |", "|---|---:|---|"]
    for path in sorted(glob.glob(os.path.join(results, "*.md"))):
        with open(path, encoding="utf-8") as file:
            found = goals(file.read())
        missed = missed_text(row for row, reached in found if not reached)
        link = os.path.relpath(path, os.path.join(ROOT, "docs"))
        if found:
            name = os.path.basename(path).removesuffix(".md")
            lines.append(f"| [{name}]({link}) | {sum(reached for _, reached in found)} of {len(found)} | {missed or '-'} |")
    return "\n".join(lines)


def main():
    print(machine_text())
    if len(sys.argv) > 1:
        results = sys.argv[1]
        document = sys.argv[2] if len(sys.argv) > 2 else os.path.join(ROOT, "docs/performance.md")
        write_document(os.path.join(results, "README.md"), "machine",
                       "\n\n".join(filter(None, (machine_text(), seconds_text(results)))))
        verdicts = verdicts_text(results)
        print(verdicts)
        with open(document, encoding="utf-8") as file:
            about = os.path.basename(os.path.normpath(results)) + "/" in file.read()
        if about:
            write_document(document, "verdicts", verdicts)


if __name__ == "__main__":
    main()
