"""The things of a case by the names that it gives them: simulation.roller("P28").force."""
from __future__ import annotations

import difflib
import math
from typing import TYPE_CHECKING, Any, Iterable

import numpy as np
import pandas as pd

from hawser.sample import Array

if TYPE_CHECKING:
    from hawser.looking import Looking


def place_of(name: str, names: Iterable[str], kind: str) -> int:
    """Where the name stands among the names, once. Raises KeyError with what is there instead."""
    there = list(names)
    if there.count(name) == 1:
        return there.index(name)
    if name in there:
        raise KeyError(f"{there.count(name)} {kind}s are called {name!r}: take the table, by row")
    near = difflib.get_close_matches(str(name), there, 1)
    said = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(there[:12])}{' ...' if len(there) > 12 else ''}" if there else "there is none"
    raise KeyError(f"no {kind} {name!r}: {said}")


def row_of(table: pd.DataFrame, name: str, kind: str) -> pd.Series[Any]:
    """The row of a table whose `name` it is, as a Series. Raises KeyError."""
    return table.iloc[place_of(name, table["name"] if "name" in table else (), kind)]


class Thing:
    """A thing of a simulation. It shows the simulation as it is when a member is read, and keeps it alive."""

    kind = "thing"

    def __init__(self, simulation: Looking, name: str, index: int) -> None:
        self._simulation = simulation
        self.name = name
        self.index = index  # in the arrays of a sample and the tables of the simulation

    @property
    def force(self) -> float:
        """Now, N. NotImplementedError: the kind has none."""
        raise NotImplementedError

    def _table(self) -> pd.DataFrame:
        raise NotImplementedError

    @property
    def so_far(self) -> dict[str, Any]:
        """What has been recorded of it so far: its row of the simulation's table, SI units at the names' ends."""
        return {str(key): value for key, value in self._table().iloc[self.index].items()}

    def __repr__(self) -> str:
        return f"<hawser {self.kind} {self.name!r}: {self.force:.6g} N>"


class Roller(Thing):
    """A roller of a simulation."""

    kind = "roller"

    def _one(self, name: str) -> float:
        values = getattr(self._simulation._latest(), name)
        return float(values[self.index]) if values.size else math.nan

    def _table(self) -> pd.DataFrame:
        return self._simulation.rollers

    @property
    def force(self) -> float:
        """Size of the contact force on it now, N."""
        return self._one("roller_load")

    @property
    def vector(self) -> Array:
        """The contact force on it now, [3], N, world components; a copy."""
        return np.array(self._simulation._latest().roller_force[self.index])

    @property
    def spin(self) -> float:
        """How it turns about its axis now, rad/s; NaN: it does not."""
        return self._one("roller_spin")

    @property
    def shift(self) -> float:
        """How far it is from its place on its mount now, m; NaN: it has no mount."""
        return self._one("roller_shift")


class Surface(Thing):
    """A duct, tray, floor, wall or ceiling of a simulation."""

    kind = "surface"

    def _table(self) -> pd.DataFrame:
        return self._simulation.surfaces

    def _one(self, name: str) -> float:
        return float(getattr(self._simulation._latest(), name)[self.index])

    @property
    def force(self) -> float:
        """Sum of the normal forces on it now, N."""
        return self._one("surface_normal")

    @property
    def friction(self) -> float:
        """Sum of the friction forces on it now, N."""
        return self._one("surface_friction")

    @property
    def line_load(self) -> float:
        """The largest normal force per length of cable on it now, N/m."""
        return self._one("surface_line_load")

    @property
    def line_load_at(self) -> float:
        """Where that is, m along the route; NaN: nowhere, or not along it."""
        return self._one("surface_at")


class Machine(Thing):
    """A conveyor or the motor of a roller, of a simulation."""

    kind = "machine"

    @property
    def now(self) -> dict[str, float]:
        """What it shows now: {figure with its unit: value}."""
        return self._simulation._latest().machines[self.name]

    @property
    def so_far(self) -> dict[str, Any]:
        """The figures of the run so far: {figure with its unit: value}."""
        return dict(self._simulation.machines[self.name])

    @property
    def force(self) -> float:
        """The force by which it moves the cable now, N; NaN: it shows none."""
        return self.now.get("force_N", math.nan)


class Conveyor(Machine):
    """A conveyor of a simulation."""

    kind = "conveyor"


class Winch:
    """The winch of a simulation, at the chain's head."""

    def __init__(self, simulation: Looking) -> None:
        self._simulation = simulation

    @property
    def force(self) -> float:
        """Pull on the rope's end along the winch's direction now, N."""
        return self._simulation._latest().winch_force

    @property
    def speed(self) -> float:
        """Prescribed now, m/s; with a set tension, the head's."""
        return self._simulation._latest().winch_speed

    @property
    def travel(self) -> float:
        """Hauled in so far, m."""
        return self._simulation._latest().winch_travel

    def __repr__(self) -> str:
        return f"<hawser winch: {self.force:.6g} N, {self.speed:.6g} m/s>"
