#!/usr/bin/env python3
"""Times the linear solvers alone on a cable's Newton matrix and writes the tables of the document.

One call of bench_linsolve is a round: every configuration has its turn and gives the median of its repetitions. Figures are
medians over the rounds, spreads are of the rounds, ratios are taken within a round first.
"""
import csv
import io
import os
import statistics
import subprocess
import sys

from common import arguments, heading, load_of_others, median, pick, publish, ratio, spread, table

NUMBERS = {"b": int, "n": int, "threads": int, "factor_us": float, "solve_us": float, "peak_gf": float}
COLUMNS = ["round", "group", "solver", "b", "n", "threads", "isa", "factor_us", "solve_us", "peak_gf"]
REPETITIONS = 150  # of the short configurations, in a round
FLOP_ROW = 1296  # of the factorisation, a block row of 6: the inverse of S, V and B V, three products' worth
# In words; phase; what is compared; with what; the ratio that it should not exceed.
GOALS = (("block, 6 x 6, to KLU's refactorisation", "factor", {"solver": "block", "b": 6}, {"solver": "klu_refactor", "b": 6}, 0.2),
         ("block, 6 x 6, to KLU's solve", "solve", {"solver": "block", "b": 6}, {"solver": "klu_refactor", "b": 6}, 0.5),
         ("block, 3 x 3, to KLU's refactorisation", "factor", {"solver": "block", "b": 3}, {"solver": "klu_refactor", "b": 3},
          0.2),
         ("block, 3 x 3, to KLU's solve", "solve", {"solver": "block", "b": 3}, {"solver": "klu_refactor", "b": 3}, 0.5),
         ("KLU on 6 N unknowns to KLU on 13 N, refactorisation", "factor", {"solver": "klu_refactor", "b": 6},
          {"solver": "klu-full amd"}, 0.15))


def read_round(text, number):
    """The rows of one call of bench_linsolve."""
    rows = list(csv.DictReader(io.StringIO(text)))
    return [{"round": number, **row, **{key: kind(row[key]) for key, kind in NUMBERS.items()}} for row in rows]


def run_rounds(program, rounds, repetitions):
    """All rounds; the first, which warms up, is not counted."""
    rows = []
    for number in range(rounds + 1):
        done = subprocess.run([program, str(repetitions)], check=True, capture_output=True, text=True, timeout=600)
        rows += read_round(done.stdout, number)
        print(f"linsolve.py: round {number} of {rounds}", file=sys.stderr)
    return [row for row in rows if row["round"] > 0]


def times(mine):
    """Cells: both medians with their spreads, and both a segment."""
    cells = []
    for key in ("factor_us", "solve_us"):
        cells += [f"{median(mine, key):.2f}", f"{spread(mine, key):.1f} %"]
    return cells + [f"{1e3 * median(mine, key) / mine[0]['n']:.1f}" for key in ("factor_us", "solve_us")]


TIMES = ["factor us", "spread", "solve us", "spread", "factor ns/N", "solve ns/N"]


def goals_table(rows):
    body = []
    for words, phase, above, below, most in GOALS:
        value = ratio(rows, {"group": "kinds", **above}, {"group": "kinds", **below}, phase + "_us")
        body.append([words, f"{most:g}", f"{value:.3f}", "yes" if value <= most else "no"])
    return table(["ratio of times at N = 370", "goal: at most", "measured", "reached"], body)


def kinds_table(rows):
    """Every back end against klu_refactor with blocks of the same size (13 N: against that of 6)."""
    kinds = pick(rows, group="kinds")
    body = []
    for b in (6, 13, 3):
        for solver in dict.fromkeys(row["solver"] for row in pick(kinds, b=b)):
            mine, base = pick(kinds, b=b, solver=solver), {"solver": "klu_refactor", "b": 6 if b == 13 else b}
            over = [f"{ratio(kinds, {'solver': solver, 'b': b}, base, key):.3f}" for key in ("factor_us", "solve_us")]
            body.append([solver, str(b), *times(mine), *over])
    return table(["solver", "b", *TIMES, "factor / klu_refactor", "solve / klu_refactor"], body)


def lengths_table(rows):
    """`block` on one thread; what a segment costs against N = 370."""
    one = pick(rows, group="lengths", threads=1)
    body = []
    for b in (6, 3):
        for n in sorted({row["n"] for row in one if row["n"] >= 370}):
            over = [ratio(one, {"b": b, "n": n}, {"b": b, "n": 370}, key) * 370 / n for key in ("factor_us", "solve_us")]
            body.append([str(n), str(b), *times(pick(one, b=b, n=n)), *(f"{value:.3f}" for value in over)])
    return table(["N", "b", *TIMES, "factor a segment / that at 370", "solve a segment / that at 370"], body)


def threads_table(rows):
    """Two threads to one, both block sizes."""
    both = pick(rows, group="lengths")
    body = []
    for n in sorted({row["n"] for row in both}):
        body.append([str(n)] + [f"{ratio(both, {'b': b, 'n': n, 'threads': 2}, {'b': b, 'n': n, 'threads': 1}, key):.3f}"
                                for b in (6, 3) for key in ("factor_us", "solve_us")])
    return table(["N", "6 x 6, factor", "6 x 6, solve", "3 x 3, factor", "3 x 3, solve"], body)


def rates_table(rows):
    mine = pick(rows, group="rates")
    body = []
    for isa in dict.fromkeys(row["isa"] for row in mine):
        own = pick(mine, isa=isa)
        rates = [row["n"] * FLOP_ROW / row["factor_us"] / 1e3 for row in own]
        share = statistics.median(rate / row["peak_gf"] for rate, row in zip(rates, own))
        body.append([isa, f"{median(own, 'factor_us'):.2f}", f"{median(own, 'solve_us'):.2f}",
                     f"{statistics.median(rates):.1f}", f"{median(own, 'peak_gf'):.1f}", f"{share:.2f}"])
    return table(["instruction set", "factor us", "solve us", "factor GF/s", "products GF/s", "share"], body)


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=15)
    args = parser.parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    rounds, repetitions = (1, 3) if args.quick else (args.rounds, REPETITIONS)
    rows = run_rounds(os.path.join(args.build, "bench/bench_linsolve"), rounds, repetitions)
    note = f"{rounds} rounds of up to {repetitions} repetitions"
    parts = [heading(load, note), "**Goals**", goals_table(rows), "**Back ends, N = 370, one thread**", kinds_table(rows),
             "**Length: `block`, one thread**", lengths_table(rows),
             "**Two threads: `block`, time on two over time on one**", threads_table(rows),
             "**Rate: `block`, N = 370, 6 x 6, one thread**", rates_table(rows)]
    publish(args, "linsolve", rows, "\n\n".join(parts), COLUMNS)
    return 0


if __name__ == "__main__":
    sys.exit(main())
