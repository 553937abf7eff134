"""From C's rows and the documents' tables to pandas; from C's arrays to numpy, without copies."""
from __future__ import annotations

import math
from typing import Any, Iterable, Mapping

import numpy as np
import pandas as pd

from hawser._declared import MEMBERS
from hawser._native import ffi
from hawser.errors import text_of

FLAGS = {"judged", "ok", "holds", "reached"}  # int in C, yes or no in meaning


class Block:
    """Numbers that C owns, as numpy asks for them: `owner` lives as long as any array made of it."""

    def __init__(self, owner: object, pointer: Any, shape: tuple[int, ...]) -> None:
        self.owner = owner
        self.__array_interface__ = {"version": 3, "typestr": "<f8", "shape": shape,
                                    "data": (int(ffi.cast("uintptr_t", pointer)), True)}


def view(owner: object, pointer: Any, *shape: int) -> np.ndarray[Any, np.dtype[np.float64]]:
    """An array of C's doubles that cannot be written; `owner` is what must not be freed before it."""
    if pointer == ffi.NULL or 0 in shape:
        return np.empty(shape if pointer != ffi.NULL or 0 in shape else (0,))
    return np.asarray(Block(owner, pointer, shape))


def plain(value: Any, name: str = "") -> Any:
    """A member of a struct as Python has it: texts, numbers, flags, tuples of numbers; the rest as it is."""
    if not isinstance(value, ffi.CData):
        return bool(value) if name in FLAGS else value
    kind = ffi.typeof(value)
    if kind.cname in ("char *", "const char *") or kind.kind == "array" and kind.item.cname == "char":
        return text_of(value)
    if kind.kind == "array":
        return tuple(value)
    if kind.kind == "struct":
        return {member: plain(getattr(value, member), member) for member, _ in kind.fields}
    return value


def columns_of(struct: str) -> list[str]:
    """Names of the members that fit into a cell: no pointers but texts."""
    return [name for name, field in ffi.typeof(struct).fields
            if field.type.kind != "pointer" or field.type.item.cname == "char"]


def frame(struct: str, rows: Any, n: int, rename: Mapping[str, str] | None = None) -> pd.DataFrame:
    """A table of C's rows: a column for each member, whose comment in the header stands in `attrs["units"]`."""
    names = columns_of(struct)
    data = {name: [plain(getattr(rows[i], name), name) for i in range(n)] for name in names}
    table = pd.DataFrame(data, columns=names).rename(columns=dict(rename or {}))
    table.attrs["columns"] = {(rename or {}).get(name, name): MEMBERS[struct][name] for name in names}
    return table


def figures(figure: Any, n: int) -> dict[str, float]:
    """C's figures by name."""
    return {text_of(figure[i].key): figure[i].value for i in range(n)}


def frame_of(rows: Iterable[Mapping[str, Any]]) -> pd.DataFrame:
    """A table of a JSON list of objects. What is not known is NaN, a flag that is not known None."""
    listed = list(rows)
    table = pd.DataFrame(listed)
    for name in table.columns:
        values = [row.get(name) for row in listed]
        if any(isinstance(v, bool) for v in values):
            table[name] = pd.Series(values, dtype=object) if None in values else pd.Series(values, dtype=bool)
        elif all(v is None or isinstance(v, (int, float)) for v in values):
            table[name] = pd.Series([math.nan if v is None else v for v in values], dtype=float)
    return table


def shown(value: float, unit: str) -> str:
    """A figure as people read it: "12.83 kN"."""
    from hawser._native import lib

    text = ffi.new("char[]", lib.HAWSER_SHOWN_MAX)
    return text_of(lib.hawser_show(value, unit.encode(), lib.HAWSER_SI, text))
