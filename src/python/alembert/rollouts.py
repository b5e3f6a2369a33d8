"""Many motions of a mechanism at once: alembert.rollout.

The steps are those of alembert/rollout.hpp, compiled for the mechanism at the first call and kept beside what load() compiled:
Python is asked for policies, once for all motions.
"""
import ctypes
import dataclasses
import hashlib
import os
import pathlib
import platform
import shlex
import warnings
from concurrent.futures import ThreadPoolExecutor
from types import ModuleType
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import building

__all__ = ["Rollouts", "STATUSES", "rollout"]

#: What a status says, by its number.
STATUSES = ("ok", "a value is not finite", "the mass matrix is not positive definite", "the constraints contradict each other",
            "the iteration found no solution", "the closest state is too far away",
            "the equations of the implicit step are singular", "the mechanism was generated without a function that is needed")
METHODS = ("semi-implicit-euler", "rk4", "linearly-implicit", "implicit")
INSTRUCTIONS = ("best", "baseline", "avx2", "avx512")
CONTROLS = ("forces", "inputs")

#: Controls at a time and the states of all motions: (t, q, qd), or (t, q, qd, states), to what broadcasts to (N, nu).
Policy = Callable[..., ArrayLike]


class Rollouts(NamedTuple):
    """N motions at K moments; without N for a single one."""

    t: NDArray[Any]        #: (K,) s
    q: NDArray[Any]        #: (N, K, nq) coordinates, quaternions of norm 1
    qd: NDArray[Any]       #: (N, K, nv) speeds
    states: NDArray[Any]   #: (N, K, ns): those under `states` of the description
    steps: NDArray[Any]    #: (N,) steps made; at later moments the last state is repeated
    status: NDArray[Any]   #: (N,) 0, or why there was no further step: STATUSES[status]
    stopped: NDArray[Any]  #: (N,) whether `stop` or `within` ended the motion


class Source(NamedTuple):
    """What a mechanism is built from, wherever that is done."""

    name: str
    text: str
    options: Tuple[str, ...]  #: of `alembert generate`
    functions: Tuple[str, ...]
    batch: Tuple[str, ...]


class Call(ctypes.Structure):
    """alembert::RolloutCall."""

    POLICY = ctypes.CFUNCTYPE(None, ctypes.c_double, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p, ctypes.c_void_p,
                              ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p)
    _fields_ = (
        [(name, ctypes.c_int64) for name in ("count", "steps", "every", "hold", "parameters_step", "wrenches_step",
                                             "controls_step", "controls_next")]
        + [(name, ctypes.c_int32) for name in ("stepper", "kind", "threads", "instructions")]
        + [(name, ctypes.c_double) for name in ("h", "t")]
        + [(name, ctypes.c_void_p) for name in ("q", "qd", "parameters", "wrenches", "controls", "bounds", "out_q", "out_qd",
                                                "out_states", "out_steps", "out_status", "out_stopped")]
        + [("policy", POLICY)])


_FLAGS = ["-std=c++17", "-O2", "-fno-math-errno", "-fPIC", "-DALEMBERT_VECTOR_TRIG"]
_INSTRUCTION_FLAGS = {"avx2": ["-mavx2", "-mfma"], "avx512": ["-mavx512f", "-mavx512dq", "-mavx512vl", "-mavx2", "-mfma"]}
_LIBRARY = """#include <{name}/{name}.hpp>
{include}
#include <alembert/rollout_library.hpp>
namespace mechanism = ::alembert::mechanisms::{name};
extern "C" long long alembert_rollout(const ::alembert::RolloutCall* call);
extern "C" long long alembert_rollout(const ::alembert::RolloutCall* call) {{
  return static_cast<long long>(::alembert::rollout_by_call<mechanism::Mechanism<double>>(*call{packed}));
}}
"""


def _source(module: ModuleType, method: str) -> Source:
    description = getattr(module, "_alembert_description", None)
    if description is None:
        raise ValueError(f"{module.name}: rollouts are compiled from the description, which this module came without: take it "
                         "from alembert.load")
    if module.number != numpy.float64:
        raise ValueError(f"{module.name}: rollouts are of double, and this module is of {module.number}: load it as double")
    text, options = description
    functions = ["mass_matrix_and_bias", "coordinate_rates"]
    batch: List[str] = []
    if module.constraint_names:
        functions.append("constraints")
    else:
        batch.append("forward_dynamics")
        # With parameters the mass matrix may be indefinite: then it is factored, and that is seen.
        if not module.parameter_names:
            functions.append("forward_dynamics")
    if module.state_names:
        functions.append("state_rates")
        if batch:
            batch.append("state_rates")
    if method in ("linearly-implicit", "implicit"):
        functions.append("inverse_dynamics_derivatives")
        if module.state_names:
            functions.append("state_rates_derivatives")
    return Source(module.name, text, tuple(options), tuple(functions), tuple(batch))


def _headers() -> List[str]:
    """Options that find the runtime and Eigen."""
    here = pathlib.Path(__file__).resolve()
    folders = [os.environ.get("ALEMBERT_INCLUDE", "")] + [str(here.parents[2])] + [str(p / "include") for p in here.parents[3:6]]
    runtime = next((f for f in folders if f and os.path.exists(os.path.join(f, "alembert", "rollout.hpp"))), None)
    if runtime is None:
        raise building.Error("the headers of alembert's runtime are neither beside this package nor in ALEMBERT_INCLUDE: rollouts "
                             "are compiled with them (package libalembert-dev)")
    eigen = [f for f in (os.environ.get("EIGEN3_INCLUDE_DIR"), "/usr/include/eigen3", "/usr/local/include/eigen3",
                         "/opt/homebrew/include/eigen3") if f and os.path.exists(os.path.join(f, "Eigen", "Core"))]
    if not eigen:
        raise building.Error("Eigen is missing: install libeigen3-dev, or set EIGEN3_INCLUDE_DIR to the folder that holds Eigen/Core")
    return [f"-I{runtime}", f"-I{eigen[0]}"]


def _compile(folder: pathlib.Path, source: Source, compiler: List[str], headers: List[str]) -> None:
    description = folder / "description.yaml"
    description.write_text(source.text, encoding="utf-8")
    command = [building.executable(), "generate", str(description), "--out-dir", str(folder), "--scalars", "double",
               "--functions", ",".join(source.functions), *source.options]
    if source.batch:
        command += ["--batch", ",".join(source.batch)]
    building.run(command, "")
    name = source.name
    library = folder / "src" / "rollout.cpp"
    library.write_text(_LIBRARY.format(
        name=name, include=f"#include <{name}/{name}_batch.hpp>" if source.batch else "",
        packed="".join([", ::alembert::PackedDynamics(mechanism::forward_dynamics_batch",
                        ", mechanism::state_rates_batch" if "state_rates" in source.batch else "", ")"])
        if source.batch else ""))
    objects = []

    def compile_one(path: pathlib.Path) -> None:
        flags = [*_FLAGS, *building.flags_of("CXXFLAGS")]
        if "_batch" in path.stem:
            flags.append("-ffp-contract=off")
            instructions = path.stem.rsplit("_", 1)[1]
            if platform.machine() in ("x86_64", "AMD64"):
                flags += _INSTRUCTION_FLAGS.get(instructions, [])
        building.run([*compiler, *flags, *headers, f"-I{folder / 'include'}", "-c", str(path), "-o", str(path) + ".o"],
                     "Set CXX to a C++ compiler.")
        objects.append(str(path) + ".o")

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        list(pool.map(compile_one, sorted(set((folder / "src").glob("*.cpp")) - set((folder / "src").glob("*_c.cpp")))))
    building.run([*compiler, "-shared", *sorted(objects), "-pthread", "-lm", "-o", str(folder / "rollout.so")],
                 "Set CXX to a C++ compiler.")
    for path in objects:
        os.remove(path)


_engines: Dict[Tuple[Source, str], Any] = {}


def engine(source: Source, cache: Union[str, "os.PathLike[str]", None] = None) -> Any:
    """The function of C, compiled once a machine and looked for once a process."""
    place = (source, str(cache))
    if place not in _engines:
        compiler = shlex.split(os.environ.get("CXX") or "c++")
        headers = _headers()
        identity = [*building.identity(compiler, "Set CXX to a C++ compiler."), *_FLAGS, *building.flags_of("CXXFLAGS"),
                    building.folder_state(headers[0][2:]), *source]
        key = "rollout-" + hashlib.sha256(repr(identity).encode()).hexdigest()[:32]
        folder = building.once(building.store(cache), key, lambda work: _compile(work, source, compiler, headers))
        entry = ctypes.CDLL(str(folder / "rollout.so")).alembert_rollout
        entry.argtypes = [ctypes.POINTER(Call)]
        entry.restype = ctypes.c_longlong
        _engines[place] = entry
    return _engines[place]


@dataclasses.dataclass(frozen=True)
class Plan:
    """A rollout of N motions in arrays, ready for the library: what shards are cut from."""

    source: Source
    count: int
    sizes: Tuple[int, int, int]      # nq, nv, ns
    numbers: Dict[str, Any]          # steps, every, hold, stepper, kind, threads, instructions, h, t
    arrays: Dict[str, NDArray[Any]]  # q and qd of each; parameters, wrenches, controls of each or of all; bounds
    policy: Optional[Policy]
    stop: Optional[Policy]

    @property
    def rows(self) -> int:
        steps, every = self.numbers["steps"], self.numbers["every"]
        return 1 if every == 0 else steps // every + 1 + (steps % every != 0)

    def moments(self) -> NDArray[Any]:
        steps, every = self.numbers["steps"], self.numbers["every"]
        at = [steps] if every == 0 else [*range(0, steps, every), steps]
        return self.numbers["t"] + self.numbers["h"] * numpy.array(at, dtype=float)

    def part(self, first: int, last: int) -> "Plan":
        """Motions first ... last - 1."""
        cut = {name: array[first:last] if name in ("q", "qd") or (name != "bounds" and len(array) == self.count and self.count > 1)
               else array for name, array in self.arrays.items()}
        return dataclasses.replace(self, count=last - first, arrays=cut)


class SampledPlan:
    """The plan of a rollout whose starts a function draws, a shard at a time."""

    def __init__(self, draw: Callable[[int, int], Plan], count: int, size: int) -> None:
        self._draw, self.count, self._size = draw, count, size
        self._first = draw(0, min(count, size))  # what all shards share, and what tells the function from another

    def __getattr__(self, name: str) -> Any:
        return getattr(self._first, name)

    def part(self, first: int, last: int) -> Plan:
        return self._draw(first // self._size, last - first)


def _width(plan: Plan) -> int:
    return int(plan.arrays["controls"].shape[2])


def _callback(plan: Plan, refused: List[BaseException]) -> Any:
    """The policy and `stop` as the library calls them; what they raise ends all motions."""
    nq, nv, ns = plan.sizes
    nu, controls = _width(plan), plan.arrays["controls"]

    def view(address: int, shape: Sequence[int], kind: Any = ctypes.c_double) -> NDArray[Any]:
        if not numpy.prod(shape):
            return numpy.zeros(shape)
        return numpy.ctypeslib.as_array(ctypes.cast(address, ctypes.POINTER(kind)), tuple(shape))

    def call(t: float, step: int, count: int, q: int, qd: int, states: int, to: int, ended: int) -> None:
        mask = view(ended, (count,), ctypes.c_bool)
        try:
            given = [view(q, (count, nq)).copy(), view(qd, (count, nv)).copy()]
            if ns:
                given.append(view(states, (count, ns)).copy())
            if plan.stop is not None:
                found = numpy.asarray(plan.stop(t, *given))
                if found.dtype != bool or found.shape != (count,):
                    raise ValueError(f"stop: expected {count} truth values, found {found.dtype} of shape {found.shape}")
                mask |= found
            if plan.policy is None:
                view(to, (count, nu))[...] = controls[:, min(step // plan.numbers["hold"], controls.shape[1] - 1)]
                return
            answer = plan.policy(t, *given)
            if answer is None:
                raise TypeError("u: the policy returns nothing")
            chosen = numpy.asarray(answer, dtype=float)
            try:
                view(to, (count, nu))[...] = chosen
            except ValueError:
                raise ValueError(f"u: expected of the policy what broadcasts to {(count, nu)}, found {chosen.shape}") from None
        except BaseException as error:  # raised behind the library
            refused.append(error)
            mask[:] = True

    return Call.POLICY(call)


def run(plan: Plan, cache: Union[str, "os.PathLike[str]", None] = None) -> Dict[str, NDArray[Any]]:
    """Results by name, in this process."""
    nq, nv, ns = plan.sizes
    results: Dict[str, NDArray[Any]] = {
        "q": numpy.empty((plan.count, plan.rows, nq)), "qd": numpy.empty((plan.count, plan.rows, nv)),
        "states": numpy.empty((plan.count, plan.rows, ns)), "steps": numpy.empty(plan.count, numpy.int64),
        "status": numpy.empty(plan.count, numpy.int32), "stopped": numpy.empty(plan.count, bool)}
    arrays = {name: numpy.ascontiguousarray(array) for name, array in plan.arrays.items()}
    call = Call(count=plan.count, **plan.numbers)
    for name, array in {**arrays, **{"out_" + name: array for name, array in results.items()}}.items():
        setattr(call, name, array.ctypes.data if array.size else None)
    for name in ("parameters", "wrenches", "controls"):
        if name in arrays and len(arrays[name]) == plan.count and plan.count > 1:
            setattr(call, name + "_step", arrays[name][0].size)
    if arrays["controls"].shape[1] > 1:
        call.controls_next = _width(plan)
    refused: List[BaseException] = []
    if plan.policy is not None or plan.stop is not None:
        call.policy = _callback(plan, refused)
    if plan.count:
        engine(plan.source, cache)(ctypes.byref(call))
    if refused:
        raise refused[0]
    return results


def _whole(label: str, value: Any, least: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, numpy.integer)) or value < least:
        raise ValueError(f"{label}: expected a whole number, {least} or more, found {value!r}")
    return int(value)


def _number(label: str, value: Any) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = numpy.nan
    if not numpy.isfinite(number):
        raise ValueError(f"{label}: expected a finite number, found {value!r}")
    return number


def _one_of(label: str, value: Any, known: Sequence[str]) -> int:
    if value not in known:
        raise ValueError(f"{label}: expected one of {', '.join(map(repr, known))}; found {value!r}")
    return known.index(value)


def _controls(states: Any, value: Any, nu: int, moments: int) -> NDArray[Any]:
    """(1 or N, 1 or moments, nu)."""
    try:
        array = numpy.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(f"u: expected an array of numbers, or a function, found {type(value).__name__}") from None
    expected = f"u: expected shape ({nu},), (N, {nu}) or (N, {moments}, {nu}), found {array.shape}"
    if array.ndim not in (1, 2, 3) or array.shape[-1] != nu or (array.ndim == 3 and array.shape[1] != moments):
        raise ValueError(expected)
    if array.ndim == 1:
        return array[None, None]
    if array.ndim == 2 and states.count is None and len(array) == moments > 1:
        warnings.warn(f"u: {array.shape} is taken for {moments} motions, each with one control that is held; for one motion with "
                      f"{moments} controls give u[None]", stacklevel=4)
    if len(array) > 1 or states.count is None:
        array = states.take("u", array, array.shape[1:])
    return array[:, None] if array.ndim == 2 else array


def make_plan(module: ModuleType, q: ArrayLike, qd: Optional[ArrayLike], u: Union[ArrayLike, Policy, None], *, steps: int,
              step: float, t: float, method: str, controls: Optional[str], hold: int, every: int, stop: Optional[Policy],
              within: Optional[Mapping[str, Any]], states: Optional[ArrayLike], threads: int, instructions: str,
              inputs: Dict[str, Any]) -> Tuple[Plan, bool]:
    """The plan, and whether it is for one motion given without N."""
    numbers: Dict[str, Any] = {
        "steps": _whole("steps", steps, 0), "every": _whole("every", every, 0), "hold": _whole("hold", hold, 1),
        "threads": _whole("threads", threads, 0), "stepper": _one_of("method", method, METHODS),
        "instructions": _one_of("instructions", instructions, INSTRUCTIONS)}
    numbers.update(h=_number("step", step), t=_number("t", t))
    ni, ns = len(module.input_names), len(module.state_names)
    if controls is None:
        controls = "inputs" if ni else "forces"
    numbers["kind"] = _one_of("controls", controls, CONTROLS)
    if controls == "inputs" and not ni:
        raise ValueError(f"controls: {module.name} has no inputs: its controls are forces")
    source = _source(module, method)
    nu = ni if controls == "inputs" else module.nv

    many = module._States()
    arrays = {"q": many.take("q", q, (module.nq,)),
              "qd": many.take("qd", module.initial_speeds if qd is None else qd, (module.nv,))}
    keywords = dict(inputs)
    given = keywords.pop("parameters", None)
    wrenches = keywords.pop("wrenches", None)
    for name in keywords:
        if name not in module.parameter_names:
            raise module._unknown("rollout", name, module.parameter_names)
    parameters = module._parameters(many, given, keywords)
    first_state = len(module.parameter_names) - ns
    if states is not None:
        rest = many.take("states", states, (ns,))
        joined = numpy.empty(rest.shape[:-1] + (len(module.parameter_names),) if rest.ndim > parameters.ndim else parameters.shape)
        joined[...] = parameters
        joined[..., first_state:] = rest
        parameters = joined
    forces = module._wrenches(many, wrenches)
    moments = max(1, -(-numbers["steps"] // numbers["hold"]))
    policy = u if callable(u) else None
    usual = parameters[..., first_state - ni:first_state] if controls == "inputs" else numpy.zeros(nu)
    control = _controls(many, usual if policy is not None or u is None else u, nu, moments)
    one, count = many.count is None, 1 if many.count is None else many.count

    def rows(array: NDArray[Any], single: int) -> NDArray[Any]:
        return array[None] if array.ndim == single else array

    for name, size in (("q", module.nq), ("qd", module.nv)):
        arrays[name] = numpy.broadcast_to(rows(arrays[name], 1), (count, size))
    arrays.update(parameters=rows(parameters, 1), wrenches=rows(forces, 2).reshape(-1, 6 * len(module.wrench_body_names))
                  if module.wrench_body_names else numpy.zeros((1, 0)), controls=control)
    if within is not None:
        bounds = []
        for name in within:
            if name not in ("q", "qd"):
                raise module._unknown("within", name, ("q", "qd"))
        for name, size in (("q", module.nq), ("qd", module.nv)):
            try:
                low, high = within.get(name, (-numpy.inf, numpy.inf))
                pair = [numpy.broadcast_to(numpy.asarray(b, dtype=float), (size,)) for b in (low, high)]
            except (TypeError, ValueError):
                raise ValueError(f"within[{name!r}]: expected a pair of bounds, each a number or of shape ({size},)") from None
            if not (pair[0] <= pair[1]).all():
                raise ValueError(f"within[{name!r}]: expected the least before the largest, found {low!r} and {high!r}")
            bounds += pair
        arrays["bounds"] = numpy.concatenate(bounds)
    return Plan(source, count, (module.nq, module.nv, ns), numbers, arrays, policy, stop), one


#: Draws n starts: (rng, n) to a dict of q and what else rollout() takes for each motion.
Start = Callable[[numpy.random.Generator, int], Mapping[str, Any]]


def _sampled(module: ModuleType, start: Start, count: Optional[int], seed: int, size: int, given: Dict[str, Any]) -> SampledPlan:
    if count is None:
        raise ValueError("count: expected how many motions q is to draw starts for")

    def draw(index: int, n: int) -> Plan:
        drawn = dict(start(numpy.random.default_rng([seed, index]), n))
        if "q" not in drawn:
            raise ValueError("q: expected of the function a dict with q among its entries")
        both: Dict[str, Any] = {**given, "inputs": dict(given["inputs"])}
        for name, value in drawn.items():
            place = both if name in ("q", "qd", "u", "states") else both["inputs"]
            if place.get(name) is not None:
                raise ValueError(f"{name}: given, and drawn by q too")
            place[name] = value
        plan, one = make_plan(module, both.pop("q"), both.pop("qd"), both.pop("u"), **both)
        if one or plan.count != n:
            raise ValueError(f"q: expected of the function {n} starts, found {1 if one else plan.count}")
        return plan

    return SampledPlan(draw, _whole("count", count, 1), size)


def rollout(module: ModuleType, q: Union[ArrayLike, Start], qd: Optional[ArrayLike] = None, u: Union[ArrayLike, Policy, None] = None, *,
            steps: int, step: float, t: float = 0.0, method: str = "semi-implicit-euler", controls: Optional[str] = None,
            hold: int = 1, every: int = 0, stop: Optional[Policy] = None, within: Optional[Mapping[str, Any]] = None,
            states: Optional[ArrayLike] = None, threads: int = 0, instructions: str = "best", client: Any = None,
            shard: Optional[int] = None, out: Union[str, "os.PathLike[str]", None] = None, count: Optional[int] = None, seed: int = 0,
            **inputs: Any) -> Any:
    """N motions of `steps` steps at once. Each depends on what is given for it alone: not on N, its place, threads or shards.

    module    of alembert.load
    q, qd     (nq,) and (nv,) for one motion, (N, nq) and (N, nv) for N, as for everything below; speeds are the
              description's unless given. Under constraints the motion begins at the nearest state that keeps them
              q may be a function of (rng, n) to a dict of q and of other arguments for n motions: it draws the starts of a shard
              from numpy.random.default_rng([seed, index of the shard]), `count` in all
    u         controls: (nu,), (N, nu), which are held; (N, K, nu) with one for each `hold` steps; or a policy, a function of
              (t, q, qd), and of the states if there are any, called every `hold` steps for all motions at once (with a client:
              of a shard), whose result broadcasts to (N, nu). Over a step they are held
    controls  "inputs" of the description, nu of which there are, or "forces", nu = nv; inputs if there are any
    steps, step, t   number and length (s) of the steps, and time of the start
    method    "semi-implicit-euler"; "rk4"; "linearly-implicit" or "implicit", of order 1, for stiff forces of the description
    every     steps between the moments that are kept, with first and last; 0: the end alone
    stop      function like a policy, asked before it, for (N,) truth values: True ends the motion
    within    {"q": (least, largest), "qd": ...}: a motion that leaves these after a step is stopped
    states    (ns,) or (N, ns): what the states of the description begin with
    threads   0: one a core
    instructions     "best", "baseline", "avx2", "avx512" of packs; results differ between them by rounding
    client    a dask.distributed.Client: its workers do shards of `shard` motions; so they do without a client if `out` is given
    out       folder for the shards (alembert.open_rollouts); what of the same rollout is there already is not done again
    inputs    parameters, wrenches and runtime parameters by name, as the module's functions take them

    Returns Rollouts, or the opened folder if `out` is given. A motion that ended early repeats its last state; no row holds a
    NaN unless the start does. Errors: ValueError that names the argument; what a policy raises.

    >>> end = alembert.rollout(arm, np.tile(arm.initial_coordinates, (1000, 1)), u=lambda t, q, qd: -qd, steps=500, step=1e-3)
    >>> end.q[:, -1], end.status
    """
    if client is not None and not callable(getattr(client, "submit", None)):
        raise ValueError(f"client: expected a dask.distributed.Client, found {client!r}")
    if client is not None and threads == 0:
        threads = 1  # a worker does as many shards at once as it has threads
    size = 1024 if shard is None else _whole("shard", shard, 1)
    given: Dict[str, Any] = dict(qd=qd, u=u, steps=steps, step=step, t=t, method=method, controls=controls, hold=hold, every=every,
                                 stop=stop, within=within, states=states, threads=threads, instructions=instructions, inputs=inputs)
    cache = getattr(module, "_alembert_cache", None)
    one = False
    plan: Union[Plan, SampledPlan]
    if callable(q):
        plan = _sampled(module, q, count, _whole("seed", seed, 0), size, given)
    else:
        if count is not None:
            raise ValueError("count: q says how many motions there are, unless it is a function")
        plan, one = make_plan(module, q, given.pop("qd"), given.pop("u"), **given)
    if isinstance(plan, Plan) and client is None and out is None:
        if shard is not None:
            raise ValueError("shard: nothing is cut without a client, `out` or starts that are drawn")
        found = run(plan, cache)
    else:
        from . import shards

        found = shards.run_all(plan, size, client, out, cache)
        if out is not None:
            return found
    if one:
        found = {name: array[0] for name, array in found.items()}
    return Rollouts(plan.moments(), **found)
