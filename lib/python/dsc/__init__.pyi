# SPDX-License-Identifier: MIT
# The types of the public names; docstrings are in the module.
from collections.abc import Callable, Collection, Mapping, Sequence
from os import PathLike
from typing import Any, Generic, Literal, NamedTuple, TypedDict, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import bench as bench
from . import scenes as scenes
from .data import Data as Data

__version__: str

# Names that begin with an underscore are only here: a program cannot import them.
_Floats = NDArray[np.float64]
_Integers = NDArray[np.int64]
_Flags = NDArray[np.bool_]
_Velocity = Callable[[_Floats, float], ArrayLike]

class InputError(ValueError): ...
class FileError(OSError): ...
class SolveError(RuntimeError): ...

class Curve(NamedTuple):
    points: _Floats
    is_closed: bool
    left: int
    right: int

class InputReport(NamedTuple):
    points: int
    thinned: int
    deviation: float
    area_changed: float
    dropped: int
    area_dropped: float
    clipped: int

class Event(NamedTuple):
    kind: str
    time: float
    place: tuple[float, float]
    lost: int
    taken: tuple[int, int]
    area: float

class Report(NamedTuple):
    unreached: int
    held: int
    sub_steps: int
    interface_vertices: int
    reached: float
    gave_up: Literal["", "too_many_sub_steps", "too_many_passes", "velocity_jumps", "interrupted"]
    events: list[Event]
    reason: str

class Report3(NamedTuple):
    unreached: int
    held: int
    sub_steps: int
    interface_vertices: int
    reached: float
    gave_up: Literal["", "too_many_sub_steps"]
    reason: str
    passes: int
    unjammed: int
    error: float
    operations: dict[str, int]

class Faces(NamedTuple):
    triangles: NDArray[np.int32]
    inside: NDArray[np.uint32]
    outside: NDArray[np.uint32]

class Interface:
    positions: _Floats
    previous: _Integers
    next: _Integers
    left: _Integers
    right: _Integers
    normals: _Floats
    curvatures: _Floats
    lengths: _Floats
    arms: _Integers
    is_junction: _Flags
    is_feature: _Flags
    is_on_boundary: _Flags
    is_locked: _Flags
    def __len__(self) -> int: ...

class _PhaseFigures(TypedDict):
    area: float
    perimeter: float
    boundary: float
    components: int
    holes: int

class _Figures(TypedDict):
    phases: dict[int, _PhaseFigures]
    lengths: dict[tuple[int, int], float]

class Mesh:
    def __init__(
        self,
        points: ArrayLike,
        triangles: ArrayLike,
        phases: ArrayLike,
        sides: Mapping[str, ArrayLike] | None = None,
    ) -> None: ...
    @property
    def sides(self) -> dict[str, _Floats]: ...
    @property
    def points(self) -> _Floats: ...
    @property
    def triangles(self) -> NDArray[np.int32]: ...
    @property
    def phases(self) -> NDArray[np.uint32]: ...
    @property
    def qualities(self) -> _Floats: ...
    @property
    def min_angles(self) -> _Floats: ...
    @property
    def areas(self) -> dict[int, float]: ...
    @property
    def figures(self) -> _Figures: ...
    @property
    def input_report(self) -> InputReport: ...
    @property
    def component_of(self) -> NDArray[np.int32]: ...
    @property
    def mesh_hash(self) -> int: ...
    @property
    def revision(self) -> int: ...
    @property
    def vertex_data(self) -> Data: ...
    @property
    def triangle_data(self) -> Data: ...
    def interface_curves(self) -> list[Curve]: ...
    def outlines(self, phase: int, samples: int = 1) -> list[_Floats]: ...
    def polygons(self, phase: int) -> list[list[_Floats]]: ...
    def validate(self) -> str: ...
    def copy(self) -> Mesh: ...
    def write_svg(self, path: str | PathLike[str]) -> None: ...
    def write_vtu(self, path: str | PathLike[str]) -> None: ...
    def to_geojson(self) -> dict[str, Any]: ...
    def to_meshio(self) -> Any: ...
    def to_shapely(self, phase: int) -> Any: ...
    def to_triangulation(self) -> Any: ...

class Mesh3:
    def __init__(self, points: ArrayLike, tetrahedra: ArrayLike, phases: ArrayLike) -> None: ...
    @property
    def points(self) -> _Floats: ...
    @property
    def tetrahedra(self) -> NDArray[np.int32]: ...
    @property
    def phases(self) -> NDArray[np.uint32]: ...
    @property
    def qualities(self) -> _Floats: ...
    @property
    def min_dihedrals(self) -> _Floats: ...
    @property
    def volumes(self) -> dict[int, float]: ...
    @property
    def mesh_hash(self) -> int: ...
    @property
    def revision(self) -> int: ...
    @property
    def vertex_data(self) -> Data: ...
    @property
    def tet_data(self) -> Data: ...
    def interface_faces(self) -> Faces: ...
    def validate(self) -> str: ...
    def copy(self) -> Mesh3: ...
    def write_vtu(self, path: str | PathLike[str]) -> None: ...
    def write_interface_vtu(self, path: str | PathLike[str]) -> None: ...
    def write_ply(self, path: str | PathLike[str]) -> None: ...
    def write_stl(self, path: str | PathLike[str]) -> None: ...
    def to_meshio(self) -> Any: ...

class Shape3:
    def __call__(self, points: ArrayLike) -> _Floats: ...

_Solid = Shape3 | Callable[[_Floats], ArrayLike]
_Solids = Mapping[int, _Solid | Sequence[_Solid]] | Sequence[tuple[_Solid, int | Mapping[int, int]]]
_Corner3 = tuple[float, float, float]

class Flow: ...

_AnyMesh = TypeVar("_AnyMesh", Mesh, Mesh3)

class Simulation(Generic[_AnyMesh]):
    @overload
    def __init__(
        self: Simulation[Mesh],
        mesh: Mesh,
        flow: Flow | None = None,
        *,
        edge_length: float,
        growth: float = 0,
        longest: float = 0,
        shortest: float = 0,
        by_place: Callable[[float, float, float, int], float] | None = None,
        by_distance: Callable[[float], float] | None = None,
        on_interface: Callable[[float, float, float], float] | None = None,
        changes_in_time: bool = False,
        integrator: Literal["euler", "midpoint", "rk4", "adaptive"] = "rk4",
        tolerance: float = 1e-4,
        insertion: Literal["linear", "cubic"] = "cubic",
        coarsening: Literal["deviation", "length", "never"] = "deviation",
        reading: Literal["chords", "cubic"] = "chords",
        deviation: float = 0.02,
        feature_degrees: float = 40,
        turn_degrees: float = 0,
        gap: float = 0,
        advected_phases: Sequence[int] = (),
        sub_step: float = 0.6,
        max_sub_steps: int = 10000,
        topology: Literal["keep", "change"] = "keep",
        contact: float = 0,
        min_area: float = 0,
        follows_seams: bool = True,
        gives_back_area: bool = False,
        threads: int | None = None,
        division: Literal["fixed", "counting", "active", "blocks", "cells"] | None = None,
        submeshes: int | None = None,
    ) -> None: ...
    @overload
    def __init__(
        self: Simulation[Mesh3],
        mesh: Mesh3,
        flow: None = None,
        *,
        edge_length: float,
        longest: float = 1.4,
        shortest: float = 0.45,
        deviation: float = 0.005,
        always: float = 0.15,
        quality: float = 0.25,
        move_quality: float = 0.1,
        layers: int = 3,
        integrator: Literal["euler", "midpoint", "rk4", "adaptive"] = "rk4",
        tolerance: float = 1e-4,
        sub_step: float = 0.4,
        max_sub_steps: int = 10000,
        max_passes: int = 16,
        threads: int | None = None,
        submeshes: int | None = None,
    ) -> None: ...
    @overload
    def step(self: Simulation[Mesh], flow: _Velocity | Flow, time: float, dt: float) -> Report: ...
    @overload
    def step(self: Simulation[Mesh3], flow: _Velocity, time: float, dt: float) -> Report3: ...
    @property
    def mesh(self) -> _AnyMesh: ...
    @property
    def time(self) -> float: ...
    @property
    def report(self) -> Any: ...
    @property
    def flow(self) -> Flow | None: ...
    @property
    def options(self) -> dict[str, Any]: ...
    @property
    def interface_size(self) -> int: ...


class Fluid:
    def __init__(
        self,
        sim: Simulation[Mesh],
        phases: Mapping[int, tuple[float, float] | None],
        tensions: Mapping[tuple[int, int], float | tuple[float, float]],
        *,
        gravity: ArrayLike = (0, 0),
        slip: str | Collection[str] = (),
        open: str | Collection[str] = (),
        inflow: Mapping[str, float | Callable[[float, float, float], float]] | None = None,
        velocity: Mapping[str, ArrayLike | Callable[[float, float, float], ArrayLike]] | None = None,
        inertia: bool = True,
        tolerance: float = 0,
        threads: int = 1,
    ) -> None: ...
    def step(self, dt: float) -> Report: ...
    @property
    def time(self) -> float: ...
    @property
    def velocities(self) -> _Floats: ...
    @property
    def pressures(self) -> _Floats: ...
    @property
    def energies(self) -> dict[str, float]: ...
    def force_on(self, side: str) -> tuple[float, float]: ...
    def mean_velocity(self, phase: int) -> tuple[float, float]: ...
    @property
    def simulation(self) -> Simulation[Mesh]: ...

def from_labels(
    array: ArrayLike,
    domain: ArrayLike | None = None,
    min_pixels: int = 0,
    *,
    edge_length: float,
    growth: float = 0,
    longest: float = 0,
    shortest: float = 0,
    by_place: Callable[[float, float, float, int], float] | None = None,
    by_distance: Callable[[float], float] | None = None,
    on_interface: Callable[[float, float, float], float] | None = None,
    changes_in_time: bool = False,
    detail: Literal["thin", "keep"] = "thin",
    border_tolerance: float = 1e-3,
    coverage: Literal["open", "whole", "longest_border", "first"] = "open",
) -> Mesh: ...

def from_meshio(mesh: Any, phases: str | None = None) -> Any: ...

@overload
def initial_complex(  # type: ignore[misc]  # corners of three coordinates, which are arrays, too
    domain: tuple[_Corner3, _Corner3],
    shapes: _Solids | None = None,
    *,
    curves: None = None,
    sides: None = None,
    edge_length: float,
    growth: float = 0.7,
    improve_rounds: int = 4,
    max_tets: float = 2e7,
) -> Mesh3: ...
@overload
def initial_complex(  # type: ignore[misc]  # solids, which may be anything, too
    domain: ArrayLike,
    shapes: _Solids,
    *,
    curves: None = None,
    sides: None = None,
    edge_length: float,
    growth: float = 0.7,
    improve_rounds: int = 4,
    max_tets: float = 2e7,
) -> Mesh3: ...
@overload
def initial_complex(
    domain: ArrayLike,
    shapes: Mapping[int, Any] | Any | None = None,
    *,
    curves: Sequence[tuple[ArrayLike, int, int]] | None = None,
    sides: str | Sequence[str | Sequence[str | None] | None] | None = None,
    edge_length: float,
    growth: float = 0,
    longest: float = 0,
    shortest: float = 0,
    by_place: Callable[[float, float, float, int], float] | None = None,
    by_distance: Callable[[float], float] | None = None,
    on_interface: Callable[[float, float, float], float] | None = None,
    changes_in_time: bool = False,
    detail: Literal["thin", "keep"] = "thin",
    border_tolerance: float = 1e-3,
    coverage: Literal["open", "whole", "longest_border", "first"] = "open",
) -> Mesh: ...
def ball(centre: ArrayLike, radius: float) -> Shape3: ...
def box(low: ArrayLike, high: ArrayLike) -> Shape3: ...
def ellipsoid(centre: ArrayLike, radii: ArrayLike) -> Shape3: ...
def torus(centre: ArrayLike, axis: ArrayLike, circle_radius: float, tube_radius: float) -> Shape3: ...
def closed_surface(points: ArrayLike | str | PathLike[str], triangles: ArrayLike | None = None) -> Shape3: ...
def interface_flow(function: Callable[[Interface, float], ArrayLike]) -> Flow: ...
def swirl(amplitude: float = 1.0, period: float = 0.0) -> Flow: ...
def growth(speeds: Mapping[tuple[int, int], float]) -> Flow: ...
def curvature_flow(
    tension: float | Mapping[tuple[int, int], float] | ArrayLike = 1.0,
    mobility: float | Mapping[tuple[int, int], float] | ArrayLike = 1.0,
    keep_areas_of: Mesh | Mapping[int, float] | None = None,
) -> Flow: ...
def symmetric_difference(first: ArrayLike | Sequence[ArrayLike], second: ArrayLike | Sequence[ArrayLike]) -> float: ...
def hausdorff(first: ArrayLike | Sequence[ArrayLike], second: ArrayLike | Sequence[ArrayLike]) -> float: ...
def grains(mesh: Mesh) -> dict[str, NDArray[Any]]: ...
def area(outlines: ArrayLike | Sequence[ArrayLike]) -> float: ...
def circle(centre: ArrayLike, radius: float, edge_length: float) -> _Floats: ...
def plot(
    mesh: Mesh | Mesh3,
    ax: Any = None,
    *,
    values: ArrayLike | None = None,
    edges: bool | None = None,
    interface: bool = True,
    palette: Sequence[Any] = ...,
    **style: Any,
) -> Any: ...
def animate(
    sim: Simulation[Mesh], flow: _Velocity | Flow, dt: float, steps: int, *, every: int = 1, ax: Any = None, **style: Any
) -> Any: ...
@overload
def run(
    sim: Simulation[Mesh],
    flow: _Velocity | Flow,
    dt: float,
    steps: int,
    *,
    time: float | None = None,
    after: Callable[[Simulation[Mesh], Report], object] | None = None,
    progress: Callable[[str], object] | bool | None = None,
) -> list[Report]: ...
@overload
def run(
    sim: Simulation[Mesh3],
    flow: _Velocity,
    dt: float,
    steps: int,
    *,
    time: float | None = None,
    after: Callable[[Simulation[Mesh3], Report3], object] | None = None,
    progress: Callable[[str], object] | bool | None = None,
) -> list[Report3]: ...

class Series:
    def __init__(self, path: str | PathLike[str]) -> None: ...
    def add(self, mesh: Mesh | Mesh3, time: float) -> None: ...

def save(path: str | PathLike[str], thing: object) -> None: ...
def load(path: str | PathLike[str]) -> Any: ...
