"""Many pulls in four Python threads over shared cases: each gives the bits that it gives alone. For builds with sanitizers
(scripts/python_pulls.sh), whose reports end the program.

Usage: pulls.py PULLS [SECONDS]      as many as asked for, or as fit into so many seconds of processor time
"""
from __future__ import annotations

import itertools
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import hawser

THREADS = 4
CABLE = {"EA": "50 MN", "GA": "20 MN", "GJ": "8 kN m2", "EI": "10 kN m2", "d": "90 mm", "mass": "20 kg/m"}


def case_of(length: int) -> hawser.Case:
    return hawser.Case({"cables": {"c": CABLE}, "chain": [{"cable": "c", "length": f"{length} m", "segment": "1 m"}],
                        "route": {"head_at": f"{length} m", "pieces": [{"straight": f"{length + 1} m"}]},
                        "rollers": {"along": {"from": 0, "to": f"{length + 1} m", "spacing": "1 m"}},
                        "drive": {"winch": {"speed": "0.5 m/s", "to": "10 ms"}, "tail": {"tension": "1 kN", "ramp": "none"}},
                        "run": {"duration": "20 ms", "steady_from": "10 ms"}, "solver": {"passes": 1, "relax": False}})


def pull(case: hawser.Case, mu: float) -> tuple[bytes, float, float]:
    """Positions at the end, pull and time; every second friction in a set copy, the others by set=."""
    simulation = (hawser.Simulation(case.copy().set({"friction.mu": mu})) if int(20 * mu) % 2 else
                  hawser.Simulation(case, set={"friction.mu": mu}))
    simulation.run_quietly()
    sample = simulation.sample()
    return sample.position.tobytes(), sample.winch_force, simulation.time


def main(pulls: int, seconds: float) -> int:
    kinds = list(itertools.product([case_of(2), case_of(3)], (0.1, 0.15, 0.2, 0.25)))
    alone = [pull(case_of(2 if case is kinds[0][0] else 3), mu) for case, mu in kinds]
    assert len(set(alone)) == len(alone)
    numbers, done, wrong = itertools.count(), [0] * THREADS, [0] * THREADS

    def work(thread: int) -> None:
        while (k := next(numbers)) < pulls and time.process_time() < seconds:
            wrong[thread] += pull(*kinds[k % len(kinds)]) != alone[k % len(kinds)]
            done[thread] += 1

    with ThreadPoolExecutor(THREADS) as pool:
        list(pool.map(work, range(THREADS)))
    print(f"{sum(done)} pulls in {THREADS} threads, {sum(wrong)} unlike those alone, {time.process_time():.0f} s of processor time")
    return 1 if sum(wrong) or not sum(done) else 0


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else float("inf")))
