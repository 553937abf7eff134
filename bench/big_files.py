#!/usr/bin/env python3
"""Large files of routes: processor time and memory of `hawser route`.

    bench/big_files.py HAWSER [FOLDER]     (FOLDER: where the files are written, 120 MB; default: a temporary one)

A table of 50 000 points, one a metre, that scatter by 10 mm about straights, bends of 10 to 200 m and no transitions; a drawing of
100 MB: contour lines, lines, texts and blocks on ten layers, and a route on one of its own.
"""
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
import time

POINTS, SCATTER, DRAWING = 50_000, 0.010, 100e6


def bends(draw, length):
    """Straights and bends in turn, whose headings stay within 60 degrees: curvature and length of each."""
    s = heading = 0.0
    while s < length:
        straight, radius = draw.uniform(5, 120), draw.uniform(10, 200)
        turn = max(-1.05, min(1.05, heading + draw.choice((-1, 1)) * draw.uniform(0.15, 1.0))) - heading
        yield 0.0, straight
        if abs(turn) > 0.1:
            yield math.copysign(1 / radius, turn), abs(turn) * radius
            heading += turn
        s += straight + abs(turn) * radius


def points_write(path):
    draw = random.Random(62)
    x = y = heading = 0.0
    left, rows = 1.0, []
    for curvature, length in bends(draw, POINTS):
        s = 0.0
        while s < length and len(rows) < POINTS:
            step = min(left, length - s)
            x += step * math.cos(heading + 0.5 * curvature * step)
            y += step * math.sin(heading + 0.5 * curvature * step)
            heading += curvature * step
            s += step
            left -= step
            if left < 1e-9:
                rows.append(f"{x + draw.gauss(0, SCATTER):.3f},{y + draw.gauss(0, SCATTER):.3f}\n")
                left = 1.0
    with open(path, "w", encoding="ascii") as f:
        f.write("x (m),y (m)\n")
        f.writelines(rows)


def pairs(*values):
    return "".join(f"{code:3d}\n{value}\n" for code, value in values)


def drawing_write(path):
    draw = random.Random(62)
    with open(path, "w", encoding="ascii") as f:
        f.write(pairs((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, 6), (0, "ENDSEC"), (0, "SECTION"),
                      (2, "BLOCKS"), (0, "BLOCK"), (8, "0"), (2, "tree"), (70, 0), (10, 0), (20, 0), (0, "CIRCLE"), (8, "0"), (10, 0), (20, 0),
                      (40, 1), (0, "ENDBLK"), (8, "0"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")))
        f.write(pairs((0, "LWPOLYLINE"), (8, "route"), (90, 4), (70, 0), (10, 0), (20, 0), (10, 300), (20, 0), (10, 300), (20, 200), (10, 800), (20, 400)))
        while f.tell() < DRAWING:
            layer, x, y = f"contours-{draw.randrange(10)}", draw.uniform(0, 5e3), draw.uniform(0, 5e3)
            kind = draw.random()
            if kind < 0.3:
                n = draw.randrange(50, 400)
                f.write(pairs((0, "LWPOLYLINE"), (100, "AcDbEntity"), (8, layer), (100, "AcDbPolyline"), (90, n), (70, 0)))
                for _ in range(n):
                    x, y = x + draw.uniform(0, 2), y + draw.uniform(-1, 1)
                    f.write(f" 10\n{x:.3f}\n 20\n{y:.3f}\n")
            elif kind < 0.6:
                f.write(pairs((0, "LINE"), (8, layer), (10, f"{x:.3f}"), (20, f"{y:.3f}"), (11, f"{x + 5:.3f}"), (21, f"{y + 1:.3f}")))
            elif kind < 0.8:
                f.write(pairs((0, "INSERT"), (8, layer), (2, "tree"), (10, f"{x:.3f}"), (20, f"{y:.3f}")))
            else:
                f.write(pairs((0, "TEXT"), (8, layer), (10, f"{x:.3f}"), (20, f"{y:.3f}"), (40, 2.5), (1, f"{y:.1f}")))
        f.write(pairs((0, "ENDSEC"), (0, "EOF")))


def measured(*command):
    """Status, processor time in s, peak memory in MB, what it said last."""
    start = time.monotonic()
    with tempfile.TemporaryFile() as out:
        child = subprocess.Popen(command, stdout=out, stderr=subprocess.STDOUT)
        _, status, used = os.wait4(child.pid, 0)
        out.seek(0)
        said = out.read().decode(errors="replace").strip().splitlines() or [""]
    return os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, time.monotonic() - start, said[-1][:60]


def main(hawser, folder):
    table, drawing = os.path.join(folder, "points.csv"), os.path.join(folder, "drawing.dxf")
    points_write(table)
    drawing_write(drawing)
    print("| file | size, MB | status | processor time, s | by the clock, s | memory, MB |\n|---|---|---|---|---|---|")
    for name, words in ((f"{POINTS} points", [table]), ("drawing, all lines", [drawing]), ("drawing, one layer", [drawing, "--layer", "route"])):
        status, used, memory, clock, said = measured(hawser, "route", *words)
        print(f"| {name} | {os.path.getsize(words[0]) / 1e6:.1f} | {status} | {used:.1f} | {clock:.1f} | {memory:.0f} |")
        if status:
            print(said, file=sys.stderr)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if len(sys.argv) == 3:
        main(*sys.argv[1:])
    else:
        with tempfile.TemporaryDirectory() as temporary:
            main(sys.argv[1], temporary)
