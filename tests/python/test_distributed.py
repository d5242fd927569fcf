# SPDX-License-Identifier: MIT
"""csgcast.distributed on two workers, of which one is killed: bit for bit what one process answers, each ray once."""
import os
import pickle
import signal
import sys
import threading
import time
from pathlib import Path

import csgcast
import numpy as np
import pytest

distributed = pytest.importorskip("distributed", reason="Dask is not installed (python3-distributed)")
import dask.array  # noqa: E402  (after it is known to be there)

from csgcast import distributed as many  # noqa: E402

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def rays(first, count):
    """Rays towards the flange, from numbers of their own: the same whoever asks for them."""
    index = np.arange(first, first + count, dtype=np.uint64)
    numbers = np.empty((count, 6))
    for column in range(6):
        mixed = (index * np.uint64(6) + np.uint64(column)) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(29)
        mixed *= np.uint64(0xBF58476D1CE4E5B9)
        numbers[:, column] = (mixed >> np.uint64(11)) * 2.0**-53 - 0.5
    origins = numbers[:, :3] * 5 + [0, -3, 5.0]
    return origins, numbers[:, 3:] * 4 - origins


def points(first, count):
    return rays(first, count)[0] - [0, -3, 5.0]


@pytest.fixture(scope="module")
def model():
    return csgcast.load(EXAMPLES / "flange.csg").compile()


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, memory_limit=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def same(one, other):
    if isinstance(one, np.ndarray):
        return one.shape == other.shape and one.tobytes() == np.ascontiguousarray(other).tobytes()
    pairs = [(getattr(one, name), getattr(other, name)) for name in one.__dataclass_fields__]
    return all(a is b is None or (a is not None and b is not None and np.array_equal(a, b)) for a, b in pairs)


def one_of_two(client):
    """The process of a worker, once there are two: one that was killed is replaced."""
    until = time.monotonic() + 60
    while time.monotonic() < until:
        try:
            processes = list(client.run(os.getpid, on_error="ignore").values())
        except (OSError, distributed.comm.CommClosedError):
            processes = []
        if len(processes) == 2:
            return processes[0]
        time.sleep(0.1)
    raise TimeoutError("there are no two workers")


def kill_one_when(client, path, pattern):
    """Kills a worker as soon as files of that name are there. Returns what waits for that to be done."""
    pid = one_of_two(client)

    def watch():
        while not list(Path(path).glob(pattern)):
            time.sleep(0.002)
        os.kill(pid, signal.SIGKILL)
        thread.done = [name for name in os.listdir(path) if name.startswith(("shard-", "frame-"))]

    thread = threading.Thread(target=watch)
    thread.start()
    return thread


def test_rays_and_a_worker_that_is_killed(model, client, tmp_path):
    count = 200_000
    killing = kill_one_when(client, tmp_path / "hits", "shard-00000003")
    shards = many.first_hits(model, rays, count=count, folder=tmp_path / "hits", shard=4096)
    killing.join()
    assert 0 < len(killing.done) < len(shards)
    assert same(shards.load(), model.first_hits(*rays(0, count)))
    assert [shard["first"] for shard in shards.shards] == list(range(0, count, 4096))
    assert sum(shard["count"] for shard in shards.shards) == shards.count == count
    assert sorted(path.name for path in (tmp_path / "hits").iterdir()) == [
        "manifest.json", "model.pickle", *(f"shard-{index:08}" for index in range(len(shards)))]
    assert isinstance(shards[0].t, np.memmap)


def test_tiles_and_a_worker_that_is_killed(model, client, tmp_path):
    killing = kill_one_when(client, tmp_path / "picture", "*-000001.npy")
    frames = many.render(model, 160, 120, folder=tmp_path / "picture", tiles=6, samples=4, adaptive=True)
    killing.join()
    assert len(frames) == 1 and 0 < len(killing.done) < 6
    assert same(frames[0], model.render(160, 120, samples=4, adaptive=True))
    assert len(list((tmp_path / "picture").glob("frame-*.npy"))) == 6


def test_a_worker_that_stops_is_not_waited_for(model, client, tmp_path):
    pid = one_of_two(client)
    os.kill(pid, signal.SIGSTOP)
    resume = threading.Timer(30, os.kill, (pid, signal.SIGCONT))
    resume.start()
    try:
        since = time.monotonic()
        hits = many.any_hits(model, rays, count=40_000, folder=tmp_path / "hits", shard=4000)
        assert time.monotonic() - since < 25
    finally:
        resume.cancel()
        os.kill(pid, signal.SIGCONT)
    assert same(hits.load(), model.any_hits(*rays(0, 40_000)))


def test_each_call_and_each_kind_of_rays(model, client, tmp_path):
    count = 5000
    origins, directions = rays(0, count)
    table = many.intervals(model, origins, directions, folder=tmp_path / "a", shard=999)
    whole = model.intervals(origins, directions)
    assert same(table.load(), whole) and table.intervals == len(whole.t) and table.load().offsets.dtype == np.int64
    assert [first for first, _ in table.iter()] == list(range(0, count, 999))
    bare = many.intervals(model, origins, directions, folder=tmp_path / "b", faces=False, normals=False, line=True).load()
    assert bare.leaves is None and same(bare, model.intervals(origins, directions, faces=False, normals=False, line=True))
    assert same(many.thickness(model, origins, directions, folder=tmp_path / "c").load(), model.thickness(origins, directions))
    assert same(many.locate(model, points, count=count, folder=tmp_path / "d", shard=777).load(), model.locate(points(0, count)))
    chunks = ((1000, 3000, 1000), (3,))
    blocks = dask.array.from_array(origins, chunks=chunks)
    hits = model.first_hits(origins, directions)
    given = many.first_hits(model, blocks, dask.array.from_array(directions, chunks=(500, 2)), folder=tmp_path / "e")
    assert [shard["count"] for shard in given.shards] == [1000, 3000, 1000] and same(given.load(), hits)
    assert same(many.any_hits(model, blocks, [0, 0, -1.0], folder=tmp_path / "f").load(), model.any_hits(origins, [0, 0, -1]))
    np.save(tmp_path / "rays.npy", np.hstack([origins, directions]))
    np.save(tmp_path / "origins.npy", origins)
    np.save(tmp_path / "directions.npy", directions)
    assert same(many.first_hits(model, tmp_path / "rays.npy", folder=tmp_path / "g").load(), hits)
    assert same(many.first_hits(model, tmp_path / "origins.npy", str(tmp_path / "directions.npy"), folder=tmp_path / "h").load(), hits)
    assert same(many.first_hits(model, origins[:0], directions[:0], folder=tmp_path / "i").load(), model.first_hits(origins[:0], directions[:0]))


def test_frames_of_cameras_and_of_models(model, client, tmp_path):
    cameras = [{"eye": [7, i, 5], "look_at": [0, 0, 0], "fov": 40} for i in range(2)]
    cameras.append(csgcast.Camera([7, 2, 5], [0, 0, 0], fov=40))
    frames = many.render(model, 40, 30, cameras=cameras, folder=tmp_path / "a", tiles=2)
    assert len(frames) == 3
    assert all(same(picture, model.render(40, 30, camera=camera)) for picture, camera in zip(frames.iter(), cameras))
    models = [csgcast.box([1, 1, size]).compile() for size in (1, 2)]
    frames = many.render(models, 40, 30, mode="depth", folder=tmp_path / "b")
    assert [frame.shape for frame in frames.iter()] == [(30, 40)] * 2
    assert all(same(frames[i], models[i].render(40, 30, mode="depth")) for i in range(2))


def test_what_is_finished_is_not_done_again(model, client, tmp_path):
    folder = tmp_path / "hits"
    first = many.first_hits(model, rays, count=20_000, folder=folder, shard=2000)
    expected = first.load()
    kept = {path: path.stat().st_mtime_ns for path in folder.glob("shard-*/t.npy")}
    lost, broken = sorted(kept)[3], sorted(kept)[5]
    (lost.parent / "shard.json").unlink()
    broken.write_bytes(broken.read_bytes()[:-1])
    with pytest.raises(csgcast.Error, match="shard 3 of 10 is missing or broken.*make the same call again"):
        many.Shards(folder)
    again = many.first_hits(pickle.loads(pickle.dumps(model)), rays, count=20_000, folder=folder, shard=2000)
    assert same(again.load(), expected) and same(many.Shards(folder).load(), expected)
    assert {path for path in kept if path.stat().st_mtime_ns != kept[path]} == {lost, broken}


def test_another_result_is_not_mixed_in(model, client, tmp_path):
    folder = tmp_path / "hits"
    many.first_hits(model, rays, count=2000, folder=folder, shard=500)
    other = csgcast.sphere(50).compile()
    for change, name in [({"shard": 400}, "cuts"), ({"t_max": 3.0}, "options"), ({"count": 1900}, "cuts")]:
        with pytest.raises(csgcast.Error, match=f"holds another result .*'{name}' differs.*; give another folder"):
            many.first_hits(model, rays, **{"count": 2000, "folder": folder, "shard": 500, **change})
    with pytest.raises(csgcast.Error, match="'scene' differs"):
        many.first_hits(other, rays, count=2000, folder=folder, shard=500)
    with pytest.raises(csgcast.Error, match="'rays' differs"):
        many.first_hits(model, points, count=2000, folder=folder, shard=500)
    with pytest.raises(csgcast.Error, match="'call' differs"):
        many.any_hits(model, rays, count=2000, folder=folder, shard=500)
    with pytest.raises(csgcast.Error, match="is not empty"):
        many.any_hits(model, rays, count=2000, folder=tmp_path)


def test_what_makes_no_sense_is_told(model, client, tmp_path):
    zero = lambda first, count: (np.zeros((count, 3)), np.zeros((count, 3)))
    with pytest.raises(csgcast.Error, match="ray 0 .*direction zero"):
        many.first_hits(model, zero, count=10, folder=tmp_path / "a")
    short = lambda first, count: (np.zeros((3, 3)), np.ones((3, 3)))
    with pytest.raises(csgcast.Error, match="got 3 rays .*10 belong to it"):
        many.first_hits(model, short, count=10, folder=tmp_path / "b")
    for arguments in [{"rays": rays}, {"rays": np.zeros((4, 3))}, {"rays": np.zeros((4, 2)), "directions": np.zeros((4, 3))},
                      {"rays": np.zeros((4, 3)), "directions": np.ones((5, 3))}, {"rays": rays, "count": 5, "shard": 0}]:
        with pytest.raises(ValueError):
            many.first_hits(model, folder=tmp_path / "c", **arguments)
    with pytest.raises(TypeError, match="compile the solid"):
        many.first_hits(csgcast.sphere(1), rays, count=5, folder=tmp_path / "c")
    with pytest.raises(csgcast.Error, match="holds no answer"):
        many.Shards(tmp_path)


def test_without_dask_there_is_one_clear_error(model, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(ImportError, match="needs Dask .*install python3-distributed"):
        many.first_hits(model, rays, count=5, folder=tmp_path / "a")
