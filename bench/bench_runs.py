#!/usr/bin/env python3
"""Times whole runs of hawser, every solver and number of threads in turn, and writes the tables of the documents.

Usage: python3 bench/bench_runs.py --build DIR [--repetitions N] [--results DIR] [--document FILE] [--quick]
       python3 bench/bench_runs.py --machine

One round runs every configuration once; rounds follow each other, so that a disturbance meets all configurations alike.
The first round warms up and is not counted. Figures are medians over the rounds; ratios are taken within a round first.
Writes DIR/runs.csv (one row a run) and puts the tables between the markers of FILE, or prints them when there is none.
  --build DIR      a build of the program and bench_phases (scripts/bench.sh makes build/bench)
  --quick          a case of 2 s and one counted round: does everything work?
  --machine        prints the name under which this machine's results are kept
"""
import argparse
import csv
import json
import os
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
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
BEGIN, END = "<!-- runs: begin -->", "<!-- runs: end -->"


def processor():
    """The processor's name as lscpu gives it."""
    text = subprocess.run(["lscpu"], capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    found = re.search(r"^Model name:\s*(.*)$", text, re.M)
    return found.group(1).strip() if found else "unknown"


def machine_name(model, cores):
    """'AMD EPYC' and 2 -> 'epyc-2core': a name for a folder, without what every processor is called."""
    text = re.sub(r"\(.*?\)|@.*|\b(amd|intel|cpu|processor|\d+-core)\b", " ", model.lower())
    words = re.findall(r"[a-z0-9]+", text)
    return "-".join(words or ["unknown"]) + f"-{cores}core"


def run_once(program, case, solver, threads, number, settings):
    """One run in a process of its own: the row of runs.csv."""
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", os.path.join(ROOT, "cases", case + ".yaml"), "-q", "-o", folder,
                   "--linear-solver", solver, "--threads", str(threads), *settings]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.perf_counter()
        subprocess.run(command, check=True)
        process = time.perf_counter() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    row = {"case": case, "solver": solver, "used": summary["linear_solver"], "threads": threads, "round": number,
           "process_s": round(process, 6), "cpu_s": round(cpu, 6), "pull_mean_N": summary["pull_force"]["steady_mean_N"]}
    row.update({key: summary[key] for key in ("wall_time_s", "real_time_factor", "steps_per_second", *WORK)})
    row.update({name + "_s": summary["phases_s"][name] for name in PHASES})
    return row


def run_rounds(program, repetitions, settings=()):
    """Every configuration in turn, round by round; the first round is thrown away."""
    rows = []
    for number in range(repetitions + 1):
        for case in CASES:
            for solver in SOLVERS:
                for threads in THREADS:
                    rows.append(run_once(program, case, solver, threads, number, settings))
        print(f"bench_runs.py: round {number} of {repetitions}", file=sys.stderr)
    return [row for row in rows if row["round"] > 0]


def pick(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def median(rows, key):
    return statistics.median(row[key] for row in rows)


def spread(rows, key):
    """Half the distance of the quartiles in % of the median."""
    values = [row[key] for row in rows]
    if len(values) < 2:
        return 0.0
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return 50 * (high - low) / middle


def ratio(rows, above, below, key="wall_time_s"):
    """Median over the rounds of one configuration's figure over another's in the same round."""
    over = {row["round"]: row[key] for row in pick(rows, **above)}
    return statistics.median(over[row["round"]] / row[key] for row in pick(rows, **below))


def table(head, body):
    """Markdown; the first column is text, the others are numbers."""
    lines = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(cells) + " |" for cells in body])


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


def commit():
    """The tree's commit, with a + when it has changes."""
    def git(*words):
        return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True).stdout.strip()
    return (git("rev-parse", "--short", "HEAD") or "unknown") + ("+" if git("status", "--porcelain", "-uno") else "")


def heading(target, repetitions, load):
    cores = os.cpu_count()
    text = (f"Machine `{machine_name(processor(), cores)}` ({processor()}, {cores} cores, Linux "
            f"{os.uname().release.split('-')[0]}), target `{target}`, commit {commit()}, {time.strftime('%Y-%m-%d')}, "
            f"medians of {repetitions} rounds; load average at the start {load:.2f}.")
    if load > 0.3 * cores:
        text += " **The machine was busy: read ratios, not times.**"
    return text


def replace_between(text, new):
    """The text with what stands between the markers replaced."""
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        raise ValueError(f"needs the lines {BEGIN} and {END}, once each")
    return text[:text.index(BEGIN) + len(BEGIN)] + "\n\n" + new + "\n\n" + text[text.index(END):]


def write_rows(path, rows):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build")
    parser.add_argument("--repetitions", type=int, default=15)
    parser.add_argument("--results")
    parser.add_argument("--document")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--machine", action="store_true")
    args = parser.parse_args()
    if args.machine:
        print(machine_name(processor(), os.cpu_count()))
        return 0
    if not args.build or args.repetitions < 1:
        parser.error("--build is needed, and one repetition at least")
    load = os.getloadavg()[0]
    repetitions = 1 if args.quick else args.repetitions
    settings = ["--set", "run.duration=2 s", "--set", "run.steady_from=1 s"] if args.quick else []
    target, samples = phase_samples(os.path.join(args.build, "bench/bench_phases"), repetitions, 20 if args.quick else 300)
    rows = run_rounds(os.path.join(args.build, "cli/hawser"), repetitions, settings)
    goals = [] if args.quick else [goals_table(rows)]
    parts = [heading(target, repetitions, load), *goals, runs_table(rows), ratios_table(rows), phases_table(rows),
             calls_table(samples)]
    text = "\n\n".join(parts)
    if args.results:
        write_rows(os.path.join(args.results, "runs.csv"), rows)
    if args.document:
        with open(args.document, encoding="utf-8") as file:
            new = replace_between(file.read(), text)
        with open(args.document, "w", encoding="utf-8") as file:
            file.write(new)
    print(text)
    bad = differing(rows)
    for name in bad:
        print(f"bench_runs.py: results differ between runs of {name}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
