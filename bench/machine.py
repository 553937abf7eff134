#!/usr/bin/env python3
"""Writes what the machine is, and how long each part took, between the markers `<!-- machine: begin -->` and
`<!-- machine: end -->` of a document.

Usage: machine.py [DOCUMENT RESULTS]     (without them: prints it)
"""
import csv
import os
import re
import subprocess
import sys

from common import machine_name, processor, write_document

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


def main():
    if len(sys.argv) == 3:
        document, results = sys.argv[1:]
        write_document(document, "machine", "\n\n".join(filter(None, (machine_text(), seconds_text(results)))))
    print(machine_text())


if __name__ == "__main__":
    main()
