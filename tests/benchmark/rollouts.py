"""Steps a second of alembert.rollout by threads and by workers of Dask, and what a shard costs beside its steps.

python3 tests/benchmark/rollouts.py FILE [--root floating] [--threads 1,2] [--workers 1,2] [--count 4096] [--steps 500]

The shortest of four runs. The motions fall from near the initial state under forces that are held.
"""
import argparse
import os
import pathlib
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src" / "python"))
os.environ["PYTHONPATH"] = str(ROOT / "src" / "python")

import alembert  # noqa: E402
import numpy as np  # noqa: E402


def shortest(action, repetitions=4):
    times = []
    for _ in range(repetitions):
        start = time.perf_counter()
        action()
        times.append(time.perf_counter() - start)
    return min(times)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--root", default="fixed")
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--workers", default="1,2")
    parser.add_argument("--count", type=int, default=4096)
    parser.add_argument("--steps", type=int, default=500)
    parser.add_argument("--shard", type=int, default=512)
    given = parser.parse_args()
    started = time.perf_counter()
    m = alembert.load(given.file, ["mass_matrix_and_bias"], root=given.root)
    rng = np.random.default_rng(1)
    q = np.tile(m.initial_coordinates, (given.count, 1))
    qd = 0.1 * rng.normal(size=(given.count, m.nv))
    u = 1e-3 * rng.normal(size=(given.count, m.nv))
    total = given.count * given.steps

    def roll(**more):
        options = dict(controls="forces", steps=given.steps, step=1e-3)
        found = alembert.rollout(m, q, qd, **{"u": u, **options, **more})
        assert "out" in more or not found.status.any(), "motions ended early"
        return found

    roll(steps=1)
    print(f"{m.name}: {m.nv} speeds; loading and compiling took {time.perf_counter() - started:.1f} s where they were not kept")
    print(f"{given.count} motions of {given.steps} steps; steps a second, in millions")
    for method in ("semi-implicit-euler", "rk4"):
        for threads in map(int, given.threads.split(",")):
            print(f"  {method}, {threads} threads: {1e-6 * total / shortest(lambda: roll(method=method, threads=threads)):.3f}")
    print(f"  semi-implicit-euler, one thread, baseline: "
          f"{1e-6 * total / shortest(lambda: roll(threads=1, instructions='baseline')):.3f}")
    policy = shortest(lambda: roll(u=lambda t, q, qd: u + 0 * qd, threads=1))
    print(f"  semi-implicit-euler, one thread, a policy of numpy each step: {1e-6 * total / policy:.3f}")
    from distributed import Client, LocalCluster

    for workers in map(int, given.workers.split(",")):
        with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            client.wait_for_workers(workers)
            roll(steps=1, shard=given.shard, client=client)
            spent = shortest(lambda: roll(shard=given.shard, client=client))
            print(f"  semi-implicit-euler, {workers} workers, shards of {given.shard}: {1e-6 * total / spent:.3f}")
            # Shards of one step: all that is left is what a shard costs.
            small = 8
            count = given.count // small
            print(f"    a shard of {small} motions without steps: "
                  f"{1e3 * shortest(lambda: roll(steps=0, shard=small, client=client)) / count * workers:.2f} ms of a worker")
            with tempfile.TemporaryDirectory() as folder:
                places = iter(range(10))
                written = shortest(lambda: roll(steps=0, shard=small, client=client, out=pathlib.Path(folder) / str(next(places))))
                print(f"    the same into a folder: {1e3 * written / count * workers:.2f} ms of a worker")


if __name__ == "__main__":
    main()
