"""The motion of a loaded mechanism in time, of one state or of many at once: alembert.simulate."""
import math
import warnings
from types import ModuleType
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from .rollouts import STATUSES, rollout

__all__ = ["Motion", "simulate"]

#: Generalized forces at a time and a state: (t, q, qd) to what broadcasts to qd.
Force = Callable[[float, NDArray[Any], NDArray[Any]], ArrayLike]


class Motion(NamedTuple):
    """K moments of a motion: of one state, or of N."""

    t: NDArray[Any]   #: (K,) s
    q: NDArray[Any]   #: (K, nq) or (K, N, nq) coordinates, quaternions of norm 1
    qd: NDArray[Any]  #: (K, nv) or (K, N, nv) speeds
    states: NDArray[Any]  #: (K, ns) or (K, N, ns): those under `states` of the description


def _start(module: ModuleType, label: str, value: ArrayLike, size: int) -> NDArray[Any]:
    array = numpy.array(value, dtype=module.number)
    if array.ndim not in (1, 2) or array.shape[-1] != size:
        raise ValueError(f"{label}: expected shape ({size},) or (N, {size}), found {array.shape}")
    return array


def _needed(module: ModuleType, method: str) -> None:
    missing = [] if hasattr(module, "forward_dynamics") or hasattr(module, "mass_matrix_and_bias") else ["forward_dynamics"]
    if module.quaternion_offsets and not hasattr(module, "coordinate_rates"):
        missing.append("coordinate_rates")
    if method == "linearly-implicit":
        missing = [name for name in ("mass_matrix_and_bias", "inverse_dynamics_derivatives") if not hasattr(module, name)] + [
            name for name in missing if name != "forward_dynamics"]
    if module.state_names and not hasattr(module, "state_rates"):
        missing.append("state_rates")
    if module.state_names and method == "linearly-implicit" and not hasattr(module, "state_rates_derivatives"):
        missing.append("state_rates_derivatives")
    if missing:
        raise ValueError(f"{module.name} was written without {' and '.join(missing)}, which motions need")


def _unit(module: ModuleType, q: NDArray[Any]) -> NDArray[Any]:
    """The same coordinates with quaternions of norm 1."""
    if module.quaternion_offsets:
        q = q.copy()
        for first in module.quaternion_offsets:
            part = q[..., first:first + 4]
            with numpy.errstate(all="ignore"):
                part /= numpy.sqrt(numpy.sum(part * part, axis=-1, keepdims=True))
    return q


def _accelerations(module: ModuleType, t: float, q: NDArray[Any], qd: NDArray[Any], tau: NDArray[Any],
                   inputs: Dict[str, Any]) -> NDArray[Any]:
    if hasattr(module, "forward_dynamics"):
        return module.forward_dynamics(q, qd, tau, t, **inputs)
    M, c = module.mass_matrix_and_bias(q, qd, t, **inputs)
    return _solve(M, tau - c)


def _solve(A: NDArray[Any], b: NDArray[Any]) -> Any:
    return numpy.linalg.solve(A, b[..., None])[..., 0]


def _implicit_change(module: ModuleType, t: float, h: Any, q: NDArray[Any], qd: NDArray[Any], tau: NDArray[Any],
                     inputs: Dict[str, Any]) -> NDArray[Any]:
    """The change of the speeds in a step of the linearly implicit Euler method that ends at t (alembert/implicit_step.hpp)."""
    M, c = module.mass_matrix_and_bias(q, qd, t, **inputs)
    K, C = module.inverse_dynamics_derivatives(q, qd, _solve(M, tau - c), t, **inputs)
    with numpy.errstate(all="ignore"):
        return _solve(M + h * C + h * h * K, h * (tau - c - h * (K @ qd[..., None])[..., 0]))


def _change_of_states(module: ModuleType, t: float, h: Any, q: NDArray[Any], qd: NDArray[Any], inputs: Dict[str, Any]) -> Any:
    """The change of the states in a linearly implicit step that ends at t."""
    rates = module.state_rates(q, qd, t, **inputs)
    by_states = module.state_rates_derivatives(q, qd, t, **inputs)[2]
    with numpy.errstate(all="ignore"):
        return _solve(numpy.eye(rates.shape[-1], dtype=rates.dtype) - h * by_states, h * rates)


def _times(start: float, until: float, step: float) -> NDArray[Any]:
    """Ends of the steps: whole ones, and a shorter one last where the time is no multiple of the step."""
    for label, value in (("t", start), ("until", until), ("step", step)):
        if not math.isfinite(value):
            raise ValueError(f"{label}: expected a finite number, found {value}")
    if not step > 0:
        raise ValueError(f"step: expected more than 0, found {step}")
    if until < start:
        raise ValueError(f"until: expected no less than t, which is {start}, found {until}")
    # What rounding leaves of a last step is none.
    count = math.ceil((until - start) / step * (1 - 1e-12))
    return numpy.append(start + step * numpy.arange(count), until)


def _forces(module: ModuleType, value: ArrayLike, speeds: NDArray[Any]) -> NDArray[Any]:
    array = numpy.asarray(value, dtype=module.number)
    try:
        return numpy.broadcast_to(array, speeds.shape)
    except ValueError:
        raise ValueError(f"tau: expected what broadcasts to {speeds.shape}, found {array.shape}") from None


def _by_compiled_steps(module: ModuleType, times: NDArray[Any], kept: List[int], start: Tuple[NDArray[Any], ...], step: float,
                       tau: Union[ArrayLike, Force, None], method: str, inputs: Dict[str, Any]) -> Motion:
    """A motion by the steppers of alembert.rollout, which keep constraints. NaN, with a warning, after the last step that there is."""
    one = start[0].ndim == 1
    now = [array[None] if one else array for array in start]

    def force(t: float, q: NDArray[Any], qd: NDArray[Any], *_: Any) -> Any:
        return _forces(module, tau(t, q[0], qd[0]) if one else tau(t, q, qd), qd[0] if one else qd)  # type: ignore[operator]

    u = force if callable(tau) else _forces(module, 0.0 if tau is None else tau, now[1])
    count = len(times) - 1
    whole = count - 1 if count > 0 and abs(times[-1] - times[-2] - step) > 1e-9 * step else count
    rows: List[List[NDArray[Any]]] = [[] for _ in now]  # moments of all motions, one after the other
    steps, status = numpy.zeros(len(now[0]), int), numpy.zeros(len(now[0]), int)
    for first, last in ((0, whole), (whole, count)):
        if first == last:
            continue
        length = step if first == 0 and whole > 0 else float(times[last] - times[first])
        done = rollout(module, now[0], now[1], u, controls="forces", steps=last - first, step=length, t=float(times[first]),
                       method=method, every=1, states=now[2] if module.state_names else None, **inputs)
        for row, array in zip(rows, (done.q, done.qd, done.states)):
            row.append(array[:, 1 if row else 0:])
        now = [array[:, -1] for array in (done.q, done.qd, done.states)]
        steps, status = numpy.where(status == 0, steps + done.steps, steps), numpy.where(status == 0, done.status, status)
    for i in numpy.flatnonzero(status):
        which = "" if one else f" {i}"
        warnings.warn(f"motion{which} of {module.name} ends at t = {times[steps[i]]:.9g} s: {STATUSES[status[i]]}", RuntimeWarning,
                      stacklevel=3)
    found = []
    for row, begin in zip(rows, now):
        array = numpy.concatenate(row, axis=1) if row else begin[:, None]
        for i in numpy.flatnonzero(status):
            array[i, steps[i] + 1:] = numpy.nan
        found.append(array[0, kept] if one else array[:, kept].transpose(1, 0, 2))
    return Motion(times[kept], *found)


def simulate(module: ModuleType, q: ArrayLike, qd: ArrayLike, until: float, step: float,
             tau: Union[ArrayLike, Force, None] = None, *, t: float = 0.0, every: int = 1, method: str = "rk4",
             states: Optional[ArrayLike] = None, **inputs: Any) -> Motion:
    """The motion from a state, with fixed steps: by the classical Runge-Kutta method of order 4, or one for stiff forces.

    module  of alembert.load or `alembert generate --language python`, with forward_dynamics or mass_matrix_and_bias and, if it has
            quaternions, coordinate_rates
    q, qd   (nq,) and (nv,) for one state; (N, nq) and (N, nv) for N, which move at once; one of the two may be for all N.
            Quaternions are normalised here and after each step
    until   time of the end, s; if no multiple of `step` leads there, the last step is shorter
    step    time step, s
    tau     generalized forces: nothing; an array that broadcasts to qd, which is held; or a function of (t, q, qd), called four
            times a step, whose q has unit quaternions
    t       time of the beginning, s
    method  "rk4"; or, of order 1 and L-stable, for hard springs, strong dampers and contacts of the description at long steps:
            "linearly-implicit", which needs mass_matrix_and_bias and inverse_dynamics_derivatives, or "implicit". They damp,
            take `tau` once a step and hold it
    states  (ns,) or (N, ns): what the states of the description, state_names, begin with; their initial values unless given
    every   how many steps lie between moments that are kept; the first and the last one are kept in any case
    inputs  parameters, wrenches, threads and runtime parameters by name, as the module's functions take them

    Under constraints, and with "implicit", steps are those of alembert.rollout: of a module of alembert.load, compiled by a C++
    compiler, with `tau` held over each; the motion begins at the nearest state that keeps the constraints.

    Returns Motion(t, q, qd, states). A state that leaves the finite numbers stays out there, without an error; what compiled steps
    cannot go on with is NaN from there on, with a RuntimeWarning.

    >>> arm = alembert.load("arm.yaml")
    >>> motion = alembert.simulate(arm, arm.initial_coordinates, arm.initial_speeds, 2, 1e-3, lambda t, q, qd: -qd)
    >>> motion.q[-1]
    """
    if method not in ("rk4", "linearly-implicit", "implicit"):
        raise ValueError(f"method: expected 'rk4', 'linearly-implicit' or 'implicit', found {method!r}")
    compiled = bool(module.constraint_names) or method == "implicit"
    if not compiled:
        _needed(module, method)
    if isinstance(every, bool) or not isinstance(every, (int, numpy.integer)) or every < 1:
        raise ValueError(f"every: expected a whole number above 0, found {every!r}")
    times = _times(float(t), float(until), float(step))
    now = _start(module, "q", q, module.nq)
    speeds = _start(module, "qd", qd, module.nv)
    for first in module.quaternion_offsets:
        if not numpy.all(numpy.any(now[..., first:first + 4] != 0, axis=-1)):
            raise ValueError(f"q: the quaternion that begins at {first} is zero")
    if now.ndim == 2 and speeds.ndim == 2 and len(now) != len(speeds):
        raise ValueError(f"qd: expected {len(now)} states as in q, found {len(speeds)}")
    if module.state_names and inputs.get("parameters") is not None and not isinstance(inputs["parameters"], Mapping):
        raise ValueError(f"parameters: {module.name} has states, which stand among them: give a dict by name, or keywords")
    for label in module.state_names:
        if label in inputs or label in (inputs.get("parameters") or ()):
            raise ValueError(f"{label} is a state: give what it begins with by states")
    rest = _start(module, "states", module.default_parameters[len(module.parameter_names) - len(module.state_names):]
                  if states is None else states, len(module.state_names))
    arrays = {"q": now, "qd": speeds, "states": rest}
    sizes = {len(array) for array in arrays.values() if array.ndim == 2}
    if len(sizes) > 1:
        raise ValueError(f"states: expected {len(now if now.ndim == 2 else speeds)} as of q and qd, found {len(rest)}")
    shape = tuple(sizes)
    now = numpy.broadcast_to(now, shape + (module.nq,)).copy()
    speeds = numpy.broadcast_to(speeds, shape + (module.nv,)).copy()
    rest = numpy.broadcast_to(rest, shape + (len(module.state_names),)).copy()
    kept = [k for k in range(len(times)) if k % every == 0 or k == len(times) - 1]
    now = _unit(module, now)
    if compiled:
        return _by_compiled_steps(module, times, kept, (now, speeds, rest), float(step), tau, method, inputs)
    held: Optional[NDArray[Any]] = None
    if not callable(tau):
        held = _forces(module, 0.0 if tau is None else tau, speeds)

    def force(moment: float, unit: NDArray[Any], u: NDArray[Any]) -> NDArray[Any]:
        return held if held is not None else _forces(module, tau(moment, unit, u), speeds)  # type: ignore[operator]

    def for_all(found: NDArray[Any], u: NDArray[Any]) -> NDArray[Any]:
        if found.shape != u.shape:
            raise ValueError(f"inputs are for {len(found)} states, q and qd for one: give q as (N, {module.nq})")
        return found

    def qdot(at: NDArray[Any], u: NDArray[Any]) -> NDArray[Any]:
        return module.coordinate_rates(at, u) if module.quaternion_offsets else u

    def with_states(s: NDArray[Any]) -> Dict[str, Any]:
        return {**inputs, **{name: s[..., i] for i, name in enumerate(module.state_names)}}

    def rates(moment: float, at: NDArray[Any], u: NDArray[Any], s: NDArray[Any]) -> Any:
        # Accelerations are those of unit quaternions, rates those of q as it is: both are smooth, and the order stays.
        unit, given = _unit(module, at), with_states(s)
        sdot = module.state_rates(unit, u, moment, **given) if module.state_names else s
        return qdot(at, u), for_all(_accelerations(module, moment, unit, u, force(moment, unit, u), given), u), sdot

    motion = Motion(times[kept], numpy.empty((len(kept),) + now.shape, now.dtype),
                    numpy.empty((len(kept),) + speeds.shape, speeds.dtype),
                    numpy.empty((len(kept),) + rest.shape, rest.dtype))
    place = 0
    for k, moment in enumerate(times):
        if k == kept[place]:
            motion.q[place], motion.qd[place], motion.states[place] = now, speeds, rest
            place += 1
        if k + 1 == len(times):
            break
        h = times[k + 1] - moment
        number = now.dtype.type
        if method == "linearly-implicit":
            end = float(times[k + 1])
            change = _implicit_change(module, end, number(h), now, speeds, force(float(moment), now, speeds), with_states(rest))
            with numpy.errstate(all="ignore"):
                speeds = speeds + for_all(change, speeds)
                now = _unit(module, now + number(h) * qdot(now, speeds))
            if module.state_names:
                rest = rest + _change_of_states(module, end, number(h), now, speeds, with_states(rest))
            continue
        q_sum, u_sum, s_sum = now, speeds, rest
        q_rate, u_rate, s_rate = numpy.zeros_like(now), numpy.zeros_like(speeds), numpy.zeros_like(rest)
        for share, weight in ((0.0, 1 / 6), (0.5, 1 / 3), (0.5, 1 / 3), (1.0, 1 / 6)):
            offset = number(share * h)
            with numpy.errstate(all="ignore"):
                at, u, s = now + offset * q_rate, speeds + offset * u_rate, rest + offset * s_rate
            q_rate, u_rate, s_rate = rates(float(moment + share * h), at, u, s)
            with numpy.errstate(all="ignore"):
                part = number(weight * h)
                q_sum, u_sum, s_sum = q_sum + part * q_rate, u_sum + part * u_rate, s_sum + part * s_rate
        now, speeds, rest = _unit(module, q_sum), u_sum, s_sum
    return motion
