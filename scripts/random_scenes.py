#!/usr/bin/env python3
"""Runs random scenes of bench/stress_random.py for a few steps each, and judges how each ended.

Usage: random_scenes.py PROGRAM LEDGER FIRST COUNT [--steps N] [--seconds S]
       random_scenes.py sum LEDGER...

Scenes FIRST to FIRST + COUNT - 1, drawn by their numbers, with at most N steps (60); of every second one a twentieth of its
duration, so that it may come to its end within them; two in three have limits that are hard to break. Each run must end with status 0 and finite figures, or 2 or 3 and a line that says
where and what; what takes more than S seconds of processor time (20) is ended and counted apart: a solver that the scene asks for may be a slow one. A verdict SAFE only of a run that was finished, all of whose
conditions of trust hold, with a number for the pull and for every limit that was judged. LEDGER gets a row a scene, so that a call that was cut
off goes on behind the last one; it ends with 1 if a scene was bad; `sum` prints counts.
"""
import argparse
import collections
import csv
import math
import os
import resource
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "bench"))
import stress  # noqa: E402
import stress_random  # noqa: E402

FIELDS = ["scene", "kind", "status", "steps", "verdict", "processor_s", "bad", "message"]


def case_of(number, steps):
    case = stress_random.draw(number)
    case["solver"].update(max_steps=steps, relax_iterations=60)
    if number % 2:
        case["run"]["duration"] /= 20
        case["output"] = {key: value / 20 for key, value in case["output"].items()}
    if number % 3 and "rod" not in case:  # something to be SAFE in
        case["limits"] = {"conductor": {"material": "copper", "area": "800 mm2"}, "attachment_rating": "1 GN", "winch_capacity": "1 GN",
                          "sidewall": "100 MN/m"}
    return case


def run(program, case, seconds):
    """As stress.launch, but limited by the processor's time: the machine may be busy."""
    with tempfile.TemporaryDirectory() as folder:
        path, out = os.path.join(folder, "case.yaml"), os.path.join(folder, "out")
        with open(path, "w", encoding="utf-8") as file:
            file.write(stress_random.text(case))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([program, "run", path, "-q", "-o", out], capture_output=True, text=True, errors="replace", check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5)))
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        found = {"status": done.returncode, "message": done.stderr.strip().replace(path, "case.yaml"), "summary": None, "series": None,
                 "processor_s": round(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 3)}
        try:
            with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
                found["summary"] = stress.json.load(file)
            found["series"] = stress.read_series(os.path.join(out, "series.csv"))
        except (OSError, ValueError):
            pass  # what is missing is None, and judged
    return found


def straight(row):
    """Whether the limit is a radius and nothing bends: `null` stands for infinite then."""
    return row["name"] in ("bend_radius", "rope_bend") and row["value"] is None and row["margin"] == 1.0


def unsafe(summary):
    """What is wrong with a verdict SAFE; "" if nothing is, or the verdict is another one."""
    if not summary or not summary["verdict"].startswith("SAFE"):
        return ""
    if summary["outcome"] != "finished":
        return f"SAFE, but {summary['outcome']}"
    broken = [row["name"] for row in summary["trust"] if not row["holds"]]
    if broken:
        return f"SAFE, but not trusted: {broken}"
    figures = [summary["pull_force"]["steady_mean_N"], summary["pull_force"]["peak_N"],
               *(row["value"] for row in summary["limits"] if row["ok"] and not straight(row))]
    return "SAFE without a figure" if any(v is None or not math.isfinite(v) for v in figures) else ""


def judge(found):
    if found["status"] == -signal.SIGXCPU:
        return ""
    ended, why = stress.outcome(found)
    bad = why if ended == "failed" else ""
    numbers = stress.not_finite(found["summary"] or {}) + stress.series_not_finite(found["series"] or {})
    return bad or ("not finite: " + ", ".join(numbers) if numbers else "") or unsafe(found["summary"])


def go(args):
    start = args.first
    if os.path.exists(args.ledger):
        with open(args.ledger, newline="", encoding="utf-8") as file:
            start = max([int(row["scene"]) + 1 for row in csv.DictReader(file)] + [start])
    bad = 0
    for number in range(start, args.first + args.count):
        case = case_of(number, args.steps)
        found = run(args.program, case, args.seconds)
        summary, wrong = found["summary"] or {}, judge(found)
        bad += bool(wrong)
        new = not os.path.exists(args.ledger)
        with open(args.ledger, "a", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            if new:
                writer.writerow(FIELDS)
            writer.writerow([number, case["title"].split(": ")[1], found["status"], summary.get("steps", ""),
                             summary.get("verdict", "").split(":")[0], found["processor_s"], wrong, found["message"][:300]])
        if wrong:
            print(f"{number}: {wrong}: {found['message'][:200]}", flush=True)
    return 1 if bad else 0


def total(ledgers):
    ends, seconds, most, bad = collections.Counter(), 0.0, 0.0, []
    for ledger in ledgers:
        with open(ledger, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                ends[f"status {row['status']} {row['verdict']}".strip()] += 1
                seconds += float(row["processor_s"])
                most = max(most, float(row["processor_s"]))
                if row["bad"]:
                    bad.append(f"{row['scene']}: {row['bad']}")
    print(f"{sum(ends.values())} scenes, {seconds / 3600:.2f} h of processor time, the longest {most:.1f} s, {len(bad)} bad")
    for end, n in ends.most_common():
        print(f"  {end}: {n}")
    print("\n".join(bad))
    return 0


def main():
    if sys.argv[1:2] == ["sum"]:
        return total(sys.argv[2:])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("ledger")
    parser.add_argument("first", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("--steps", type=int, default=60)
    parser.add_argument("--seconds", type=int, default=20)
    return go(parser.parse_args())


if __name__ == "__main__":
    sys.exit(main())
