"""Rollouts: against alembert.simulate, policies, ends, inputs and states, shards on disk, errors."""
import os
import subprocess
import sys

import alembert
import numpy as np
import pytest
from conftest import ROOT


def starts(m, n, seed=1):
    rng = np.random.default_rng(seed)
    q = m.initial_coordinates + rng.uniform(-0.3, 0.3, (n, m.nq))
    return q, rng.normal(size=(n, m.nv))


def same(a, b):
    return all(np.array_equal(x, y) for x, y in zip(a, b))


@pytest.mark.parametrize("name, method", [("double_pendulum", "rk4"), ("free_body", "rk4"), ("free_body", "linearly-implicit")])
def test_motions_are_those_of_simulate(load, name, method):
    m = load(name)
    q, qd = starts(m, 70)
    tau = 0.1 * qd
    ends = alembert.rollout(m, q, qd, tau, controls="forces", steps=30, step=0.01, every=10, method=method)
    motion = alembert.simulate(m, q, qd, 0.3, 0.01, tau, every=10, method=method)
    assert ends.q.shape == (70, 4, m.nq) and ends.qd.shape == (70, 4, m.nv) and np.allclose(ends.t, motion.t, rtol=0, atol=1e-15)
    assert np.allclose(ends.q, motion.q.transpose(1, 0, 2), rtol=0, atol=1e-10)
    assert np.allclose(ends.qd, motion.qd.transpose(1, 0, 2), rtol=0, atol=1e-9)
    assert np.all(ends.steps == 30) and not ends.status.any() and not ends.stopped.any()


def test_motions_depend_on_nothing_else(load):
    m = load("free_body")
    q, qd = starts(m, 200)
    all_ends = alembert.rollout(m, q, qd, steps=50, step=0.01, every=25)
    assert same(all_ends, alembert.rollout(m, q, qd, steps=50, step=0.01, every=25, threads=1))
    part = alembert.rollout(m, q[77:90], qd[77:90], steps=50, step=0.01, every=25)
    assert np.array_equal(part.q, all_ends.q[77:90])
    one = alembert.rollout(m, q[80], qd[80], steps=50, step=0.01, every=25)
    assert one.q.shape == (3, m.nq) and np.array_equal(one.q, all_ends.q[80]) and one.steps == 50
    # A thousand steps are ten times a hundred.
    half = alembert.rollout(m, q, qd, steps=25, step=0.01)
    rest = alembert.rollout(m, half.q[:, -1], half.qd[:, -1], steps=25, step=0.01)
    assert np.allclose(rest.q[:, -1], all_ends.q[:, -1], rtol=0, atol=1e-13)


def test_policies_are_asked_for_all_at_once(load):
    m = load("double_pendulum")
    q, qd = starts(m, 40)
    seen = []

    def damp(t, q, qd):
        seen.append((t, q.shape, qd.shape))
        return -0.5 * qd

    ends = alembert.rollout(m, q, qd, damp, steps=60, step=0.01, hold=20, every=20)
    assert [t for t, *_ in seen] == [0, 0.2, 0.4] and seen[0][1:] == ((40, 2), (40, 2))
    # The same controls as an array.
    u = np.stack([-0.5 * ends.qd[:, k] for k in range(3)], axis=1)
    assert same(ends, alembert.rollout(m, q, qd, u, steps=60, step=0.01, hold=20, every=20))
    held = alembert.rollout(m, q, qd, u[:, 0], steps=20, step=0.01, hold=20)
    assert np.array_equal(held.q[:, -1], ends.q[:, 1])
    of_all = alembert.rollout(m, q, qd, u[:1], steps=60, step=0.01, hold=20, every=20)
    assert np.array_equal(of_all.q[0], ends.q[0]) and not np.array_equal(of_all.q[1], ends.q[1])
    assert same(alembert.rollout(m, q, qd, u[0, 0], steps=60, step=0.01), alembert.rollout(m, q, qd, u[:1, 0], steps=60, step=0.01))

    def broken(t, q, qd):
        raise KeyError("no such gain")

    with pytest.raises(KeyError, match="no such gain"):
        alembert.rollout(m, q, qd, broken, steps=5, step=0.01)
    with pytest.raises(ValueError, match=r"u: expected of the policy what broadcasts to \(40, 2\), found \(3,\)"):
        alembert.rollout(m, q, qd, lambda t, q, qd: [1, 2, 3], steps=5, step=0.01)
    with pytest.raises(TypeError, match="the policy returns nothing"):
        alembert.rollout(m, q, qd, lambda t, q, qd: None, steps=5, step=0.01)


def test_motions_end(load):
    m = load("double_pendulum")
    q, qd = starts(m, 90)
    free = alembert.rollout(m, q, qd, steps=100, step=0.01, every=1)
    bounded = alembert.rollout(m, q, qd, steps=100, step=0.01, every=1, within={"q": (-0.4, 0.4)})
    assert bounded.stopped.any() and not bounded.stopped.all() and not bounded.status.any()
    for i in range(90):
        out = np.flatnonzero(np.any(np.abs(free.q[i, 1:]) > 0.4, axis=1))
        assert bounded.steps[i] == (out[0] + 1 if len(out) else 100) and bounded.stopped[i] == bool(len(out))
        last = bounded.steps[i]
        assert np.array_equal(bounded.q[i, :last + 1], free.q[i, :last + 1])
        assert np.all(bounded.q[i, last:] == free.q[i, last])
    asked = alembert.rollout(m, q, qd, steps=100, step=0.01, every=1, stop=lambda t, q, qd: np.any(np.abs(q) > 0.4, axis=1))
    # Asked before each step, and not after the last.
    assert np.array_equal(asked.steps, bounded.steps) and np.array_equal(asked.q, bounded.q) and not asked.status.any()
    with pytest.raises(ValueError, match="stop: expected 90 truth values, found float64"):
        alembert.rollout(m, q, qd, steps=5, step=0.01, stop=lambda t, q, qd: q[:, 0])


@pytest.mark.filterwarnings("error")
def test_what_is_not_finite_has_a_status(load):
    m = load("free_body")
    q, qd = starts(m, 3)
    qd[1] = 1e200
    q[2, 0] = np.nan
    ends = alembert.rollout(m, q, qd, steps=10, step=0.01, every=1)
    assert ends.status.tolist() == [0, 1, 1] and ends.steps[0] == 10 and ends.steps[2] == 0 and ends.steps[1] < 10
    assert alembert.STATUSES[ends.status[1]] == "a value is not finite"
    assert np.all(np.isfinite(ends.q[:2])) and np.isnan(ends.q[2, -1, 0])


STATES = """alembert: 1
name: lagging_block
gravity: [0, 0, 0]
parameters: {m: {value: 2, runtime: true}}
inputs: [{name: drive, initial: 1}]
coordinates: [x]
states:
  - {name: a, initial: 0.25, rate: (drive - a)/0.05}
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: m}]
forces: [{name: motor, on: x, value: 4*a}]
"""


@pytest.fixture(scope="module")
def block(tmp_path_factory, cache):
    file = tmp_path_factory.mktemp("block") / "block.yaml"
    file.write_text(STATES)
    return alembert.load(file, cache=cache)


@pytest.mark.parametrize("method, near", [("semi-implicit-euler", 2e-2), ("rk4", 1e-7), ("linearly-implicit", 2e-2)])
def test_inputs_states_and_parameters_of_each(block, method, near):
    drive = np.linspace(-1, 2, 75)
    mass = np.linspace(1, 3, 75)
    a = np.linspace(0, 0.5, 75)
    ends = alembert.rollout(block, np.zeros((75, 1)), [0.0], drive[:, None], steps=300, step=1e-3, every=100, method=method, m=mass,
                            states=a[:, None])
    lag = drive[:, None] - (drive - a)[:, None] * np.exp(-ends.t / 0.05)
    assert np.allclose(ends.states[..., 0], lag, rtol=0, atol=near)
    speed = 4 / mass[:, None] * (drive[:, None] * ends.t - (drive - a)[:, None] * 0.05 * (1 - np.exp(-ends.t / 0.05)))
    assert np.allclose(ends.qd[..., 0], speed, rtol=0, atol=near)
    single = alembert.rollout(block, [0.0], [0.0], [drive[3]], steps=300, step=1e-3, method=method, m=mass[3], states=[a[3]])
    assert np.array_equal(single.states[-1], ends.states[3, -1])
    policy = alembert.rollout(block, np.zeros((75, 1)), [0.0], lambda t, q, qd, s: drive[:, None] + 0 * s, steps=300, step=1e-3,
                              hold=50, every=100, method=method, m=mass, states=a[:, None])
    assert same(policy, ends)
    # A mass that is none is seen, in packs too.
    mass[5] = -1
    bad = alembert.rollout(block, np.zeros((75, 1)), [0.0], steps=3, step=1e-3, method=method, m=mass)
    assert bad.status[5] == 2 and np.count_nonzero(bad.status) == 1


def test_constraints_are_kept(load):
    m = load("paper/rolling_disc")
    # Thrown while it rolls: the rolling speeds are those that the first step leaves.
    ends = alembert.rollout(m, np.tile(m.initial_coordinates, (3, 1)), steps=20, step=1e-3, method="rk4")
    assert not ends.status.any()
    residual = m.constraints(ends.q[:, -1], ends.qd[:, -1])
    assert np.abs(residual.velocity).max() < 1e-9


def draw(rng, n):
    return {"q": rng.uniform(-1, 1, (n, 2)), "qd": rng.normal(size=(n, 2))}


def test_shards_in_a_folder(load, tmp_path):
    m = load("double_pendulum")
    q, qd = starts(m, 50)
    whole = alembert.rollout(m, q, qd, steps=20, step=0.01, every=10)
    folder = alembert.rollout(m, q, qd, steps=20, step=0.01, every=10, shard=16, out=tmp_path / "a")
    assert len(folder) == 4 and folder.missing == [] and folder[3]["q"].shape == (2, 3, 2) and same(folder.read(), whole)
    # What is there is not done again, what is missing is.
    kept = (tmp_path / "a" / "1").stat().st_mtime_ns
    (tmp_path / "a" / "2").unlink()
    os.truncate(tmp_path / "a" / "0", 100)
    left = alembert.open_rollouts(tmp_path / "a")
    assert left.missing == [0, 2] and np.array_equal(left[-1]["q"], left[3]["q"])
    with pytest.raises(ValueError, match="shard 0 is not done"):
        left.read()
    again = alembert.rollout(m, q, qd, steps=20, step=0.01, every=10, shard=16, out=tmp_path / "a", threads=1)
    assert same(again.read(), whole) and (tmp_path / "a" / "1").stat().st_mtime_ns == kept
    with pytest.raises(ValueError, match=r"holds another rollout \(of other rollout, step, t\)"):
        alembert.rollout(m, q, qd, steps=20, step=0.02, every=10, shard=16, out=tmp_path / "a")
    with pytest.raises(ValueError, match="no folder of a rollout"):
        alembert.open_rollouts(tmp_path)


def test_a_folder_is_an_array_of_zarr(load, tmp_path):
    zarr = pytest.importorskip("zarr", reason="python3-zarr is missing")
    m = load("double_pendulum")
    q, qd = starts(m, 50)
    for shard in (16, 50, 1000):
        folder = alembert.rollout(m, q, qd, steps=20, step=0.01, every=10, shard=shard, out=tmp_path / str(shard))
        array = zarr.open(str(folder.folder), mode="r")
        whole = folder.read()
        assert array.shape == (50,) and array.chunks == (min(shard, 50),) and np.array_equal(array.attrs["t"], whole.t)
        for name in ("q", "qd", "states", "steps", "status", "stopped"):
            assert np.array_equal(array[:][name], getattr(whole, name)), name
    (tmp_path / "16" / "2").unlink()
    records = zarr.open(str(tmp_path / "16"), mode="r")[:]
    assert np.array_equal(np.flatnonzero(records["steps"] < 0), range(32, 48)) and np.isnan(records["q"][32:48]).all()


def test_starts_are_drawn_by_seed_and_shard(load, tmp_path):
    m = load("double_pendulum")
    ends = alembert.rollout(m, draw, steps=5, step=0.01, every=5, count=40, seed=3, shard=16)
    assert ends.q.shape == (40, 2, 2)
    for index, first in enumerate((0, 16, 32)):
        n = min(16, 40 - first)
        assert np.array_equal(ends.q[first:first + n, 0], draw(np.random.default_rng([3, index]), n)["q"])
    folder = alembert.rollout(m, draw, steps=5, step=0.01, every=5, count=40, seed=3, shard=16, out=tmp_path / "drawn")
    assert same(folder.read(), ends)
    with pytest.raises(ValueError, match="holds another rollout"):
        alembert.rollout(m, draw, steps=5, step=0.01, every=5, count=40, seed=4, shard=16, out=tmp_path / "drawn")
    for arguments, message in [({}, "count: expected how many motions"), ({"count": 5, "qd": [0, 0]}, "qd: given, and drawn by q too")]:
        with pytest.raises(ValueError, match=message):
            alembert.rollout(m, draw, steps=5, step=0.01, **arguments)
    with pytest.raises(ValueError, match="expected of the function 5 starts, found 1"):
        alembert.rollout(m, lambda rng, n: {"q": [0, 0]}, steps=5, step=0.01, count=5)


@pytest.mark.parametrize("message, change", [
    (r"q: expected shape \(2,\) or \(N, 2\), found \(3,\)", {"q": [0, 0, 0]}),
    (r"qd: expected 4 states as in q, found 3", {"qd": np.zeros((3, 2))}),
    (r"u: expected shape \(2,\), \(N, 2\) or \(N, 5, 2\), found \(4, 7, 2\)", {"u": np.zeros((4, 7, 2))}),
    (r"u: expected 4 states as in q, found 3", {"u": np.zeros((3, 2))}),
    (r"u: expected an array of numbers", {"u": "full"}),
    (r"steps: expected a whole number, 0 or more, found 1.5", {"steps": 1.5}),
    (r"hold: expected a whole number, 1 or more, found 0", {"hold": 0}),
    (r"step: expected a finite number", {"step": float("nan")}),
    (r"step: expected a finite number, found None", {"step": None}),
    (r"within\['q'\]: expected the least before the largest, found 1 and 0", {"within": {"q": (1, 0)}}),
    (r"client: expected a dask.distributed.Client, found 'tcp://here'", {"client": "tcp://here"}),
    (r"method: expected one of 'semi-implicit-euler', 'rk4'", {"method": "euler"}),
    (r"controls: double_pendulum has no inputs", {"controls": "inputs"}),
    (r"within: unknown name 'qdd'; did you mean 'qd'", {"within": {"qdd": (0, 1)}}),
    (r"within\['q'\]: expected a pair of bounds", {"within": {"q": 1}}),
    (r"rollout: unknown name 'payload'", {"payload": 1}),
    (r"states: expected shape \(0,\)", {"states": [1.0]}),
    (r"shard: nothing is cut", {"shard": 5}),
    (r"count: q says how many", {"count": 5}),
])
def test_errors_name_the_argument(load, message, change):
    m = load("double_pendulum")
    with pytest.raises(ValueError, match=message):
        alembert.rollout(m, **{"q": np.zeros((4, 2)), "steps": 5, "step": 0.01, **change})


def test_controls_over_time_or_over_motions(load):
    """For one start, (K, nu) are K motions; who meant one motion is told how to write it."""
    m = load("double_pendulum")
    u = np.arange(10.0).reshape(5, 2)
    with pytest.warns(UserWarning, match=r"for one motion with 5 controls give u\[None\]"):
        many = alembert.rollout(m, [0, 0], u=u, steps=5, step=0.01)
    assert many.q.shape[0] == 5
    assert alembert.rollout(m, [0, 0], u=u[None], steps=5, step=0.01).q.shape[0] == 1


def test_modules_that_cannot(load, tmp_path):
    single = load("double_pendulum", ["mass_matrix"], scalar="float")
    with pytest.raises(ValueError, match="rollouts are of double"):
        alembert.rollout(single, [0, 0], steps=1, step=0.01)
    shipped = type(sys)("shipped")
    shipped.__dict__.update({k: v for k, v in vars(load("double_pendulum")).items() if not k.startswith("_alembert_")})
    with pytest.raises(ValueError, match="compiled from the description, which this module came without"):
        alembert.rollout(shipped, [0, 0], steps=1, step=0.01)
