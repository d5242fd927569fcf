# SPDX-License-Identifier: MIT
"""The Python module: answers as of the libraries, arrays of the shapes that are promised, errors that say what is wrong."""
import ast
import copy
import inspect
import json
import math
import pickle
import subprocess
import sys
import threading
from pathlib import Path

import csgcast
import numpy as np
import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def angel():
    bore = csgcast.cylinder(h=4, r=0.6, center=True)
    ball = csgcast.box([2, 2, 2], center=True) & csgcast.sphere(1.35)
    return ball - bore - bore.rotate([90, 0, 0]) - bore.rotate(90, [0, 1, 0])


@pytest.fixture(scope="module")
def model():
    return angel().compile()


def test_intervals_have_the_shapes_that_are_promised(model):
    origins = np.array([[0.8, 0.2, -5], [0, 0, -5], [0.7, 0.7, -5]])
    table = model.intervals(origins, [0, 0, 1])
    assert len(table) == 3
    assert table.offsets.tolist() == [0, 2, 2, 3]
    assert table.offsets.dtype == np.int64
    assert table.t.shape == (3, 2) and table.t.dtype == np.float64
    assert table.surfaces.shape == table.leaves.shape == table.parts.shape == (3, 2)
    assert table.surfaces.dtype == table.leaves.dtype == table.parts.dtype == np.int32
    assert table.normals.shape == (3, 2, 3)
    assert table.of(1).shape == (0, 2)
    assert table.of(0)[0].tolist() == [4, 5 - math.sqrt(0.36 - 0.04)]
    assert np.allclose(np.linalg.norm(table.normals, axis=2), 1)
    assert (table.parts == -1).all()
    bare = model.intervals(origins, [0, 0, 1], faces=False, normals=False)
    assert bare.leaves is None and bare.parts is None and bare.normals is None
    assert np.array_equal(bare.t, table.t)


def test_spans_and_lines(model):
    ball = csgcast.sphere(1).compile()
    assert ball.intervals([0, 0, 0], [0, 0, 2]).t.tolist() == [[0, 0.5]]
    assert ball.intervals([0, 0, 0], [0, 0, 2], line=True).t.tolist() == [[-0.5, 0.5]]
    assert ball.intervals([0, 0, 0], [0, 0, 2], t_min=-0.25, t_max=0.25).surfaces.tolist() == [[-1, -1]]
    outside = (~csgcast.sphere(1)).compile().intervals([0, 0, 0], [0, 0, 1], line=True)
    assert outside.t.tolist() == [[-np.inf, -1], [1, np.inf]]


def test_hits_and_points(model):
    rays = np.random.default_rng(1).normal(size=(5000, 3))
    hits = model.first_hits(rays * 3, -rays)
    table = model.intervals(rays * 3, -rays, faces=False, normals=False)
    some = np.diff(table.offsets) > 0
    assert np.array_equal(np.isfinite(hits.t), some)
    assert np.array_equal(model.any_hits(rays * 3, -rays), some)
    first = table.offsets[:-1][some]
    entered = hits.is_entry[some]
    assert np.array_equal(hits.t[some][entered], table.t[first[entered], 0])
    assert model.locate([[0.7, 0.7, 0.2], [0, 0, 0], [1, 0.8, 0.1], [9, 9, 9]]).tolist() == [1, -1, 0, -1]
    assert model.locate([0.7, 0.7, 0.2]).tolist() == [1]


def test_numbers_and_lists_of_any_kind():
    volume = lambda solid: solid.compile().measure(1e-9).volume
    assert volume(csgcast.box(np.int64(2))) == pytest.approx(8) == volume(csgcast.box(np.float32(2)))
    assert volume(csgcast.box(1).rotate(np.int64(90)) & csgcast.box(1)) == 0
    boxes = [csgcast.box(1).translate([2 * i, 0, 0]) for i in range(4)]
    assert volume(csgcast.union(boxes)) == pytest.approx(4) == volume(sum(boxes))
    with pytest.raises(TypeError):
        csgcast.union(boxes, 3)
    model = csgcast.box(1).compile()
    assert len(model.intervals([], [])) == 0 and len(model.intervals(np.zeros((0, 3)), [0, 0, 1])) == 0
    assert len(model.locate([])) == 0
    table = model.intervals(np.full((5, 3), [0.5, 0.5, -1]), np.array([[0, 0, 1]]))
    assert len(table) == 5 and table.of(-1).tolist() == [[1, 2]]
    with pytest.raises(IndexError):
        table.of(5)


def test_other_types_and_layouts_give_the_same(model):
    origins = np.random.default_rng(2).normal(size=(100, 3)).astype(np.float32)
    want = model.intervals(origins.astype(np.float64), [0.0, 0.0, 1.0]).t
    assert np.array_equal(model.intervals(origins, np.array([0, 0, 1], dtype=np.int8)).t, want)
    assert np.array_equal(model.intervals(np.asfortranarray(origins), [0, 0, 1]).t, want)
    wide = np.zeros((100, 6), dtype=np.float32)
    wide[:, ::2] = origins
    assert np.array_equal(model.intervals(wide[:, ::2], [0, 0, 1]).t, want)
    assert np.array_equal(model.intervals(origins.tolist(), [0, 0, 1]).t, want)


def test_principal_moments_hold():
    m = csgcast.box([1, 2, 3]).rotate([0, 0, 30]).translate([9, 9, 9]).compile().measure(1e-8)
    assert np.abs(m.principal_moments - [2.5, 5, 6.5]).max() <= m.principal_error + 1e-13 < 1e-5
    assert m.principal_axes.shape == (3, 3) and m.principal_angles.shape == (3,)
    assert np.allclose(m.inertia, m.principal_axes.T @ np.diag(m.principal_moments) @ m.principal_axes, atol=1e-12)
    assert np.linalg.det(m.principal_axes) > 0.999
    assert (m.principal_angles < 1e-5).all()
    assert abs(m.principal_axes[0][2]) > 1 - 1e-10  # the longest side
    assert np.isinf(csgcast.sphere(1).compile().measure().principal_angles).all()


def test_measures_hold():
    ball = csgcast.sphere(2).translate([1, 2, 3]).part("ball", 3).compile()
    m = ball.measure(1e-8)
    assert m.as_asked and m.is_bounded
    volume = 4 / 3 * math.pi * 8
    assert abs(m.volume - volume) <= m.volume_error + 1e-14 <= 1e-6
    assert abs(m.mass - 3 * volume) <= m.mass_error + 1e-13
    assert np.abs(m.centroid - [1, 2, 3]).max() <= m.centroid_error + 1e-14
    assert np.abs(m.inertia - np.eye(3) * 3 * volume * 2 / 5 * 4).max() <= m.inertia_error + 1e-12
    assert np.abs(m.bounds - [[-1, 0, 1], [3, 4, 5]]).max() <= m.bounds_error + 1e-12
    assert [part.name for part in m.parts] == ball.parts == ["ball"]
    assert m.parts[0].density == 3
    assert not csgcast.everything().compile().measure().is_bounded
    assert csgcast.empty().compile().measure().bounds is None


def test_scene_texts(tmp_path):
    (tmp_path / "drilled.csg").write_text("difference() {\n  cube(2);\n  cylinder(h = 9, r = 0.5, $fn = 40);\n}\n")
    model = csgcast.load(tmp_path / "drilled.csg").compile()
    assert abs(model.measure(1e-6).volume - (8 - math.pi / 8)) < 8e-6
    assert model.leaf(1) == f"cylinder at {tmp_path}/drilled.csg:3:3"
    assert csgcast.load(EXAMPLES / "flange.csg").compile().parts
    read = csgcast.read("cylinder(h = 2, r = 1, $fn = 6);")
    assert read.warnings == []
    hexagon = 1.5 * math.sqrt(3) * 2
    assert abs(read.compile().measure(1e-9).volume - hexagon) < 1e-8
    assert abs(csgcast.read("sphere(r = 0);").warnings[0].find("warning")) > 0
    assert abs(csgcast.read("cylinder(h = 2, r = 1, $fn = 6);", facets="never").compile().measure(1e-6).volume - 2 * math.pi) < 1e-4


def test_sections():
    solid = csgcast.box([2, 2, 2]) - csgcast.cylinder(h=9, r=0.5, center=True).translate([1, 1, 0])
    s = solid.compile().section([0, 0, 1], 1, relative_error=1e-9)
    assert abs(s.area - (4 - math.pi / 4)) <= s.area_error + 1e-14 < 1e-8
    assert abs(s.perimeter - (8 + math.pi)) <= s.perimeter_error + 1e-13
    assert s.is_closed and s.is_bounded and len(s.loops) == 2
    assert s.u.tolist() == [1, 0, 0] and s.v.tolist() == [0, 1, 0] and s.origin.tolist() == [0, 0, 1]
    for points, conics, surfaces in s.loops:
        assert points.shape == (len(surfaces), 3, 2) and conics.shape == (len(surfaces), 6)
        u, v = points[..., 0], points[..., 1]
        a, b, c, d, e, f = (conics[:, i, None] for i in range(6))
        assert np.abs(a * u * u + b * u * v + c * v * v + d * u + e * v + f).max() < 1e-9
        assert np.allclose(points[:, 2], np.roll(points[:, 0], -1, axis=0), atol=1e-9)
    assert solid.compile().section([0, 0, 1], 5).loops == []


def test_thinnest():
    web = csgcast.box([4, 4, 1]) - csgcast.cylinder(h=2, r=0.5).translate([2, 2, 0.125])
    thickness, place, normal, leaf = web.compile().thinnest(64)
    assert thickness == pytest.approx(0.125) and abs(normal[2]) == 1 and leaf in (0, 1)
    assert np.hypot(place[0] - 2, place[1] - 2) < 0.5
    assert csgcast.empty().compile().thinnest() is None
    with pytest.raises(ValueError):
        web.compile().thinnest(0)


def test_checks():
    parts = csgcast.box(1).part("a") + csgcast.box(1).translate([0.5, 0, 0]).part("b") + csgcast.box(1).translate([0, 1, 0]).part("c")
    report = (parts + csgcast.sphere(0.1).translate([0.5, 0.5, 0.5])).compile().check()
    assert [(a, b) for a, b, *_ in report.overlaps] == [("a", "b")]
    _, _, volume, error, place = report.overlaps[0]
    assert abs(volume - 0.5) <= error + 1e-15 and 0.5 <= place[0] <= 1
    assert report.without_effect == [("sphere", "without it the shape is the same", range(3, 4))] and not report.is_unbounded
    assert csgcast.empty().compile().check().is_empty


def test_pictures(tmp_path, model):
    picture = model.render(40, 30)
    assert picture.shape == (30, 40, 3) and picture.dtype == np.float32
    depth = model.render(40, 30, mode="depth", camera={"eye": [0, 0, 10], "look_at": [0, 0, 0], "height": 3})
    assert depth.shape == (30, 40)
    assert abs(depth[10, 10] - 9.15) < 0.02 and np.isinf(depth[15, 20])
    model.render(40, 30, path=tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(csgcast.Error):
        model.render(40, 30, path=tmp_path / "a.stl")


def test_many_threads_may_ask_one_model(model):
    origins = np.random.default_rng(3).normal(size=(20000, 3))
    want = model.intervals(origins, [0, 0, 1]).t
    found = []
    threads = [threading.Thread(target=lambda: found.append(model.intervals(origins, [0, 0, 1]).t)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4 and all(np.array_equal(t, want) for t in found)


def test_results_outlive_the_model():
    t = csgcast.sphere(1).compile().intervals([0, 0, -5], [0, 0, 1]).t
    assert t.tolist() == [[4, 6]]


MANY = np.zeros((20000, 3)) + [0.7, 0.7, -5]

# Every method that takes a progress callback and a number of threads.
LONG_CALLS = {
    "intervals": lambda m, **how: m.intervals(MANY, [0, 0, 1], **how).t,
    "first_hits": lambda m, **how: m.first_hits(MANY, [0, 0, 1], **how).t,
    "any_hits": lambda m, **how: m.any_hits(MANY, [0, 0, 1], **how),
    "locate": lambda m, **how: m.locate(MANY, **how),
    "thickness": lambda m, **how: m.thickness(MANY, [0, 0, 1], **how),
    "measure": lambda m, **how: m.measure(**how).volume,
    "section": lambda m, **how: m.section([0, 0.1, 1], **how).area,
    "thinnest": lambda m, **how: m.thinnest(30, **how)[0],
    "check": lambda m, **how: m.check(**how).not_asked,
    "render": lambda m, **how: m.render(100, 80, **how),
}


def test_the_list_of_long_calls_is_whole():
    for option in ("progress", "threads"):
        taking = {name for name, method in inspect.getmembers(csgcast.Model, inspect.isfunction)
                  if not name.startswith("_") and option in inspect.signature(method).parameters}
        assert taking == set(LONG_CALLS)


@pytest.mark.parametrize("name", LONG_CALLS)
def test_any_number_of_threads_gives_the_same(model, name):
    call = LONG_CALLS[name]
    want = call(model, threads=0)
    for threads in (1, 3):
        assert np.array_equal(call(model, threads=threads), want)
    with pytest.raises(ValueError, match="threads"):
        call(model, threads=-1)


def test_models_are_made_on_any_number_of_threads(model):
    want = model.intervals(MANY, [0, 0, 1]).t
    for threads in (1, 3):
        assert np.array_equal(angel().compile(threads=threads).intervals(MANY, [0, 0, 1]).t, want)
        assert csgcast.Scene(angel()).compile(threads=threads).counts == model.counts
    for solid in (angel(), csgcast.Scene(angel())):
        with pytest.raises(ValueError, match="threads"):
            solid.compile(threads=-1)


def test_one_thread_is_the_one_that_calls(model):
    callers = set()
    model.intervals(MANY, [0, 0, 1], threads=1, progress=lambda share: callers.add(threading.get_ident()))
    assert callers == {threading.get_ident()}


@pytest.mark.parametrize("name", LONG_CALLS)
def test_progress_tells_cancels_by_false_and_passes_on_what_it_raises(model, name):
    call = LONG_CALLS[name]
    want = call(model, progress=None)
    shares = []
    assert np.array_equal(call(model, progress=shares.append), want)
    assert shares == sorted(shares) and len(shares) >= 2 and 0 <= shares[0] <= 1 and shares[-1] == 1
    for goes_on in (None, True, 0, "", np.True_):
        assert np.array_equal(call(model, progress=lambda share: goes_on), want)
    for cancels in (False, np.False_):
        told = []

        def stop(share):
            told.append(share)
            return cancels if len(told) == 2 else None

        with pytest.raises(csgcast.Cancelled):
            call(model, progress=stop)
        assert len(told) == 2

    class Enough(Exception):
        pass

    def fail(share):
        raise Enough

    with pytest.raises(Enough):
        call(model, progress=fail)


def test_a_cancelled_picture_is_not_written(tmp_path, model):
    (tmp_path / "a.png").write_text("old")
    with pytest.raises(csgcast.Cancelled):
        model.render(100, 80, path=tmp_path / "a.png", progress=lambda share: False)
    assert (tmp_path / "a.png").read_text() == "old"


def test_a_measure_may_be_enough(model):
    errors = []

    def enough(error):
        errors.append(error)
        return error < 1e-2

    for goes_on in (False, np.False_, None, 0):
        assert model.measure(1e-6, enough=lambda error: goes_on).as_asked
    with pytest.raises(csgcast.Cancelled):
        model.measure(1e-9, progress=lambda share: False, enough=lambda error: False)
    rough = model.measure(1e-9, enough=enough)
    assert not rough.as_asked and errors[-1] < 1e-2 <= errors[-2]
    assert abs(rough.volume - model.measure(1e-6).volume) <= 1.01 * rough.volume_error
    with pytest.raises(ZeroDivisionError):
        model.measure(1e-9, enough=lambda error: 1 / 0)


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o755])
def test_files_keep_their_permissions_and_links(tmp_path, model, mode):
    (tmp_path / "link.csg").symlink_to("a.csg")
    (tmp_path / "link.png").symlink_to("a.png")
    for name in ("a.csg", "a.png"):
        (tmp_path / name).write_text("old")
        (tmp_path / name).chmod(mode)
    csgcast.save(angel(), tmp_path / "link.csg")
    model.render(20, 10, path=tmp_path / "link.png")
    for name in ("a.csg", "a.png"):
        assert (tmp_path / name).stat().st_mode & 0o777 == mode and (tmp_path / name).read_bytes() != b"old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csg", "a.png", "link.csg", "link.png"]
    with pytest.raises(csgcast.Error):
        csgcast.save(angel(), tmp_path / "no" / "a.csg")


@pytest.mark.parametrize("call", [
    lambda m: m.intervals([[0, 0]], [0, 0, 1]),
    lambda m: m.intervals([[0, 0, 0], [1, 1, 1]], [[0, 0, 1], [0, 0, 1], [0, 0, 1]]),
    lambda m: m.intervals([0, 0, 0], [0, 0, 0]),
    lambda m: m.intervals([0, 0, math.nan], [0, 0, 1]),
    lambda m: m.intervals([0, 0, 0], [0, 0, 1], t_min=2, t_max=1),
    lambda m: m.locate([[0, 0, math.inf]]),
    lambda m: m.measure(0),
    lambda m: m.measure(math.nan),
    lambda m: m.section([0, 0, 0], 1),
    lambda m: m.section([0, 1], 1),
    lambda m: m.section([0, 0, 1], math.nan),
    lambda m: m.render(0, 10),
    lambda m: m.render(mode="nice"),
    lambda m: m.render(samples=4, adaptive=True, mode="depth"),
    lambda m: m.render(background="nocolor"),
    lambda m: m.render(background=[-1, 0, 0]),
    lambda m: csgcast.Light(),
    lambda m: csgcast.Light([0, 0, 1], [0, 0, 1]),
    lambda m: csgcast.Light(direction=[0, 0, 0]),
    lambda m: csgcast.Light([0, 0, 1], intensity=-1),
    lambda m: csgcast.Light([0, 0, 1], color="#ff000080"),
    lambda m: csgcast.Light(direction=[0, 0, 1], falloff=2),
    lambda m: csgcast.Light([0, 0, math.nan]),
    lambda m: csgcast.Camera([0, 0, 1], [0, 0, 1]),
    lambda m: csgcast.Camera([0, 0, 1], [0, 0, 0], fov=180),
    lambda m: csgcast.Camera([0, 0, 1], [0, 0, 0], fov=20, height=1),
    lambda m: csgcast.Settings(max_depth=101),
    lambda m: csgcast.Settings(min_contribution=-1),
    lambda m: csgcast.sphere(1).material(reflection=1.5),
    lambda m: csgcast.sphere(1).material(ior=0),
    lambda m: csgcast.sphere(1).material(diffuse=math.nan),
    lambda m: csgcast.sphere(1).material(emission=[0, -1, 0]),
    lambda m: csgcast.sphere(1).material("nocolor"),
    lambda m: m.section([0, 0, 1], 0).polyline(0),
    lambda m: m.section([0, 0, 1], 0).svg(math.nan),
    lambda m: m.section([0, 0, 1], 0).save("a.dxf"),
    lambda m: csgcast.halfspace([0, 0, 1], 0).compile().section([1, 0, 0]).svg(),
    lambda m: m.render(camera={"eye": [0, 0, 1]}),
    lambda m: m.render(camera={"eye": [0, 0, 1], "look_at": [0, 0, 0], "zoom": 2}),
    lambda m: csgcast.box([1, 2]),
    lambda m: csgcast.box([1, 2, math.nan]),
    lambda m: csgcast.sphere(1, d=2),
    lambda m: csgcast.sphere(math.inf),
    lambda m: csgcast.halfspace([0, 0, 0], 1),
    lambda m: csgcast.quadric([[1, 2, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0], -1),
    lambda m: csgcast.convex(),
    lambda m: csgcast.sphere(1).translate([0, 0, math.nan]),
    lambda m: csgcast.sphere(1).transform([[1, 0, 0, 0]] * 2),
    lambda m: csgcast.sphere(1).part(""),
    lambda m: csgcast.sphere(1).part("a", -1),
    lambda m: csgcast.sphere(1).part("a", math.inf),
    lambda m: csgcast.sphere(1).part("a", math.nan),
    lambda m: csgcast.sphere(1).color([1, 2, 3]),
    lambda m: (csgcast.sphere(1).part("a") - csgcast.sphere(0.5)).compile(),
    lambda m: csgcast.sphere(1).compile(weld=-1),
    lambda m: csgcast.load("/nowhere/at/all.csg"),
    lambda m: csgcast.read("cube(1"),
    lambda m: csgcast.read("cube(1);", facets="some"),
])
def test_what_makes_no_sense_raises_value_error(model, call):
    with pytest.raises(ValueError):
        call(model)


def test_errors_name_the_place():
    with pytest.raises(csgcast.Error, match=r"<text>:2:1: error: .*teapot"):
        csgcast.read("cube(1);\nteapot();")


def test_operators_and_transforms():
    a, b = csgcast.box(2), csgcast.box(2).translate([1, 0, 0])
    volume = lambda solid: solid.compile().measure(1e-9).volume
    assert volume(a + b) == pytest.approx(12) == volume(a | b) == volume(csgcast.union(a, b))
    assert volume(a - b) == pytest.approx(4) == volume(csgcast.difference(a, b))
    assert volume(a & b) == pytest.approx(4) == volume(csgcast.intersection(a, b))
    assert volume(a & ~b) == pytest.approx(4)
    assert volume(a.scale(0.5)) == pytest.approx(1) == volume(a.scale([0.5, 0.25, 1]))
    assert volume(a.mirror([1, 0, 0]) & a) == 0
    assert volume(a.transform([[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 5], [0, 0, 0, 1]])) == pytest.approx(16)
    assert volume(csgcast.convex(points=[[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])) == pytest.approx(1 / 6)
    assert volume(csgcast.quadric(np.eye(3), [0, 0, 0], -1)) == pytest.approx(4 / 3 * math.pi)
    assert volume(csgcast.cylinder(1, r1=1, r2=0)) == pytest.approx(math.pi / 3)
    assert volume(csgcast.cylinder(d=2)) == pytest.approx(math.pi)
    assert volume(csgcast.paraboloid(2, 1)) == pytest.approx(math.pi)
    assert volume(csgcast.ellipsoid([1, 2, 3])) == pytest.approx(8 * math.pi)


def test_parts_alone(tmp_path):
    text = 'light(position = [9, 9, 9]); part("a") { cube(1); } part("b", density = 2) { translate([5, 0, 0]) { cube(2); } } sphere(9);'
    scene = csgcast.read(text)
    assert scene.parts == ["a", "b"] == scene.solid.parts
    alone = scene.only("b")
    assert alone.parts == ["b"]
    m = alone.compile().measure()
    assert abs(m.mass - 16) <= m.mass_error and abs(m.volume - 8) <= m.volume_error
    assert scene.solid.only(["a", "b"]).compile().measure().parts[0].name == "a"
    assert alone.compile().render(8, 6).shape == (6, 8, 3)
    with pytest.raises(ValueError, match="no part is named 'c'; there are .'a', 'b'"):
        scene.only("c")


def test_bounds_colors_and_names():
    moved = csgcast.box([1, 2, 3]).translate([1, 1, 1])
    assert np.allclose(moved.bounds, [[1, 1, 1], [2, 3, 4]], atol=1e-12)
    assert np.isinf(csgcast.halfspace([0, 0, 1], 0).bounds).any() and csgcast.empty().bounds[0, 0] > csgcast.empty().bounds[1, 0]
    picture = [csgcast.box(2, center=True).color(c).compile().render(9, 9) for c in ("red", "#f00", [1, 0, 0], "blue")]
    assert (picture[0] == picture[1]).all() and (picture[0] == picture[2]).all() and not (picture[0] == picture[3]).all()
    for wrong in (5, None, [1, 0, "x"], b"red"):
        with pytest.raises(TypeError, match="a color is"):
            moved.color(wrong)
        with pytest.raises(TypeError, match="only"):
            moved.only(wrong)
    with pytest.raises(ValueError, match="not all three"):
        csgcast.cylinder(r=1, r1=2, r2=3)
    with pytest.raises(ValueError, match="leave t_min"):
        moved.compile().intervals([0, 0, 0], [1, 0, 0], line=True, t_min=2)
    with pytest.raises(TypeError):
        csgcast.load(None)
    assert repr(csgcast.read('part("a") { cube(1); }')) == "<csgcast.Scene: 1 parts: 'a'>"
    with pytest.raises(ValueError, match="there is no color 'rad'"):
        moved.color("rad")
    assert repr(moved) == "<csgcast.Solid: moved>"
    assert np.array_equal(copy.deepcopy(moved).bounds, copy.copy(moved).bounds)
    assert repr(moved.part("a") + moved.part("b'c")) == "<csgcast.Solid: union, parts 'a', \"b'c\">"


def test_solids_are_written_and_pickled(tmp_path):
    solid = angel().color("teal").part("angel", density=2.5) + csgcast.hyperboloid(2, 1, 0.3).rotate(33, [1, 2, 3])
    csgcast.save(solid, tmp_path / "angel.csg")
    assert [p.name for p in tmp_path.iterdir()] == ["angel.csg"]
    o = np.random.default_rng(1).normal(size=(500, 3)) * 3
    lists = [s.compile(weld=0).intervals(o, -o + 0.1, line=True)
             for s in (solid, csgcast.load(tmp_path / "angel.csg", facets="never").solid, pickle.loads(pickle.dumps(solid)))]
    for other in lists[1:]:
        assert np.array_equal(lists[0].t, other.t) and np.array_equal(lists[0].offsets, other.offsets)
        assert np.array_equal(lists[0].parts, other.parts)
    assert csgcast.sphere(0.1).translate([1, 0, 0]).to_text().split() == (
        "multmatrix(m = [[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { sphere(r = 0.1); }".split())


def test_models_and_scenes_are_pickled_and_copied(tmp_path):
    (tmp_path / "scene.csg").write_text((EXAMPLES / "still-life.csg").read_text())
    scene = csgcast.load(tmp_path / "scene.csg")
    model = scene.compile()
    (tmp_path / "scene.csg").unlink()
    o = np.random.default_rng(1).normal(size=(500, 3)) * 9
    for other in (pickle.loads(pickle.dumps(model)), copy.copy(model), copy.deepcopy(model), pickle.loads(pickle.dumps(scene)).compile(),
                  copy.deepcopy(scene).compile()):
        one, two = model.intervals(o, -o), other.intervals(o, -o)
        assert all(np.array_equal(getattr(one, name), getattr(two, name)) for name in one.__dataclass_fields__)
        leaves = range(model.counts["leaves"])
        assert [model.leaf(i) for i in leaves] == [other.leaf(i) for i in leaves] and "scene.csg:" in model.leaf(0)
        assert np.array_equal(model.render(64, 48), other.render(64, 48))
        assert model.parts == other.parts and model.counts == other.counts
    assert pickle.dumps(model) == pickle.dumps(pickle.loads(pickle.dumps(model)))
    odd = csgcast.read("cube(1); camera(eye = [9, 8, 7], look_at = [0, 0, 0], height = 3); background([0.1, 0.2, 0.3]);"
                       "light(position = [1, 2, 30], falloff = 20, color = [1, 0.5, 0.25]); light(direction = [1, 2, -3], intensity = 0.3);"
                       "settings(max_depth = 0); scale([0, 1, 1]) { cube(1); }")
    again = pickle.loads(pickle.dumps(odd))
    assert odd.warnings == again.warnings != []
    assert np.array_equal(odd.compile().render(40, 30), again.compile().render(40, 30))


def test_colors_and_welding_survive_a_pickle():
    random = np.random.default_rng(3)
    balls = [csgcast.sphere(0.5).translate([i % 12, i // 12, 0]).color(list(random.random(3)) + [1.0]) for i in range(144)]
    camera = {"eye": [5.5, 5.5, 40], "look_at": [5.5, 5.5, 0], "up": [0, 1, 0], "height": 13}
    model = csgcast.union(balls).compile()
    again = pickle.loads(pickle.dumps(model))
    assert np.array_equal(model.render(96, 96, camera=camera), again.render(96, 96, camera=camera))
    near = csgcast.box(1) + csgcast.box(1).translate([1 + 1e-9, 0, 0])
    for weld in (None, 0, 1e-6):
        model = near.compile(weld=weld)
        assert pickle.loads(pickle.dumps(model)).counts["surfaces"] == model.counts["surfaces"]
    assert near.compile(weld=1e-6).counts["surfaces"] < near.compile(weld=0).counts["surfaces"]
    assert pickle.loads(pickle.dumps(csgcast.sphere(1).compile())).leaf(0) == "sphere"  # made here: without a place


def test_a_region_of_a_picture(model):
    whole = model.render(60, 40, samples=9, adaptive=True)
    assert np.array_equal(model.render(60, 40, samples=9, adaptive=True, region=(7, 11, 33, 40)), whole[11:40, 7:33])
    tiles = [model.render(60, 40, samples=9, adaptive=True, tile=(i, 3)) for i in range(3)]
    assert [tile.shape[0] for tile in tiles] == [13, 13, 14] and np.array_equal(np.concatenate(tiles), whole)
    with pytest.raises(csgcast.Error, match="tile 3/3 does not exist"):
        model.render(60, 40, tile=(3, 3))
    with pytest.raises(csgcast.Error, match="empty or not within the picture"):
        model.render(60, 40, region=(0, 0, 61, 40))
    with pytest.raises(ValueError, match="not both"):
        model.render(60, 40, region=(0, 0, 1, 1), tile=(0, 2))


def test_thickness_along_rays():
    plate = csgcast.box([10, 10, 2]).compile()
    assert plate.thickness([[5, 5, 9], [5, 5, -9], [20, 5, 9], [5, 5, 1]], [[0, 0, -1], [1, 1, 9], [0, 0, -1], [0, 0, 1]]).tolist() == [2, 2, 0, 0]
    assert plate.thickness([5, 5, 9], [[0, 0, -1], [0, 0, 1]]).tolist() == [2, 0]
    assert csgcast.halfspace([0, 0, 1], 0).compile().thickness([0, 0, 9], [0, 0, -1]).tolist() == [np.inf]
    assert len(plate.thickness([], [])) == 0
    with pytest.raises(csgcast.Error, match="ray 1 .* cannot be cast"):
        plate.thickness([0, 0, 0], [[0, 0, 1], [0, 0, 0]])
    with pytest.raises(csgcast.Cancelled):
        plate.thickness(np.zeros((100000, 3)) + [5, 5, 9], [0, 0, -1], progress=lambda share: False)


def test_everything_public_says_what_it_is():
    for name in csgcast.__all__:
        thing = getattr(csgcast, name)
        members = vars(thing).items() if isinstance(thing, type) else ()
        said = {name: thing} | {f"{name}.{m}": v for m, v in members if not m.startswith("_") and (callable(v) or isinstance(v, property))}
        for what, of in said.items():
            if what != "__version__":
                last_line = (of.__doc__ or "").strip().split("\n")[-1]  # the first of a function in C++ is its signature
                assert len(last_line) > 8 and "->" not in last_line, what


STUBS = ast.parse(Path(csgcast.__file__).with_suffix(".pyi").read_text())


def public_calls():
    """(name, callable, its definition in the stubs) of everything public that can be called."""
    defined = {node.name: node for node in STUBS.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    for name in csgcast.__all__:
        thing = getattr(csgcast, name)
        if name == "__version__":
            continue
        yield name, thing, defined[name]
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if callable(value) and not member.startswith("_"):
                methods = {node.name: node for node in defined[name].body if isinstance(node, ast.FunctionDef)}
                yield f"{name}.{member}", getattr(thing, member), methods.get(member)


def told_parameters(node):
    """(name, kind, default) of each parameter that the stubs tell; the default ... stands for any."""
    kinds = inspect.Parameter
    value = lambda default: kinds.empty if default is None else ... if isinstance(default, ast.Constant) and default.value is ... \
        else eval(compile(ast.Expression(default), "stub", "eval"))
    arguments = node.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + arguments.defaults
    yield from ((a.arg, kinds.POSITIONAL_OR_KEYWORD, value(d)) for a, d in zip(arguments.args, defaults))
    if arguments.vararg:
        yield arguments.vararg.arg, kinds.VAR_POSITIONAL, kinds.empty
    yield from ((a.arg, kinds.KEYWORD_ONLY, value(d)) for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults))


def told_of_class(node):
    """The parameters of a class: of its __init__, else of a dataclass's fields."""
    for inner in node.body:
        if isinstance(inner, ast.FunctionDef) and inner.name == "__init__":
            return list(told_parameters(inner))[1:]
    fields = [inner for inner in node.body if isinstance(inner, ast.AnnAssign)]
    arguments = ast.arguments([], [ast.arg(f.target.id) for f in fields], None, [], [], None, [f.value for f in fields if f.value])
    return list(told_parameters(ast.FunctionDef("__init__", arguments, [], [])))


@pytest.mark.parametrize("name, thing, stub", list(public_calls()), ids=lambda value: value if isinstance(value, str) else "")
def test_signatures_can_be_inspected_and_are_those_of_the_stubs(name, thing, stub):
    signature = inspect.signature(thing)
    if name in ("Error", "Cancelled"):
        assert str(signature) == "(*args)"
        return
    told = told_of_class(stub) if isinstance(stub, ast.ClassDef) else list(told_parameters(stub))
    own = [p for p in signature.parameters.values() if not p.name.startswith("_")]
    assert [(p.name, p.kind) for p in own] == [(parameter, kind) for parameter, kind, _ in told]
    for p, (_, _, default) in zip(own, told):
        assert (p.default is p.empty) == (default is p.empty)
        if default is not ... and default is not p.empty:
            assert p.default == default and type(p.default) is type(default)


def test_stubs_name_what_there_is():
    named = {n.name: n for n in STUBS.body if isinstance(n, (ast.FunctionDef, ast.ClassDef))} | {"__version__": None}
    assert set(named) == set(csgcast.__all__)
    for name, stub in named.items():
        if not isinstance(stub, ast.ClassDef) or name in ("Error", "Cancelled"):
            continue
        in_stubs = {n.name for n in stub.body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")}
        own = {k for k, v in vars(getattr(csgcast, name)).items() if callable(v) or isinstance(v, property)}
        assert {k for k in own if not k.startswith("_")} == in_stubs


def test_lengths_per_ray():
    ball = csgcast.sphere(1) - csgcast.sphere(0.5)
    table = ball.compile().intervals([[0, 0, -5], [0, 0, 5], [0.2, 0, -5], [9, 0, 0]], [0, 0, 2])
    lengths = table.lengths_per_ray()
    assert lengths.shape == (4,) and lengths.dtype == np.float64
    assert lengths.tolist() == [sum(b - a for a, b in table.of(i)) for i in range(4)] and lengths[0] == 0.5 and lengths[1] == lengths[3] == 0
    assert (~ball).compile().intervals([0, 0, 0], [0, 0, 1], line=True).lengths_per_ray().tolist() == [math.inf]
    assert csgcast.everything().compile().intervals([[0, 0, 0]] * 2, [0, 0, 1]).lengths_per_ray().tolist() == [math.inf] * 2
    for count in (0, 3):
        none = csgcast.empty().compile().intervals(np.zeros((count, 3)), [0, 0, 1]).lengths_per_ray()
        assert none.tolist() == [0.0] * count and none.dtype == np.float64


def distance_to_polyline(points, line):
    """Of each point, (n, 2), to the nearest chord."""
    a, b = line[:-1], line[1:]
    along = b - a
    at = ((points[:, None] - a) * along).sum(-1) / (along * along).sum(-1)
    return np.linalg.norm(points[:, None] - a - np.clip(at, 0, 1)[..., None] * along, axis=-1).min(1)


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-5])
def test_polylines_are_as_near_as_they_say(tolerance):
    # A circle, an ellipse, both ends of a parabola and a hyperbola, and straight lines, far from the origin.
    solid = csgcast.sphere(1) + csgcast.cylinder(h=9, r=0.3, center=True).rotate(60, [0, 1, 0]).translate([4, 0, 0])
    solid = solid + csgcast.paraboloid(2, 1).rotate(90, [1, 0, 0]).translate([9, 0, 0]) \
        + csgcast.hyperboloid(2, 1, 0.3).rotate(90, [1, 0, 0]).translate([13, 0, 0])
    for place in ([0, 0, 0], [100, -50, 0]):
        cut = solid.translate(place).compile().section([0, 0, 1], 0.05)
        lines = cut.polyline(tolerance)
        assert len(lines) == len(cut.loops) >= 4
        turns = np.linspace(0, 2 * np.pi, 20000)
        circle = np.stack([np.cos(turns), np.sin(turns)], 1) * math.sqrt(1 - 0.05 ** 2) + place[:2]
        round_one = min(lines, key=lambda line: np.abs(line.mean(0) - place[:2]).sum())
        assert distance_to_polyline(circle, round_one).max() <= tolerance + cut.place_error + 1e-12
        area = 0
        for line, (points, conics, _) in zip(lines, cut.loops):
            assert (line[0] == line[-1]).all() and line.shape[1] == 2
            u, v = line.T
            area += 0.5 * (u[:-1] * v[1:] - u[1:] * v[:-1]).sum()
            # Every point is on one of the loop's conics, and each arc's points are near the line.
            assert distance_to_polyline(points.reshape(-1, 2), line).max() <= 2 * cut.place_error + 1e-12
            a, b, c, d, e, f = (conics[:, i, None] for i in range(6))
            value = a * u * u + b * u * v + c * v * v + d * u + e * v + f
            slope = np.hypot(2 * a * u + b * v + d, b * u + 2 * c * v + e)
            assert (np.abs(value) / slope).min(0).max() < 1e-9
        assert abs(area - cut.area) <= tolerance * cut.perimeter + 1e-6
        space = cut.polyline(tolerance, space=True)
        assert all(np.allclose(p, cut.origin + q[:, :1] * cut.u + q[:, 1:] * cut.v) for p, q in zip(space, lines))
        assert all(np.allclose(p[:, 2], 0.05) for p in space)


def test_straight_sections_have_their_corners_only():
    lines = csgcast.box([2, 3, 4]).compile().section([0, 0, 1], 1).polyline(1e-9)
    assert len(lines) == 1 and len(lines[0]) == 5
    assert csgcast.box(1).compile().section([0, 0, 1], 9).polyline(1) == []


def test_sections_are_saved(tmp_path, model):
    cut = model.section([0, 0, 1], 0.9)
    cut.save(tmp_path / "a.svg")
    assert (tmp_path / "a.svg").read_text() == cut.svg() and cut.svg().count("<path") == 1
    assert len(cut.svg(1e-9)) >= len(cut.svg(1e-1))
    cut.save(tmp_path / "a.json")
    assert (tmp_path / "a.json").read_text() == cut.json()
    told = json.loads(cut.json())
    assert told["area"] == cut.area and len(told["loops"]) == len(cut.loops)
    cut.save(tmp_path / "a.png", pixels=50)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    other = pickle.loads(pickle.dumps(cut))
    assert other.svg() == cut.svg() and other.json() == cut.json()
    other.save(str(tmp_path / "b.svg"))
    with pytest.raises(ValueError, match="another process"):
        other.save(tmp_path / "b.png")


def test_materials_are_those_of_the_scene_text():
    text = ("material(color = [0.2, 0.4, 0.6], ambient = 0.1, diffuse = 0.5, specular = 0.3, shininess = 9, reflection = 0.25, "
            "transmission = 0.5, ior = 1.5, emission = [0, 0, 0.1], absorption = [1, 0, 0]) { sphere(1); }")
    solid = csgcast.sphere(1).material([0.2, 0.4, 0.6], 0.1, 0.5, 0.3, 9, 0.25, 0.5, 1.5, [0, 0, 0.1], [1, 0, 0])
    assert solid.to_text() == csgcast.read(text, facets="never").solid.to_text()
    assert csgcast.sphere(1).material().to_text() == csgcast.read("material() { sphere(1); }", facets="never").solid.to_text()
    assert csgcast.sphere(1).material("red").to_text() == csgcast.sphere(1).material([1, 0, 0]).to_text()
    matt, shiny = (csgcast.sphere(1).material("white", reflection=r).compile().render(9, 9) for r in (0, 0.5))
    assert not np.array_equal(matt, shiny)


SCENE = """camera(eye = [5, -7, 4], look_at = [0, 0, 0], fov = 20);
light(position = [3, -9, 9], color = [1, 0.5, 0.25], intensity = 2, falloff = 9);
light(direction = [0, 1, -1]);
background(color = [0.1, 0.2, 0.3]);
settings(max_depth = 3, min_contribution = 0.01);
material(reflection = 0.5) { sphere(1); }
cube(1);
"""


def test_scenes_are_made_and_told():
    read = csgcast.read(SCENE, facets="never")
    assert read.camera == csgcast.Camera([5, -7, 4], [0, 0, 0], [0, 0, 1], fov=20)
    lights = (csgcast.Light([3, -9, 9], color=[1, 0.5, 0.25], intensity=2, falloff=9), csgcast.Light(direction=[0, 1, -1]))
    assert read.lights == lights and read.background == (0.1, 0.2, 0.3) and read.settings == csgcast.Settings(3, 0.01)
    solid = csgcast.sphere(1).material(reflection=0.5) + csgcast.box(1)
    made = csgcast.Scene(solid, camera=read.camera, lights=lights, background=[0.1, 0.2, 0.3], settings=csgcast.Settings(3, 0.01))
    want = read.compile().render(60, 40)
    assert np.array_equal(made.compile().render(60, 40), want)
    said = solid.compile().render(60, 40, camera={"eye": [5, -7, 4], "look_at": [0, 0, 0], "fov": 20}, lights=lights,
                                  background=read.background, settings=read.settings)
    assert np.array_equal(said, want)
    bare = csgcast.Scene(solid)
    assert bare.camera is None and bare.lights == () and bare.background is None and bare.settings == csgcast.Settings()
    assert np.array_equal(bare.compile().render(30, 20), solid.compile().render(30, 20))
    assert repr(csgcast.Scene(solid.part("a"))) == "<csgcast.Scene: 1 parts: 'a'>"
    model = made.compile()
    assert np.array_equal(model.render(60, 40, background="#fff"), model.render(60, 40, background=[1, 1, 1]))
    assert not np.array_equal(model.render(60, 40, lights=()), want)
    adaptive = model.render(60, 40, samples=4, adaptive=True)
    assert adaptive.shape == want.shape and not np.array_equal(adaptive, model.render(60, 40, samples=4))
    with pytest.raises(TypeError):
        csgcast.Scene("sphere(1);")


def test_the_package_runs_the_program(tmp_path):
    run = lambda *arguments: subprocess.run([sys.executable, "-m", "csgcast", *arguments], capture_output=True, text=True)
    assert run("--version").stdout == f"csgcast {csgcast.__version__}\n"
    (tmp_path / "a.csg").write_text("cube(2);")
    cut = csgcast.box(2).compile().section([0, 0, 1], 1)
    told = json.loads(run("section", str(tmp_path / "a.csg"), "--plane", "0,0,1,1").stdout)
    assert told == json.loads(cut.json())
    assert run("no-such-command").returncode != 0
