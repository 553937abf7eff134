"""Random cases for bench/stress.py: scenes drawn from wide ranges over many keys, the same for the same number.

`draw(number)` is a case as a dict; `text` writes it as JSON, which is YAML. Every case is drawn from `random.Random(number)`
alone, so that a case that fails can be had again by its number whatever else is drawn:

    python3 bench/stress_random.py 17 >17.yaml && build/release/cli/hawser run 17.yaml

What varies, uniformly in the logarithm where a range spans decades: diameters 5-200 mm, axial rigidity 1e4-1e10 N, shear at
0.03 to 1 of it, bending 1e-3-1e6 N m2, torsion likewise, mass 0.05-300 kg/m, damping 0 to 1 s or as shares of critical 0 to 2,
preloads, bending with hysteresis; one to three pieces of cable with segments of 50 mm to 3 m; routes of one to four straights
and bends in any direction, slopes to 40 deg; rollers of every profile, fixed, spinning, on mounts, with guides and hold-downs;
ducts, trays, floors; reels; conveyors; winches by speed, table, tension, with trips and rope taken in; rods of every shape,
held, led and loaded; contact stiffness over eight decades, its exponent, damping and geometry; both laws of friction, mu 0 to 2,
v_s 1e-6 to 0.1 m/s; gravity 0 to 100 m/s2; accuracy 1e-1 to 1e-6, order 1 to 5, every solver, planar or not, with and without
relaxation. Many of these are nonsense as engineering. That is their purpose: each must end with results that are finite or
with a message that says what is wrong.
"""
import json
import math
import random
import sys

STEPS_MOST = 8000  # of every case: what does not get along with it says so and ends with status 3
KINDS = ("rollers", "rollers", "rollers", "surfaces", "surfaces", "reel", "rod", "rod", "mixed", "self")


class Draw(random.Random):
    """Draws that the generators below share."""

    def decades(self, low, high):
        return float(f"{math.exp(self.uniform(math.log(low), math.log(high))):.6g}")

    def even(self, low, high):
        return float(f"{self.uniform(low, high):.6g}")

    def chance(self, share):
        return self.random() < share


def ramp(r):
    """Where a profile's ramp lies: gentle, or nearly a jump."""
    start = r.choice([0.0, r.even(0, 1)])
    return {"ramp": r.choice(["none", "step", "step5"]), "from": start, "to": start + r.decades(1e-3, 2)}


def table(r, largest):
    """A profile as a table, jumps included."""
    times, values = [0.0], [0.0]
    for _ in range(r.randint(1, 5)):
        times.append(float(f"{times[-1] + r.decades(1e-3, 1):.9g}"))
        values.append(r.choice([0.0, r.even(0, largest)]))
    return [[t, v] for t, v in zip(times, values)]


def cable(r, rod=False):
    """A kind of cable; a rod's bends elastically."""
    stiff = r.decades(1e4, 1e10)
    out = {"d": r.decades(5e-3, 0.2), "EA": stiff, "GA": stiff * r.even(0.03, 1), "GJ": r.decades(1e-3, 1e6),
           "mass": r.decades(0.05, 300)}
    if r.chance(0.12) and not rod:
        moment, slope = [[0, 0]], r.decades(10, 1e5)
        for _ in range(r.randint(2, 4)):
            last, slope = moment[-1], slope * r.even(0.1, 0.9)
            step = r.decades(1e-3, 0.1)
            moment.append([last[0] + step, last[1] + slope * step])
        out["bending"] = {"table": moment[1:]}
    elif r.chance(0.2):
        out.update(EI_y=r.decades(1e-3, 1e6), EI_z=r.decades(1e-3, 1e6))
    else:
        out["EI"] = r.decades(1e-3, 1e6)
    if r.chance(0.3):
        names = r.sample(["axial", "shear", "torsion", "bending"], r.randint(1, 4))
        out["damping_ratio"] = {name: r.choice([0, r.even(0, 2)]) for name in names}
        if r.chance(0.3):
            out["damping_ratio"]["at"] = r.decades(0.1, 1e3)
    out["damping"] = r.choice([0, r.decades(1e-6, 1), r.decades(1e-4, 1e-2)])
    if r.chance(0.1):
        out["damping_factor"] = {"torsion": r.even(0, 10), "bending": r.even(0, 3)}
    if r.chance(0.1):
        out["preload"] = {"bending_y": r.even(-1, 1) * out.get("EI", 1.0), "torsion": r.even(-1, 1) * out["GJ"]}
    return out


def friction(r, some=False):
    """A law of friction; some: perhaps only a part of it."""
    out = {"v_s": r.decades(1e-6, 0.1)}
    out["v_d"] = out["v_s"] * r.decades(1.01, 100)
    if r.chance(0.5):
        out["mu"] = r.choice([0, r.even(0, 1), r.even(0, 2)])
    else:
        out["mu_s"] = r.even(0, 1.5)
        out["mu_d"] = out["mu_s"] * r.even(0, 1)
    if r.chance(0.35):
        out.update(law="stick", d_s=r.decades(1e-6, 1e-2))
    return {"mu": r.even(0, 1)} if some and r.chance(0.5) else out


def contact(r):
    """A law of contact."""
    out = {"geometry": r.choice(["smooth", "smooth", "cylinder"]), "reach": r.decades(0.1, 10)}
    if r.chance(0.8):
        e = r.choice([1, 1.5, 1.5, 2.2])
        out.update(e=e, k=r.decades(1e4, 1e12), c=r.choice([0, r.decades(10, 1e7)]), d=r.decades(1e-6, 1e-2))
    return out


def roller_row(r, name):
    """A row of rollers."""
    out = {"name": name, "radius": r.decades(0.03, 0.5), "width": r.decades(0.2, 2),
           "spacing": r.decades(0.3, 6)}
    if r.chance(0.3):
        out["profile"] = r.choice(["v", "u"])
    if r.chance(0.2):
        out["hold_down"] = "sag"
    if r.chance(0.3):
        out["spin"] = {"inertia": r.decades(1e-4, 10)}
        if r.chance(0.7):
            out["spin"]["bearing"] = {"friction": r.even(0, 2), "journal": 0.02, "speed": r.decades(1e-4, 1),
                                      "torque": r.choice([0, r.decades(0.1, 1e5)])}
    if r.chance(0.25):
        k = r.decades(1e3, 1e8)
        out["mount"] = {"stiffness": [k, k, k * r.decades(0.1, 10)] + [k * r.decades(1e-3, 1)] * 3,
                        "damping": r.choice([0, r.decades(1e-5, 0.1)]), "mass": r.decades(0.1, 300),
                        "inertia": r.decades(1e-3, 10)}
    if r.chance(0.3):
        out["friction"] = friction(r, some=True)
    return out


def pieces(r, flat):
    """Straights and bends of a route, and its length."""
    out, length = [], 0.0
    for number in range(r.randint(1, 4)):
        if number % 2 and not flat:
            angle, radius = r.even(2, 120), r.decades(1, 60)
            plane = r.choice(["up", "down", "left", "right"])
            if plane in ("up", "down"):
                angle = min(angle, 25)
            out.append({"bend": f"{angle} deg", "radius": radius, "plane": plane})
            length += math.radians(angle) * radius
        else:
            straight = r.decades(1, 30)
            out.append({"straight": straight})
            length += straight
    return out, length


def chain(r, names, length):
    """Pieces of cable that are about as long as asked for, at most 120 segments; and the place of the front."""
    count = len(names)
    shares = [r.even(0.2, 1) for _ in range(count)]
    out = []
    for name, share in zip(names, shares):
        piece = float(f"{length * share / sum(shares):.6g}")
        out.append({"cable": name, "length": piece, "segment": max(piece / 60, min(piece, r.decades(0.05, 3)))})
    for piece in out[1:]:
        if r.chance(0.5):
            piece["swivel"] = True
    if count > 1:
        out[-1]["rope"] = True
    return out


def winch(r, weight):
    """What pulls."""
    out = {"grip": r.choice(["clamp", "axial"])}
    if r.chance(0.2):
        pull = {"force": r.even(0, 2) * weight, **ramp(r)}
        if r.chance(0.7):
            pull["speed_limit"] = r.decades(0.01, 10)
        if r.chance(0.5):
            pull["drum_mass"] = r.decades(0.1, 1000)
        out["tension"] = pull
        return out
    if r.chance(0.25):
        out["table"] = table(r, r.decades(0.01, 5))
    else:
        out.update(speed=r.decades(1e-3, 5), **ramp(r))
    if r.chance(0.25):
        out["trip"] = {"force": r.decades(0.01, 2) * weight, "brake": r.decades(1e-3, 1), "hold": r.choice([0, 0.05]),
                       "restarts": r.randint(0, 3), "pause": r.even(0, 1), "ramp": r.decades(1e-3, 1)}
    return out


def conveyor(r, route_length, winch_leads):
    """One conveyor somewhere along the route; a belt of its own where no winch's speed leads it."""
    start = r.even(0, max(0.1, route_length - 2))
    out = {"from": start, "to": start + r.even(0.5, 2), "clamp": r.decades(10, 1e5), "mu": r.even(0, 1),
           "v_s": r.decades(1e-6, 1e-2), "hold": r.chance(0.5)}
    if r.chance(0.5) or not winch_leads:
        out["belt"] = {"table": table(r, 2)} if r.chance(0.5) else {"speed": r.decades(1e-3, 2), **ramp(r)}
    return out


def surfaces(r, length, thick):
    """Ducts, trays or a floor."""
    which, law = r.choice(["duct", "flat", "v", "u", "plane"]), {"friction": friction(r, some=True)}
    if which == "plane":
        return {"planes": [{"point": [0, 0, -r.choice([0.501, 0.6, 2]) * thick], "normal": [0, 0, 1], **law}]}
    where = {"from": 0.0, "to": length, **law}
    if which == "duct":
        return {"ducts": [{**where, "radius": thick * r.decades(0.51, 3), "place": r.choice(["centred", "resting"])}]}
    tray = {**where, "section": which}
    if which == "flat":
        tray.update(width=thick * r.decades(1.5, 20), height=r.choice([0, thick * r.even(0.2, 3)]))
    elif which == "u":
        tray["radius"] = thick * r.decades(0.51, 3)
    return {"trays": [tray]}


def reel(r, thick):
    """A reel that pays out, or a weight that stands for one."""
    if r.chance(0.2):
        return {"model": "weight", "length": r.even(0, 30), **ramp(r)}
    barrel = max(0.3, thick * r.decades(5, 30))
    out = {"distance": r.decades(4, 10), "barrel": barrel, "flange": barrel * r.even(2, 4), "width": max(2 * thick, r.even(0.5, 2)),
           "inertia": r.decades(1, 1e4), "bearing": r.choice([0, r.decades(1, 1e3)]), "end": r.choice(["free", "fixed"])}
    if r.chance(0.6):
        law = r.choice(["constant", "proportional", "speed"])
        out["brake"] = {"law": law, "torque": r.decades(1, 1e4)}
        if law != "constant":
            out["brake"]["speed"] = r.decades(0.01, 2)
    if r.chance(0.4):
        out["back_tension"] = {"tension": r.decades(1, 1e4), **ramp(r)}
    return out


def solver(r, planar=True):
    """How it is computed."""
    out = {"accuracy": r.choice([1e-3, r.decades(1e-6, 1e-1)]), "max_steps": STEPS_MOST}
    if r.chance(0.3):
        out["max_order"] = r.randint(1, 5)
    if r.chance(0.3):
        out["linear_solver"] = r.choice(["block", "klu"])
    if r.chance(0.2) and planar:
        out["planar"] = "off"
    if r.chance(0.3):
        out["relax"] = r.chance(0.5)
    if r.chance(0.1):
        out["threads"] = 2
    if r.chance(0.1):
        out["max_step"] = r.decades(1e-4, 1)
    return out


def held(r, end):
    """How an end of a rod is held, and perhaps led."""
    fixing = r.choice(["free", "pinned", "clamped", "clamped", "guided"])
    out = {"fixing": fixing}
    if fixing != "free" and r.chance(0.5 if end == "head" else 0.1):
        turn = r.chance(0.5)
        led = {"turn": f"{r.choice([90, 720, 18000]) * r.even(-1, 1):.6g} deg"} if turn else {"move": r.even(-2, 1)}
        out["motion"] = [{"direction": [1, r.even(-0.5, 0.5), r.even(-0.5, 0.5)], **led, **ramp(r)}]
    return out


def rod_case(r):
    """A rod of some shape, held, led and loaded."""
    length, count = r.decades(0.5, 50), r.randint(3, 80)
    shape = r.choice(["straight", "straight", "arc", "helix"])
    rod = {"shape": shape, "heading": f"{r.even(-180, 180)} deg", "slope": f"{r.even(-90, 90)} deg",
           "stress_free": r.chance(0.7), "tail": held(r, "tail"), "head": held(r, "head")}
    if shape != "straight":
        rod["radius"] = length / r.even(0.5, 12)
    if shape == "helix":
        rod["pitch"] = r.even(-1, 1) * rod["radius"]
    if r.chance(0.6):
        rod["loads"] = [{"at": length * r.choice([1, r.even(0, 1)]), "direction": [r.even(-1, 1), r.even(-1, 1), 1],
                         r.choice(["force", "moment"]): r.decades(0.1, 1e5), "frame": r.choice(["dead", "follower"]),
                         **ramp(r)} for _ in range(r.randint(1, 2))]
    if r.chance(0.2):
        rod["masses"] = [{"at": length * r.even(0, 1), "mass": r.decades(1e-3, 1e4)}]
    analysis = r.choice(["dynamics", "dynamics", "dynamics", "static", "modes"])
    return {"cables": {"a": cable(r, rod=True)}, "chain": [{"cable": "a", "length": length, "segment": length / count}], "rod": rod,
            "run": {"analysis": analysis, "duration": r.decades(0.1, 3)}}


def self_case(r):
    """A rope that falls across itself, or that comes off a drum on which its turns touch."""
    a = cable(r)
    a["d"] = min(a["d"], 0.06)
    turn = {"bend": "90 deg", "radius": r.even(0.6, 1.2), "plane": "left"}
    parts = [{"straight": 3.0}, turn, {"bend": "10 deg", "radius": 2.0, "plane": "up"}, turn, turn, {"straight": 2.0}]
    return {"cables": {"a": a}, "chain": [{"cable": "a", "length": r.even(6, 9), "segment": r.even(0.1, 0.2)}],
            "route": {"pieces": parts},
            "rollers": {"along": {"from": 0, "to": 6.0, "spacing": 0.3, "radius": 0.03, "width": 0.8}},
            "run": {"duration": r.decades(0.1, 1)}}


def pull_case(r, kind):
    """A cable that is pulled along a route."""
    count = r.choice([1, 1, 2, 3])
    names = ["a", "b", "c"][:count]
    cables = {name: cable(r) for name in names}
    thick, weight = max(c["d"] for c in cables.values()), sum(c["mass"] for c in cables.values())
    parts, length = pieces(r, flat=r.chance(0.3))
    route = {"pieces": parts, "slope": f"{r.choice([0, r.even(-40, 40)])} deg", "heading": f"{r.choice([0, r.even(0, 360)])} deg"}
    case = {"cables": cables, "chain": chain(r, names, length * r.even(0.2, 1.2)), "route": route,
            "run": {"duration": r.decades(0.1, 4)}}
    if r.chance(0.7):
        route["head_at"] = length * r.even(0.5, 1)
    if r.chance(0.5):
        case["lead_in"] = {"weight": r.choice(["full", "carried"])}
    if kind in ("rollers", "mixed", "reel"):
        rows = [roller_row(r, "R")]
        if r.chance(0.15):
            rows.append({"guide": r.choice(["inside", "both"]), "spacing": 1.0, "radius": 0.06, "gap": r.even(0, 0.02), "name": "G"})
        case["rollers"] = {"along": rows}
    if kind in ("surfaces", "mixed"):
        case["surfaces"] = surfaces(r, length, thick)
    if r.chance(0.85):
        case["drive"] = {"winch": winch(r, 9.81 * weight * length)}
        if r.chance(0.3) and "tension" not in case["drive"]["winch"]:
            case["drive"]["rope_drag"] = {"force": r.decades(1, 1e4), "v_s": r.decades(1e-5, 1e-2)}
    if kind == "reel":
        case["reel"] = reel(r, thick)
        if case["reel"].get("model") != "weight":
            case.pop("lead_in", None)
            case["chain"][0]["length"] += case["reel"]["distance"] + length
            if len(names) > 1 and r.chance(0.5) and "winch" in case.get("drive", {}) and "tension" not in case["drive"]["winch"]:
                case["drive"]["winch"]["take_in"] = True
    elif r.chance(0.4):
        profile = {"table": table(r, 1e4)} if r.chance(0.3) else {"tension": r.decades(1, 1e5), **ramp(r)}
        case.setdefault("drive", {})["tail"] = profile
    if r.chance(0.15):
        leads = "winch" in case.get("drive", {}) and "tension" not in case["drive"]["winch"]
        case["conveyors"] = [conveyor(r, length, leads)]
    return case


def draw(number):
    """The case of that number, as a dict."""
    r = Draw(number)
    kind = r.choice(KINDS)
    case = rod_case(r) if kind == "rod" else self_case(r) if kind == "self" else pull_case(r, kind)
    case["title"] = f"random {number}: {kind}"
    case["gravity"] = r.choice([9.81, 9.81, 9.81, 0, 1.62, r.decades(0.1, 100)])
    if r.chance(0.1):
        case["frame"] = "adams"
    if kind != "rod":
        case["contact"], case["friction"] = contact(r), friction(r)
    if kind == "self":
        case["contact"]["cable_on_cable"] = True
    case["solver"] = solver(r)
    case["output"] = {"interval": case["run"]["duration"] / 40, "states": case["run"]["duration"] / 4}
    return case


def text(case):
    """The case as the text of a file."""
    return json.dumps(case, indent=1) + "\n"


if __name__ == "__main__":
    for word in sys.argv[1:]:
        print(text(draw(int(word))), end="")
