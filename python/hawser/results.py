"""Results: what a run has written into a folder, by Python or by `hawser run`."""
from __future__ import annotations

import contextlib
import fcntl
import functools
import io
import json
import os
import pathlib
import shutil
import tempfile
import time
import weakref
import webbrowser
from collections.abc import Iterator, Sequence
from typing import Any, BinaryIO

import numpy as np
import pandas as pd

from hawser import _door
from hawser._columns import COLUMNS
from hawser._native import ffi, lib
from hawser._tables import frame_of, page_html, shown
from hawser.things import row_of
from hawser.errors import MissingError, OutputError, c_path, check, taken, text_of

PLOTS = ("tension", "series", "rollers", "plan")
# What the axes of a set of results.h5 are, by its name; all begin with the time of the state.
AXES = {"position": ("segment", "xyz"), "quaternion": ("segment", "wxyz"), "velocity": ("segment", "xyz"),
        "omega": ("segment", "xyz"), "tension": ("joint",), "curvature": ("joint",), "sidewall": ("joint",),
        "contact_line_load": ("segment",), "roller_load": ("roller",), "roller_force": ("roller", "xyz"),
        "winch_force": (), "tail_tension": (), "head_at": ()}


class Verdict(str):
    """One line that says whether the pull is safe and the figures are to be trusted: "NOT SAFE: 1 of 12 limits broken: ..."."""

    @property
    def _found(self) -> int:
        return int(lib.hawser_word_of(self.encode()))

    @property
    def word(self) -> str:
        """"SAFE", "SAFE ONLY IF", "NOT SAFE", "NOT JUDGED" or "NOT TRUSTED"."""
        return text_of(lib.hawser_word_text(self._found)) if self._found < lib.HAWSER_WORDS else ""

    @property
    def code(self) -> str:
        """The same for programs: "safe", "safe_if", "not_safe", "not_judged", "not_trusted"; only "safe" is safe."""
        return text_of(lib.hawser_word_code(self._found)) if self._found < lib.HAWSER_WORDS else ""

    @property
    def safe(self) -> bool | None:
        """Whether the pull is safe; None: that is not known, as limits or values are missing or the run is not to be trusted."""
        return {"SAFE": True, "NOT SAFE": False}.get(self.word)

    @property
    def trusted(self) -> bool:
        """Whether the figures are worth judging."""
        return self.word != "NOT TRUSTED"


class Figure(str):
    """A figure as the text of an SVG; notebooks show it."""

    def __repr__(self) -> str:
        return f"<hawser figure: SVG, {len(self)} characters>"

    def _repr_svg_(self) -> str:
        return str(self)


@contextlib.contextmanager
def held(folder: pathlib.Path) -> Iterator[BinaryIO]:
    """results.h5 as the last flush left it, which it stays meanwhile: HDF5 must not see a file that changes, or one whose run was
    killed within a flush."""
    path = folder / "results.h5"
    with _door.opened(folder, path.name) as file:
        for last in [False] * 40 + [True]:
            try:
                fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                if last:
                    raise OutputError(f"{path}: its run has been writing it for more than 2 s: try again") from None
                time.sleep(0.05)
            except OSError:  # the disk knows no locks
                break
        if os.path.lexists(f"{path}.journal"):
            raise OutputError(f"{path}: its run was killed while it wrote this file: 'hawser run --resume' completes it")
        yield file


TEXTS = ("name", "key", "value", "unit", "origin", "where", "source")  # columns that hold no numbers
COUNTS = ("max_tension_joint", "active_contacts", "mode", "segment")  # numbers that are whole always


def unguarded(cell: str) -> str:
    """A text as it was before it was made harmless for spreadsheets: an apostrophe stands before =, +, - or @."""
    return cell[1:] if cell[:1] == "'" and cell[1:2] in tuple("=+-@") else cell


def read_csv(folder: pathlib.Path, name: str, *, optional: bool = False) -> pd.DataFrame:
    """A table of results; an empty cell is NaN, in a column of texts an empty text. What each column is stands in
    `attrs["columns"]`, of those that every folder has. optional: an empty one if it is not there."""
    if optional and not _door.is_there(folder, name):
        return pd.DataFrame()
    table = pd.read_csv(io.BytesIO(_door.read(folder, name)), encoding="utf-8", converters=dict.fromkeys(TEXTS, unguarded))
    whole = [column for column in table.columns if table[column].dtype == np.int64 and column not in COUNTS]
    table = table.astype(dict.fromkeys(whole, float))
    told = COLUMNS.get(name, {})
    table.attrs["columns"] = {column: told[column] for column in table.columns if column in told}
    return table


def remove(folder: str, process: int) -> None:
    """A forked process leaves it to the one that made it."""
    if os.getpid() == process:
        shutil.rmtree(folder, ignore_errors=True)


class OwnFolder:
    """A folder that goes with the last object that has it."""

    def __init__(self) -> None:
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="hawser-"))
        weakref.finalize(self, remove, str(self.path), os.getpid())


class Result:
    """What a run has found. Tables are pandas DataFrames with the unit in every column's name, as docs/reference/columns.md lists them;
    each is read when it is asked for first.

    folder: where the files are, all of one run (else CaseError); a run without `out` has a folder of its own, which goes with the Result
            (see save). Pickled, such a Result takes its files along, into a folder of its own there; others take their path
    """

    def __init__(self, folder: str | os.PathLike[str], *, _keep: OwnFolder | None = None) -> None:
        self.folder = pathlib.Path(folder)
        self._keep = _keep
        path = c_path(self.folder)
        if not (self.folder / "summary.json").is_file():
            raise MissingError(f"{self.folder}: no results: there is no summary.json", self.folder / "summary.json")
        error = ffi.new("hawser_error *")
        check(lib.hawser_results_check(path, error), error)

    def __copy__(self) -> Result:
        return Result(self.folder, _keep=self._keep)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._keep is None:
            return Result, (self.folder.absolute(),)
        return with_files, ({str(file.relative_to(self.folder)): file.read_bytes() for file in self.folder.rglob("*")
                            if file.is_file() and not file.is_symlink()},)

    @functools.cached_property
    def summary(self) -> dict[str, Any]:
        """The run in numbers; what is not known is None."""
        found: dict[str, Any] = json.loads(_door.read(self.folder, "summary.json"))
        return found

    @property
    def title(self) -> str:
        """The case's title, or its file's name."""
        return str(self.summary["title"])

    @property
    def outcome(self) -> str:
        """"finished", "tripped", "stopped", "failed", "unfinished" or, of a run that goes on elsewhere, "running"."""
        return str(self.summary["outcome"])

    @property
    def verdict(self) -> Verdict:
        """Whether the pull is safe, in one line; verdict.safe and verdict.trusted for programs."""
        return Verdict(self.summary["verdict"])

    @functools.cached_property
    def series(self) -> pd.DataFrame:
        """Over time, a row every output.interval: time_s, winch_force_N, winch_speed_m_per_s, max_tension_N and more."""
        return read_csv(self.folder, "series.csv")

    @functools.cached_property
    def stations(self) -> pd.DataFrame:
        """Tension along the route: s_m; paper_N and reference_N by theory; mean_N and peak_N as simulated, with what each may
        be off by."""
        return read_csv(self.folder, "stations.csv")

    @functools.cached_property
    def rollers(self) -> pd.DataFrame:
        """Loads of the rollers (N): initial_N, steady_N, peak_N, rating_N."""
        return read_csv(self.folder, "rollers.csv")

    @functools.cached_property
    def inputs(self) -> pd.DataFrame:
        """Every key of the case: value, unit, origin ("given", "catalogue", "estimated", "default"), where, source."""
        return read_csv(self.folder, "inputs.csv")

    @functools.cached_property
    def route(self) -> pd.DataFrame:
        """The route and theory along it (m, N, N/m); empty of a rod."""
        return read_csv(self.folder, "route.csv", optional=True)

    @functools.cached_property
    def places(self) -> pd.DataFrame:
        """Steady motion by place of the front, of a run with `analysis: positions`; empty of others."""
        return read_csv(self.folder, "positions.csv", optional=True)

    @functools.cached_property
    def modes(self) -> pd.DataFrame:
        """Shapes of vibration, of a run with `analysis: modes`; empty of others."""
        return read_csv(self.folder, "modes.csv", optional=True)

    def roller(self, name: str) -> pd.Series[Any]:
        """The row of `rollers` of that name (N): initial_N, steady_N, peak_N, rating_N. KeyError: there is none, or more than one."""
        return row_of(self.rollers, name, "roller")

    def surface(self, name: str) -> pd.Series[Any]:
        """The row of `surfaces` of that name. KeyError."""
        return row_of(self.surfaces, name, "surface")

    def conveyor(self, name: str) -> pd.Series[Any]:
        """The row of `conveyors` of that name. KeyError."""
        return row_of(self.conveyors, name, "conveyor")

    def _list(self, key: str) -> pd.DataFrame:
        return frame_of(self.summary.get(key) or [])

    @property
    def limits(self) -> pd.DataFrame:
        """Each limit of the case: name, value, limit, unit, margin (share that is left; below 0: broken), ok, where, source."""
        return self._list("limits")

    @property
    def trust(self) -> pd.DataFrame:
        """The conditions under which the run is worth judging: name, value, allowed, unit, holds, remedy."""
        return self._list("trust")

    @property
    def events(self) -> pd.DataFrame:
        """What happened: time_s, what, pull_N."""
        return self._list("events")

    @property
    def surfaces(self) -> pd.DataFrame:
        """Ducts, trays, floors, walls: place (m), forces (N), peak_line_load_N_per_m."""
        return self._list("surfaces")

    @property
    def conveyors(self) -> pd.DataFrame:
        """Forces (N), speeds and slip (m/s) of the conveyors; empty without."""
        return self._list("conveyors")

    @property
    def motors(self) -> pd.DataFrame:
        """Torques (N m), speeds (m/s) and power (W) of driven rollers; empty without."""
        return self._list("motors")

    @property
    def positions(self) -> pd.DataFrame:
        """The pull by place of the cable's front: head_m, pull_N, reference_N, error_pct."""
        return self._list("pull_by_position")

    @functools.cached_property
    def states(self) -> Any:
        """The sampled states: time (s), position (m), velocity (m/s), tension (N) and more, as docs/reference/columns.md lists the sets
        of results.h5. An xarray.Dataset; without xarray a dict of numpy arrays. Needs h5py."""
        try:
            import h5py
        except ImportError as missing:
            raise ImportError("states are read with h5py, which is not there (Debian: python3-h5py)") from missing
        with held(self.folder) as held_file, h5py.File(held_file, "r") as file:
            sets = {name: data for name in ("time", *AXES) if (data := _door.data_of(file, name)) is not None}
            arrays = {name: np.asarray(data) for name, data in sets.items()}
            units = {name: as_text(data.attrs["units" if "units" in data.attrs else "unit"]) for name, data in sets.items()}
            told = {name: as_text(data.attrs["description"]) for name, data in sets.items()}
            names = [as_text(name) for name in _door.names_of(file, "roller_name")]
        complete = len(arrays["time"])  # a state has a time once all of it is there
        arrays = {name: values[:complete] for name, values in arrays.items()}
        try:
            import xarray
        except ImportError:
            return arrays
        axes = {name: ("time", *AXES.get(name, ())) for name in arrays}
        data = {name: (axes[name], values, {"units": units[name], "long_name": told[name]})
                for name, values in arrays.items() if name != "time"}
        coordinates: dict[str, Any] = {"time": ("time", arrays["time"], {"units": "s"}),
                                       "xyz": ["x", "y", "z"], "wxyz": ["w", "x", "y", "z"]}
        if "roller_load" in arrays:
            coordinates["roller"] = names
        return xarray.Dataset(data, coords=coordinates, attrs={"title": self.title})

    def report(self, path: str | os.PathLike[str] | None = None, *, open: bool = False) -> pathlib.Path:
        """Writes the whole result as one HTML page that needs no other file; open: shows it in the browser. Returns its path
        (default: report.html in the folder)."""
        page = pathlib.Path(path) if path is not None else self.folder / "report.html"
        write_report([self.folder], page)
        if open:
            webbrowser.open(page.resolve().as_uri())
        return page

    def plot(self, name: str = "tension") -> Figure:
        """A figure as SVG: "tension" along the route, "series" over time, "rollers" or "plan"."""
        if name not in PLOTS:
            raise ValueError(f"no figure {name!r}: there are {', '.join(PLOTS)}")
        error, wanted = ffi.new("hawser_error *"), ffi.new("char[]", name.encode())
        with tempfile.TemporaryDirectory() as scratch:
            check(lib.hawser_plot_write(c_path(self.folder), scratch.encode(), 1, ffi.new("const char *[]", [wanted]),
                                        lib.HAWSER_SI, ffi.NULL, error), error)
            return Figure((pathlib.Path(scratch) / f"{name}.svg").read_text(encoding="utf-8"))

    def save(self, folder: str | os.PathLike[str]) -> Result:
        """Copies the files to another folder, which must not be there yet. Returns the results there."""
        shutil.copytree(self.folder, folder, symlinks=True)  # what a link leads to is none of the result's
        return Result(folder)

    def against(self, log: str | os.PathLike[str], *, align: str = "length", shift: float = 0.0, band: float = 0.1, raw: bool = False,
                page: str | os.PathLike[str] | None = None) -> dict[str, Any]:
        """How far the winch's force that a logger has written (CSV, docs/guide/studies-and-measured-pulls.md) agrees with this run and with the theory.

        align: by "length", the winch's travel, or by the time since the pull's "start"
        shift: m or s, added to where the log is
        band:  share of the log's force that counts as agreement
        raw:   spikes and drop-outs of the log are taken as they are
        page:  an HTML file with figures, which is written
        """
        if align not in ("length", "start"):
            raise ValueError(f"align={align!r}: 'length' or 'start' is expected")
        error, text = ffi.new("hawser_error *"), ffi.new("char **")
        drawn = ffi.NULL if page is None else ffi.new("char[]", c_path(page))
        options = ffi.new("hawser_compare_options *", {"by_start": align == "start", "shift": shift, "band": band, "raw": raw, "page": drawn,
                                                       "format": lib.HAWSER_JSON})
        check(lib.hawser_compare(c_path(self.folder), c_path(log), options, text, error), error, log)
        found: dict[str, Any] = json.loads(taken(text))
        return found

    def _figures(self) -> list[tuple[str, str]]:
        """What matters most, as people read it."""
        pull, theory = self.summary["pull_force"], self.summary["theory"]
        rows = [("pull, mean of the steady window", pull["steady_mean_N"]), ("pull, peak", pull["peak_N"]),
                ("reference theory", theory["reference_total_N"])]
        found = [(name, shown(value, "N")) for name, value in rows if value is not None]
        if len(self.rollers) and self.rollers["peak_N"].notna().any():
            worst = self.rollers.loc[self.rollers["peak_N"].idxmax()]
            found.append((f"largest roller load, {worst['name']}", shown(worst["peak_N"], "N")))
        return found

    def __str__(self) -> str:
        lines = [self.title, f"  {self.verdict}", *(f"  {name}: {value}" for name, value in self._figures())]
        return "\n".join(lines)

    def __repr__(self) -> str:
        return f"<hawser result of {self.title!r}: {self.outcome}; {self.verdict}>"

    def _repr_html_(self) -> str:
        limits = self.limits[["name", "value", "limit", "unit", "margin", "ok", "where"]] if len(self.limits) else None
        return page_html(self.title, self.verdict, self._figures(), limits)


def with_files(files: dict[str, bytes]) -> Result:
    """A pickled result that had a folder of its own."""
    own = OwnFolder()
    for name, content in files.items():
        file = own.path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
    return Result(own.path, _keep=own)


def as_text(name: Any) -> str:
    return name.decode("utf-8", "replace") if isinstance(name, bytes) else str(name)


def write_report(folders: list[pathlib.Path], page: pathlib.Path) -> None:
    """One HTML page about the results in one to six folders."""
    error = ffi.new("hawser_error *")
    paths = [ffi.new("char[]", c_path(folder)) for folder in folders]
    check(lib.hawser_report_write(ffi.new("const char *[]", paths), len(paths), c_path(page), error), error)


def compare(results: Sequence[Result | str | os.PathLike[str]], path: str | os.PathLike[str]) -> pathlib.Path:
    """Writes one HTML page that compares up to six results, or what stands in their folders. Returns its path."""
    write_report([result.folder if isinstance(result, Result) else pathlib.Path(result) for result in results], pathlib.Path(path))
    return pathlib.Path(path)
