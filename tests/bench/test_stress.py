"""bench/stress.py: what counts as clean, the random cases' repeatability, the picture; and whole runs of a false program."""
import csv
import io
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = sys.argv.pop(1)
sys.path.insert(0, os.path.join(ROOT, "bench"))
import common  # noqa: E402
import heatmap  # noqa: E402
import stress  # noqa: E402
import stress_random  # noqa: E402
import stress_rows  # noqa: E402

FINISHED = {"status": 0, "message": "", "wall_s": 0.1, "summary": {"outcome": "finished", "steps": 10, "sim_time_s": 2.0},
            "series": {"time_s": [0.0, 1.0], "gap": [None, 1.0]}}
SPENT = ("hawser: solver.max_steps = 6 is used up at t = 0.1 s (step 1e-07 s), the hardest part is segment 1 of 9: raise it or "
         "solver.accuracy, or soften what is stiff there")
INPUT = "hawser: case.yaml:12: key 'cables.a.EA': value '0' is out of range: must be above 0 N, at most 1e15 N"

# A hawser that ends as the case's title says.
PROGRAM = r"""#!/usr/bin/env python3
import json, os, signal, sys, time
case, out = json.load(open(sys.argv[2])), sys.argv[sys.argv.index("-o") + 1]
title = case.get("title", "")
os.makedirs(out, exist_ok=True)
what = "crash" if title.startswith("random 3:") else "nan" if title.startswith("random 4:") else "ok"
if what == "crash":
    os.kill(os.getpid(), signal.SIGSEGV)
pull = "NaN" if what == "nan" else "863.28"
open(os.path.join(out, "summary.json"), "w").write(
    '{"outcome": "finished", "steps": 10, "sim_time_s": 1.0, "events": [], "pull_force": {"steady_mean_N": %s}}' % pull)
open(os.path.join(out, "series.csv"), "w").write("time_s,max_tension_N\n0,1\n1,2\n")
"""


class Outcomes(unittest.TestCase):
    def run_with(self, **changes):
        return {**FINISHED, **changes}

    def test_finished(self):
        self.assertEqual(stress.outcome(FINISHED), ("ok", ""))
        self.assertEqual(stress.outcome(FINISHED, lambda run: (True, "fine")), ("ok", "fine"))
        self.assertEqual(stress.outcome(FINISHED, lambda run: (False, "off")), ("missed", "off"))

    def test_numbers_that_are_none(self):
        summary = {**FINISHED["summary"], "list": [{"x": 1.0}, {"x": math.inf}]}
        self.assertEqual(stress.outcome(self.run_with(summary=summary)), ("failed", "not finite: .list[].x"))
        self.assertEqual(stress.outcome(self.run_with(series={"a": [0.0, math.nan]}))[0], "failed")
        self.assertEqual(stress.outcome(self.run_with(summary=None))[0], "failed")

    def test_only_clear_messages_count(self):
        failed = {"outcome": "failed", "message": "x"}
        self.assertEqual(stress.outcome(self.run_with(status=3, message=SPENT, summary=failed))[0], "reported")
        self.assertEqual(stress.outcome(self.run_with(status=2, message=INPUT, summary=None))[0], "reported")
        for status, message, summary in ((3, SPENT, None), (3, "hawser: failed", failed), (3, SPENT + "\nmore", failed),
                                         (2, "hawser: bad", None), (-11, SPENT, failed), (1, SPENT, failed),
                                         (None, "no end within 240 s", failed), (23, INPUT, None)):
            self.assertEqual(stress.outcome(self.run_with(status=status, message=message, summary=summary))[0], "failed")


class Tables(unittest.TestCase):
    def rows(self, *rates, name="damping"):
        return [{"row": name, "value": float(k), "status": 0, "outcome": "ok", "steps_per_sim_s": rate}
                for k, rate in enumerate(rates)]

    def test_explosions_up_and_down(self):
        found = stress.explosions(self.rows(10, 99, 1000, 50))
        self.assertEqual([(a["value"], b["value"]) for a, b in found], [(1.0, 2.0), (2.0, 3.0)])

    def test_no_explosion_across_rows_or_failures(self):
        rows = self.rows(10) + self.rows(1000, name="mu")
        self.assertEqual(stress.explosions(rows), [])
        rows = self.rows(10, 1000)
        rows[1]["status"] = 3
        self.assertEqual(stress.explosions(rows), [])

    def test_what_is_known_is_no_failure(self):
        known = next(row for row in stress_rows.ROWS if row.known)
        rows = [{"row": known.name, "value": value, "outcome": "reported"} for value in known.values]
        self.assertEqual(len(stress.bad_rows(rows)), len(known.values) - len(known.known))
        rows = [{"row": known.name, "value": value, "outcome": "failed"} for value in known.known]
        self.assertEqual(stress.bad_rows(rows), rows)
        self.assertEqual(stress.bad_rows([{"row": "random rod", "value": 1, "outcome": "reported"}]), [])


class Cases(unittest.TestCase):
    def test_rows_are_as_they_should_be(self):
        names = [row.name for row in stress_rows.ROWS]
        self.assertEqual(len(set(names)), len(names))
        for row in stress_rows.ROWS:
            self.assertTrue(set(row.known) <= set(row.values), row.name)
            for value in row.values:
                json.dumps(row.case(value), allow_nan=False)

    def test_a_number_is_a_case(self):
        for number in range(50):
            case = stress_random.draw(number)
            self.assertEqual(stress_random.text(case), stress_random.text(stress_random.draw(number)))
            json.dumps(case, allow_nan=False)
        self.assertEqual(len({stress_random.draw(number)["title"].split(": ")[1] for number in range(100)}), 6)

    def test_put_leaves_the_original(self):
        case = stress_rows.pull_case()
        changed = stress_rows.put(case, drive__winch__speed=2, chain__0__segment=1, solver__accuracy=0.1)
        self.assertEqual(case, stress_rows.pull_case())
        self.assertEqual((changed["drive"]["winch"]["speed"], changed["chain"][0]["segment"], changed["solver"]),
                         (2, 1, {"accuracy": 0.1}))


class Picture(unittest.TestCase):
    def test_colours_run_with_the_logarithm(self):
        self.assertEqual(heatmap.colour(0, 1, 100), "#eeeeee")
        self.assertEqual(heatmap.colour(1, 1, 1e4), "#deebf7")
        self.assertEqual(heatmap.colour(100, 1, 1e4), "#fee391")
        self.assertEqual(heatmap.colour(1e9, 1, 1e4), "#cc4c02")


class Whole(unittest.TestCase):
    def test_crashes_and_nan_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "cli/hawser")
            os.makedirs(os.path.dirname(program))
            with open(program, "w", encoding="utf-8") as file:
                file.write(PROGRAM)
            os.chmod(program, 0o755)
            done = subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/stress.py"), "--build", folder, "--results",
                                   os.path.join(folder, "results"), "--no-conditions", "--random", "6"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("3: failed: status -11", done.stderr)
            self.assertIn("4: failed: not finite: .pull_force.steady_mean_N", done.stderr)
            with open(os.path.join(folder, "results/stress.csv"), encoding="utf-8") as file:
                rows = list(csv.DictReader(io.StringIO(file.read())))
            self.assertEqual([row["outcome"] for row in rows], ["ok", "ok", "ok", "failed", "failed", "ok"])

    def test_the_document_has_its_markers(self):
        with open(os.path.join(ROOT, "bench/results/xeon-2core/stress.md"), encoding="utf-8") as file:
            common.replace_between(file.read(), "stress", "new")


if __name__ == "__main__":
    unittest.main()
