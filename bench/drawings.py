#!/usr/bin/python3
"""Line lengths of drawings: `hawser route` beside ezdxf (Debian: python3-ezdxf).

    bench/drawings.py HAWSER FOLDER [--markdown]

Every .dxf below FOLDER is read by both. Per drawing: the sum of the lengths of all lines in model space, those of inserted
blocks included, in metres. A line drawn twice on one layer counts once, and one straight up or down does not count, as in `hawser route`.
"""
import collections
import json
import math
import pathlib
import subprocess
import sys

import ezdxf
from ezdxf import path, recover

METRES = {1: 0.0254, 2: 0.3048, 3: 1609.344, 4: 1e-3, 5: 1e-2, 6: 1, 7: 1e3, 8: 0.0254e-6, 9: 0.0254e-3, 10: 0.9144,
          13: 1e-6, 14: 0.1, 15: 10, 16: 100, 21: 1200 / 3937, 22: 100 / 3937, 23: 3600 / 3937, 24: 5280 * 1200 / 3937}
NEVER = ("*X", "*D", "*T")


def places(entity):
    """Points along an entity, chords 0.1 mm off at most; None: it is no line."""
    kind = entity.dxftype()
    if kind == "LINE":
        return [entity.dxf.start, entity.dxf.end]
    if kind not in ("ARC", "LWPOLYLINE", "POLYLINE", "SPLINE", "ELLIPSE"):
        return None
    if kind == "POLYLINE" and not (entity.is_2d_polyline or entity.is_3d_polyline):
        return None
    if kind == "ARC" and not entity.dxf.radius > 0:
        return None
    if kind == "ELLIPSE":
        turn = (entity.dxf.end_param - entity.dxf.start_param) % math.tau
        if turn < 1e-9 or turn > math.tau - 1e-9:
            return None
    if kind == "SPLINE" and not len(entity.control_points):
        return list(entity.fit_points)
    way = path.make_path(entity)
    extent = max((abs(c) for p in way.control_vertices() for c in p - way.start), default=1)
    return list(way.flattening(max(extent, 1e-9) * 1e-7, segments=16))


def entities(layout, layer=None, depth=0):
    for e in layout:
        try:
            own = e.dxf.get("layer", "0")
        except ezdxf.DXFError:  # a kind that it does not know
            continue
        own = layer if layer is not None and own == "0" else own
        if e.dxf.get("invisible", 0) == 1:
            continue
        if e.dxftype() != "INSERT":
            yield e, own
            continue
        if depth > 32 or e.dxf.name[:2].upper() in NEVER or e.block() is None:
            continue
        for one in (e.multi_insert() if e.mcount > 1 else [e]):
            yield from entities(one.virtual_entities(), own, depth + 1)


def by_ezdxf(file):
    try:
        doc = ezdxf.readfile(file)
    except Exception:
        doc, _ = recover.readfile(file)
    unit = METRES.get(doc.header.get("$INSUNITS", 0), 1)
    met, total = set(), 0
    for block in doc.blocks:  # of a dimension in a block ezdxf makes lines, of one beside it none
        for e in block.query("DIMENSION") if not block.is_any_layout else ():
            block.delete_entity(e)
    kinds = collections.Counter()
    for e, layer in entities(doc.modelspace()):
        points = places(e)
        if not points or len(points) < 2:
            continue
        length = sum(a.distance(b) for a, b in zip(points, points[1:])) * unit
        plan = sum(math.hypot(b.x - a.x, b.y - a.y) for a, b in zip(points, points[1:])) * unit
        ends = sorted((round(p.x * unit, 5), round(p.y * unit, 5), round(p.z * unit, 5)) for p in (points[0], points[-1]))
        middle = points[len(points) // 2] * unit
        half = tuple(round(c, 4) for c in middle) if len(points) > 2 else ()  # two halves of a circle have the same ends
        key = (layer.lower(), tuple(ends), round(length, 4), half)
        if plan < 2e-6 or key in met:
            continue
        met.add(key)
        total += length
        kinds[e.dxftype()] += 1
    return total, kinds


def lines_by_text(file):
    """How many lines a drawing that ezdxf does not read has among its entities, whatever else is in it."""
    text = pathlib.Path(file).read_bytes().decode("latin-1").split("ENTITIES", 1)[-1].split("ENDSEC", 1)[0]
    return sum(text.count(f"\n{kind}\r\n") + text.count(f"\n{kind}\n")
               for kind in ("LINE", "ARC", "LWPOLYLINE", "POLYLINE", "SPLINE"))


def by_hawser(program, file):
    run = subprocess.run([program, "route", file, "--json", "--join", "0.00001m"], capture_output=True, text=True)
    if run.returncode:
        return None, run.stderr.strip().split(": ", 1)[-1].replace(str(file), "").lstrip(": ")
    lines = json.loads(run.stdout)
    return sum(a["length_m"] for a in lines["alignments"]), "; ".join(lines["ignored"])


def main():
    program, folder = sys.argv[1:3]
    markdown = "--markdown" in sys.argv
    for file in sorted(pathlib.Path(folder).rglob("*.[dD][xX][fF]")):
        try:
            theirs, kinds = by_ezdxf(str(file))
            many = sum(kinds.values())
        except Exception as e:
            theirs, many = math.nan, f"ezdxf: {type(e).__name__} {str(e)[:60]}"
        ours, said = by_hawser(program, str(file))
        if ours is None:
            verdict = "refused" if theirs == 0 or (math.isnan(theirs) and not lines_by_text(file)) else "REFUSED"
        else:
            verdict = "read" if math.isnan(theirs) or abs(ours - theirs) <= 1e-4 * theirs else "DIFFERS"
        name = file.relative_to(folder)
        row = [name, verdict, many, f"{theirs:.4f}", "-" if ours is None else f"{ours:.4f}", said[:300]]
        print("| " + " | ".join(map(str, row)) + " |" if markdown else "\t".join(map(str, row)), flush=True)


main()
