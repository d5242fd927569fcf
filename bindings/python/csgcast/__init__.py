# SPDX-License-Identifier: MIT
"""Constructive solid geometry along rays: certified intervals, measures with error bounds, pictures.

    import csgcast, numpy as np
    ball = csgcast.box([2, 2, 2], center=True) & csgcast.sphere(1.35)
    bore = csgcast.cylinder(h=4, r=0.6, center=True)
    model = (ball - bore - bore.rotate([90, 0, 0]) - bore.rotate([0, 90, 0])).compile()
    hits = model.intervals(np.array([[0.8, 0.2, -5.0]]), np.array([0.0, 0.0, 1.0]))
    hits.t          # shape (intervals, 2): entry and exit, each the double nearest to the exact t
    model.measure(1e-9).volume

Solids are immutable values; a compiled Model may be asked by any number of threads at once. Lengths are in the unit of the
solids' numbers, angles in degrees. What makes no sense raises ValueError or TypeError; where a
scene text, a solid or a ray is wrong that is a csgcast.Error, which is a ValueError.
"""
from dataclasses import dataclass as _dataclass, field as _field
from inspect import Parameter as _Parameter, Signature as _Signature
from os import fspath as _fspath

import numpy as _np

from . import _core
from ._core import (Cancelled, Error, Solid, __version__, box, complement, convex, cylinder, difference, ellipsoid, empty,
                    everything, halfspace, hyperboloid, intersection, paraboloid, quadric, sphere, union)

__all__ = ["Camera", "Cancelled", "Check", "Error", "Hits", "Intervals", "Light", "Measures", "Model", "Scene", "Section", "Settings", "Solid",
           "__version__", "box", "complement", "convex", "cylinder", "difference", "ellipsoid", "empty", "everything", "halfspace",
           "hyperboloid", "intersection", "load", "paraboloid", "quadric", "read", "save", "sphere", "union"]

_inf = float("inf")

Error.__doc__ = """What was given makes no sense: 'file:line:column: error: what (why); what to do'. A ValueError."""
Cancelled.__doc__ = """A call was cancelled: its progress callback returned False. There is no result."""
Solid.__signature__ = _Signature()
Error.__signature__ = Cancelled.__signature__ = _Signature([_Parameter("args", _Parameter.VAR_POSITIONAL)])


@_dataclass(frozen=True, eq=False)
class Intervals:
    """Where rays are inside a solid. Those of ray i are rows offsets[i] to offsets[i + 1] of the other arrays, ascending.

    offsets   (rays + 1,)       int64
    t         (intervals, 2)    entry and exit; where the ray was cut off the end of the span, or infinite
    surfaces  (intervals, 2)    int32, the same number for the same surface; -1 where no surface makes the end
    leaves    (intervals, 2)    int32, whose face it is: Model.leaf() names it; -1; None if faces were not asked for
    parts     (intervals, 2)    int32, an index into Model.parts; -1 in no part; likewise
    normals   (intervals, 2, 3) unit, out of the solid; zero where no surface makes the end; None if not asked for
    """
    offsets: object
    t: object
    surfaces: object
    leaves: object
    parts: object
    normals: object

    def __len__(self):
        """How many rays there are."""
        return len(self.offsets) - 1

    def of(self, ray):
        """The t of one ray's intervals: shape (its intervals, 2). Negative numbers count from the end."""
        count = len(self)
        if not -count <= ray < count:
            raise IndexError(f"there are {count} rays, no ray {ray}")
        ray %= count
        return self.t[self.offsets[ray]:self.offsets[ray + 1]]

    def lengths_per_ray(self):
        """How long each ray is inside, (rays,): the sum of exit - entry over its intervals, in t, each rounded once and summed up in
        order; inf where an interval has no end; 0.0 without any. Times the length of the direction it is a length."""
        rays = _np.repeat(_np.arange(len(self)), _np.diff(self.offsets))
        lengths = _np.bincount(rays, weights=self.t[:, 1] - self.t[:, 0], minlength=len(self))
        return lengths.astype(_np.float64, copy=False)  # without intervals they are whole numbers


@_dataclass(frozen=True, eq=False)
class Hits:
    """Where rays first cross the boundary: t (rays,), inf without a hit; surfaces (rays,) int32, -1 without; is_entry
    (rays,) bool, False where the ray starts inside and leaves, or misses."""
    t: object
    surfaces: object
    is_entry: object


@_dataclass(frozen=True, eq=False)
class Measures:
    """What a body comes to. The true value is within each error, rounding included.

    centroid (3,) is the centre of mass, inertia (3, 3) the tensor about it; centroid_error and inertia_error are of each
    number. principal_moments (3,) are the tensor's eigenvalues, ascending, each within principal_error; principal_axes (3, 3)
    has a unit row for each, right-handed, which is principal_angles (3,) radians from the true axis at most: inf if it is
    undetermined, as moments come too near each other. bounds (2, 3) holds the solid, which is nowhere farther than bounds_error from a side; None if it is empty. Of a
    solid that may be unbounded (is_bounded False) nothing is measured. parts: of each part as if it were alone, with
    name and density; the whole's mass, centroid and inertia are those of the parts with their densities, the first where
    they overlap, and of the rest with density 1.
    """
    is_bounded: bool
    volume: float
    volume_error: float
    area: float
    area_error: float
    mass: float
    mass_error: float
    centroid: object
    centroid_error: float
    inertia: object
    inertia_error: float
    principal_moments: object
    principal_error: float
    principal_axes: object
    principal_angles: object
    bounds: object
    bounds_error: float
    cells: int
    as_asked: bool
    name: str = ""
    density: float = 1.0
    parts: list = _field(default_factory=list)


@_dataclass(frozen=True, eq=False)
class Section:
    """What a plane cuts out of a solid. The true area and perimeter are within their errors, ends of arcs within place_error of where
    they should be. A place (a, b) of the plane is origin + a u + b v in space. loops: for each loop, the inside on its left,
    points (arcs, 3, 2), the beginning, somewhere between and end of each; conics (arcs, 6), A to F of
    A u^2 + B uv + C v^2 + D u + E v + F = 0; surfaces (arcs,)."""
    is_bounded: bool
    origin: object
    u: object
    v: object
    area: float
    area_error: float
    perimeter: float
    perimeter_error: float
    place_error: float
    is_closed: bool
    loops: list
    _source = None  # the model, and its plane

    def svg(self, tolerance=None):
        """An SVG picture, as text: straight lines and elliptic arcs as they are, other curves within tolerance (None: less than
        anybody sees)."""
        return _core._section_svg(self, tolerance)

    def json(self):
        """All of it as a JSON object, as text, as the command line writes it."""
        return _core._section_json(self)

    def polyline(self, tolerance, space=False):
        """Each loop as points of a polyline, (n, 2) of u and v, or with space=True (n, 3) in space; the last point is the first one
        again. No arc is farther than tolerance from its chords; straight arcs have no points between their ends. The arcs
        themselves are within place_error of the true ends."""
        lines = _core._section_polylines(self, tolerance)
        if not space:
            return lines
        return [self.origin + line[:, :1] * self.u + line[:, 1:] * self.v for line in lines]

    def save(self, path, pixels=1024):
        """Writes it as .svg, .json, or .png with so many pixels along the longer side. The file appears whole or not at all."""
        model, normal, distance = self._source or (None, None, 0.0)
        _core._save_section(self, _fspath(path), pixels, model, normal, distance)

    def __getstate__(self):
        return {name: value for name, value in vars(self).items() if name != "_source"}


@_dataclass(frozen=True, eq=False)
class Check:
    """What may be wrong with a solid. overlaps: (part, part, volume, its error, a place in both) of parts that share space, proved;
    undecided: (part, part, the most that they may share); without_effect: (kind and place, why, range of its leaves) of
    leaves and Boolean operators without which, one at a time, the shape would be the same, proved; not_asked: how many were not
    asked, as they are among hundreds of others."""
    overlaps: list
    undecided: list
    unbounded_parts: list
    empty_parts: list
    without_effect: list
    not_asked: int
    is_unbounded: bool
    is_empty: bool


def _set(values, **fields):
    """Sets fields of a frozen dataclass while it is being made."""
    for name, value in fields.items():
        object.__setattr__(values, name, value)


def _told(camera):
    """A camera as a dict of what is given; None as it is."""
    if not isinstance(camera, Camera):
        return camera
    return {name: value for name, value in vars(camera).items() if value is not None}


@_dataclass(frozen=True)
class Camera:
    """From where a picture is seen. Perspective, with a vertical field of view of fov degrees (None: 30); or parallel, where the
    picture shows height units of length. up: what is upright, None is z. Raises Error for a camera that sees nothing."""
    eye: tuple
    look_at: tuple
    up: tuple = None
    fov: float = None
    height: float = None

    def __post_init__(self):
        for name in ("eye", "look_at", "up"):
            if getattr(self, name) is not None:
                _set(self, **{name: _core._triple(getattr(self, name), name)})
        if self.fov is not None and self.height is not None:
            raise ValueError("a camera has fov or height, not both")
        _core._check_camera(_told(self))


@_dataclass(frozen=True)
class Light:
    """A light: at a position, or from everywhere along a direction, which is where its light goes. color: linear, three numbers,
    or a name or '#rrggbb'. falloff: of one with a position, inverse-square, intensity is reached at this distance; None: the
    same everywhere."""
    position: tuple = None
    direction: tuple = None
    color: tuple = (1.0, 1.0, 1.0)
    intensity: float = 1.0
    falloff: float = None

    def __post_init__(self):
        for name in ("position", "direction"):
            if getattr(self, name) is not None:
                _set(self, **{name: _core._triple(getattr(self, name), name)})
        _set(self, color=_core._light_color(self.color, "color"))
        _core._check_light(self)


@_dataclass(frozen=True)
class Settings:
    """How far light is followed: at most max_depth reflections and transmissions, and none that brings less than
    min_contribution of a pixel."""
    max_depth: int = 5
    min_contribution: float = 1.0 / 512

    def __post_init__(self):
        _core._check_settings(self)


class Model:
    """A solid made ready for questions. Made by Solid.compile() or Scene.compile().

    weld: faces that were meant to coincide but differ by the rounding of the solid's own numbers become one (None), none
    do (0), or those at most this share of the solid's size apart.

    Arrays of rays have shape (rays, 3), or (3,) where all share one; other types are converted to doubles. Directions need
    not be unit: t counts in units of them.

    progress(share) is called now and then by what takes long, with the share done, in [0, 1], which never falls and is 1 at
    the end; by any thread, but never by two at once. If it returns False the call is cancelled and raises Cancelled; None, or
    anything else, goes on. What it raises ends the call and is raised there; so is KeyboardInterrupt after Ctrl-C.

    threads: how many of them work on a call, or on making the model; 0: one a core. Results do not depend on it.
    """

    def __init__(self, solid, weld=None, _description=None, *, threads=0):
        self._solid = solid
        self._weld = weld
        self._description = _description or _core._Description()
        self._model = _core._Model(_description or solid, weld, threads)

    def __reduce__(self):
        return _model_from, (self._solid, self._weld, _core._description_state(self._description))

    def __copy__(self):
        return self  # nothing changes it

    def __deepcopy__(self, _):
        return self

    def intervals(self, origins, directions, *, t_min=0.0, t_max=_inf, line=False, faces=True, normals=True, threads=0, progress=None):
        """All intervals of each ray that lie in [t_min, t_max], or on its whole line, as Intervals. Without faces and normals
        it is faster and takes a third of the memory."""
        if line and (t_min != 0.0 or t_max != _inf):
            raise ValueError("line=True is the whole line: leave t_min and t_max out")
        return Intervals(**self._model.intervals(origins, directions, t_min, t_max, line, faces, normals, progress, threads))

    def first_hits(self, origins, directions, *, t_min=0.0, t_max=_inf, threads=0, progress=None):
        """The first crossing of the boundary in [t_min, t_max], as Hits."""
        return Hits(*self._model.first_hits(origins, directions, t_min, t_max, progress, threads))

    def any_hits(self, origins, directions, *, t_min=0.0, t_max=_inf, threads=0, progress=None):
        """Whether each ray meets the inside of the solid between t_min and t_max: (rays,) bool."""
        return self._model.any_hits(origins, directions, t_min, t_max, progress, threads)

    def locate(self, points, *, threads=0, progress=None):
        """For each point 1 inside, 0 on the boundary, -1 outside: int8. Never falsely inside or outside."""
        return self._model.locate(points, progress, threads)

    def thickness(self, origins, directions, *, threads=0, progress=None):
        """How thick the solid is at the first face that each ray enters by, from there straight in to the boundary again: (rays,);
        0 where a ray enters by none, inf where nothing ends the solid."""
        return self._model.thickness(origins, directions, progress, threads)

    def measure(self, relative_error=1e-4, area_error=1e-3, *, threads=0, progress=None, enough=None):
        """Volume, area, mass, centroid, inertia and bounds, as Measures; errors of volume and area relative to them are as
        small as asked for if as_asked is True. enough(relative_error) is asked now and then about a volume's present error: if
        it returns what is true, that is the result; False and None go on. It does not cancel: progress does."""
        whole = self._model.measure(relative_error, area_error, progress, enough, threads)
        whole["parts"] = [Measures(**part) for part in whole["parts"]]
        return Measures(**whole)

    def section(self, normal, distance=0.0, *, relative_error=1e-6, threads=0, progress=None):
        """What the plane normal . p = distance cuts out, as Section. In the plane of a face it is what is just beyond it."""
        cut = Section(**_core._section(self._model, normal, distance, relative_error, progress, threads))
        _set(cut, _source=(self._model, normal, distance))
        return cut

    def thinnest(self, grid=512, *, threads=0, progress=None):
        """The thinnest wall that grid x grid rays along each axis meet, straight in from the boundary to the boundary again:
        (thickness, place (3,), normal (3,), leaf); None if the solid is empty or may be unbounded. No bound."""
        return _core._thinnest(self._model, grid, progress, threads)

    def check(self, *, threads=0, progress=None):
        """Looks for parts that overlap, empty and unbounded parts, and what is without effect: Check."""
        return Check(**_core._check(self._model, progress, threads))

    def render(self, width=800, height=600, *, samples=1, mode="shaded", camera=None, lights=None, background=None,
               settings=None, adaptive=False, tile=None, region=None, path=None, threads=0, progress=None):
        """A picture: float32, (height, width, 3) of linear light or of normals, (height, width) of depths, lengths or ids.
        mode: shaded, edges, xray (lengths inside), depth, normal or id (leaves). camera: a Camera, or a dict of its arguments;
        lights: Lights, () is none; background: linear, three numbers, or a name or '#rrggbb'; settings: Settings. What is None is
        the scene's, or a default: a camera that frames the solid, a light beside it, a pale sky. samples: rays a pixel, rounded
        up to a square number; adaptive: all of them only in pixels that do not look like those around. region (x0, y0, x1, y1):
        only these columns and rows, the last ones not included, bit for bit what they are in the whole picture; tile (i, n): only
        the i-th of n bands of rows, from 0 at the top. With path (.png, .jpg, .tif, .exr and others) it is written there
        instead."""
        region = _region_of(width, height, tile, region)
        view = (_told(camera), lights, background, settings, progress, threads)
        if path is not None:
            _core._save_picture(self._model, _fspath(path), width, height, samples, mode, adaptive, region, *view)
            return None
        return _core._render(self._model, width, height, samples, mode, adaptive, region, *view)

    def leaf(self, index):
        """What a leaf is and which statement made it: 'sphere at part.csg:3:5'."""
        return self._model.leaf(index)

    @property
    def parts(self):
        """The names of the parts, in file order."""
        return self._model.part_names()

    @property
    def bounds(self):
        """A box that holds the solid, (2, 3), quickly found and maybe wide: Model.measure().bounds is tight."""
        return self._model.bounds()

    @property
    def counts(self):
        """How many leaves, surfaces and cells, and the cells' bytes."""
        return self._model.counts()

    def __repr__(self):
        counts = self.counts
        return f"<csgcast.Model: {counts['leaves']} leaves, {counts['surfaces']} surfaces, {counts['cells']} cells>"


class Scene:
    """A solid, and camera, lights, background and settings for pictures of it; what is None is left to the picture's defaults.
    load() and read() make one of a scene text. background: linear, three numbers, or a name or '#rrggbb'."""

    def __init__(self, solid, camera=None, lights=None, background=None, settings=None):
        self._description = _core._described(solid, _told(camera), lights, background, settings)

    @classmethod
    def _of(cls, description):
        scene = cls.__new__(cls)
        scene._description = description
        return scene

    def __reduce__(self):
        return _scene_from, (self._description.solid, _core._description_state(self._description))

    def __copy__(self):
        return self  # nothing changes it

    def __deepcopy__(self, _):
        return self

    @property
    def solid(self):
        """All that is solid in it, as one Solid."""
        return self._description.solid

    @property
    def camera(self):
        """Its Camera; None without one."""
        told = self._description.camera
        return told and Camera(**told)

    @property
    def lights(self):
        """Its Lights, as a tuple."""
        return tuple(Light(**told) for told in self._description.lights)

    @property
    def background(self):
        """Its background, three linear numbers; None without one."""
        return self._description.background

    @property
    def settings(self):
        """Its Settings."""
        return Settings(*self._description.settings)

    @property
    def parts(self):
        """The names of its parts, in file order."""
        return self.solid.parts

    def only(self, name):
        """The parts of this name, or of these names, under the same camera and lights."""
        return Scene._of(self._description.with_solid(self.solid.only(name)))

    @property
    def warnings(self):
        """What is odd in the text but has a meaning: 'file:line:column: warning: ..'."""
        return self._description.warnings

    def __repr__(self):
        parts = self.parts
        return f"<csgcast.Scene: {len(parts)} parts{': ' if parts else ''}{', '.join(map(repr, parts[:4]))}{', ..' if len(parts) > 4 else ''}>"

    def compile(self, weld=None, *, threads=0):
        """A Model of the solid that renders under its camera and lights; see Model for weld and threads."""
        return Model(self._description.solid, weld, self._description, threads=threads)


def load(path, facets="auto", *, skip_unsupported=False):
    """Reads a scene text (OpenSCAD's .csg, or csgcast's own). facets: which curved solids become polyhedra as in OpenSCAD:
    those with $fn <= 16 ("auto"), all ("always"), none ("never"). skip_unsupported: statements that are not supported yet
    are left out, each with one of the scene's warnings; else they are an Error."""
    return Scene._of(_core._load(_fspath(path), facets, skip_unsupported))


def read(text, facets="auto", *, skip_unsupported=False):
    """The same for a text in memory."""
    return Scene._of(_core._read(text, facets, skip_unsupported))


def _compile(self, weld=None, *, threads=0):
    """A Model of the solid, ready for questions; see Model for weld and threads."""
    return Model(self, weld, threads=threads)


def _to_text(self):
    """The solid as a scene text of its own (.csg), which read(text, facets="never").solid makes the same solid of, exactly."""
    return _core._text_of(self)


def _solid_from(*state):
    return _core._solid_of(state)


def _scene_from(solid, state):
    return Scene._of(_core._description_of(state, solid))


def _model_from(solid, weld, state):
    return Model(solid, weld, _core._description_of(state, solid))


def _rows(numbers):
    """Rows of three; one for all as one row. What has no such shape is refused later."""
    rows = _np.asarray(numbers, dtype=float)
    return rows.reshape(1, 3) if rows.shape == (3,) else rows.reshape(-1, 3) if rows.size == 0 else rows


def _region_of(width, height, tile, region):
    """(x0, y0, x1, y1) of what is asked for of a picture; None for all of it."""
    if tile is not None and region is not None:
        raise ValueError("give tile or region, not both")
    if tile is None:
        return None if region is None else tuple(region)
    index, count = tile
    return _core._band(width, height, index, count)


def save(solid, path):
    """Writes a solid as a scene text (.csg), for the command line or another program. The file appears whole or not at all; an older
    one's permissions are kept, and links are followed."""
    _core._save_text(solid, _fspath(path))


Solid.compile = _compile
Solid.to_text = _to_text
Solid.__reduce__ = lambda self: (_solid_from, _core._solid_state(self))
