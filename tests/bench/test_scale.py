"""bench/scale.py: fit, turns of the workers, bytes, conditions and tables from made-up rows.

Usage: test_scale.py ROOT
"""
import os
import random
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import scale  # noqa: E402

# Stays and answers every amount; says in a common log when it was asked.
PROGRAM = '''#!/usr/bin/env -S python3 -S -E
import os, sys
log = os.path.join(os.path.dirname(os.path.abspath(__file__)), "log")
if sys.argv[2] == "13":
    sys.exit(3)
print("steps=7", flush=True)
for line in iter(sys.stdin.readline, ""):
    with open(log, "a") as file:
        file.write(sys.argv[2] + " " + line)
    print("steps=4 total_s=0.5", flush=True)
print("pull_ratio=1.25")
'''


def step_row(config, segments, number, seconds, steps=10, iterations=20):
    scene, way, threads = config
    return {"kind": "steps", "scene": scene, "way": way, "threads": threads, "segments": segments, "rollers": -1,
            "round": number, "steps": steps, "iterations": iterations, "setups": 2, "jacobians": 1, "total_s": seconds,
            **{name + "_s": seconds / 10 for name in scale.PHASES}}


def end_row(config, segments, ratio=1.0, height=-1.0):
    scene, way, threads = config
    return {"kind": "steps end", "scene": scene, "way": way, "threads": threads, "segments": segments, "rollers": -1,
            "pull_ratio": ratio, "middle_z": height, "candidates": 5, "memory_kB": 100}


def count_rows(segments, steps, simulated=1.5):
    base = {"scene": "pull", "way": "plane", "threads": 1, "segments": segments, "rollers": -1}
    return [{**base, "kind": "from rest", "round": 0, "steps": 100, "simulated_s": simulated},
            {**base, "kind": "sliding", "round": 0, "steps": 90, "simulated_s": 0.5, "iterations": 100},
            {**base, "kind": "sliding", "round": 1, "steps": steps, "simulated_s": simulated, "iterations": 2 * steps,
             "pull_ratio": 1.0}]


class Fit(unittest.TestCase):
    def test_power(self):
        lengths = [370, 1000, 3700, 10000]
        slope, error = scale.fit(lengths, [3e-9 * n ** 1.07 for n in lengths])
        self.assertAlmostEqual(slope, 1.07, places=12)
        self.assertLess(error, 1e-12)

    def test_error(self):
        """The standard error is the scatter of slopes of noisy lines."""
        dice = random.Random(5)
        lengths = [370, 1000, 3700, 10000, 37000, 100000]
        fits = [scale.fit(lengths, [n * 2.718281828 ** dice.gauss(0, 0.05) for n in lengths]) for _ in range(2000)]
        middle = sum(slope for slope, _ in fits) / len(fits)
        scatter = (sum((slope - middle) ** 2 for slope, _ in fits) / len(fits)) ** 0.5
        mean = (sum(error ** 2 for _, error in fits) / len(fits)) ** 0.5
        self.assertAlmostEqual(mean / scatter, 1, delta=0.06)

    def test_from(self):
        """Lengths below the first of the fit do not count; a step's slope is not an iteration's."""
        rows = [step_row(config, n, 1, 1e-6 * (5 if n < scale.FIT_FROM else 1) * n, iterations=n / 10)
                for config in scale.CONFIGS for n in (37, 370, 3700)]
        self.assertAlmostEqual(scale.slopes(rows)[scale.CONFIGS[0]][0], 1, places=12)
        self.assertAlmostEqual(scale.slopes(rows, "iterations")[scale.CONFIGS[0]][0], 0, places=12)


class Turns(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        os.mkdir(os.path.join(self.folder.name, "bench"))
        self.program = os.path.join(self.folder.name, "bench/bench_scale")
        with open(self.program, "w", encoding="utf-8") as file:
            file.write(PROGRAM)
        os.chmod(self.program, 0o755)

    def tearDown(self):
        self.folder.cleanup()

    def test_rounds(self):
        workers = [scale.Worker(self.folder.name, "pull", n, -1, "plane", 1, "0.5s") for n in (100, 5000)]
        self.assertEqual(workers[0].begun, {"steps": 7})
        rows = scale.in_turn(workers, 2, scale.steps_of_round, "steps")
        with open(os.path.join(self.folder.name, "bench/log"), encoding="utf-8") as file:
            self.assertEqual(file.read().split("\n")[:-1], ["100 60", "5000 10"] * 3)
        self.assertEqual([row["round"] for row in rows if row["kind"] == "steps"], [1, 1, 2, 2])
        self.assertEqual([row["pull_ratio"] for row in rows if row["kind"] == "steps end"], [1.25, 1.25])

    def test_fails(self):
        with self.assertRaisesRegex(RuntimeError, "status 3"):
            scale.Worker(self.folder.name, "pull", 13, -1, "plane", 1, 0)


class Rows(unittest.TestCase):
    def rows(self, heights=(-1.0, -1.0), ratio=1.0, later=(30, 60), turns=(7, 8)):
        rows = []
        for config in scale.CONFIGS:
            for n in (37, 370, 3700):
                rows += [step_row(config, n, number, 1e-6 * n * number) for number in (1, 2, 3)]
                rows.append(end_row(config, n, ratio, heights[config[2] - 1]))
        for n, steps in zip((370, 3700), later):
            rows += count_rows(n, steps)
        for way in ("plane", "space"):
            for n, turn, memory in zip((37, 370, 3700), (99, *turns), (1000, 4330, 37630)):
                rows.append({"kind": "setup", "scene": "rest", "way": way, "threads": 1, "segments": n, "round": 1,
                             "build_s": 1e-6 * n, "relax_s": 2e-6 * n, "relax_iterations": turn, "memory_kB": memory})
            rows.append({**step_row(("pull", way, 1), 2000, 1, 1e-3), "kind": "rollers", "rollers": 100})
            rows.append({**end_row(("pull", way, 1), 2000), "kind": "rollers end", "rollers": 100})
        return rows + [{"kind": "bandwidth", "threads": threads, "round": 1, "GB_per_s": 10.0 * threads}
                       for threads in (1, 2)]

    def test_fine(self):
        self.assertEqual(scale.faults(self.rows()), [])

    def test_faults(self):
        self.assertIn("bits", scale.faults(self.rows(heights=(-1.0, -1.0000000001)))[0])
        self.assertIn("pull is 0.98", scale.faults(self.rows(ratio=0.98))[0])
        self.assertIn("pull is nan", scale.faults(self.rows(ratio=float("nan")))[0])
        self.assertIn("30 to 150 steps", scale.faults(self.rows(later=(30, 150)))[0])
        self.assertIn("7 to 15 iterations", scale.faults(self.rows(turns=(7, 15)))[0])

    def test_bytes(self):
        """Ten steps of two iterations, with two matrices and one Jacobian."""
        row = step_row(scale.CONFIGS[2], 370, 1, 1.0)
        cost = scale.BYTES["space"]
        iteration = cost["iteration"] + cost["rhs"] + cost["solve"]
        expected = cost["step"] + 2 * iteration + 0.2 * cost["setup"] + 0.1 * cost["jacobian"]
        self.assertAlmostEqual(scale.moved("space", row), expected)

    def test_tables(self):
        rows = self.rows()
        self.assertIn("| pull, plane, 1 thr. | 1.000 | 0.000 | 1.000 | yes |", scale.verdicts_table(rows))
        self.assertIn("| 3700 | 200 |", scale.lengths_table(rows))  # the median of three rounds, ns a segment and step
        self.assertIn("| right-hand side | 0.0 | 0.0 | - |", scale.phases_table(rows, scale.CONFIGS[2]))
        self.assertIn("| solve | 20.0 | 20.0 | 1.00 |", scale.phases_table(rows, scale.CONFIGS[2]))
        self.assertIn("| plane, 3700 | 1.00 | 2.00 | 8 | 10.00 |", scale.setup_table(rows))
        self.assertIn("| 3700 | 67 | 90 | 40.0 | 2.00 | 1.00000 |", scale.counts_table(rows))
        self.assertIn("| plane, 100 | 5 | 100.0 | 10.0 | 10.0 | 50.0 |", scale.rollers_table(rows))
        total = scale.moved("space", step_row(scale.CONFIGS[2], 3700, 1, 1.0))
        self.assertIn(f"| pull, space, 1 thr. | {total / 1000:.1f} | 10.0 | {total / 10:.0f} | 180 |",
                      scale.roofline_table(rows))

    def test_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
            scale.draw(folder, self.rows())
            for name in ("scale.svg", "scale-rollers.svg"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    text = file.read()
                self.assertTrue(text.startswith("<svg") and "nan" not in text)


if __name__ == "__main__":
    unittest.main()
