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
    """
    error, text = ffi.new("hawser_error *"), ffi.new("char **")
    wanted = [ffi.NULL if word is None else c_text(word, "the catalogue") for word in (kind, pattern)]
    check(lib.hawser_library(*wanted, lib.HAWSER_JSON, text, error), error)
    return frame_of(json.loads(taken(text))["entries"])


def schema() -> dict[str, Any]:
    """What a case may hold, as a JSON Schema (draft 2020-12): keys, kinds, choices, ranges in SI, defaults."""
    error, text = ffi.new("hawser_error *"), ffi.new("char **")
    check(lib.hawser_case_schema(text, error), error)
    read: dict[str, Any] = json.loads(taken(text))
    return read
