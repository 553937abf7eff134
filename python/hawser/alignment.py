"""Routes out of files: drawings, models, tables and maps (docs/guide/routes-from-files.md)."""
from __future__ import annotations

import math
import os
import threading
from typing import Any, Callable

import numpy as np
import pandas as pd

from hawser._native import ffi, lib
from hawser._tables import frame, plain
from hawser.errors import c_path, c_text, check

Array = np.ndarray[Any, np.dtype[np.float64]]


def places(at: Callable[[float, Any], None], s: float | Array) -> dict[str, Array]:
    """The places s (m) that `at` fills in, as {"position", "tangent", "curvature"}, x y z in the last axis."""
    wanted, place = np.atleast_1d(np.asarray(s, float)), ffi.new("hawser_route_place *")
    found = np.empty((3, len(wanted), 3))
    for k, one in enumerate(wanted):
        at(float(one), place)
        found[:, k] = tuple(place.position_m), tuple(place.tangent), tuple(place.curvature_per_m)
    shaped = found.reshape(3, *np.shape(s), 3)
    return {"position": shaped[0], "tangent": shaped[1], "curvature": shaped[2]}


class Turn:
    """One thread at a time, the others wait. A forked process does not wait for threads that it has not got."""

    def __init__(self) -> None:
        self._lock, self._pid = threading.Lock(), os.getpid()

    def __enter__(self) -> None:
        forked = os.getpid() != self._pid
        if not self._lock.acquire(not forked):
            raise RuntimeError("a thread was at work with these routes as this process was forked: read them again")
        self._pid = os.getpid()

    def __exit__(self, *_: object) -> None:
        self._lock.release()


class Route:
    """One line of a file.

    name, layer: "" if it has none
    figures:     length_m (of the file's own line), horizontal_length_m, station_m, start_m and end_m (x, y, z), pieces,
                 fitted, least_radius_m (infinite: straight), deviation_max_m, rms_m
    problem:     why it cannot be a route; None: it can
    """

    def __init__(self, handle: Any, number: int, lock: Turn) -> None:
        self._c, self._number, self._lock = handle, number, lock  # of all lines of the file: C makes routes of them when they are first used
        found = ffi.new("hawser_route_figures *")
        self._call(lib.hawser_routes_figures, found)
        self.figures: dict[str, Any] = plain(found[0])
        self.name: str = self.figures.pop("name")
        self.layer: str = self.figures.pop("layer")
        self.problem: str | None = self.figures.pop("problem") or None

    def _call(self, function: Any, *arguments: Any) -> None:
        error = ffi.new("hawser_error *")
        with self._lock:
            status = function(self._c, self._number, *arguments, error)
        check(status, error)

    @property
    def length(self) -> float:
        """Of the route that would be built, in space, m."""
        found = ffi.new("double *")
        self._call(lib.hawser_routes_length, found)
        return float(found[0])

    def at(self, s: float | Array) -> dict[str, Array]:
        """The place s (m, one or many) along the route: "position" (m), "tangent" (unit) and "curvature" (1/m, toward the
        centre), each [..., 3] with x y z in the last axis. Beyond its ends it goes on straight."""
        return places(lambda one, place: self._call(lib.hawser_routes_at, one, place), s)

    @property
    def bends(self) -> pd.DataFrame:
        """Its arcs in plan as they would be built: station_m, length_m, turn (rad, to the left positive), radius_m, radius_sd_m (of a
        fit, one standard deviation; NaN: the file's own)."""
        n, made = ffi.new("int *"), ffi.new("hawser_route_bend **")
        self._call(lib.hawser_routes_bends, n, made)
        try:
            return frame("hawser_route_bend", made[0], n[0])
        finally:
            lib.hawser_route_bends_free(made[0])

    def write(self, path: str | os.PathLike[str]) -> None:
        """As it would be built: a table (.csv), a drawing (.dxf), a map (.geojson) or a case's section `route` (.yaml)."""
        self._call(lib.hawser_routes_write, c_path(path))

    def __repr__(self) -> str:
        return f"<hawser route {self.name!r}: {self.problem or format(self.figures['length_m'], '.6g') + ' m'}>"


def routes(path: str | os.PathLike[str], *, name: str | None = None, layer: str | None = None, units: str | None = None,
           profile: str | os.PathLike[str] | None = None, reverse: bool = False, from_m: float = math.nan,
           to_m: float = math.nan, tolerance_m: float | None = None, radius_m: float = math.nan,
           join_m: float | None = None, sheet: str | None = None, ignore: list[str] | None = None) -> list[Route]:
    """The routes that a file holds (DXF, LandXML, IFC, tables, spreadsheets, GeoJSON, KML, GPX, shapefiles).

    name, layer:  only lines of this name, on this layer
    units:        the file's unit of length, in place of what it says: "mm", "ft"
    profile:      another file from which the heights come
    reverse:      from end to start
    from_m, to_m: stations between which the line is used
    tolerance_m:  by which the route may be off the line (default 0.05)
    radius_m:     of the corners of lines of points, which are fitted otherwise
    join_m:       within which ends of a drawing's pieces meet (default 0.01)
    sheet:        of a spreadsheet, by its name or its number from 1 (default: the first)
    ignore:       names of a table's columns that are not used

    CaseError: it cannot be read, holds no line, or an option fits none; MissingError: there is no such file.
    """
    error, made = ffi.new("hawser_error *"), ffi.new("hawser_routes **")
    options = ffi.new("hawser_route_options *", lib.hawser_route_defaults())
    texts = {"name": name, "layer": layer, "units": units, "profile": None if profile is None else os.fsdecode(profile), "sheet": sheet,
             "ignore": None if ignore is None else ",".join(ignore)}
    kept = {key: ffi.new("char[]", c_text(text, key)) for key, text in texts.items() if text is not None}
    for key, text in kept.items():
        setattr(options, key, text)
    options.reverse, options.from_m, options.to_m, options.radius_m = reverse, from_m, to_m, radius_m
    options.tolerance_m = options.tolerance_m if tolerance_m is None else tolerance_m
    options.join_m = options.join_m if join_m is None else join_m
    check(lib.hawser_routes_read(c_path(path), options, made, error), error, path)
    handle = ffi.gc(made[0], lib.hawser_routes_free)
    lock = Turn()
    return [Route(handle, k, lock) for k in range(lib.hawser_routes_count(handle))]
