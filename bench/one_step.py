#!/usr/bin/env python3
"""Would the one-step method be a better default than backward differences? Both on the cases that come with the program.

Steps of the one-step method may pass over rows. Errors are those of mean and peak pull against backward differences at an
accuracy of 1e-5 on the same mesh. An evaluation is one of the rates of all segments; a matrix is one set of derivatives.
"""
import os
import sys

from common import ROOT, RunFailed, arguments, heading, load_of_others, publish, run_case, table

CASES = ("huangjiahu straight duct-bends three-in-a-duct tray bell-mouth capstan crossing drum-contact guide-rollers limits jam reel take-in "
         "conveyors winch-tension winch-trip rollers-spinning rollers-mounted rollers-v-groove spiral-drift placing/by-rule placing/drawn "
         "routes/tunnel-csv towed-in-water").split()
ALONE = ["solver.passes=1", "output.states=0s"]
METHODS = {"default": [], "1e-3": ["solver.method=esdirk", "solver.accuracy=1e-3", "solver.max_step=500ms"],
           "1e-2": ["solver.method=esdirk", "solver.accuracy=1e-2", "solver.max_step=500ms"]}
COLUMNS = ["case", "method", "steps", "rhs_evals", "jac_evals", "cpu_s", "mean_pct", "peak_pct"]


def off(value, reference):
    return 100 * (value / reference - 1) if reference else 0.0


def measure(build, case):
    """One row a method."""
    path = os.path.join(ROOT, "cases", case + ".yaml")
    reference = run_case(build, path, [*ALONE, "solver.accuracy=1e-5"])["pull_force"]
    for method, settings in METHODS.items():
        run = run_case(build, path, [*ALONE, *settings], timeout=120)
        pull = run["pull_force"]
        yield {"case": case, "method": method, **{key: run[key] for key in COLUMNS[2:6]},
               "mean_pct": off(pull["steady_mean_N"], reference["steady_mean_N"]), "peak_pct": off(pull["peak_N"], reference["peak_N"])}


def cell(row):
    return (f"{row['steps']} / {row['rhs_evals']} / {row['jac_evals']}", f"{row['cpu_s']:.2f}",
            f"{row['mean_pct']:+.3f} / {row['peak_pct']:+.2f}")


def main():
    args = arguments(__doc__).parse_args()
    load, rows = load_of_others(), []
    for case in CASES[:2] if args.quick else CASES:
        rows += measure(args.build, case)
    head = ["case"] + [text.format(name) for name in ("default", "one-step 1e-3", "one-step 1e-2")
                       for text in ("{}: steps / evaluations / matrices", "s", "mean / peak off, %")]
    body = [[case] + [text for row in rows if row["case"] == case for text in cell(row)] for case in dict.fromkeys(row["case"] for row in rows)]
    publish(args, "one_step", rows, heading(load) + "\n\n" + table(head, body), COLUMNS)


if __name__ == "__main__":
    try:
        main()
    except RunFailed as failed:
        sys.exit(f"one_step: {failed.message}")
