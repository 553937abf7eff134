"""Simulations step by step; views of their memory; threads."""
from __future__ import annotations

import gc
import threading
import weakref

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT
from hawser._native import ffi


def test_by_hand_is_as_at_once(pull):
    """The statistics of steps by hand, recorded where a run records, are a run's."""
    at_once, by_hand = hawser.Simulation(pull), hawser.Simulation(pull)
    at_once.run_quietly()
    assert by_hand.relax().reached
    for _ in by_hand.every(0.05):
        by_hand.record()
    assert by_hand.time == 2 == by_hand.end_time
    first, second = at_once.stations, by_hand.stations
    assert second["mean_N"].to_numpy() == pytest.approx(first["mean_N"].to_numpy(), rel=1e-3)
    assert by_hand.verdict.word == at_once.verdict.word


def test_an_advance_takes_the_same_steps_in_one_call_or_many(pull):
    whole, parts = hawser.Simulation(pull), hawser.Simulation(pull)
    whole.relax()
    parts.relax()
    whole.advance(2.0)
    while parts.time < 2.0:
        parts.step(2.0)
    assert np.array_equal(whole.sample().position, parts.sample().position)
    assert whole.sample().winch_force == parts.sample().winch_force


def test_tables_of_a_simulation_are_those_of_its_results():
    simulation = hawser.Simulation(DATA / "limits.yaml")
    result = simulation.run()
    for live, kept in ((simulation.stations, result.stations), (simulation.rollers, result.rollers)):
        common = [name for name in live.columns if name in kept.columns and name != "name" and "error" not in name]
        assert {"s_m", "peak_N"} <= set(common)
        assert list(live["name"]) == list(kept["name"])
        for name in common:
            assert live[name].to_numpy(float) == pytest.approx(kept[name].to_numpy(float), rel=1e-7, nan_ok=True), name
    live, kept = simulation.limits.set_index("name"), result.limits.set_index("name")
    assert list(live.index) == list(kept.index) and list(live["ok"]) == list(kept["ok"])
    assert live["value"].to_numpy() == pytest.approx(kept["value"].to_numpy(), rel=1e-8, nan_ok=True)
    assert simulation.verdict == result.verdict and str(simulation.verdict).split("; ")[0] in " ".join(simulation.answer.split())
    assert list(simulation.trust["name"]) == list(result.trust["name"])
    assert simulation.summary["steps"] == result.summary["steps"]
    assert simulation.stations.attrs["columns"]["reference_N"] == "by the bend ODE"


def test_machines_and_surfaces():
    simulation = hawser.Simulation(DATA / "limits-conveyor.yaml")
    result = simulation.run()
    done = simulation.machines["K"]
    kept = result.conveyors.set_index("name").loc["K"]
    assert done["steady_mean_N"] == pytest.approx(kept["steady_mean_N"]) and kept["steady_mean_N"] > 0
    assert simulation.sample().machines["K"]["force_N"] == pytest.approx(result.series["K_force_N"].iloc[-1])
    simulation = hawser.Simulation(DATA / "picture.yaml")
    simulation.run_quietly()
    assert list(simulation.surfaces["kind"]) == ["duct", "plane"]
    assert simulation.surfaces["normal_N"][0] > 0


def test_probes_and_modes():
    simulation = hawser.Simulation(ROOT / "cases" / "rod-modes.yaml")
    simulation.run_quietly()
    assert simulation.modes["frequency_Hz"].is_monotonic_increasing
    assert all(len(probe["position"]) == 3 for probe in simulation.sample().probes.values())


# ------------------------------------------------------------------------------------------------------- views


def test_arrays_are_views_that_cannot_be_written(pull):
    simulation = hawser.Simulation(pull)
    simulation.relax()
    look = simulation.sample()
    assert look.position.shape == (20, 3) and look.tension.shape == (21,) and look.quaternion.shape == (20, 4)
    assert look.position.ctypes.data == int(ffi.cast("uintptr_t", look._c.position))
    assert not look.position.flags.writeable
    with pytest.raises(ValueError):
        look.tension[0] = 1
    assert look.roller_force.shape == (look.rollers, 3)
    assert np.linalg.norm(look.roller_force, axis=1) == pytest.approx(look.roller_load)
    assert look.roller_spin.size == 0  # no roller of this case moves


def test_a_view_shows_the_latest_sample(pull):
    simulation = hawser.Simulation(pull)
    simulation.relax()
    x = simulation.sample().position[:, 0]
    before, kept = x.copy(), simulation.sample().as_dict()
    simulation.advance(2)
    simulation.sample()
    assert x - before == pytest.approx(np.full(20, 0.15), rel=0.02)
    assert np.array_equal(kept["position"][:, 0], before) and kept["t"] == 0


@pytest.mark.parametrize("move", [lambda s: s.step(), lambda s: s.advance(0.1), lambda s: s.sample(), lambda s: s.record(),
                                  lambda s: s.run_quietly()])
def test_a_sample_that_was_overwritten_says_so(pull, move):
    simulation = hawser.Simulation(pull)
    look = simulation.sample()
    assert look.t == 0
    move(simulation)
    for name in ("t", "position", "machines"):
        with pytest.raises(RuntimeError, match="moved on"):
            getattr(look, name)


@pytest.mark.parametrize("leave", ["close", "drop"])
def test_a_view_keeps_its_memory(pull, leave):
    simulation = hawser.Simulation(pull)
    handle = weakref.ref(simulation._handle)
    tension = simulation.sample().tension[3:5]
    before = tension.copy()
    if leave == "close":
        simulation.close()
        with pytest.raises(RuntimeError, match="closed"):
            simulation.time
    del simulation
    gc.collect()
    others = [hawser.Simulation(pull) for _ in range(20)]  # who would take the memory if it were free
    assert np.array_equal(tension, before)
    assert handle() is not None
    del tension, others
    gc.collect()
    assert handle() is None


def test_a_simulation_as_a_context(pull):
    with hawser.Simulation(pull) as simulation:
        simulation.step()
    assert repr(simulation) == "<hawser simulation, closed>"
    with pytest.raises(RuntimeError, match="closed"):
        simulation.step()


# ------------------------------------------------------------------------------------------------------- threads


def test_python_goes_on_while_c_computes():
    """Work of C that comes back to Python only every quarter of a second; this thread counts meanwhile."""
    simulation = hawser.Simulation(DATA / "running-pull.yaml", set={"run.duration": "60 s"})
    counted, worker = 0, threading.Thread(target=simulation.run_quietly)
    worker.start()
    while worker.is_alive() and counted < 100_000:
        counted += 1
    simulating = worker.is_alive()
    worker.join()
    assert counted == 100_000 and simulating


def test_simulations_side_by_side(pull):
    settings = [{"friction.mu": mu} for mu in (0.1, 0.2, 0.3, 0.4)]
    alone = [hawser.run(pull, set=s).series["winch_force_N"].tolist() for s in settings]
    together: dict[int, list[float]] = {}

    def work(k: int) -> None:
        together[k] = hawser.run(pull, set=settings[k]).series["winch_force_N"].tolist()

    workers = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert [together[k] for k in range(4)] == alone


def test_a_second_thread_is_refused(pull):
    simulation, said = hawser.Simulation(pull), []

    def interfere() -> None:
        for call in (simulation.step, simulation.sample, simulation.close, lambda: simulation.summary):
            try:
                call()
            except RuntimeError as error:
                said.append(str(error))

    def from_elsewhere(now: hawser.Progress) -> None:
        other = threading.Thread(target=interfere)
        other.start()
        other.join()

    simulation.run(progress=from_elsewhere)
    assert len(said) >= 4 and all("one thread uses it at a time" in text for text in said)


def test_a_call_back_may_look_but_not_move(pull):
    simulation, seen, said = hawser.Simulation(pull), [], []

    def look(now: hawser.Progress) -> None:
        seen.append(simulation.sample().t)
        for call in (simulation.step, simulation.run_quietly, simulation.close, simulation.record):
            try:
                call()
            except RuntimeError as error:
                said.append(str(error))

    simulation.run(progress=look)
    assert seen[0] == 0 and seen[-1] == 2
    assert len(said) == 4 * len(seen) and all("not move its simulation" in text for text in said)


def test_wrong_order_and_wrong_numbers(pull):
    simulation = hawser.Simulation(pull)
    simulation.advance(0.1)
    with pytest.raises(hawser.CaseError, match="relaxed"):
        simulation.relax()
    with pytest.raises(hawser.CaseError, match="threads"):
        hawser.Simulation(pull, threads=7)
    with pytest.raises(ValueError, match="interval"):
        next(simulation.every(0))
    for back in (lambda: simulation.advance(0.05), lambda: simulation.step(0.05)):
        with pytest.raises(hawser.CaseError, match="at 0.1 s already") as found:  # returned 0.1, as if it had been done
            back()
    assert found.value.key == "until" and simulation.time == 0.1 == simulation.advance(0.1)


def test_two_threads_of_c_give_the_same(pull):
    one, two = (hawser.run(pull, threads=n).series for n in (1, 2))
    assert one.drop(columns="step_size_s").equals(two.drop(columns="step_size_s"))
