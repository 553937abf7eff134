#!/usr/bin/env python3
"""Random scenes with an oracle: is a run that is trusted right?

Every scene is run as its case says, and twice more, strictly better each time: `fine` with segments half as long, a tenth of the accuracy
and friction that comes in at half of the speed; `finest` with a quarter, a hundredth and a fifth, and no step longer than a fifth of
the output interval. Where those two agree within half of what is allowed, their balances close and they begin at rest as the run does, the
finest is the truth; where not there is no oracle, which is counted apart, unless the run is farther off than what they differ by and
what is allowed together. A run is wrong if its mean pull is off by more than 3 % or its peak by more than 10 %, and trusted if every condition of its summary holds.

Two families: `sensible`, what an engineer could mean (truth_scenes.py), and `wild`, settings at random (stress_random.py).
Rows are appended to a file of JSON lines, and a scene that is there already is not run again:

    python3 bench/truth.py --build build/release --rows truth.jsonl --scenes 0-199
    python3 bench/truth.py --build build/release --rows new.jsonl --scenes 0-199 --truths truth.jsonl    # oracles from there

A row holds which program made it (a digest of its file, and the commit of the tree beside this script) and the processor time of its run, so
that rows of several sittings say themselves whether they are of one program.

Its status is 1 if a wrong run was trusted, or fewer than 85 % of the sensible ones were.
"""
import argparse
import collections
import concurrent.futures
import copy
import csv
import hashlib
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import threading

import stress_random
import truth_scenes
from common import ROOT, commit, table
from document import replace_between

MEAN, PEAK = 0.03, 0.10  # of the oracle's; half of it is what the oracles may differ by
TRUSTED_LEAST = 0.85     # share of the sensible scenes
# Pulls near zero are compared with a share of what is moved, weight and back tension: a winch that can move them has no scale that
# shows less, and a conveyor that pushes all but a rest leaves a difference of large forces.
FLOOR = 0.02
OF_PASS = ("steady_mean_N", "steady_mean_bar_N", "peak_N", "peak_bar_N")  # kept of each pass: what it shows itself
GRAVITY = 9.81
SLOW = 1e-3              # m/s: friction's v_s where a case does not say
REST = 5000              # steps of the relaxation of an oracle: one that is not at rest begins elsewhere
LEVELS = {"fine": {"mesh": 2, "accuracy": 10, "slower": 2, "step": 1}, "finest": {"mesh": 4, "accuracy": 100, "slower": 5, "step": 5}}
# One cause at a time: which of them moves a wrong pull?
CAUSES = {"time": {"mesh": 1, "accuracy": 100, "slower": 1, "step": 5}, "mesh": {"mesh": 4, "accuracy": 1, "slower": 1, "step": 1},
          "friction speed": {"mesh": 1, "accuracy": 1, "slower": 5, "step": 1}}


# ------------------------------------------------------------------------------------------------------------- scenes

def draw(family, number):
    """A scene's case as a dict."""
    if family == "sensible":
        return truth_scenes.draw(number)
    while True:  # a rod has no pull, and a rope that falls across itself no steady one
        case = stress_random.draw(number)
        if "rod" not in case and "cable_on_cable" not in case.get("contact", {}):
            break
        number += 1_000_000
    case["solver"].pop("max_steps")
    return case


def slower(value, factor):
    """A case's part with every speed at which a friction comes in divided by the factor."""
    if isinstance(value, list):
        return [slower(item, factor) for item in value]
    if not isinstance(value, dict):
        return value
    out = {key: slower(item, factor) for key, item in value.items()}
    for key in ("v_s", "v_d"):
        if key in out:
            out[key] /= factor
    if "bearing" in out and isinstance(out["bearing"], dict) and "speed" in out["bearing"]:
        out["bearing"]["speed"] /= factor
    return out


def better(case, run, mesh, accuracy, slower_by, step):
    """The case with all of its numerical settings made better by these factors, in one pass; run: of the case itself, for the settings
    of its figures, which a second pass may have made better already."""
    if slower_by != 1:
        slower_by /= run.get("v_s_factor", 1)
    out = slower(copy.deepcopy(case), slower_by)
    if slower_by != 1:
        out.setdefault("friction", {}).setdefault("v_s", SLOW / slower_by)
        if "rope_drag" in out.get("drive", {}):
            out["drive"]["rope_drag"].setdefault("v_s", SLOW / slower_by)
        for machine in out.get("conveyors", []):
            machine.setdefault("v_s", 1e-4 / slower_by)
    if mesh != 1:
        mean = sum(piece["length"] for piece in case["chain"]) / run["segments"]
        for piece in out["chain"]:
            piece["segment"] = piece.get("segment", mean) / mesh
    solver, interval = out.setdefault("solver", {}), case.get("output", {}).get("interval", 0.05)
    solver["accuracy"] = max(1e-8, run.get("accuracy", solver.get("accuracy", 1e-3)) / accuracy)
    solver["passes"] = 1
    solver["relax_iterations"] = REST
    if step != 1:
        solver["max_step"] = (solver.get("max_step") or interval) / step
    return out


# --------------------------------------------------------------------------------------------------------------- runs

def bars(pull):
    """Error bars of mean and peak, N: what there is of them."""
    found = {"mean": pull.get("steady_mean_error"), "peak": pull.get("peak_error")}
    return {name: bar["total_N"] for name, bar in found.items() if bar and bar.get("total_N") is not None}


def number(text):
    """What a field of a table says; None: nothing."""
    return float(text) if text else None


# What has an error bar besides the pull: the table, its columns of value and bar.
OTHERS = {"tension at stations, mean": ("stations.csv", "mean_N", "mean_error_N"), "peak": ("stations.csv", "peak_N", "peak_error_N"),
          "load of a roller, mean": ("rollers.csv", "steady_N", "steady_error_N"), "largest": ("rollers.csv", "peak_N", "peak_error_N")}
SIDEWALL = "sidewall pressure, peak"


def others(out, summary):
    """[[value, error bar], ...] of stations, rollers and surfaces, by kind."""
    found = {SIDEWALL: [[row["peak_line_load_N_per_m"], row["peak_line_load_error"]] for row in summary.get("surfaces") or []]}
    for kind, (name, value, bar) in OTHERS.items():
        path = os.path.join(out, name)
        if os.path.exists(path):
            with open(path, encoding="utf-8", newline="") as file:
                found[kind] = [[number(row[value]), number(row[bar])] for row in csv.DictReader(file)]
    return found


def launch(program, case, seconds):
    """One run within that much processor time: status (None: it took longer), what it says, pull and conditions."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "case.yaml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(case, file)
        with subprocess.Popen([program, "run", path, "-q", "-o", out], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              preexec_fn=limit) as child:
            message = child.stderr.read()
            _, ended, used = os.wait4(child.pid, 0)  # of this child alone: others run at the same time
            code = child.returncode = os.waitstatus_to_exitcode(ended)
        run = {"status": None if code in (-24, -9) else code, "message": message.strip().replace(path, "case.yaml")[:300],
               "cpu_s": round(used.ru_utime + used.ru_stime, 3)}
        if code not in (0, 3):
            return run
        try:
            with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
        except (OSError, ValueError):
            return run
        run["others"] = others(out, summary)
    pull = summary["pull_force"]
    run.update(segments=summary["segments"], steps=summary["steps"], mean=pull["steady_mean_N"], peak=pull["peak_N"],
               theory=summary["theory"]["reference_total_N"], failing={c["name"]: c["value"] for c in summary["trust"] if not c["holds"]},
               conditions={c["name"]: c["value"] for c in summary["trust"]}, verdict=summary["verdict"], bars=bars(pull),
               broken=[limit["name"] for limit in summary.get("limits") or [] if limit["ok"] is False])
    passes = summary.get("passes")
    if passes:
        shown = passes["pass"][-1 if passes["outcome"] == "replaced" else 0]
        run.update(passes=passes["outcome"], why=passes["why"], accuracy=shown["accuracy"], v_s_factor=shown["v_s_factor"],
                   each=[[one[key] for key in OF_PASS] for one in passes["pass"]])
    return run


def identity(program):
    """Which program it is: a digest of its file, and the commit of this tree, which says of a build elsewhere nothing."""
    with open(program, "rb") as file:
        return {"digest": hashlib.sha256(file.read()).hexdigest()[:12], "commit": commit()}


def complete(run):
    """Whether a run has figures."""
    return run is not None and run["status"] == 0 and run.get("mean") is not None and run.get("peak") is not None


def scale(case):
    """Pulls are compared with at least this, N."""
    weight = sum(piece["length"] * case["cables"][piece["cable"]]["mass"] for piece in case["chain"]) * GRAVITY
    return FLOOR * (weight + case.get("drive", {}).get("tail", {}).get("tension", 0))


def off(run, truth, floor):
    """Errors of mean and peak, shares."""
    return tuple((run[name] - truth[name]) / max(abs(truth[name]), floor) for name in ("mean", "peak"))


def within(errors, part=1.0):
    return abs(errors[0]) <= part * MEAN and abs(errors[1]) <= part * PEAK


def examine(program, family, number, seconds, known=None, made_by=None):
    """A scene's row. known: an earlier row, whose oracles are taken over, and with them who made them; made_by: the program's identity."""
    case = draw(family, number)
    row = {"program": made_by, "seconds": seconds, "family": family, "number": number, "title": case["title"], "run": launch(program, case, seconds), "oracles": {},
           "floor": scale(case)}
    if known and known.get("oracles"):
        row["oracles"] = known["oracles"]
        row["oracles_by"] = known.get("oracles_by", known.get("program"))
    elif complete(row["run"]):
        for name, by in LEVELS.items():
            row["oracles"][name] = launch(program, better(case, row["run"], by["mesh"], by["accuracy"], by["slower"], by["step"]),
                                          3 * seconds)
            if not complete(row["oracles"][name]):
                break
    judge(row)
    if row["ended"] == "wrong" and row["trusted"] and not known:
        for cause, by in CAUSES.items():
            run = launch(program, better(case, row["run"], by["mesh"], by["accuracy"], by["slower"], by["step"]), 3 * seconds)
            row.setdefault("causes", {})[cause] = off(run, row["oracles"]["finest"], row["floor"]) if complete(run) else None
    return row


def is_sound(oracle, run):
    """Whether an oracle's books close, and it begins at rest where the run did."""
    return complete(oracle) and not {"energy", "momentum"} & set(oracle["failing"]) and ("equilibrium" not in oracle["failing"] or
                                                                                        "equilibrium" in run["failing"])


def judge(row):
    """How a scene ended: `refused`, `unfinished`, `no oracle`, `right` or `wrong`; and whether it is trusted."""
    run, fine, finest = row["run"], row["oracles"].get("fine"), row["oracles"].get("finest")
    row["trusted"] = complete(run) and not run["failing"]
    if run["status"] == 2:
        row["ended"] = "refused"
    elif not complete(run):
        row["ended"] = "unfinished"
    elif not all(is_sound(oracle, run) for oracle in (fine, finest)):
        row["ended"] = "no oracle"
    else:
        row["off"] = off(run, finest, row["floor"])
        row["oracles_off"] = off(fine, finest, row["floor"])
        row["ended"] = "right" if within(row["off"]) else "wrong"
        # wrong wherever the truth is within what the oracles still differ by
        far = any(abs(e) > abs(o) + limit for e, o, limit in zip(row["off"], row["oracles_off"], (MEAN, PEAK)))
        if not within(row["oracles_off"], 0.5) and not far:
            row["ended"] = "no oracle"


# ------------------------------------------------------------------------------------------------------------- tables

def share(part, whole):
    return f"{len(part)} of {len(whole)} ({100 * len(part) / len(whole):.1f} %)" if whole else "-"


def contained(rows):
    """(how many error bars hold the truth, how many there are, median of their width over the error) of mean and peak."""
    held, ratios = 0, []
    for row in rows:
        finest = row["oracles"].get("finest")
        if row["ended"] not in ("right", "wrong"):
            continue
        for name, bar in row["run"].get("bars", {}).items():
            error, doubt = (abs(run[name] - finest[name]) for run in (row["run"], row["oracles"]["fine"]))
            held += error <= bar + doubt
            ratios.append(bar / max(error, 1e-9 * row["floor"]))
    return held, len(ratios), statistics.median(ratios) if ratios else None


def contained_others(rows):
    """Lines of a table: bars of what is not the pull, in runs whose own conditions hold. What weighs less than a thousandth of the
    largest of its kind is left out, as it is nothing."""
    body = []
    for kind in (*OTHERS, SIDEWALL):
        held, ratios = 0, []
        for row in rows:
            figures = [run.get("others", {}).get(kind, []) for run in (row["run"], row["oracles"].get("fine") or {},
                                                                       row["oracles"].get("finest") or {})]
            if row["ended"] not in ("right", "wrong") or not row["trusted"] or not all(figures):
                continue
            least = 1e-3 * max(abs(value or 0) for value, _ in figures[2])
            for (value, bar), (fine, _), (truth, _) in zip(*figures):
                if None in (value, bar, fine, truth) or abs(truth) <= least:
                    continue
                held += abs(value - truth) <= bar + abs(fine - truth)
                ratios.append(bar / max(abs(value - truth), 1e-9 * row["floor"]))
        if ratios:
            body.append([kind, str(len(ratios)), f"{100 * held / len(ratios):.1f} %", f"{statistics.median(ratios):.1f}"])
    return body


def programs(rows):
    """Which program made how many rows, by their own word, and what its runs took: rows of several sittings may be of several programs."""
    groups = collections.defaultdict(list)
    for row in rows:
        by = row.get("program") or {}
        groups[by.get("digest", "not recorded"), by.get("commit", "not recorded"), str(row.get("seconds", "not recorded"))].append(row)
    body = []
    for (digest, at, seconds), ours in sorted(groups.items()):
        numbers, cpu = [row["number"] for row in ours], [row["run"]["cpu_s"] for row in ours if "cpu_s" in row["run"]]
        took = [f"{statistics.median(cpu):.2f}", f"{sum(cpu):.0f}"] if cpu else ["-", "-"]
        body.append([digest, at, seconds, str(len(ours)), f"{min(numbers)} to {max(numbers)}"] + took)
    return table(["program", "commit of the tree", "s a run may take", "scenes", "numbers", "processor time of a run, median, s", "of all, s"],
                 body)


def report(rows):
    """The tables as Markdown."""
    text = [programs(rows)] if rows else []
    for family in ("sensible", "wild"):
        ours = [row for row in rows if row["family"] == family]
        if not ours:
            continue
        by = collections.Counter((row["ended"], bool(row.get("trusted"))) for row in ours)
        body = [[ended, str(by[ended, True]), str(by[ended, False])] for ended in ("right", "wrong", "no oracle", "unfinished", "refused")]
        text.append(f"{len(ours)} {family} scenes:\n\n" + table([family, "trusted", "not trusted"], body))
        failing = collections.Counter(name for row in ours for name in row["run"].get("failing", {}))
        alone = collections.Counter(next(iter(row["run"]["failing"])) for row in ours if len(row["run"].get("failing", {})) == 1)
        fine = collections.Counter(name for row in ours if row["ended"] == "right" for name in row["run"].get("failing", {}))
        if failing:
            text.append(table(["condition that fails", "scenes", "alone", "though right"],
                              [[name, str(count), str(alone[name]), str(fine[name])] for name, count in failing.most_common()]))
        held, bars_n, width = contained(ours)
        if bars_n:
            text.append(f"Error bars hold the truth in {held} of {bars_n} ({100 * held / bars_n:.1f} %); "
                        f"median of width over error: {width:.1f}.")
        body = contained_others(ours)
        if body:
            text.append("Of trusted runs:\n\n" + table(["figure", "bars", "hold the truth", "width over error, median"], body))
    return "\n\n".join(text)


def wrong_and_trusted(rows):
    return [row for row in rows if row["ended"] == "wrong" and row["trusted"]]


def misses(rows):
    """One line each for what must not be."""
    bad = [f"{row['family']} {row['number']} ({row['title']}): trusted with {100 * row['off'][0]:+.1f} % mean, {100 * row['off'][1]:+.1f} % peak"
           for row in wrong_and_trusted(rows)]
    sensible = [row for row in rows if row["family"] == "sensible" and row["ended"] != "refused"]
    trusted = [row for row in sensible if row["trusted"]]
    if sensible and len(trusted) < TRUSTED_LEAST * len(sensible):
        bad.append(f"trusted: {share(trusted, sensible)} of the sensible scenes")
    return bad


# --------------------------------------------------------------------------------------------------------------- main

def read_rows(path):
    if not path or not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        rows = [json.loads(line) for line in file if line.strip()]
    for row in rows:
        judge(row)
    return rows


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, help="a build, such as build/release")
    parser.add_argument("--rows", help="file of rows; appended to (default: none is kept)")
    parser.add_argument("--scenes", default="0-19", help="numbers A-B")
    parser.add_argument("--family", choices=["sensible", "wild"], action="append", help="(default: both)")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=5, help="processor time that a run may take; an oracle three times as much")
    parser.add_argument("--truths", help="file of rows whose oracles are taken over")
    parser.add_argument("--keep", help="folder for the case files of scenes that are wrong and trusted")
    parser.add_argument("--document", help="write the tables between the markers of this document")
    return parser.parse_args()


def main():
    args = arguments()
    first, last = (int(word) for word in args.scenes.split("-"))
    program = os.path.join(args.build, "cli/hawser")
    made_by = identity(program)
    rows = read_rows(args.rows)
    done = {(row["family"], row["number"]) for row in rows}
    known = {(row["family"], row["number"]): row for row in read_rows(args.truths)}
    jobs = [(family, number) for number in range(first, last + 1) for family in args.family or ("sensible", "wild")]
    lock = threading.Lock()

    def one(job):
        row = examine(program, *job, args.seconds, known.get(job), made_by)
        with lock:
            rows.append(row)
            if args.rows:
                with open(args.rows, "a", encoding="utf-8") as file:
                    file.write(json.dumps(row) + "\n")
            if args.keep and row["ended"] == "wrong" and row["trusted"]:
                os.makedirs(args.keep, exist_ok=True)
                with open(os.path.join(args.keep, f"{job[0]}-{job[1]}.yaml"), "w", encoding="utf-8") as file:
                    json.dump(draw(*job), file, indent=1)

    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        list(pool.map(one, [job for job in jobs if job not in done]))
    wanted = set(jobs)
    rows = [row for row in rows if (row["family"], row["number"]) in wanted]
    text = report(rows)
    print(text)
    bad = misses(rows)
    for line in bad:
        print(f"truth.py: {line}", file=sys.stderr)
    if args.document:
        with open(args.document, encoding="utf-8") as file:
            old = file.read()
        with open(args.document, "w", encoding="utf-8") as file:
            file.write(replace_between(old, "truth", text))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
