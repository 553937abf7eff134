"""How a simulation is at one moment; its arrays are C's own."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from hawser._declared import MEMBERS
from hawser._handle import Handle
from hawser._tables import figures, plain, view
from hawser.errors import text_of

if TYPE_CHECKING:
    import xarray

Array = np.ndarray[Any, np.dtype[np.float64]]

# The arrays of a sample: how many rows, and how many numbers in each (0: the rows are the numbers).
SHAPES = {"position": ("segments", 3), "quaternion": ("segments", 4), "velocity": ("segments", 3), "omega": ("segments", 3),
          "tension": ("joints", 0), "axial_speed": ("segments", 0), "roller_load": ("rollers", 0),
          "roller_spin": ("rollers", 0), "roller_shift": ("rollers", 0), "surface_normal": ("surfaces", 0),
          "surface_friction": ("surfaces", 0), "surface_line_load": ("surfaces", 0), "surface_at": ("surfaces", 0),
          "curvature": ("joints", 0), "sidewall": ("joints", 0), "contact_line_load": ("segments", 0),
          "roller_force": ("rollers", 3)}


class Sample:
    """One look at a simulation, in SI units and world components.

    It is good until the simulation moves on: then its members raise RuntimeError. Arrays are views of the simulation's
    own memory: they cannot be written, are never copied, keep it alive, and show its latest sample; copy what is to be kept
    (as_dict copies everything).
    """

    __slots__ = ("_handle", "_c", "_moved")

    t: float  # s
    segments: int
    joints: int
    rollers: int
    surfaces: int
    first: int
    active: int
    winch_force: float  # N
    tail_tension: float  # N
    winch_speed: float  # m/s
    winch_travel: float  # m
    max_tension: float  # N
    max_tension_joint: int
    active_contacts: int
    reel_speed: float  # rad/s
    paid_out: float  # m
    wound: float  # m
    head_at: float  # m
    reference: float  # N
    step_size: float  # s
    position: Array  # [segments, 3], m
    quaternion: Array  # [segments, 4], w x y z
    velocity: Array  # [segments, 3], m/s
    omega: Array  # [segments, 3], rad/s
    tension: Array  # [joints], N
    axial_speed: Array  # [segments], m/s
    roller_load: Array  # [rollers], N
    roller_spin: Array  # [rollers], rad/s
    roller_shift: Array  # [rollers], m
    surface_normal: Array  # [surfaces], N
    surface_friction: Array  # [surfaces], N
    surface_line_load: Array  # [surfaces], N/m
    surface_at: Array  # [surfaces], m along the route
    curvature: Array  # [joints], 1/m
    sidewall: Array  # [joints], N/m
    contact_line_load: Array  # [segments], N/m
    roller_force: Array  # [rollers, 3], N

    def __init__(self, handle: Handle, c: Any) -> None:
        self._handle = handle
        self._c = c
        self._moved = handle.moved

    def _now(self) -> Any:
        if self._moved != self._handle.moved:
            raise RuntimeError("the simulation has moved on since this sample: take a new one, or copy what is to be kept")
        return self._c

    @property
    def held_up(self) -> str | None:
        """What makes a run slow, in a sentence, in the function that is told of its progress; None: nothing does."""
        return text_of(self._now().held_up) or None

    @property
    def machines(self) -> dict[str, dict[str, float]]:
        """What conveyors, motors and the like show now: {name: {figure with its unit: value}}."""
        c = self._now()
        return {text_of(machine.name): figures(machine.now, machine.n_now)
                for machine in (c.machine[i] for i in range(c.machines))}

    @property
    def probes(self) -> dict[str, dict[str, Any]]:
        """The named places of the chain: position, displacement (m), rotation (rad), force (N), moment (N m)."""
        c = self._now()
        return {text_of(c.probe[i].name): plain(c.probe[i]) for i in range(c.probes)}

    def as_dict(self) -> dict[str, Any]:
        """A copy of everything, which stays."""
        found = {name: getattr(self, name) for name in Sample.__annotations__}
        return {**{name: np.array(value) if name in SHAPES else value for name, value in found.items()},
                "machines": self.machines, "probes": self.probes}

    def to_xarray(self) -> xarray.Dataset:
        """A copy of all arrays as an xarray.Dataset with their axes: segment, joint, roller, surface, xyz (wxyz of quaternions); the
        numbers are its attributes. ImportError: xarray is not there."""
        try:
            import xarray
        except ImportError as missing:
            raise ImportError("to_xarray needs xarray, which is not there (Debian: python3-xarray); as_dict() does without") from missing
        components = {0: (), 3: ("xyz",), 4: ("wxyz",)}
        arrays = {name: getattr(self, name) for name in SHAPES}
        data = {name: ((SHAPES[name][0].removesuffix("s"), *components[SHAPES[name][1]]), np.array(values))
                for name, values in arrays.items() if values.size}  # rollers that do not move have no spin and shift
        numbers = {name: getattr(self, name) for name in Sample.__annotations__ if name not in SHAPES}
        return xarray.Dataset(data, coords={"xyz": ["x", "y", "z"], "wxyz": ["w", "x", "y", "z"]}, attrs=numbers)

    def __repr__(self) -> str:
        return f"<hawser sample at t = {self.t:.6g} s: winch {self.winch_force:.6g} N>"


def number_of(name: str) -> property:
    def get(sample: Sample) -> Any:
        return getattr(sample._now(), name)

    return property(get, doc=MEMBERS["hawser_sample"].get(name))


def array_of(name: str) -> property:
    rows, width = SHAPES[name]
    field = name in MEMBERS["hawser_fields"]

    def get(sample: Sample) -> Any:
        c = sample._now()
        n = getattr(c, rows)
        return view(sample._handle, getattr(c.field if field else c, name), *((n, width) if width else (n,)))

    return property(get, doc=MEMBERS["hawser_fields" if field else "hawser_sample"][name])


for _name in Sample.__annotations__:
    setattr(Sample, _name, array_of(_name) if _name in SHAPES else number_of(_name))
