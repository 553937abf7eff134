"""Dicts that C reads as files: studies and jobs. What they name is looked for beside a folder that the caller gives."""
from __future__ import annotations

import contextlib
import hashlib
import os
import pathlib
import tempfile
from collections.abc import Iterator, Mapping
from typing import Any, Union

from hawser.case import Case, packed, simple, yaml_of
from hawser.errors import DICT, CaseError

Plan = Union[str, "os.PathLike[str]", Mapping[str, Any]]
NAMING = ("file", "include")  # keys of a case whose texts are paths


def beside(value: Any, folder: str, naming: tuple[str, ...] = NAMING, key: str = "") -> Any:
    """The value with the paths below it made absolute, as they stand beside the folder."""
    if isinstance(value, Mapping):
        return {name: beside(item, folder, naming, name) for name, item in value.items()}
    if isinstance(value, list):
        return [beside(item, folder, naming, key) for item in value]
    return os.path.join(folder, value) if isinstance(value, str) and value and key in naming else value


def kept(value: Any, to: pathlib.Path, stem: str) -> pathlib.Path:
    """The value in a file of the folder whose name has its sum, so that the same value is the same file and no other one's."""
    text = yaml_of(value) + "\n"
    path = to / f"{stem}-{hashlib.sha256(text.encode()).hexdigest()[:12]}.yaml"
    if not path.exists():
        to.mkdir(parents=True, exist_ok=True)
        whole = path.with_suffix(".new")
        whole.write_text(text, encoding="utf-8")
        whole.replace(path)
    return path


def study_file(plan: Mapping[str, Any], to: pathlib.Path, folder: str) -> pathlib.Path:
    """A study's dict as a file in the folder of its results, where who goes on with it or makes its page finds it. Its `case` may be a
    path, a dict or a Case; values of `set` are as Case.set takes them."""
    of = {name: value for name, value in plan.items() if name not in ("case", "set")}
    base = plan.get("case")
    if isinstance(base, (Case, Mapping)):
        text, beside_it = packed(base if isinstance(base, Case) else Case(base, folder=folder))
        base = kept(beside(text, beside_it), to, "case")
    known = simple(of, "")
    for way, name in (("list", "file"), ("calibrate", "log")):
        if isinstance(known.get(way), dict):
            known[way] = beside(known[way], folder, (name,))
    if "set" in plan:
        settings = plan["set"]
        known["set"] = {name: yaml_of(value, name) for name, value in settings.items()} if isinstance(settings, Mapping) else settings
    if base is not None:
        known["case"] = os.path.join(folder, os.fspath(base))
    return kept(known, to, "study")


@contextlib.contextmanager
def job_file(plan: Plan, folder: str | os.PathLike[str] | None) -> Iterator[str | os.PathLike[str]]:
    """The path of a job, which of a dict is a file that is there meanwhile."""
    if not isinstance(plan, Mapping):
        yield plan
        return
    with tempfile.TemporaryDirectory(prefix="hawser-") as scratch:
        path = kept(beside(simple(plan, ""), os.path.abspath(folder or os.curdir), (*NAMING, "case")), pathlib.Path(scratch), "job")
        try:
            yield path
        except CaseError as error:
            raise of_dict(error, path) from None


def of_dict(error: CaseError, path: pathlib.Path) -> CaseError:
    """The error with the dict in place of the file that nobody has written."""
    found = CaseError(str(error).replace(str(path), DICT))
    found.key = error.key
    if error.file != str(path):
        found.file, found.line = error.file, error.line
    return found
