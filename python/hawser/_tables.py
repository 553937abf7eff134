"""From C's rows and the documents' tables to pandas; from C's arrays to numpy, without copies."""
from __future__ import annotations

import html
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


def kinds_of(struct: str) -> dict[str, Any]:
    """{member: its type} of those that fit into a cell: no pointers but texts, and no number of a kind that has a name."""
    fields = ffi.typeof(struct).fields
    return {name: field.type for name, field in fields
            if (field.type.kind != "pointer" or field.type.item.cname == "char")
            and not (field.type.kind == "enum" and name == "kind" and any(other == "name" for other, _ in fields))}


def is_text(kind: Any) -> bool:
    return bool(kind.kind == "pointer" or kind.kind == "array" and kind.item.cname == "char")


def numbers_of(struct: str, rows: Any, n: int) -> np.ndarray[Any, Any]:
    """The numbers of C's rows as a numpy array with a field for each member; a view, good as long as the rows are."""
    formats = {"double": "<f8", "int": "<i4"}
    fields = {}
    for name, field in ffi.typeof(struct).fields:
        kind = field.type.item if field.type.kind == "array" else field.type
        if kind.kind == "enum" or kind.cname in formats:
            shape = (field.type.length,) if field.type.kind == "array" else ()
            fields[name] = ((formats.get(kind.cname, "<u4"), shape), field.offset)
    layout = np.dtype({"names": list(fields), "formats": [f for f, _ in fields.values()],
                       "offsets": [o for _, o in fields.values()], "itemsize": ffi.sizeof(struct)})
    return np.frombuffer(ffi.buffer(rows, n * ffi.sizeof(struct)), layout) if n else np.empty(0, layout)


def parts_of(name: str) -> list[str]:
    """Columns of a vector: force_N is force_x_N, force_y_N, force_z_N."""
    stem, *unit = name.split("_", 1)
    return ["_".join([stem, axis, *unit]) for axis in "xyz"]


def frame(struct: str, rows: Any, n: int, rename: Mapping[str, str] | None = None) -> pd.DataFrame:
    """A table of C's rows: a column for each member, three for a vector. What the header says of each stands in
    `attrs["columns"]`."""
    numbers, data, told = numbers_of(struct, rows, n), {}, {}
    for member, kind in kinds_of(struct).items():
        name = (rename or {}).get(member, member)
        columns: dict[str, Any] = {}
        if is_text(kind):
            columns = {name: [text_of(getattr(rows[i], member)) for i in range(n)]}
        elif kind.kind == "array":
            columns = dict(zip(parts_of(name), numbers[member].T.copy()))
        elif member in numbers.dtype.names:
            columns = {name: numbers[member].astype(bool if member in FLAGS else numbers[member].dtype)}
        data.update(columns)
        told.update(dict.fromkeys(columns, MEMBERS[struct][member]))
    table = pd.DataFrame(data)
    table.attrs["columns"] = told
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


def page_html(title: str, verdict: str, rows: Iterable[tuple[str, str]] = (), table: pd.DataFrame | None = None) -> str:
    """What a notebook shows of a thing: its title, its verdict, figures, a table."""
    figures = "".join(f"<tr><th style='text-align:left'>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in rows)
    below = table.to_html(index=False, float_format=lambda x: f"{x:.4g}", max_rows=20) if table is not None and len(table) else ""
    return (f"<h4>{html.escape(title)}</h4><p><b>{html.escape(verdict)}</b></p>"
            f"{f'<table>{figures}</table>' if figures else ''}{below}")
