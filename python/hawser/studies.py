"""Studies: many variants of a case (docs/guide/studies-and-measured-pulls.md).

The library computes them on processes that it forks, which a program with threads cannot do: a Python process of its own does it, with
FILE FOLDER JOBS FRESH as arguments, and prints lines of JSON with how far it is.
"""
from __future__ import annotations

import json
import os
import pathlib
import signal
import subprocess
import sys
from collections.abc import Mapping
from typing import Any, Callable

import pandas as pd

from hawser import _door
from hawser._native import ffi, lib
from hawser._tables import page_html
from hawser._written import Plan, of_dict, study_file
from hawser.errors import CaseError, MissingError, OutputError, c_path, check, error_from, taken, told
from hawser.results import read_csv

# Of a study's process: numpy's linear algebra would start threads.
ALONE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


# What it runs, also before Python 3.11, which has -P for it: nothing is imported from the current folder, where anything may lie.
START = "import sys; sys.path[:] = filter(None, sys.path); from hawser.studies import main; sys.exit(main(*sys.argv[1:]))"


class Study:
    """What a study has found, in a folder that study() or `hawser study` has written.

    answer: for people; "" of a folder that is only read
    """

    def __init__(self, folder: str | os.PathLike[str], answer: str = "") -> None:
        self.folder, self.answer = pathlib.Path(folder), answer
        if not (self.folder / "samples.csv").is_file():
            raise MissingError(f"{self.folder}: no study: there is no samples.csv", self.folder / "samples.csv")

    @property
    def samples(self) -> pd.DataFrame:
        """A row a sample: its parameters, verdict, limited_by, quantities, margins."""
        return read_csv(self.folder, "samples.csv")

    @property
    def summary(self) -> dict[str, Any]:
        """All of them together: shares, limits, sensitivities."""
        found: dict[str, Any] = json.loads(_door.read(self.folder, "summary.json"))
        return found

    def report(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Makes the page with its figures anew, as far as samples have come; also while others compute. Returns the path. CaseError: the
        folder holds no study; OutputError: the page cannot be written."""
        error = ffi.new("hawser_error *")
        check(lib.hawser_study_report(c_path(self.folder), c_path(path), error), error)
        return pathlib.Path(path)

    def __str__(self) -> str:
        return self.answer or repr(self)

    def __repr__(self) -> str:
        found = self.summary
        return f"<hawser study in {str(self.folder)!r}: {found['done']:g} of {found['samples']:g} samples>"

    def _repr_html_(self) -> str:
        found = self.summary
        return page_html(found.get("title") or str(self.folder), f"{found['done']:g} of {found['samples']:g} samples", table=self.samples.head(10))


def study(plan: Plan, out: str | os.PathLike[str], *, folder: str | os.PathLike[str] | None = None, jobs: int = 0, fresh: bool = False,
          progress: Callable[[dict[str, float]], Any] | None = None) -> Study:
    """Computes a study's samples on all processors. One that was stopped (Ctrl-C) or killed goes on where it was.

    plan:     path of a study's file (docs/guide/studies-and-measured-pulls.md), or a dict with the same keys, whose `case` may be a path, a dict or a Case
    out:      folder of the results; of a dict its files, too
    folder:   of a dict: where files are looked for that it names (default: the current folder)
    jobs:     worker processes; 0: as many as there are processors
    fresh:    what an earlier start has left in the folder is dropped
    progress: is called a few times a second with samples, done, failed, not_safe, jobs, wall_s, left_s, and stops the study
              (hawser.Stopped) by returning True

    CaseError: the study or its case is wrong; MissingError: a file of it is not there; OutputError: `out` cannot be written.
    """
    path = study_file(plan, pathlib.Path(out), os.path.abspath(folder or os.curdir)) if isinstance(plan, Mapping) else plan
    command = [sys.executable, "-c", START, os.fspath(path), os.fspath(out), str(jobs), str(int(fresh))]
    paths = [str(pathlib.Path(__file__).resolve().parents[1]), os.environ.get("PYTHONPATH", "")]
    environment = {**os.environ, **ALONE, "PYTHONPATH": os.pathsep.join(filter(None, paths))}
    child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    assert child.stdout is not None
    last: dict[str, Any] = {}
    try:
        for line in child.stdout:
            last = json.loads(line)
            if "status" not in last and progress is not None and progress(last):
                child.send_signal(signal.SIGINT)
    except BaseException:
        child.send_signal(signal.SIGINT)
        raise
    finally:
        child.stdout.close()
        child.wait()
    if "status" not in last:
        raise OutputError(f"the process of the study ended with status {child.returncode}")
    if last["status"]:
        raised = error_from(last["status"], **last["told"])
        if isinstance(plan, Mapping) and isinstance(raised, CaseError):
            raise of_dict(raised, pathlib.Path(path))
        raise raised if os.path.exists(path) else MissingError(str(raised), path)
    return Study(out, last["answer"])


STATE = ("samples", "done", "failed", "not_safe", "jobs", "wall_s", "left_s")


@ffi.def_extern(name="hawser_python_study", error=1, onerror=lambda *_: 1)  # type: ignore[misc]
def _progress(_: Any, state: Any) -> int:
    print(json.dumps({name: getattr(state, name) for name in STATE}), flush=True)
    return 0


def main(path: str, out: str, jobs: str, fresh: str) -> int:
    """The process of a study; Ctrl-C comes as an exception out of the progress function, and so stops it."""
    made, error, text = ffi.new("hawser_study **"), ffi.new("hawser_error *"), ffi.new("char **")
    end: dict[str, Any] = {"answer": ""}
    if len(os.listdir("/proc/self/task")) > 1:
        raise RuntimeError("a study forks, and this process has threads")
    end["status"] = lib.hawser_study_load(os.fsencode(path), made, error)
    if not end["status"]:
        handle = ffi.gc(made[0], lib.hawser_study_free)
        options = ffi.new("hawser_study_options *", {"jobs": int(jobs), "fresh": int(fresh),
                                                     "progress": lib.hawser_python_study, "user": ffi.NULL})
        end["status"] = lib.hawser_study_run(handle, os.fsencode(out), options, error)
        if not end["status"]:
            check(lib.hawser_study_answer(handle, lib.HAWSER_TABLE, text, error), error)
            end["answer"] = taken(text)
    if end["status"]:
        end["told"] = told(error)
    print(json.dumps(end), flush=True)
    return 0
