"""bench/paired.py, compare.py, counts.py and history.py: the statistics on made-up data, and a whole comparison.

Usage: test_compare.py ROOT
"""
import math
import os
import random
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import compare  # noqa: E402
import counts  # noqa: E402
import history  # noqa: E402
import paired  # noqa: E402

# Takes as long as the file `speed` beside it says; the pull is the file `pull`'s.
PROGRAM = '''#!/usr/bin/env -S python3 -S -E
import json, os, random, sys, time
words = dict(zip(sys.argv[1:], sys.argv[2:]))
here = os.path.dirname(os.path.abspath(__file__))
speed, pull = (float(open(os.path.join(here, name)).read()) for name in ("speed", "pull"))
end = time.process_time() + 0.02 * speed
while time.process_time() < end:
    pass
wall = speed * (1 + 0.001 * random.random())
names = ("relax", "rhs", "contacts", "jacobian", "factor", "solve", "vector", "output", "other")
summary = {"wall_time_s": wall, "phases_s": {name: wall / 9 for name in names}, "steps": 10, "newton_iters": 20,
           "rhs_evals": 30, "pull_force": {"steady_mean_N": pull, "peak_N": pull}}
with open(os.path.join(words["-o"], "summary.json"), "w") as file:
    json.dump(summary, file)
'''
ANNOTATED = """
1,000 (100.0%)  PROGRAM TOTALS

  990 (99.00%)  ???:main [/x/hawser]
  600 (60.00%)  sim/solve/integrator.c:integrator_step [/x/hawser]
  300 (30.00%)  ???:call_rates [/x/hawser]
  100 (10.00%)  ???:planar_contact_forces [/x/hawser]
   90 ( 9.00%)  ???:solver_solve.constprop.0 [/x/hawser]
   50 ( 5.00%)  ???:sim_record_row [/x/hawser]
   10 ( 1.00%)  ???:0x0000000000014ad1 [/usr/lib/libsundials_cvode.so.6.4.1]
"""


def skewed(chance, count, shift, noise=0.03):
    """Pairs of times: a common disturbance, skewed noise of their own with outliers, and a shift of the second."""
    old, new = [], []
    for _ in range(count):
        common = math.exp(chance.gauss(0, 0.3))
        one, two = (common * (1 + chance.expovariate(1 / noise) + (chance.random() < 0.05)) for _ in range(2))
        old.append(one)
        new.append(two * (1 + shift))
    return old, new


class Intervals(unittest.TestCase):
    def test_ranks_are_those_of_the_tables(self):
        # two-sided 5 %: the sign test's critical values
        self.assertEqual([paired.rank(n, 0.05) for n in (5, 6, 10, 20, 30, 40)], [0, 1, 2, 6, 10, 14])
        self.assertEqual(paired.least_pairs(0.05), 6)
        self.assertEqual(paired.interval([1, 2, 3], 0.05), (-math.inf, math.inf))
        self.assertEqual(paired.interval(list(range(10, 0, -1)), 0.05), (2, 9))

    def test_the_interval_covers_the_median(self):
        chance, missed = random.Random(2), 0
        for _ in range(2000):
            low, high = paired.interval([chance.expovariate(1) for _ in range(30)], 0.05)
            missed += not low <= math.log(2) <= high
        self.assertLess(missed / 2000, 0.06)  # 4.3 % exactly, 0.5 % its deviation
        self.assertGreater(missed / 2000, 0.025)


class Verdicts(unittest.TestCase):
    def verdicts(self, shift, least, count=40, trials=400):
        chance = random.Random(3)
        return [paired.judge(*skewed(chance, count, shift), 0.05, least)["verdict"] for _ in range(trials)]

    def test_equal_programs_are_called_equal(self):
        found = self.verdicts(0, least=0)
        self.assertGreaterEqual(found.count("no change beyond noise") / len(found), 0.95)
        found = self.verdicts(0, least=0.01)
        self.assertGreaterEqual(found.count("no change beyond noise") / len(found), 0.95)

    def test_a_shift_is_found_with_its_sign_and_size(self):
        self.assertGreater(self.verdicts(0.05, least=0.01).count("slower"), 380)
        self.assertGreater(self.verdicts(-0.05, least=0.01).count("faster"), 380)
        it = paired.judge(*skewed(random.Random(4), 200, 0.05), 0.05, 0.01)
        self.assertAlmostEqual(it["change"], 0.05, delta=0.01)
        self.assertTrue(it["low"] < 0.05 < it["high"])

    def test_small_changes_and_few_pairs_have_no_verdict(self):
        sure = [1.0] * 40, [1.005] * 40
        self.assertEqual(paired.judge(*sure, 0.05, 0.01)["verdict"], "no change beyond noise")
        self.assertEqual(paired.judge(*sure, 0.05, 0.001)["verdict"], "slower")
        self.assertEqual(paired.judge([1.0] * 5, [2.0] * 5, 0.05, 0.01)["verdict"], "no change beyond noise")

    def test_reports_share_their_error(self):
        # equal programs, all figures of a report at once: a verdict in at most 5 % of the reports
        chance, wrong = random.Random(5), 0
        for _ in range(200):
            pairs = [tuple({phase: chance.lognormvariate(0, 0.1) for phase in ("process", "all", "integration", *compare.PHASES)}
                           for _ in range(2)) for _ in range(40)]
            found = compare.judge_all({"straight": pairs, "huangjiahu": pairs[::-1]})
            wrong += any(it["verdict"] != "no change beyond noise" for it in found.values())
        self.assertLessEqual(wrong / 200, 0.08)


class Counts(unittest.TestCase):
    def test_phases_from_annotations(self):
        self.assertEqual(counts.phases_of(counts.read_annotated(ANNOTATED)),
                         {"rhs": 300, "solve": 90, "output": 50, "vector": 210, "contacts": 100, "all": 1000, "other": 350})

    def test_growth(self):
        counted = {"straight": ({"all": 100, "rhs": 10}, {"all": 110, "rhs": 10})}
        self.assertAlmostEqual(compare.growth(counted, "straight", "process"), 0.1)
        self.assertEqual(compare.growth(counted, "straight", "rhs"), 0)
        self.assertTrue(math.isnan(compare.growth(counted, "straight", "integration")))
        self.assertTrue(math.isnan(compare.growth(counted, "huangjiahu", "all")))

    def test_slower_counts_only_with_more_instructions(self):
        slower = {("straight", "process"): {"verdict": "slower"}, ("straight", "rhs"): {"verdict": "slower"}}
        for new, bad in ((100, []), (99, []), (101, ["straight"])):
            self.assertEqual(compare.worse(slower, {"straight": ({"all": 100}, {"all": new})}), bad)
        self.assertEqual(compare.worse(slower, {}), ["straight"])
        same = {("straight", "process"): {"verdict": "no change beyond noise"}}
        self.assertEqual(compare.worse(same, {"straight": ({"all": 100}, {"all": 200})}), [])


class History(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = os.path.join(self.folder.name, "history.csv")

    def record(self, commit, **figures):
        return history.record(self.path, {**dict.fromkeys(history.KEYS, "x"), "commit": commit, **figures})

    def text(self):
        with open(self.path, encoding="utf-8") as file:
            return file.read()

    def test_rows_are_appended_and_only_the_own_one_is_replaced(self):
        self.record("aaa", a=1)
        first = self.text()
        self.record("bbb", a=2)
        self.assertTrue(self.text().startswith(first))
        self.record("aaa+", a=3)
        self.assertEqual([row["a"] for row in self.record("bbb", a=4)], ["1", "4", "3"])
        self.assertEqual(self.text().splitlines()[1], first.splitlines()[1])

    def test_new_columns_do_not_lose_old_ones(self):
        self.record("aaa", a=1)
        rows = history.read_history(self.path) and self.record("bbb", b=2)
        self.assertEqual(history.read_history(self.path)[0], {**dict.fromkeys(history.KEYS, "x"), "commit": "aaa", "a": "1", "b": ""})
        self.assertTrue(math.isnan(history.numbers(history.read_history(self.path), "b")[0]))
        self.assertEqual(len(rows), 2)

    def test_picture_and_table(self):
        rows = [{**dict.fromkeys(history.KEYS, "x"), "commit": name, "straight.steps_per_s": str(speed)}
                for name, speed in (("aaa", 10), ("bbb", 20))]
        history.draw(os.path.join(self.folder.name, "h.svg"), rows)
        with open(os.path.join(self.folder.name, "h.svg"), encoding="utf-8") as file:
            self.assertIn("steps/s", file.read())
        self.assertIn("`bbb`", history.table_of(rows))
        self.assertNotIn("`aaa`", history.table_of(rows, last=1))


class Whole(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def build(self, name, speed, pull=7000):
        here = os.path.join(self.folder.name, name, "cli")
        os.makedirs(here)
        for file_name, text in (("hawser", PROGRAM), ("speed", str(speed)), ("pull", str(pull))):
            with open(os.path.join(here, file_name), "w", encoding="utf-8") as file:
                file.write(text)
        os.chmod(os.path.join(here, "hawser"), 0o755)
        return os.path.dirname(here)

    def compare(self, old, new):
        return subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/compare.py"), old, new, "--pairs", "12",
                               "--scenes", "straight", "--no-counts"], capture_output=True, text=True)

    def test_slower_and_faster(self):
        fast, slow = self.build("fast", 1), self.build("slow", 3, 7001)
        done = self.compare(fast, slow)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("Slower beyond noise with more instructions: straight", done.stdout)
        self.assertRegex(done.stdout, r"straight, all phases .*\*\*slower\*\*")
        self.assertIn("straight: results differ: pull 7000 -> 7001 N (+0.01 %)", done.stdout)
        done = self.compare(slow, fast)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"straight, all phases .*\*\*faster\*\*")

    def test_equal(self):
        done = self.compare(self.build("one", 1), self.build("two", 1))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("results agree to the last digit", done.stdout)
        self.assertRegex(done.stdout, r"straight, all phases .*no change beyond noise")


if __name__ == "__main__":
    unittest.main()
