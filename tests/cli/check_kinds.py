#!/usr/bin/env python3
"""Files as people have them, three of each kind that was once read wrong: the length of what is read, by hand, or the reason why it is
refused.

Usage: check_kinds.py HAWSER
"""
import json
import math
import os
import subprocess
import sys
import tempfile


def flat(*entities):
    return "".join(f"{word}\n" for entity in entities for word in entity)


def dxf(*entities, head="", blocks=""):
    text = flat((0, "SECTION", 2, "HEADER")) + head + flat((0, "ENDSEC",)) if head else ""
    text += flat((0, "SECTION", 2, "BLOCKS")) + blocks + flat((0, "ENDSEC")) if blocks else ""
    return text + flat((0, "SECTION", 2, "ENTITIES"), *entities, (0, "ENDSEC", 0, "EOF"))


def line(x0, y0, x1, y1, layer="C"):
    return (0, "LINE", 8, layer, 10, x0, 20, y0, 11, x1, 21, y1)


def block(name, *entities):
    return flat((0, "BLOCK", 2, name, 10, 0, 20, 0), *entities, (0, "ENDBLK"))


def insert(name, x, y, *more, layer="C"):
    return (0, "INSERT", 8, layer, 2, name, 10, x, 20, y, *more)


EMBEDDED = (101, "Embedded Object", 70, 1, 10, 1.0, 20, 0.0)
MM = flat((9, "$INSUNITS", 70, 4))
CABLE = line(0, 0, 80, 0)
FEATURE = '{"type":"Feature","properties":{"name":"%s"},"geometry":{"type":"LineString","coordinates":[[10,60],[10,60.00%d]]}}'
MERIDIAN = 111.4  # m, a thousandth of a degree of latitude at 60 degrees on WGS 84
PARALLEL = 75.49  # m, a thousandth of a degree of longitude at 47.4 degrees

# name: text, and the lengths of its lines in m, or a part of the reason why it is refused
KINDS = {
    "embedded-attdef.dxf": (dxf((0, "ATTDEF", 8, "C", 10, 0, 20, 0, 1, "x", *EMBEDDED), CABLE), [80]),
    "embedded-mtext.dxf": (dxf(CABLE, (0, "MTEXT", 8, "T", 100, "AcDbEntity", 100, "AcDbMText", 10, 1, 20, 1, 40, 2, 1, "a", *EMBEDDED)), [80]),
    "embedded-attrib.dxf": (dxf((0, "INSERT", 8, "M", 2, "P", 66, 1, 10, 3, 20, 3),
                                (0, "ATTRIB", 8, "M", 1, "pit", 2, "NAME", 102, "{ACAD_X", 330, "1F", 102, "}", *EMBEDDED[:4]),
                                (0, "SEQEND"), CABLE), [80]),
    "anonymous-scaled.dxf": (dxf(insert("*U3", 5, 5, 41, 2), blocks=block("*U3", line(0, 0, 40, 0))), [80]),
    "anonymous-nested.dxf": (dxf(insert("OUT", 0, 0), blocks=block("*U7", line(0, 0, 40, 0)) +
                                 block("OUT", insert("*U7", 1, 1, 50, 90), insert("*U7", 1, 41, 50, 90))), [80]),
    "anonymous-mirrored.dxf": (dxf(insert("*U1", 0, 0, 41, -1, layer="0"), insert("*D4", 0, 0, layer="0"),
                                   blocks=block("*U1", line(0, 0, 80, 0, "0")) + block("*D4", line(0, 0, 7, 0, "0"))), [80]),
    "bad-arc.dxf": (dxf((0, "ARC", 8, "C", 10, 0, 20, 0, 40, -3, 50, 0, 51, 90), CABLE), [80]),
    "bad-circle.dxf": (dxf(CABLE, (0, "CIRCLE", 8, "C", 10, 0, 20, 0, 40, 0)), [80]),
    "bad-ellipse.dxf": (dxf(CABLE, (0, "ELLIPSE", 8, "C", 10, 0, 20, 0, 11, 0, 21, 0, 40, 0.5, 41, 0, 42, 1)), [80]),
    "text-of-two-lines.dxf": (dxf((0, "TEXT", 8, "T", 10, 0, 20, 0, 40, 1, 1, "two\nlines"), CABLE), [80]),
    "text-blank-line.dxf": (dxf((0, "MTEXT", 8, "T", 10, 0, 20, 0, 40, 1, 1, "a\n\nb"), CABLE), [80]),
    "text-of-numbers.dxf": (dxf(CABLE, (0, "ATTDEF", 8, "T", 10, 0, 20, 0, 40, 1, 1, "7\n8\n9", 2, "T")), [80]),
    "mark.dxf": ("\ufeff" + dxf(CABLE).replace("\n", "\r\n"), [80]),
    "mark.csv": ("\ufeffx (m),y (m)\n0,0\n80,0\n", [80]),
    "mark.geojson": ('\ufeff{"type":"LineString","coordinates":[[10,60],[10,60.001]]}', [MERIDIAN]),
    "gradient-percent.csv": ("Length,Gradient %\n100,5\n100,-2\n", [200]),
    "neigung-promille.csv": ("Länge;Neigung (‰)\n100;50\n100;-20\n", [200]),
    "incline-degrees.csv": ("Length (m),Incline (deg)\n100,5\n100,-2\n", [200]),
    "course-azimuth.csv": ("Course,Distance (m),Azimuth (deg)\nA-B,100,45\nB-C,50,135\n", [150]),
    "quadrant-bearing.csv": ("Distance,Bearing\n100,N 45 E\n50,S 45 E\n", [150]),
    "richtung-gon.csv": ("Entfernung;Richtungswinkel (gon)\n100;50\n50;150\n", [150]),
    "sum.csv": ("Section,Length\n1,100\n2,50\nSum,150\n", [150]),
    "gesamt.csv": ("Name;Länge (m)\nA;100,5\nB;49,5\nGesamt;150,0\n", [150]),
    "sum-without-a-word.csv": ("No,Length,Angle,Radius,Turn\n1,100,,,\n2,,90,10,left\n3,50,,,\n,165.708,,,\n", "a sum is no piece"),
    "two-features.geojsonl": (FEATURE % ("a", 1) + "\n" + FEATURE % ("b", 2) + "\n", [MERIDIAN, 2 * MERIDIAN]),
    "record-separators.geojsonl": ("\x1e" + FEATURE % ("a", 1) + "\n\x1e" + FEATURE % ("b", 2) + "\n", [MERIDIAN, 2 * MERIDIAN]),
    "cut-off.geojsonl": (FEATURE % ("a", 1) + '\n{"type":"Feature",\n', "no JSON"),
    "joined-behind.dxf": (dxf(line(50, 0, 80, 0), line(0, 0, 50, 0)), [80]),
    "joined-reversed.dxf": (dxf(line(50, 0, 80, 40), line(50, 0, 0, 0), line(80, 40, 80, 90)), [150]),
    "joined-by-an-arc.dxf": (dxf((0, "ARC", 8, "C", 10, 50, 20, 10, 40, 10, 50, 270, 51, 0), line(60, 10, 60, 80), line(0, 0, 50, 0)),
                             [120 + 5 * math.pi]),
    "degrees-as-x-and-y.csv": ("X;Y\n8.5;47.4\n8.501;47.4\n", "degrees?"),
    "longitude-latitude.csv": ("Longitude,Latitude,Name\n8.5,47.4,a\n8.501,47.4,b\n", [PARALLEL]),
    "latitude-first.csv": ("lat,lon\n47.4,8.5\n47.4,8.501\n", [PARALLEL]),
    "metres-called-mm.dxf": (dxf(line(0, 0, 50, 0), line(50, 0, 50, 60), head=MM), [0.11]),
    "map-metres-called-mm.dxf": (dxf(line(453000, 6712000, 453080, 6712000), head=MM), [0.08]),
    "true-mm.dxf": (dxf(line(0, 0, 50000, 0), line(50000, 0, 50000, 30000), head=MM), [80]),
    "station-height.csv": ("Station,Height\n0,10\n50,12\n100,11\n", [math.hypot(50, 2) + math.hypot(50, 1)]),
    "chainage-niveau.csv": ("Chainage (m);Niveau\n0;10\n50;12\n", [math.hypot(50, 2)]),
    "abstand-hoehe.csv": ("Abstand;Höhe\n0;10\n50;12\n100;15\n", "not known: 1 'Abstand'"),
    "slope-of-two.csv": ("Length,Slope\n100,2.5\n100,-1\n", "per cent?"),
    "slope-percent-cells.csv": ("Length,Slope\n100,2.5%\n100,-1%\n", [200]),
    "pente.csv": ("Longueur;Pente\n100;3\n100;-2\n", "per cent?"),
}
CABLES = """cables: {c: {d: 1.2 in, mass: %s}}
bundle: {cables: %d}
route: {pieces: [{straight: 100 ft}, {bend: 90 deg, radius: 4 ft, plane: left}]}
surfaces: {ducts: [{radius: %s in}]}
friction: {mu: 0.35}
limits: {conductor: {material: copper, area: %s}, sidewall: 500 lbf/ft}
"""
POUND, FOOT = 0.45359237, 0.3048
# mass, cables, radius of the duct in inches, area; a figure of `theory --format json` and what it is, or why the case is refused
CASES = [
    ("3200 lb/kft", 1, "2", "750 kcmil", "weight_N_per_m", 9.81 * 3.2 * POUND / FOOT),
    ("3.2 lbs/ft", 1, "2", "750 kcmil", "weight_N_per_m", 9.81 * 3.2 * POUND / FOOT),
    ("3200 lb/Mft", 1, "2", "750 kcmil", "weight_N_per_m", 9.81 * 3.2 * POUND / FOOT),
    ("3.2 lb/ft", 1, "2", "750 MCM", "pull", 70e6 * 750 * 5.067074790975e-7),
    ("3.2 lb/ft", 1, "2", "0.75 Mcmil", None, "unknown unit 'Mcmil'"),
    ("3.2 lb/ft", 1, "2", "1 Mcmil", None, "M is a thousand in MCM"),
    *(("1.5 lb/ft", 4, str(r), "500 kcmil", "diamond", 1 + 2 * (1.2 / (2 * r - 1.2)) ** 2) for r in (2.2, 2.8, 3.2)),
]
NEAR = 2e-3  # of a length: corners without a radius are rounded


def main():
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        for name, (text, truth) in KINDS.items():
            path = os.path.join(folder, name)
            with open(path, "w", encoding="utf-8", newline="") as out:
                out.write(text)
            done = subprocess.run([sys.argv[1], "route", path, "--json"], capture_output=True, text=True, timeout=60, check=False)
            if isinstance(truth, str):
                if done.returncode != 2 or truth not in done.stderr:
                    bad.append(f"{name}: status {done.returncode}, not refused for '{truth}': {done.stderr}")
                continue
            lengths = [a["length_m"] for a in json.loads(done.stdout)["alignments"]] if done.returncode == 0 else []
            if len(lengths) != len(truth) or any(abs(a - b) > NEAR * b for a, b in zip(lengths, truth)):
                bad.append(f"{name}: {lengths} for {truth}: {done.stderr}")
        for mass, cables, radius, area, figure, truth in CASES:
            path = os.path.join(folder, "case.yaml")
            with open(path, "w", encoding="utf-8") as out:
                out.write(CABLES % (mass, cables, radius, area))
            done = subprocess.run([sys.argv[1], "theory", path, "--format", "json"], capture_output=True, text=True, timeout=60, check=False)
            if figure is None:
                if done.returncode != 2 or truth not in done.stderr:
                    bad.append(f"{mass}, {area}: not refused for '{truth}': {done.stderr}")
                continue
            o = json.loads(done.stdout)
            found = o[figure] if figure in o else next(l["limit"] for l in o["limits"] if l["name"] == "pull")
            if figure == "diamond":
                found = o["ducts"][0]["weight_factor"] if o["ducts"][0]["layout"] == figure else None
            if found is None or abs(found / truth - 1) > 1e-5:
                bad.append(f"{mass}, {cables} in {radius} in, {area}: {figure} {found} for {truth}")
    print("\n".join(bad))
    return int(bool(bad))


sys.exit(main())
