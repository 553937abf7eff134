"""bench/long.py: rates, growth, and what is judged.

Usage: test_long.py ROOT
"""
import os
import sys
import unittest

ROOT = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, os.path.join(ROOT, "bench"))
import long  # noqa: E402


def rows(scene="paying", steps=lambda t: 20 * t, memory=lambda t: 5000, share=1e-5):
    return [{"scene": scene, "t_s": t, "steps": steps(t), "rhs_evals": 50 * t, "newton_iters": 40 * t, "cpu_s": 0.01 * t,
             "memory_kB": memory(t), "active": 110, "winch_N": 1e3, "residual_J": 1.0, "turnover_J": 1e5,
             "residual_share": share, "impulse_residual_share": share} for t in range(60, 3660, 60)]


def verdicts(of_one):
    return [reached for _, _, reached in long.judge(of_one)]


class Long(unittest.TestCase):
    def test_rates_are_of_single_pieces(self):
        self.assertEqual(long.rates(rows(), "steps"), [20] * 59)
        self.assertAlmostEqual(long.growth(rows()), 0)

    def test_growth_compares_the_ends(self):
        self.assertGreater(long.growth(rows(steps=lambda t: 20 * t + 0.01 * t * t)), 1)
        self.assertAlmostEqual(long.growth(rows(steps=lambda t: 20 * t + (1000 if t == 60 else 0))), 0, 1)

    def test_a_quiet_hour_passes(self):
        self.assertEqual(verdicts(rows()), [True] * 4)

    def test_each_condition_can_fail(self):
        self.assertEqual(verdicts(rows(memory=lambda t: 5000 + t)), [False, True, True, True])
        self.assertEqual(verdicts(rows(share=2e-3)), [True, False, False, True])
        self.assertEqual(verdicts(rows(steps=lambda t: 20 * t + 0.01 * t * t)), [True, True, True, False])

    def test_a_tunnel_may_need_more_steps(self):
        self.assertEqual(len(verdicts(rows(scene="tunnel", steps=lambda t: t * t))), 3)

    def test_segments_that_join_need_memory(self):
        grown = rows(memory=lambda t: 5000 + t)
        grown[-1]["active"] += 300
        self.assertEqual(verdicts(grown), [True] * 4)

    def test_memory_of_the_beginning_does_not_count(self):
        self.assertEqual(long.memory_growth(rows(memory=lambda t: 1000 if t < 200 else 9000)), 0)

    def test_tables_have_all_scenes(self):
        by_scene = {"paying": rows(), "tunnel": rows("tunnel")}
        for text in (long.runs_table(by_scene), long.verdict_table(by_scene), long.balances_table(by_scene)):
            self.assertIn("paying", text)
            self.assertIn("tunnel", text)


if __name__ == "__main__":
    unittest.main()
