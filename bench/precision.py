#!/usr/bin/env python3
"""Run time against error: six scenes over accuracy, method of integration, order limit, segment length and contact geometry.

Two runs go at once, in processes of their own. A run's work is the processor time of its integration: that of the process
times the integration's share of its duration, so that other programs do not count. Its errors are those of its histories
against two references: of the same mesh, converged in time, and of no segment length, extrapolated from fine meshes.
A round runs every configuration once; runs of more than a second are not repeated. Fails if a run fails, if one of order 2
takes too many steps, or if a reference is not as sure as it must be.
"""
import concurrent.futures
import functools
import json
import math
import os
import sys
import tempfile
import time

from common import ROOT, RunFailed, arguments, load_of_others, publish, read_series, run_case
from precision_judge import errors, extrapolate
import precision_report

HERE = os.path.join(ROOT, "bench/cases")
INTEGRATION = ("rhs", "contacts", "jacobian", "factor", "solve", "vector")
COUNTS = ("steps", "rhs_evals", "newton_iters", "jac_evals", "lin_setups", "error_test_fails", "newton_fails")
ERRORS = ("rms", "largest", "peak", "load")
COLUMNS = ["scene", "geometry", "segment", "method", "order", "accuracy", "round", "outcome", "work_s", "process_s", "cpu_s", *COUNTS,
           *("time_" + name for name in ERRORS), *("total_" + name for name in ERRORS)]
ACCURACIES = (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7)
SEGMENTS = (1.0, 0.5, 0.25, 0.125)
MOST_STEPS, DENSE, LONG = 200000, 20, 1.0  # of a run; rows of a reference over those of a run; s
SURE = 2e-4  # what the two references in time may differ by


class Scene:
    """A case, what is set in it besides, and where its figures stand.

    force: columns of the tension (their root of squares); loads: rollers; pieces: of the chain; interval: s between rows;
    order: of convergence with the segments' length.
    """

    def __init__(self, name, case, settings=(), force=("winch_force_N",), loads=(), pieces=1, interval=0.02, order=2,
                 cylinder=True):
        self.name, self.case, self.settings, self.force, self.order = name, case, list(settings), force, order
        self.loads, self.pieces, self.interval = loads, pieces, interval
        self.geometries = ("smooth", "cylinder") if cylinder else ("smooth",)

    def words(self, job, dense):
        """Settings of one run; dense: so many times the rows."""
        words = [*self.settings, "output.states=0 s", f"output.interval={self.interval / dense:.9g} s",
                 f"solver.accuracy={job['accuracy']:.9g}", f"solver.max_order={job['order']}",
                 f"solver.method={job['method']}", f"solver.max_steps={MOST_STEPS}"]
        words += [f"chain.{k}.segment={job['segment']:.9g} m" for k in range(self.pieces)]
        words += [f"contact.geometry={job['geometry']}"] if len(self.geometries) > 1 else []
        return words + ([f"output.rollers_of=[{', '.join(self.loads)}]"] if self.loads else [])


SCENES = {scene.name: scene for scene in (
    Scene("straight", "straight", ["run.duration=3 s", "run.steady_from=2 s"], loads=("R1", "R40", "R90")),
    # The eye's cone is as long as a segment: if it lies on a roller at the start, as in the case, meshes begin elsewhere.
    Scene("huangjiahu", "huangjiahu", ["run.duration=15 s", "run.steady_from=14 s", "output.speeds_of=[0]",
                                       "rollers.along.to=58.2 m"], loads=("P2", "P10", "P22"), pieces=2, interval=0.05),
    Scene("reel-start", os.path.join(HERE, "reel-start.yaml"), loads=("R1", "R2", "R3"), pieces=2),
    Scene("s-bend", os.path.join(HERE, "s-bend.yaml"), order=1),  # its ends, half a segment short of contact, are felt
    Scene("snap", os.path.join(HERE, "snap.yaml"), loads=("R1", "R8", "R16"), interval=0.002),
    Scene("chain", os.path.join(HERE, "chain.yaml"), force=("pin_fx_N", "pin_fy_N", "pin_fz_N"), interval=0.01,
          cylinder=False),
)}


def job_of(scene, geometry="smooth", segment=0.5, order=2, accuracy=1e-3, method="auto"):
    """A configuration; of "esdirk" the order says nothing. The default's is "auto"."""
    return {"scene": scene, "geometry": geometry, "segment": segment, "order": order, "accuracy": accuracy, "method": method}


def histories(build, job, dense=1):
    """One run: its summary, and the histories that precision_judge.errors compares."""
    scene = SCENES[job["scene"]]
    with tempfile.TemporaryDirectory() as folder:
        summary = run_case(build, scene.case, scene.words(job, dense), timeout=300, keep=folder)
        series = read_series(os.path.join(folder, "series.csv"))
    line = [surface["peak_line_load_N_per_m"] for surface in summary["surfaces"]]
    return summary, {"time": series["time_s"], "tension": series["max_tension_N"],
                     "force": [math.hypot(*values) if len(values) > 1 else values[0]
                               for values in zip(*(series[name] for name in scene.force))],
                     "loads": {name: series[f"load_{name}_N"] for name in scene.loads}, "line": max(line, default=None)}


# ------------------------------------------------------------------------------------------------------- references

def reference_jobs(scene, quick):
    """{name: job} of the dense runs: two ways to the limit in time for every geometry, and the two finest meshes."""
    tight, finest = (1e-5, (0.5, 0.25)) if quick else (1e-9, (0.125, 0.0625))
    jobs = {}
    for geometry in SCENES[scene].geometries:
        jobs["time " + geometry] = job_of(scene, geometry, order=3, accuracy=tight, method="bdf")
        jobs["check " + geometry] = job_of(scene, geometry, order=4, accuracy=tight, method="bdf")
    for name, segment in zip(("coarse", "fine"), finest):
        jobs[name] = job_of(scene, segment=segment, order=3, accuracy=max(tight, 1e-7), method="bdf")
    return jobs


def reference_run(build, folder, name, job, dense):
    """Runs a reference and keeps it in the folder; returns its file."""
    path = os.path.join(folder, f"{job['scene']} {name}.json")
    _, found = histories(build, job, dense)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(found, file)
    return path


@functools.lru_cache(maxsize=32)
def reference(folder, scene, name):
    """A kept reference; "space" is the one of no segment length."""
    if name == "space":
        return extrapolate(reference(folder, scene, "coarse"), reference(folder, scene, "fine"), SCENES[scene].order)
    with open(os.path.join(folder, f"{scene} {name}.json"), encoding="utf-8") as file:
        return json.load(file)


def certainties(folder, scene):
    """By how much each reference may be wrong: {name: RMS share}."""
    found = {"time " + geometry: errors(reference(folder, scene, "check " + geometry),
                                        reference(folder, scene, "time " + geometry))["rms"]
             for geometry in SCENES[scene].geometries}
    found["space"] = errors(reference(folder, scene, "fine"), reference(folder, scene, "space"))["rms"]
    return found


# ------------------------------------------------------------------------------------------------------- the sweep

def sweep_jobs(scene, quick):
    """Every configuration once: orders and the one-step method by accuracies on the default mesh, meshes and geometries by
    accuracies."""
    accuracies = (1e-2, 1e-3) if quick else ACCURACIES
    jobs = [job_of(scene, order=order, accuracy=accuracy, method="bdf") for order in ((1, 2) if quick else (1, 2, 3, 4, 5))
            for accuracy in accuracies]
    jobs += [job_of(scene, accuracy=accuracy, method=method) for method in ("auto", "esdirk") for accuracy in accuracies]
    for geometry in SCENES[scene].geometries:
        for segment in (0.5,) if quick else SEGMENTS:
            settings = [(2, accuracy, method) for method in ("bdf", "esdirk") for accuracy in accuracies[:5]]
            settings += [(3, 1e-7, "bdf")] * (not quick)  # for space alone
            jobs += [job_of(scene, geometry, segment, *setting) for setting in settings]
    return [job for k, job in enumerate(jobs) if job not in jobs[:k]]


def measure(build, folder, job, number):
    """One run of the sweep: a row of precision.csv."""
    row = {**dict.fromkeys(COLUMNS), **job, "round": number, "outcome": "finished"}
    try:
        summary, found = histories(build, job)
    except RunFailed as failure:
        return {**row, "outcome": "steps" if "max_steps" in failure.message else failure.message}
    row.update({name: summary[name] for name in ("process_s", "cpu_s", *COUNTS)})
    share = sum(summary["phases_s"][name] for name in INTEGRATION) / summary["process_s"]
    row["work_s"] = round(share * summary["cpu_s"], 6)
    kinds = [("total_", "space")] + [("time_", "time " + job["geometry"])] * (job["segment"] == 0.5)
    for prefix, name in kinds:
        wrong = errors(found, reference(folder, job["scene"], name))
        row.update({prefix + key: float(f"{value:.6g}") for key, value in wrong.items() if value is not None})
    return row


def run_all(pool, function, calls, what):
    """Calls in turn, two at once, with a word on progress."""
    start = time.monotonic()
    found = list(pool.map(function, *zip(*calls)))
    print(f"precision.py: {what}, {len(calls)} runs, {time.monotonic() - start:.0f} s", file=sys.stderr)
    return found


def sweep(pool, args, folder):
    """All rounds; runs that take long or fail are made once."""
    jobs = [job for scene in SCENES for job in sweep_jobs(scene, args.quick)]
    rows = []
    for number in range(1, (1 if args.quick else args.rounds) + 1):
        calls = [(args.build, folder, job, number) for job in jobs]
        found = run_all(pool, measure, calls, f"round {number}")
        rows += found
        jobs = [job for job, row in zip(jobs, found) if row["outcome"] == "finished" and row["process_s"] < LONG]
    return rows


def failures(rows, sure):
    """What makes the part fail: runs that did not finish, references that are not sure.

    With other orders than 2 too many steps are a result.
    """
    found = [f"{row['scene']}, {row['geometry']}, {row['segment']} m, {precision_report.method_of(row)}, accuracy {row['accuracy']:g}: "
             f"{row['outcome']}" for row in rows
             if row["outcome"] not in ("finished", "steps") or (row["outcome"] == "steps" and row["order"] == 2)]
    return found + [f"{scene}: the references ({name}) differ by {value:.1e}" for scene, values in sure.items()
                    for name, value in values.items() if name != "space" and value > SURE]


def main():
    parser = arguments(__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=3)
    args = parser.parse_args()
    load = load_of_others(0.1 if args.quick else 3)
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ProcessPoolExecutor(1 if args.quick else 2) as pool:
        calls = [(args.build, folder, name, job, 2 if args.quick else DENSE) for scene in SCENES
                 for name, job in reference_jobs(scene, args.quick).items()]
        run_all(pool, reference_run, calls, "references")
        sure = {scene: certainties(folder, scene) for scene in SCENES}
        rows = sweep(pool, args, folder)
    text = precision_report.text(rows, sure, load, max(row["round"] for row in rows))
    if args.results:
        shown = precision_report.pictures(rows, args.results)
        for path, words in shown:
            text += f"\n\n![{words}]({os.path.relpath(path, os.path.join(ROOT, 'docs'))})"
    publish(args, "precision", rows, text, COLUMNS)
    bad = failures(rows, {} if args.quick else sure)
    for line in bad:
        print("precision.py: " + line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
