"""Scenes for bench/truth.py: pulls that an engineer could mean, drawn at random, the same for the same number.

`draw(number)` is a case as a dict. It is drawn from the number alone, so that a scene can be had again:

    python3 bench/truth_scenes.py 17 >17.yaml && build/release/cli/hawser run 17.yaml

A scene is put together as a planner would: cable and rope from a catalogue's ranges; a route of 12 to 40 m with bends no tighter than 20
diameters; something under every metre of it (rollers that suit the bends, ducts, trays, a floor); a back tension that keeps the cable
taut where it runs downhill; a winch, perhaps helped by conveyors or driven rollers; a run that ends after the pull has come to its
steady value. What the program offers is drawn too where a planner has the choice: profiles, spinning and mounted rollers, both laws of
friction, segments given or left to the default, relaxation where the guide to equipment asks for it or not. Nothing here looks at what
the program makes of the scene.
"""
import json
import math
import sys

from stress_random import Draw

GRAVITY = 9.81
SIDEWAYS = ("left", "right")


def round_to(value, step):
    return round(round(value / step) * step, 9)


# ---------------------------------------------------------------------------------------------------- cable and rope

def power_cable(r):
    """From medium voltage to 220 kV: 40 to 120 mm; stiffnesses of ropes of wires, not of bars."""
    d = round_to(r.even(0.04, 0.12), 0.001)
    area = math.pi * d**2 / 4
    size = d / 0.09
    out = {"d": d, "mass": round_to(area * r.even(2000, 4500), 0.1), "EA": round(area * r.decades(4e9, 2e10), -5),
           "GJ": round(1e4 * size**4 * r.decades(0.3, 2), 1)}
    out["GA"] = round(out["EA"] * r.even(0.3, 0.45), -5)
    bend = 2e3 * size**3.5 * r.decades(0.15, 1.5)  # in a bend, where layers have slipped
    if r.chance(0.08):  # layers that slip
        out["bending"] = {"table": [[0.02, float(f"{0.02 * 4 * bend:.4g}")], [0.1, float(f"{0.02 * 4 * bend + 0.08 * bend:.4g}")],
                                    [0.3, float(f"{0.02 * 4 * bend + 0.08 * bend + 0.2 * bend / 4:.4g}")]]}
    else:
        out["EI"] = float(f"{bend:.4g}")
    if r.chance(0.7):
        out["damping"] = r.choice([1e-3, 2e-3, 5e-3, 10e-3])
    return out


def rope(r, cable):
    """Steel wire rope of 10 to 22 mm, thinner than a third of the cable."""
    d = r.choice([d for d in (0.010, 0.012, 0.014, 0.016, 0.018, 0.022) if d < 0.34 * cable["d"]])
    size = d / 0.014
    return {"d": d, "mass": round(0.68 * size**2, 3), "EA": round(8e6 * size**2, -4), "GA": round(3e6 * size**2, -4),
            "GJ": round(100 * size**4, 2), "EI": round(50 * size**4 * r.even(0.3, 1), 2), "damping": r.choice([2e-3, 5e-3, 20e-3])}


# ------------------------------------------------------------------------------------------------------------- route

def route(r, d, level):
    """(pieces, slope at the start in deg). level: one straight. Bends keep 20 diameters and the grade within 15 deg."""
    slope = 0.0 if level or r.chance(0.4) else round(r.even(-10, 10), 1)
    pieces = [{"straight": round_to(r.even(5, 12), 0.1)}]
    grade = slope
    for _ in range(0 if level else r.choice([0, 0, 1, 1, 2])):
        radius = round_to(max(20 * d, r.decades(1.5, 15)), 0.1)
        if r.chance(0.55):
            pieces.append({"bend": round(min(r.even(10, 90), 9 / radius * 57.3)), "radius": radius, "plane": r.choice(SIDEWAYS)})
        else:
            angle = round(min(r.even(3, 25), 7 / radius * 57.3))
            plane = "up" if grade + angle <= 15 and (grade - angle < -15 or r.chance(0.5)) else "down"
            if not -15 <= grade + (angle if plane == "up" else -angle) <= 15:
                continue
            grade += angle if plane == "up" else -angle
            pieces.append({"bend": angle, "radius": radius, "plane": plane})
        pieces.append({"straight": round_to(r.even(3, 8), 0.1)})
    if sum("bend" in p for p in pieces) == 0:
        pieces[0]["straight"] = round_to(pieces[0]["straight"] + r.even(3, 12), 0.1)
    return pieces, slope


def stretches(pieces, slope):
    """The route's pieces as (from, to, piece, slope at its start in rad, radius or inf)."""
    s, grade, out = 0.0, math.radians(slope), []
    for piece in pieces:
        radius = piece.get("radius", math.inf)
        length = piece.get("straight", math.radians(piece.get("bend", 0)) * radius if "bend" in piece else 0)
        out.append((s, s + length, piece, grade, radius))
        s += length
        turn = {"up": 1, "down": -1}.get(piece.get("plane"), 0) * math.radians(piece.get("bend", 0))
        grade += turn
    return out


def tensions(parts, start, weight, mu, to):
    """Tension along the route at steps of about 0.1 m up to `to`: weight, friction and bends, N. [(s, T, radius, plane)]."""
    out, tension = [], start
    for s0, s1, piece, grade, radius in parts:
        count = max(1, round((s1 - s0) / 0.1))
        sense = {"up": 1, "down": -1}.get(piece.get("plane"), 0)
        for k in range(count):
            s = s0 + (k + 0.5) * (s1 - s0) / count
            if s > to:
                return out
            slope = grade + sense * (s - s0) / radius
            across = weight * math.cos(slope)
            normal = math.hypot(across, tension / radius) if sense == 0 else abs(across - sense * tension / radius)
            tension += (weight * math.sin(slope) + mu * normal) * (s1 - s0) / count
            out.append((s, tension, radius, piece.get("plane")))
    return out


# ------------------------------------------------------------------------------------------------- what the cable lies on

def friction_law(r, mu, speed):
    """The case's law; v_s is the default or a fraction of the laying speed."""
    law = {"mu": round(mu, 3)}
    if r.chance(0.25):
        law = {"mu_s": round(mu * r.even(1, 1.4), 3), "mu_d": round(mu, 3)}
    if r.chance(0.4):
        law["v_s"] = round(min(5e-3, speed / r.choice([20, 50, 100])), 5)
    if r.chance(0.2):
        law.update(law="stick", d_s=r.choice([5e-5, 1e-4, 2e-4, 5e-4]))
    return law


def spin(r, radius, load, motor):
    """A roller on a journal; load: N on it; motor: with a drive that gives back some of what the bearing takes."""
    out = {"inertia": round(r.decades(0.02, 0.2), 3),
           "bearing": {"friction": round(r.even(0.05, 0.2), 3), "journal": r.choice([0.008, 0.012, 0.015]), "speed": round(1e-3 / radius, 4)}}
    if r.chance(0.4):
        out["bearing"]["torque"] = round(r.even(0.02, 0.2), 3)
    if motor:
        bearing = load * out["bearing"]["friction"] * out["bearing"]["journal"] + out["bearing"].get("torque", 0)  # N m
        torque = round(bearing * r.even(0.3, 0.8), 3)
        out["motor"] = r.choice([{"torque": torque, "to": 1.0}, {"factor": round(r.even(1, 1.05), 3), "limit": torque}])
        if "torque" in out["motor"] and r.chance(0.5):
            out["motor"]["speed_limit"] = 0.5
    return out


def mount(r):
    """A frame on bolts or on timber, stiff enough against tilting for a flat roller."""
    k = round(r.decades(5e5, 2e7), -4)
    turning = round(k * r.even(0.04, 0.1), -3)
    return {"stiffness": [k, k, k, turning, turning, turning], "damping": r.choice([1e-3, 2e-3, 5e-3]), "mass": round(r.even(15, 60)),
            "inertia": round(r.even(0.3, 2), 2)}


def roller_rows(r, case, parts, cable, pulled, length, spins):
    """Rows that carry the cable on straights and in bends: grooves or guides where a bend goes to the side, hold-downs where the
    tension lifts the cable. pulled: tensions along the route; spins: whether the rollers turn."""
    weight = cable["mass"] * GRAVITY
    radius, width = r.choice([0.05, 0.06, 0.08, 0.1]), r.choice([0.25, 0.4, 0.5])
    shape = {"radius": radius, "width": width, "profile": r.choice(["flat", "flat", "flat", "v", "u"])}
    side = [p for p in parts if p[2].get("plane") in SIDEWAYS]
    lifted = any(plane == "up" and tension / rad > 0.3 * weight for _, tension, rad, plane in pulled)
    pushed = max((tension / rad for _, tension, rad, plane in pulled if plane in SIDEWAYS), default=0)
    pitch = round(r.even(1, 2.5) if max(T for _, T, _, _ in pulled) > 500 else r.even(0.8, 1.6), 2)
    carrier = dict(shape)
    if spins:
        carrier["spin"] = spin(r, radius, weight * pitch, motor=r.chance(0.35) and all(p[3] >= 0 for p in parts))
    if r.chance(0.15):
        carrier["mount"] = mount(r)
    if r.chance(0.2):
        carrier["friction"] = {"mu": round(r.even(0.1, 0.25), 3)}
    if len(parts) == 1 or (not side and not lifted and r.chance(0.5)):
        rows = [{"from": 0.0, "to": round(length, 3), "spacing": pitch, **carrier}]
    else:
        rows = [{"where": "straights", "spacing": pitch, **carrier},
                {"where": "bends", "spacing": round(r.even(0.4, 0.8), 2), **carrier, "name": "C"}]
        if lifted:
            rows[1]["hold_down"] = "sag"
        if side and (shape["profile"] == "flat" or pushed > 0.4 * weight):
            rows[0]["profile"] = rows[1]["profile"] = "flat"
            rows.append(guides(r, case, cable, pulled, carrier))
    return rows


def duct(r, d, where):
    return {**where, "radius": round(d / 2 * r.even(1.25, 2.5), 4), "place": r.choice(["resting", "resting", "centred"])}


def tray(r, d, where, bends):
    """Bends to the side ask for walls."""
    section = r.choice(["flat", "v", "u"])
    out = {**where, "section": section}
    if section == "flat":
        out["width"] = round(d * r.even(1.5, 5), 3)
        if bends or r.chance(0.5):
            out["height"] = round(d * r.even(1, 2), 3)
    elif section == "u":
        out["radius"] = round(d / 2 * r.even(1.25, 2.5), 4)
    return out


def bending_stiffness(cable):
    """N m2, of the straight cable."""
    return cable["EI"] if "EI" in cable else cable["bending"]["table"][0][1] / cable["bending"]["table"][0][0]


def guides(r, case, cable, pulled, carrier):
    """Upright rollers: on the inside alone where the tension holds the cable to them against its own stiffness, EI/R^2."""
    firm = "mount" not in carrier and all(tension > 3 * bending_stiffness(cable) / rad**2 for _, tension, rad, plane in pulled if plane in SIDEWAYS)
    sides = r.choice(["inside", "both"]) if firm else "both"
    late = sides == "inside" and case["drive"].get("tail", {}).get("ramp") != "none"
    if late:  # the guide to equipment: what only friction holds does not stand the search for an equilibrium without it
        case["solver"] = {"relax": False}
        if "speed" in case["drive"]["winch"]:
            case["drive"]["winch"].update({"from": 1.0, "to": case["drive"]["winch"]["to"] + 1})
            case["run"]["duration"], case["run"]["steady_from"] = case["run"]["duration"] + 1, case["run"]["steady_from"] + 1
    return {"guide": sides, "spacing": round(r.even(0.3, 0.6), 2), "gap": r.choice([0.0, 0.005, 0.01]), "radius": carrier["radius"],
            "width": 0.3, "name": "G"}


# ------------------------------------------------------------------------------------------------------------ the scene

def support(r, case, kind, parts, cable, pulled, mu, spins):
    """Puts what the cable lies on into the case."""
    length, d = parts[-1][1], cable["d"]
    bends = any(p[2].get("plane") in SIDEWAYS for p in parts)
    law = {"friction": {"mu": round(mu, 3)}} if r.chance(0.5) else {}
    if kind == "rollers":
        case["rollers"] = {"along": roller_rows(r, case, parts, cable, pulled, length, spins)}
    elif kind == "duct":
        case["surfaces"] = {"ducts": [{**duct(r, d, {}), **law}]}
    elif kind == "tray":
        case["surfaces"] = {"trays": [{**tray(r, d, {}, bends), **law}]}
    elif kind == "floor":
        case["surfaces"] = {"planes": [{"point": [0, 0, -d / 2], "normal": [0, 0, 1], **law}]}
    else:  # rollers, then a duct or a tray over the last pieces
        edge = round_to(parts[0][1] * (0.5 if len(parts) == 1 else 1), 0.1)
        rows = roller_rows(r, case, parts[:1], cable, [p for p in pulled if p[0] <= edge], edge - 0.4, spins)
        case["rollers"] = {"along": rows}
        where = {"from": edge}
        if r.chance(0.6):
            case["surfaces"] = {"ducts": [{**duct(r, d, where), "place": "resting", **law}]}
        else:
            case["surfaces"] = {"trays": [{**tray(r, d, where, bends), **law}]}


def ahead(r, case, parts, need):
    """Conveyors on a straight that is full of cable, which take over at most 70 % of the pull. need: N, what there is to pull."""
    s0, s1 = parts[0][0], min(parts[0][1], case["route"]["head_at"])
    if s1 - s0 < 4:
        return
    machine = round(r.even(1, 2), 1)
    at = round(r.even(s0 + 1, s1 - machine - 1), 2)
    out = {"from": at, "to": round(at + machine, 2), "clamp": round(r.decades(1e3, 1e4), -2), "mu": round(r.even(0.2, 0.4), 2)}
    kind = r.choice(["synchronised", "synchronised", "fast", "belt"])
    speed = case["drive"]["winch"].get("speed")
    if kind == "belt" or speed is None:
        own = speed or case["drive"]["winch"]["tension"]["speed_limit"]
        out["belt"] = {"speed": round(own * r.even(1.02, 1.1), 4), "to": case["drive"]["winch"].get("to", 2)}
    elif kind == "fast":
        out["factor"] = round(r.even(1.01, 1.05), 3)
    else:
        r.chance(0.4)  # once whether it had one: a drive without that runs with the winch shares the pull by tenths of a millimetre
    out["limit"] = float(f"{need * r.even(0.2, 0.7):.3g}")
    if r.chance(0.3):
        out["v_s"] = r.choice([1e-5, 5e-4, 1e-3])
    if r.chance(0.3):
        out["hold"] = False
    case["conveyors"] = [out]


def source(r, case, start, cable, kind):
    """What holds the cable back with `start` newtons at the route's start: a tension, a weight, a drum."""
    if kind == "reel":
        barrel = round(max(1.2, 22 * cable["d"]), 2)
        half = 1.1 * barrel / 2
        reel = {"distance": round(r.even(4, 6), 1), "barrel": barrel, "flange": round(barrel * 1.8, 2), "width": 1.2,
                "inertia": round(r.decades(200, 2000)), "bearing": round(r.even(20, 80))}
        law = r.choice(["constant", "constant", "proportional", "speed"])
        if law == "constant":
            reel["brake"] = {"law": law, "torque": max(1.0, round(start * half - reel["bearing"]))}
        else:
            speed = case["drive"]["winch"].get("speed") or 0.1
            reel["brake"] = {"law": law, "torque": max(1.0, round(start * half)), "speed": round(speed * (0.9 if law == "speed" else 1), 4)}
        case["reel"] = reel
    elif kind == "weight":
        case["reel"] = {"model": "weight", "length": round(start / (cable["mass"] * GRAVITY), 1), "to": 1.0}
    elif start > 0:
        case["drive"]["tail"] = {"tension": round(start), **({"ramp": "none"} if kind == "taut" else {"to": 1.0})}


def drive(r, speed, to, need, grip):
    """A winch of set speed, or of set tension with a speed limit."""
    if r.chance(0.15):
        pull = {"force": float(f"{1.3 * need + 100:.3g}"), "to": to, "speed_limit": speed, "drum_mass": round(r.even(100, 500)),
                "band": r.choice([0.05, 0.1])}
        return {"grip": grip, "tension": pull}
    return {"speed": speed, "ramp": r.choice(["step", "step", "step5"]), "to": to, "grip": grip}


def segments(r, case, parts):
    """Given for half of the scenes: what people write, at most an eighth of the tightest bend's radius."""
    if r.chance(0.5):
        given = min(r.choice([0.2, 0.25, 0.3, 0.4, 0.5]), round_to(min(p[4] for p in parts) / 8, 0.01) if len(parts) > 1 else 1)
        for piece in case["chain"]:
            piece["segment"] = given


def draw(number):
    """The scene of that number, as a dict."""
    r = Draw(f"a sensible scene, number {number}")
    cable = power_cable(r)
    kind = r.choice(["rollers"] * 5 + ["duct", "duct", "tray", "floor", "mixed"])
    pieces, slope = route(r, cable["d"], level=kind == "floor")
    parts = stretches(pieces, slope)
    length = parts[-1][1]
    speed, to = round(r.even(0.05, 0.25), 3), round(r.even(1, 2), 1)
    settle, window = r.even(2, 3), r.even(3, 4)
    travel = speed * (to / 2 + settle + window)
    roped = r.chance(0.5)
    head_at = round(length * r.even(0.6, 0.9) if roped else length - travel - r.even(0.3, 1), 2)
    mu, weight = r.even(0.1, 0.35), cable["mass"] * GRAVITY

    spins = kind in ("rollers", "mixed") and r.chance(0.25)
    low = 0.01 if spins else min(mu, 0.1)  # of the easiest rollers that a row may have

    # a back tension that keeps at least 2 m of the cable's weight on it everywhere; more of it by choice
    least = min(T for _, T, _, _ in tensions(parts, 0, weight, low, length))
    start = max(0.0, 2 * weight - least) if least < 0.5 * weight else 0.0
    behind = r.choice(["none", "tail", "taut", "taut", "weight", "reel"])
    side = any(p[2].get("plane") in SIDEWAYS for p in parts)
    if start == 0 and (behind != "none" or side):
        start = weight * r.even(2, 20)
    if start > 0 and behind == "none":
        behind = "taut"
    pulled = tensions(parts, start, weight, mu, length)
    need = pulled[-1][1]

    grip = r.choice(["clamp", "axial"]) if not roped and slope == 0 and len(parts) == 1 else "clamp"
    case = {"title": f"sensible {number}: {kind}, {behind}", "cables": {"cable": cable},
            "route": {"head_at": head_at, "slope": f"{slope} deg",
                      "pieces": [{**p, "bend": f"{p['bend']} deg"} if "bend" in p else p for p in pieces]},
            "drive": {"winch": drive(r, speed, to, need, grip)}, "friction": friction_law(r, mu, speed),
            "run": {"duration": round(to + settle + window, 1), "steady_from": round(to + settle, 1)}}
    source(r, case, start, cable, behind)
    support(r, case, kind, parts, cable, pulled, mu, spins)
    behind_start = behind == "reel" or len(parts) > 1 or r.chance(0.4)
    if behind == "reel":
        cable_length = case["reel"]["distance"] + head_at + r.even(3, 15)
    elif behind_start:
        case["lead_in"] = {"weight": r.choice(["carried", "carried", "full"])}
        cable_length = head_at + travel + r.even(0.5, 2)
    else:
        cable_length = head_at - r.even(0.3, 1)
    case["chain"] = [{"cable": "cable", "length": round(cable_length, 2)}]
    if roped:
        case["cables"]["rope"] = rope(r, cable)
        case["chain"].append({"cable": "rope", "length": round(length - head_at + r.even(0, 1), 2), "swivel": True})
        if "speed" in case["drive"]["winch"] and r.chance(0.2):
            case["drive"]["rope_drag"] = {"force": round(weight * r.even(1, 5))}
    segments(r, case, parts)
    if "tension" in case["drive"]["winch"]:
        for row in case.get("rollers", {}).get("along", []):
            motor = row.get("spin", {}).get("motor", {})
            if motor.pop("factor", None):  # no speed to follow
                motor["torque"] = motor.pop("limit")
    if kind == "rollers" and r.chance(0.3):
        ahead(r, case, parts, tensions(parts, start, weight, low, head_at)[-1][1])
    # the relaxation knows no friction: what only that keeps from running down does not stand it
    held = start if behind == "taut" else 0
    if min(T for _, T, _, _ in tensions(parts, held, weight, 0, length)) < 0:
        case["solver"] = {"relax": False}
    if r.chance(0.1):
        case["contact"] = {"geometry": "cylinder"}
    elif r.chance(0.1):
        case["contact"] = {"k": r.choice([1e8, 1e9]), "e": 1.5}
    return case


if __name__ == "__main__":
    for word in sys.argv[1:]:
        print(json.dumps(draw(int(word)), indent=1))
