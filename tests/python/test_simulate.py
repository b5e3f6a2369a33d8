"""Motions in time: against `alembert simulate`, the order of the method, many states, forces, errors."""
import io
import subprocess

import alembert
import numpy as np
import pytest
from conftest import ROOT


def by_the_command(name, duration, step, q, qd, integrator="rk4"):
    done = subprocess.run([alembert.executable(), "simulate", str(ROOT / "mechanisms" / f"{name}.yaml"), "--duration", str(duration),
                           "--step", str(step), "--every", "1", "--integrator", integrator, "--q=" + ",".join(map(str, q)), "--qd=" + ",".join(map(str, qd))],
                          capture_output=True, text=True, check=True)
    return np.loadtxt(io.StringIO(done.stdout), delimiter=",", skiprows=1)


@pytest.mark.parametrize("method", ["rk4", "linearly-implicit"])
@pytest.mark.parametrize("name", ["double_pendulum", "free_body", "moving_base"])
def test_motions_are_those_of_the_command(load, name, method):
    m = load(name)
    rng = np.random.default_rng(2)
    q, qd = m.initial_coordinates + rng.uniform(0, 0.4, m.nq), rng.normal(size=m.nv)
    rows = by_the_command(name, 0.205, 0.01, q, qd, method)
    motion = alembert.simulate(m, q, qd, 0.205, 0.01, method=method)
    assert motion.t.shape == (22,) and motion.q.shape == (22, m.nq) and motion.qd.shape == (22, m.nv)
    assert motion.t[-1] == 0.205 and np.allclose(motion.t, rows[:, 0], rtol=0, atol=1e-12)
    assert np.allclose(motion.q, rows[:, 1:1 + m.nq], rtol=1e-9, atol=1e-9)
    assert np.allclose(motion.qd, rows[:, 1 + m.nq:1 + m.nq + m.nv], rtol=1e-9, atol=1e-9)
    for first in m.quaternion_offsets:
        assert np.allclose(np.linalg.norm(motion.q[:, first:first + 4], axis=1), 1, rtol=0, atol=1e-14)


@pytest.mark.parametrize("name", ["free_body", "puma560"])
def test_the_order_is_four(load, name):
    m = load(name)
    qd = np.linspace(1, 2, m.nv)

    def end(step):
        motion = alembert.simulate(m, m.initial_coordinates, qd, 0.4, step)
        return np.append(motion.q[-1], motion.qd[-1])

    exact = end(0.0005)
    ratio = np.linalg.norm(end(0.02) - exact) / np.linalg.norm(end(0.01) - exact)
    assert 12 < ratio < 20


def test_stiff_forces_are_taken_at_the_step_of_a_frame(tmp_path):
    file = tmp_path / "block.yaml"
    file.write_text("alembert: 1\nname: block\ngravity: [0, 0, 0]\ncoordinates: [{name: x, initial: 1, stiffness: 2000, damping: 4001}]\n"
                    "bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]\n")
    m = alembert.load(file)
    h = 1 / 60
    motion = alembert.simulate(m, [[1.0], [-2.0]], [[0.0], [0.5]], 1, h, method="linearly-implicit")
    u = np.array([0.0, 0.5])
    x = np.array([1.0, -2.0])
    for k in range(1, 61):  # the implicit Euler method
        u = (2 * u - h * 2000 * x) / (2 + h * 4001 + h * h * 2000)
        x = x + h * u
        assert np.allclose(motion.q[k, :, 0], x, rtol=1e-11, atol=0) and np.allclose(motion.qd[k, :, 0], u, rtol=1e-9, atol=1e-12)
    by_newton = alembert.simulate(m, [[1.0], [-2.0]], [[0.0], [0.5]], 1, h, method="implicit")
    assert np.allclose(by_newton.q, motion.q, rtol=1e-9, atol=0)
    assert not np.all(np.abs(alembert.simulate(m, [1.0], [0.0], 1, h).q) < 1e3)
    # What tau is, it is for a step: from its beginning.
    times = []
    alembert.simulate(m, [1.0], [0.0], 0.03, 0.01, lambda t, q, qd: times.append(t) or 0 * qd, method="linearly-implicit")
    assert times == [0, 0.01, 0.02]
    with pytest.raises(ValueError, match="method: expected 'rk4', 'linearly-implicit' or 'implicit', found 'magic'"):
        alembert.simulate(m, [1.0], [0.0], 1, h, method="magic")
    short = alembert.load(file, functions=["mass_matrix_and_bias"])
    with pytest.raises(ValueError, match="written without inverse_dynamics_derivatives, which motions need"):
        alembert.simulate(short, [1.0], [0.0], 1, h, method="linearly-implicit")


def test_many_states_are_the_same_as_one_by_one(load):
    m = load("tree_every_joint")
    rng = np.random.default_rng(3)
    q, qd = m.initial_coordinates + rng.uniform(-0.2, 0.2, (5, m.nq)), rng.normal(size=(5, m.nv))
    wrench = {"drill": [0.1, 0.2, 0.3, 0, 0, 0]}
    many = alembert.simulate(m, q, qd, 0.05, 0.01, lambda t, q, qd: -1e-3 * qd, wrenches=wrench)
    assert many.q.shape == (6, 5, m.nq) and np.all(np.isfinite(many.q))
    for i in range(5):
        one = alembert.simulate(m, q[i], qd[i], 0.05, 0.01, lambda t, q, qd: -1e-3 * qd, wrenches=wrench)
        assert np.array_equal(many.q[:, i], one.q) and np.array_equal(many.qd[:, i], one.qd)
    same_start = alembert.simulate(m, q[0], qd, 0.05, 0.01)
    assert np.array_equal(same_start.q[0], np.broadcast_to(same_start.q[0, 0], (5, m.nq)))


def test_energy_is_kept_and_forces_change_it(load):
    m = load("double_pendulum")
    q, qd = [0.5, 1.0], [0, 0]
    motion = alembert.simulate(m, q, qd, 2, 1e-3, every=100)
    assert motion.t.shape == (21,) and motion.t[1] == pytest.approx(0.1)
    energy = m.energy(motion.q, motion.qd).sum(axis=1)
    assert np.ptp(energy) < 1e-8
    # Power of a held force is the change of energy.
    tau = np.array([0.3, -0.2])
    forced = alembert.simulate(m, q, qd, 1, 1e-3, tau)
    change = m.energy(forced.q[-1], forced.qd[-1]).sum() - m.energy(forced.q[0], forced.qd[0]).sum()
    assert change == pytest.approx(tau @ (forced.q[-1] - forced.q[0]), abs=1e-8)
    assert np.array_equal(forced.q, alembert.simulate(m, q, qd, 1, 1e-3, lambda t, q, qd: tau).q)


def test_a_controller_sees_time_and_state(load):
    m = load("puma560")
    goal = np.full(m.nq, 0.3)
    seen = []

    def control(t, q, qd):
        seen.append(t)
        return m.inverse_dynamics(q, qd, 100 * (goal - q) - 20 * qd)

    motion = alembert.simulate(m, m.initial_coordinates, m.initial_speeds, 2.5, 0.01, control, t=1, every=1000)
    assert motion.t.tolist() == [1, 2.5] and np.allclose(motion.q[-1], goal, atol=1e-4)
    assert seen[:5] == pytest.approx([1, 1.005, 1.005, 1.01, 1.01]) and len(seen) == 600


def test_runtime_parameters_and_float(load):
    m = load("runtime_parameters")
    start = m.initial_coordinates + 0.3, m.initial_speeds
    other = {m.parameter_names[0]: 2 * m.default_parameters[0]}
    by_default = alembert.simulate(m, *start, 0.1, 0.01)
    assert not np.allclose(by_default.q, alembert.simulate(m, *start, 0.1, 0.01, **other).q, atol=1e-6)
    single = alembert.simulate(load("runtime_parameters", scalar="float"), *start, 0.1, 0.01)
    assert single.q.dtype == np.float32 and np.allclose(single.q, by_default.q, atol=1e-4)


def test_inputs_of_each_state(load):
    m = load("runtime_parameters")
    q, qd = np.tile(m.initial_coordinates + 0.3, (3, 1)), m.initial_speeds
    parameters = m.default_parameters * np.array([[1.0], [1.1], [1.2]])
    many = alembert.simulate(m, q, qd, 0.05, 0.01, parameters=parameters)
    assert np.array_equal(many.q[:, 2], alembert.simulate(m, q[2], qd, 0.05, 0.01, parameters=parameters[2]).q)
    with pytest.raises(ValueError, match="inputs are for 3 states, q and qd for one"):
        alembert.simulate(m, q[0], qd, 0.05, 0.01, parameters=parameters)


def test_without_forward_dynamics_the_mass_matrix_serves(load):
    m = load("puma560")
    short = load("puma560", ["mass_matrix_and_bias"])
    start = m.initial_coordinates + 0.1, m.initial_speeds + 0.2
    assert np.allclose(alembert.simulate(short, *start, 0.05, 0.01).q, alembert.simulate(m, *start, 0.05, 0.01).q, atol=1e-12)


@pytest.mark.parametrize("message, change", [
    (r"q: expected shape \(10,\) or \(N, 10\), found \(3,\)", {"q": [0, 0, 0]}),
    (r"qd: expected 2 states as in q, found 3", {"q": "two", "qd": "three"}),
    (r"q: the quaternion that begins at \d+ is zero", {"q": "zero"}),
    (r"tau: expected what broadcasts to \(\d+,\), found \(2,\)", {"tau": [1, 2]}),
    (r"tau: expected what broadcasts", {"tau": lambda t, q, qd: [1, 2]}),
    (r"step: expected more than 0", {"step": 0}),
    (r"step: expected a finite number", {"step": float("nan")}),
    (r"until: expected no less than t, which is 0.0, found -1.0", {"until": -1}),
    (r"every: expected a whole number above 0", {"every": 0}),
])
def test_errors_name_the_argument(load, message, change):
    m = load("free_body")
    given = {"q": m.initial_coordinates, "qd": m.initial_speeds, "until": 0.1, "step": 0.01, **change}
    made = {"two": np.tile(m.initial_coordinates, (2, 1)), "three": np.zeros((3, m.nv)), "zero": np.zeros(m.nq)}
    given = {k: made[v] if isinstance(v, str) else v for k, v in given.items()}
    with pytest.raises(ValueError, match=message.replace("10", str(m.nq))):
        alembert.simulate(m, **given)


@pytest.mark.filterwarnings("error")
def test_what_is_not_finite_stays_so_without_a_word(load):
    m = load("free_body")
    q = np.tile(m.initial_coordinates, (2, 1))
    qd = np.zeros((2, m.nv))
    qd[0] = 1e300
    motion = alembert.simulate(m, q, qd, 0.03, 0.01)
    assert not np.all(np.isfinite(motion.q[-1, 0])) and np.all(np.isfinite(motion.q[:, 1]))


def test_constraints_are_kept(load):
    disc = load("paper/rolling_disc")
    motion = disc.simulate(disc.initial_coordinates, disc.initial_speeds, 0.205, 0.01, every=4)
    assert np.allclose(motion.t, [0, 0.04, 0.08, 0.12, 0.16, 0.2, 0.205], atol=1e-14) and motion.q.shape == (7, disc.nq)
    rows = by_the_command("paper/rolling_disc", 0.205, 0.01, disc.initial_coordinates, disc.initial_speeds)[[0, 4, 8, 12, 16, 20, 21]]
    assert np.allclose(motion.q, rows[:, 1:1 + disc.nq], rtol=0, atol=1e-9)
    assert np.allclose(motion.qd, rows[:, 1 + disc.nq:1 + disc.nq + disc.nv], rtol=0, atol=1e-9)
    assert np.abs(disc.constraints(motion.q, motion.qd).velocity).max() < 1e-9
    # Many, with a law of forces, which sees each as one does.
    law = lambda t, q, qd: -0.1 * qd
    q, qd = np.tile(disc.initial_coordinates, (3, 1)), np.outer([1, 0.5, 0], disc.initial_speeds)
    many = disc.simulate(q, qd, 0.1, 0.01, law, method="implicit")
    one = disc.simulate(q[1], qd[1], 0.1, 0.01, law, method="implicit")
    assert many.qd.shape == (11, 3, disc.nv) and np.array_equal(many.q[:, 1], one.q) and np.array_equal(many.qd[:, 1], one.qd)
    assert not np.allclose(one.qd, disc.simulate(q[1], qd[1], 0.1, 0.01, method="implicit").qd, atol=1e-6)


def test_steps_that_there_are_none_of_are_nan_with_a_warning(load):
    disc = load("paper/rolling_disc")
    q, qd = np.tile(disc.initial_coordinates, (2, 1)), np.tile(disc.initial_speeds, (2, 1))
    qd[1] *= 1e200
    with pytest.warns(RuntimeWarning, match=r"motion 1 of rolling_disc ends at t = 0 s: "):
        motion = disc.simulate(q, qd, 0.03, 0.01)
    assert np.all(np.isfinite(motion.q[:, 0])) and np.all(np.isfinite(motion.q[0])) and np.all(np.isnan(motion.q[1:, 1]))


def test_missing_functions_are_refused(load):
    m = load("free_body", ["energy"])
    with pytest.raises(ValueError, match="without forward_dynamics"):
        alembert.simulate(m, m.initial_coordinates, m.initial_speeds, 1, 0.1)


STATES = """alembert: 1
name: block
gravity: [0, 0, 0]
inputs: [{name: drive, initial: 1}]
coordinates: [x]
states:
  - {name: a, initial: 0.25, rate: (drive - a)/0.05}
  - {name: way, rate: d(x)}
bodies: [{name: block, transform: [{translate: [x, 0, 0]}], mass: 2}]
forces: [{name: motor, on: x, value: 4*a}]
"""


@pytest.mark.parametrize("method, step, near", [("rk4", 0.005, 1e-6), ("linearly-implicit", 1e-4, 5e-4)])
def test_states_are_integrated_too(tmp_path, method, step, near):
    file = tmp_path / "block.yaml"
    file.write_text(STATES)
    m = alembert.load(file)
    assert m.state_names == ("a", "way") and m.input_names == ("drive",)
    motion = alembert.simulate(m, [1.0], [0.0], 0.3, step, method=method)
    a = 1 - 0.75 * np.exp(-motion.t / 0.05)
    assert np.allclose(motion.states[:, 0], a, rtol=0, atol=near)
    assert np.allclose(motion.qd[:, 0], 2 * (motion.t - 0.75 * 0.05 * (1 - np.exp(-motion.t / 0.05))), rtol=0, atol=near)
    assert np.allclose(motion.states[:, 1], motion.q[:, 0] - 1, rtol=0, atol=1e-12)
    both = alembert.simulate(m, [1.0], [0.0], 0.3, step, method=method, states=[[0.25, 0], [2, 1]], drive=[1, 3])
    assert both.states.shape == (len(motion.t), 2, 2) and np.array_equal(both.states[:, 0], motion.states)
    assert np.allclose(both.states[:, 1, 0], 3 - np.exp(-motion.t / 0.05), rtol=0, atol=2 * near)
    with pytest.raises(ValueError, match="a is a state"):
        alembert.simulate(m, [1.0], [0.0], 0.3, step, a=2)
    with pytest.raises(ValueError, match=r"states: expected shape \(2,\)"):
        alembert.simulate(m, [1.0], [0.0], 0.3, step, states=[1.0])
    with pytest.raises(ValueError, match="give a dict by name"):
        alembert.simulate(m, [1.0], [0.0], 0.3, step, parameters=[1, 0, 0])
