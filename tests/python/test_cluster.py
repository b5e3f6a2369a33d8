"""Rollouts on the workers of Dask: two are killed in mid-run, the client is cut off once, and all is as in one process."""
import hashlib
import os
import pathlib
import signal
import threading
import time

import alembert
import numpy as np
import pytest
from conftest import ROOT

distributed = pytest.importorskip("distributed", reason="python3-distributed is missing")

COUNT, SHARD, WORKERS = 600, 10, 3


def make_policy(log, gate):
    """It says which shard it is of, and lets as many shards go on as the file `gate` tells: so there is a middle of the run, whatever the machine does."""

    def policy(t, q, qd):
        if t == 0:
            line = f"{q[0, 0]!r} {os.getpid()}"
            with open(log, "a") as file:
                file.write(line + "\n")
            number = log.read_text().splitlines().index(line) + 1
            while number > int(gate.read_text() or 0):
                time.sleep(0.01)
        return -0.2 * qd

    return policy


def files(folder):
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(pathlib.Path(folder).glob("[0-9]*"))}


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    # Workers have a cache of their own, and take the package from where this process has it.
    work = tmp_path_factory.mktemp("cluster")
    before = dict(os.environ)
    os.environ.update(PYTHONPATH=str(ROOT / "src" / "python"), XDG_CACHE_HOME=str(work / "cache"), PYTHONDONTWRITEBYTECODE="1")
    config = {"distributed.worker.memory.terminate": False, "distributed.scheduler.worker-ttl": None}
    try:
        import dask

        with dask.config.set(config), distributed.LocalCluster(n_workers=WORKERS, threads_per_worker=1, processes=True,
                                                               dashboard_address=None, local_directory=str(work)) as made:
            yield made
    finally:
        os.environ.clear()
        os.environ.update(before)


def wait_for(condition, seconds=300):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "nothing happened"
        time.sleep(0.01)


def pids(client):
    return set(client.run(os.getpid, on_error="ignore").values())


def is_idle(client):
    return not any(client.run(lambda dask_worker: len(dask_worker.state.executing)).values())


def test_nothing_is_lost_and_nothing_is_done_twice(load, cluster, tmp_path):
    m = load("double_pendulum")
    rng = np.random.default_rng(5)
    q, qd = rng.uniform(-1, 1, (COUNT, 2)), rng.normal(size=(COUNT, 2))
    log, gate = tmp_path / "log", tmp_path / "gate"
    log.touch()
    gate.write_text("6")
    task = dict(steps=60, step=0.01, every=20, hold=10, shard=SHARD)
    shards = COUNT // SHARD
    alone = alembert.rollout(m, q, qd, lambda t, q, qd: -0.2 * qd, **task, out=tmp_path / "alone")
    assert len(alone) == shards
    many = tmp_path / "many"
    done = lambda: len(list(many.glob("[0-9]*")))  # noqa: E731
    begun = lambda: [line.split() for line in log.read_text().splitlines()]  # noqa: E731

    # A first client: two of three workers are killed, then it is cut off.
    first = distributed.Client(cluster)
    failed = []

    def run():
        try:
            alembert.rollout(m, q, qd, make_policy(log, gate), **task, out=many, client=first)
        except BaseException as error:  # noqa: B902
            failed.append(error)

    running = threading.Thread(target=run)
    running.start()
    wait_for(lambda: done() >= 6 and len(begun()) == 6 + WORKERS)  # each worker stands in a shard
    killed = set(sorted(pids(first))[:2])
    for pid in killed:
        os.kill(pid, signal.SIGKILL)
    gate.write_text("30")
    wait_for(lambda: done() >= 20)
    first.close()
    running.join(300)
    assert not running.is_alive() and failed, "a client that is cut off says so"
    # What is under way comes to an end; half is missing.
    gate.write_text("1000")
    with distributed.Client(cluster) as between:
        wait_for(lambda: len(pids(between) - killed) == WORKERS)
        wait_for(lambda: is_idle(between))
    kept = files(many)
    left = alembert.open_rollouts(many).missing
    assert 0 < len(left) < shards and len(kept) + len(left) == shards
    written = {name: (many / name).stat().st_mtime_ns for name in kept}

    # A second one goes on where that was.
    with distributed.Client(cluster) as second:
        folder = alembert.rollout(m, q, qd, make_policy(log, gate), **task, out=many, client=second)
    assert folder.missing == [] and files(many) == files(tmp_path / "alone")
    assert all((many / name).stat().st_mtime_ns == when for name, when in written.items())
    assert not [path for path in many.glob(".*") if path.stat().st_mtime_ns > max(written.values())]
    # A shard was begun again only where a worker had died with it, or the client was cut off with it.
    firsts = {repr(x) for x in q[::SHARD, 0]}
    assert {start for start, _ in begun()} == firsts
    assert len(begun()) - shards <= len(killed) + WORKERS
    assert len({pid for _, pid in begun()}) == WORKERS + len(killed), "workers were replaced"
    built = os.listdir(pathlib.Path(os.environ["XDG_CACHE_HOME"]) / "alembert")
    assert len(built) == 1, "one worker builds, the others wait"
    for name, x in zip(("q", "qd"), (folder.read().q, folder.read().qd)):
        assert np.array_equal(x, getattr(alone.read(), name))


def test_results_come_back_without_a_folder(load, cluster):
    m = load("double_pendulum")
    q = np.random.default_rng(6).uniform(-1, 1, (45, 2))
    with distributed.Client(cluster) as client:
        ends = alembert.rollout(m, q, steps=20, step=0.01, every=5, shard=7, client=client)

        def broken(t, q, qd):
            raise KeyError("no such gain")

        with pytest.raises(KeyError, match="no such gain"):
            alembert.rollout(m, q, u=broken, steps=20, step=0.01, shard=7, client=client)
        drawn = alembert.rollout(m, lambda rng, n: {"q": rng.normal(size=(n, 2))}, steps=3, step=0.01, every=1, count=20, seed=1,
                                 shard=8, client=client)
    whole = alembert.rollout(m, q, steps=20, step=0.01, every=5)
    assert all(np.array_equal(a, b) for a, b in zip(ends, whole))
    again = alembert.rollout(m, lambda rng, n: {"q": rng.normal(size=(n, 2))}, steps=3, step=0.01, every=1, count=20, seed=1, shard=8)
    assert np.array_equal(drawn.q, again.q)
