# SPDX-License-Identifier: MIT
"""Rays and pictures on many machines, by Dask: docs/distributed.md.

    from dask.distributed import Client
    from csgcast import distributed
    client = Client("tcp://scheduler:8786")
    hits = distributed.first_hits(model, "rays.npy", folder="hits")     # rays (count, 6): origin and direction
    for first, shard in hits.iter(): ...                                # arrays of Hits, memory-mapped

Work is cut into shards of rays, or tiles of pictures. Each is a task of its own, and its answer a folder or a file of its
own, which appears whole or not at all. The answers are bit for bit those of Model. All machines must see `folder`.

Rays are given by `rays` and `directions`:

    arrays (count, 3), numpy or dask; one of them may be (3,), for all. A dask array's chunks along rays are the shards
    a path of an .npy file (count, 6), or two of (count, 3): each worker maps the rows that it needs
    a function rays(first, count) that returns origins and directions, with count= of all; it must return the same each time

A call may be repeated on its folder, after whatever ended it: what is finished is not done again. The folder's manifest.json
tells what it was made from; for another scene, option or cut there is an Error.
"""
import hashlib
import json
import os
import pickle
import shutil
import socket
import threading
import time
import uuid
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import Error, Hits, Intervals, Model, _core, _told

__all__ = ["Frames", "Shards", "any_hits", "first_hits", "intervals", "locate", "render", "thickness"]

_VERSION = 1
_inf = float("inf")


def _dask():
    """dask and dask.distributed."""
    try:
        import dask
        import distributed
    except ImportError as error:
        raise ImportError(f"csgcast.distributed needs Dask ({error}); install python3-distributed, or pip install distributed") from None
    return dask, distributed


def _error(problem, why, remedy):
    return Error(f"csgcast: error: {problem} ({why}); {remedy}")


# ---- On the workers ------------------------------------------------------------------------------------------------------

_models = {}
_models_lock = threading.Lock()
_MOST_MODELS = 4


def _model(folder, name, key):
    """The model of this key: read and compiled once a process, by the first task; the others wait for it."""
    with _models_lock:
        entry = _models.pop(key, None) or [threading.Lock(), None]
        _models[key] = entry  # the last one used stands last
        while len(_models) > _MOST_MODELS:
            del _models[next(iter(_models))]
    with entry[0]:
        if entry[1] is None:
            entry[1] = pickle.loads((Path(folder) / name).read_bytes())
        return entry[1]


def _write_whole(path, write):
    """Has a file written under another name beside it, then gives it its own."""
    path = Path(path)
    unfinished = path.with_name(f".{path.name}.{socket.gethostname()}-{os.getpid()}-{uuid.uuid4().hex[:8]}")
    try:
        with open(unfinished, "wb") as file:
            write(file)
        os.replace(unfinished, path)
    except FileNotFoundError:
        if not path.exists():
            raise
    finally:
        unfinished.unlink(missing_ok=True)


def _write_shard(folder, name, arrays, facts):
    """A folder of .npy files and shard.json. If there is one by now, from another try, it holds the same."""
    target = Path(folder) / name
    unfinished = target.with_name(f".{name}.{socket.gethostname()}-{os.getpid()}-{uuid.uuid4().hex[:8]}")
    unfinished.mkdir()
    try:
        sizes = {}
        for key, array in arrays.items():
            np.save(unfinished / f"{key}.npy", array)
            sizes[key] = (unfinished / f"{key}.npy").stat().st_size
        (unfinished / "shard.json").write_text(json.dumps({**facts, "bytes": sizes}))
        os.rename(unfinished, target)
    except OSError:
        if _facts_of(target) is None:
            raise
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


def _facts_of(shard):
    """What shard.json says; None if the shard is not there or not whole."""
    try:
        facts = json.loads((shard / "shard.json").read_text())
        whole = all((shard / f"{key}.npy").stat().st_size == size for key, size in facts["bytes"].items())
        return facts if whole else None
    except (OSError, ValueError, KeyError):
        return None


def _mapped(path):
    """An array in a file; one without numbers cannot be mapped."""
    try:
        return np.load(path, mmap_mode="r")
    except ValueError:
        return np.load(path)


def _rows_of(source, first, count):
    """(origins, directions) of rays, from what stands for them in a task."""
    kind, *what = source
    if kind == "function":
        rows = what[0](first, count)
        return rows if isinstance(rows, tuple) else (rows, None)
    if kind == "file":
        rows = _mapped(what[0])[first:first + count]
        return rows[:, :3], rows[:, 3:]
    return tuple(_mapped(part)[first:first + count] if isinstance(part, str) else part for part in what)


def _ask(model, call, origins, directions, options):
    """The arrays of an answer, by name."""
    if call == "locate":
        return {"locations": model.locate(origins, **options)}
    found = getattr(model, call)(origins, directions, **options)
    if call == "any_hits":
        return {"hits": found}
    if call == "thickness":
        return {"thickness": found}
    arrays = {key: getattr(found, key) for key in found.__dataclass_fields__}
    return {key: array for key, array in arrays.items() if array is not None}


def _answer(folder, key, call, options, threads, index, first, count, source, *parts):
    """A task: answers one shard, and writes it. Returns numbers only."""
    shard = f"shard-{index:08}"
    if _facts_of(Path(folder) / shard) is None:
        model = _model(folder, "model.pickle", key)
        origins, directions = (*parts, None)[:2] if parts else _rows_of(source, first, count)
        rows = {len(part) for part in (origins, directions) if part is not None and np.ndim(part) == 2}
        if rows - {count}:
            raise _error(f"shard {index} got {max(rows - {count})} rays", f"{count} belong to it", "give as many as are counted")
        arrays = _ask(model, call, origins, directions, {**options, "threads": threads})
        _write_shard(folder, shard, arrays, {"first": first, "count": count, "intervals": len(arrays["t"]) if call == "intervals" else 0})
    return index


def _draw(folder, model_name, key, options, threads, camera, region, name):
    """A task: makes one tile of a picture."""
    if not (Path(folder) / name).exists():
        model = _model(folder, model_name, key)
        picture = model.render(**options, camera=camera, region=region, threads=threads)
        _write_whole(Path(folder) / name, lambda file: np.save(file, picture))
    return name


# ---- In the client -------------------------------------------------------------------------------------------------------

def _run(client, distributed, tasks, window):
    """Has all tasks done, so that at most `window` are under way. tasks: an iterator of (function, arguments).

    A task that takes much longer than others, as on a machine that hangs, is started once more on a worker that has nothing
    to do; the first answer counts. Until then its place is another's.
    """
    started = {}  # future: (function, arguments, since, number)
    copies = {}  # number: futures
    durations = []
    ended = False
    number = 0

    def start(function, arguments, number, **where):
        future = client.submit(function, *arguments, key=f"csgcast-{uuid.uuid4().hex}", pure=False, **where)
        started[future] = (function, arguments, time.monotonic(), number)
        copies.setdefault(number, []).append(future)

    def overdue():
        patience = max(4 * sorted(durations)[len(durations) // 2], 1.0) if durations else 5.0
        return [f for f, (_, _, since, n) in started.items() if len(copies[n]) == 1 and time.monotonic() - since > patience]

    try:
        while not ended or started:
            late = overdue()
            while not ended and len(started) - len(late) < window and len(started) < 2 * window:
                task = next(tasks, None)
                if task is None:
                    ended = True
                else:
                    start(*task, number)
                    number += 1
            if not started:
                break
            if late:
                _start_elsewhere(client, late, started, start)
            try:
                done, _ = distributed.wait(list(started), timeout=0.5, return_when="FIRST_COMPLETED")
            except (TimeoutError, distributed.TimeoutError):
                continue
            for future in done:
                if future not in started:
                    continue
                _, _, since, n = started.pop(future)
                future.result()  # raises what the task did
                durations.append(time.monotonic() - since)
                del durations[:-64]
                for other in copies.pop(n):
                    if other is not future:
                        started.pop(other, None)
                        other.cancel()
    finally:
        for future in started:
            future.cancel()


def _start_elsewhere(client, late, started, start):
    processing = client.processing()
    idle = [worker for worker in client.scheduler_info()["workers"] if not processing.get(worker)]
    for future in late[:len(idle)]:
        function, arguments, _, number = started[future]
        start(function, arguments, number, workers=idle, allow_other_workers=True)


def _client(distributed, client):
    if client is not None:
        return client
    try:
        return distributed.get_client()
    except ValueError:
        raise _error("there is no Dask client", "nothing says which machines are to work",
                     "make a dask.distributed.Client, or pass client=") from None


def _window(client, window):
    threads = sum(worker["nthreads"] for worker in client.scheduler_info()["workers"].values())
    return max(2 * threads, 2) if window is None else max(int(window), 1)


def _check_threads(threads):
    if threads < 1:
        raise ValueError("threads must be 1 or more")


def _hash(*things):
    """Of bytes, and of what JSON tells."""
    digest = hashlib.sha256()
    for thing in things:
        data = thing if isinstance(thing, bytes) else json.dumps(thing, sort_keys=True).encode()
        digest.update(len(data).to_bytes(8, "little"))
        digest.update(data)
    return digest.hexdigest()


def _prepare(folder, manifest, payloads):
    """The folder with manifest and models, new or from an earlier run. Throws Error if that was another."""
    folder = Path(folder).absolute()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / "manifest.json"
    if path.exists():
        try:
            old = json.loads(path.read_text())
        except ValueError:
            raise _error(f"{path} is no manifest", "it is not JSON", "give another folder") from None
        for name in manifest:
            if old.get(name) != manifest[name]:
                raise _error(f"{folder} holds another result", f"its '{name}' differs", "give another folder, or delete this one")
    elif any(folder.iterdir()):
        raise _error(f"{folder} is not empty", "it holds no manifest.json", "give a new folder")
    for name, payload in payloads.items():
        if not (folder / name).exists():
            _write_whole(folder / name, lambda file, payload=payload: file.write(payload))
    if not path.exists():
        _write_whole(path, lambda file: file.write(json.dumps(manifest, indent=1).encode()))
    return folder


def _remove_unfinished(folder):
    """What tasks left that died. Only where all is finished: another try may be under way else."""
    for path in folder.glob(".*"):
        shutil.rmtree(path, ignore_errors=True) if path.is_dir() else path.unlink(missing_ok=True)


# ---- Rays ----------------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class _Source:
    """Rays, cut into shards. pieces(index, first, count): what goes to the task, and dask blocks that it needs."""
    count: int
    cuts: list  # where shards begin, and the end
    identity: str
    pieces: object


def _is_dask(array):
    return hasattr(array, "to_delayed") and hasattr(array, "chunks")


def _cuts(count, shard):
    return [*range(0, count, shard), count] if count else [0, 0]


def _array_identity(array):
    array = np.ascontiguousarray(array)
    return _hash([list(array.shape), str(array.dtype)], array.tobytes() if array.nbytes < 1 << 20 else hashlib.sha256(array).digest())


def _file_identity(path):
    status = os.stat(path)
    return [os.path.abspath(path), status.st_size, status.st_mtime_ns]


def _source(rays, directions, count, shard, is_points):
    dask, _ = _dask()
    names = "points" if is_points else "rays"
    if shard is not None and shard < 1:
        raise ValueError("shard must be 1 or more")
    if callable(rays):
        if directions is not None or count is None:
            raise ValueError(f"a function of {names} needs count=, and returns directions by itself")
        return _Source(count, _cuts(count, shard or 1 << 18), _hash(["function", dask.base.tokenize(rays)]),
                       lambda index, first, many: (("function", rays), ()))
    if count is not None:
        raise ValueError(f"count= belongs to a function of {names}")
    parts = [rays] if is_points else [rays, directions]
    if not is_points and directions is None:
        if not isinstance(rays, (str, os.PathLike)):
            raise ValueError("directions are missing; only a file or a function has them with the origins")
        return _file_source(os.path.abspath(rays), shard)
    if any(_is_dask(part) for part in parts):
        return _dask_source(dask, parts, shard)
    return _array_source(parts, shard)


def _file_source(path, shard):
    array = np.load(path, mmap_mode="r")
    if array.ndim != 2 or array.shape[1] != 6:
        raise ValueError(f"{path} must have shape (rays, 6), not {array.shape}")
    return _Source(len(array), _cuts(len(array), shard or 1 << 18), _hash(["file", _file_identity(path)]),
                   lambda index, first, many: (("file", path), ()))


def _opened(part):
    array = np.load(part, mmap_mode="r") if isinstance(part, (str, os.PathLike)) else np.asarray(part, dtype=float)
    if array.shape != (3,) and (array.ndim != 2 or array.shape[1] != 3):
        raise ValueError(f"rays must have shape (rays, 3), or (3,) for one, not {array.shape}")
    return array


def _array_source(parts, shard):
    arrays = [_opened(part) for part in parts]
    lengths = {len(array) for array in arrays if array.ndim == 2}
    if len(lengths) > 1:
        raise ValueError("origins and directions must be as many, or one of them for all")
    count = lengths.pop() if lengths else 1
    identity = [_hash(["file", _file_identity(part)]) if isinstance(part, (str, os.PathLike)) else _array_identity(array)
                for part, array in zip(parts, arrays)]

    def piece(part, array, first, many):
        if isinstance(part, (str, os.PathLike)) and array.ndim == 2:
            return os.path.abspath(part)
        return np.array(array[first:first + many]) if array.ndim == 2 else np.array(array)

    def pieces(index, first, many):
        found = [piece(part, array, first, many) for part, array in zip(parts, arrays)]
        return ("parts", *found, *([None] if len(found) == 1 else [])), ()

    # What goes with the tasks passes the scheduler: some megabytes at a time.
    return _Source(count, _cuts(count, shard or 1 << 17), _hash(["arrays", identity]), pieces)


def _dask_source(dask, parts, shard):
    """The chunks of a dask array are the shards; another part must be one array of (3,), or have the same length."""
    if shard is not None:
        raise ValueError("the chunks of a dask array are the shards: rechunk it, and leave shard= out")
    lead = next(part for part in parts if _is_dask(part))
    chunks = lead.chunks[0]
    if lead.ndim != 2 or lead.shape[1] != 3 or any(np.isnan(chunks)):
        raise ValueError("a dask array of rays must have shape (rays, 3) and chunks of known sizes")
    import dask.array
    blocks, identity = [], []
    for part in parts:
        if not _is_dask(part):
            array = _opened(part)
            if array.ndim == 2:
                part = dask.array.from_array(array, chunks=(chunks, (3,)))
        if _is_dask(part):
            if part.shape != lead.shape:
                raise ValueError("origins and directions must be as many, or one of them for all")
            part = part.rechunk((chunks, (3,)))
            blocks.append(part.to_delayed().ravel())
            identity.append(part.name)
        else:
            blocks.append(array)
            identity.append(_array_identity(array))

    def pieces(index, first, many):
        return ("blocks",), tuple(block[index] if block.ndim == 1 and block.dtype == object else block for block in blocks)

    return _Source(lead.shape[0], [int(at) for at in np.cumsum([0, *chunks])], _hash(["dask", identity]), pieces)


class Shards:
    """An answer that lies in a folder, shard by shard. Nothing of it is in memory until it is asked for.

    shards  a list of {"first", "count", "intervals"}: which rays each holds, and of intervals how many there are
    count   of all rays; intervals: of all intervals, for the call of that name
    """

    def __init__(self, folder):
        """Of a folder that a call has filled. Throws Error if it is not finished."""
        self.folder = Path(folder).absolute()
        try:
            self.manifest = json.loads((self.folder / "manifest.json").read_text())
            self.call, cuts = self.manifest["call"], self.manifest["cuts"]
        except (OSError, ValueError, KeyError):
            raise _error(f"{self.folder} holds no answer", "its manifest.json is missing or another one's", "give the folder of a call") from None
        self.shards = []
        for index, (first, end) in enumerate(zip(cuts, cuts[1:])):
            facts = _facts_of(self._path(index))
            if facts is None or facts["first"] != first or facts["count"] != end - first:
                raise _error(f"{self.folder} is not finished", f"shard {index} of {len(cuts) - 1} is missing or broken",
                             "make the same call again: it does what is missing")
            self.shards.append({key: facts[key] for key in ("first", "count", "intervals")})
        self.count = cuts[-1]
        self.intervals = sum(shard["intervals"] for shard in self.shards)

    def __len__(self):
        return len(self.shards)

    def _path(self, index):
        return self.folder / f"shard-{index:08}"

    def _answer(self, arrays):
        if self.call == "first_hits":
            return Hits(**arrays)
        if self.call == "intervals":
            return Intervals(**{name: arrays.get(name) for name in Intervals.__dataclass_fields__})
        return next(iter(arrays.values()))

    def __getitem__(self, index):
        """One shard, memory-mapped: Hits, Intervals (offsets count within the shard), or an array."""
        if not -len(self.shards) <= index < len(self.shards):
            raise IndexError(f"there are {len(self.shards)} shards, no shard {index}")
        path = self._path(index % len(self.shards))
        return self._answer({file.stem: _mapped(file) for file in sorted(path.glob("*.npy"))})

    def iter(self):
        """(number of its first ray, shard) of each shard, in order."""
        for index, shard in enumerate(self.shards):
            yield shard["first"], self[index]

    def load(self):
        """The whole answer as one, in memory: what Model returns. offsets are int64."""
        shards = [self[index] for index in range(len(self.shards))]
        if self.call not in ("first_hits", "intervals"):
            return np.concatenate(shards)
        kind = Hits if self.call == "first_hits" else Intervals
        arrays = {}
        for name in kind.__dataclass_fields__:
            parts = [getattr(shard, name) for shard in shards]
            if name == "offsets":
                arrays[name] = self._offsets(parts)
            else:
                arrays[name] = np.concatenate(parts) if parts[0] is not None else None
        return kind(**arrays)

    def _offsets(self, parts):
        """Of all shards as if they were one."""
        before = np.cumsum([0, *(shard["intervals"] for shard in self.shards)])
        return np.concatenate([*(part[:-1] + start for part, start in zip(parts, before)), before[-1:]])

    def __repr__(self):
        return f"<csgcast.distributed.Shards: {self.call}, {self.count} rays in {len(self.shards)} shards, in {str(self.folder)!r}>"


def _ask_all(call, model, rays, directions, options, *, folder, count, shard, client, window, threads):
    _, distributed = _dask()
    if not isinstance(model, Model):
        raise TypeError("model must be a csgcast.Model: compile the solid")
    if folder is None:
        raise ValueError("folder= says where the answer goes")
    _check_threads(threads)
    source = _source(rays, directions, count, shard, call == "locate")
    client = _client(distributed, client)
    payload = pickle.dumps(model, protocol=4)
    key = hashlib.sha256(payload).hexdigest()
    shown = {name: repr(value) for name, value in options.items()}
    manifest = {"csgcast": _VERSION, "call": call, "scene": key, "options": shown, "rays": source.identity, "cuts": source.cuts}
    path = _prepare(folder, manifest, {"model.pickle": payload})

    def tasks():
        for index, (first, end) in enumerate(zip(source.cuts, source.cuts[1:])):
            if _facts_of(path / f"shard-{index:08}") is not None:
                continue
            shutil.rmtree(path / f"shard-{index:08}", ignore_errors=True)
            what, blocks = source.pieces(index, first, end - first)
            futures = [client.compute(block) if hasattr(block, "dask") else block for block in blocks]
            yield _answer, (str(path), key, call, options, threads, index, first, end - first, what, *futures)

    _run(client, distributed, tasks(), _window(client, window))
    _remove_unfinished(path)
    return Shards(path)


def intervals(model, rays, directions=None, *, folder, t_min=0.0, t_max=_inf, line=False, faces=True, normals=True, count=None,
              shard=None, client=None, window=None, threads=1):
    """Model.intervals of all rays, as Shards in `folder`.

    shard: rays a shard (2^18; of arrays in memory 2^17; dask arrays have chunks). client: a dask.distributed.Client; else the present one. window: the most
    shards under way (two for each thread of the workers). threads: of each worker's process, at one shard.
    """
    if line and (t_min != 0.0 or t_max != _inf):
        raise ValueError("line=True is the whole line: leave t_min and t_max out")
    options = {"t_min": t_min, "t_max": t_max, "line": line, "faces": faces, "normals": normals}
    return _ask_all("intervals", model, rays, directions, options, folder=folder, count=count, shard=shard, client=client,
                    window=window, threads=threads)


def first_hits(model, rays, directions=None, *, folder, t_min=0.0, t_max=_inf, count=None, shard=None, client=None, window=None,
               threads=1):
    """Model.first_hits of all rays, as Shards; see intervals()."""
    return _ask_all("first_hits", model, rays, directions, {"t_min": t_min, "t_max": t_max}, folder=folder, count=count,
                    shard=shard, client=client, window=window, threads=threads)


def any_hits(model, rays, directions=None, *, folder, t_min=0.0, t_max=_inf, count=None, shard=None, client=None, window=None,
             threads=1):
    """Model.any_hits of all rays, as Shards; see intervals()."""
    return _ask_all("any_hits", model, rays, directions, {"t_min": t_min, "t_max": t_max}, folder=folder, count=count,
                    shard=shard, client=client, window=window, threads=threads)


def thickness(model, rays, directions=None, *, folder, count=None, shard=None, client=None, window=None, threads=1):
    """Model.thickness of all rays, as Shards; see intervals()."""
    return _ask_all("thickness", model, rays, directions, {}, folder=folder, count=count, shard=shard, client=client,
                    window=window, threads=threads)


def locate(model, points, *, folder, count=None, shard=None, client=None, window=None, threads=1):
    """Model.locate of all points, as Shards; see intervals(). points: (count, 3), a file of them, or a function."""
    return _ask_all("locate", model, points, None, {}, folder=folder, count=count, shard=shard, client=client, window=window,
                    threads=threads)


# ---- Pictures ------------------------------------------------------------------------------------------------------------

class Frames:
    """Pictures that lie in a folder, tile by tile. frames[i] is a picture, as Model.render returns it; len() tells how many."""

    def __init__(self, folder):
        """Of a folder that render() has filled. Throws Error if it is not finished."""
        self.folder = Path(folder).absolute()
        try:
            self.manifest = json.loads((self.folder / "manifest.json").read_text())
            self._frames, self._tiles = self.manifest["frames"], self.manifest["tiles"]
        except (OSError, ValueError, KeyError):
            raise _error(f"{self.folder} holds no pictures", "its manifest.json is missing or another one's", "give the folder of render()") from None
        for name in self.names():
            if not (self.folder / name).exists():
                raise _error(f"{self.folder} is not finished", f"{name} is missing", "make the same call again: it does what is missing")

    def names(self):
        """The files, .npy: by frame, then by tile from the top."""
        return [_tile_name(frame, tile) for frame in range(self._frames) for tile in range(self._tiles)]

    def __len__(self):
        return self._frames

    def __getitem__(self, frame):
        if not -self._frames <= frame < self._frames:
            raise IndexError(f"there are {self._frames} frames, no frame {frame}")
        return np.concatenate([np.load(self.folder / _tile_name(frame % self._frames, tile), mmap_mode="r") for tile in range(self._tiles)])

    def iter(self):
        """Each picture, in order; one is in memory at a time."""
        for frame in range(self._frames):
            yield self[frame]

    def __repr__(self):
        return f"<csgcast.distributed.Frames: frames: {self._frames}, tiles of each: {self._tiles}, in {str(self.folder)!r}>"


def _tile_name(frame, tile):
    return f"frame-{frame:06}-tile-{tile:06}.npy"


def render(model, width=800, height=600, *, folder, cameras=None, tiles=1, samples=1, mode="shaded", adaptive=False, client=None,
           window=None, threads=1):
    """Pictures as of Model.render, as Frames in `folder`.

    model: one, or a list of them; cameras: None, one camera or a list. Of each list a frame is made for each entry; if there are two
    they go together. tiles: into how many bands of rows each picture is cut. client, window and threads as of intervals().
    """
    _, distributed = _dask()
    models = list(model) if isinstance(model, (list, tuple)) else [model]
    if not models or not all(isinstance(one, Model) for one in models):
        raise TypeError("model must be a csgcast.Model, or a list of them: compile the solid")
    views = [_told(view) for view in (cameras if isinstance(cameras, (list, tuple)) else [cameras])]
    frames = max(len(models), len(views)) if views else 0
    if not {len(models), len(views)} <= {1, frames} or frames == 0:
        raise ValueError("models and cameras must be as many, or one of them for all")
    regions = [_core._band(width, height, tile, tiles) for tile in range(tiles)]
    if not regions:
        raise ValueError("tiles must be 1 or more")
    _check_threads(threads)
    client = _client(distributed, client)
    keys, payloads = [], {}
    for one in models:
        payload = pickle.dumps(one, protocol=4)
        keys.append(hashlib.sha256(payload).hexdigest())
        payloads[f"model-{keys[-1][:16]}.pickle"] = payload
    cameras_as_text = [None if view is None else {name: np.asarray(value, dtype=float).tolist() for name, value in view.items()} for view in views]
    options = {"width": width, "height": height, "samples": samples, "mode": mode, "adaptive": adaptive}
    manifest = {"csgcast": _VERSION, "call": "render", "scene": _hash(keys), "options": options, "cameras": cameras_as_text,
                "frames": frames, "tiles": tiles}
    path = _prepare(folder, manifest, payloads)

    def tasks():
        for frame in range(frames):
            key = keys[frame % len(keys)]
            for tile, region in enumerate(regions):
                name = _tile_name(frame, tile)
                if not (path / name).exists():
                    yield _draw, (str(path), f"model-{key[:16]}.pickle", key, options, threads, views[frame % len(views)], region, name)

    _run(client, distributed, tasks(), _window(client, window))
    _remove_unfinished(path)
    return Frames(path)
