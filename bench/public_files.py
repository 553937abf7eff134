#!/usr/bin/env python3
"""Models and tracks of public repositories: which `hawser route` reads, which it refuses and why, and whether lengths agree.

    bench/public_files.py HAWSER FOLDER EXTENSION     (EXTENSION: ifc or gpx; drawings: bench/drawings.py)

IFC: beside each file the sum of SegmentLength over all segments of horizontal alignments that stand in it (of the drafts: of the curve
segments). GPX: the sum of the lengths of its tracks and routes over the ellipsoid, WGS 84, by the radii of curvature at their points.
A line agrees within 1e-4, or 2 mm. Prints one row for each outcome, then the files that differ.
"""
import collections
import json
import math
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

SEGMENT = re.compile(r"IFCALIGNMENTHORIZONTALSEGMENT\(([^;]*)\)\s*;|IFC(?:LINE|CIRCULARARC|TRANSITIONCURVE)SEGMENT2D\(([^;]*)\)\s*;")
AXIS, FLAT = 6378137.0, 1 / 298.257223563


def length_of_ifc(file):
    """Sum of the lengths of all segments in plan, in the file's unit; NAN: it has none."""
    text, total, n = file.read_text(errors="replace"), 0.0, 0
    for segment in SEGMENT.finditer(text):
        arguments = re.sub(r"'(?:[^']|'')*'", "''", segment[1] or segment[2]).split(",")
        total += float(arguments[6 if segment[1] else 2])
        n += 1
    return total if n else math.nan


def step(a, b):
    latitude = math.radians((a[0] + b[0]) / 2)
    square = FLAT * (2 - FLAT)
    w = 1 - square * math.sin(latitude) ** 2
    north = AXIS * (1 - square) / w**1.5 * math.radians(b[0] - a[0])
    east = AXIS / math.sqrt(w) * math.cos(latitude) * math.radians(math.remainder(b[1] - a[1], 360))
    return math.hypot(north, east)


def length_of_gpx(file):
    """Sum of the lengths of all tracks' segments and routes, m."""
    total, n = 0.0, 0
    for line in xml.etree.ElementTree.parse(file).iter():
        if line.tag.rsplit("}", 1)[-1] not in ("trkseg", "rte"):
            continue
        places = [(float(p.get("lat")), float(p.get("lon"))) for p in line if p.tag.rsplit("}", 1)[-1] in ("trkpt", "rtept")]
        total += sum(map(step, places, places[1:]))
        n += len(places) > 1
    return total if n else math.nan


def main():
    program, folder, ending = sys.argv[1:4]
    outcomes, differ = collections.Counter(), []
    for file in sorted(p for p in pathlib.Path(folder).rglob("*") if p.suffix.lower() == "." + ending and p.is_file()):
        run = subprocess.run([program, "route", str(file), "--json"], capture_output=True, text=True, timeout=600)
        try:
            own = (length_of_ifc if ending == "ifc" else length_of_gpx)(file)
        except (ValueError, IndexError, TypeError, xml.etree.ElementTree.ParseError):
            own = math.nan
        if run.returncode not in (0, 2):
            outcomes[f"crash: status {run.returncode}"] += 1
            continue
        if run.returncode:
            why = re.sub(r"[0-9]+(\.[0-9]+)?", "N", run.stderr.strip().replace(str(file), "").removeprefix("hawser: ").lstrip(":0123456789 "))
            outcomes[("refused: " if math.isnan(own) or own == 0 else "refused, with segments: ") + why[:150]] += 1
            continue
        lines = json.loads(run.stdout)
        unit = float(lines["unit"].split()[0]) if ending == "ifc" else 1
        length = sum(a["horizontal_length_m"] for a in lines["alignments"])
        many = len(lines["alignments"])
        if math.isnan(own):
            outcomes["read, no segments to compare with"] += 1
        elif abs(length - own * unit) < 2e-3 + 1e-4 * length:
            outcomes["read, lengths agree"] += 1
        else:
            outcomes["read, lengths differ"] += 1
            differ.append(f"{file.relative_to(folder)}: {many} lines, {length:.4f} m, by its segments {own * unit:.4f} m"
                          f" {'; '.join(lines['ignored'])[:200]}")
    print("| outcome | files |\n|---|---|")
    for outcome, n in sorted(outcomes.items()):
        print(f"| {outcome} | {n} |")
    print(*differ, sep="\n")


main()
