"""Jobs: many pulls, calculated by theory in one go (docs/guide/jobs-and-sheets.md)."""
from __future__ import annotations

import json
import os
import pathlib

import pandas as pd

from hawser._native import ffi, lib
from hawser._tables import frame_of, page_html
from hawser._written import Plan, job_file
from hawser.errors import c_path, check, taken
from hawser.results import Verdict


class Job:
    """The pulls of a job's file, each in the direction that is taken. SI units; columns as `hawser job --format json` has them."""

    def __init__(self, plan: Plan, *, folder: str | os.PathLike[str] | None = None) -> None:
        made, self._error = ffi.new("hawser_job **"), ffi.new("hawser_error *")
        with job_file(plan, folder) as path:
            check(lib.hawser_job_load(c_path(path), made, self._error), self._error, path)
        self._job = ffi.gc(made[0], lib.hawser_job_free)
        text, word = ffi.new("char **"), ffi.new("hawser_word *")
        check(lib.hawser_job_answer(self._job, lib.HAWSER_JSON, text, word, self._error), self._error)
        self.data = json.loads(taken(text))
        self.verdict = Verdict(ffi.string(lib.hawser_word_text(word[0])).decode())  # of the worst pull

    @property
    def pulls(self) -> pd.DataFrame:
        """A row a pull: name, verdict_code, direction, force_N, restart_N, limit, margin_pct, trip_N, reel and more."""
        return frame_of(self.data["pulls"])

    @property
    def reels(self) -> pd.DataFrame:
        """A row a reel: the pulls that it is for, length_m, used_m, left_m, lift_N."""
        return frame_of(self.data["reels"])

    @property
    def bays(self) -> pd.DataFrame:
        """A row a joint bay: the reels and winches that stand there."""
        return frame_of(self.data["bays"])

    def page(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Writes tables and calculations as one page (HTML). OutputError: it cannot be written."""
        check(lib.hawser_job_page(self._job, lib.HAWSER_SI, c_path(path), self._error), self._error)
        return pathlib.Path(path)

    def crew_sheets(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Write the crew's sheets of all pulls, one printed side each, as one page (HTML). OutputError: it cannot be written."""
        check(lib.hawser_job_crew_sheets(self._job, lib.HAWSER_SI, c_path(path), self._error), self._error)
        return pathlib.Path(path)

    def workbook(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Writes the tables as a workbook (.xlsx). OutputError: it cannot be written."""
        check(lib.hawser_job_workbook(self._job, c_path(path), self._error), self._error)
        return pathlib.Path(path)

    def __str__(self) -> str:
        text = ffi.new("char **")
        check(lib.hawser_job_answer(self._job, lib.HAWSER_TABLE, text, ffi.NULL, self._error), self._error)
        return taken(text)


    def __repr__(self) -> str:
        return f"<hawser job {self.data['title']!r}: {len(self.data['pulls'])} pulls; {self.verdict}>"

    def _repr_html_(self) -> str:
        return page_html(str(self.data["title"]), self.verdict, table=self.pulls)


def job(plan: Plan, *, folder: str | os.PathLike[str] | None = None) -> Job:
    """Calculates all pulls of a job.

    plan:   path of a job's file (docs/guide/jobs-and-sheets.md), or a dict with the same keys
    folder: of a dict: where files are looked for that it names (default: the current folder)
    """
    return Job(plan, folder=folder)
