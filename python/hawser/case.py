"""Cases: what is to be pulled, through what, and how."""
from __future__ import annotations

import html
import json
import math
import os
import pathlib
import re
import threading
from typing import TYPE_CHECKING, Any, Mapping, Union

import numpy as np
import pandas as pd

from hawser._native import ffi, lib
from hawser._tables import frame_of
from hawser.errors import DICT, SETTING, CaseError, c_path, c_text, check, taken, text_of

if TYPE_CHECKING:
    from hawser.simulation import Simulation
    from hawser.calculation import Theory

Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]
Settings = Mapping[str, Any]


NUMBER = re.compile(r"-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?")
WORDS = {"true": True, "false": False}


def case_error(key: str, text: str) -> CaseError:
    found = CaseError(f"key '{key}': {text}")
    found.key = key
    return found


def simple(value: Any, key: str) -> Any:
    """A value as json knows it: all below it, too. key: its dotted key."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, Mapping):
        return {name_of(name, key): simple(item, f"{key}.{name}" if key else str(name)) for name, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [simple(item, f"{key}.{k}" if key else str(k)) for k, item in enumerate(value)]
    if isinstance(value, str):
        if "\0" in value:
            raise case_error(key, "a NUL character in a text")
        return value
    if isinstance(value, float) and not math.isfinite(value):
        raise case_error(key, f"value {value}: expected a finite number")
    if value is None or isinstance(value, (bool, int, float)):
        return value
    raise TypeError(f"key '{key}': a case cannot hold {type(value).__name__}: texts, numbers, yes or no, lists and dicts")


def name_of(name: object, key: str) -> str:
    if name is True:  # what loaders of YAML 1.1 make of a job's key `on`
        name = "on"
    if isinstance(name, bool) or not isinstance(name, (str, int)):
        raise TypeError(f"key '{key}': a case cannot hold a key that is {type(name).__name__}: texts")
    return c_text(str(name), f"a key of '{key}'", key).decode()


def yaml_of(value: Any, key: str = "") -> str:
    """A value as YAML: a text as it is (it may be YAML itself), everything else as JSON, which is YAML."""
    plain = simple(value, key)
    return plain if isinstance(plain, str) else json.dumps(plain, ensure_ascii=False, allow_nan=False)


def value_of(found: Any) -> Any:
    """A value of a case, whose numbers and flags are texts in C, as Python has it."""
    if isinstance(found, dict):
        return {name: value_of(item) for name, item in found.items()}
    if isinstance(found, list):
        return [value_of(item) for item in found]
    return json.loads(found) if NUMBER.fullmatch(found) else WORDS.get(found, found)


def owned(made: Any) -> Any:
    """A case of C's that is freed with the last object that uses it."""
    return ffi.gc(made[0], lib.hawser_case_free)


def settle(c: Any, settings: Settings) -> Any:
    """Sets values of a case of C's that nobody else knows."""
    error = ffi.new("hawser_error *")
    for key, value in settings.items():
        name = c_text(key, f"{SETTING}{key!r}")
        check(lib.hawser_case_set(c, name, yaml_of(value, key).encode(), error), error)
    return c


class Case:
    """A case, from a file, a text or a dict.

    source: path of a YAML file (docs/case-format.md); or its text, if it has a line break; or a dict with the same keys,
            whose values are numbers (SI) or texts with units: {"friction": {"mu": 0.2}, "run": {"duration": "30 s"}}
    set:    changes by dotted key, as `hawser run --set` takes them: {"drive.winch.speed": "3 m/min", "friction.mu": 0.25}
    folder: of texts and dicts: where files are looked for that the case names

    Raises CaseError; MissingError, which is a FileNotFoundError, where there is no file. The file's values are interpreted by check() and
    by everything that needs them.

    Any number of threads may use one case, also while one of them sets it: each call works on the case as it was when the call began.
    Cases can be copied, which costs nothing, and pickled: into another process goes the case as it is, with the contents of its own file,
    but not of those that it includes.
    """

    def __init__(self, source: Source, *, set: Settings | None = None,
                 folder: str | os.PathLike[str] | None = None) -> None:
        made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
        if isinstance(source, Mapping):
            self.name = DICT
            check(lib.hawser_case_parse_json(yaml_of(source).encode(), DICT.encode(), made, error), error)
        elif isinstance(source, str) and "\n" in source:
            self.name = "<text>"
            line = source[:source.find("\0") + 1].count("\n") + 1
            check(lib.hawser_case_parse(c_text(source, f"<text>:{line}"), b"<text>", made, error), error)
        else:
            self.name = os.fspath(source)
            check(lib.hawser_case_load(c_path(self.name), made, error), error, self.name)
        c = owned(made)
        if folder is not None:
            check(lib.hawser_case_folder(c, c_path(folder), error), error)
        self._become(settle(c, set or {}))

    def _become(self, c: Any) -> None:
        self._c = c  # is never set: set() puts another one here, and who uses this one goes on with it
        self._setting = threading.Lock()

    @classmethod
    def _of(cls, name: str, c: Any) -> Case:
        case = cls.__new__(cls)
        case.name = name
        case._become(c)
        return case

    @classmethod
    def of_run(cls, folder: str | os.PathLike[str]) -> Case:
        """The case of the run whose checkpoint is in a folder of results, with all its settings."""
        made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
        check(lib.hawser_case_resume(c_path(folder), made, error), error, pathlib.Path(folder, "checkpoint.hawser"))
        return cls._of(os.fspath(folder), owned(made))

    def set(self, settings: Settings) -> Case:
        """Changes values by dotted key, all of them or, where one is wrong, none; later ones win. Returns the case. What runs already does
        not see it. RuntimeError: another thread is setting it."""
        if not self._setting.acquire(False):
            raise RuntimeError("this case is being set by another thread: let each thread set a copy()")
        try:
            if settings:
                self._c = settle(self._copied(), settings)
        finally:
            self._setting.release()
        return self

    def _copied(self) -> Any:
        made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
        check(lib.hawser_case_copy(self._c, made, error), error)
        return owned(made)

    def copy(self) -> Case:
        """A copy, to be set apart."""
        return self._of(self.name, self._c)

    def __copy__(self) -> Case:
        return self.copy()

    def __deepcopy__(self, _: object) -> Case:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        text, error = ffi.new("char **"), ffi.new("hawser_error *")
        check(lib.hawser_case_pack(self._c, text, error), error)
        try:
            return unpacked, (type(self), self.name, ffi.string(text[0]))
        finally:
            lib.hawser_text_free(text[0])

    def __getitem__(self, key: str) -> Any:
        """The value that the case gives under a dotted key, as set() takes it: case["friction.mu"], case["chain.0.length"]. Numbers without
        a unit are numbers, others texts; KeyError: the case does not give the key."""
        text, error = ffi.new("char **"), ffi.new("hawser_error *")
        status = lib.hawser_case_get(self._c, c_text(key, "a key"), text, error)
        if status == lib.HAWSER_ERR_INPUT:
            raise KeyError(text_of(error.message))
        check(status, error)
        return value_of(json.loads(taken(text)))

    def get(self, key: str, default: Any = None) -> Any:
        """The same; `default` where the case does not give the key."""
        try:
            return self[key]
        except KeyError:
            return default

    def __contains__(self, key: str) -> bool:
        return self.get(key, self) is not self

    __iter__ = None  # `in` takes dotted keys; as_dict() has all of them

    def as_dict(self) -> dict[str, Any]:
        """All that the case gives, as a dict from which the same case is made."""
        found: dict[str, Any] = self[""]
        return found

    def check(self) -> Case:
        """Interprets and checks everything that can be checked without running. Returns the case; raises CaseError."""
        error = ffi.new("hawser_error *")
        check(lib.hawser_case_check(self._c, error), error)
        return self

    def _text(self, call: Any, format: int) -> str:
        text, error = ffi.new("char **"), ffi.new("hawser_error *")
        check(call(self._c, format, text, error), error)
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

    def place(self, only: str = "any", lubricant: str | None = None, to: str | os.PathLike[str] | None = None) -> pd.DataFrame:
        """Where machines (of the push `theory.machine_push`, N) and pits go, the fewest that keep all limits: a row a proposal. only:
        "any", "machines" or "pits"; lubricant: jacket and duct of the catalogue's friction; to: file for the case with the best one.
        ValueError: another `only`; CaseError: the case has no limits, or is wrong; OutputError: `to` cannot be written."""
        kinds = {"any": lib.HAWSER_PLACE_ANY, "machines": lib.HAWSER_PLACE_MACHINES, "pits": lib.HAWSER_PLACE_PITS}
        if only not in kinds:
            raise ValueError(f"only={only!r}: allowed are {', '.join(kinds)}")
        kept = [ffi.new("char[]", lubricant.encode()) if lubricant else ffi.NULL, ffi.NULL if to is None else ffi.new("char[]", c_path(to))]
        options = ffi.new("hawser_place_options *", {"only": kinds[only], "lubricant": kept[0], "to": kept[1]})
        error, text = ffi.new("hawser_error *"), ffi.new("char **")
        check(lib.hawser_case_place(self._c, options, lib.HAWSER_JSON, text, ffi.NULL, error), error)
        return frame_of(json.loads(taken(text))["proposals"])

    def calculation(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Writes the pulling calculation as a page (HTML) that can be handed on and printed (docs/guide/plan-a-duct.md)."""
        error = ffi.new("hawser_error *")
        check(lib.hawser_case_calculation(self._c, lib.HAWSER_SI, c_path(path), ffi.NULL, error), error)
        return pathlib.Path(path)

    def crew_sheet(self, path: str | os.PathLike[str]) -> pathlib.Path:
        """Write the crew's sheet, one printed side: force by the place of the cable's front, trip setting, who stands where."""
        error = ffi.new("hawser_error *")
        check(lib.hawser_case_crew_sheet(self._c, lib.HAWSER_SI, c_path(path), ffi.NULL, error), error)
        return pathlib.Path(path)

    def sensitivities(self, *keys: str) -> Theory:
        """Derivatives of figures, with all tables under their names: without keys those of the pulling calculation; by dotted keys those
        of a run, which this computes; with "all" those of the position that the run ends at, by every number of the case."""
        from hawser.calculation import Theory

        if not keys:
            return Theory(json.loads(self._text(lib.hawser_case_sensitivities, lib.HAWSER_JSON)),
                          self._text(lib.hawser_case_sensitivities, lib.HAWSER_TABLE))
        names = [] if keys == ("all",) else [ffi.new("char[]", c_text(key, "a key")) for key in keys]
        compute = lib.hawser_case_run_sensitivities if names else lib.hawser_case_position_sensitivities
        text, data, error = ffi.new("char **"), ffi.new("char **"), ffi.new("hawser_error *")
        check(compute(self._c, len(names), ffi.new("char *[]", names), lib.HAWSER_TABLE, ffi.NULL, ffi.NULL, text, data, error), error)
        return Theory(json.loads(taken(data)), taken(text))

    def fmu(self, path: str | os.PathLike[str], *, version: int = 3) -> pathlib.Path:
        """Writes the case as a mock-up unit (docs/guide/fmi.md) for programs that simulate it together with other models. version: of FMI,
        3 or 2. Returns the path."""
        error = ffi.new("hawser_error *")
        check(lib.hawser_fmu_write(self._c, version, c_path(path), error), error)
        return pathlib.Path(path)

    def simulation(self, *, threads: int = 0) -> Simulation:
        """A simulation of the case as it is now. threads: 1 or 2; 0: the case's choice."""
        from hawser.simulation import Simulation

        return Simulation(self, threads=threads)

    def __str__(self) -> str:
        return self._text(lib.hawser_case_describe, lib.HAWSER_TABLE)

    def __repr__(self) -> str:
        return f"hawser.Case({self.name!r})"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


def packed(case: Case) -> tuple[dict[str, Any], str]:
    """What a case gives, with its settings, and the folder beside which its files are looked for; "": it has none."""
    text, error = ffi.new("char **"), ffi.new("hawser_error *")
    check(lib.hawser_case_pack(case._c, text, error), error)
    return case.as_dict(), str(json.loads(taken(text)).get("folder") or "")


def case_of(source: Source | Case, set: Settings | None) -> Case:
    """A case with settings. One that is given stays as it is: a copy has them, which nobody else sets."""
    return source.copy().set(set or {}) if isinstance(source, Case) else Case(source, set=set)


def unpacked(kind: type[Case], name: str, text: bytes) -> Case:
    """A pickled case."""
    made, error = ffi.new("hawser_case **"), ffi.new("hawser_error *")
    check(lib.hawser_case_unpack(text, made, error), error)
    return kind._of(name, owned(made))


def theory(case: Source | Case, *, set: Settings | None = None) -> Theory:
    """The pulling calculation of a case, from its file, text or dict: forces either way, station by station, limits."""
    return case_of(case, set).theory()
