#!/usr/bin/env python3
"""Times whole runs of hawser: every solver, one and two threads, in the plane and in space; keeps the history.

One round runs every configuration once; rounds follow each other, so that a disturbance meets all configurations alike.
The first round warms up and is not counted. Figures are medians over the rounds; ratios are taken within a round first.
"""
import math
import os
import statistics
import subprocess
import sys

import counts
import history
from common import arguments, busy, heading, load_of_others, median, pick, publish, ratio, run_case, spread, table

CASES = ("huangjiahu", "straight")
GEOMETRIES = {"plane": "on", "space": "off"}  # solver.planar
THREADS = (1, 2)
SOLVERS = ("auto", "block", "bordered", "klu")
WHOLE = "whole"
QUICK = ["run.duration=1 s", "run.steady_from=500 ms"]
LENGTHS = (370, 600, 1000, 2000, 4000)  # segments of `straight` on which two threads are tried
LENGTH_ROUNDS = 7
COUNTED = ["run.duration=5 s", "run.steady_from=4 s"]  # the part of a run whose instructions are counted
PHASES = {"relax": "relaxation", "rhs": "right-hand side", "contacts": "contacts", "jacobian": "Jacobian blocks",
          "factor": "factor", "solve": "solve", "vector": "vectors and control", "output": "output", "other": "other"}
WORK = ("steps", "rhs_evals", "newton_iters", "jac_evals", "lin_setups", "error_test_fails", "newton_fails",
        "contact_candidates", "contact_active_max")
COLUMNS = ["case", "segments", "geometry", "solver", "used", "threads", "window", "round", "process_s", "cpu_s",
           "wall_time_s", "real_time_factor", "steps_per_second", "step_us", *WORK, "pull_mean_N",
           *(name + "_s" for name in PHASES), "pull_bar_N"]
# What the program is meant to reach: case, figure of the table, least value, in words.
GOALS = (("huangjiahu", "real_time_factor", 60, "at least 60 times faster than real time"),
         ("straight", "steps_per_second", 8000, "at least 8000 steps a second"))
AGREE = 1e-4  # share of the mean pull by which solvers and geometries may differ: a tenth of the accuracy


def configuration(case, geometry, solver, threads, window=WHOLE, segments=370):
    return {"case": case, "segments": segments, "geometry": geometry, "solver": solver, "threads": threads, "window": window}


def everyday():
    """What is fast enough for every round."""
    return [configuration(case, geometry, solver, threads) for case in CASES for geometry in GEOMETRIES
            for solver in SOLVERS for threads in THREADS]


def long_rows(lengths):
    return [configuration("straight", geometry, "auto", threads, "6 s", n) for n in lengths for geometry in GEOMETRIES
            for threads in THREADS]


def length_settings(segments):
    """`straight` with another number of segments of 0.5 m, rollers to the end."""
    length = 0.5 * segments
    return [f"chain.0.length={length} m", f"route.head_at={length + 2.5} m", f"route.pieces.0.straight={length + 9} m",
            f"rollers.along.to={length + 9} m"]


def settings_of(conf, settings):
    """The case's settings for a configuration; the given ones shorten whole runs."""
    words = ["solver.planar=" + GEOMETRIES[conf["geometry"]]]
    if conf["window"] == WHOLE:
        words += settings
    else:
        value, unit = conf["window"].split()
        words += [f"run.duration={conf['window']}", f"run.steady_from={0.5 * float(value):g} {unit}"]
    return words + (length_settings(conf["segments"]) if conf["segments"] != 370 else [])


def run_once(build, conf, number, settings):
    """One run: the row of steps.csv."""
    summary = run_case(build, conf["case"], settings_of(conf, settings),
                       ["--linear-solver", conf["solver"], "--threads", str(conf["threads"])], timeout=300)
    row = {**conf, "used": summary["linear_solver"], "round": number,
           "pull_mean_N": summary["pull_force"]["steady_mean_N"],
           "pull_bar_N": summary["pull_force"]["steady_mean_error"]["total_N"], "step_us": 1e6 / summary["steps_per_second"]}
    row.update({key: summary[key] for key in ("process_s", "cpu_s", "wall_time_s", "real_time_factor",
                                              "steps_per_second", *WORK)})
    row.update({name + "_s": summary["phases_s"][name] for name in PHASES})
    return row


def run_rounds(build, what, configurations, rounds, settings=(), warm=True):
    """Every configuration in turn, round by round; if `warm`, a first round is thrown away."""
    rows = []
    for number in range(0 if warm else 1, rounds + 1):
        rows += [run_once(build, conf, number, list(settings)) for conf in configurations]
        print(f"steps.py: {what}, round {number} of {rounds}", file=sys.stderr)
    return [row for row in rows if row["round"] > 0]


# ------------------------------------------------------------------------------------------------------ tables

def goals_table(rows, load):
    """Times of a busy machine are shown, not judged."""
    body = []
    for case, key, least, words in GOALS:
        for geometry in GEOMETRIES:
            value = median(pick(rows, case=case, solver="auto", geometry=geometry, threads=2), key)
            body.append([f"{case}, {geometry}{' (default)' if geometry == 'plane' else ''}: {words}", f"{value:.0f}",
                         "not judged: busy" if busy(load) else "yes" if value >= least else "no"])
    return table(["goal, auto on two threads", "measured", "reached"], body)


def scenes_table(rows):
    body = []
    for case in CASES:
        for geometry in GEOMETRIES:
            row = pick(rows, case=case, geometry=geometry, solver="auto", threads=1)[0]
            body.append([f"{case}, {geometry}"] + [str(row[key]) for key in ("segments", "contact_candidates",
                                                                            "contact_active_max", "steps", "rhs_evals",
                                                                            "jac_evals", "lin_setups")])
    return table(["scene", "segments", "candidates", "contacts at most", "steps", "right-hand sides", "Jacobians",
                  "set-ups"], body)


def whole_table(rows):
    """The run as its user meets it, with the solver that hawser chooses."""
    body = []
    for case in CASES:
        for geometry in GEOMETRIES:
            for threads in THREADS:
                mine = pick(rows, case=case, geometry=geometry, solver="auto", threads=threads)
                body.append([f"{case}, {geometry}", str(threads), f"{1e3 * median(mine, 'wall_time_s'):.1f}",
                             f"{spread(mine, 'wall_time_s'):.1f} %", f"{1e3 * median(mine, 'process_s'):.1f}",
                             f"{median(mine, 'real_time_factor'):.0f}", f"{median(mine, 'steps_per_second'):.0f}"])
    return table(["scene", "threads", "wall ms", "spread", "process ms", "x real time", "steps/s"], body)


def solver_cells(mine, base):
    """Time of a step on one thread and on two, spreads, steps, and over that of `auto` in the same round and window."""
    cells = []
    for threads in THREADS:
        own = pick(mine, threads=threads)
        cells += [f"{median(own, 'step_us'):.1f}", f"{spread(own, 'step_us'):.1f} %"] if own else ["-", "-"]
    first = pick(mine, threads=1)
    same = [row for row in base if row["window"] == first[0]["window"] and row["round"] in {r["round"] for r in first}]
    return cells + [str(first[0]["steps"]), f"{ratio(first + same, {'solver': first[0]['solver']}, {'solver': 'auto'}, 'step_us'):.2f}"]


def solvers_table(rows, case):
    """Every linear solver: integration time a step."""
    body = []
    for geometry in GEOMETRIES:
        here = pick(rows, case=case, geometry=geometry)
        for solver in SOLVERS:
            mine = pick(here, solver=solver, window=WHOLE)
            name = solver if solver != "auto" else f"auto ({mine[0]['used']})"
            body.append([f"{geometry}, {name}"] + solver_cells(mine, pick(here, solver="auto", threads=1, window=WHOLE)))
    return table([case, "1 thread, us a step", "spread", "2 threads, us a step", "spread", "steps", "time / auto's"], body)


def phases_table(rows):
    """Microseconds a step by phase, for the solver that hawser chooses."""
    picked = [(case, geometry, threads, pick(rows, case=case, geometry=geometry, solver="auto", threads=threads))
              for case in CASES for geometry in GEOMETRIES for threads in THREADS]
    head = ["phase, us a step"] + [f"{case}, {geometry}, {threads} thr." for case, geometry, threads, _ in picked]
    body = []
    for name, text in PHASES.items():
        body.append([text] + [f"{1e6 * statistics.median(row[name + '_s'] / row['steps'] for row in mine):.2f}"
                              for *_, mine in picked])
    body.append(["all"] + [f"{1e6 * statistics.median(row['wall_time_s'] / row['steps'] for row in mine):.2f}"
                           for *_, mine in picked])
    return table(head, body)


def lengths_table(rows):
    """One thread and two over the number of segments."""
    body = []
    for n in sorted({row["segments"] for row in rows}):
        cells = [str(n)]
        for geometry in GEOMETRIES:
            here = pick(rows, segments=n, geometry=geometry)
            cells += [f"{median(pick(here, threads=threads), 'step_us'):.1f}" for threads in THREADS]
            cells.append(f"{ratio(here, {'threads': 2}, {'threads': 1}, 'step_us'):.3f}")
        body.append(cells)
    return table(["N"] + [f"{geometry}, {what}" for geometry in GEOMETRIES
                          for what in ("1 thread, us a step", "2 threads", "ratio")], body)


def calls_table(samples):
    """samples: [{phase: us}], one a round. Phases in the plane stand beside those in space."""
    def cell(name):
        return f"{statistics.median(sample[name] for sample in samples):.2f}" if name in samples[0] else "-"
    names = [name for name in samples[0] if not name.startswith("plane-")]
    names += [name[6:] for name in samples[0] if name.startswith("plane-") and name[6:] not in names]
    return table(["phase of bench_phases", "plane, us a call", "space, us a call"],
                 [[name, cell("plane-" + name), cell(name)] for name in names])


def counts_table(counted):
    """counted: {scene: {phase: instructions a step}}."""
    words = {**PHASES, "rhs": "right-hand side, with its contacts", "contacts": "contacts (of all the above)", "all": "all"}
    body = [[words[phase]] + [f"{scene[phase]:.0f}" if phase in scene else "-" for scene in counted.values()]
            for phase in counts.PHASES]
    return table(["instructions a step", *counted], body)


# -------------------------------------------------------------------------------------------- measuring besides runs

def phase_samples(program, repetitions, calls):
    """The name of the target (compiler and instruction set) and the times of single phases."""
    samples = []
    for _ in range(repetitions):
        text = subprocess.run([program, "all", str(calls)], check=True, capture_output=True, text=True).stdout
        first, *lines = text.splitlines()
        samples.append({line.split()[0]: float(line.split()[2]) for line in lines})
    return first.split()[1], samples


def count_scenes(build, settings, scenes):
    """{scene: {phase: instructions a step}} of the tracked scenes; empty without a valgrind that runs the program."""
    counted = {}
    for scene in scenes:
        case, planar = history.TRACKED[scene]
        wanted = [*settings, "solver.planar=" + planar]
        totals = counts.count_case(os.path.join(build, "cli/hawser"), case, wanted)
        if totals is None:
            continue
        steps = run_case(build, case, wanted, ["--threads", "1"])["steps"]
        counted[scene] = {phase: value / steps for phase, value in totals.items()}
        print(f"steps.py: instructions of {scene}", file=sys.stderr)
    return counted


def tracked_figures(rows, counted, load):
    """{scene: {figure: number}} of the history's row; a busy machine gives counts, but no times."""
    figures = {}
    for scene, (case, planar) in history.TRACKED.items():
        geometry = next(name for name, value in GEOMETRIES.items() if value == planar)
        one, two = (pick(rows, case=case, geometry=geometry, solver="auto", threads=threads) for threads in THREADS)
        times = {"steps_per_s": round(median(one, "steps_per_second")),
                 "steps_per_s_2": round(median(two, "steps_per_second")),
                 "us_per_step": round(1e6 * statistics.median(r["wall_time_s"] / r["steps"] for r in one), 3),
                 "spread_percent": round(spread(one, "step_us"), 2)}
        figures[scene] = {"steps": one[0]["steps"], **(dict.fromkeys(times, "") if busy(load) else times)}
        figures[scene].update({f"instructions_{phase}": round(value) for phase, value in counted.get(scene, {}).items()})
    return figures


def differing(rows):
    """Configurations whose results depend on the number of threads or differ from round to round: none, it is hoped."""
    same = {}
    for row in rows:
        key = tuple(row[name] for name in ("case", "segments", "geometry", "solver", "window"))
        same.setdefault(key, set()).add((row["steps"], row["newton_iters"], row["pull_mean_N"]))
    return [f"{case} ({segments}, {geometry}) with {solver}" for (case, segments, geometry, solver, _), results
            in same.items() if len(results) != 1]


def astray(rows, quick):
    """Whole runs whose mean pull is not that of `auto` in space. Quick ones end while the start still swings, in which rounding
    counts: they agree within what each may be off by."""
    whole, found = pick(rows, window=WHOLE), []
    for case in CASES:
        right = pick(whole, case=case, geometry="space", solver="auto")[0]["pull_mean_N"]
        for row in pick(whole, case=case, threads=1):
            if not abs(row["pull_mean_N"] - right) <= max(AGREE * abs(right), (row["pull_bar_N"] or math.inf) if quick else 0):
                found.append(f"{case} ({row['geometry']}) with {row['solver']}: {row['pull_mean_N']} N, not {right} N")
    return list(dict.fromkeys(found))


def measure(args):
    """All runs: rows, samples and target of bench_phases, counts."""
    quick = args.quick
    rounds, settings = (1, QUICK) if quick else (args.rounds, [])
    target, samples = phase_samples(os.path.join(args.build, "bench/bench_phases"), rounds, 20 if quick else 300)
    rows = run_rounds(args.build, "solvers", everyday(), rounds, settings, warm=not quick)
    rows += run_rounds(args.build, "lengths", long_rows(LENGTHS[:1] if quick else LENGTHS),
                       1 if quick else min(LENGTH_ROUNDS, rounds), warm=not quick)
    counted = count_scenes(args.build, ["run.duration=100 ms", "run.steady_from=50 ms"] if quick else COUNTED,
                           ["straight"] if quick else history.TRACKED)
    return target, samples, rows, counted


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=11)
    parser.add_argument("--load", type=float, help="cores that others use (default: look for three seconds)")
    args = parser.parse_args()
    load = load_of_others() if args.load is None else args.load
    target, samples, rows, counted = measure(args)
    whole = [row for row in rows if row["segments"] == 370 and row["window"] == WHOLE]
    runs = [row for row in rows if row["window"] != "6 s"]
    goals = [] if args.quick else ["**Goals**", goals_table(whole, load)]
    rounds = max(row["round"] for row in rows)
    parts = [heading(load, f"target `{target}`, medians of {rounds} rounds"), *goals, "**Scenes**", scenes_table(whole),
             "**Whole runs**", whole_table(whole), "**Every solver**", *(solvers_table(runs, case) for case in CASES),
             "**Phases of whole runs, `auto`**", phases_table(whole), "**One thread and two**",
             lengths_table(pick(rows, window="6 s")), "**Single calls, one thread**", calls_table(samples)]
    if counted:
        parts += ["**Instructions, one thread**", counts_table(counted)]
    if args.results:
        os.makedirs(args.results, exist_ok=True)
        row = history.history_row(target, rounds, load, tracked_figures(whole, counted, load))
        past = history.record(os.path.join(args.results, "history.csv"), row)
        history.draw(os.path.join(args.results, "steps-history.svg"), past)
        parts += ["**History, one thread**", history.table_of(past)]
    publish(args, "steps", rows, "\n\n".join(parts), COLUMNS)
    bad = [f"results differ between runs of {name}" for name in differing(rows)] + astray(rows, args.quick)
    for text in bad:
        print("steps.py: " + text, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
