#!/usr/bin/env python3
"""Drives hawser through conditions far from the usual and through random cases, and says what became of each.

Every run is a process of its own with a time limit and a limit of steps, so that a crash or a hang is seen as one. A run
ends in one of four ways: `ok`, finished, with finite results that meet the row's condition; `reported`, status 2 or 3 with a
message that says what is wrong; `missed`, finished but not so; `failed`, anything else: a crash, a hang, a silence, results
that are no numbers. Rows are in stress_rows.py, random cases in stress_random.py.
"""
import concurrent.futures
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import time

import stress_random
import stress_rows
from common import arguments, heading, load_of_others, publish, read_series, table
from heatmap import write_heatmap

STEPS_MOST, SECONDS_MOST = 60000, 300  # of a run; the machine may be slow, no run takes a tenth of it on an idle one
RANDOM_COUNT = 600
EXPLOSION = 10  # steps per simulated second over the neighbour's, or under it
COLUMNS = ["row", "value", "outcome", "status", "steps", "sim_time_s", "steps_per_sim_s", "newton_fails", "error_test_fails",
           "relaxed", "wall_s", "found", "message"]
# What a message of status 2 or 3 must have: where, and what to do or what is allowed.
SAYS_WHERE = re.compile(r"key '|t = |near \d|roller '|solver\.linear_solver|the linear solver")
SAYS_WHAT = re.compile(r"try |give |put |lead |must be|ends at|raise|expected|allowed|missing|needs|need|may help|takes? |can$|can\b|not |\?")


def not_finite(value, path=""):
    """Places in a summary (dicts, lists, numbers) where a number is none."""
    if isinstance(value, dict):
        return [bad for key, item in value.items() for bad in not_finite(item, f"{path}.{key}")]
    if isinstance(value, list):
        return [bad for item in value for bad in not_finite(item, path + "[]")]
    return [path] if isinstance(value, float) and not math.isfinite(value) else []


def series_not_finite(series):
    """Columns of series.csv with values that are no finite numbers."""
    return [name for name, column in series.items() if any(v is not None and not math.isfinite(v) for v in column)]


def launch(build, case, seconds=SECONDS_MOST):
    """One run of a case (a dict). A dict with status (a number, negative: a signal, None: hung), message, wall_s, and what
    the run wrote: summary and series, None where it did not."""
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "case.yaml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(case, file, indent=1)
        start = time.perf_counter()
        try:
            done = subprocess.run([os.path.join(build, "cli/hawser"), "run", path, "-q", "-o", out], capture_output=True,
                                  text=True, timeout=seconds)
            status, message = done.returncode, done.stderr.strip().replace(path, "case.yaml")
        except subprocess.TimeoutExpired:
            status, message = None, f"no end within {seconds} s"
        run = {"status": status, "message": message, "wall_s": round(time.perf_counter() - start, 3), "summary": None,
               "series": None}
        try:
            with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
                run["summary"] = json.load(file)
            run["series"] = read_series(os.path.join(out, "series.csv"))
        except (OSError, ValueError):
            pass  # what is missing is None, and judged
    return run


def told(run):
    """Whether a run that did not finish says so as it should: status 2 or 3, one line with where and what."""
    lines = run["message"].splitlines()
    clear = len(lines) == 1 and SAYS_WHERE.search(lines[0]) and SAYS_WHAT.search(lines[0])
    if run["status"] == 2:
        return bool(clear)
    summary = run["summary"] or {}
    return bool(run["status"] == 3 and clear and summary.get("outcome") == "failed" and summary.get("message"))


def outcome(run, judge=None):
    """('ok', 'reported', 'missed' or 'failed', what was found)."""
    if run["status"] != 0:
        return ("reported", "") if told(run) else ("failed", f"status {run['status']}")
    if run["summary"] is None or run["series"] is None:
        return "failed", "no results"
    bad = not_finite(run["summary"]) + series_not_finite(run["series"])
    if bad:
        return "failed", "not finite: " + ", ".join(bad)
    if judge is None:
        return "ok", ""
    holds, found = judge(stress_rows.Run(run["summary"], run["series"]))
    return ("ok" if holds else "missed"), found


def row_of(name, value, run, judge=None):
    """A run as a row of stress.csv."""
    ended, found = outcome(run, judge)
    summary = run["summary"] or {}
    steps, simulated = summary.get("steps") or 0, summary.get("sim_time_s") or 0.0
    return {"row": name, "value": value, "outcome": ended, "status": run["status"], "steps": steps, "sim_time_s": simulated,
            "steps_per_sim_s": float(f"{steps / simulated:.4g}") if simulated else 0.0,
            "newton_fails": summary.get("newton_fails"), "error_test_fails": summary.get("error_test_fails"),
            "relaxed": summary.get("relaxation", {}).get("reached"), "wall_s": run["wall_s"], "found": found,
            "message": run["message"]}


def run_value(build, row, value):
    """One value of a condition."""
    case = row.case(value)
    case.setdefault("solver", {}).setdefault("max_steps", STEPS_MOST)
    return row_of(row.name, value, launch(build, case), lambda run: row.judge(value, run))


def run_random(build, number, steps):
    """One random case."""
    case = stress_random.draw(number)
    case["solver"]["max_steps"] = steps
    return row_of("random " + case["title"].split(": ")[1], number, launch(build, case))


def run_all(build, jobs):
    """The results of the jobs in their order, two at a time; progress goes to stderr."""
    rows = []
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for row in pool.map(lambda job: job[0](build, *job[1:]), jobs):
            rows.append(row)
            if len(rows) % 100 == 0 or row["outcome"] == "failed":
                print(f"stress.py: {len(rows)} of {len(jobs)}: {row['row']} {row['value']} {row['outcome']}", file=sys.stderr)
    return rows


def explosions(rows):
    """Neighbours in a condition, both finished, of which one takes EXPLOSION times the other's steps a simulated second."""
    found = []
    for before, after in zip(rows, rows[1:]):
        low, high = sorted((before["steps_per_sim_s"], after["steps_per_sim_s"]))
        both = before["row"] == after["row"] and before["status"] == after["status"] == 0
        if both and low > 0 and high > EXPLOSION * low:
            found.append((before, after))
    return found


def label(value, unit):
    return f"{value:g}" + (f" {unit}" if unit else "")


def bad_rows(rows):
    """Runs that are not as they should be: missed and failed ones, and reported ones, where they are not known."""
    known = {(row.name, value) for row in stress_rows.ROWS for value in row.known}
    return [row for row in rows if row["outcome"] == "failed" or
            (not row["row"].startswith("random") and row["outcome"] != "ok" and (row["row"], row["value"]) not in known)]


def conditions_table(rows):
    body = []
    for row in stress_rows.ROWS:
        mine = [r for r in rows if r["row"] == row.name]
        if not mine:
            continue
        rates = [r["steps_per_sim_s"] for r in mine if r["status"] == 0]
        counts = {name: sum(r["outcome"] == name for r in mine) for name in ("ok", "reported", "missed", "failed")}
        body.append([f"{row.name}: {label(mine[0]['value'], row.unit)} to {label(mine[-1]['value'], row.unit)}", row.asks,
                     str(len(mine)), *(str(counts[name]) for name in counts),
                     f"{min(rates):.3g}-{max(rates):.3g}" if rates else "-"])
    return table(["condition", "what must hold", "runs", "ok", "reported", "missed", "failed", "steps a simulated second"], body)


def not_ok_table(rows):
    """Every run of a condition that is not ok, with its cause."""
    causes = {row.name: row.known for row in stress_rows.ROWS}
    units = {row.name: row.unit for row in stress_rows.ROWS}
    body = []
    for row in rows:
        if row["outcome"] != "ok":
            said = (row["found"] or row["message"]).replace("|", "/").split(": raise it")[0]
            body.append([f"{row['row']} {label(row['value'], units[row['row']])}", row["outcome"], said,
                         causes[row["row"]].get(row["value"], "**not known**")])
    return table(["run", "how it ended", "what was found", "cause"], body) if body else "All conditions hold."


def explosions_table(rows):
    units, why = ({row.name: getattr(row, key) for row in stress_rows.ROWS} for key in ("unit", "why"))
    body = [[before["row"], f"{label(before['value'], units[before['row']])}: {before['steps_per_sim_s']:.4g}",
             f"{label(after['value'], units[after['row']])}: {after['steps_per_sim_s']:.4g}", why[before["row"]] or "**not known**"]
            for before, after in explosions(rows)]
    return table(["condition", "steps a simulated second", "at the next value", "why"], body) if body else "None."


def ending(row):
    """In a few words how a random case ended."""
    if row["outcome"] != "reported":
        return row["outcome"]
    if row["status"] == 2:
        return "input"
    return "steps spent" if "is used up" in row["message"] else "no equilibrium" if "no equilibrium" in row["message"] else "other"


def random_table(rows):
    """How random cases ended, by kind of scene."""
    ends = ("ok", "input", "steps spent", "no equilibrium", "other", "failed")
    kinds = sorted({row["row"] for row in rows})
    body = []
    for kind in [*kinds, "all"]:
        mine = [row for row in rows if kind in ("all", row["row"])]
        body.append([kind.removeprefix("random "), str(len(mine)),
                     *(str(sum(ending(row) == end for row in mine)) for end in ends)])
    return table(["scene", "cases", "finished", "input refused", "steps spent", "no equilibrium", "other report", "failed"], body)


def failures_list(rows):
    """Random cases that failed, one line each."""
    lines = [f"- {row['row']} {row['value']}: {row['found']} {row['message'][:200]}" for row in rows if row["outcome"] == "failed"]
    return "\n".join(lines) if lines else "No random case failed."


def draw(path, rows):
    """The heat map of steps and failures."""
    picture = []
    for row in stress_rows.ROWS:
        cells = [{"label": label(r["value"], ""), "number": r["steps_per_sim_s"], "outcome": r["outcome"],
                  "words": f"{row.name} {label(r['value'], row.unit)}: {r['outcome']}; {r['steps']} steps in {r['sim_time_s']:g} s. "
                           f"{r['found'] or r['message']}"} for r in rows if r["row"] == row.name]
        if cells:
            picture.append((f"{row.name}{', ' + row.unit if row.unit else ''}", cells))
    write_heatmap(path, "Conditions and what became of them: value, and steps per simulated second",
                  "steps per simulated second", picture, (1.0, 1e4))


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--random", type=int, default=RANDOM_COUNT, help="how many random cases")
    parser.add_argument("--steps", type=int, default=stress_random.STEPS_MOST, help="most steps of a random case")
    parser.add_argument("--no-conditions", action="store_true", help="random cases only")
    args = parser.parse_args()
    load, start = load_of_others(0.1 if args.quick else 3), time.time()
    jobs = [] if args.no_conditions else [(run_value, row, value) for row in stress_rows.ROWS
                                          for value in (row.values[-1:] if args.quick else row.values)]
    count = len(jobs)
    jobs += [(run_random, number, args.steps) for number in range(20 if args.quick else args.random)]
    rows = run_all(args.build, jobs)
    conditions, drawn = rows[:count], rows[count:]
    bad = bad_rows(rows)
    verdict = table(["condition", "runs", "not as it should be", "reached"],
                    [["every value of every row: its condition holds, or its cause is known and it is reported", str(count),
                      str(sum(row in conditions for row in bad)), "no" if any(row in conditions for row in bad) else "yes"],
                     ["every random case: finite results, or a clear message", str(len(drawn)),
                      str(sum(row in drawn for row in bad)), "no" if any(row in drawn for row in bad) else "yes"]])
    text = "\n\n".join([heading(load, f"{time.time() - start:.0f} s, two processes at a time"), verdict, conditions_table(conditions),
                        "Runs that did not meet their condition:", not_ok_table(conditions),
                        f"Neighbours that differ by more than a factor of {EXPLOSION} in steps a simulated second:",
                        explosions_table(conditions), "Random cases:", random_table(drawn), failures_list(drawn)])
    if args.results and conditions:
        os.makedirs(args.results, exist_ok=True)
        draw(os.path.join(args.results, "stress.svg"), conditions)
    publish(args, "stress", rows, text, COLUMNS)
    for row in bad:
        print(f"stress.py: {row['row']} {row['value']}: {row['outcome']}: {row['found']} {row['message']}", file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
