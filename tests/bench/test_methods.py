#!/usr/bin/env python3
"""The comparison of methods: what counts as the best setting, when a sweep ends, ratios, verdicts, and the whole script.

Usage: test_methods.py ROOT [unittest options]
"""
import csv
import io
import json
import math
import os
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from unittest import mock

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import methods  # noqa: E402
from common import replace_between  # noqa: E402

FIXED = ("rk4", "symplectic-euler", "implicit-euler", "trapezoid", "bdf2-fixed", "generalised-alpha")
COST = {"hawser": 0.01, "rk4": 9, "symplectic-euler": 3, "erk-bogacki-shampine": 99, "erk-dormand-prince": 99}


class Program:
    """In bench_methods' place: the error falls with the setting, the cost rises. Keeps the calls; the trapezoid never comes
    near the reference if it is to be wrong."""

    def __init__(self, wrong=False):
        self.wrong, self.calls = wrong, []

    def call(self, *words, timeout=None):
        words = [str(word) for word in words]
        self.calls.append(words)
        if words[0] == "converge":
            return ""
        method, setting = words[3], 2e-5 if words[0] == "search" else float(words[4])
        rms = 0.5 * (setting if method in FIXED else setting**0.5)
        if self.wrong and method == "trapezoid":
            rms = 0.3
        return json.dumps({"arrived": True, "why": "", "per_segment": 6, "from_s": 0, "reached_s": 2, "rms": rms,
                           "cpu_s": COST.get(method, 0.1) / max(rms, 1e-4)**0.5, "worst": 2 * rms, "steps": 100, "rhs": 150,
                           "iterations": 140, "inner": 0, "setups": 10, "jacobians": 5, "error_fails": 0, "newton_fails": 1,
                           "largest_N": 8000, "setting": setting})


def row(cost, rms, arrived=True, **more):
    return {"cpu_ms_per_s": cost, "rms": rms, "arrived": arrived, **more}


def round_rows(scene, costs):
    """Rows of rounds 1, 2, ...: {method: [costs]}."""
    return [row(cost, 0, kind="round", scene=scene, method=name, round=k + 1)
            for name, values in costs.items() for k, cost in enumerate(values)]


class Choice(unittest.TestCase):
    def test_the_cheapest_within_the_goal(self):
        rows = [row(1, 0.02), row(5, 0.009), row(4, 0.001), row(0.1, 0.001, arrived=False)]
        self.assertEqual(methods.best(rows)["cpu_ms_per_s"], 4)
        self.assertIsNone(methods.best(rows[:1]))

    def test_an_error_that_is_no_number_is_not_good(self):
        self.assertFalse(methods.good(row(1, math.nan)))

    def test_a_sweep_goes_on_until_two_are_good_and_the_picture_has_points(self):
        loose, tight = row(1, 0.1), row(2, 0.005)
        self.assertFalse(methods.enough([loose, tight], spent=2, cap=8))
        self.assertFalse(methods.enough([loose, tight, tight], spent=0.5, cap=8))
        self.assertFalse(methods.enough([loose, tight, tight], spent=2, cap=8))  # a tenth of the goal is still to be had
        self.assertTrue(methods.enough([loose, tight, row(3, 0.001)], spent=2, cap=8))
        self.assertTrue(methods.enough([loose, tight, tight], spent=5, cap=8))
        self.assertTrue(methods.enough([loose], spent=9, cap=8))

    def test_settings_in_words(self):
        klu = {"setting": 1e-3, "program": "cvode-klu", "words": ("a.b=1", "solver.max_order=5")}
        self.assertEqual(methods.setting_text(klu), "tol 1e-03, order 5")
        self.assertEqual(methods.setting_text({"setting": 5e-3, "program": "trapezoid", "words": ()}), "h 5 ms")


class Figures(unittest.TestCase):
    rows = round_rows("s", {"a": [1, 10, 1.2], "b": [3, 30, 3.6]}) + round_rows("other", {"a": [100]})

    def test_median_over_the_rounds_of_one_scene(self):
        cost, spread = methods.timed(self.rows, "s", "a", row(7, 0))
        self.assertAlmostEqual(cost, 1.2)
        self.assertGreater(spread, 0)
        self.assertEqual(methods.timed(self.rows, "other", "a", row(7, 0)), (7, None))

    def test_ratios_are_taken_within_rounds(self):
        self.assertAlmostEqual(methods.paired(self.rows, "s", "b", "a"), 3)
        self.assertIsNone(methods.paired(self.rows, "other", "b", "a"))

    def scene(self, own, other):
        scene = methods.Scene("s")
        scene.sweeps = {methods.HAWSER: [row(*own)], "x": [row(*other)], "y": [row(0.01, 0.001, arrived=False)]}
        return {"s": scene}

    def test_verdicts_name_who_is_cheaper(self):
        self.assertIn("| s, 1 % | 1 | x | 2 | 2.00 | yes |", methods.verdicts([], self.scene((1, 5e-3), (2, 5e-3))))
        self.assertIn("| s, 1 % | 3 | x | 2 | 0.67 | no, factor 1.50 |",
                      methods.verdicts([], self.scene((3, 5e-3), (2, 5e-3))))
        self.assertIn("| s, 0.1 % | - | x | 2 | - | no: not reached |",
                      methods.verdicts([], self.scene((3, 5e-3), (2, 5e-4))))

    def test_a_method_that_does_not_converge_is_told(self):
        scene = methods.Scene("s")
        scene.sweeps = {name: [row(1, 1e-4)] for name in methods.MUST}
        scene.held = {name: row(1, 1e-4) for name, _, _ in methods.EXPLICIT}
        self.assertEqual(methods.disagreements({"s": scene}, quick=False), [])
        scene.sweeps[methods.HAWSER] = [row(1, 0.02), row(1, 1e-4, arrived=False)]
        del scene.held["RK4"]
        found = methods.disagreements({"s": scene}, quick=False)
        self.assertEqual(len(found), 2)
        self.assertIn("hawser comes no closer", found[0])
        self.assertIn("RK4 found no step", found[1])


class Names(unittest.TestCase):
    def test_the_ladder_and_conditions_name_methods_that_there_are(self):
        names = {method.name for method in methods.METHODS}
        self.assertLessEqual({name for name, _, _ in methods.LADDER} | set(methods.MUST), names)
        self.assertEqual(len(names), len(methods.METHODS))

    def test_pictures_of_the_document_are_made(self):
        with open(os.path.join(ROOT, "bench/results/xeon-2core/methods.md"), encoding="utf-8") as file:
            text = file.read()
        replace_between(text, "methods", "new")
        for name in ("huangjiahu", "straight", "straight, light"):
            self.assertIn(name, methods.SCENES)
            self.assertIn(f"({methods.picture_name(name)})", text)


class Whole(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def bench(self, *words, wrong=False):
        """The whole script; its status, what it prints and complains, and the calls of the program."""
        program, out, err = Program(wrong), io.StringIO(), io.StringIO()
        words = ["methods.py", "--build", "none", "--results", self.path("results"), *words]
        with mock.patch.object(methods.Bench, "call", lambda _, *given, timeout=None: program.call(*given)), \
                mock.patch.object(sys, "argv", words), redirect_stdout(out), redirect_stderr(err):
            status = methods.main()
        return status, out.getvalue(), err.getvalue(), program.calls

    def test_goals_rounds_and_rows(self):
        status, out, err, _ = self.bench("--rounds", "2", "--scenes", "huangjiahu;huangjiahu in space")
        self.assertEqual(status, 0, err)
        self.assertRegex(out, r"huangjiahu: the best explicit method \(semi-implicit Euler\) over hawser's default "
                              r"\| \S+ \| 100 \| yes")
        self.assertRegex(out, r"huangjiahu in space: CVODE with KLU on the unreduced system over hawser in the plane, "
                              r"both at 1 % \| \S+ \| 5 \|")
        with open(self.path("results/methods.csv"), newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        again = [r["method"] for r in rows if r["kind"] == "round" and r["scene"] == "huangjiahu"]
        self.assertEqual(again[:len(again) // 2], again[len(again) // 2:])  # every round the same, one after the other
        self.assertEqual(len(set(again)), len(again) // 2)
        for name in ("huangjiahu", "huangjiahu-in-space"):
            self.assertTrue(os.path.exists(self.path(f"results/methods-{name}.svg")))

    def test_a_scene_in_space_gets_its_reference_in_the_plane_and_runs_in_space(self):
        status, _, _, calls = self.bench("--rounds", "1", "--scenes", "straight in space")
        self.assertEqual(status, 0)
        self.assertFalse([call for call in calls if call[0] == "converge" and "solver.planar=off" in call])
        runs = [call for call in calls if call[0] != "converge" and "straight_in_space" in call[1]]
        self.assertTrue(runs)
        self.assertTrue(all("solver.planar=off" in call for call in runs))

    def test_a_method_that_is_wrong_is_a_failure(self):
        status, _, err, _ = self.bench("--rounds", "1", "--scenes", "straight", wrong=True)
        self.assertEqual(status, 1)
        self.assertIn("straight: trapezoid, fixed step comes no closer to the reference than 30 %", err)


if __name__ == "__main__":
    unittest.main()
