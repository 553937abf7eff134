#!/usr/bin/env python3
"""Runs the program again and again, each time with another of its calls failing (inject.c), and judges how it ended.

Usage: inject.py HAWSER SHIM SOURCE_DIR [--all] [--only KIND] [--jobs N]

Without --all the calls are sampled: evenly, and all of the first and last ones. Memory that is refused, once (memory) or from
a size on (heap), must end with status 5 and "out of memory", a disk with status 4 and the file; what can be done without may be missed (status 0, the same
figures). Interrupted and short transfers change nothing. A signal, another status, or a file that is cut off under its
final name is a failure.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

SAMPLES, EDGES = 90, 6
HEAP_STEP = 16  # KiB between two sizes of the heap, where all are tried
SHORT = ["--set", "run.duration=0.3 s", "--set", "run.steady_from=0.2 s", "--set", "output.states=0.1 s", "--quiet"]
STATUS = {"memory": {0, 5}, "heap": {0, 5}, "disk": {0, 4}, "eintr": {0}, "short": {0}}
SAYS = {5: "out of memory", 4: "cannot write"}


class Scene:
    """A command line, what it writes when nothing fails: results into a folder, a page, or nothing."""

    def __init__(self, hawser, shim, words, writes):
        self.command, self.shim, self.words, self.writes = hawser, shim, words, writes

    def run(self, kind, at):
        with tempfile.TemporaryDirectory(prefix="hawser_inject_") as folder:
            count = os.path.join(folder, "count")
            out = os.path.join(folder, "out")
            if self.writes in ("page", "line"):
                os.mkdir(out)
            to = {"results": ["-o", out], "study": ["-o", out], "page": ["-o", os.path.join(out, "page.html")],
                  "line": ["-o", os.path.join(out, "line.csv")], None: []}[self.writes]
            words = [self.command, *self.words, *to]
            env = dict(os.environ, LD_PRELOAD=self.shim, INJECT_KIND=kind, INJECT_AT=str(at), INJECT_COUNT=count,
                       OPENBLAS_NUM_THREADS="1")
            try:
                done = subprocess.run(words, env=env, capture_output=True, timeout=60, check=False)
            except subprocess.TimeoutExpired:
                return None, "", "", {}, 0
            files = {}
            for where, _, names in os.walk(out):
                for name in names:
                    with open(os.path.join(where, name), "rb") as f:
                        files[os.path.relpath(os.path.join(where, name), out)] = f.read()
            calls = 0
            if os.path.exists(count):
                with open(count, encoding="ascii") as f:
                    calls = int(f.read() or 0)
            text = done.stderr.decode("utf-8", "replace").replace(folder, "")
            return done.returncode, done.stdout.replace(folder.encode(), b""), text, files, calls


def results_of(files):
    """Without what a finer pass can be gone on with from: where removing fails it stays, for the next run to remove."""
    return {name: content for name, content in files.items()
            if name != "checkpoint.hawser" and not name.startswith(("second-pass/", "third-pass/"))}


def is_whole(files, reference):
    """Whether all files of a run are there, each with as many rows."""
    files = results_of(files)
    def rows(of):
        return {name: content.count(b"\n") for name, content in of.items() if name.endswith(".csv")}
    return files.keys() == reference.keys() and rows(files) == rows(reference)


def faults(kind, reference, result):
    """What is wrong with how it ended."""
    status, out, err, files, _ = result
    if status is None:
        return ["hangs"]
    if status not in STATUS[kind]:
        return [f"status {status}: {err.strip()[-160:]}"]
    found = []
    if status and SAYS[status] not in err:
        found.append(f"status {status} without its reason: {err.strip()[-160:]}")
    if not status and out != reference[1]:
        found.append("says something else")
    if not status and files.get("series.csv") != reference[3].get("series.csv"):
        found.append("series.csv is not the same")
    found += [f"{name} is left" for name in files if name.endswith(".part")]
    # a page may say that it has no view, without memory for HDF5; it is never cut off
    found += [f"{name} is cut off" for name, content in files.items()
              if name.endswith(".html") and not content.rstrip().endswith(b"</html>")]
    if not status and files.get("line.csv") != reference[3].get("line.csv"):
        found.append("line.csv is not the same")
    if not status and reference[3].keys() != results_of(files).keys():
        found.append("other files than without a failure")
    if "summary.json" in files:
        try:
            outcome = json.loads(files["summary.json"]).get("outcome")  # of a study there is none
            # What ended may be the second pass, which leaves the results of the first as they were, or the very last call, the
            # folder's own fsync: results are whole then.
            late = status == 5 or "cannot write '/out':" in err
            if status and outcome == "finished" and not (late and is_whole(files, reference[3])):
                found.append("summary.json says finished")
        except ValueError:
            found.append("summary.json is cut off")
    return found


def choose(kind, calls, everything):
    if everything or calls <= SAMPLES:
        return range(1, calls + 1, HEAP_STEP if kind == "heap" else 1)
    even = {1 + i * (calls - 1) // (SAMPLES - 1) for i in range(SAMPLES)}
    return sorted(even | set(range(1, EDGES + 1)) | set(range(calls - EDGES, calls + 1)))


def study_of(folder, data):
    """A study of four samples by theory."""
    path = os.path.join(folder, "study.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"case: {os.path.abspath(os.path.join(data, 'limits.yaml'))}\nparameters:\n  friction.mu: {{uniform: {{from: 0.1, to: 0.3}}}}\n"
                   "monte-carlo: {samples: 4, seed: 1}\nquantities: [reference_total_N]\n")
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("hawser")
    parser.add_argument("shim")
    parser.add_argument("source")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", choices=sorted(STATUS))
    parser.add_argument("--scene", help="this command alone")
    parser.add_argument("--jobs", type=int, default=2)
    args = parser.parse_args()
    data = os.path.join(args.source, "tests", "data")
    kinds = sorted(STATUS)
    results = tempfile.TemporaryDirectory(prefix="hawser_inject_results_")
    subprocess.run([args.hawser, "run", os.path.join(data, "cli-pull.yaml"), *SHORT, "-o", results.name], check=True)
    scenes = [Scene(args.hawser, args.shim, words, writes) for words, writes in (
        (["run", os.path.join(data, "cli-pull.yaml"), *SHORT], "results"),
        (["report", results.name], "page"),
        (["check", os.path.join(data, "limits.yaml")], None),
        (["theory", os.path.join(data, "cli-pull.yaml"), "--format", "json"], None),
        (["library"], None),
        (["route", os.path.join(args.source, "cases", "routes", "tunnel.geojson"), "--json"], "line"),
        (["route", os.path.join(args.source, "cases", "routes", "tunnel.xml")], None),
        (["route", os.path.join(args.source, "cases", "routes", "tunnel.ifc")], None),
        (["route", os.path.join(args.source, "cases", "routes", "tunnel.dxf")], None),
        (["study", study_of(results.name, data), "--jobs", "1", "--quiet"], "study"))]
    bad = total = 0
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for scene in [s for s in scenes if args.scene in (None, s.words[0])]:
            for kind in [args.only] if args.only else kinds:
                if kind == "disk" and not scene.writes:
                    continue
                reference = scene.run(kind, 0)
                if reference[0] != 0:
                    print(f"{scene.words[0]}: fails when nothing does: {reference[2]}")
                    return 1
                chosen = choose(kind, reference[4], args.all)
                failed = 0
                for at, result in zip(chosen, pool.map(lambda k, s=scene, w=kind: s.run(w, k), chosen)):
                    wrong = faults(kind, reference, result)
                    failed += bool(wrong)
                    if wrong:
                        print(f"  {scene.words[0]}, {kind} {at}: {'; '.join(wrong)}")
                unit = "KiB were the most" if kind == "heap" else "calls failed"
                print(f"{scene.words[0]}, {kind}: {len(chosen)} of {reference[4]} {unit}, {failed} badly", flush=True)
                bad += failed
                total += len(chosen)
    print(f"{total} runs, {bad} ended badly")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())
