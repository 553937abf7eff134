"""What a simulation shows, at any time: how it is now, its tables so far, what it stands in."""
from __future__ import annotations

import json
from typing import Any, NamedTuple

import numpy as np
import pandas as pd

from hawser._callbacks import enum_names, event_kind
from hawser._handle import Handle
from hawser._native import ffi, lib
from hawser._tables import figures, frame, plain, view
from hawser.alignment import Array, places
from hawser.errors import taken, text_of
from hawser.results import Verdict
from hawser.sample import Sample
from hawser.things import Conveyor, Machine, Roller, Surface, Winch, place_of

PARTNERS = enum_names("hawser_partner", "HAWSER_ON_")


class Geometry(NamedTuple):
    """What stands around the cable, as it was built."""

    rollers: pd.DataFrame  # name, kind, along_m, centre, axis, radius_m, width_m
    surfaces: pd.DataFrame  # name, kind, from_m, to_m, diameter_m, width_m, height_m
    lines: list[Array]  # of each surface's middle, [n, 3], m
    conveyors: pd.DataFrame  # name, from_m, to_m, where the cable enters and leaves
    length_m: Array  # [segments]
    diameter_m: Array  # [segments]
    winch: dict[str, Any] | None  # "m": its place, "direction" of its pull
    reel: dict[str, Any] | None  # "m": its centre, "axis", "barrel_m", "flange_m" (radii), "width_m"


class Looking:
    """The part of a Simulation that changes nothing."""

    _handle: Handle | None
    _sampled: Sample | None = None

    @property
    def _open(self) -> Handle:
        if self._handle is None:
            raise RuntimeError("this simulation was closed")
        return self._handle

    @property
    def time(self) -> float:
        """Where it is, s."""
        with self._open as c:
            return float(lib.hawser_sim_time(c))

    @property
    def end_time(self) -> float:
        """The case's duration, s; earlier once a winch that tripped has ended the run."""
        with self._open as c:
            return float(lib.hawser_sim_end_time(c))

    @property
    def title(self) -> str:
        """The case's title, or its file's name."""
        with self._open as c:
            return text_of(lib.hawser_sim_title(c))

    def sample(self) -> Sample:
        """How everything is now."""
        handle = self._open
        with handle as c:
            handle.moved += 1
            self._sampled = Sample(handle, lib.hawser_sim_sample(c))
            return self._sampled

    def _latest(self) -> Sample:
        """The last sample, if it is still good, so that who holds it may go on with it; else a new one."""
        last = self._sampled
        return last if last is not None and last._handle is self._open and last._moved == last._handle.moved else self.sample()

    def _table(self, call: Any, struct: str, rename: dict[str, str] | None = None) -> pd.DataFrame:
        rows, summary = ffi.new(f"const {struct} **"), ffi.new("hawser_summary *")
        with self._open as c:
            lib.hawser_sim_summary(c, summary)  # brings the rows' error bars up to date
            n = call(c, rows)
            return frame(struct, rows[0], n, rename)

    @property
    def stations(self) -> pd.DataFrame:
        """Tension along the route so far: name, s_m, paper_N, reference_N, mean_N, peak_N, mean_error_N, peak_error_N."""
        return self._table(lib.hawser_sim_stations, "hawser_station", {"s": "s_m"})

    @property
    def rollers(self) -> pd.DataFrame:
        """The rollers so far: name, s_m, rating_N, initial_N, steady_N, peak_N and more."""
        return self._table(lib.hawser_sim_rollers, "hawser_roller", {"s": "s_m"})

    @property
    def surfaces(self) -> pd.DataFrame:
        """Ducts, trays, floors and walls so far: normal_N, friction_N, line_load_N_per_m and more."""
        return self._table(lib.hawser_sim_surfaces, "hawser_surface")

    @property
    def events(self) -> pd.DataFrame:
        """What happened so far: t (s), what (in words), kind ("winch_trips", "command" ...), pull_N."""
        table = self._table(lib.hawser_sim_events, "hawser_event")
        table.insert(2, "kind", [event_kind(code) for code in table.pop("code")])
        return table

    @property
    def positions(self) -> pd.DataFrame:
        """The pull by place of the cable's front so far: head_m, pull_N, reference_N, error_pct."""
        return self._table(lib.hawser_sim_positions, "hawser_position")

    @property
    def places(self) -> pd.DataFrame:
        """Steady motion by place of the front, of a run with `analysis: positions`; columns as positions.csv, SI."""
        return self._table(lib.hawser_sim_places, "hawser_place")

    @property
    def modes(self) -> pd.DataFrame:
        """Vibrations: frequency_Hz, growth_per_s, omega_squared (1/s2); none before the end of a run with `analysis: modes`."""
        return self._table(lib.hawser_sim_modes, "hawser_mode")

    @property
    def assumptions(self) -> pd.DataFrame:
        """Values that the case did not give itself: key, value, origin ("given", "catalogue", "estimated", "not read"), source."""
        return self._table(lib.hawser_sim_assumptions, "hawser_assumption")

    @property
    def machines(self) -> dict[str, dict[str, float]]:
        """What conveyors, motors and the like have done so far: {name: {figure with its unit: value}}."""
        rows = ffi.new("const hawser_machine **")
        with self._open as c:
            n = lib.hawser_sim_machines(c, rows)
            return {text_of(rows[0][i].name): figures(rows[0][i].figure, rows[0][i].n_figures) for i in range(n)}

    # ------------------------------------------------------------------------------------------------ things by name

    def _names(self, call: Any, struct: str) -> list[str]:
        rows = ffi.new(f"const {struct} **")
        with self._open as c:
            return [text_of(rows[0][i].name) for i in range(call(c, rows))]

    def roller(self, name: str) -> Roller:
        """The roller of that name: .force (N), .vector, .spin, .shift, .so_far. KeyError: there is none, or more than one."""
        return Roller(self, name, place_of(name, self._names(lib.hawser_sim_rollers, "hawser_roller"), "roller"))

    def surface(self, name: str) -> Surface:
        """The duct, tray, floor, wall or ceiling of that name: .force (N), .friction (N), .line_load (N/m), .so_far. KeyError."""
        return Surface(self, name, place_of(name, self._names(lib.hawser_sim_surfaces, "hawser_surface"), "surface"))

    def _machine(self, name: str, kinds: tuple[str, ...], kind: str) -> int:
        rows = ffi.new("const hawser_machine **")
        with self._open as c:
            there = [(text_of(rows[0][i].name), i) for i in range(lib.hawser_sim_machines(c, rows)) if not kinds or text_of(rows[0][i].kind) in kinds]
        return there[place_of(name, [own for own, _ in there], kind)][1]

    def conveyor(self, name: str) -> Conveyor:
        """The conveyor of that name: .force (N), .now, .so_far (figures by name). KeyError."""
        return Conveyor(self, name, self._machine(name, ("conveyors",), "conveyor"))

    def machine(self, name: str) -> Machine:
        """The conveyor or motor of that name: .force (N), .now, .so_far (figures by name). KeyError."""
        return Machine(self, name, self._machine(name, (), "machine"))

    @property
    def winch(self) -> Winch:
        """The winch: .force (N), .speed (m/s), .travel (m)."""
        return Winch(self)

    @property
    def limits(self) -> pd.DataFrame:
        """The limits of the case, judged by what has been recorded so far: name, value, limit, unit, margin, ok (None: not
        judged), where, source."""
        rows = ffi.new("hawser_limit[]", lib.HAWSER_LIMITS_MAX)
        with self._open as c:
            table = frame("hawser_limit", rows, lib.hawser_sim_limits(c, rows))
        table["ok"] = [bool(ok) if judged else None for ok, judged in zip(table["ok"], table["judged"])]
        return table

    @property
    def trust(self) -> pd.DataFrame:
        """The conditions under which the run is worth judging: name, unit, value, allowed, holds, remedy."""
        summary = ffi.new("hawser_summary *")
        with self._open as c:
            lib.hawser_sim_summary(c, summary)
            return frame("hawser_condition", summary.conditions, summary.n_conditions)

    @property
    def verdict(self) -> Verdict:
        """Whether the pull is safe by what has been recorded so far."""
        limits, summary = ffi.new("hawser_limit[]", lib.HAWSER_LIMITS_MAX), ffi.new("hawser_summary *")
        text = ffi.new("char[]", lib.HAWSER_VERDICT_MAX)
        with self._open as c:
            lib.hawser_sim_summary(c, summary)
            lib.hawser_verdict(summary.n_conditions, summary.conditions, lib.hawser_sim_limits(c, limits), limits, text,
                               lib.HAWSER_VERDICT_MAX)
        return Verdict(text_of(text))

    @property
    def answer(self) -> str:
        """The verdict with what it rests on, as a report begins."""
        text = ffi.new("char[]", lib.HAWSER_ANSWER_MAX)
        with self._open as c:
            return text_of(lib.hawser_sim_answer(c, lib.HAWSER_SI, text, lib.HAWSER_ANSWER_MAX))

    @property
    def summary(self) -> dict[str, Any]:
        """The run so far in numbers, as summary.json has it; what is not known is None."""
        text, handle = ffi.new("char **"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_summary_json(c, text, handle.error))
        found: dict[str, Any] = json.loads(taken(text))
        return found

    # ------------------------------------------------------------------------------------------------ a close look

    @property
    def contacts(self) -> pd.DataFrame:
        """Where the cable is pressed now: partner ("roller", "surface", "cable"), index (of that, or the other segment),
        segment, point (m), normal (toward the cable), normal_N, force (N, on the cable), slip_m_per_s, gap_m."""
        rows, n, handle = ffi.new("const hawser_contact **"), ffi.new("int *"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_contacts(c, rows, n, handle.error))
            table = frame("hawser_contact", rows[0], n[0])
        table["partner"] = [PARTNERS[number] for number in table["partner"]]
        return table

    @property
    def cable(self) -> pd.DataFrame:
        """The cable now, joint by joint from the tail (the index is the joint's number): from_tail_m, along_m, position,
        tension_N, shear_N, torsion_N_m, bending_N_m, curvature_per_m, sidewall_N_per_m."""
        rows, n, first, handle = ffi.new("const hawser_cable_point **"), ffi.new("int *"), ffi.new("int *"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_cable(c, rows, n, first, handle.error))
            table = frame("hawser_cable_point", rows[0], n[0])
        table.index = pd.RangeIndex(first[0], first[0] + n[0], name="joint")
        return table

    def envelope(self, *, along_route: bool = True) -> pd.DataFrame:
        """Least, mean and largest tension (N), curvature (1/m) and sidewall pressure (N/m) by place along the route, or by joint
        of the cable (at_m from its tail), of all that was recorded since watch_envelope()."""
        found, handle = ffi.new("hawser_envelope *"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_envelope(c, along_route, found, handle.error))
            columns = {name: getattr(found, name) for name in ("at_m", "time_s")}
            for name in ("tension_N", "curvature_per_m", "sidewall_N_per_m"):
                stem, unit = name.split("_", 1)
                columns.update({f"{stem}_{kind}_{unit}": getattr(getattr(found, name), kind)
                                for kind in ("least", "mean", "largest")})
            return pd.DataFrame({name: np.array(view(handle, pointer, found.n)) for name, pointer in columns.items()})

    @property
    def geometry(self) -> Geometry:
        """What stands around the cable."""
        found, handle = ffi.new("const hawser_geometry **"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_geometry(c, found, handle.error))
        g = found[0]
        end = {name: {key: plain(getattr(g, f"{name}_{key}")) for key in keys} if getattr(g, f"has_{name}") else None
               for name, keys in (("winch", ("m", "direction")), ("reel", ("m", "axis", "barrel_m", "flange_m", "width_m")))}
        return Geometry(frame("hawser_roller_shape", g.roller, g.rollers), frame("hawser_surface_shape", g.surface, g.surfaces),
                        [view(handle, g.surface[k].points_m, g.surface[k].n, 3) for k in range(g.surfaces)],
                        frame("hawser_conveyor_shape", g.conveyor, g.conveyors),
                        view(handle, g.length_m, g.segments), view(handle, g.diameter_m, g.segments), **end)

    @property
    def route_length(self) -> float:
        """Of the route, m."""
        found, handle = ffi.new("double *"), self._open
        with handle as c:
            handle.check(lib.hawser_sim_route_length(c, found, handle.error))
        return float(found[0])

    def route_at(self, s: float | Array) -> dict[str, Array]:
        """The place s (m, one or many) along the route: "position" (m), "tangent" (unit), "curvature" (1/m, toward the centre),
        each [..., 3] with x y z in the last axis. Beyond its ends it goes on straight."""
        handle = self._open
        with handle as c:
            return places(lambda one, place: handle.check(lib.hawser_sim_route_at(c, one, place, handle.error)), s)
