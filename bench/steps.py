#!/usr/bin/env python3
"""Times whole runs of hawser, every solver and number of threads in turn, and writes the tables of the documents.

One round runs every configuration once; rounds follow each other, so that a disturbance meets all configurations alike.
The first round warms up and is not counted. Figures are medians over the rounds; ratios are taken within a round first.
"""
import os
import statistics
import subprocess
import sys

from common import arguments, heading, median, pick, publish, ratio, run_case, spread, table

CASES = ("huangjiahu", "straight")
SOLVERS = ("auto", "klu", "klu-full")
THREADS = (1, 2)
PHASES = {"relax": "relaxation", "rhs": "right-hand side", "contacts": "contacts", "jacobian": "Jacobian blocks",
          "factor": "factor", "solve": "solve", "vector": "vectors and control", "output": "output", "other": "other"}
WORK = ("steps", "rhs_evals", "newton_iters", "jac_evals", "lin_setups", "error_test_fails", "newton_fails")
COLUMNS = ["case", "solver", "used", "threads", "round", "process_s", "cpu_s", "wall_time_s", "real_time_factor",
           "steps_per_second", *WORK, "pull_mean_N", *(name + "_s" for name in PHASES)]
# What the program is meant to reach: case, figure of the table, least value, in words.
GOALS = (("huangjiahu", "real_time_factor", 60, "at least 60 times faster than real time"),
         ("straight", "steps_per_second", 8000, "at least 8000 steps a second"))


def run_once(build, case, solver, threads, number, settings):
    """One run: the row of steps.csv."""
    summary = run_case(build, case, settings, ["--linear-solver", solver, "--threads", str(threads)])
    row = {"case": case, "solver": solver, "used": summary["linear_solver"], "threads": threads, "round": number,
           "pull_mean_N": summary["pull_force"]["steady_mean_N"]}
    row.update({key: summary[key] for key in ("process_s", "cpu_s", "wall_time_s", "real_time_factor",
                                              "steps_per_second", *WORK)})
    row.update({name + "_s": summary["phases_s"][name] for name in PHASES})
    return row


def run_rounds(build, repetitions, settings=()):
    """Every configuration in turn, round by round; the first round is thrown away."""
    rows = []
    for number in range(repetitions + 1):
        for case in CASES:
            for solver in SOLVERS:
                for threads in THREADS:
                    rows.append(run_once(build, case, solver, threads, number, settings))
        print(f"steps.py: round {number} of {repetitions}", file=sys.stderr)
    return [row for row in rows if row["round"] > 0]


def runs_table(rows):
    body = []
    for case in CASES:
        for solver in SOLVERS:
            for threads in THREADS:
                mine = pick(rows, case=case, solver=solver, threads=threads)
                used = mine[0]["used"]
                name = solver if used == solver else f"{solver} ({used})"
                body.append([f"{case}, {name}", str(threads), f"{1e3 * median(mine, 'wall_time_s'):.1f}",
                             f"{spread(mine, 'wall_time_s'):.1f} %", f"{1e3 * median(mine, 'process_s'):.1f}",
                             f"{median(mine, 'real_time_factor'):.1f}", f"{median(mine, 'steps'):.0f}",
                             f"{median(mine, 'steps_per_second'):.0f}"])
    return table(["run, solver", "threads", "wall ms", "spread", "process ms", "x real time", "steps", "steps/s"], body)


def ratios_table(rows):
    body = []
    for case in CASES:
        base = {"case": case, "solver": "auto", "threads": 1}
        pairs = [("two threads to one", {**base, "threads": 2}), ("klu to auto", {**base, "solver": "klu"}),
                 ("klu-full to auto", {**base, "solver": "klu-full"})]
        body += [[f"{case}, {name}", f"{ratio(rows, above, base):.3f}",
                  f"{ratio(rows, above, base, 'factor_s'):.3f}", f"{ratio(rows, above, base, 'solve_s'):.3f}"]
                 for name, above in pairs]
    return table(["ratio of times", "wall", "factor", "solve"], body)


def phases_table(rows):
    """Share of the wall time and microseconds a step, for the solver that hawser chooses."""
    picked = [(case, threads, pick(rows, case=case, solver="auto", threads=threads))
              for case in CASES for threads in THREADS]
    head = ["phase"] + [f"{case}, {threads} thr., {unit}" for case, threads, _ in picked for unit in ("%", "us")]
    body = []
    for name, text in PHASES.items():
        cells = [text]
        for _, _, mine in picked:
            share = statistics.median(row[name + "_s"] / row["wall_time_s"] for row in mine)
            step = statistics.median(row[name + "_s"] / row["steps"] for row in mine)
            cells += [f"{100 * share:.1f}", f"{1e6 * step:.2f}"]
        body.append(cells)
    sums = [statistics.median(row["wall_time_s"] / row["steps"] for row in mine) for _, _, mine in picked]
    body.append(["all"] + [cell for value in sums for cell in ("100", f"{1e6 * value:.2f}")])
    return table(head, body)


def goals_table(rows):
    body = []
    for case, key, least, words in GOALS:
        value = median(pick(rows, case=case, solver="auto", threads=2), key)
        body.append([f"{case}: {words}", f"{value:.0f}", "yes" if value >= least else "no"])
    return table(["goal, auto on two threads", "measured", "reached"], body)


def calls_table(samples):
    """samples: [{phase: us}], one a round."""
    body = [[name, f"{statistics.median(sample[name] for sample in samples):.2f}"] for name in samples[0]]
    return table(["phase of bench_phases", "us a call"], body)


def phase_samples(program, repetitions, calls):
    """The name of the target (compiler and instruction set) and the times of single phases."""
    samples = []
    for _ in range(repetitions):
        text = subprocess.run([program, "all", str(calls)], check=True, capture_output=True, text=True).stdout
        first, *lines = text.splitlines()
        samples.append({line.split()[0]: float(line.split()[2]) for line in lines})
    return first.split()[1], samples


def differing(rows):
    """Configurations whose results depend on the number of threads or differ from round to round: none, it is hoped."""
    found = []
    for case in CASES:
        for solver in SOLVERS:
            mine = pick(rows, case=case, solver=solver)
            if len({(row["steps"], row["newton_iters"], row["pull_mean_N"]) for row in mine}) != 1:
                found.append(f"{case} with {solver}")
    return found


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--repetitions", type=int, default=15)
    args = parser.parse_args()
    load = os.getloadavg()[0]
    repetitions = 1 if args.quick else args.repetitions
    settings = ["run.duration=2 s", "run.steady_from=1 s"] if args.quick else []
    target, samples = phase_samples(os.path.join(args.build, "bench/bench_phases"), repetitions, 20 if args.quick else 300)
    rows = run_rounds(args.build, repetitions, settings)
    goals = [] if args.quick else [goals_table(rows)]
    parts = [heading(load, f"target `{target}`, medians of {repetitions} rounds"), *goals, runs_table(rows),
             ratios_table(rows), phases_table(rows), calls_table(samples)]
    publish(args, "steps", rows, "\n\n".join(parts), COLUMNS)
    bad = differing(rows)
    for name in bad:
        print(f"steps.py: results differ between runs of {name}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
