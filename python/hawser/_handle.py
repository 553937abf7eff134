"""Who owns a simulation's memory, and who may use it when."""
from __future__ import annotations

import os
import threading
from typing import Any

from hawser._native import ffi, lib
from hawser.errors import check


class Handle:
    """The C simulation: freed when neither the Simulation nor any array of it is left.

    `with handle as c:` lends it for a look. A second thread is refused instead of waiting; a call-back in the same thread may
    look too, but not a law of force, which is asked in the midst of a step.
    `with handle.motion as c:` lends it to a call that moves it, which a call-back may not do.
    """

    def __init__(self, c: Any) -> None:
        self.c = ffi.gc(c, lib.hawser_sim_free)
        self.error = ffi.new("hawser_error *")
        self.moved = 0  # counts what makes older samples invalid
        self.kept: dict[Any, Any] = {}  # call-backs that C knows
        self._gone: list[Any] = []  # those that it may still be in
        self._depth = 0
        self.raised: BaseException | None = None  # by a call-back; waits until C has returned
        self.in_law = False
        self.under_way = False
        self._lock = threading.RLock()

    def __enter__(self) -> Any:
        if not self._lock.acquire(False):
            raise RuntimeError("this simulation is at work in another call: one thread uses it at a time")
        if self.in_law:
            self._lock.release()
            raise RuntimeError("a law of force is shown its segment and nothing else: the step is not done yet")
        self._depth += 1
        return self.c

    def __exit__(self, *_: object) -> None:
        self._depth -= 1
        if self._depth == 0:
            self._gone.clear()
        self._lock.release()

    def keep(self, name: Any, called: Any) -> None:
        """Keeps a call-back that C knows under a name, in place of the one before: that may be under way, and stays until C has returned."""
        if self._depth:
            self._gone.append(self.kept.get(name))
        self.kept[name] = called

    @property
    def motion(self) -> Motion:
        return Motion(self)

    def check(self, status: int, path: str | os.PathLike[str] | None = None) -> None:
        """Raises what a call-back raised, or what the call returned if it is not OK. path: as errors.check."""
        if self.raised is not None:
            raised, self.raised = self.raised, None
            raise raised
        check(status, self.error, path)


class Motion:
    """A call that moves the simulation: one at a time, and older samples are invalid."""

    __slots__ = ("handle",)

    def __init__(self, handle: Handle) -> None:
        self.handle = handle

    def __enter__(self) -> Any:
        handle = self.handle
        c = handle.__enter__()
        if handle.under_way:
            handle.__exit__()
            raise RuntimeError("a call-back may look and give commands, but not move its simulation")
        handle.under_way = True
        handle.moved += 1
        return c

    def __exit__(self, *_: object) -> None:
        handle = self.handle
        handle.under_way = False
        handle.moved += 1
        handle.__exit__()
