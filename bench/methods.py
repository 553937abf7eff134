#!/usr/bin/env python3
"""Other methods on hawser's own equations: what the choice of integrator, reduction, linear solver and plane is worth.

bench_methods makes each run in a process of its own and measures it against a converged winch force. For every scene and
method a sweep over steps or tolerances finds the cheapest setting that keeps to 1 % of the tension; these settings are then
timed again in rounds, each round running every method once. Explicit methods take millions of steps: they get windows of
hundredths of a second, and the rest is said by the tables.
"""
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

from common import ROOT, arguments, heading, load_of_others, publish, slope, table

from svgplot import COLOURS, Panel, write_svg

GOAL = 0.01  # of the largest force: what "equal error" means
SPACE = ("solver.planar=off",)
LIGHT = ("cables.power.damping=0.01 ms",)
# Scene: case, settings, window in s, accuracy of the reference; where explicit methods start, the windows in which their
# step is searched and then held, in s.
SCENES = {
    "huangjiahu": ("huangjiahu", (), (0, 15), 1e-6, (8.0, 0.004, 0.02)),
    "huangjiahu in space": ("huangjiahu", SPACE, (0, 15), 1e-6, (8.0, 0.004, 0.02)),
    "straight": ("straight", (), (0, 3), 1e-7, (0.5, 0.01, 0.2)),
    "straight in space": ("straight", SPACE, (0, 3), 1e-7, (0.5, 0.01, 0.2)),
    "straight, light": ("straight", LIGHT, (0, 3), 1e-7, (0.5, 0.02, 0.5)),
}
QUICK = {"straight": ("straight", (), (0, 0.1), 1e-5, (0.05, 0.001, 0.001)),
         "straight in space": ("straight", SPACE, (0, 0.1), 1e-5, (0.05, 0.001, 0.001))}

TOLERANCES = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7)
COARSE = (1e-2, 1e-3, 1e-4, 1e-5)
STEPS = (5e-2, 2e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4)
ORDER2, ORDER5 = ("solver.max_order=2",), ("solver.max_order=5",)
KLU = ("solver.linear_solver=klu",)
BOTH = (ORDER5, ORDER2)


class Method:
    """A row of the tables: the program's method, what is swept, and in which scenes it is run."""

    def __init__(self, name, program, sweep, variants=((),), extra=(), where=None, once=False):
        self.name, self.program, self.sweep, self.variants, self.extra = name, program, sweep, variants, extra
        self.where = where or (lambda scene: True)
        self.once = once  # hopeless: one short run says what there is to say


def in_space(scene):
    return scene.endswith("in space")


def in_plane(scene):
    return not in_space(scene)


HAWSER = "hawser"
USER_KLU = "CVODE, KLU, unreduced, coloured differences"
METHODS = (
    Method(HAWSER, "hawser", TOLERANCES),
    Method("hawser, KLU in place of the chain's solver", "hawser", TOLERANCES, extra=KLU),
    Method("CVODE's settings, hawser's matrix", "cvode-own", TOLERANCES, BOTH),
    Method(USER_KLU, "cvode-klu", COARSE, BOTH),
    Method("CVODE, band, unreduced", "cvode-band", COARSE, BOTH),
    Method("CVODE, GMRES", "cvode-gmres", (1e-4,), (ORDER5,), once=True, where=in_plane),
    Method("CVODE, GMRES(60)", "cvode-gmres-60", (1e-4,), (ORDER5,), once=True, where=in_plane),
    Method("CVODE, GMRES, band as preconditioner", "cvode-gmres-band", COARSE, BOTH),
    Method("CVODE, GMRES, hawser's matrix as preconditioner", "cvode-gmres-own", COARSE, BOTH),
    Method("ARKODE, SDIRK 2(1)", "dirk-sdirk2", TOLERANCES),
    Method("ARKODE, TR-BDF2", "dirk-trbdf2", TOLERANCES),
    Method("ARKODE, ARK3(2)4L[2]SA", "dirk-ark324", TOLERANCES),
    Method("ARKODE, ESDIRK3(2)5L[2]SA", "dirk-esdirk32", TOLERANCES),
    Method("ARKODE, Kvaerno 4(3)", "dirk-kvaerno43", TOLERANCES),
    Method("ARKODE, ESDIRK5(4)7L[2]SA", "dirk-esdirk54", TOLERANCES),
    Method("the same with ARKODE's own settings", "dirk-esdirk54-default", (1e-1, 1e-3, 1e-5), where=in_plane),
    Method("implicit Euler, fixed step", "implicit-euler", STEPS),
    Method("trapezoid, fixed step", "trapezoid", STEPS),
    Method("BDF2, fixed step", "bdf2-fixed", STEPS),
    Method("generalised alpha, fixed step", "generalised-alpha", STEPS),
)
# name, program, accuracies (None: the step is searched)
EXPLICIT = (("RK4", "rk4", None), ("semi-implicit Euler", "symplectic-euler", None),
            ("ARKODE, Bogacki-Shampine 3(2)", "erk-bogacki-shampine", (1e-5, 1e-4)),
            ("ARKODE, Dormand-Prince 5(4)", "erk-dormand-prince", (1e-5, 1e-4)))
# From a plain use of CVODE to hawser: each row has one thing more than the row before it.
LADDER = ((USER_KLU, "in space", "CVODE as its guide sets it up, KLU on the unreduced system in space, differences"),
          ("CVODE, KLU, unreduced, analytic", "in space", "the derivatives are analytic"),
          ("hawser, KLU, unreduced, analytic", "in space", "hawser's order, norm and Newton iteration"),
          ("hawser, KLU in place of the chain's solver", "in space", "positions and rotations eliminated"),
          (HAWSER, "in space", "the block solver of the chain"),
          (HAWSER, "", "in the plane, where the scene lies in one"))
COLUMNS = ["scene", "kind", "method", "program", "setting", "options", "round", "cpu_ms_per_s", "rms", "worst", "arrived",
           "why", "from_s", "reached_s", "cpu_s", "steps", "rhs", "iterations", "inner", "setups", "jacobians",
           "error_fails", "newton_fails", "largest_N", "per_segment"]


class Bench:
    """The helper program, and the rows that it has given so far."""

    def __init__(self, build, folder):
        self.program = os.path.join(build, "bench/methods/bench_methods")
        self.folder, self.rows = folder, []

    def path(self, scene, kind):
        return os.path.join(self.folder, f"{scene}.{kind}".replace(" ", "_").replace(",", ""))

    @staticmethod
    def case(name):
        return name if ":" in name else os.path.join(ROOT, "cases", name + ".yaml")

    def call(self, *words, timeout=None):
        words = [str(word) for word in words]
        done = subprocess.run([self.program, *words], capture_output=True, text=True, timeout=timeout)
        if done.returncode != 0:
            raise RuntimeError(f"bench_methods {' '.join(words)}: {done.stderr.strip()}")
        return done.stdout

    def converge(self, file, case, settings, accuracy, window):
        settings = [word for word in settings if word not in SPACE]
        self.call("converge", file, self.case(case), accuracy, *window, *settings)

    def run(self, file, case, program, setting, limit, options, note):
        """One run; its row is kept and returned. note: what identifies it."""
        text = self.call("run", file, self.case(case), program, setting, limit, *options, timeout=60 * limit)
        return self.keep(json.loads(text), program, options, note)

    def search(self, file, case, program, ends, limit, options, note):
        text = self.call("search", file, self.case(case), program, *ends, limit, *options, timeout=40 * limit)
        return self.keep(json.loads(text), program, options, note)

    def keep(self, got, program, options, note):
        covered = got["reached_s"] - got["from_s"]
        row = {"round": 0, "options": " ".join(options), "words": options, "program": program, **note, **got}
        row["cpu_ms_per_s"] = float(f"{1e3 * got['cpu_s'] / covered:.5g}") if covered > 0 else math.inf
        self.rows.append({key: row.get(key, "") for key in COLUMNS})
        return row


def good(row):
    return row["arrived"] and row["rms"] <= GOAL


def best(rows):
    """The cheapest run that keeps to the goal; None if none does."""
    return min(filter(good, rows), key=lambda row: row["cpu_ms_per_s"], default=None)


def enough(rows, spent, cap):
    """Whether a sweep from loose to tight may end: two settings keep to the goal, one to a tenth of it if that can be had
    for half the cap, and the picture has its points; or it has cost too much."""
    if spent > cap:
        return True
    tenth = any(good(row) and row["rms"] <= GOAL / 10 for row in rows)
    return sum(map(good, rows)) >= 2 and spent > (cap / 8 if tenth else cap / 2)


def sweep(bench, scene, spec, method, quick):
    """All runs of one method on one scene, each variant from loose to tight."""
    case, settings = spec[:2]
    found, limit = [], 4 if quick or method.once else 6
    for variant in method.variants[:1] if quick else method.variants:
        rows, spent = [], 0.0
        values = (method.sweep[min(6, len(method.sweep) - 1)],) if quick else method.sweep
        for value in values:
            row = bench.run(bench.path(scene, "ref"), case, method.program, value, limit,
                            (*settings, *variant, *method.extra), {"scene": scene, "kind": "sweep", "method": method.name})
            rows.append(row)
            spent += row["cpu_s"]
            if enough(rows, spent, 5 if len(method.variants) == 1 else 4):
                break
        found += rows
    return found


def explicit(bench, scene, spec, quick):
    """Explicit methods on their short windows; returns {name: row of the longer one}."""
    case, settings, _, accuracy, (start, short, long) = spec
    held = {}
    for kind, span in (("short", short), ("long", long)):
        bench.converge(bench.path(scene, kind), case, settings, accuracy, (start, start + span))
    for name, program, values in EXPLICIT:
        note = {"scene": scene, "kind": "explicit", "method": name}
        if values is None:
            found = bench.search(bench.path(scene, "short"), case, program, (1e-7, 1e-5 if quick else 3e-4), 10, settings,
                                 {**note, "kind": "search"})
            if not found["arrived"]:
                continue
            step = found["setting"] * 0.98
            for _ in range(4):  # what holds for a thousand steps need not hold for many more
                row = bench.run(bench.path(scene, "long"), case, program, step, 40, settings, note)
                if good(row):
                    held[name] = row
                    break
                step *= 0.9
        else:
            rows = [bench.run(bench.path(scene, "short"), case, program, value, 20, settings, note)
                    for value in values[:1 if quick else None]]
            if best(rows):
                held[name] = best(rows)
    return held


def rounds(bench, scene, spec, chosen, number, cap):
    """Every chosen run again, in turn. chosen: {name: (row, file kind)}; what takes longer than cap is not repeated."""
    for round_ in range(1, number + 1):
        for name, (row, kind) in chosen.items():
            if row["cpu_s"] > cap:
                continue
            bench.run(bench.path(scene, kind), spec[0], row["program"], row["setting"], 60, row["words"],
                      {"scene": scene, "kind": "round", "method": name, "round": round_})


def timed(rows, scene, name, row):
    """Median over the rounds of one run's cost, and half the distance of the quartiles in % of it; the sweep's own cost
    (and None) where there are no rounds."""
    values = [r["cpu_ms_per_s"] for r in rows if r["kind"] == "round" and r["scene"] == scene and r["method"] == name]
    if len(values) < 2:
        return row["cpu_ms_per_s"], None
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return middle, 50 * (high - low) / middle


def paired(rows, scene, above, below):
    """Median over the rounds of one method's cost over another's in the same round; None where one of them has none."""
    cost = {(r["method"], r["round"]): r["cpu_ms_per_s"] for r in rows if r["kind"] == "round" and r["scene"] == scene}
    ratios = [cost[above, k] / cost[below, k] for name, k in cost if name == above and (below, k) in cost]
    return statistics.median(ratios) if ratios else None


def setting_text(row):
    """'tol 1e-03, order 5' or 'h 5 ms'."""
    value = row["setting"]
    fixed = row["program"] in ("rk4", "symplectic-euler", "implicit-euler", "trapezoid", "bdf2-fixed", "generalised-alpha")
    text = f"h {1e3 * value:.3g} ms" if fixed else f"tol {value:.0e}"
    order = [word[-1] for word in row["words"] if word.startswith("solver.max_order=")]
    return text + (f", order {order[0]}" if order else "")


DEFAULT = "hawser, default accuracy"


class Scene:
    """What was found on one scene."""

    def __init__(self, name):
        self.name, self.sweeps, self.chosen, self.held = name, {}, {}, {}

    def cost(self, rows, name):
        """ms of processor time a simulated second at <= 1 %, or None."""
        return timed(rows, self.name, name, self.chosen[name][0])[0] if name in self.chosen else None


def measure(bench, name, spec, number, quick):
    """Reference, sweeps, explicit windows and rounds of one scene."""
    scene = Scene(name)
    bench.converge(bench.path(name, "ref"), spec[0], spec[1], spec[3], spec[2])
    for method in METHODS:
        if method.where(name):
            scene.sweeps[method.name] = sweep(bench, name, spec, method, quick)
            print(f"methods.py: {name}: {method.name}", file=sys.stderr)
    default = [row for row in scene.sweeps[HAWSER] if row["setting"] == 1e-3]
    scene.held = explicit(bench, name, spec, quick)
    print(f"methods.py: {name}: explicit", file=sys.stderr)
    scene.chosen = {method: (best(found), "ref") for method, found in scene.sweeps.items() if best(found)}
    if default:
        scene.chosen[DEFAULT] = (default[0], "ref")
    for method, row in scene.held.items():
        scene.chosen[method] = (row, "short")
    rounds(bench, name, spec, scene.chosen, number, 1.5)
    return scene


def times(rows, above, below):
    """How many times more (scene, method) costs than another, within rounds where the scene is the same; None: not known."""
    ratio = paired(rows, above[0].name, above[1], below[1]) if above[0] is below[0] else None
    costs = above[0].cost(rows, above[1]), below[0].cost(rows, below[1])
    return ratio or (costs[0] / costs[1] if all(costs) else None)


def scene_table(rows, scene):
    """Every method at its best setting."""
    own = scene.cost(rows, HAWSER)
    body = []
    names = [DEFAULT] + [method.name for method in METHODS] + [name for name, _, _ in EXPLICIT]
    for name in names:
        found = scene.sweeps.get(name, [])
        if name in scene.chosen:
            row = scene.chosen[name][0]
            cost, half = timed(rows, scene.name, name, row)
            over = times(rows, (scene, name), (scene, HAWSER))
            steps = row["steps"] / (row["reached_s"] - row["from_s"])
            body.append([name, setting_text(row), f"{cost:.4g}", "-" if half is None else f"{half:.0f} %",
                         f"{100 * row['rms']:.2g}", f"{100 * row['worst']:.2g}", f"{steps:.0f}",
                         "-" if over is None else f"{over:.3g}"])
        elif found:
            row = min(found, key=lambda r: (not r["arrived"], r["rms"]))
            note = "not within 1 %" if row["arrived"] else f"ended at {row['reached_s']:.3g} s: {row['why']}"
            body.append([name, f"{setting_text(row)}: {note}", f"{row['cpu_ms_per_s']:.4g}", "-", f"{100 * row['rms']:.2g}",
                         f"{100 * row['worst']:.2g}", "-", f"> {row['cpu_ms_per_s'] / own:.3g}" if own else "-"])
    head = ["method", "best setting", "ms / s", "spread", "error %", "largest %", "steps / s", "times hawser's"]
    return table(head, body)


def goals_table(rows, scenes):
    """The two goals, and whether anything beats hawser at 1 %."""
    body = []

    def line(words, value, least):
        body.append([words, "-" if value is None else f"{value:.3g}", str(least),
                     "-" if value is None else "yes" if value >= least else "no"])

    for name in ("huangjiahu", "huangjiahu in space"):
        scene = scenes.get(name)
        if not scene:
            continue
        names = [row for row, _, _ in EXPLICIT if row in scene.held]
        cheapest = min(names, key=lambda row: scene.cost(rows, row), default=None)
        line(f"{name}: the best explicit method ({cheapest or 'none'}) over hawser's default",
             times(rows, (scene, cheapest), (scene, DEFAULT)), 100)
    pairs = (("huangjiahu", "huangjiahu in space"), ("straight", "straight in space"))
    for name, space in pairs:
        for mine, theirs in ((name, space), (name, name), (space, space)):
            if mine not in scenes or theirs not in scenes:
                continue
            line(f"{theirs}: CVODE with KLU on the unreduced system over hawser"
                 f"{' in the plane' if mine != theirs else ''}, both at 1 %",
                 times(rows, (scenes[theirs], USER_KLU), (scenes[mine], HAWSER)), 5)
    return table(["times slower", "measured", "goal", "reached"], body)


def verdicts(rows, scenes):
    """Per scene: the cheapest of all at 1 %, and at a tenth of that."""
    body = []
    for scene in scenes.values():
        for level in (GOAL, GOAL / 10):
            costs = sorted((row["cpu_ms_per_s"], name) for name, found in scene.sweeps.items() for row in found
                           if row["arrived"] and row["rms"] <= level)
            own = min((cost for cost, name in costs if name == HAWSER), default=None)
            others = [(cost, name) for cost, name in costs if not name.startswith("hawser")]
            if not others:
                continue
            cost, name = others[0]
            if own is None:
                body.append([f"{scene.name}, {100 * level:g} %", "-", name, f"{cost:.3g}", "-", "no: not reached"])
                continue
            body.append([f"{scene.name}, {100 * level:g} %", f"{own:.3g}", name, f"{cost:.3g}", f"{cost / own:.2f}",
                         "yes" if own <= 1.1 * cost else f"no, factor {own / cost:.2f}"])
    return table(["scene, error", "hawser ms / s", "best other method", "ms / s", "ratio", "hawser on the frontier"], body)


def ladder_table(rows, scenes):
    """What reduction, solver, plane and settings are worth, one by one."""
    body = []
    for base in ("huangjiahu", "straight"):
        last = first = None
        for method, where, words in LADDER:
            scene = scenes.get(f"{base} {where}".strip())
            cost = scene.cost(rows, method) if scene else None
            if cost is None:
                continue
            first = first or cost
            row = scene.chosen[method][0]
            body.append([f"{base}: {words}", setting_text(row), f"{cost:.4g}", f"{100 * row['rms']:.2g}",
                         f"{last / cost:.2f}" if last else "-", f"{first / cost:.1f}"])
            last = cost
    return table(["with one thing more a row", "best setting", "ms / s", "error %", "gain", "gain so far"], body)


def agreement_table(scenes):
    """The smallest difference from the reference that each method came to: they solve the same equations."""
    names = [method.name for method in METHODS] + [name for name, _, _ in EXPLICIT]
    body = []
    for name in names:
        cells = []
        for scene in scenes.values():
            found = [row for row in scene.sweeps.get(name, []) if row["arrived"]]
            found += [scene.held[name]] if name in scene.held else []
            cells.append(f"{100 * min(row['rms'] for row in found):.1g}" if found else "-")
        body.append([name, *cells])
    return table(["smallest difference from the reference, %", *scenes], body)


# Methods that must come to the reference in every scene, whatever the machine: hawser itself, one of CVODE's own, one of
# ARKODE's, two of fixed step, and the explicit ones.
MUST = {HAWSER: 5e-3, "CVODE's settings, hawser's matrix": 2 * GOAL, "ARKODE, ESDIRK5(4)7L[2]SA": 5e-3,
        "trapezoid, fixed step": 5e-3, "BDF2, fixed step": GOAL, "generalised alpha, fixed step": GOAL}


def disagreements(scenes, quick):
    """Methods whose closest run is too far from the reference: none, or something is wrong."""
    found = []
    for scene in scenes.values():
        for name, most in MUST.items():
            least = min((row["rms"] for row in scene.sweeps.get(name, []) if row["arrived"]), default=math.inf)
            if least > (0.05 if quick else most):
                found.append(f"{scene.name}: {name} comes no closer to the reference than {100 * least:.2g} %")
        found += [f"{scene.name}: {name} found no step at which it is stable"
                  for name, _, values in EXPLICIT if values is None and name not in scene.held]
    return found


def dense_runs(bench, sizes, limit):
    """How dense, banded and sparse matrices cost with the number of segments (in the plane), ms a step."""
    body, costs = [], {}
    for size in sizes:
        case, name = f"straight:{size}", f"straight:{size}"
        bench.converge(bench.path(name, "ref"), case, (), 1e-4, (0, 0.5))
        for program in ("hawser", "cvode-klu", "cvode-band", "cvode-dense"):
            row = bench.run(bench.path(name, "ref"), case, program, 1e-3, limit, (),
                            {"scene": name, "kind": "dense", "method": program})
            costs.setdefault(program, []).append(1e3 * row["cpu_s"] / row["steps"])
    for program, values in costs.items():
        body.append([program, *(f"{value:.3g}" for value in values), f"{slope(sizes, values):.2f}"])
    return table(["ms a step", *(f"N = {size}" for size in sizes), "exponent"], body)


def picture(path, scene):
    """Cost against error of the methods that compete."""
    names = (HAWSER, "CVODE's settings, hawser's matrix", USER_KLU, "ARKODE, SDIRK 2(1)", "ARKODE, ESDIRK5(4)7L[2]SA",
             "trapezoid, fixed step", "implicit Euler, fixed step", "generalised alpha, fixed step")
    panel = Panel("error in the winch's force, % (RMS)", "ms a simulated second", height=320, log="xy")
    for colour, name in zip(COLOURS, names):
        points = sorted((100 * row["rms"], row["cpu_ms_per_s"]) for row in scene.sweeps.get(name, []) if row["arrived"])
        if points:
            panel.add(name, *zip(*points), colour=colour, marks=True)
    write_svg(path, f"Processor time against error: {scene.name}", [panel])


def picture_name(scene):
    return "methods-" + scene.replace(",", "").replace(" ", "-") + ".svg"


def report(args, load, number, rows, scenes, dense):
    """Tables, pictures, rows."""
    parts = [heading(load, f"processor time of one thread, medians of {number} rounds"), goals_table(rows, scenes),
             verdicts(rows, scenes), ladder_table(rows, scenes)]
    for scene in scenes.values():
        parts += [f"**{scene.name}**", scene_table(rows, scene)]
    parts += [dense, agreement_table(scenes)]
    if args.results:
        os.makedirs(args.results, exist_ok=True)
        for scene in scenes.values():
            picture(os.path.join(args.results, picture_name(scene.name)), scene)
    publish(args, "methods", rows, "\n\n".join(parts), COLUMNS)


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--scenes", help="only these, separated by ';'")
    args = parser.parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    number = 2 if args.quick else args.rounds
    specs = QUICK if args.quick else SCENES
    if args.scenes:
        specs = {name: specs[name] for name in args.scenes.split(";")}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(args.build, folder)
        scenes = {name: measure(bench, name, spec, number, args.quick) for name, spec in specs.items()}
        dense = dense_runs(bench, (8, 16) if args.quick else (12, 23, 46, 92), 4 if args.quick else 20)
    report(args, load, number, bench.rows, scenes, dense)
    bad = disagreements(scenes, args.quick)
    for words in bad:
        print(f"methods.py: {words}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
