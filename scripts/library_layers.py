"""Writes library/cables-by-layers.yaml: single-core XLPE cables of which no public table of sizes and masses was found, built up layer
by layer from the thicknesses of public standards (docs/guide/equipment.md, "Sources of the catalogue").

Usage: library_layers.py [--check]      (from the project's folder; --check: says whether the file is what this would write)
"""
import math
import os
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
PATH = os.path.join(ROOT, "library/cables-by-layers.yaml")

# Diameters of compacted conductors, mm: the middle of what IEC 60228 allows.
ROUND = {95: 11.5, 120: 12.9, 150: 14.35, 185: 16.05, 240: 18.4, 300: 20.65, 400: 23.45, 500: 26.45, 630: 30.6}
FILLING, MILLIKEN_FILLING, MILLIKEN_FROM = 0.90, 0.80, 1200  # metal in the circle; conductors in segments from this section on
DENSITY = {"cu": 8.89, "al": 2.70, "xlpe": 0.93, "pe": 0.95, "tape": 0.6}  # g/cm3
LAY = 1.05  # screen wires are so much longer than the cable

# Insulation, mm, by section: GB/T 11017.2 (64/110 kV) and GB/T 18890.2 (127/220 kV), GB/T 22078.2 (290/500 kV).
THICK = {
    64: {240: 19.0, 300: 18.5, 400: 17.5, 500: 17.0, 630: 16.5, 800: 16.0},
    127: {400: 27.0, 500: 27.0, 630: 26.0, 800: 25.0, 1000: 24.0},
    290: {800: 34.0, 1000: 33.0, 1600: 32.0, 2500: 31.0},
}
# Name, kV to earth, screens within and without, bedding, screen's copper, mm2, and its wires, mm; (section, metal) that are listed.
SERIES = [
    ("20kv", 12, 0.5, 0.5, 0.3, 25, 0.8, [(s, m) for s in (95, 150, 240, 400) for m in ("cu", "al")]),
    ("33kv", 18, 0.5, 0.5, 0.3, 35, 1.0, [(s, m) for s in (150, 240, 400, 630) for m in ("cu", "al")]),
    ("110kv", 64, 1.5, 1.0, 1.0, 95, 1.5, [(s, "cu") for s in (240, 400, 630, 800, 1200, 1600)] + [(630, "al"), (1000, "al")]),
    ("132kv", 76, 1.5, 1.0, 1.0, 95, 1.5, [(s, "cu") for s in (400, 630, 800, 1000, 1600)] + [(1000, "al")]),
    ("220kv", 127, 1.5, 1.0, 1.0, 150, 1.8, [(s, "cu") for s in (800, 1000, 1600, 2500)] + [(1600, "al")]),
    ("400kv", 230, 1.5, 1.2, 1.0, 185, 2.0, [(s, "cu") for s in (1000, 1600, 2000, 2500)] + [(2000, "al")]),
]
MEDIUM = {12: 5.5, 18: 8.0}  # IEC 60502-2: 12/20 kV and 18/30 kV, for all sections


def conductor(section):
    """Diameter, mm."""
    filling = MILLIKEN_FILLING if section >= MILLIKEN_FROM else FILLING
    return ROUND.get(section) or math.sqrt(4 * section / (math.pi * filling))


def tabled(volts, section):
    """A standard's thickness for the largest section of its table that is not above; mm."""
    table = THICK[volts]
    return table[max([s for s in table if s <= section] or [min(table)])]


def insulation(volts, section):
    """Linear in the voltage to earth between the standards."""
    if volts in MEDIUM:
        return MEDIUM[volts]
    known = sorted(THICK)
    low = max(v for v in known if v <= volts)
    high = min(v for v in known if v >= volts)
    share = (volts - low) / (high - low) if high > low else 0
    return (1 - share) * tabled(low, section) + share * tabled(high, section)


def ring(outer, inner):
    return math.pi * (outer ** 2 - inner ** 2) / 4


def cable(volts, section, metal, inner, outer, bedding, screen, wire, thickness=None):
    """Diameter, mm, and mass, kg/m."""
    core = conductor(section)
    insulated = core + 2 * (inner + (thickness or insulation(volts, section)) + outer)
    bedded = insulated + 2 * bedding
    screened = bedded + 2 * wire
    sheath = max(1.8, 0.035 * screened + 1.0)  # IEC 60502-2
    d = screened + 2 * sheath
    grams = (DENSITY[metal] * section + DENSITY["xlpe"] * ring(insulated, core) + DENSITY["tape"] * ring(bedded, insulated)
             + DENSITY["cu"] * LAY * screen + DENSITY["pe"] * ring(d, screened))
    return d, grams / 1000


def text():
    lines = ["# Written by scripts/library_layers.py: change that. docs/guide/equipment.md, \"Sources of the catalogue\", says how good the rule is.",
             "sources:",
             "  layers: built up by layers from IEC 60228, IEC 60502-2, GB/T 11017.2, GB/T 18890.2, GB/T 22078.2 (docs/guide/equipment.md)",
             "cables:"]
    metals = {"cu": "copper", "al": "aluminium"}
    for name, volts, inner, outer, bedding, screen, wire, members in SERIES:
        for section, metal in members:
            d, mass = cable(volts, section, metal, inner, outer, bedding, screen, wire)
            lines += [f"  xlpe-{name}-{section}-{metal}:",
                      f"    d: {d:.1f} mm",
                      f"    mass: {mass:.3g} kg/m",
                      f"    conductor: {{material: {metals[metal]}, area: {section} mm2}}",
                      "    range: {d: 12 %, mass: 15 %}",
                      "    mark: estimated",
                      f"    note: single core, insulation {insulation(volts, section):.1f} mm, screen {screen} mm2 of copper wires, PE;"
                      " no lead or corrugated sheath",
                      "    source: layers"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if "--check" in sys.argv:
        with open(PATH) as f:
            sys.exit(0 if f.read() == text() else "library/cables-by-layers.yaml is not what scripts/library_layers.py writes")
    with open(PATH, "w") as f:
        f.write(text())
