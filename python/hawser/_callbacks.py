"""From C back into Python. What a Python function raises waits in the simulation's handle until C has returned, which it is asked
to do at once: so Ctrl-C ends a run cleanly, too."""
from __future__ import annotations

import sys
import weakref
from typing import Any, Callable, NamedTuple, Union

import numpy as np

from hawser._handle import Handle
from hawser._native import ffi, lib
from hawser._tables import plain
from hawser.errors import text_of

Vector = tuple[float, float, float]


class Progress(NamedTuple):
    """What a progress function is told."""

    t: float  # s
    end: float  # s, the run's end
    wall: float  # s since the run began
    step: float  # s, the integrator's last
    winch_force: float  # N


class Event(NamedTuple):
    """Something that happened."""

    t: float  # s
    what: str  # in words
    kind: str  # "winch_trips", "jam", "command" ...
    pull_N: float  # on the rope's end then


class Segment(NamedTuple):
    """A segment as a law of force is shown it; world components."""

    segment: int  # of the whole chain, from the tail
    t: float  # s
    length_m: float  # unstretched
    mass_kg: float
    position_m: Vector  # of its middle
    quaternion: tuple[float, float, float, float]  # w x y z, its own axes to the world's
    velocity_m_per_s: Vector
    omega_rad_per_s: Vector


class Called:
    """A Python function that C calls for a simulation. C gets `user`, and calls it as long as this object is there."""

    def __init__(self, handle: Handle, call: Callable[..., Any]) -> None:
        self.handle = weakref.ref(handle)
        self.call = call
        self.user = ffi.new_handle(self)


def enum_names(enum: str, prefix: str) -> dict[int, str]:
    """{number: name} of an enum of the headers, in small letters and without what all names begin with."""
    return {number: name[len(prefix):].lower() for number, name in sorted(ffi.typeof(enum).elements.items())}


EVENTS = enum_names("hawser_event_code", "HAWSER_EVENT_")
LEVELS = enum_names("hawser_log_level", "HAWSER_LOG_")


def event_kind(code: int) -> str:
    """A command's code is that of commands and its own number."""
    return EVENTS.get(code) or (EVENTS[lib.HAWSER_EVENT_COMMAND] if code > lib.HAWSER_EVENT_COMMAND else str(code))


def keep_raised(_: Any, error: BaseException, trace: Any) -> int:
    handle = ffi.from_handle(trace.tb_frame.f_locals["user"]).handle()
    if handle.raised is None:
        handle.raised = error
    return 1


def from_c(name: str) -> Any:
    """The function that C knows as hawser_python_NAME; 1 stops what is going on."""
    return ffi.def_extern(name=f"hawser_python_{name}", error=1, onerror=keep_raised)


@from_c("progress")  # type: ignore[misc]
def _progress(user: Any, sample: Any, wall: float, end: float) -> int:
    return bool(ffi.from_handle(user).call(Progress(sample.t, end, wall, sample.step_size, sample.winch_force)))


@from_c("on_step")  # type: ignore[misc]
def _on_step(user: Any, _: Any, t: float) -> int:
    called = ffi.from_handle(user)
    called.handle().moved += 1
    return bool(called.call(t))


@from_c("on_event")  # type: ignore[misc]
def _on_event(user: Any, _: Any, event: Any) -> int:
    called = ffi.from_handle(user)
    called.handle().moved += 1
    return bool(called.call(Event(event.t, text_of(event.what), event_kind(event.code), event.pull_N)))


@ffi.def_extern(name="hawser_python_on_log", onerror=lambda *args: keep_raised(*args) and None)  # type: ignore[misc]
def _on_log(user: Any, level: int, text: Any) -> None:
    ffi.from_handle(user).call(LEVELS[level], text_of(text))


@from_c("law")  # type: ignore[misc]
def _law(user: Any, at: Any, wrench: Any, by_place: Any, by_motion: Any) -> int:
    called = ffi.from_handle(user)
    handle = called.handle()
    handle.in_law = True
    try:
        force, moment, *slopes = called.call(Segment(**plain(at[0])))
    finally:
        handle.in_law = False
    wrench[0], wrench[1], wrench[2] = force
    wrench[3], wrench[4], wrench[5] = moment
    if slopes and by_place != ffi.NULL:
        for matrix, out in zip(slopes, (by_place, by_motion)):
            ffi.buffer(out, 36 * 8)[:] = np.asarray(matrix, float).reshape(6, 6).tobytes()
    return 0


Wish = Union[bool, Callable[[Progress], Any]]


class Teller:
    """What becomes of a run's progress: nothing, a line on standard error, a call of the user's function."""

    def __init__(self, wish: Wish) -> None:
        self.wish = wish
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
        """The line on the terminal is done."""
        if self.wish is True and self.live and self.tenth >= 0:
            print(file=sys.stderr)
