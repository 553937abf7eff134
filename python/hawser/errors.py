"""What can go wrong, as exceptions."""
from __future__ import annotations

import re
from typing import Any

from hawser._native import ffi, lib

# "FILE:LINE: key 'KEY': what", of which only the last must be there; what --set brought has no file and no line.
PLACE = re.compile(r"(?:--set (?P<set>\S+)|(?P<file>.*?)(?::(?P<line>\d+))?): (?:key '(?P<key>[^']*)': )?")


class Error(Exception):
    """Of everything that hawser refuses or fails at; the text says what is wrong and where."""


class CaseError(Error, ValueError):
    """A case, a setting or an argument is wrong; nothing was computed or written.

    file: the case's file or name; None where the fault is not in one
    key:  dotted key of the value, as in `set`: "drive.winch.speed"; None where none is to blame
    line: in the file, from 1; None of settings and dicts
    """

    file: str | None = None
    key: str | None = None
    line: int | None = None


class RunError(Error, RuntimeError):
    """The integration failed; the text says when, where and what to try. The simulation is in its last good state.

    result: what a run had computed until then; None where nothing is written
    """

    result: object = None


class OutputError(Error, OSError):
    """A result could not be written."""


class Stopped(Error):
    """A call-back wanted no more."""


def told(error: Any) -> dict[str, Any]:
    """What C's error says: message, file, key, line; None of what is not known."""
    message = text_of(error.message)
    place = PLACE.match(message)
    if not place or not (place["key"] or place["set"] or place["line"]):
        return {"message": message, "file": None, "key": None, "line": None}
    return {"message": message, "file": place["file"], "key": place["key"] or place["set"],
            "line": int(place["line"]) if place["line"] else None}


def error_from(status: int, message: str, file: str | None, key: str | None, line: int | None) -> BaseException:
    """The exception of a status other than OK."""
    if status == lib.HAWSER_ERR_MEMORY:
        return MemoryError(message)
    if status != lib.HAWSER_ERR_INPUT:
        kinds = {lib.HAWSER_ERR_RUN: RunError, lib.HAWSER_ERR_OUTPUT: OutputError, lib.HAWSER_STOPPED: Stopped}
        return kinds.get(status, Error)(message)
    found = CaseError(message)
    found.file, found.key, found.line = file, key, line
    return found


def check(status: int, error: Any) -> None:
    """Raises what a call has returned, if it is not OK."""
    if status:
        raise error_from(status, **told(error))


def text_of(chars: Any) -> str:
    """A C string; names in files are not always UTF-8."""
    return "" if chars == ffi.NULL else str(ffi.string(chars), "utf-8", "replace")


def taken(text: Any) -> str:
    """What a call has put into a new char*[1], which is given back to the library."""
    try:
        return text_of(text[0])
    finally:
        lib.hawser_text_free(text[0])
