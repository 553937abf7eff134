"""bench/common.py and steps.py: names, statistics, tables, and a whole benchmark of a made-up program.

Usage: test_steps.py ROOT
"""
import csv
import io
import os
import statistics
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import common  # noqa: E402

# Answers `hawser run CASE ... -o DIR --linear-solver S --threads N` with a summary; logs the order of the calls. The time
# of the first call of a configuration is wild, as of a program that is not in memory yet.
PROGRAM = '''#!/usr/bin/env python3
import json, os, sys
words = dict(zip(sys.argv[1:], sys.argv[2:]))
here = os.path.dirname(os.path.abspath(__file__))
case, solver, threads = os.path.basename(sys.argv[2])[:-5], words["--linear-solver"], int(words["--threads"])
with open(os.path.join(here, "log"), "a") as log:
    log.write(f"{case} {solver} {threads}\\n")
with open(os.path.join(here, "log")) as log:
    count = log.read().splitlines().count(f"{case} {solver} {threads}")
wall = 100.0 if count == 1 else (1 + 0.1 * count) / threads
pull = 8000.0 + (threads if os.path.exists(os.path.join(here, "differ")) else 0)
summary = {"linear_solver": "block" if solver == "auto" else solver, "wall_time_s": wall, "real_time_factor": 30 / wall,
           "steps_per_second": 1000 / wall, "steps": 1000, "rhs_evals": 1100, "newton_iters": 1090, "jac_evals": 40,
           "lin_setups": 100, "error_test_fails": 2, "newton_fails": 3, "pull_force": {"steady_mean_N": pull},
           "phases_s": {name: wall / 9 for name in ("relax", "rhs", "contacts", "jacobian", "factor", "solve", "vector",
                                                    "output", "other")}}
with open(os.path.join(words["-o"], "summary.json"), "w") as file:
    json.dump(summary, file)
'''
PHASES = '''#!/bin/sh
echo "target gcc99-test"
echo "rhs $2 12.5"
echo "solve $2 3.5"
'''


def rows_of(walls):
    """Rows of one configuration with these times."""
    return [{"case": "straight", "solver": "auto", "threads": 1, "round": i, "wall_time_s": wall}
            for i, wall in enumerate(walls)]


class Names(unittest.TestCase):
    def test_machine(self):
        name = common.machine_name
        self.assertEqual(name("AMD EPYC", 2), "epyc-2core")
        self.assertEqual(name("Intel(R) Xeon(R) Platinum 8375C CPU @ 2.90GHz", 4), "xeon-platinum-8375c-4core")
        self.assertEqual(name("AMD Ryzen 7 5800X 8-Core Processor", 16), "ryzen-7-5800x-16core")
        self.assertEqual(name("", 1), "unknown-1core")


class Statistics(unittest.TestCase):
    def test_spread(self):
        self.assertAlmostEqual(common.spread(rows_of([1, 2, 3, 4, 5]), "wall_time_s"), 100 / 3)
        self.assertEqual(common.spread(rows_of([7]), "wall_time_s"), 0)

    def test_ratio_is_taken_within_rounds(self):
        # a slow second round slows both alike: the ratio does not see it
        one, two = rows_of([2, 20, 2.2]), [{**row, "threads": 2} for row in rows_of([1, 10, 1.1])]
        self.assertAlmostEqual(common.ratio(one + two, {"threads": 2}, {"threads": 1}), 0.5)

    def test_table(self):
        self.assertEqual(common.table(["a", "b"], [["x", "1"]]), "| a | b |\n|---|---:|\n| x | 1 |")


class Document(unittest.TestCase):
    BEGIN, END = "<!-- steps: begin -->", "<!-- steps: end -->"
    text = f"before\n{BEGIN}\n\nold\n\n{END}\nafter\n"

    def test_only_what_is_between_changes(self):
        new = common.replace_between(self.text, "steps", "new")
        self.assertEqual(new, self.text.replace("old", "new"))
        self.assertEqual(common.replace_between(new, "steps", "new"), new)

    def test_markers_must_be_there(self):
        for text in ("", self.BEGIN, self.text + self.text, f"{self.END} {self.BEGIN}"):
            with self.assertRaises(ValueError):
                common.replace_between(text, "steps", "new")

    def test_the_document_has_them(self):
        with open(os.path.join(ROOT, "docs/performance.d/20-steps.md"), encoding="utf-8") as file:
            common.replace_between(file.read(), "steps", "new")


class Whole(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        for path, text in (("cli/hawser", PROGRAM), ("bench/bench_phases", PHASES)):
            self.place(path, text)
            os.chmod(self.path(path), 0o755)
        self.place("steps.md", f"# Steps\n{Document.BEGIN}\n{Document.END}\n")

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def place(self, name, text):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def bench(self, *words):
        return subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/steps.py"), "--build", self.folder.name,
                               "--results", self.path("results"), "--document", self.path("steps.md"), *words],
                              capture_output=True, text=True)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_rounds_are_interleaved_and_the_first_is_not_counted(self):
        done = self.bench("--repetitions", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        log = self.read("cli/log").splitlines()
        self.assertEqual(len(log), 3 * 12)
        self.assertEqual(len(set(log[:12])), 12)
        self.assertEqual(log[:12], log[12:24])
        rows = list(csv.DictReader(io.StringIO(self.read("results/steps.csv"))))
        self.assertEqual(len(rows), 2 * 12)
        walls = [float(row["wall_time_s"]) for row in rows
                 if (row["case"], row["solver"], row["threads"]) == ("straight", "auto", "2")]
        self.assertAlmostEqual(statistics.median(walls), 0.625)
        text = self.read("steps.md")
        self.assertIn("| straight, auto (block) | 2 | 625.0 |", text)
        self.assertIn("| huangjiahu, two threads to one | 0.500 |", text)
        self.assertIn("| straight: at least 8000 steps a second | 1603 | no |", text)
        self.assertIn("| solve | 3.50 |", text)
        self.assertIn("`gcc99-test`", text)

    def test_results_that_depend_on_threads_are_a_failure(self):
        self.place("cli/differ", "")
        done = self.bench("--repetitions", "1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("results differ between runs of huangjiahu with auto", done.stderr)

    def test_quick_is_short(self):
        self.assertEqual(self.bench("--quick").returncode, 0)
        self.assertEqual(len(self.read("cli/log").splitlines()), 2 * 12)

    def test_a_program_that_fails_ends_it(self):
        self.place("cli/hawser", "#!/bin/sh\nexit 3\n")
        self.assertNotEqual(self.bench("--quick").returncode, 0)
        self.assertFalse(os.path.exists(self.path("results/steps.csv")))


if __name__ == "__main__":
    unittest.main()
