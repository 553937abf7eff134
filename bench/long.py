#!/usr/bin/env python3
"""An hour of simulated pulling: memory, work for a simulated second, and the balances of energy and momentum over time.

Every scene runs once, in pieces of equal length in one process (bench_long_run). The first piece holds the start and is
left out of every comparison; `calm` pieces at the beginning and at the end are compared.
"""
import csv
import os
import statistics
import subprocess
import sys

import common
from common import arguments, heading, load_of_others, publish, table

HOUR = 3600
# Name, case, what differs from it, simulated seconds of the whole part and of the quick one. `paying` never changes its
# state: cable comes off the reel as rope and then cable pass the winch. `row` pulls the same cable along 400 m of rollers.
SCENES = (
    ("paying", "take-in", ("chain.0.length=770 m", "reel.flange=4.5 m", "reel.width=2.2 m", "rollers.along.to=50 m"), HOUR, 60),
    ("row", "straight", ("chain.0.length=30 m", "route.head_at=35 m", "route.pieces.0.straight=400 m", "rollers.along.to=400 m"), HOUR, 30),
    ("tunnel", "tunnel-879", (), HOUR, 0),
)
PIECES, QUICK_PIECES = 60, 6
MEMORY_MOST = 1024      # kB that the resident memory may grow by after the first tenth,
MEMORY_SEGMENT = 12     # and for every segment more that is simulated (about 10 are measured)
GROWTH_MOST = 0.25      # of steps a simulated second, where the pull's state is the same at the beginning and at the end
STEADY = ("paying", "row")  # where it is
RESIDUAL_MOST = 1e-3    # of the energy's turnover, and of the largest impulse
COLUMNS = ["scene", "t_s", "steps", "rhs_evals", "newton_iters", "cpu_s", "memory_kB", "active", "winch_N", "residual_J",
           "turnover_J", "residual_share", "impulse_residual_share"]


def run_scene(build, scene, quick):
    """The rows of one run; raises common.RunFailed."""
    name, case, settings, seconds, quick_seconds = scene
    seconds, pieces = (quick_seconds, QUICK_PIECES) if quick else (seconds, PIECES)
    path = os.path.join(common.ROOT, "cases", case + ".yaml")
    settings = (*settings, f"run.duration={seconds} s", f"run.steady_from={seconds / 2:g} s")
    done = subprocess.run([os.path.join(build, "bench/bench_long_run"), path, str(seconds), str(pieces), *settings],
                          capture_output=True, text=True)
    if done.returncode != 0:
        raise common.RunFailed(done.returncode, f"{name}: {done.stderr.strip()}")
    rows = [{"scene": name, **{key: float(value) for key, value in row.items()}}
            for row in csv.DictReader(done.stdout.splitlines())]
    print(f"long.py: {name}: {seconds} s simulated in {rows[-1]['cpu_s']:.1f} s", file=sys.stderr)
    return rows


def rates(rows, key):
    """What `key` grew by in each piece after the first, for a simulated second."""
    return [(b[key] - a[key]) / (b["t_s"] - a["t_s"]) for a, b in zip(rows, rows[1:])]


def ends(values):
    """Medians of the first and of the last sixth (at least one value)."""
    count = max(1, len(values) // 6)
    return statistics.median(values[:count]), statistics.median(values[-count:])


def growth(rows, key="steps"):
    """Relative growth of the rate of `key` from the beginning to the end."""
    first, last = ends(rates(rows, key))
    return last / first - 1


def memory_growth(rows):
    """kB between the end and the first tenth, by which everything that is allocated as one goes has its size."""
    return rows[-1]["memory_kB"] - rows[len(rows) // 10]["memory_kB"]


def memory_allowed(rows):
    """kB that memory_growth may be."""
    joined = rows[-1]["active"] - rows[len(rows) // 10]["active"]
    return MEMORY_MOST + MEMORY_SEGMENT * max(0, joined)


def judge(rows):
    """The conditions of one scene that do not depend on time: [(words, measured, reached)]."""
    last = rows[-1]
    found = [(f"memory after the first tenth grows by at most {memory_allowed(rows):.0f} kB", f"{memory_growth(rows):.0f} kB",
              memory_growth(rows) <= memory_allowed(rows)),
             (f"energy closes to {100 * RESIDUAL_MOST:g} % of its turnover", f"{100 * last['residual_share']:.2g} %",
              last["residual_share"] <= RESIDUAL_MOST),
             (f"momentum closes to {100 * RESIDUAL_MOST:g} % of the largest impulse",
              f"{100 * last['impulse_residual_share']:.2g} %", last["impulse_residual_share"] <= RESIDUAL_MOST)]
    if last["scene"] in STEADY:
        found.append((f"steps for a simulated second grow by at most {100 * GROWTH_MOST:g} %",
                      f"{100 * growth(rows):+.1f} %", growth(rows) <= GROWTH_MOST))
    return found


def runs_table(by_scene):
    body = []
    for name, rows in by_scene.items():
        last, steps = rows[-1], ends(rates(rows, "steps"))
        micro = ends([1e6 * cpu / step for cpu, step in zip(rates(rows, "cpu_s"), rates(rows, "steps"))])
        work = ends([evals / step for evals, step in zip(rates(rows, "rhs_evals"), rates(rows, "steps"))])
        body.append([name, f"{last['t_s']:.0f}", f"{last['cpu_s']:.1f}", f"{last['steps']:.0f}",
                     *(f"{value:.1f}" for value in steps), *(f"{value:.1f}" for value in micro),
                     *(f"{value:.2f}" for value in work), f"{rows[0]['active']:.0f} -> {last['active']:.0f}",
                     f"{last['memory_kB'] / 1024:.1f}", f"{memory_growth(rows):+.0f}"])
    return table(["scene", "simulated s", "CPU s", "steps", "steps/s first", "last", "us/step first", "last", "rhs/step first",
                  "last", "segments", "memory MB", "growth kB"], body)


def balances_table(by_scene):
    body = []
    for name, rows in by_scene.items():
        for share in (0.1, 0.5, 1):
            row = rows[max(0, round(share * len(rows)) - 1)]
            body.append([f"{name} at {row['t_s']:.0f} s", f"{row['turnover_J'] / 1e3:.4g}", f"{row['residual_J']:.3g}",
                         f"{row['residual_share']:.1e}", f"{row['impulse_residual_share']:.1e}"])
    return table(["scene", "turnover kJ", "residual J", "of turnover", "momentum"], body)


def verdict_table(by_scene):
    body = [[f"{name}: {words}", measured, "yes" if reached else "no"]
            for name, rows in by_scene.items() for words, measured, reached in judge(rows)]
    return table(["goal", "measured", "reached"], body)


def draw(path, by_scene):
    import svgplot
    memory = svgplot.Panel("simulated time, s", "memory, MB")
    steps = svgplot.Panel("simulated time, s", "steps for a simulated second", bottom=0)
    books = svgplot.Panel("simulated time, s", "residual over turnover", log="y")
    for name, rows in by_scene.items():
        t = [row["t_s"] for row in rows]
        memory.add(name, t, [row["memory_kB"] / 1024 for row in rows])
        steps.add(name, t[1:], rates(rows, "steps"))
        books.add(name, t, [max(row["residual_share"], 1e-12) for row in rows])
    svgplot.write_svg(path, "An hour of pulling", [memory, steps, books])


def main():
    args = arguments(__doc__.splitlines()[0]).parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    by_scene = {scene[0]: run_scene(args.build, scene, args.quick) for scene in SCENES if not args.quick or scene[4]}
    rows = [row for of_one in by_scene.values() for row in of_one]
    text = "\n\n".join([heading(load, "one thread, one run a scene"), verdict_table(by_scene), runs_table(by_scene),
                        balances_table(by_scene)])
    publish(args, "long", rows, text, COLUMNS)
    if args.results:
        draw(os.path.join(args.results, "long.svg"), by_scene)
    if args.quick:
        return 0
    missed = [f"{name}: {words}: {measured}" for name, of_one in by_scene.items()
              for words, measured, reached in judge(of_one) if not reached]
    for line in missed:
        print(f"long.py: missed: {line}", file=sys.stderr)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
