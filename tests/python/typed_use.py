"""Not run, but read by mypy: how a user's own typed program uses the package."""
from __future__ import annotations

import numpy as np

import hawser


def peak(path: str, friction: float) -> float:
    result: hawser.Result = hawser.run(path, set={"friction.mu": friction}, progress=lambda now: now.t > 10)
    safe: bool | None = result.verdict.safe
    return float(result.series["winch_force_N"].max()) if safe else np.nan


def forces(case: hawser.Case) -> list[float]:
    with hawser.Simulation(case, threads=2) as simulation:
        found = [look.winch_force for look in simulation.every(0.1, until=2.0)]
        return [*found, float(simulation.sample().tension.max())]
