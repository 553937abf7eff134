"""Simulations: a case in motion, step by step or all at once."""
from __future__ import annotations

import math
import os
import pathlib
import weakref
from typing import Any, Callable, Iterator, NamedTuple, Sequence

import numpy as np

from hawser._callbacks import LEVELS, Called, Event, Segment, Teller, Wish, enum_names
from hawser._handle import Handle
from hawser._native import ffi, lib
from hawser._tables import plain
from hawser.case import Case, Settings, Source, case_of
from hawser.errors import CaseError, RunError, Stopped, c_path, c_text, check
from hawser.looking import Looking
from hawser.results import OwnFolder, Result
from hawser.sample import Sample

# What a simulation can be told: {"winch_speed": 1, ...}, as the header lists it.
COMMANDS = {name: number for number, name in enum_names("hawser_control", "HAWSER_").items()}
POLL_S = 0.1  # wall time after which a long advance lets Python look for Ctrl-C


class Relaxation(NamedTuple):
    """What the relaxation to the initial equilibrium reached."""

    reached: bool  # the residual is below the tolerance
    iterations: int  # Newton steps
    residual_N: float  # largest unbalanced force
    tolerance_N: float  # what counts as equilibrium
    segment: int  # where the residual is largest
    moved_m: float  # farthest that a segment moved from the route


class Simulation(Looking):
    """A simulation of a case (a Case, or what makes one). The case may be changed or dropped afterwards.

    threads: 1 or 2; 0: the case's choice. Results do not depend on it.

    Use it in one thread at a time, a second one is refused (RuntimeError); several simulations run side by side in several threads, as Python's lock is let go while C
    computes. Ctrl-C ends a run or an advance cleanly. Raises CaseError; RunError where the integration fails.
    """

    def __init__(self, case: Source | Case, *, set: Settings | None = None, threads: int = 0) -> None:
        made, error = ffi.new("hawser_sim **"), ffi.new("hawser_error *")
        options = ffi.new("hawser_options *", {"threads": threads})
        check(lib.hawser_sim_new(case_of(case, set)._c, options, made, error), error)
        self._handle = Handle(made[0])

    # ------------------------------------------------------------------------------------------------ life

    def close(self) -> None:
        """Lets the simulation go; its memory goes with the last array that shows it."""
        if self._handle is not None:
            with self._handle.motion:
                pass  # not while it computes
        self._handle = self._sampled = None

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------------ moving

    def relax(self) -> Relaxation:
        """Brings the cable to static equilibrium under the loads of t = 0. Not reaching it is no error: see `reached`."""
        found, handle = ffi.new("hawser_relaxation *"), self._open
        with handle.motion as c:
            handle.check(lib.hawser_sim_relax(c, found, handle.error))
        return Relaxation(**plain(found[0]))

    def step(self, until: float = math.inf) -> float:
        """One step of the integrator's own, which does not go beyond `until` (s; default: the case's end). Returns the time (s)."""
        handle = self._open
        with handle.motion as c:
            to = until if until < math.inf else max(lib.hawser_sim_end_time(c), lib.hawser_sim_time(c))
            forward(to, lib.hawser_sim_time(c), "until")
            status = lib.hawser_sim_advance(c, to, 1, handle.error)
            now: float = lib.hawser_sim_time(c)
        handle.check(status)
        return now

    def advance(self, t: float) -> float:
        """Advances to the time t (s) exactly. Returns it. Ctrl-C ends it between two steps. CaseError: t lies before now."""
        handle = self._open
        with handle.motion as c:
            forward(t, lib.hawser_sim_time(c), "t")
            handle.check(lib.hawser_python_advance(c, t, POLL_S, handle.error))
            while lib.hawser_sim_time(c) < t:
                handle.check(lib.hawser_python_advance(c, t, POLL_S, handle.error))
            now: float = lib.hawser_sim_time(c)
            return now

    def every(self, interval: float, *, until: float | None = None) -> Iterator[Sample]:
        """Samples, `interval` seconds of simulated time apart, from now to `until` (default: the case's end, s):
        for look in simulation.every(0.1): ... ValueError: the interval is not above 0; RunError: the integration failed."""
        if not interval > 0:
            raise ValueError(f"an interval of {interval} s: it must be above 0")
        start, k = self.time, 0
        yield self.sample()
        while self.time < (end := self.end_time if until is None else until):
            k += 1
            self.advance(min(start + k * interval, end))
            yield self.sample()

    def run(self, out: str | os.PathLike[str] | None = None, *, progress: Wish = False) -> Result:
        """Runs to the end of the case (relaxing first, if the case wants that), as `hawser run` does, and writes the results.

        out:      their folder; default: one of its own, which goes with the Result
        progress: True shows a line on standard error; a function is called a few times a second with a Progress, and stops the
                  run by returning True: the Result's outcome is "stopped" then
        """
        keep = OwnFolder() if out is None else None
        folder = keep.path if keep else pathlib.Path(os.fspath(out))  # type: ignore[arg-type]
        stopped: BaseException | None = None
        try:
            self._run(c_path(folder), progress)
        except (RunError, Stopped) as why:  # what was computed until then is written
            stopped = why
        return outcome(Result(folder, _keep=keep), stopped)

    def resume(self, folder: str | os.PathLike[str], *, progress: Wish = False) -> Result:
        """Goes on with a run that was stopped or killed, from the checkpoint in its folder of results, as run() would have gone on.
        The simulation is one of Case.of_run(folder); hawser.resume does both."""
        def go_on(c: Any, *call: Any) -> int:
            status: int = lib.hawser_sim_resume(c, c_path(folder), *call)
            return status

        try:
            self._go(go_on, progress)
        except (RunError, Stopped) as why:
            return outcome(Result(folder), why)
        return Result(folder)

    def run_quietly(self, *, progress: Wish = False) -> None:
        """The same as run() without results on disk: the tables, the summary and the verdict of the simulation itself tell."""
        self._run(None, progress)

    def _run(self, folder: bytes | None, progress: Wish) -> None:
        def begin(c: Any, *call: Any) -> int:
            status: int = lib.hawser_sim_run(c, ffi.NULL if folder is None else folder, *call)
            return status

        self._go(begin, progress)

    def _go(self, start: Callable[..., int], progress: Wish) -> None:
        """A run of C's, which is started with progress function, its user, and error."""
        handle, teller = self._open, Teller(progress)
        called = Called(handle, teller.tell)
        with handle.motion as c:
            status = start(c, lib.hawser_python_progress, called.user, handle.error)
        teller.end()
        handle.check(status)

    # ------------------------------------------------------------------------------------------------ keeping

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the whole state to a file, from which load() goes on bit for bit as if nothing had been (docs/guide/simulate.md)."""
        handle = self._open
        with handle as c:
            handle.check(lib.hawser_sim_save(c, c_path(path), handle.error))

    def state(self) -> bytes:
        """The same as bytes."""
        handle, made, size = self._open, ffi.new("void **"), ffi.new("size_t *")
        with handle as c:
            handle.check(lib.hawser_sim_save_memory(c, made, size, handle.error))
        try:
            return bytes(ffi.buffer(made[0], size[0]))
        finally:
            lib.hawser_bytes_free(made[0])

    def load(self, state: str | os.PathLike[str] | bytes) -> None:
        """A state, from a file or as bytes, takes the place of that of now. It must be one of the same case with the same settings."""
        handle = self._open
        with handle.motion as c:
            if isinstance(state, bytes):
                handle.check(lib.hawser_sim_load_memory(c, state, len(state), handle.error))
            else:
                handle.check(lib.hawser_sim_load(c, c_path(state), handle.error), state)

    def record(self) -> None:
        """Takes the state of now into the statistics: means of the steady window, peaks. run() does so by itself; who advances
        by himself calls it after each advance."""
        handle = self._open
        with handle.motion as c:
            lib.hawser_sim_record(c)

    def watch_envelope(self) -> None:
        """Has all that is recorded from now on go into the envelope."""
        handle = self._open
        with handle as c:
            handle.check(lib.hawser_sim_watch_envelope(c, handle.error))

    # ------------------------------------------------------------------------------------------------ acting

    def control(self, command: str, value: float = 0.0, *, on: str | None = None, ramp: float = 0.0) -> None:
        """Gives a command, which holds from now on and is an event of the run:

        "winch_speed" (m/s), "winch_tension" (N), "winch_brake", "winch_pause", "winch_restart", "conveyor_speed" (m/s),
        "conveyor_clamp" (N), "reel_brake" (N m), "jam" and "release" (a roller or conveyor), "friction" (times the case's).

        value: in the command's unit
        on:    name of the thing that is meant; of friction None means everything
        ramp:  s over which it comes in; 0: 0.2 s

        ValueError: another command; CaseError: there is no such thing, or a value that it does not take.
        """
        if command not in COMMANDS:
            raise ValueError(f"no command {command!r}: there are {', '.join(COMMANDS)}")
        handle, name = self._open, ffi.NULL if on is None else c_text(on, "on")
        with handle as c:
            handle.check(lib.hawser_sim_control(c, COMMANDS[command], name, value, ramp, handle.error))

    def force(self, segment: int, force: Sequence[float] | None, moment: Sequence[float] = (0, 0, 0), *,
              arm: Sequence[float] = (0, 0, 0), follows: bool = False, ramp: float = 0.0) -> None:
        """Puts a force (N, x y z) and a moment (N m) on a segment, in place of what was put there before; None takes it away.

        arm:     where the force acts, m from the segment's middle in its own axes (x is along it, toward the winch)
        follows: force and moment are in the segment's own axes and turn with it
        ramp:    s over which it comes in; 0: 0.2 s
        """
        handle, load = self._open, ffi.NULL
        if force is not None:
            load = ffi.new("hawser_force *", {"force_N": vector(force, "force"), "moment_N_m": vector(moment, "moment"),
                                              "arm_m": vector(arm, "arm"), "follows": follows})
        with handle as c:
            handle.check(lib.hawser_sim_force(c, segment, load, ramp, handle.error))

    def law(self, start: int, stop: int, law: Callable[[Segment], Any] | None, *, derivatives: bool = False) -> None:
        """Has a function act on the segments start .. stop-1 from now on; None: none any longer.

        law:         is shown a Segment and returns force (N) and moment (N m, about its middle), in world components. It must
                     depend on what it is shown alone: the integrator asks again, for states that are never reached
        derivatives: the function also returns two 6 x 6 matrices, of (force, moment) by shift and small turn, and by
                     velocity and omega; without, they are found by asking 24 times more
        """
        handle = self._open
        called = None if law is None else Called(handle, law)
        with handle as c:
            handle.check(lib.hawser_sim_set_law(c, start, stop, lib.hawser_python_law if called else ffi.NULL, derivatives,
                                                called.user if called else ffi.NULL, handle.error))
            handle.keep(("law", start, stop), called)

    def _call_back(self, name: str, register: Any, call: Callable[..., Any] | None, *between: Any) -> None:
        """C's function `register` gets a call-back of that name, or none any longer."""
        handle = self._open
        called = None if call is None else Called(handle, call)
        with handle as c:
            register(c, *between, getattr(lib, f"hawser_python_{name}") if called else ffi.NULL,
                     called.user if called else ffi.NULL)
            handle.keep(name, called)

    def _told(self, function: Callable[..., Any] | None) -> Callable[[Any], Any] | None:
        """The function with this simulation as its first argument, which it does not keep alive."""
        if function is None:
            return None
        this, call = weakref.ref(self), function
        return lambda what: call(this(), what)

    def on_step(self, function: Callable[[Simulation, float], Any] | None) -> None:
        """After each step of the integrator's, function(simulation, t) is called, which may look and give commands; True ends
        what is going on (hawser.Stopped). None: nobody is called."""
        self._call_back("on_step", lib.hawser_sim_on_step, self._told(function))

    def on_event(self, function: Callable[[Simulation, Event], Any] | None) -> None:
        """For each event function(simulation, event) is called, which may look; True ends what is going on."""
        self._call_back("on_event", lib.hawser_sim_on_event, self._told(function))

    def on_log(self, function: Callable[[str, str], Any] | None, level: str = "info") -> None:
        """function(level, text) is called with each line that is worth a word: "error", "warning" or "info", up to `level`. ValueError: another level."""
        if level not in LEVELS.values():
            raise ValueError(f"no level {level!r}: there are {', '.join(LEVELS.values())}")
        number = next(number for number, name in LEVELS.items() if name == level)
        self._call_back("on_log", lib.hawser_sim_on_log, function, number)

    def __repr__(self) -> str:
        if self._handle is None:
            return "<hawser simulation, closed>"
        try:
            return f"<hawser simulation of {self.title!r} at t = {self.time:.6g} s of {self.end_time:.6g} s>"
        except RuntimeError:
            return "<hawser simulation, at work>"

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("a simulation can neither be copied nor pickled: take its case and its state(), and load() that into another one")


def forward(to: float, now: float, name: str) -> None:
    """Raises CaseError where a simulation would have to go back."""
    if to < now:
        raised = CaseError(f"{name} = {to:g} s: the simulation is at {now:g} s already, and goes forward only; load() takes a state that was kept before")
        raised.key = name
        raise raised


def vector(values: Sequence[float], name: str) -> list[float]:
    """Three numbers, x y z."""
    found = np.asarray(values)
    if found.shape != (3,) or found.dtype.kind not in "iuf":
        raise CaseError(f"{name}: three numbers x, y, z are expected, not {values!r}")
    return [float(value) for value in found]


def outcome(result: Result, stopped: BaseException | None) -> Result:
    """The result, or the failure with it."""
    if isinstance(stopped, RunError):
        stopped.result = result
        raise stopped
    return result


def resume(folder: str | os.PathLike[str], *, progress: Wish = False, threads: int = 0) -> Result:
    """Goes on with a run that was stopped or killed, from the checkpoint in its folder of results: hawser run --resume."""
    return Simulation(Case.of_run(folder), threads=threads).resume(folder, progress=progress)


def run(case: Source | Case, *, set: Settings | None = None, out: str | os.PathLike[str] | None = None,
        progress: Wish = False, threads: int = 0) -> Result:
    """Simulates a pull as `hawser run` does: hawser.run("case.yaml", set={"friction.mu": 0.3}).

    case:     a Case, or what makes one: a file's path, a text, a dict
    set:      changes by dotted key: {"drive.winch.speed": "3 m/min"}
    out:      folder of the results; default: one of its own, which goes with the Result (Result.save keeps it)
    progress: True, or a function that is called with a Progress and may stop the run by returning True
    threads:  1 or 2; 0: the case's choice

    Raises CaseError before anything is computed or written, RunError (with `.result`, what was computed until then) where
    the integration fails, OutputError where results cannot be written. Ctrl-C raises KeyboardInterrupt; what was computed
    until then is in `out`.
    """
    return Simulation(case, set=set, threads=threads).run(out, progress=progress)
