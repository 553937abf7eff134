"""The shipped catalogue of cables, ropes, rollers, ducts, friction and reels (docs/guide/equipment.md), and what a case may hold."""
from __future__ import annotations

import json
from typing import Any

import pandas as pd

from hawser._native import ffi, lib
from hawser._tables import frame_of
from hawser.errors import c_text, check, taken


def library(kind: str | None = None, pattern: str | None = None) -> pd.DataFrame:
    """The catalogue's entries with figures, ranges, marks and sources.

    kind:    "cables", "ropes", "rollers", "ducts", "friction" or "reels"; None: all
    pattern: of it those whose names hold this text; None: all

    CaseError: there is no such kind, or no catalogue.
    """
    error, text = ffi.new("hawser_error *"), ffi.new("char **")
    wanted = [ffi.NULL if word is None else c_text(word, "the catalogue") for word in (kind, pattern)]
    check(lib.hawser_library(*wanted, lib.HAWSER_JSON, text, error), error)
    return frame_of(json.loads(taken(text))["entries"])


def schema(of: str = "case") -> dict[str, Any]:
    """What a case, study, job or summary may hold, as a JSON Schema (draft 2020-12): keys, kinds, choices, ranges in SI,
    defaults. Another word for `of` is a ValueError."""
    calls = {"case": lib.hawser_case_schema, "study": lib.hawser_study_schema, "job": lib.hawser_job_schema,
             "summary": lib.hawser_summary_schema}
    if of not in calls:
        raise ValueError(f"schema: {of!r}: allowed are {', '.join(calls)}")
    error, text = ffi.new("hawser_error *"), ffi.new("char **")
    check(calls[of](text, error), error)
    read: dict[str, Any] = json.loads(taken(text))
    return read
