"""bench/precision*.py: errors of histories, frontier, fits, verdicts and the sweep, on made-up runs; and logarithmic axes.

Usage: test_precision.py ROOT
"""
import math
import os
import re
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import common  # noqa: E402
import precision  # noqa: E402
import precision_judge as judge  # noqa: E402
import precision_report as report  # noqa: E402
import svgplot  # noqa: E402


def run_of(times, force, tension=None, loads=None, line=None):
    return {"time": times, "force": force, "tension": tension or force, "loads": loads or {}, "line": line}


class Errors(unittest.TestCase):
    times = [0.01 * k for k in range(1001)]
    dense = [0.0005 * k for k in range(20001)]

    def test_a_history_between_its_rows_and_beyond_its_ends(self):
        self.assertEqual(judge.at_times([-1, 0.5, 1, 1.75, 9], [0, 1, 2], [0, 10, 30]), [0, 5, 10, 25, 30])

    def test_rms_is_over_time_and_not_over_rows(self):
        # 2 for 9 s with two rows, then 0 for 1 s with many
        times = [0, 9] + [9 + 0.001 * k for k in range(1, 1001)]
        self.assertAlmostEqual(judge.rms(times, [2, 2] + [0] * 1000), math.sqrt(3.6), places=3)

    def test_each_error_is_of_its_own(self):
        # the force is off by 1 % of its largest in a sine, the peak by 3 %, the second load by 5 % of the heavier one
        reference = run_of(self.dense, [200 * math.sin(t) for t in self.dense], [300 * math.sin(t) for t in self.dense],
                           {"a": [10.0] * 20001, "b": [40.0] * 20001})
        run = run_of(self.times, [200 * math.sin(t) + 2 * math.sin(40 * math.pi * t) for t in self.times],
                     [309 * math.sin(t) for t in self.times], {"a": [10.0] * 1001, "b": [42.0] * 1001})
        found = judge.errors(run, reference)
        self.assertAlmostEqual(found["rms"], 0.01 / math.sqrt(2), places=4)
        self.assertAlmostEqual(found["largest"], 0.01, delta=6e-4)
        self.assertAlmostEqual(found["peak"], 0.03, places=6)
        self.assertAlmostEqual(found["load"], 0.05, places=9)

    def test_rows_at_other_times_are_no_error(self):
        reference = run_of(self.dense, [math.sin(t) for t in self.dense])
        times = [t + 0.003 * math.sin(9 * t) for t in self.times[1:-1]]
        self.assertLess(judge.errors(run_of(times, [math.sin(t) for t in times]), reference)["largest"], 1e-7)

    def test_a_line_load_is_a_load_and_nothing_is_none(self):
        reference = run_of(self.dense, [1.0] * 20001, line=50.0)
        self.assertAlmostEqual(judge.errors(run_of(self.times, [1.0] * 1001, line=51.0), reference)["load"], 0.02)
        self.assertIsNone(judge.errors(run_of(self.times, [1.0] * 1001), run_of(self.dense, [1.0] * 20001))["load"])

    def test_extrapolation_finds_the_limit(self):
        def mesh(h, times):
            force = [math.sin(t) + h * h * t for t in times]
            return run_of(times, force, loads={"a": [7 + h * h] * len(times)}, line=3 - h * h)

        limit = judge.extrapolate(mesh(0.2, self.dense), mesh(0.1, self.times))
        self.assertEqual(limit["time"], self.times)
        self.assertLess(max(abs(f - math.sin(t)) for t, f in zip(self.times, limit["force"])), 1e-6)
        self.assertAlmostEqual(limit["loads"]["a"][5], 7)
        self.assertAlmostEqual(limit["line"], 3)
        first = judge.extrapolate(run_of([0, 1], [5.4, 5.4]), run_of([0, 1], [5.2, 5.2]), order=1)
        self.assertAlmostEqual(first["force"][1], 5)


class Frontier(unittest.TestCase):
    def test_what_is_beaten_is_left_out(self):
        points = [(3, 0.1, "c"), (1, 0.5, "a"), (2, 0.6, "worse"), (2, 0.2, "b"), (3, 0.2, "dearer than b"), (9, 0.1, "dear")]
        self.assertEqual([name for *_, name in judge.frontier(points)], ["a", "b", "c"])
        self.assertEqual(judge.frontier([]), [])

    def test_work_is_straight_in_the_logarithms(self):
        curve = [(1, 1e-1), (100, 1e-3)]
        self.assertAlmostEqual(judge.work_for(curve, 1e-2), 10)
        self.assertEqual(judge.work_for(curve, 0.2), 1)
        self.assertIsNone(judge.work_for(curve, 1e-4))

    def test_a_curve_that_turns_back_counts_where_it_is_cheapest(self):
        curve = [(1, 1e-2), (5, 1e-1), (10, 1e-3)]
        self.assertEqual(judge.work_for(curve, 2e-2), 1)
        self.assertAlmostEqual(judge.work_for(curve, 1e-3), 10)

    def test_the_cheapest_curve_has_a_name(self):
        curves = {"a": [(4, 0.1), (8, 0.01)], "b": [(5, 0.001)]}
        self.assertEqual(judge.cheapest(curves, 0.1), (4, "a"))
        self.assertEqual(judge.cheapest(curves, 0.01), (5, "b"))
        self.assertEqual(judge.cheapest(curves, 1e-9), (None, None))


class Fits(unittest.TestCase):
    def test_exponent_between_floor_and_ceiling(self):
        points = [(a, a ** (2 / 3), a ** (2 / 3)) for a in (1e-2, 1e-3, 1e-4, 1e-5)] + [(1e-7, 1e-6, 1e-6), (1e-1, 0.3, 0.3)]
        self.assertAlmostEqual(judge.fit_order(points, 2e-6, 0.1), 2 / 3)
        self.assertIsNone(judge.fit_order(points, 1e-3, 0.02))

    def test_order_in_space_is_of_the_two_finest_that_are_sure(self):
        errors = {1.0: 0.5, 0.5: 0.16, 0.25: 0.04, 0.125: 0.001}
        self.assertAlmostEqual(judge.observed_order(errors), math.log2(40))
        self.assertAlmostEqual(judge.observed_order(errors, 0.01), 2)
        self.assertIsNone(judge.observed_order(errors, 0.2))


def row_of(work, error, scene="straight", **changes):
    return {**dict.fromkeys(precision.COLUMNS), **precision.job_of(scene), "round": 1, "outcome": "finished", "work_s": work,
            "steps": 10, "newton_iters": 20, "time_rms": error, "total_rms": error, **changes}


class Report(unittest.TestCase):
    def test_medians_are_over_the_rounds(self):
        rows = [row_of(work, 0.01, round=k) for k, work in enumerate((1.0, 9.0, 2.0))]
        found = report.medians(rows + [row_of(None, None, order=5, outcome="steps")])
        self.assertEqual([row["work_s"] for row in found], [2.0])

    def cells(self, others):
        return report.judgement("straight", [row_of(0.004, 0.002), *others], "time_rms")

    def test_a_default_that_nothing_beats(self):
        cells = self.cells([row_of(0.003, 0.004, accuracy=1e-2), row_of(0.009, 0.001, order=3, method="bdf")])
        self.assertEqual(cells[1:6], ["0.2", "4.0", "1.00", "auto", "on it"])
        self.assertEqual(cells[6:], ["3.0", "auto", "3.0", "1.00"])

    def test_a_default_that_is_beaten(self):
        near, off = self.cells([row_of(0.0025, 0.002, order=3, method="bdf")]), self.cells([row_of(0.001, 0.001, order=3, method="bdf")])
        self.assertEqual(near[3:6], ["1.60", "order 3", "near it"])
        self.assertEqual(off[3:6], ["4.00", "order 3", "off it"])
        self.assertEqual(off[6:], ["1.0", "order 3", "4.0", "4.00"])

    def test_the_one_step_method_is_a_curve_of_its_own(self):
        cells = self.cells([row_of(0.001, 0.001, method="esdirk", accuracy=1e-2)])
        self.assertEqual(cells[3:6], ["4.00", "one-step", "off it"])

    def test_what_an_error_costs(self):
        rows = [row_of(0.004, 0.02), row_of(0.008, 0.002, accuracy=1e-4), row_of(0.002, 0.005, method="esdirk"), row_of(9, 1e-5, method="esdirk")]
        text = report.levels_table(rows, "time_rms", segment=0.5).splitlines()[-1]
        self.assertIn("| straight | 2.0 | one-step | 2.", text)
        self.assertTrue(text.endswith("| one-step | - |"))

    def test_one_per_cent_out_of_reach(self):
        cells = report.judgement("straight", [row_of(0.004, 0.02)], "time_rms")
        self.assertEqual(cells[6:], ["-", "none", "-", "-"])

    def test_the_frontiers_table_shows_a_default_that_is_off_it(self):
        text = report.frontier_table([row_of(0.004, 0.002), row_of(0.001, 0.001, order=3, method="bdf"), row_of(0.1, 1e-6, order=4, method="bdf")])
        self.assertIn("| auto, 0.001 (default) off the frontier | 4.0 |", text)
        self.assertIn("| order 3, 0.001 | 1.0 |", text)
        self.assertNotIn("order 4", text)

    def test_runs_that_were_given_up_are_named(self):
        rows = [row_of(None, None, order=1, accuracy=1e-7, method="bdf", outcome="steps")]
        self.assertEqual(report.stopped(rows), "Given up for too many steps: straight, order 1, 1e-07.")
        self.assertEqual(report.stopped([row_of(1.0, 1.0)]), "Every run finished.")

    def test_failures_are_what_does_not_depend_on_time(self):
        steps = {"outcome": "steps"}
        self.assertEqual(precision.failures([row_of(1, 1), row_of(1, 1, order=5, **steps)], {}), [])
        self.assertIn("auto, accuracy 0.001: steps", precision.failures([row_of(1, 1, **steps)], {})[0])
        self.assertEqual(len(precision.failures([row_of(1, 1, order=4, outcome="status 3")], {})), 1)
        self.assertEqual(len(precision.failures([], {"chain": {"time smooth": 1e-3, "space": 1.0}})), 1)

    def test_the_document_has_its_markers(self):
        with open(os.path.join(ROOT, "bench/results/xeon-2core/precision.md"), encoding="utf-8") as file:
            common.replace_between(file.read(), "precision", "new")


class Sweep(unittest.TestCase):
    def test_every_configuration_is_there_once(self):
        jobs = precision.sweep_jobs("straight", False)
        for job in jobs:
            self.assertEqual(jobs.count(job), 1)
        self.assertIn(precision.job_of("straight"), jobs)
        for order in range(1, 6):
            mine = common.pick(jobs, order=order, segment=0.5, geometry="smooth", method="bdf")
            self.assertEqual({job["accuracy"] for job in mine}, set(precision.ACCURACIES))
        one_step = common.pick(jobs, segment=0.5, geometry="smooth", method="esdirk")
        self.assertEqual({job["accuracy"] for job in one_step}, set(precision.ACCURACIES))
        for segment in precision.SEGMENTS:
            for geometry in ("smooth", "cylinder"):
                self.assertIn(precision.job_of("straight", geometry, segment, 2, 1e-3, "bdf"), jobs)
        self.assertEqual({job["geometry"] for job in precision.sweep_jobs("chain", False)}, {"smooth"})

    def test_settings_name_what_is_varied(self):
        words = precision.SCENES["reel-start"].words(precision.job_of("reel-start", "cylinder", 0.25, 3, 1e-5, "bdf"), 20)
        for word in ("chain.0.segment=0.25 m", "chain.1.segment=0.25 m", "contact.geometry=cylinder", "solver.max_order=3", "solver.method=bdf",
                     "solver.accuracy=1e-05", "output.interval=0.001 s"):
            self.assertIn(word, words)
        self.assertNotIn("geometry", " ".join(precision.SCENES["chain"].words(precision.job_of("chain"), 1)))


class Axes(unittest.TestCase):
    def test_decades_and_their_labels(self):
        self.assertEqual([label for _, label in svgplot.marked(-6, 0, True)],
                         ["1e-06", "1e-05", "0.0001", "0.001", "0.01", "0.1", "1"])
        self.assertEqual([label for _, label in svgplot.marked(0.2, 1.1, True)], ["2", "5", "10"])
        self.assertEqual(svgplot.marked(0, 10, False), [(value, f"{value:g}") for value in (0, 2, 4, 6, 8, 10)])

    def test_equal_ratios_are_equally_far_apart_and_zero_is_a_gap(self):
        panel = svgplot.Panel("x", "y", log="xy").add("a", [1, 10, 100, 1000], [1e-1, 1e-2, 1e-3, 0])
        panel.add("", [1], [1e-1], marks=True)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.svg")
            svgplot.write_svg(path, "t", [panel])
            with open(path, encoding="utf-8") as file:
                text = file.read()
        line = re.search(r'<polyline points="([^"]*)"', text).group(1)
        (x0, y0), (x1, y1), (x2, y2) = [[float(v) for v in pair.split(",")] for pair in line.split()]
        self.assertAlmostEqual(x1 - x0, x2 - x1, delta=0.11)
        self.assertAlmostEqual(y1 - y0, y2 - y1, delta=0.11)
        self.assertGreater(y2, y0)
        self.assertEqual(text.count("<circle"), 1)  # the mark without a label has no place in the legend


if __name__ == "__main__":
    unittest.main()
