"""Acting on a simulation, and being called by it."""
from __future__ import annotations

import os
import subprocess

import hawser
import numpy as np
import pytest
from conftest import DATA, ROOT
from hawser.simulation import COMMANDS

CASE = str(ROOT / "python" / "notebooks" / "hold-tension.yaml")
PULL = str(DATA / "short-pull.yaml")


def hold_tension(case: str, target: float = 800, gain: float = 1e-5, belt: float = 0.1, interval: float = 0.05) -> np.ndarray:
    """Rows of time, winch force, speed: the winch's speed follows from its force; after 8 s friction rises by half."""
    rows = []
    with hawser.Simulation(case) as simulation:
        simulation.relax()
        simulation.advance(2.0)
        for k, look in enumerate(simulation.every(interval)):
            speed = min(max(belt + gain * (target - look.winch_force), 0), 2 * belt)
            rows.append((look.t, look.winch_force, speed))
            if look.t >= simulation.end_time:
                break
            if k == 120:
                simulation.control("friction", 1.5, ramp=0.5)
            simulation.control("winch_speed", speed, ramp=interval)
    return np.array(rows)


@pytest.fixture(scope="module")
def by_python() -> np.ndarray:
    return hold_tension(CASE)


def test_a_controller_is_the_same_in_python_and_in_c(by_python, tmp_path):
    library = os.environ["HAWSER_SHARED"]
    subprocess.run([os.environ.get("CC", "cc"), "-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{ROOT / 'include'}",
                    ROOT / "tests" / "python" / "hold_tension.c", "-o", tmp_path / "hold", library,
                    f"-Wl,-rpath,{os.path.dirname(library)}"], check=True)
    said = subprocess.run([tmp_path / "hold", CASE], check=True, capture_output=True, text=True).stdout
    by_c = np.array([[float(cell) for cell in line.split()] for line in said.splitlines()])
    assert by_c.shape == by_python.shape == (201, 3)
    assert np.abs(by_c - by_python).max() <= 1e-9 * 800
    assert by_python[-1, 0] == 12


def test_the_controller_holds_the_tension(by_python):
    t, force, speed = by_python.T
    assert force[0] < 600  # what conveyor and winch settle at by themselves
    assert force[(t > 5) & (t < 7.9)] == pytest.approx(800, rel=0.01)
    assert force[t > 11] == pytest.approx(800, rel=0.01)  # with half as much friction again
    assert speed[t > 11] == pytest.approx(0.1, rel=0.02)


def test_commands_are_events(pull):
    simulation = hawser.Simulation(PULL)
    simulation.advance(1.5)
    simulation.control("winch_speed", 0.2, ramp=0.25)
    simulation.control("jam", on="R15")
    simulation.advance(2.0)
    assert simulation.sample().winch_speed == pytest.approx(0.2, rel=1e-12)
    events = simulation.events
    assert list(events["t"][:2]) == [1.5, 1.5] and set(events["kind"][:1]) == {"command"}
    assert "0.2 m/s" in events["what"][0] and "R15" in events["what"][1]


def test_commands_that_are_wrong():
    simulation = hawser.Simulation(PULL)
    with pytest.raises(ValueError, match="winch_speed, winch_tension"):
        simulation.control("winch_sped", 1)
    for arguments in (dict(command="winch_speed", value=float("nan")), dict(command="jam", on="no such roller"),
                      dict(command="reel_brake", value=1), dict(command="winch_speed", value=0.1, ramp=-1)):
        with pytest.raises(hawser.CaseError):
            simulation.control(**arguments)
    assert simulation.events.empty
    assert {"winch_speed", "friction", "release"} <= set(COMMANDS)


def test_a_force_from_outside():
    """100 N backward on the last segment are 100 N more at the winch; taken away again, they are not."""
    told, free = (hawser.Simulation(PULL, set={"run.duration": "4 s"}) for _ in range(2))

    def more_at(t: float) -> float:
        told.advance(t)
        free.advance(t)
        return told.sample().winch_force - free.sample().winch_force

    told.advance(1.5)
    told.force(19, (-100, 0, 0), ramp=0.1)
    assert more_at(2.5) == pytest.approx(100, rel=0.02)
    told.force(19, None, ramp=0.1)
    assert more_at(3.5) == pytest.approx(0, abs=2)
    with pytest.raises(hawser.CaseError):
        told.force(20, (1, 0, 0))


def drag(per_speed: float, slopes: bool):
    def law(at: hawser.Segment):
        force = tuple(-per_speed * v for v in at.velocity_m_per_s)
        if not slopes:
            return force, (0, 0, 0)
        by_motion = np.zeros((6, 6))
        by_motion[:3, :3] = -per_speed * np.eye(3)
        return force, (0, 0, 0), np.zeros((6, 6)), by_motion

    return law


@pytest.mark.parametrize("slopes", [False, True])
def test_a_law_of_force_of_ones_own(slopes):
    """A drag of 50 N s/m on each of 20 segments at 0.1 m/s is 100 N more at the winch."""
    free, told = hawser.Simulation(PULL), hawser.Simulation(PULL)
    told.law(0, 20, drag(50, slopes), derivatives=slopes)
    for simulation in (free, told):
        simulation.relax()
        simulation.advance(2.0)
    assert told.sample().winch_force - free.sample().winch_force == pytest.approx(100, rel=0.03)
    told.law(0, 20, None)


def test_a_law_that_fails():
    simulation = hawser.Simulation(PULL)

    def law(at: hawser.Segment):
        simulation.sample()

    simulation.law(0, 5, law)
    with pytest.raises(RuntimeError, match="nothing else"):
        simulation.advance(0.1)
    simulation.law(0, 5, lambda at: ((0, 0), (0, 0, 0)))
    with pytest.raises(ValueError):
        simulation.advance(0.2)


def test_after_each_step():
    simulation, times = hawser.Simulation(PULL), []

    def watch(told: hawser.Simulation, t: float) -> bool:
        assert told is simulation and told.sample().t == t
        times.append(t)
        return t > 0.5

    simulation.on_step(watch)
    with pytest.raises(hawser.Stopped):
        simulation.advance(2.0)
    assert times == sorted(set(times)) and times[-1] == simulation.time > 0.5 >= times[-2]
    simulation.on_step(None)
    assert simulation.advance(1.0) == 1.0 and times[-1] < 1


def test_a_call_back_that_gives_commands():
    simulation = hawser.Simulation(PULL)

    def once(told: hawser.Simulation, t: float) -> None:
        if t > 1.2 and told.events.empty:
            told.control("winch_pause", ramp=0.1)

    simulation.on_step(once)
    result = simulation.run()
    assert result.series["winch_speed_m_per_s"].iloc[-1] == pytest.approx(0, abs=1e-12)
    assert result.events["what"].str.contains("winch_pause").any()


def test_events_and_log():
    simulation, seen, said = hawser.Simulation(PULL), [], []
    simulation.on_event(lambda told, event: seen.append(event))
    simulation.on_log(lambda level, text: said.append((level, text)))
    simulation.advance(1.2)
    simulation.control("winch_brake", ramp=0.1)
    simulation.advance(1.6)
    assert [event.kind for event in seen][:2] == ["command", "winch_stopped"]
    assert list(simulation.events["what"]) == [event.what for event in seen]
    assert said and {level for level, _ in said} <= {"error", "warning", "info"}
    with pytest.raises(ValueError, match="error, warning, info"):
        simulation.on_log(print, "loud")


def test_what_call_backs_raise():
    for register in ("on_step", "on_event", "on_log"):
        simulation = hawser.Simulation(PULL)

        def fail(*_):
            raise LookupError(register)

        getattr(simulation, register)(fail)
        with pytest.raises(LookupError, match=register):
            simulation.control("winch_speed", 0.1)
            simulation.advance(0.5)


def test_call_backs_go_with_their_simulation():
    import gc
    import weakref

    simulation = hawser.Simulation(PULL)
    handle = weakref.ref(simulation._handle)
    simulation.on_step(lambda told, t: None)
    simulation.advance(0.1)
    gc.disable()
    try:
        del simulation
        assert handle() is None  # at once, without waiting for the garbage collector
    finally:
        gc.enable()
