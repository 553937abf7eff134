"""Cases: what is to be pulled, through what, and how."""
from __future__ import annotations

import json
import os
import pathlib
from typing import TYPE_CHECKING, Any, Mapping, Union

import numpy as np
import pandas as pd

from hawser._native import ffi, lib
from hawser._tables import frame_of
from hawser.errors import DICT, check, taken

if TYPE_CHECKING:
    from hawser.simulation import Simulation
    from hawser.calculation import Theory

Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]
Settings = Mapping[str, Any]


def simple(value: Any) -> Any:
    """What json does not know by itself."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(f"a case cannot hold {type(value).__name__}: texts, numbers, yes or no, lists and dicts")


def yaml_of(value: Any) -> str:
    """A value as YAML: a text as it is (it may be YAML itself), everything else as JSON, which is YAML."""
    return value if isinstance(value, str) else json.dumps(value, default=simple, ensure_ascii=False, allow_nan=False)


class Case:
    """A case, from a file, a text or a dict.

    source: path of a YAML file (docs/case-format.md); or its text, if it has a line break; or a dict with the same keys,
            whose values are numbers (SI) or texts with units: {"friction": {"mu": 0.2}, "run": {"duration": "30 s"}}
    set:    changes by dotted key, as `hawser run --set` takes them: {"drive.winch.speed": "3 m/min", "friction.mu": 0.25}
    folder: of texts and dicts: where files are looked for that the case names

    Raises CaseError. The file's values are interpreted by check() and by everything that needs them.
    """

    def __init__(self, source: Source, *, set: Settings | None = None,
                 folder: str | os.PathLike[str] | None = None) -> None:
        made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
        if isinstance(source, Mapping):
            self.name = DICT
            status = lib.hawser_case_parse_json(yaml_of(source).encode(), DICT.encode(), made, error)
        elif isinstance(source, str) and "\n" in source:
            self.name = "<text>"
            status = lib.hawser_case_parse(source.encode(), b"<text>", made, error)
        else:
            self.name = os.fspath(source)
            status = lib.hawser_case_load(os.fsencode(self.name), made, error)
        check(status, error)
        self._c = ffi.gc(made[0], lib.hawser_case_free)
        self._error = error
        if folder is not None:
            check(lib.hawser_case_folder(self._c, os.fsencode(folder), error), error)
        self.set(set or {})

    @classmethod
    def of_run(cls, folder: str | os.PathLike[str]) -> Case:
        """The case of the run whose checkpoint is in a folder of results, with all its settings."""
        made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
        check(lib.hawser_case_resume(os.fsencode(folder), made, error), error)
        case = cls.__new__(cls)
        case.name, case._error, case._c = os.fspath(folder), error, ffi.gc(made[0], lib.hawser_case_free)
        return case

    def set(self, settings: Settings) -> Case:
        """Changes values by dotted key; later ones win. Returns the case. What runs already does not see it."""
        for key, value in settings.items():
            check(lib.hawser_case_set(self._c, key.encode(), yaml_of(value).encode(), self._error), self._error)
        return self

    def check(self) -> Case:
        """Interprets and checks everything that can be checked without running. Returns the case; raises CaseError."""
        check(lib.hawser_case_check(self._c, self._error), self._error)
        return self

    def _text(self, call: Any, format: int) -> str:
        text = ffi.new("char **")
        check(call(self._c, format, text, self._error), self._error)
        return taken(text)

    def describe(self) -> dict[str, Any]:
        """What would be built: counts, masses (kg), lengths (m), theory (N); the keys of `hawser check --format json`."""
        found: dict[str, Any] = json.loads(self._text(lib.hawser_case_describe, lib.HAWSER_JSON))
        return found

    def equipment(self) -> pd.DataFrame:
        """Everything that stands along the route by rising station: number, kind, name, place (m), load by the pulling
        theory (N), rating, margin."""
        return frame_of(json.loads(self._text(lib.hawser_case_equipment, lib.HAWSER_JSON))["equipment"])

    def theory(self) -> Theory:
        """The pulling calculation alone, in milliseconds."""
        from hawser.calculation import Theory

        return Theory(json.loads(self._text(lib.hawser_case_theory, lib.HAWSER_JSON)),
                      self._text(lib.hawser_case_theory, lib.HAWSER_TABLE))

    def fmu(self, path: str | os.PathLike[str], *, version: int = 3) -> pathlib.Path:
        """Writes the case as a mock-up unit (docs/fmi.md) for programs that simulate it together with other models. version: of FMI,
        3 or 2. Returns the path."""
        check(lib.hawser_fmu_write(self._c, version, os.fsencode(path), self._error), self._error)
        return pathlib.Path(path)

    def simulation(self, *, threads: int = 0) -> Simulation:
        """A simulation of the case as it is now. threads: 1 or 2; 0: the case's choice."""
        from hawser.simulation import Simulation

        return Simulation(self, threads=threads)

    def __str__(self) -> str:
        return self._text(lib.hawser_case_describe, lib.HAWSER_TABLE)

    def __repr__(self) -> str:
        return f"hawser.Case({self.name!r})"


def case_of(source: Source | Case, set: Settings | None) -> Case:
    """A case with settings. One that is given is changed by them, as by Case.set."""
    return source.set(set or {}) if isinstance(source, Case) else Case(source, set=set)


def theory(case: Source | Case, *, set: Settings | None = None) -> Theory:
    """The pulling calculation of a case, from its file, text or dict: forces either way, station by station, limits."""
    return case_of(case, set).theory()
