"""Certificates: whether the figures of a run hold when it is computed again with finer settings (docs/guide/simulate.md, "Certify")."""
from __future__ import annotations

import json
from typing import Any, Callable, NamedTuple

import pandas as pd

from hawser._callbacks import Called, from_c
from hawser._native import ffi, lib
from hawser._tables import frame_of, page_html
from hawser.case import Case, Settings, Source, case_of
from hawser.errors import check, taken, text_of
from hawser.simulation import Simulation


class Certified(NamedTuple):
    """What a progress function is told."""

    round: int  # from 1
    runs: int  # of this round
    over: int  # how many of them have ended
    what: str  # is being computed
    done: float  # share of the round's work
    left_s: float  # s until the end of the round; NaN: not known yet


class Certificate:
    """The figures of a run with what refinement says of them; `data` is certificate.json."""

    def __init__(self, data: dict[str, Any], text: str, certified: bool) -> None:
        self.data = data
        self.certified = certified  # all figures of the run hold to the tolerance
        self._text = text

    @property
    def verdict(self) -> str:
        """"CERTIFIED: ..." or "NOT CERTIFIED: ..."."""
        return str(self.data["verdict"])

    @property
    def figures(self) -> pd.DataFrame:
        """name, unit, value (of the run), bar (what it may be off by), allowed, holds, best and more."""
        return frame_of(self.data["figures"])

    @property
    def runs(self) -> pd.DataFrame:
        """What was computed: settings, how it ended, its work over that of the case as it is."""
        return frame_of(self.data["runs"])

    def __str__(self) -> str:
        return f"{self.verdict}\n{self._text}"

    def __repr__(self) -> str:
        return f"<hawser certificate: {self.verdict}>"

    def _repr_html_(self) -> str:
        return page_html("Certificate", self.verdict, table=self.figures)


@from_c("certify")  # type: ignore[misc]
def _progress(user: Any, state: Any) -> int:
    now = Certified(state.round, state.runs, state.over, text_of(state.what), state.done, state.left_s)
    return bool(ffi.from_handle(user).call(now))


def certify(case: Source | Case, *, set: Settings | None = None, tolerance: float = 0.01, rounds: int = 0, effort: float = 0,
            threads: int = 0, progress: Callable[[Certified], Any] | None = None) -> Certificate:
    """Runs a case, then again with finer settings, until its figures hold to the tolerance or there is no more to be tried.
    That costs up to `effort` times the run.

    tolerance: share, above 0 and below 1
    rounds:    at most so many; 0: 4
    effort:    work of the finer runs, in runs of the case, which they do not exceed; 0: 6
    threads:   runs side by side, 1 or 2; 0: 2 where there are two processors
    progress:  is called with a Certified a few times a second, and stops it (hawser.Stopped) by returning True

    CaseError: the case or an option is wrong; RunError: the integration failed.
    """
    case, error = case_of(case, set), ffi.new("hawser_error *")
    simulation = Simulation(case)
    simulation.run_quietly()
    handle, made, text = simulation._open, ffi.new("hawser_certificate **"), ffi.new("char **")
    called = Called(handle, progress or (lambda now: False))
    options = ffi.new("hawser_certify_options *", {
        "tolerance": tolerance, "rounds": rounds, "effort": effort, "threads": threads, "user": called.user,
        "progress": lib.hawser_python_certify})
    with handle.motion as c:
        status = lib.hawser_certify(case._c, c, options, made, handle.error)
    handle.check(status)
    certificate = ffi.gc(made[0], lib.hawser_certificate_free)
    texts = []
    for format in (lib.HAWSER_JSON, lib.HAWSER_TABLE):
        check(lib.hawser_certificate_text(certificate, format, text, error), error)
        texts.append(taken(text))
    return Certificate(json.loads(texts[0]), texts[1], bool(certificate.certified))
