"""Simulations: a case in motion, step by step or all at once."""
from __future__ import annotations

import json
import math
import os
import pathlib
import sys
import tempfile
import threading
from typing import Any, Callable, Iterator, NamedTuple, Union

import numpy as np
import pandas as pd

from hawser._declared import MEMBERS
from hawser._native import ffi, lib
from hawser._tables import frame, plain, view
from hawser.case import Case, Settings, Source, case_of
from hawser.errors import RunError, Stopped, check, error_from, taken, text_of
from hawser.results import Result, Verdict

Array = np.ndarray[Any, np.dtype[np.float64]]

POLL_S = 0.1  # wall time after which a long advance lets Python look for Ctrl-C


class Handle:
    """The C simulation: freed when neither the Simulation nor any array of it is left. One thread at a time: `with handle as
    c:` refuses a second one instead of waiting for it."""

    def __init__(self, c: Any) -> None:
        self.c = ffi.gc(c, lib.hawser_sim_free)
        self.moved = 0  # counts what makes older samples invalid
        self._lock = threading.Lock()

    def __enter__(self) -> Any:
        if not self._lock.acquire(False):
            raise RuntimeError("this simulation is at work in another call: one thread uses it at a time")
        return self.c

    def __exit__(self, *_: object) -> None:
        self._lock.release()


class Progress(NamedTuple):
    """What a progress function is told."""

    t: float  # s
    end: float  # s, the run's end
    wall: float  # s since the run began
    step: float  # s, the integrator's last
    winch_force: float  # N


class Relaxation(NamedTuple):
    """What the relaxation to the initial equilibrium reached."""

    reached: bool  # the residual is below the tolerance
    iterations: int  # Newton steps
    residual_N: float  # largest unbalanced force
    tolerance_N: float  # what counts as equilibrium
    segment: int  # where the residual is largest
    moved_m: float  # farthest that a segment moved from the route


# The arrays of a sample: how many rows, and how many numbers in each (0: the rows are the numbers).
SHAPES = {"position": ("segments", 3), "quaternion": ("segments", 4), "velocity": ("segments", 3), "omega": ("segments", 3),
          "tension": ("joints", 0), "axial_speed": ("segments", 0), "roller_load": ("rollers", 0),
          "roller_spin": ("rollers", 0), "roller_shift": ("rollers", 0), "surface_normal": ("surfaces", 0),
          "surface_friction": ("surfaces", 0), "surface_line_load": ("surfaces", 0), "surface_at": ("surfaces", 0),
          "curvature": ("joints", 0), "sidewall": ("joints", 0), "contact_line_load": ("segments", 0),
          "roller_force": ("rollers", 3)}


class Sample:
    """One look at a simulation, in SI units and world components.

    It is good until the simulation moves on: then its members raise RuntimeError. Arrays are views of the simulation's
    own memory: they cannot be written, are never copied, keep it alive, and show its latest sample; copy what is to be kept
    (as_dict copies everything).
    """

    __slots__ = ("_handle", "_c", "_moved")

    t: float  # s
    segments: int
    joints: int
    rollers: int
    surfaces: int
    first: int
    active: int
    winch_force: float  # N
    tail_tension: float  # N
    winch_speed: float  # m/s
    winch_travel: float  # m
    max_tension: float  # N
    max_tension_joint: int
    active_contacts: int
    reel_speed: float  # rad/s
    paid_out: float  # m
    wound: float  # m
    head_at: float  # m
    reference: float  # N
    step_size: float  # s
    position: Array  # [segments, 3], m
    quaternion: Array  # [segments, 4], w x y z
    velocity: Array  # [segments, 3], m/s
    omega: Array  # [segments, 3], rad/s
    tension: Array  # [joints], N
    axial_speed: Array  # [segments], m/s
    roller_load: Array  # [rollers], N
    roller_spin: Array  # [rollers], rad/s
    roller_shift: Array  # [rollers], m
    surface_normal: Array  # [surfaces], N
    surface_friction: Array  # [surfaces], N
    surface_line_load: Array  # [surfaces], N/m
    surface_at: Array  # [surfaces], m along the route
    curvature: Array  # [joints], 1/m
    sidewall: Array  # [joints], N/m
    contact_line_load: Array  # [segments], N/m
    roller_force: Array  # [rollers, 3], N

    def __init__(self, handle: Handle, c: Any) -> None:
        self._handle = handle
        self._c = c
        self._moved = handle.moved

    def _now(self) -> Any:
        if self._moved != self._handle.moved:
            raise RuntimeError("the simulation has moved on since this sample: take a new one, or copy what is to be kept")
        return self._c

    @property
    def machines(self) -> dict[str, dict[str, float]]:
        """What conveyors, motors and the like show now: {name: {figure with its unit: value}}."""
        c = self._now()
        return {text_of(machine.name): figures(machine.now, machine.n_now)
                for machine in (c.machine[i] for i in range(c.machines))}

    @property
    def probes(self) -> dict[str, dict[str, Any]]:
        """The named places of the chain: position, displacement (m), rotation (rad), force (N), moment (N m)."""
        c = self._now()
        return {text_of(c.probe[i].name): plain(c.probe[i]) for i in range(c.probes)}

    def as_dict(self) -> dict[str, Any]:
        """A copy of everything, which stays."""
        found = {name: getattr(self, name) for name in Sample.__annotations__}
        return {**{name: np.array(value) if name in SHAPES else value for name, value in found.items()},
                "machines": self.machines, "probes": self.probes}

    def __repr__(self) -> str:
        return f"<hawser sample at t = {self.t:.6g} s: winch {self.winch_force:.6g} N>"


def number_of(name: str) -> property:
    def get(sample: Sample) -> Any:
        return getattr(sample._now(), name)

    return property(get, doc=MEMBERS["hawser_sample"].get(name))


def array_of(name: str) -> property:
    rows, width = SHAPES[name]
    field = name in MEMBERS["hawser_fields"]

    def get(sample: Sample) -> Any:
        c = sample._now()
        n = getattr(c, rows)
        return view(sample._handle, getattr(c.field if field else c, name), *((n, width) if width else (n,)))

    return property(get, doc=MEMBERS["hawser_fields" if field else "hawser_sample"][name])


for _name in Sample.__annotations__:
    setattr(Sample, _name, array_of(_name) if _name in SHAPES else number_of(_name))


def figures(figure: Any, n: int) -> dict[str, float]:
    return {text_of(figure[i].key): figure[i].value for i in range(n)}


class Simulation:
    """A simulation of a case (a Case, or what makes one). The case may be changed or dropped afterwards.

    threads: 1 or 2; 0: the case's choice. Results do not depend on it.

    Use it in one thread at a time; several simulations run side by side in several threads, as Python's lock is let go while C
    computes. Ctrl-C ends a run or an advance cleanly. Raises CaseError; RunError where the integration fails.
    """

    def __init__(self, case: Source | Case, *, set: Settings | None = None, threads: int = 0) -> None:
        made, self._error = ffi.new("hawser_sim **"), ffi.new("hawser_error *")
        options = ffi.new("hawser_options *", {"threads": threads})
        check(lib.hawser_sim_new(case_of(case, set)._c, options, made, self._error), self._error)
        self._handle: Handle | None = Handle(made[0])

    # ------------------------------------------------------------------------------------------------ life

    @property
    def _open(self) -> Handle:
        if self._handle is None:
            raise RuntimeError("this simulation was closed")
        return self._handle

    def close(self) -> None:
        """Lets the simulation go; its memory goes with the last array that shows it."""
        if self._handle is not None:
            with self._handle:
                pass  # not while another thread computes
        self._handle = None

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # ------------------------------------------------------------------------------------------------ moving

    def relax(self) -> Relaxation:
        """Brings the cable to static equilibrium under the loads of t = 0. Not reaching it is no error: see `reached`."""
        found = ffi.new("hawser_relaxation *")
        handle = self._open
        with handle as c:
            handle.moved += 1
            check(lib.hawser_sim_relax(c, found, self._error), self._error)
        return Relaxation(**plain(found[0]))

    def step(self, until: float = math.inf) -> float:
        """One step of the integrator's own, which does not go beyond `until` (s; default: the case's end). Returns the time (s)."""
        handle = self._open
        with handle as c:
            handle.moved += 1
            if until == math.inf:
                until = lib.hawser_sim_end_time(c)
            status = lib.hawser_sim_advance(c, until, 1, self._error)
            if status:
                raise error_from(status, text_of(self._error.message))
            now: float = lib.hawser_sim_time(c)
            return now

    def advance(self, t: float) -> float:
        """Advances to the time t (s) exactly. Returns it. Ctrl-C ends it between two steps."""
        handle = self._open
        with handle as c:
            handle.moved += 1
            check(lib.hawser_python_advance(c, t, POLL_S, self._error), self._error)
            while lib.hawser_sim_time(c) < t:
                check(lib.hawser_python_advance(c, t, POLL_S, self._error), self._error)
            now: float = lib.hawser_sim_time(c)
            return now

    def every(self, interval: float, *, until: float | None = None) -> Iterator[Sample]:
        """Samples, `interval` seconds of simulated time apart, from now to `until` (default: the case's end, s):
        for look in simulation.every(0.1): ..."""
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
        keep = tempfile.TemporaryDirectory(prefix="hawser-") if out is None else None
        folder = pathlib.Path(keep.name if keep else os.fspath(out))  # type: ignore[arg-type]
        stopped: BaseException | None = None
        try:
            self._run(os.fsencode(folder), progress)
        except (RunError, Stopped) as why:  # what was computed until then is written
            stopped = why
        result = Result(folder, _keep=keep)
        if isinstance(stopped, RunError):
            stopped.result = result
            raise stopped
        return result

    def run_quietly(self, *, progress: Wish = False) -> None:
        """The same without results on disk: the tables, the summary and the verdict of the simulation itself tell."""
        self._run(None, progress)

    def _run(self, folder: bytes | None, progress: Wish) -> None:
        handle, teller = self._open, Teller(progress)
        user = ffi.new_handle(teller)
        with handle as c:
            handle.moved += 1
            status = lib.hawser_sim_run(c, ffi.NULL if folder is None else folder, lib.hawser_python_progress, user,
                                        self._error)
            handle.moved += 1
        teller.end()
        if teller.raised is not None:
            raise teller.raised
        check(status, self._error)

    # ------------------------------------------------------------------------------------------------ looking

    @property
    def time(self) -> float:
        """Where it is, s."""
        return float(lib.hawser_sim_time(self._open.c))

    @property
    def end_time(self) -> float:
        """The case's duration, s; earlier once a winch that tripped has ended the run."""
        return float(lib.hawser_sim_end_time(self._open.c))

    @property
    def title(self) -> str:
        """The case's title, or its file's name."""
        return text_of(lib.hawser_sim_title(self._open.c))

    def sample(self) -> Sample:
        """How everything is now."""
        handle = self._open
        with handle as c:
            handle.moved += 1
            return Sample(handle, lib.hawser_sim_sample(c))

    def record(self) -> None:
        """Takes the state of now into the statistics: means of the steady window, peaks. run() does so by itself; who advances
        by himself calls it after each advance."""
        handle = self._open
        with handle as c:
            handle.moved += 1
            lib.hawser_sim_record(c)

    def _table(self, call: Any, struct: str, rename: dict[str, str] | None = None) -> pd.DataFrame:
        rows, summary = ffi.new(f"const {struct} **"), ffi.new("hawser_summary *")
        with self._open as c:
            lib.hawser_sim_summary(c, summary)  # brings the rows' error bars up to date
            n = call(c, rows)
            return frame(struct, rows[0], n, rename)

    @property
    def stations(self) -> pd.DataFrame:
        """Tension along the route so far: name, s_m, paper_N, reference_N, mean_N, peak_N, mean_error_N, peak_error_N."""
        return self._table(lib.hawser_sim_stations, "hawser_station", {"s": "s_m"})

    @property
    def rollers(self) -> pd.DataFrame:
        """The rollers so far: name, s_m, rating_N, initial_N, steady_N, peak_N and more."""
        return self._table(lib.hawser_sim_rollers, "hawser_roller", {"s": "s_m"})

    @property
    def surfaces(self) -> pd.DataFrame:
        """Ducts, trays, floors and walls so far: normal_N, friction_N, line_load_N_per_m and more."""
        return self._table(lib.hawser_sim_surfaces, "hawser_surface")

    @property
    def events(self) -> pd.DataFrame:
        """What happened so far: t (s), what, pull_N."""
        return self._table(lib.hawser_sim_events, "hawser_event")

    @property
    def positions(self) -> pd.DataFrame:
        """The pull by place of the cable's front so far: head_m, pull_N, reference_N, error_pct."""
        return self._table(lib.hawser_sim_positions, "hawser_position")

    @property
    def modes(self) -> pd.DataFrame:
        """Vibrations: frequency_Hz, growth_per_s, omega_squared (1/s2); none before the end of a run with `analysis: modes`."""
        return self._table(lib.hawser_sim_modes, "hawser_mode")

    @property
    def assumptions(self) -> pd.DataFrame:
        """Values that the case did not give itself: key, value, origin ("given", "catalogue", "estimated"), source."""
        return self._table(lib.hawser_sim_assumptions, "hawser_assumption")

    @property
    def machines(self) -> dict[str, dict[str, float]]:
        """What conveyors, motors and the like have done so far: {name: {figure with its unit: value}}."""
        rows = ffi.new("const hawser_machine **")
        with self._open as c:
            n = lib.hawser_sim_machines(c, rows)
            return {text_of(rows[0][i].name): figures(rows[0][i].figure, rows[0][i].n_figures) for i in range(n)}

    @property
    def limits(self) -> pd.DataFrame:
        """The limits of the case, judged by what has been recorded so far: name, value, limit, unit, margin, ok (None: not
        judged), where, source."""
        rows = ffi.new("hawser_limit[]", lib.HAWSER_LIMITS_MAX)
        with self._open as c:
            table = frame("hawser_limit", rows, lib.hawser_sim_limits(c, rows))
        table["ok"] = [bool(ok) if judged else None for ok, judged in zip(table["ok"], table["judged"])]
        return table

    @property
    def trust(self) -> pd.DataFrame:
        """The conditions under which the run is worth judging: name, unit, value, allowed, holds, remedy."""
        summary = ffi.new("hawser_summary *")
        with self._open as c:
            lib.hawser_sim_summary(c, summary)
            return frame("hawser_condition", summary.conditions, summary.n_conditions)

    @property
    def verdict(self) -> Verdict:
        """Whether the pull is safe by what has been recorded so far."""
        limits, summary = ffi.new("hawser_limit[]", lib.HAWSER_LIMITS_MAX), ffi.new("hawser_summary *")
        text = ffi.new("char[]", lib.HAWSER_VERDICT_MAX)
        with self._open as c:
            lib.hawser_sim_summary(c, summary)
            lib.hawser_verdict(summary.n_conditions, summary.conditions, lib.hawser_sim_limits(c, limits), limits, text,
                               lib.HAWSER_VERDICT_MAX)
        return Verdict(text_of(text))

    @property
    def answer(self) -> str:
        """The verdict with what it rests on, as a report begins."""
        text = ffi.new("char[]", lib.HAWSER_ANSWER_MAX)
        with self._open as c:
            return text_of(lib.hawser_sim_answer(c, lib.HAWSER_SI, text, lib.HAWSER_ANSWER_MAX))

    @property
    def summary(self) -> dict[str, Any]:
        """The run so far in numbers, as summary.json has it; what is not known is None."""
        text = ffi.new("char **")
        with self._open as c:
            check(lib.hawser_sim_summary_json(c, text, self._error), self._error)
        found: dict[str, Any] = json.loads(taken(text))
        return found

    def __repr__(self) -> str:
        if self._handle is None:
            return "<hawser simulation, closed>"
        return f"<hawser simulation of {self.title!r} at t = {self.time:.6g} s of {self.end_time:.6g} s>"


Wish = Union[bool, Callable[[Progress], Any]]


class Teller:
    """Between C's progress call-back and who wants to know; keeps what was raised meanwhile (Ctrl-C above all)."""

    def __init__(self, wish: Wish) -> None:
        self.wish = wish
        self.raised: BaseException | None = None
        self.tenth = -1
        self.live = sys.stderr.isatty()

    def tell(self, now: Progress) -> bool:
        """True: stop."""
        if callable(self.wish):
            return bool(self.wish(now))
        if self.wish:
            self.show(now)
        return False

    def show(self, now: Progress) -> None:
        """A line that is written over, on a terminal; elsewhere one every tenth of the run."""
        share = now.t / now.end if now.end > 0 else 1.0
        if not self.live and int(10 * share) == self.tenth:
            return
        self.tenth = int(10 * share)
        line = f"t = {now.t:.2f} s of {now.end:g} s, {100 * share:3.0f} %, step {1e3 * now.step:.3g} ms, {now.wall:.1f} s"
        print(f"\r{line}\033[K" if self.live else line, end="" if self.live else "\n", file=sys.stderr, flush=True)

    def end(self) -> None:
        if self.wish is True and self.live and self.tenth >= 0:
            print(file=sys.stderr)


def keep_raised(_: Any, error: BaseException, trace: Any) -> int:
    """What a call-back raises waits until C has ended, which it is asked to do."""
    ffi.from_handle(trace.tb_frame.f_locals["user"]).raised = error
    return 1


@ffi.def_extern(name="hawser_python_progress", error=1, onerror=keep_raised)  # type: ignore[misc]
def _progress(user: Any, sample: Any, wall: float, end: float) -> int:
    teller: Teller = ffi.from_handle(user)
    return int(teller.tell(Progress(sample.t, end, wall, sample.step_size, sample.winch_force)))


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
