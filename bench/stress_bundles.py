"""Rows of bench/stress.py for several chains: how many, how unlike, how near, how fast; in ducts, trays, on rollers and floors,
with ties, behind a rope. Cables of 2 m and 3 kg/m; what all of them pull together is mu m g L and their tails' tension, in a
duct times the weight factor of how they lie, wherever there is a closed form.
"""
import math

GRAVITY, MASS, MU, DIAMETER, LENGTH = 9.81, 3.0, 0.3, 41e-3, 2.0
WEIGHT = MASS * GRAVITY * LENGTH  # N, of one cable


def cable(d=DIAMETER, mass=MASS, ei=60.0):
    """A cable whose stiffness to stretch goes with its section."""
    return {"d": d, "mass": mass, "EA": 16e9 * d * d, "GA": 5e9 * d * d, "GJ": 100, "EI": ei, "damping": 2e-3}


def floor_bundle(count=3, gap=1e-4, speed=0.1):
    """Cables side by side on a floor, a winch each."""
    return {
        "cables": {"power": cable()},
        "chain": [{"cable": "power", "length": LENGTH, "segment": 0.25}],
        "chains": {f"c{k}": {} for k in range(count)},
        "lay": {"pattern": "flat", "spacing": DIAMETER + gap},
        "route": {"head_at": LENGTH + 0.5, "pieces": [{"straight": LENGTH + 3 + 2 * speed}]},
        "surfaces": {"planes": [{"point": [0, 0, -DIAMETER / 2], "normal": [0, 0, 1]}]},
        "friction": {"mu": MU},
        "drive": {"winch": {"speed": speed, "to": 0.5, "grip": "axial"}},
        "run": {"duration": 2, "steady_from": 1.2},
        "output": {"states": 0},
    }


def duct_bundle(ratio, pattern="triangular", **contact):
    """Three in a duct of D/d = ratio, a winch each."""
    case = floor_bundle()
    case["lay"] = {"pattern": pattern}
    case["surfaces"] = {"ducts": [{"radius": ratio * DIAMETER / 2}]}
    case["contact"] = contact
    return case


def rope_bundle(count, **lay):
    """Cables on a floor behind one rope without weight, which its winch clamps."""
    case = floor_bundle(count)
    del case["drive"]["winch"]["grip"]
    case["cables"]["rope"] = cable(16e-3, 1e-3, 5.0)
    case["chains"] = {"rope": {"chain": [{"cable": "rope", "length": 1.5, "segment": 0.25}], "swivel": True},
                      **{f"c{k}": {"join": "rope"} for k in range(count)}}
    case["lay"].update(lay)
    return case


def unlike(second, **places):
    """Two cables of which the second differs; its axis lies where its own radius has it on the floor."""
    case = floor_bundle(2)
    case["cables"]["other"] = second
    up = (second["d"] - DIAMETER) / 2
    aside = math.sqrt((second["d"] + DIAMETER) ** 2 / 4 - up * up) + 1e-4
    case["chains"]["c0"] = {"place": [0, 0]}
    case["chains"]["c1"] = {"chain": [{"cable": "other", "length": LENGTH, "segment": 0.25}], "place": [-aside, up], **places}
    return case


def tied(spacing, stiffness=1e5):
    case = floor_bundle()
    case["lay"]["ties"] = {"spacing": spacing, "stiffness": stiffness}
    return case


def faster(times):
    case = floor_bundle()
    case["chains"]["c1"] = {"drive": {"winch": {"speed": 0.1 * times, "to": 0.5, "grip": "axial"}}}
    case["route"]["pieces"] = [{"straight": LENGTH + 3 + 0.2 * times}]
    return case


def tailed(tension):
    case = floor_bundle()
    case["drive"]["tail"] = {"tension": tension, "to": 0.5}
    return case


def stiff(ei):
    case = floor_bundle()
    case["cables"]["power"] = cable(ei=ei)
    return case


def on_rollers(spacing):
    case = floor_bundle(3, 0.02)
    end = case["route"]["pieces"][0]["straight"]
    case["surfaces"] = {}
    case["rollers"] = {"along": {"from": 0.25, "to": end, "spacing": spacing, "radius": 0.05, "width": 0.4}}
    return case


def in_tray(angle):
    """Two in a V, one on either side of its middle, where both fall to."""
    case = floor_bundle(2, 1e-3)
    case["surfaces"] = {"trays": [{"section": "v", "angle": f"{angle} deg", "height": 0.2}]}
    half = math.radians(angle) / 2
    aside = 0.51 * DIAMETER
    up = aside / math.tan(half) + DIAMETER / 2 / math.sin(half) - DIAMETER / 2
    case["chains"] = {"c0": {"place": [aside, up]}, "c1": {"place": [-aside, up]}}
    return case


def pulls(run):
    """What all pull together, N."""
    return next(chain for chain in run.summary["chains"] if chain["name"] == "all")["pull_mean_N"]


def together(share, expected):
    """The pull of all is `expected(value)` to a share of it."""
    def judge(value, run):
        want, have = expected(value), pulls(run)
        return abs(have - want) <= share * want, f"all pull {100 * (have / want - 1):+.3f} % of {want:.5g} N"
    return judge


def bounded(low, high):
    """The pull of all lies between two bounds."""
    def judge(value, run):
        have = pulls(run)
        return low(value) <= have <= high(value), f"all pull {have:.4g} N in {low(value):.4g} to {high(value):.4g} N"
    return judge


def triangle(ratio):
    return 3 * MU * WEIGHT / math.sqrt(1 - 1 / (ratio - 1) ** 2)


def cradle(ratio):
    return 3 * MU * WEIGHT * (1 + 4 / 3 / (ratio - 1) ** 2)


def bundle_rows(row):
    """The rows, made with stress_rows.Row."""
    three = together(0.02, lambda v: 3 * MU * WEIGHT)
    pull = "pull of all within {} % of mu m g L"
    return (
        row("bundle: chains", "", (2, 3, 4, 5), floor_bundle, together(0.02, lambda v: v * MU * WEIGHT), pull.format(2)),
        row("bundle: gap", "m", (1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1), lambda v: floor_bundle(3, v), three, pull.format(2)),
        row("bundle: speed", "m/s", (1e-3, 1e-2, 0.1, 1, 10), lambda v: floor_bundle(3, 1e-4, v),
            together(0.05, lambda v: 3 * MU * WEIGHT), pull.format(5)),
        row("bundle: one faster", "times", (1, 2, 10, 100), faster, together(0.05, lambda v: 3 * MU * WEIGHT), pull.format(5)),
        row("bundle: diameters", "", (1, 0.7, 0.5, 0.3, 0.2), lambda v: unlike(cable(v * DIAMETER)),
            together(0.02, lambda v: 2 * MU * WEIGHT), pull.format(2)),
        row("bundle: mass ratio", "", (1, 10, 100, 1e3, 1e-1, 1e-2), lambda v: unlike(cable(mass=v * MASS)),
            together(0.02, lambda v: (1 + v) * MU * WEIGHT), pull.format(2)),
        row("bundle: EI", "N m2", (1, 10, 100, 1e3, 1e4), stiff, three, pull.format(2)),
        row("bundle: tails", "N", (0, 10, 100, 1e3, 1e4), tailed, together(0.02, lambda v: 3 * (v + MU * WEIGHT)),
            "pull of all within 2 % of mu m g L and the tails"),
        row("bundle: ties every", "m", (0.1, 0.25, 0.5, 1, 1.9), tied, three, pull.format(2)),
        row("bundle: tie k", "N/m", (10, 1e3, 1e5, 1e7, 1e9), lambda v: tied(0.5, v), three, pull.format(2)),
        row("bundle: rollers every", "m", (0.25, 0.5, 0.75, 1), on_rollers, together(0.05, lambda v: 3 * MU * WEIGHT), pull.format(5)),
        row("bundle: V tray", "deg", (160, 150, 140, 120, 90), in_tray,
            bounded(lambda v: 1.9 * MU * WEIGHT, lambda v: 2.1 * MU * WEIGHT / math.sin(math.radians(v) / 2) ** 2),
            "pull of all between a floor's and that of a V with friction on both sides"),
        row("bundle: triangle, D/d", "", (2.2, 2.5, 2.8, 3, 3.2, 4), duct_bundle, together(0.03, triangle),
            "pull of all within 3 % of the triangle's factor"),
        row("bundle: cradle, D/d", "", (2.6, 2.8, 3, 3.2, 4), lambda v: duct_bundle(v, "cradled"), together(0.03, cradle),
            "pull of all within 3 % of the cradle's factor"),
        row("bundle: contact k", "N/m^1.5", (3.4e6, 3.4e7, 3.4e8, 3.4e9), lambda v: duct_bundle(2.5, k=v),
            together(0.1, lambda v: triangle(2.5)), "pull of all within 10 % of the triangle's factor"),
        row("bundle: behind a rope", "", (2, 3, 4, 5), rope_bundle, together(0.03, lambda v: v * MU * WEIGHT), pull.format(3)),
    )
