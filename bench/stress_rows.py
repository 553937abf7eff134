"""The conditions of bench/stress.py: one row each, with the values it is driven through, the case for every value, and what
must be true of the results.

A row's `case(value)` is a case file as a dict (JSON is YAML), its `judge(value, run)` a pair (does it hold?, measured in
words). `run` has the summary and the columns of series.csv. Conditions are closed forms wherever there is one: a cable pulled
along level rollers costs mu m g whatever its stiffness, its damping, the contact's stiffness or the number of segments.
"""
import copy
import math
from dataclasses import dataclass, field
from typing import Callable

from stress_bundles import bundle_rows

GRAVITY, MASS, MU = 9.81, 22.0, 0.2
DIAMETER, AREA, MODULUS = 87.3e-3, 5982.7e-6, 115e9
BAR = math.pi * DIAMETER**4 / 64  # second moment of area
LENGTH, SPEED = 20.0, 0.1


@dataclass
class Run:
    """What a finished run gave. `column(name)` is a column of series.csv without its gaps."""

    summary: dict
    series: dict

    def column(self, name):
        return [v for v in self.series.get(name, []) if v is not None]

    @property
    def pull(self):
        return self.summary["pull_force"]["steady_mean_N"]


@dataclass
class Row:
    """A condition. Values in `known` may end otherwise, for the cause that stands there; `why` says what makes the number of
    steps explode from one value to the next, where it does."""

    name: str
    unit: str
    values: tuple
    case: Callable
    judge: Callable
    asks: str
    known: dict = field(default_factory=dict)
    why: str = ""


# ----------------------------------------------------------------------------------------------------------- scenes


def pull_case():
    """20 m of the paper's cable on a level row of rollers with room to go: the pull is mu m g L = 863 N."""
    return {
        "cables": {"a": {"d": DIAMETER, "EA": MODULUS * AREA, "GA": 41.5e9 * AREA, "GJ": 2 * 41.5e9 * BAR,
                         "EI": MODULUS * BAR, "mass": MASS, "damping": 1e-3}},
        "chain": [{"cable": "a", "length": LENGTH, "segment": 0.5}],
        "route": {"head_at": LENGTH + 1.25, "pieces": [{"straight": LENGTH + 5}]},
        "rollers": {"along": {"from": 0, "to": LENGTH + 5, "spacing": 2, "radius": 0.1, "width": 0.4}},
        "friction": {"mu": MU, "v_s": 1e-3, "v_d": 2e-3},
        "contact": {"geometry": "smooth", "k": 3.4e8, "e": 1.5, "c": 1e4, "d": 1e-4},
        "drive": {"winch": {"speed": SPEED, "ramp": "step", "from": 0, "to": 1, "grip": "axial"}},
        "run": {"duration": 5, "steady_from": 3},
        "output": {"states": 0},
    }


def floor_case():
    """The same on a floor in place of the rollers."""
    case = pull_case()
    del case["rollers"]
    case["surfaces"] = {"planes": [{"point": [0, 0, -DIAMETER / 2], "normal": [0, 0, 1]}]}
    return case


def rod_case(length=10.0, count=40):
    """A rod of moderate stiffness without gravity: EI = 1 kN m2, GJ = 800 N m2, EA = 10 MN, 5 kg/m."""
    return {
        "gravity": 0,
        "cables": {"a": {"d": 0.03, "EA": 1e7, "GA": 4e6, "GJ": 800.0, "EI": 1e3, "mass": 5.0, "damping": 1e-3}},
        "chain": [{"cable": "a", "length": length, "segment": length / count}],
        "rod": {"tail": {"fixing": "clamped"}, "head": {"fixing": "clamped"}},
        "run": {"duration": 2},
        "output": {"states": 0},
    }


def put(case, **changes):
    """A copy with values changed; keys are paths with __ between their parts."""
    case = copy.deepcopy(case)
    for key, value in changes.items():
        *parents, last = key.split("__")
        place = case
        for part in parents:
            place = place[int(part)] if part.isdigit() else place.setdefault(part, {})
        place[int(last) if last.isdigit() else last] = value
    return case


# ----------------------------------------------------------------------------------------------------- what must hold


def within(share, expected, room=0.0):
    """The steady pull is `expected(value)` to a share of it, and `room` newtons."""
    def judge(value, run):
        want, have = expected(value), run.pull
        found = f"pull {100 * (have / want - 1):+.3f} % of {want:.5g} N" if want else f"pull {have:.3g} N of 0 N"
        return abs(have - want) <= share * want + room, found
    return judge


def between(low, high):
    """The steady pull lies between two bounds."""
    def judge(value, run):
        return low(value) <= run.pull <= high(value), f"pull {run.pull:.4g} N in {low(value):.4g} to {high(value):.4g} N"
    return judge


def peak_below(bound):
    """No tension of the run is above `bound(value)`."""
    def judge(value, run):
        peak = max(run.column("max_tension_N"))
        return peak <= bound(value), f"largest tension {peak:.4g} N, bound {bound(value):.4g} N"
    return judge


def column_below(name, bound, words, unit):
    """No value of a column is larger in size than `bound(value)`."""
    def judge(value, run):
        peak = max(abs(v) for v in run.column(name))
        return peak <= bound(value), f"{words} {peak:.4g} {unit}, bound {bound(value):.4g} {unit}"
    return judge


def drift_below(bound):
    """The probe in the middle ends no farther than `bound` from where it was at half the time."""
    def judge(value, run):
        along = run.column("middle_x_m"), run.column("middle_z_m")
        move = math.hypot(*(c[-1] - c[len(c) // 2] for c in along))
        return move <= bound, f"drift {move:.2g} m in the second half, bound {bound:.2g} m"
    return judge


FRICTION = MU * MASS * GRAVITY * LENGTH  # 863 N
WAVE = math.sqrt(MODULUS * AREA * MASS)  # N s/m: force of a speed's jump, EA v/c
WEIGHT = MASS * GRAVITY * LENGTH
MIDDLE = {"probes": [{"name": "middle", "at": LENGTH / 2}], "states": 0}


# ------------------------------------------------------------------------------------------------------------ the rows


def e_case(value, scene=floor_case):
    """The modulus goes through all rigidities; the run lasts until friction has stretched the cable."""
    share = value / MODULUS
    cable = scene()["cables"]["a"]
    stretch = FRICTION * LENGTH / (2 * MODULUS * AREA * share)
    swing = 4 * LENGTH / math.sqrt(MODULUS * AREA * share / MASS)  # s, of the free end in stretching
    time = 5 + 2 * stretch / SPEED + 4 * swing
    case = put(scene(), run={"duration": time, "steady_from": time - 2 - 2 * swing}, route__pieces__0__straight=40)
    return put(case, **{f"cables__a__{key}": cable[key] * share for key in ("EA", "GA", "GJ", "EI")})


def taut_case(value):
    """The same on rollers, held taut by 5 kN: a limp cable would fall between them."""
    return put(e_case(value, pull_case), drive__tail={"tension": 5000, "ramp": "none"},
               drive__winch__grip="clamp")


def droop_case(value):
    """The same on an axial grip, which does not hold a limp cable's head up."""
    return put(taut_case(value), drive__winch__grip="axial")


def droop_judge(value, run):
    """The pull is right, or the run says that the head has drooped."""
    right, found = within(0.03, lambda v: 5000 + FRICTION)(value, run)
    said = any("the head is turned" in event["what"] for event in run.summary["events"])
    return right or said, found + (", said that the head droops" if said else "")


def mass_case(ratio):
    """Heavy, light and heavy pieces; every neighbour of another kind is `ratio` times heavier or lighter."""
    case = pull_case()
    case["cables"]["b"] = {**case["cables"]["a"], "mass": MASS / ratio}
    case["chain"] = [{"cable": name, "length": LENGTH / 5, "segment": 0.5} for name in "ababa"]
    case["chain"][-1]["rope"] = True
    return case


def mass_pull(ratio):
    return FRICTION * (3 + 2 / ratio) / 5


def aspect_case(aspect):
    """40 segments on a floor, `aspect` diameters long each; beyond 10 the cable is lighter by as much, so that it stays
    short of being stretched by more than the winch moves."""
    length = 40 * aspect * DIAMETER
    mass = MASS * min(1, 10 / aspect)
    return put(floor_case(), chain=[{"cable": "a", "length": length, "segment": aspect * DIAMETER}], cables__a__mass=mass,
               route={"head_at": length + 0.25, "pieces": [{"straight": length + 5}]})


def aspect_pull(aspect):
    return MU * MASS * min(1, 10 / aspect) * GRAVITY * 40 * aspect * DIAMETER


def bounce_case(ratio):
    """A rod bent by 100 N across its middle, let go within 1 ms."""
    case = put(rod_case(), output={"probes": [{"name": "middle", "at": 5.0}], "states": 0, "interval": 0.02}, cables__a__damping_ratio={key: ratio for key in ("axial", "shear", "torsion", "bending")})
    case["rod"]["loads"] = [{"at": 5.0, "direction": [0, 0, 1], "force": 100, "table": [[0, 1], [0.5, 1], [0.501, 0], [9, 0]]}]
    return case


def bounce_judge(value, run):
    """It swings no farther than it was bent."""
    z = run.column("middle_z_m")
    first = max(z[: int(0.25 * len(z)) - 1])
    peak = max(abs(v) for v in z)
    return peak <= 1.05 * first, f"swings to {peak / first:.3f} of the deflection let go of"


def stop_case(time):
    """The winch stops from its speed within `time`."""
    return put(pull_case(), drive__winch={"table": [[0, 0], [1, SPEED], [3, SPEED], [3 + time, 0], [9, 0]], "grip": "axial"},
               run={"duration": 5, "steady_from": 4})


def jam_case(torque):
    """Rollers that spin on bearings with a set torque, whatever the load."""
    spin = {"inertia": 0.06, "bearing": {"friction": 0, "torque": torque, "speed": 0.01}}
    return put(pull_case(), rollers__along__spin=spin)


def inertia_case(inertia):
    """Rollers that hardly turn, or that turn at once."""
    return put(jam_case(1.0), rollers__along__spin__inertia=inertia)


def snag_case(time):
    """A snag holds the tail back with 20 kN and lets go within `time`."""
    return put(pull_case(), drive__tail={"table": [[0, 0], [1, 2e4], [3, 2e4], [3 + time, 0], [9, 0]]},
               run={"duration": 5, "steady_from": 4})


def grab_case(time):
    """A conveyor that stands holds the cable against the winch; from 2 s on it runs along within `time`."""
    case = put(pull_case(), drive__winch__grip="clamp")
    case["conveyors"] = [{"from": 10.2, "to": 11.8, "clamp": 2e4, "mu": 0.3, "v_s": 1e-4, "hold": False,
                          "belt": {"table": [[0, 0], [2, 0], [2 + time, SPEED], [9, SPEED]]}}]
    return case


def fall_case(height):
    """A cable let go above rollers."""
    time = 3 + 5 * math.sqrt(2 * height / GRAVITY)
    case = put(pull_case(), run={"duration": time}, solver={"relax": False}, output=MIDDLE)
    del case["drive"], case["rollers"]
    case["rollers"] = {"list": [{"centre": [x, 0, -0.1 - DIAMETER / 2 - height], "axis": [0, 1, 0], "radius": 0.1, "width": 0.4}
                                for x in range(0, 26, 2)]}
    return case


def fall_judge(height, run):
    """The middle falls as deep as the rollers let it and is nearly at rest there."""
    z = run.column("middle_z_m")
    bounce = max(z[-5:]) - min(z[-5:])
    deep = -min(z) - height
    return deep < 0.05 + 0.2 * height and bounce < 0.02, f"{1e3 * deep:.3g} mm below the row, moves {1e3 * bounce:.2g} mm at the end"


FLIES = "at 100 m/s the cable flies from roller to roller, and the run says that its pull is not to be trusted"


def speed_case(speed):
    """The pull at a speed; as far as 1 s at that speed, with at least 5 s below 1 m/s."""
    time = 5 if speed <= 1 else 2
    room = speed * time + 2
    return put(pull_case(), drive__winch__speed=speed, run={"duration": time, "steady_from": 0.7 * time},
               route={"head_at": LENGTH + 1.25, "pieces": [{"straight": LENGTH + room + 2}]},
               rollers__along__to=LENGTH + room + 2)


def twist_case(turns, count=160):
    """A rod under 50 kN of tension, turned at its head. It stays straight: M < 2 sqrt(EI T) (Greenhill, long rods)."""
    case = rod_case(count=count)
    case["rod"]["head"] = {"fixing": "held", "hold": ["torsion", "shear_y", "shear_z", "bending_y", "bending_z"],
                           "motion": [{"direction": [1, 0, 0], "turn": f"{360 * turns} deg", "ramp": "step", "from": 0, "to": 2}]}
    case["rod"]["loads"] = [{"at": 10, "direction": [1, 0, 0], "force": 5e4, "ramp": "none"}]
    return put(case, run={"duration": 3}, cables__a__GJ=40.0, output={"probes": [{"name": "head", "at": 10.0}], "states": 0})


def twist_judge(turns, run):
    """The torque is GJ theta/L."""
    want = 40.0 * 2 * math.pi * turns / 10
    have = abs(run.column("head_mx_N_m")[-1])
    return abs(have - want) <= 0.01 * want, f"torque {100 * (have - want) / want:+.3f} % of {want:.4g} N m"


def joint_case(angle):
    """The same rod in 20 segments, turned by so much a joint; beyond 180 deg a joint snaps back."""
    return twist_case(angle * 20 / 360, 20)


def joint_judge(angle, run):
    """The torque is right, or the run says that a joint has turned too far."""
    right, found = twist_judge(angle * 20 / 360, run)
    said = any("a joint is turned" in event["what"] for event in run.summary["events"])
    return right or said, found + (", said so" if said else "")


def buckle_case(turns):
    """A rod of 40 segments between clamped ends, turned: it buckles into loops."""
    case = rod_case()
    case["rod"]["head"] = {"fixing": "clamped", "motion": [{"direction": [1, 0, 0], "turn": f"{360 * turns} deg", "ramp": "step",
                                                            "from": 0, "to": 2}]}
    case["gravity"] = [0, 0, -0.1]
    return put(case, run={"duration": 3})


def buckle_bound(turns):
    """Tension, N, if all work of the turning were stretch: W <= GJ theta^2/(2 L) = T^2 L/(2 EA)."""
    return math.sqrt(800.0 * 1e7) * 2 * math.pi * turns / 10 + 100


def buckle_judge(turns, run):
    """The tension is bounded by the work done; past half a turn a joint the run says so."""
    peak = max(run.column("max_tension_N"))
    said = any("a joint is turned" in event["what"] for event in run.summary["events"])
    return peak <= buckle_bound(turns) and (said or turns < 20), \
        f"tension {peak:.4g} N, bound {buckle_bound(turns):.4g} N" + (", said that a joint turned too far" if said else "")


def count_case(count):
    """The pull by a cable of few or many segments; a single one is held by nothing but its rollers."""
    return put(floor_case(), chain=[{"cable": "a", "length": LENGTH, "segment": LENGTH / count}])


def rest_case(seconds, law="adams", slope=0):
    """The cable lies there for a long time."""
    case = put(pull_case(), friction={"mu": 0.5, "v_s": 1e-3, "law": law}, run={"duration": seconds}, output=MIDDLE,
               route__slope=f"{slope} deg", output__interval=seconds / 100)
    del case["drive"]
    return put(case, solver__relax=slope == 0)


def duct_case(rigidity):
    """A limp cable through a duct with bends, drawn by an axial grip: a follower force."""
    return {
        "cables": {"a": {"d": 0.06, "mass": 10, "EA": 5e7, "GA": 2e7, "GJ": 2e3, "EI": rigidity, "damping": 2e-3}},
        "chain": [{"cable": "a", "length": 12, "segment": 0.25}],
        "route": {"head_at": 13, "pieces": [{"straight": 4}, {"bend": "60 deg", "radius": 5, "plane": "left"}, {"straight": 6}]},
        "surfaces": {"ducts": [{"radius": 0.031, "place": "resting", "friction": {"mu": 0.25}}]},
        "drive": {"winch": {"speed": 0.1, "from": 0, "to": 1, "grip": "axial"}, "tail": {"tension": 2000, "ramp": "none"}},
        "run": {"duration": 4, "steady_from": 2}, "output": {"states": 0},
    }


def start_case(time):
    """The winch reaches its speed within `time`."""
    return put(pull_case(), drive__winch__to=time)


def trip_case(time):
    """The winch trips at once and brakes within `time`, starts again and trips again."""
    return put(pull_case(), drive__winch__trip={"force": 600, "brake": time, "restarts": 3, "pause": 0.2, "ramp": time})


def mount_case(stiffness):
    """Rollers on springs."""
    return put(pull_case(), rollers__along__mount={"stiffness": [stiffness] * 3 + [stiffness / 50] * 3, "damping": 2e-3, "mass": 25,
                                                   "inertia": 0.5})


def drum_case(radius, geometry="smooth"):
    """A rope over a quarter of a drum, hanging on both sides: heavy below."""
    return {
        "cables": {"a": {"d": 0.03, "mass": 2, "EA": 5e6, "GA": 2e6, "GJ": 5, "EI": 5, "damping": 5e-3}},
        "chain": [{"cable": "a", "length": 4 + math.pi / 2 * radius, "segment": 0.125}],
        "route": {"head_at": 2 + math.pi / 2 * radius + 2.5, "pieces": [{"straight": 2.5},
                  {"bend": "90 deg", "radius": radius + 0.015, "plane": "right"}, {"straight": 3.5}]},
        "gravity": 0,
        "rollers": {"list": [{"centre": [2.5, -radius - 0.015, 0], "axis": [0, 0, 1], "radius": radius, "width": 1}]},
        "contact": {"geometry": geometry, "k": 1e8},
        "friction": {"mu": 0.2},
        "drive": {"winch": {"speed": 0.1, "from": 0, "to": 1}, "tail": {"tension": 500, "ramp": "none"}},
        "run": {"duration": 3, "steady_from": 2}, "output": {"states": 0},
    }


def swing_case(order):
    """The undamped rod of `bounce_case` with an order of the BDF, which `auto` would not take for it."""
    return put(bounce_case(0), solver__max_order=order, solver__method="bdf")


DRUM_PEAK = peak_below(lambda v: 2 * 500 * math.exp(MU * math.pi / 2))
FLOOR_PULL = within(0.01, lambda v: FRICTION)
ROLLER_PULL = within(0.02, lambda v: FRICTION)
WAVES = peak_below(lambda v: 1.02 * (FRICTION + 2 * WAVE * SPEED))
PULL = "pull within {} % of mu m g L"
WAVE_ASKS = "tension below friction and twice the wave's EA v/c"
ORDER = "BDF beyond order 2 is unstable near the imaginary axis, where undamped waves are; 2 is the default"
WRAP = ("a limp cable bent around a roller over more than two segments lies as close to it everywhere: no point is nearest, (C6) is "
        "broken; the message names `contact.geometry: cylinder`")
EVENTS = "a sudden change is followed by its waves, which are resolved while they last"

ROWS = (
    Row("E, on a floor", "Pa", (1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13), e_case, FLOOR_PULL, PULL.format(1)),
    Row("E, on rollers", "Pa", (1e8, 1e9, 1e10, 1e11, 1e12, 1e13), taut_case, within(0.03, lambda v: 5000 + FRICTION),
        "pull within 3 % of 5 kN and mu m g L"),
    Row("E, axial grip", "Pa", (1e8, 1e9, 1e10, 1e11, 1e12, 1e13), droop_case, droop_judge,
        "the same, or the run says that the head droops"),
    Row("damping", "s", (0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1), lambda v: put(pull_case(), cables__a__damping=v), ROLLER_PULL,
        PULL.format(2)),
    Row("damping ratio", "", (0, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.5, 1), bounce_case, bounce_judge, "a bent rod let go swings no farther"),
    Row("order, undamped", "", (1, 2, 3, 4, 5), swing_case, bounce_judge, "a bent rod let go swings no farther",
        known={v: ORDER for v in (3, 4, 5)}, why=ORDER),
    Row("mass ratio", "", (1, 10, 100, 1e3, 1e4, 1e5, 1e6), mass_case, within(0.02, mass_pull), "pull within 2 % of mu g sum m"),
    Row("segment/diameter", "", (0.1, 0.3, 1, 3, 10, 100, 1000), aspect_case, within(0.01, aspect_pull), PULL.format(1)),
    Row("segments", "", (1, 2, 3, 5, 10, 100, 1000), count_case, FLOOR_PULL, PULL.format(1)),
    Row("mu", "", (0, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 1), lambda v: put(pull_case(), friction__mu=v),
        within(0.01, lambda v: FRICTION * v / MU, 1e-4 * WEIGHT), PULL.format(1) + " and 1e-4 of the weight"),
    Row("v_s", "m/s", (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.04), lambda v: put(pull_case(), friction={"mu": MU, "v_s": v, "v_d": 2 * v}),
        ROLLER_PULL, PULL.format(2)),
    Row("v_s, on a floor", "m/s", (1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.04),
        lambda v: put(floor_case(), friction={"mu": MU, "v_s": v, "v_d": 2 * v}), FLOOR_PULL, PULL.format(1)),
    Row("stick d_s", "m", (1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2),
        lambda v: put(pull_case(), friction={"mu": MU, "v_s": 1e-3, "law": "stick", "d_s": v}), ROLLER_PULL, PULL.format(2)),
    Row("contact k", "N/m^1.5", (3.4e5, 3.4e6, 3.4e7, 3.4e8, 3.4e9, 3.4e10, 3.4e11), lambda v: put(pull_case(), contact__k=v),
        ROLLER_PULL, PULL.format(2)),
    Row("k, cylinder", "N/m^1.5", (3.4e5, 3.4e6, 3.4e7, 3.4e8, 3.4e9, 3.4e10, 3.4e11),
        lambda v: put(pull_case(), contact__k=v, contact__geometry="cylinder"), within(0.03, lambda v: FRICTION), PULL.format(3)),
    Row("contact c", "N s/m", (0, 10, 1e3, 1e5, 1e7, 1e9), lambda v: put(pull_case(), contact__c=v), ROLLER_PULL, PULL.format(2)),
    Row("reach", "m", (1e-3, 1e-2, 0.1, 1, 10, 100), lambda v: put(pull_case(), contact__reach=v), ROLLER_PULL, PULL.format(2)),
    Row("mount k", "N/m", (1e4, 1e5, 1e6, 1e7, 1e8, 1e9), mount_case, ROLLER_PULL, PULL.format(2)),
    Row("gravity", "m/s2", (0, 1e-3, 0.1, 1.62, 30, 300, 1000), lambda v: put(pull_case(), gravity=v),
        within(0.03, lambda v: FRICTION * v / GRAVITY, 1e-3), PULL.format(3) + " and 1 mN"),
    Row("speed", "m/s", (1e-3, 1e-2, 0.1, 1, 10, 100), speed_case, within(0.08, lambda v: FRICTION),
        PULL.format(8) + "; at 10 m/s the cable bounces, and a run of accuracy 1e-6 has 6 % less",
        known={100: FLIES}, why=FLIES),
    Row("accuracy", "", (0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8), lambda v: put(pull_case(), solver={"accuracy": v}),
        FLOOR_PULL, PULL.format(1)),
    Row("winch starts in", "s", (1, 0.1, 1e-2, 1e-3, 1e-4, 1e-5), start_case, WAVES, WAVE_ASKS),
    Row("winch stops in", "s", (1, 0.1, 1e-2, 1e-3, 1e-4, 1e-5), stop_case, WAVES, WAVE_ASKS),
    Row("winch trips in", "s", (1, 0.1, 1e-2, 1e-3, 1e-4), trip_case, WAVES, WAVE_ASKS),
    Row("snag lets go in", "s", (1, 0.1, 1e-2, 1e-3, 1e-4, 1e-5), snag_case, peak_below(lambda v: 1.03 * (2e4 + FRICTION)),
        "tension never above the snag's 20 kN and friction", why=EVENTS),
    Row("conveyor lets go in", "s", (1, 0.1, 1e-2, 1e-3, 1e-4), grab_case, peak_below(lambda v: 1.05 * (2 * 0.3 * 2e4 + FRICTION)),
        "tension never above the conveyor's grip and friction"),
    Row("jammed: torque", "N m", (0, 0.1, 1, 10, 100, 1e4, 1e6), jam_case, between(lambda v: -5.0, lambda v: 1.01 * FRICTION),
        "pull not above that of fixed rollers"),
    Row("roller inertia", "kg m2", (1e-6, 1e-4, 1e-2, 1, 100), inertia_case, between(lambda v: 0.0, lambda v: 1.01 * FRICTION),
        "pull not above that of fixed rollers"),
    Row("falls from", "m", (1e-3, 1e-2, 0.1, 0.3, 1, 3, 10, 30, 100), fall_case, fall_judge, "lands on the rollers and comes to rest",
        why="every impact is resolved, and a higher fall has more of them"),
    Row("twist, taut", "turns", (1, 5, 10, 20, 50), twist_case, twist_judge, "torque GJ theta/L within 1 %"),
    Row("twist a joint", "deg", (30, 60, 120, 160, 200, 450), joint_case, joint_judge, "the same, or the run says that a joint snaps back",
        why="past 180 deg joints snap to the other side one after the other"),
    Row("twist, slack", "turns", (1, 2, 5, 10, 20, 50), buckle_case, buckle_judge, "tension bounded by the work of the turning",
        why="past half a turn a joint, joints snap to the other side; before it, the rod buckles and whips"),
    Row("at rest for", "s", (1, 100, 1e4, 1e6), rest_case, drift_below(1e-6), "drift below 1 um in the second half",
        why="a step is as long as the time between rows"),
    Row("on 20 deg, stick", "s", (100, 1e4, 1e6), lambda v: rest_case(v, "stick", 20), drift_below(1e-6), "drift below 1 um in the second half",
        why="the first second takes most of the steps"),
    Row("axial grip, EI", "N m2", (1e4, 1e3, 100, 10, 1, 0.1, 1e-3), duct_case, peak_below(lambda v: 1e4),
        "tension below 10 kN, three times theory's"),
    Row("drum, smooth", "m", (2, 1, 0.5, 0.3, 0.2), drum_case, DRUM_PEAK, "tension below twice Euler's",
        known={v: WRAP for v in (2, 1, 0.5, 0.3, 0.2)}),
    Row("drum, cylinder", "m", (2, 1, 0.5, 0.3, 0.2), lambda v: drum_case(v, "cylinder"), DRUM_PEAK, "tension below twice Euler's"),
) + bundle_rows(Row)
