# SPDX-License-Identifier: MIT
"""Measures csgcast.distributed on workers of this machine: ./dev bench distributed [--rays N] [--intervals N] [--folder F].

Rays, intervals, tiles and frames are answered by four workers, of which one is killed and one is stopped again and again.
Answers are compared bit for bit with those of one process, each ray is counted, and the memory of client and workers is
watched. One-core workers are timed, one and two of them. Exits 1 if a promise is broken.
"""
import argparse
import hashlib
import logging
import os
import shutil
import signal
import tempfile
import threading
import time
from pathlib import Path

import csgcast
import distributed
import numpy as np
import psutil
from csgcast import distributed as many

MEGABYTE = 1 << 20


def rays(first, count):
    """Rays towards a scene of size 1, from numbers of their own: the same whoever asks for them."""
    index = np.arange(first, first + count, dtype=np.uint64)
    numbers = np.empty((count, 6))
    for column in range(6):
        mixed = (index * np.uint64(6) + np.uint64(column + 1)) * np.uint64(0x9E3779B97F4A7C15)
        mixed ^= mixed >> np.uint64(29)
        mixed *= np.uint64(0xBF58476D1CE4E5B9)
        mixed ^= mixed >> np.uint64(32)
        numbers[:, column] = (mixed >> np.uint64(11)) * 2.0**-53 - 0.5
    start = numbers[:, :3] * 1.4 + [0, 0, 1.5]
    return start, numbers[:, 3:] - start


class RaysTo:
    """The same towards a box."""

    def __init__(self, bounds):
        self.middle = bounds.mean(axis=0)
        self.size = float(np.max(bounds[1] - bounds[0]))

    def __call__(self, first, count):
        origins, directions = rays(first, count)
        return origins * self.size + self.middle, directions * self.size


class Memory:
    """The most memory of this process and of its workers, since it was entered, in bytes."""

    def __enter__(self):
        self.client = self.worker = 0
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self.watch)
        self.thread.start()
        return self

    def watch(self):
        own = psutil.Process()
        while not self.ended.wait(0.05):
            self.client = max(self.client, own.memory_info().rss)
            for process in own.children(recursive=True):
                try:
                    self.worker = max(self.worker, process.memory_info().rss)
                except psutil.NoSuchProcess:
                    pass

    def __exit__(self, *_):
        self.ended.set()
        self.thread.join()


class Trouble:
    """Kills one worker once files of a name are there, and stops another one again and again until the end."""

    def __init__(self, client, folder, pattern):
        until = time.monotonic() + 60
        while len(processes := list(client.run(os.getpid, on_error="ignore").values())) < 4:
            if time.monotonic() > until:
                raise TimeoutError("there are no four workers")
            time.sleep(0.2)
        self.killed, self.slow = processes[:2]
        self.folder, self.pattern = Path(folder), pattern
        self.seen = None
        self.ended = threading.Event()

    def __enter__(self):
        self.threads = [threading.Thread(target=self.kill), threading.Thread(target=self.stop)]
        for thread in self.threads:
            thread.start()
        return self

    def kill(self):
        while not self.ended.wait(0.01):
            if list(self.folder.glob(self.pattern)):
                os.kill(self.killed, signal.SIGKILL)
                self.seen = len([path for path in self.folder.iterdir() if path.name.startswith(("shard-", "frame-"))])
                return

    def stop(self):
        while not self.ended.is_set():
            os.kill(self.slow, signal.SIGSTOP)
            self.ended.wait(0.7)
            os.kill(self.slow, signal.SIGCONT)
            self.ended.wait(0.3)

    def __exit__(self, *_):
        self.ended.set()
        for thread in self.threads:
            thread.join()


class Bench:
    def __init__(self, arguments, folder):
        self.arguments = arguments
        self.folder = folder
        self.scene = csgcast.load(arguments.scene)
        self.model = self.scene.compile()
        self.rays = RaysTo(bounded(self.scene))
        self.broken = []

    def check(self, holds, what):
        print(f"  {'ok    ' if holds else 'BROKEN'} {what}", flush=True)
        if not holds:
            self.broken.append(what)

    def cluster(self, workers):
        return distributed.LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None, memory_limit=None)

    # What one process answers, a shard at a time: a hash of each array.
    def reference(self, call, count):
        hashes = {}
        since = time.monotonic()
        for first in range(0, count, self.arguments.shard):
            many_rays = self.rays(first, min(self.arguments.shard, count - first))
            add(hashes, getattr(self.model, call)(*many_rays, threads=1))
        return {name: digest.hexdigest() for name, digest in hashes.items()}, time.monotonic() - since

    def answers(self, client, call, count):
        print(f"{call} of {count} rays, shards of {self.arguments.shard}: four workers, one killed, one stopped 70 % of the time")
        folder = self.folder / f"{call}-{count}"
        shards_in_all = -(-count // self.arguments.shard)
        with Trouble(client, folder, f"shard-{shards_in_all // 3:08}") as trouble, Memory() as memory:
            since = time.monotonic()
            shards = getattr(many, call)(self.model, self.rays, count=count, folder=folder, shard=self.arguments.shard)
            seconds = time.monotonic() - since
        self.check(trouble.seen is not None and trouble.seen < shards_in_all,
                   f"a worker was killed after {trouble.seen} of {shards_in_all} shards")
        counted = [(shard["first"], shard["count"]) for shard in shards.shards]
        once = counted == [(first, min(self.arguments.shard, count - first)) for first in range(0, count, self.arguments.shard)]
        hashes = {}
        for _, shard in shards.iter():
            add(hashes, shard)
        wanted, alone = self.reference(call, count)
        self.check(once and shards.count == count, f"each of {count} rays is answered once")
        self.check({name: digest.hexdigest() for name, digest in hashes.items()} == wanted, "bit for bit as one process")
        print(f"         {seconds:.1f} s; one process, one thread {alone:.1f} s; "
              f"most memory: client {memory.client / MEGABYTE:.0f} MB, a worker {memory.worker / MEGABYTE:.0f} MB")
        shutil.rmtree(folder)
        return memory

    def memory(self, client, call, count):
        """Ten times as many rays take no more memory, but for what a few shards are."""
        few = self.answers(client, call, count // 10)
        all_ = self.answers(client, call, count)
        room = 4 * self.arguments.shard * 150 + 48 * MEGABYTE  # a ray and its answer are 61 to 150 bytes
        for who in ("client", "worker"):
            more = getattr(all_, who) - getattr(few, who)
            self.check(more < room, f"memory of the {who}: {more / MEGABYTE:+.0f} MB for ten times as many rays, less than {room / MEGABYTE:.0f}")

    def pictures(self, client):
        for name, size, tiles, cameras in [("24 tiles of 3840x2160", (3840, 2160), 24, None), ("60 frames of 640x360", (640, 360), 1, self.orbit(60))]:
            print(f"{name}: four workers, one killed, one stopped 70 % of the time")
            folder = self.folder / "pictures"
            with Trouble(client, folder, "frame-000000-tile-000005.npy" if cameras is None else "frame-000015-*.npy") as trouble, Memory() as memory:
                since = time.monotonic()
                frames = many.render(self.scene.compile(), *size, tiles=tiles, cameras=cameras, samples=4, folder=folder)
                seconds = time.monotonic() - since
            total = len(frames.names())
            self.check(trouble.seen is not None and trouble.seen < total, f"a worker was killed after {trouble.seen} of {total} tiles")
            same = all(np.array_equal(picture, self.model.render(*size, samples=4, camera=camera))
                       for picture, camera in zip(frames.iter(), cameras or [None]))
            self.check(same and len(frames) == len(cameras or [None]), "bit for bit as one process")
            print(f"         {seconds:.1f} s; most memory: client {memory.client / MEGABYTE:.0f} MB, a worker {memory.worker / MEGABYTE:.0f} MB")
            shutil.rmtree(folder)

    def orbit(self, count):
        turns = np.arange(count) * 2 * np.pi / count
        middle, size = self.rays.middle, self.rays.size
        return [{"eye": (middle + size * np.array([2 * np.cos(turn), 2 * np.sin(turn), 1.2])).tolist(), "look_at": middle.tolist()}
                for turn in turns]

    def throughput(self):
        """One worker on a core, and two on a core each."""
        count = max(self.arguments.rays // 2, 8 * self.arguments.shard)
        rates = {}
        for workers in (1, 2):
            with self.cluster(workers) as cluster, distributed.Client(cluster) as client:
                for core, (address, process) in enumerate(client.run(os.getpid).items()):
                    client.run(os.sched_setaffinity, 0, [core % os.cpu_count()], workers=[address])
                warm = self.folder / "warm"
                many.first_hits(self.model, self.rays, count=workers * 2000, folder=warm, shard=1000)  # each compiles once
                shutil.rmtree(warm)
                processes = [psutil.Process(process) for process in client.run(os.getpid).values()]
                used = sum(sum(process.cpu_times()[:2]) for process in processes)
                since = time.monotonic()
                many.first_hits(self.model, self.rays, count=count, folder=self.folder / "rate", shard=self.arguments.shard)
                seconds = time.monotonic() - since
                used = sum(sum(process.cpu_times()[:2]) for process in processes) - used
                shutil.rmtree(self.folder / "rate")
            rates[workers] = count / seconds
            print(f"{workers} one-core worker{'s' * (workers > 1)}: {rates[workers] / 1e6:.2f} million rays per second, {100 * used / seconds / workers:.0f} % of the cores' time")
            share = used / seconds / workers
        ratio = rates[2] / rates[1]
        self.check(ratio >= 1.6 or share >= 0.9, f"two workers are {ratio:.2f} times as fast as one, {100 * share:.0f} % of two cores' time on the job")


def bounded(scene):
    """The bounds of a scene, or of its parts that have some."""
    bounds = [csgcast.Solid.compile(solid).bounds for solid in [scene.solid, *(scene.only(name).solid for name in scene.parts)]]
    finite = [box for box in bounds if box is not None and np.isfinite(box).all()]
    return np.array([np.min([box[0] for box in finite], axis=0), np.max([box[1] for box in finite], axis=0)])


def add(hashes, answer):
    """Adds the arrays of a shard to the hashes of all. Offsets depend on the cut, counts do not."""
    arrays = {name: getattr(answer, name) for name in answer.__dataclass_fields__} if hasattr(answer, "__dataclass_fields__") else {"": answer}
    for name, array in arrays.items():
        if name == "offsets":
            array = np.diff(np.asarray(array).astype(np.int64))
        hashes.setdefault(name, hashlib.sha256()).update(np.ascontiguousarray(array))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rays", type=float, default=1e7, help="of first hits (1e7)")
    parser.add_argument("--intervals", type=float, default=None, help="rays of intervals (a tenth)")
    parser.add_argument("--shard", type=int, default=1 << 18, help="rays a shard")
    parser.add_argument("--scene", default=str(Path(__file__).resolve().parents[2] / "examples" / "flange.csg"))
    parser.add_argument("--folder", default=None, help="where answers go, and are deleted; 13 bytes a ray (a temporary one)")
    parser.add_argument("--only", nargs="*", choices=["rays", "intervals", "pictures", "throughput"], default=["rays", "intervals", "pictures", "throughput"])
    arguments = parser.parse_args()
    arguments.rays = int(arguments.rays)
    arguments.intervals = int(arguments.intervals or arguments.rays // 10)
    logging.getLogger("distributed").setLevel(logging.ERROR)
    with tempfile.TemporaryDirectory(dir=arguments.folder, prefix="csgcast-distributed-") as folder:
        bench = Bench(arguments, Path(folder))
        if {"rays", "intervals", "pictures"} & set(arguments.only):
            with bench.cluster(4) as cluster, distributed.Client(cluster) as client:
                if "rays" in arguments.only:
                    bench.memory(client, "first_hits", arguments.rays)
                if "intervals" in arguments.only:
                    bench.answers(client, "intervals", arguments.intervals)
                if "pictures" in arguments.only:
                    bench.pictures(client)
        if "throughput" in arguments.only:
            bench.throughput()
    return 1 if bench.broken else 0


if __name__ == "__main__":
    raise SystemExit(main())
