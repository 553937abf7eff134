"""Keeping a simulation's state, and going on from it."""
from __future__ import annotations

import subprocess
import sys

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT


def history(simulation: hawser.Simulation, until: float) -> np.ndarray:
    return np.array([(look.t, look.winch_force, look.max_tension) for look in simulation.every(0.1, until=until)])


@pytest.mark.parametrize("where", ["file", "memory"])
def test_it_goes_on_as_if_nothing_had_been(pull, tmp_path, where):
    simulation = hawser.Simulation(pull)
    simulation.relax()
    simulation.advance(0.8)
    state = tmp_path / "state" if where == "file" else simulation.state()
    if where == "file":
        simulation.save(state)
    expected = history(simulation, 2.0)
    again = hawser.Simulation(pull)
    again.load(state)
    assert again.time == 0.8
    assert np.array_equal(history(again, 2.0), expected)
    again.load(state)  # as often as one likes
    assert np.array_equal(history(again, 2.0), expected)


def test_a_sample_ends_with_a_load(pull):
    simulation = hawser.Simulation(pull)
    state, look = simulation.state(), simulation.sample()
    simulation.load(state)
    with pytest.raises(RuntimeError, match="moved on"):
        look.t


def test_what_is_no_state_of_this_case(pull, tmp_path):
    simulation = hawser.Simulation(pull)
    simulation.advance(0.5)
    before = simulation.sample().winch_force
    for wrong in (b"", b"nothing like it", hawser.Simulation(pull, set={"friction.mu": 0.3}).state(), tmp_path / "none"):
        with pytest.raises(hawser.CaseError):
            simulation.load(wrong)
    assert simulation.sample().winch_force == before
    with pytest.raises(hawser.OutputError):
        simulation.save(tmp_path / "none" / "state")


def test_a_killed_run_is_resumed(tmp_path):
    """In a process of its own, killed where Python cannot notice; resumed, its tables are those of a run that was left alone."""
    case = {"run.checkpoint": "100 ms", "run.duration": "6 s"}
    text = "import hawser; hawser.run(%r, set=%r, out=%r, progress=lambda now: print(now.t, flush=True))"
    path = str(ROOT / "cases" / "limits.yaml")
    child = subprocess.Popen([sys.executable, "-c", text % (path, case, str(tmp_path / "out"))], stdout=subprocess.PIPE, text=True)
    while float(child.stdout.readline() or 9) < 1:
        pass
    child.kill()
    child.wait()
    child.stdout.close()
    resumed = hawser.resume(tmp_path / "out")
    alone = hawser.run(path, set=case, out=tmp_path / "alone")
    assert resumed.outcome == alone.outcome == "finished"
    for name in ("series.csv", "stations.csv", "rollers.csv"):
        assert (resumed.folder / name).read_bytes() == (alone.folder / name).read_bytes(), name
    with pytest.raises(hawser.CaseError):
        hawser.resume(tmp_path)
