"""The pictures of docs/guide/routes-from-files.md from what bench/fit_figures.c computes: docs/img/fit-*.svg.

Usage: routes_pictures.py PROGRAM     (bench_fit_figures of a build; from the root)
"""
import subprocess
import sys

from svgplot import Panel, write_svg


def tables(program):
    """Name -> list of rows of floats, as the program prints them: '# name' over lines of numbers."""
    out, name = {}, None
    for line in subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines():
        if line.startswith("#"):
            name = line[1:].strip()
            out[name] = []
        else:
            out[name].append([float(word) for word in line.split()])
    return out


def columns(rows):
    return list(zip(*rows))


def main():
    data = tables(sys.argv[1])
    x, y = columns(data["points"])
    fx, fy = columns(data["fit"])
    jx, jy = columns(data["joints"])
    plan = Panel("east, m", "north, m", height=300)
    plan.add("points, 10 mm of noise", x, y, "#c0c0c0", marks=True).add("fit", fx, fy, "#0060b0")
    plan.add("where pieces join", jx, jy, "#c03030", marks=True)
    s, k = columns(data["curvature of the fit"])
    t, true = columns(data["curvature of the route"])
    p, raw = columns(data["curvature by neighbours"])
    bend = Panel("m in plan", "curvature, 1/m", bottom=-0.15, top=0.15)
    bend.add("of three points", p, raw, "#d8d8d8").add("route", t, true, "#c03030", dash="6 3").add("fit", s, k, "#0060b0")
    d, off = columns(data["deviation, mm"])
    away = Panel("m in plan", "points beside the fit, mm", height=150)
    away.add("", d, off, "#888888", marks=True).level("", 50).level("", -50)
    write_svg("docs/img/fit-plan.svg", "A route of 20 pieces from points with 10 mm of noise", [plan, bend, away])
    u, z = columns(data["heights"])
    v, w = columns(data["profile"])
    a, b = columns(data["joints of the profile"])
    rise = Panel("m in plan", "height, m")
    rise.add("points", u, z, "#c0c0c0", marks=True).add("fit", v, w, "#0060b0")
    rise.add("where pieces join", a, b, "#c03030", marks=True)
    write_svg("docs/img/fit-profile.svg", "Its heights: grades and vertical arcs", [rise])


if __name__ == "__main__":
    main()
