"""Tables, verdicts and pictures of bench/precision.py, from its rows."""
import os
import statistics

from common import heading, pick, table
from precision_judge import cheapest, fit_order, frontier, observed_order, work_for
from svgplot import COLOURS, Panel, write_svg

DEFAULT = {"geometry": "smooth", "segment": 0.5, "method": "auto", "order": 2, "accuracy": 1e-3}
GOAL = 0.01  # of tension
LEVELS = (1e-2, 1e-3, 1e-4)
ON, NEAR = 1.25, 2.0  # times the frontier's work
SMALL = 1e-4  # errors below are of no use: left out of the frontiers' tables
KEYS = ("scene", "geometry", "segment", "method", "order", "accuracy")


def medians(rows):
    """One row a configuration that finished: its errors, which do not change, and the median of its work over the rounds."""
    groups = {}
    for row in rows:
        if row["outcome"] == "finished":
            groups.setdefault(tuple(row[key] for key in KEYS), []).append(row)
    return [{**group[0], "work_s": statistics.median(row["work_s"] for row in group)} for group in groups.values()]


def method_of(row):
    return {"auto": "auto", "esdirk": "one-step"}.get(row["method"], f"order {row['order']}")


def curve_name(row):
    """Everything but the accuracy, as far as it is not the default's."""
    words = [method_of(row)]
    words += [f"{row['segment']:g} m"] if row["segment"] != DEFAULT["segment"] else []
    words += [row["geometry"]] if row["geometry"] != DEFAULT["geometry"] else []
    return ", ".join(words)


def curves(points, error):
    """{name: [(work, error)]} of one scene, from loose to tight accuracy."""
    found = {}
    for row in sorted(points, key=lambda row: -row["accuracy"]):
        found.setdefault(curve_name(row), []).append((row["work_s"], row[error]))
    return found


def verdict(factor):
    return "on it" if factor <= ON else "near it" if factor <= NEAR else "off it"


def percent(value):
    return "-" if value is None else f"{100 * value:.3g}"


def errors_of(row, kind):
    """The four errors of a row, "time_" or "total_", in %."""
    return [percent(row[kind + name]) for name in ("rms", "largest", "peak", "load")]


def milli(value):
    return "-" if value is None else f"{1e3 * value:.1f}"


def the_default(points):
    found = pick(points, **DEFAULT)
    return found[0] if found else None


def judgement(scene, points, error):
    """Row of a table of verdicts: the default against the frontier at its own error, and what 1 % costs."""
    default, all_curves = the_default(points), curves(points, error)
    if not default:
        return [scene, "failed"] + ["-"] * 8
    work, name = cheapest(all_curves, default[error])
    factor = default["work_s"] / work
    goal, goal_name = cheapest(all_curves, GOAL)
    own = work_for(all_curves[curve_name(default)], GOAL)
    return [scene, percent(default[error]), milli(default["work_s"]), f"{factor:.2f}", name, verdict(factor),
            milli(goal), goal_name or "none", milli(own), f"{own / goal:.2f}" if own else "-"]


def verdicts_table(points, error):
    head = ["scene", "default's error, %", "its ms", "times the frontier", "frontier there", "the default is",
            "least ms for 1 %", "with", "ms for 1 % with auto, 0.5 m, smooth", "ratio"]
    body = []
    for scene in scenes_of(points):
        mine = [row for row in pick(points, scene=scene) if row[error] is not None and (error[:5] == "total" or
                                                                                         row["geometry"] == "smooth")]
        body.append(judgement(scene, mine, error))
    return table(head, body)


def levels_table(points, error, **where):
    """What errors of 1, 0.1 and 0.01 % cost: the least of all curves, and the default's method and mesh over that."""
    body = []
    for scene in scenes_of(points):
        mine = [row for row in pick(points, scene=scene, **where) if row[error] is not None]
        all_curves, cells = curves(mine, error), [scene]
        for level in LEVELS:
            least, name = cheapest(all_curves, level)
            own = work_for(all_curves.get("auto", []), level)
            cells += [milli(least), name or "none", f"{own / least:.2f}" if own else "-"]
        body.append(cells)
    return table(["scene"] + [word for level in LEVELS for word in (f"{100 * level:g} %: least ms", "with", "auto, 0.5 m, smooth: times that")],
                 body)


def scenes_of(points):
    return list(dict.fromkeys(row["scene"] for row in points))


def frontier_table(points):
    """The frontier in time of one scene and, in its place, the default."""
    mine = [row for row in points if row["segment"] == 0.5 and row["geometry"] == "smooth"]
    kept = [row for *_, row in frontier([(row["work_s"], row["time_rms"], k, row) for k, row in enumerate(mine)])]
    default = the_default(mine)
    body = []
    shown = [row for row in kept if row["time_rms"] >= SMALL]
    shown += [default] if default and default not in shown else []
    for row in sorted(shown, key=lambda row: row["work_s"]):
        mark = (" (default)" if row is default else "") + ("" if row in kept else " off the frontier")
        body.append([f"{method_of(row)}, {row['accuracy']:g}{mark}", milli(row["work_s"]), str(row["steps"]),
                     str(row["newton_iters"]), *errors_of(row, "time_")])
    return table(["setting", "ms", "steps", "Newton it.", "RMS, %", "largest, %", "peak, %", "load, %"], body)


def orders_table(points, sure):
    """Exponents of error and steps over accuracy, order by order; the theory's in the head."""
    orders = sorted({row["order"] for row in points})
    points, body = pick(points, method="bdf"), []
    for scene in scenes_of(points):
        floor, cells = 5 * sure[scene]["time smooth"], [scene]
        for order in orders:
            mine = pick(points, scene=scene, order=order, segment=0.5, geometry="smooth")
            fits = [fit_order([(row["accuracy"], row[key], row["time_rms"]) for row in mine], floor, 0.03)
                    for key in ("time_rms", "steps")]
            cells.append(" / ".join("-" if fit is None else f"{fit:.2f}" for fit in fits))
        body.append(cells)
    return table(["error / steps"] + [f"order {q}: {q / (q + 1):.2f} / {-1 / (q + 1):.2f}" for q in orders], body)


def meshes_table(points, sure):
    """The default accuracy on every mesh, and the error that the tightest run there leaves: that of space.

    The order of convergence is given where the reference and the tightest run in time are sure enough for it.
    """
    body = []
    for scene in scenes_of(points):
        for geometry in ("smooth", "cylinder"):
            mine = pick(points, scene=scene, geometry=geometry, method="bdf")
            tight = {row["segment"]: row for row in sorted(mine, key=lambda row: (row["order"] == 3, -row["accuracy"]))}
            floor = 3 * max([sure[scene]["space"], *(row["time_rms"] for row in tight.values() if row["time_rms"])])
            order = observed_order({segment: row["total_rms"] for segment, row in tight.items()}, floor)
            for segment, row in sorted(tight.items(), reverse=True):
                default = next(iter(pick(mine, segment=segment, accuracy=DEFAULT["accuracy"], order=2)), None)
                if not default:
                    continue
                body.append([f"{scene}, {geometry}, {segment:g} m", milli(default["work_s"]), str(default["steps"]),
                             percent(default["total_rms"]), *errors_of(row, "total_"),
                             f"{order:.1f}" if segment == min(tight) and order is not None else ""])
    head = ["mesh", "ms", "steps", "RMS at 1e-3, %", "RMS of space, %", "largest, %", "peak, %", "load, %", "order"]
    return table(head, body)


def certainty_table(sure):
    names = ("time smooth", "time cylinder", "space")
    return table(["reference's own error, RMS %", *names],
                 [[scene, *(f"{100 * values[name]:.1e}" if name in values else "-" for name in names)]
                  for scene, values in sure.items()])


def stopped(rows):
    """One line on the runs that took too many steps."""
    found = sorted({(row["scene"], method_of(row), row["accuracy"]) for row in rows if row["outcome"] == "steps"})
    if not found:
        return "Every run finished."
    return "Given up for too many steps: " + "; ".join(f"{scene}, {method}, {accuracy:g}" for scene, method, accuracy in found) + "."


def text(rows, sure, load, rounds):
    """All that stands between the markers of the document."""
    points = medians(rows)
    parts = [heading(load, f"medians of {rounds} rounds, two runs at once"), stopped(rows),
             "**Error in time**, 0.5 m, smooth:", verdicts_table(points, "time_rms"),
             "**Error in space and time**, all meshes and both geometries:", verdicts_table(points, "total_rms"),
             "**What an error in time costs**, 0.5 m, smooth:", levels_table(points, "time_rms", geometry="smooth", segment=0.5),
             "**What an error in space and time costs**:", levels_table(points, "total_rms"),
             "**Exponents over the accuracy**, fitted:", orders_table(points, sure),
             "**Meshes**:", meshes_table(points, sure),
             "**References**:", certainty_table(sure)]
    for scene in scenes_of(points):
        parts += [f"**Frontier in time of `{scene}`**:", frontier_table(pick(points, scene=scene))]
    return "\n\n".join(parts)


# ------------------------------------------------------------------------------------------------------- pictures

def panel_of(points, error, label):
    """Error over work, a line for every curve; the default's point is ringed by a larger series of its own."""
    panel = Panel("time of integration, ms", label, height=300, log="xy")
    for k, (name, curve) in enumerate(curves(points, error).items()):
        colour = COLOURS[k % len(COLOURS)]
        work, wrong = [1e3 * w for w, _ in curve], [e for _, e in curve]
        panel.add(name, work, wrong, colour, dash="4 3" if "cylinder" in name else "")
        panel.add("", work, wrong, colour, marks=True)
    default = the_default(points)
    panel.level("1 %", GOAL)
    if default:
        panel.add("default", [1e3 * default["work_s"]], [default[error]], "#000000", marks=True)
    return panel


def pictures(rows, folder):
    """One picture a scene, precision-SCENE.svg: returns [(path, what it shows in words)]."""
    points, shown = medians(rows), []
    os.makedirs(folder, exist_ok=True)
    for scene in scenes_of(points):
        mine = pick(points, scene=scene)
        in_time = [row for row in mine if row["segment"] == 0.5 and row["geometry"] == "smooth"]
        meshes = [row for row in mine if row["order"] == 2 and row["method"] != "esdirk"]
        path = os.path.join(folder, f"precision-{scene}.svg")
        panels = [panel_of(in_time, "time_rms", "RMS error in time"),
                  panel_of(meshes, "total_rms", "RMS error, space and time")]
        write_svg(path, f"Error of the tension against run time: {scene}", panels)
        shown.append((path, f"{scene}: RMS error of the tension over the time of integration, both logarithmic. Above the "
                      "error in time, a line for the one-step method and every order limit; below that in space and time, a line for every "
                      "segment length and geometry."))
    return shown
