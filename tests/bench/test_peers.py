"""bench/peers.py: which settings go on, which rows are compared, the goal, and a whole run with made-up programs.

Usage: test_peers.py ROOT
"""
import csv
import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import peer_grids  # noqa: E402
import peers  # noqa: E402

# Answers PROBLEM N SETTINGS... as bench/peers/run.h says; the settings say what: cost=, error=, and from= which size on it
# does not finish. Costs grow as N^1.5.
PROGRAM = '''#!/usr/bin/env python3
import sys
name, problem, n = "NAME", sys.argv[1], int(sys.argv[2])
settings = [word for word in sys.argv[3:] if "=" in word]
said = dict(word.split("=") for word in settings)
if "--trace" in sys.argv:
    open(sys.argv[sys.argv.index("--trace") + 1], "w").write("0 0\\n")
cost = float(said.get("cost", 0.001)) * (n / 12) ** 1.5
done = n < int(said.get("from", 10 ** 6))
error = said.get("error", "0.01") if done else ""
print(f"{name},{problem},{n},{' '.join(settings)},{'finished' if done else 'limit'},7,0.1,{7 * cost},700,1,1,{error},5,2")
'''


def row(settings, error, cost, outcome="finished", **more):
    return {"settings": settings, "error_pct": error, "cost": cost, "outcome": outcome, **more}


class Choice(unittest.TestCase):
    rows = [row("slow", 0.001, 9), row("wrong", 3, 1), row("best", 0.1, 2), row("bad", 0.2, 1),
            row("none", None, 1, "limit")]

    def test_rank(self):
        self.assertEqual(peers.rank(self.rows, None), ["best", "slow", "bad", "wrong"])
        self.assertEqual(peers.rank(self.rows, 1), ["best"])

    def test_rank_where_more_is_good_enough(self):
        self.assertEqual(peers.rank(self.rows, None, 2), ["bad", "best", "slow", "wrong"])

    def test_rank_names_a_setting_once(self):
        self.assertEqual(peers.rank(self.rows + self.rows, 3), ["best", "slow", "bad"])

    def test_best_is_a_median(self):
        self.assertEqual(peers.best([row("a", 0.1, cost) for cost in (5, 1, 2)])["cost"], 2)

    def test_best_of_unfinished_runs(self):
        rows = [row("a", None, 5, "limit"), row("b", None, 4, "limit"), row("c", None, 1, "failed")]
        self.assertEqual(peers.best(rows)["settings"], "b")
        self.assertIsNone(peers.best(rows[2:]))

    def test_match_is_the_cheapest_that_is_not_worse(self):
        rows = [row("fine", 0.001, 8), row("default", 0.3, 3), row("coarse", 2, 1)]
        self.assertEqual(peers.match(rows, 0.02)["settings"], "fine")
        self.assertEqual(peers.match(rows, 0.5)["settings"], "default")
        self.assertEqual(peers.match(rows, 2.5)["settings"], "coarse")
        self.assertEqual(peers.match(rows, None)["settings"], "fine")
        self.assertIsNone(peers.match(rows[1:], 0.02))

    def test_errors_below_the_same_level_are_equal(self):
        rows = [row("fine", 0.001, 8), row("default", 0.09, 3)]
        self.assertEqual(peers.match(rows, 0.0001)["settings"], "default")


class Grid(unittest.TestCase):
    def test_combinations(self):
        self.assertEqual(peer_grids.grid(a=[1, 2], b=["x"]), ["a=1 b=x", "a=2 b=x"])

    def test_no_setting_twice(self):
        for peer in (peer_grids.HAWSER, *peers.PEERS):
            for problem in peers.PROBLEMS:
                self.assertEqual(len(peer.sweep[problem]), len(set(peer.sweep[problem])), f"{peer.name} {problem}")

    def test_row(self):
        read = peers.read_row("mujoco,swing,37,a=1 b=2,limit,0.5,0.01,2,100,,,,0.5,")
        self.assertEqual((read["n"], read["cost"], read["error_pct"], read["settings"]), (37, 4, None, "a=1 b=2"))
        with self.assertRaises(ValueError):
            peers.read_row("mujoco,swing,37")


class Goal(unittest.TestCase):
    peer = peer_grids.Peer("mujoco", "MuJoCo", "package", {}, {})

    def goal(self, *theirs):
        rows = [{"program": "mujoco", "problem": "straight", "n": n, "stage": "sweep", **row("s", error, cost)}
                for n, error, cost in theirs]
        rows += [{"program": "hawser", "problem": "straight", "n": n, "stage": "hawser", **row("", 0.01, 0.002)}
                 for n in peers.SIZES]
        return peers.goal_rows(rows, [self.peer])[0][1:]

    def test_reached_at_full_size(self):
        self.assertEqual(self.goal((120, 0.01, 0.5), (370, 0.1, 1.0)), ["370", "500", "yes"])
        self.assertEqual(self.goal((370, 0.1, 0.998)), ["370", "499", "no"])

    def test_at_the_largest_size_with_a_small_error(self):
        self.assertEqual(self.goal((120, 0.05, 3), (370, 0.2, 9)), ["120 (largest managed)", "1500", "yes"])

    def test_no_size_at_all(self):
        self.assertEqual(self.goal((120, 5, 3)), ["-", "-", "no setting reached the error"])


    def test_the_swing_is_compared_where_errors_may_be_larger(self):
        rows = [{"program": name, "problem": "swing", "n": 12, "stage": stage, **row(settings, error, cost)}
                for name, stage, settings, error, cost in (("mujoco", "sweep", "exact", 0.01, 9.0), ("mujoco", "sweep", "rough", 1.9, 1.0),
                                                           ("mujoco", "sweep", "wrong", 2.1, 0.1), ("hawser", "hawser", "exact", 0.01, 0.1),
                                                           ("hawser", "hawser", "rough", 1.5, 0.04))]
        self.assertEqual(peers.goal_rows(rows, [self.peer])[1][1:], ["12", "25.0", "yes"])


class Sweep(unittest.TestCase):
    """Which settings of the swinging chain go on: the best within 0.1 %, and two that are cheapest within 2 %."""

    class Runner:
        costs = {"exact": (9, 0.01), "more": (10, 0.02), "rough": (2, 1.9), "rougher": (3, 1), "third": (4, 1), "wrong": (1, 2.1)}

        def __init__(self):
            self.asked = []

        def run(self, _peer, _problem, n, settings, _stage, limit):
            self.asked.append((n, settings, limit))
            cost, error = self.costs[settings]
            return row(settings, error, cost)

    def test_rough_ones_go_on(self):
        runner, settings = self.Runner(), list(self.Runner.costs)
        peer = peer_grids.Peer("mujoco", "MuJoCo", "package", {"swing": settings, "straight": settings}, {}, keep={37: 1, 120: 1, 370: 1})
        peers.sweep(runner, peer, "swing", False)
        self.assertEqual([name for n, name, _ in runner.asked if n == 37], ["exact", "rough", "rougher"])
        self.assertEqual([name for n, name, _ in runner.asked if n == 370], ["exact", "rough", "rougher"])
        runner.asked = []
        peers.sweep(runner, peer, "straight", False)
        self.assertEqual([name for n, name, _ in runner.asked if n == 37], ["exact"])


class Whole(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        os.makedirs(os.path.join(self.folder.name, "bench/peers"))

    def program(self, name, text=PROGRAM):
        path = os.path.join(self.folder.name, "bench/peers/peer_" + name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace("NAME", name))
        os.chmod(path, 0o755)

    def bench(self, *words):
        return subprocess.run([sys.executable, "-B", os.path.join(ROOT, "bench/peers.py"), "--build", self.folder.name,
                               "--results", os.path.join(self.folder.name, "results"), *words],
                              capture_output=True, text=True)

    def rows(self):
        with open(os.path.join(self.folder.name, "results/peers.csv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))

    def test_packages_that_are_missing(self):
        self.program("hawser")
        done = self.bench("--quick")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("MuJoCo: skipped: package libmujoco-dev is missing.", done.stdout)
        self.assertIn("Simbody, its integrators: skipped: package libsimbody-dev is missing.", done.stdout)
        self.assertTrue(os.path.exists(os.path.join(self.folder.name, "results/peers.svg")))

    def test_wrong_results_of_hawser_are_a_failure(self):
        self.program("hawser", PROGRAM.replace('"0.01"', '"3"'))
        done = self.bench("--quick")
        self.assertEqual(done.returncode, 1)
        self.assertIn("hawser is wrong: straight 12", done.stderr)

    def test_a_setting_that_is_not_known_ends_it(self):
        self.program("hawser")
        self.program("mujoco", "#!/bin/sh\necho 'does not know it' >&2\nexit 2\n")
        done = self.bench("--quick")
        self.assertEqual(done.returncode, 1)
        self.assertIn("does not know it", done.stderr)

    def test_a_crash_is_a_row(self):
        self.program("hawser")
        self.program("mujoco", "#!/bin/sh\nkill -SEGV $$\n")
        self.assertEqual(self.bench("--quick").returncode, 0)
        self.assertIn("failed", {row["outcome"] for row in self.rows() if row["program"] == "mujoco"})

    def test_the_best_go_on_and_unfinished_ones_do_not(self):
        self.program("hawser")
        self.program("mujoco")
        peer = peer_grids.Peer("mujoco", "MuJoCo", "", {"straight": [
            "cost=2 error=0.05", "cost=1 error=0.05 from=120", "cost=0.1 error=4", "cost=3 error=0.01"]}, {},
            keep={37: 3, 120: 2})
        runner = peers.Runner(self.folder.name, self.folder.name)
        peers.sweep(runner, peer, "straight", False)
        ran = {n: [row["settings"].split()[0] for row in runner.rows if row["n"] == n] for n in peers.SIZES}
        self.assertEqual(ran, {12: ["cost=2", "cost=1", "cost=0.1", "cost=3"], 37: ["cost=1", "cost=2", "cost=3"],
                               120: ["cost=1", "cost=2"], 370: ["cost=2"]})

    def test_what_is_aside_is_not_chosen(self):
        rows = [{"program": name, "problem": "straight", "n": 370, "stage": stage, "ripple": 1.0, **row("s", 0.05, cost)}
                for name, stage, cost in (("mujoco", "aside", 1), ("mujoco", "sweep", 3), ("hawser", "hawser", 0.002))]
        self.assertEqual(peers.pairs(rows, peer_grids.MUJOCO, "straight")[0][1]["cost"], 3)
        self.assertIn("| 370 | `s` | finished | 0.05 | 1 | 1 | 500 |", peers.aside_table(rows, [peer_grids.MUJOCO]))

    def test_growth(self):
        self.program("hawser")
        self.program("mujoco")
        peer = peer_grids.Peer("mujoco", "MuJoCo", "", {"straight": ["cost=2 error=0.05"]}, {})
        runner = peers.Runner(self.folder.name, self.folder.name)
        peers.sweep(runner, peer, "straight", False)
        peers.measure_hawser(runner, peers.SIZES, "straight", 1, True)
        self.assertEqual({row["round"] for row in runner.rows}, {1})
        self.assertIn("| straight pull, MuJoCo | 37 to 370 | 1.50 | 1.50 |", peers.growth_table(runner.rows, [peer]))


if __name__ == "__main__":
    unittest.main()
