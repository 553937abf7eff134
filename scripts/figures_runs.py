"""The runs behind docs/paper.md: the paper's case and what is changed in it, and how a run is made and read."""
import os
import subprocess
import sys

from results_tables import read_summary, read_table

CASE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "cases", "huangjiahu.yaml")

# Segments whose speed and tension are recorded. With the front at F, 58.5 m, segment k starts (304.5 - k)/2 m behind it:
# the sections' segments are near 20 m (up at 10 deg), 40 m (level) and 54 m (down at 5 deg). Table 2's locations count
# from 1; its last, 379, is beyond the 370 segments of table 1's chain and stands for the last.
SECTIONS = {"up": 227, "level": 267, "down": 295}
ROPE = (310, 340, 369)
WATCHED = tuple(range(188, 305, 4))
SPEEDS_OF = sorted({0, 8, 16, 88, 100, 120, 196, 236, 304, *ROPE, *WATCHED,
                    *(k + d for k in SECTIONS.values() for d in (-8, 0, 8))})
LOADS = ("P28", "P29", "P30", "P31", "P32")

FINE = {"output.interval": "5 ms", "output.states": "0 s"}
SHORT = {**FINE, "run.duration": "10 s", "run.steady_from": "6 s"}
TAIL = {"drive.tail.ramp": "none"}
SUDDEN = {**TAIL, "drive.winch.ramp": "none", **SHORT}
SOFT = {"cables.power.EI": "16.4 kN m2"}
# The front starts at 50 m; four more pulleys and 8 m more of route lie behind F, or P32 would carry the free end for ever.
FRONT = {"route.head_at": "50 m", "route.pieces.6.straight": "13.6460084 m", "paper.terms.4.length": "16.264 m",
         "rollers.along.to": "66.0484 m", "rollers.along.count": "36", "run.duration": "150 s",
         "run.steady_from": "110 s", "output.interval": "100 ms", "output.states": "0 s"}
RUBBER = {"rollers.along.mount": "{stiffness: [100 kN/m, 100 kN/m, 200 kN/m, 4.5 kN m/rad, 4.5 kN m/rad, 4.5 kN m/rad], "
                                 "damping: 2 ms, mass: 25 kg, inertia: 0.5 kg m2}"}
SPIN = {"rollers.along.spin": "{inertia: 0.1 kg m2, bearing: {friction: 0.1, journal: 12 mm}}", "friction.mu": "0.3"}
NO_ROPE = {"chain.1.length": "1 m", "cables.rope.damping": "1 ms", "output.interval": "1 ms",
           "output.speeds_of": "[0, 304]"}


def ramp(kind, seconds):
    return {"drive.winch.ramp": kind, "drive.winch.to": f"{seconds} s"}


def slow(v_s):
    """A friction law that is full at v_s; the same for the rope's drag."""
    return {f"{key}.{name}": f"{factor * v_s} mm/s" for key in ("friction", "drive.rope_drag")
            for name, factor in (("v_s", 1), ("v_d", 2))}


FIGURE_RUNS = {
    "case": {},
    "flexible": SOFT,
    "fine": {"output.interval": "5 ms", "output.states": "0 s"},
    "cylinders": {"contact.geometry": "cylinder", "output.interval": "5 ms", "output.states": "0 s"},
    "sudden": SUDDEN,
    "step1": {**TAIL, **ramp("step", 1), **SHORT},
    "step2": {**TAIL, **ramp("step", 2), **SHORT},
    "front": {**SOFT, **FRONT},
}

# Every row of the document's tables: what it says, and what is set.
EXPERIMENTS = {
    "winch": [
        ("**the case**: winch and tail by STEP over 13 s", {}),
        ("winch STEP 5 s, tail 13 s", ramp("step", 5)),
        ("winch STEP 1 s, tail 13 s", ramp("step", 1)),
        ("winch STEP5 13 s, tail 13 s", ramp("step5", 13)),
        ("winch STEP5 1 s, tail 13 s", ramp("step5", 1)),
        ("winch at once, tail 13 s", {"drive.winch.ramp": "none", **FINE}),
        ("full tail from the start, winch STEP 13 s", TAIL),
        ("full tail, winch STEP 5 s", {**TAIL, **ramp("step", 5), **FINE}),
        ("full tail, winch STEP 2 s", {**TAIL, **ramp("step", 2), **SHORT}),
        ("full tail, winch STEP 1 s", {**TAIL, **ramp("step", 1), **SHORT}),
        ("full tail, winch STEP5 1 s", {**TAIL, **ramp("step5", 1), **SHORT}),
        ("**full tail, winch at once**", SUDDEN),
    ],
    "model": [
        ("cylinders, the case's ramps", {"contact.geometry": "cylinder"}),
        ("cylinders, winch at once", {**SUDDEN, "contact.geometry": "cylinder"}),
        ("EI/20, the case's ramps", SOFT),
        ("EI/20, winch at once", {**SUDDEN, **SOFT}),
        ("cable damping 20 ms, the case's ramps", {"cables.power.damping": "20 ms"}),
        ("cable damping 20 ms, winch at once", {**SUDDEN, "cables.power.damping": "20 ms"}),
        ("rope damping 1 ms, winch at once", {**SUDDEN, "cables.rope.damping": "1 ms"}),
        ("rope damping 100 ms, winch at once", {**SUDDEN, "cables.rope.damping": "100 ms"}),
        ("v_s = 5 mm/s, the case's ramps", slow(5)),
        ("v_s = 100 mm/s, the case's ramps", slow(100)),
        ("v_s = 100 mm/s, winch at once", {**SUDDEN, **slow(100)}),
        ("pulleys on rubber mounts, the case's ramps", RUBBER),
        ("pulleys on rubber mounts, winch at once", {**SUDDEN, **RUBBER}),
        ("spinning pulleys (mu 0.3 on 12 mm journals), the case's ramps", SPIN),
        ("spinning pulleys, winch at once", {**SUDDEN, **SPIN}),
    ],
    "front": [
        ("front from 50 m, table 1's EI", FRONT),
        ("front from 50 m, table 1's EI, cylinders", {**FRONT, "contact.geometry": "cylinder"}),
        ("**front from 50 m, EI/20**", {**FRONT, **SOFT}),
        ("front from 55 m, EI/20, no pulley beyond P32",
         {**SOFT, **{key: FRONT[key] for key in FRONT if key.startswith(("run.", "output."))}, "route.head_at": "55 m"}),
        ("front from 50 m, EI/20, cylinders", {**FRONT, **SOFT, "contact.geometry": "cylinder"}),
    ],
    "peak": [
        ("winch at once, rope 10 m", {**SUDDEN, **NO_ROPE, "chain.1.length": "10 m"}),
        ("winch at once, rope 1 m", {**SUDDEN, **NO_ROPE}),
        ("winch starts at 0.2 m/s, falls to 0.1 in 2 s; rope 32.5 m",
         {**SUDDEN, "drive.winch": "{table: [[0, 0.2], [2, 0.1], [10, 0.1]]}"}),
        ("**the same, rope 1 m**",
         {**SUDDEN, **NO_ROPE, "drive.winch": "{table: [[0, 0.2], [2, 0.1], [10, 0.1]]}"}),
        ("winch starts at 0.7 m/s, falls to 0.1 in 2 s; rope 32.5 m",
         {**SUDDEN, "drive.winch": "{table: [[0, 0.7], [2, 0.1], [10, 0.1]]}"}),
        ("winch at once, no equilibrium before t = 0, rope damping 7.8 ms",
         {**SUDDEN, "solver.relax": "false", "cables.rope.damping": "7.8 ms"}),
        ("winch pulls with 49 kN up to 6 m/min",
         {**SUDDEN, "drive.winch": "{tension: {force: 49 kN, ramp: none, speed_limit: 6 m/min}, grip: axial}"}),
        ("mu_s = 0.5 at rest, mu_d = 0.1, winch STEP 13 s, full tail",
         {**TAIL, "friction": "{mu_s: 0.5, mu_d: 0.1, v_s: 1 mm/s, v_d: 2 mm/s}"}),
    ],
}


class Run:
    """A run's tables (columns by name) and its summary."""

    def __init__(self, folder):
        self.series, self.stations = read_table(folder, "series.csv"), read_table(folder, "stations.csv")
        self.rollers, self.summary = read_table(folder, "rollers.csv"), read_summary(folder)
        self.steady_from = self.summary["steady_window"]["from_s"]


def run_case(program, folder, settings):
    """Runs the paper's case with settings {key: value} into a folder and reads the results."""
    wanted = {"output.speeds_of": str(SPEEDS_OF), "output.rollers_of": "[" + ", ".join(LOADS) + "]", **settings}
    # a section that is replaced comes before the keys that are set in it
    keys = sorted(wanted, key=lambda key: key.count("."))
    if str(wanted.get("drive.winch", "")).startswith("{"):
        keys = [key for key in keys if not key.startswith("drive.winch.")]
    command = [program, "run", CASE, "-q", "-o", folder] + [f"--set={key}={wanted[key]}" for key in keys]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    if done.returncode:
        sys.exit(f"figures: hawser failed: {done.stderr.strip()}\n  with {settings}")
    return Run(folder)
