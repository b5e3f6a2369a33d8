"""alembert.torch: gradients by torch.autograd.gradcheck."""
import numpy as np
import pytest

torch = pytest.importorskip("torch", reason="PyTorch is missing (python3-torch): gradients are NOT tested")
import alembert.torch as dynamics  # noqa: E402


def state(m, *batch, seed=3):
    rng = torch.Generator().manual_seed(seed)
    tensors = [torch.randn(*batch, size, generator=rng, dtype=torch.float64) for size in (m.nq, m.nv, m.nv)]
    for tensor in tensors:
        tensor.requires_grad_(True)
    return tensors


def on_the_sphere(m, q):
    """Quaternions normalised: what is differentiated must stay among the rotations."""
    parts, at = [], 0
    for first in m.quaternion_offsets:
        p = q[..., first:first + 4]
        parts += [q[..., at:first], p / p.norm(dim=-1, keepdim=True)]
        at = first + 4
    return torch.cat([*parts, q[..., at:]], dim=-1)


@pytest.mark.parametrize("name", ["puma560", "free_body", "tree_every_joint"])
@pytest.mark.parametrize("function", ["inverse_dynamics", "forward_dynamics"])
def test_gradients(load, name, function):
    m = load(name)
    call = getattr(dynamics, function)
    inputs = {"t": 0.3}
    if m.wrench_body_names:
        inputs["wrenches"] = np.linspace(-1, 1, 6 * len(m.wrench_body_names)).reshape(-1, 6)
    assert torch.autograd.gradcheck(lambda q, qd, x: call(m, on_the_sphere(m, q), qd, x, **inputs), state(m, 2),
                                    eps=1e-6, atol=1e-5, rtol=1e-5)


def test_values_and_shapes(load):
    m = load("puma560")
    q, qd, qdd = state(m, 2, 3)
    tau = dynamics.inverse_dynamics(m, q, qd, qdd[0, 0])
    assert tau.shape == (2, 3, 6)
    expected = m.inverse_dynamics(q[1, 2].detach().numpy(), qd[1, 2].detach().numpy(), qdd[0, 0].detach().numpy())
    assert np.array_equal(tau[1, 2].detach().numpy(), expected)
    back = dynamics.forward_dynamics(m, q, qd, tau)
    assert torch.allclose(back, qdd[0, 0].expand(2, 3, 6), rtol=1e-8, atol=1e-8)
    tau.sum().backward()
    assert qdd.grad[0, 0].abs().sum() > 0 and qdd.grad[1].abs().sum() == 0
    assert dynamics.inverse_dynamics(m, q[0, 0], qd[0, 0], qdd[0, 0]).shape == (6,)


def test_errors(load):
    m = load("puma560")
    q, qd, qdd = state(m, 2)
    with pytest.raises(TypeError, match="q: expected a tensor of torch.float64 on the CPU, found torch.float32"):
        dynamics.inverse_dynamics(m, q.float(), qd, qdd)
    with pytest.raises(TypeError, match="qd: .*found ndarray"):
        dynamics.inverse_dynamics(m, q, np.zeros(6), qdd)
    with pytest.raises(ValueError, match=r"qdd: expected shape \(..., 6\), found \(2, 5\)"):
        dynamics.inverse_dynamics(m, q, qd, qdd[:, :5])
    with pytest.raises(ValueError, match="the shapes do not go together"):
        dynamics.inverse_dynamics(m, q, qd, qdd.expand(3, 2, 6)[:, 0])
    with pytest.raises(ValueError, match="t: there are no gradients"):
        dynamics.inverse_dynamics(m, q, qd, qdd, t=torch.zeros((), requires_grad=True))
    few = load("puma560", ["inverse_dynamics", "mass_matrix"], scalar="float")
    with pytest.raises(ValueError, match="written without inverse_dynamics_derivatives"):
        dynamics.inverse_dynamics(few, q, qd, qdd)
