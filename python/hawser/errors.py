"""What can go wrong, as exceptions."""
from __future__ import annotations

import errno
import os
from typing import Any

from hawser._native import ffi, lib

# What stands in place of a file: for what Case.set has brought; for a dict, whose lines nobody has seen.
SETTING, DICT = "--set ", "<dict>"


class Error(Exception):
    """Of everything that hawser refuses or fails at; the text says what is wrong and where."""

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class CaseError(Error, ValueError):
    """A case, a setting or an argument is wrong; nothing was computed or written.

    file: the case's file, "<text>" of a text; None where the fault is not in one
    key:  dotted key of the value, as in `set`: "drive.winch.speed"; None where none is to blame
    line: in the file, from 1; None of settings and dicts
    """

    file: str | None = None
    key: str | None = None
    line: int | None = None


class MissingError(CaseError, FileNotFoundError):
    """A file or folder that is to be read is not there; `filename` has its path."""

    def __init__(self, message: str, path: str | os.PathLike[str]) -> None:
        super().__init__(message)
        self.errno, self.filename, self.file = errno.ENOENT, os.fspath(path), os.fspath(path)

    def __reduce__(self) -> tuple[Any, ...]:
        return MissingError, (str(self), self.filename)


class RunError(Error, RuntimeError):
    """The integration failed; the text says when, where and what to try. The simulation is in its last good state.

    t:       simulated time then, s
    segment: of the whole chain, where it was at its wits' end; None: nowhere in particular
    result:  what a run had computed until then; None where nothing is written
    """

    t: float = 0.0
    segment: int | None = None
    result: object = None


class OutputError(Error, OSError):
    """A result could not be written."""


class Stopped(Error):
    """A call-back wanted no more."""


KINDS: dict[int, type[Error]] = {lib.HAWSER_ERR_INPUT: CaseError, lib.HAWSER_ERR_RUN: RunError, lib.HAWSER_ERR_OUTPUT: OutputError,
                                 lib.HAWSER_STOPPED: Stopped}


def told(error: Any) -> dict[str, Any]:
    """What C's error says; None of what is not known."""
    file = text_of(error.file)
    in_file = file and file != DICT and not file.startswith(SETTING)
    return {"message": text_of(error.message), "file": file if in_file else None, "key": text_of(error.key) or None,
            "line": error.line if in_file and error.line else None,
            "segment": error.segment if error.segment >= 0 else None, "t": error.t_s}


def error_from(status: int, message: str, **known: Any) -> BaseException:
    """The exception of a status other than OK."""
    if status == lib.HAWSER_ERR_MEMORY:
        return MemoryError(message)
    kind = KINDS.get(status, Error)
    found = kind(message)
    for name in getattr(kind, "__annotations__", {}):
        setattr(found, name, known.get(name))
    return found


def check(status: int, error: Any, path: str | os.PathLike[str] | None = None) -> None:
    """Raises what a call has returned, if it is not OK. path: what it was to read; that it is not there is an error of its own."""
    if status:
        raised = error_from(status, **told(error))
        raise MissingError(str(raised), path) if path is not None and not os.path.exists(path) else raised


def c_text(text: str, what: str, key: str | None = None) -> bytes:
    """A text for C, which would take a NUL for its end: that is refused. what: of messages."""
    if "\0" in text:
        raised = CaseError(f"{what}: a NUL character in a text")
        raised.key = key
        raise raised
    return text.encode()


def c_path(path: str | os.PathLike[str]) -> bytes:
    """A path for C, likewise."""
    found = os.fsencode(path)
    if b"\0" in found:
        raise CaseError(f"{os.fsdecode(path)!r}: a NUL character in a path")
    return found


def text_of(chars: Any) -> str:
    """A C string; names in files are not always UTF-8."""
    return "" if chars == ffi.NULL else str(ffi.string(chars), "utf-8", "replace")


def taken(text: Any) -> str:
    """What a call has put into a new char*[1], which is given back to the library."""
    try:
        return text_of(text[0])
    finally:
        lib.hawser_text_free(text[0])
