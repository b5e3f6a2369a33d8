"""Dynamics as functions of PyTorch with exact gradients, from inverse_dynamics_derivatives and mass_matrix.

    arm = alembert.load("arm.yaml")
    tau = alembert.torch.inverse_dynamics(arm, q, qd, qdd)      # tensors (..., nq) and (..., nv) of float64, on the CPU

Gradients are by q, qd and qdd or tau; t, parameters and wrenches are constants. A quaternion has four numbers and turns in three
directions: its gradient lies along these (pseudo-inverse of N in dq/dt = N qd) and has no part along the quaternion itself, as
if the function normalised it. Give unit quaternions.
"""
from types import ModuleType
from typing import Any

import numpy
import torch
from torch.autograd.function import once_differentiable

__all__ = ["inverse_dynamics", "forward_dynamics"]


def _along_coordinates(module: ModuleType, q: Any, by_speeds: Any) -> Any:
    """A gradient along the speeds as one by the coordinates."""
    gradient = module.coordinate_rates(q, by_speeds)
    for first in module.quaternion_offsets:
        p = q[:, first:first + 4]
        gradient[:, first:first + 4] *= 4 / numpy.sum(p * p, axis=1, keepdims=True)
    return gradient


def _derivatives(module: ModuleType, inputs: Any, q: Any, qd: Any, qdd: Any, force: Any) -> Any:
    """force^T times the derivatives of inverse dynamics by coordinates and speeds."""
    tau_q, tau_qd = module.inverse_dynamics_derivatives(q, qd, qdd, **inputs)
    along, by_speeds = (numpy.matmul(force[:, None, :], matrix)[:, 0] for matrix in (tau_q, tau_qd))
    return _along_coordinates(module, q, along), by_speeds


class _InverseDynamics(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, module: ModuleType, inputs: Any, q: Any, qd: Any, qdd: Any) -> Any:  # type: ignore[override]
        ctx.module, ctx.inputs = module, inputs
        ctx.save_for_backward(q, qd, qdd)
        return torch.from_numpy(module.inverse_dynamics(q.numpy(), qd.numpy(), qdd.numpy(), **inputs))

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Any) -> Any:  # type: ignore[override]
        q, qd, qdd = (tensor.numpy() for tensor in ctx.saved_tensors)
        force = gradient.contiguous().numpy()
        by_q, by_qd = _derivatives(ctx.module, ctx.inputs, q, qd, qdd, force)
        by_qdd = numpy.matmul(force[:, None, :], ctx.module.mass_matrix(q, **ctx.inputs))[:, 0]
        return (None, None, *map(torch.from_numpy, (by_q, by_qd, by_qdd)))


class _ForwardDynamics(torch.autograd.Function):
    @staticmethod
    def forward(ctx: Any, module: ModuleType, inputs: Any, q: Any, qd: Any, tau: Any) -> Any:  # type: ignore[override]
        qdd = torch.from_numpy(module.forward_dynamics(q.numpy(), qd.numpy(), tau.numpy(), **inputs))
        ctx.module, ctx.inputs = module, inputs
        ctx.save_for_backward(q, qd, qdd)
        return qdd

    @staticmethod
    @once_differentiable
    def backward(ctx: Any, gradient: Any) -> Any:  # type: ignore[override]
        q, qd, qdd = (tensor.numpy() for tensor in ctx.saved_tensors)
        M = ctx.module.mass_matrix(q, **ctx.inputs)
        force = numpy.linalg.solve(M, gradient.numpy()[:, :, None])[:, :, 0]
        by_q, by_qd = _derivatives(ctx.module, ctx.inputs, q, qd, qdd, force)
        return (None, None, *map(torch.from_numpy, (-by_q, -by_qd, force)))


def _apply(function: Any, module: ModuleType, needed: Any, arguments: Any, inputs: Any) -> Any:
    for name in needed:
        if not hasattr(module, name):
            raise ValueError(f"{module.name} was written without {name}, which gradients need")
    for label, value in inputs.items():
        for part in value.values() if hasattr(value, "values") and not torch.is_tensor(value) else [value]:
            if torch.is_tensor(part) and part.requires_grad:
                raise ValueError(f"{label}: there are no gradients by it; give it detached")
    kind = torch.float32 if module.number == numpy.float32 else torch.float64
    for label, tensor, size in arguments:
        if not torch.is_tensor(tensor) or tensor.dtype != kind or tensor.device.type != "cpu":
            found = f"{tensor.dtype} on {tensor.device}" if torch.is_tensor(tensor) else type(tensor).__name__
            raise TypeError(f"{label}: expected a tensor of {kind} on the CPU, found {found}")
        if tensor.ndim == 0 or tensor.shape[-1] != size:
            raise ValueError(f"{label}: expected shape (..., {size}), found {tuple(tensor.shape)}")
    try:
        batch = torch.broadcast_shapes(*(tensor.shape[:-1] for _, tensor, _ in arguments))
    except RuntimeError:
        shapes = ", ".join(f"{label} {tuple(tensor.shape)}" for label, tensor, _ in arguments)
        raise ValueError(f"the shapes do not go together: {shapes}") from None
    flat = [tensor.expand(*batch, size).reshape(-1, size) for _, tensor, size in arguments]
    return function.apply(module, inputs, *flat).reshape(*batch, module.nv)


def inverse_dynamics(module: ModuleType, q: Any, qd: Any, qdd: Any, **inputs: Any) -> Any:
    """tau = M(q) qdd + c(q, qd), with gradients by q, qd and qdd. `inputs` as the module's function takes them."""
    return _apply(_InverseDynamics, module, ["inverse_dynamics_derivatives", "mass_matrix", "coordinate_rates"],
                  [("q", q, module.nq), ("qd", qd, module.nv), ("qdd", qdd, module.nv)], inputs)


def forward_dynamics(module: ModuleType, q: Any, qd: Any, tau: Any, **inputs: Any) -> Any:
    """qdd = M(q)^-1 (tau - c(q, qd)), constraints left out, with gradients by q, qd and tau."""
    return _apply(_ForwardDynamics, module,
                  ["forward_dynamics", "inverse_dynamics_derivatives", "mass_matrix", "coordinate_rates"],
                  [("q", q, module.nq), ("qd", qd, module.nv), ("tau", tau, module.nv)], inputs)
