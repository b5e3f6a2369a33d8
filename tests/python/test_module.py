"""The written module: numbers against `alembert evaluate`, and what becomes of arguments of all kinds."""
import ast
import inspect
import json
import os
import pathlib
import subprocess
import sys
import threading

import alembert
import numpy as np
import pytest
from conftest import CATALOGUE, ROOT


def random_states(m, count, seed=1):
    rng = np.random.default_rng(seed)
    s = {"q": rng.uniform(-1, 1, (count, m.nq)) + m.initial_coordinates, "t": rng.uniform(0, 2, count)}
    for first in m.quaternion_offsets:
        s["q"][:, first:first + 4] /= np.linalg.norm(s["q"][:, first:first + 4], axis=1, keepdims=True)
    if m.name == "four_bar_knee":
        s["q"][:, 1] = rng.uniform(0.9, 2.0, count)
    for name in ("qd", "qdd", "tau", "mu"):
        s[name] = rng.normal(size=(count, m.nv))
    s["parameters"] = m.default_parameters * rng.uniform(0.7, 1.4, (count, len(m.parameter_names)))
    s["wrenches"] = rng.normal(size=(count, len(m.wrench_body_names), 6))
    return s


def arguments_of(m, name, states, state=slice(None)):
    signature = inspect.signature(getattr(m, name)).parameters
    return {k: states[k][state] for k in ("q", "qd", "qdd", "tau", "mu", "t", "parameters", "wrenches") if k in signature}


def parts(result):
    return list(result) if isinstance(result, tuple) else [result]


@pytest.mark.parametrize("name", CATALOGUE)
def test_every_function_equals_evaluate_and_many_states_equal_one_by_one(load, name):
    m = load(name)
    states = random_states(m, 7)
    lines = []
    for i in range(7):
        line = {k: states[k][i].tolist() for k in ("q", "qd", "qdd", "tau", "mu", "t")}
        line["parameters"] = dict(zip(m.parameter_names, states["parameters"][i].tolist()))
        line["wrenches"] = {b: w.tolist() for b, w in zip(m.wrench_body_names, states["wrenches"][i])}
        lines.append(json.dumps({k: v for k, v in line.items() if v != {}}))
    done = subprocess.run([alembert.executable(), "evaluate", str(ROOT / "mechanisms" / f"{name}.yaml"), "--functions", "all",
                           "--json"], input="\n".join(lines), capture_output=True, text=True, check=True)
    expected = [json.loads(line) for line in done.stdout.splitlines()]
    assert set(expected[0]) == set(m.function_names)
    for function in m.function_names:
        call = getattr(m, function)
        many = parts(call(**arguments_of(m, function, states)))
        for i in range(7):
            one = parts(call(**arguments_of(m, function, states, i)))
            for a, b, right in zip(one, many, expected[i][function].values()):
                assert a.dtype == np.float64 and b.shape == (7,) + a.shape
                assert np.array_equal(a, b[i])
                right = np.array(right).reshape(a.shape)
                assert np.allclose(a, right, rtol=1e-12, atol=1e-12 * max(1, np.abs(right).max(initial=0)))


def test_natural_shapes(load):
    m = load("tree_every_joint")
    s = random_states(m, 3)
    assert m.inverse_dynamics(s["q"][0], s["qd"][0], s["qdd"][0]).shape == (20,)
    assert m.body_poses(s["q"]).shape == (3, 10, 3, 4)
    assert m.frame_jacobians(s["q"][0]).shape == (1, 6, 20)
    assert m.body_inertias().shape == (10, 10)
    both = m.mass_matrix_and_bias(s["q"], s["qd"])
    assert both.M.shape == (3, 20, 20) and both.c.shape == (3, 20) and type(both).__name__ == "MassMatrixAndBias"
    assert m.mass_matrix(s["q"][:0]).shape == (0, 20, 20)
    assert m.mass_matrix(s["q"][:1]).shape == (1, 20, 20)


def test_names_and_constants(load):
    m = load("tree_every_joint")
    assert (m.name, m.nq, m.nv) == ("tree_every_joint", 22, 20)
    assert m.coordinate_names[3:7] == ("attitude.x", "attitude.y", "attitude.z", "attitude.w")
    assert m.wrench_body_names == ("trunk", "drill") and m.frame_names == ("drill_tip",) and m.quaternion_offsets == (3, 17)
    knee = load("four_bar_knee")
    assert knee.lower_limits.tolist() == [-0.6, 0.8] and knee.upper_limits.tolist() == [1.8, 2.1]
    assert m.upper_limits[0] == np.inf and m.lower_limits[0] == -np.inf
    with pytest.raises(ValueError):
        m.initial_coordinates[0] = 1
    wheels = load("paper/rolling_disc")
    s = random_states(wheels, 1)
    assert wheels.constraints(s["q"][0], s["qd"][0]).P.shape == (len(wheels.constraint_names), wheels.nv)
    assert len(wheels.holonomic) == len(wheels.constraint_names) > 0


@pytest.mark.parametrize("states", [0, 1, 5])
def test_arrays_of_any_layout_give_the_same_bits(load, states):
    m = load("puma560")
    s = random_states(m, 2 * max(states, 1))
    q, qd = (s["q"][::2], s["qd"][::2]) if states else (s["q"][0], s["qd"][0])
    q, qd = np.ascontiguousarray(np.round(q * 4) / 4), np.ascontiguousarray(np.round(qd * 4) / 4)
    expected = m.bias(q, qd)

    def same(a, b):
        assert np.array_equal(m.bias(a, b), expected)

    same(q.astype(np.float32), qd.astype(np.float16))
    same(q.tolist(), qd.tolist())
    same(np.asfortranarray(q), np.asfortranarray(qd))
    same(q.astype(">f8"), qd.astype(np.longdouble))
    wide = np.zeros(q.shape[:-1] + (12,))
    wide[..., ::2] = q
    same(wide[..., ::2], qd)
    same(q[..., ::-1].copy()[..., ::-1], qd)
    q.flags.writeable = False
    same(q, qd)
    raw = np.zeros(q.nbytes + 1, dtype=np.uint8)
    raw[1:] = np.frombuffer(q.tobytes(), dtype=np.uint8)
    odd = raw[1:].view(np.float64).reshape(q.shape)
    assert not odd.flags.aligned
    same(odd, qd)
    whole = (q * 4).astype(np.int64)
    assert np.array_equal(m.bias(whole, qd), m.bias(whole.astype(float), qd))


def test_what_is_for_one_state_is_shared_by_all(load):
    m = load("tree_every_joint")
    s = random_states(m, 4)
    w = s["wrenches"][0]
    expected = np.array([m.inverse_dynamics(s["q"][0], s["qd"][i], s["qdd"][0], 0.5, wrenches=w) for i in range(4)])
    assert np.array_equal(m.inverse_dynamics(s["q"][0], s["qd"], s["qdd"][0], 0.5, wrenches=w), expected)
    drill = m.inverse_dynamics(s["q"], s["qd"], s["qdd"], wrenches={"drill": s["wrenches"][:, 1]})
    for i in range(4):
        both = np.array([np.zeros(6), s["wrenches"][i, 1]])
        assert np.array_equal(drill[i], m.inverse_dynamics(s["q"][i], s["qd"][i], s["qdd"][i], wrenches=both))
    assert not np.array_equal(drill, m.inverse_dynamics(s["q"], s["qd"], s["qdd"]))


def test_parameters_by_name(load):
    m = load("runtime_parameters")
    q, qd = [0.3, 0.4], [1.0, 2.0]
    expected = m.bias(q, qd, parameters=[9.81, 2.0, 0.42, 0.05])
    assert not np.array_equal(expected, m.bias(q, qd))
    assert np.array_equal(m.bias(q, qd, m=2.0), expected)
    assert np.array_equal(m.bias(q, qd, parameters={"m": 2}), expected)
    assert np.array_equal(m.bias(q, qd, parameters={"m": 2}, l=0.42), expected)
    many = m.bias(q, qd, m=[1.0, 2.0], g=9.81)
    assert many.shape == (2, 2) and np.array_equal(many[1], expected)
    with pytest.raises(TypeError, match="given as an array, and m as a keyword"):
        m.bias(q, qd, parameters=[9.81, 2.0, 0.42, 0.05], m=2)
    with pytest.raises(TypeError, match="m is given as a keyword too"):
        m.bias(q, qd, parameters={"m": 2}, m=2)


def test_the_docstring_tells_which_parameters_are_keywords(load, cache, tmp_path):
    names = ["lambda", "in", "q", "threads", "mu", "k"]
    file = tmp_path / "names.yaml"

    def loaded(names):
        file.write_text("alembert: 1\nname: names\nparameters:\n"
                        + "".join(f"  {name}: {{value: 1, runtime: true}}\n" for name in names)
                        + "coordinates: [x]\nbodies:\n  - {name: a, transform: [{translate: [x, 0, 0]}], mass: "
                        + " + ".join(names) + "}\n")
        module = alembert.load(file, ("mass_matrix", "inverse_dynamics_second_derivatives"), cache=cache)
        return module, " ".join(module.__doc__.split())

    m, doc = loaded(names)
    assert ("or a dict by name; each can also be given as a keyword but lambda, in, q, threads, which only the dict takes; mu only "
            "where the function has no argument of that name wrenches") in doc
    for name in names:
        assert m.mass_matrix([0], parameters={name: 2.0})[0, 0] == 7
    assert m.mass_matrix([0], k=2.0, mu=3.0)[0, 0] == 9
    for name in names[:4]:
        with pytest.raises((TypeError, ValueError)):
            m.mass_matrix([0], **{name: 2.0})
    assert m.inverse_dynamics_second_derivatives([0], [0], [0], mu=[1], parameters={"mu": 2}).tau_qq.shape == (1, 1)
    assert "a dict by name; no keywords, because Python or the functions use these names wrenches" in loaded(["lambda", "out"])[1]
    assert "a dict by name; each can also be given as a keyword wrenches" in loaded(["k", "l"])[1]
    assert "parameters (0,): there are no runtime parameters wrenches" in " ".join(load("puma560").__doc__.split())


@pytest.mark.parametrize("error, message, call", [
    (ValueError, r"q: expected shape \(6,\) or \(N, 6\), found \(5,\)", lambda m: m.bias(np.zeros(5), np.zeros(6))),
    (ValueError, r"qd: expected shape \(6,\) or \(N, 6\), found \(6, 3\)", lambda m: m.bias(np.zeros(6), np.zeros((6, 3)))),
    (ValueError, r"q: expected shape .* found \(2, 2, 6\)", lambda m: m.mass_matrix(np.zeros((2, 2, 6)))),
    (ValueError, r"q: expected shape .* found \(\)", lambda m: m.mass_matrix(1.0)),
    (ValueError, r"qd: expected 3 states as in q, found 4", lambda m: m.bias(np.zeros((3, 6)), np.zeros((4, 6)))),
    (ValueError, r"t: expected 3 states as in q, found 2", lambda m: m.bias(np.zeros((3, 6)), np.zeros(6), [0, 1])),
    (ValueError, r"t: expected shape \(\) or \(N,\), found \(1, 1\)", lambda m: m.bias(np.zeros(6), np.zeros(6), [[0]])),
    (ValueError, r"q: rows of different lengths", lambda m: m.mass_matrix([[1, 2], [3]])),
    (TypeError, r"q: expected real numbers, found complex128", lambda m: m.mass_matrix(np.zeros(6, complex))),
    (TypeError, r"q: expected real numbers, found object", lambda m: m.mass_matrix([None] * 6)),
    (TypeError, r"q: expected real numbers, found <U", lambda m: m.mass_matrix(["a"] * 6)),
    (TypeError, r"q: expected real numbers, found bool", lambda m: m.mass_matrix([True] * 6)),
    (ValueError, r"wrenches: unknown name 'hand'; there are none",
     lambda m: m.bias(np.zeros(6), np.zeros(6), wrenches={"hand": np.zeros(6)})),
    (ValueError, r"wrenches: expected shape \(0, 6\)", lambda m: m.bias(np.zeros(6), np.zeros(6), wrenches=np.zeros(6))),
    (ValueError, r"parameters: expected shape \(0,\)", lambda m: m.bias(np.zeros(6), np.zeros(6), parameters=[1, 2])),
    (TypeError, r"threads: expected an int, found str", lambda m: m.mass_matrix(np.zeros(6), threads="2")),
    (ValueError, r"threads: expected 0 or more, found -1", lambda m: m.mass_matrix(np.zeros(6), threads=-1)),
    (TypeError, r"out: expected an array of float64, found list", lambda m: m.mass_matrix(np.zeros(6), out=[0])),
    (TypeError, r"out: expected an array of float64, found float32",
     lambda m: m.mass_matrix(np.zeros(6), out=np.zeros((6, 6), np.float32))),
    (ValueError, r"out: expected shape \(6, 6\), found \(6, 5\)", lambda m: m.mass_matrix(np.zeros(6), out=np.zeros((6, 5)))),
    (ValueError, r"out: expected an array that is contiguous",
     lambda m: m.mass_matrix(np.zeros(6), out=np.zeros((6, 6), order="F"))),
    (ValueError, r"out: expected an array that is contiguous.* not read-only",
     lambda m: m.bias(np.zeros(6), np.zeros(6), out=m.upper_limits)),
    (ValueError, r"out: expected 2 arrays, for M, c; found 1",
     lambda m: m.mass_matrix_and_bias(np.zeros(6), np.zeros(6), out=np.zeros(6))),
    (ValueError, r"out, c: expected shape \(6,\), found \(5,\)",
     lambda m: m.mass_matrix_and_bias(np.zeros(6), np.zeros(6), out=(np.zeros((6, 6)), np.zeros(5)))),
])
def test_errors_name_the_argument(load, error, message, call):
    with pytest.raises(error, match=message):
        call(load("puma560"))


def test_near_names_are_told(load):
    tree, rod = load("tree_every_joint"), load("runtime_parameters")
    with pytest.raises(ValueError, match="wrenches: unknown name 'dril'; did you mean 'drill'?"):
        tree.mass_matrix(tree.initial_coordinates, wrenches={"dril": np.zeros(6)})
    with pytest.raises(ValueError, match=r"wrenches\['drill'\]: expected shape \(6,\) or \(N, 6\), found \(5,\)"):
        tree.mass_matrix(tree.initial_coordinates, wrenches={"drill": np.zeros(5)})
    with pytest.raises(ValueError, match="parameters: unknown name 'mass'; expected one of g, m, l, I"):
        rod.mass_matrix([0, 0], parameters={"mass": 1})
    with pytest.raises(TypeError, match="mass"):
        rod.mass_matrix([0, 0], mass=1)


def test_out_is_filled_and_may_lie_over_arguments(load):
    m = load("puma560")
    s = random_states(m, 5)
    expected = m.bias(s["q"], s["qd"])
    out = np.empty((5, 6))
    assert m.bias(s["q"], s["qd"], out=out) is out and np.array_equal(out, expected)
    M, c = np.empty((5, 6, 6)), np.empty((5, 6))
    both = m.mass_matrix_and_bias(s["q"], s["qd"], out=(M, c))
    assert both.M is M and both.c is c and np.array_equal(c, m.mass_matrix_and_bias(s["q"], s["qd"]).c)
    qd = s["qd"].copy()
    assert np.array_equal(m.bias(s["q"], qd, out=qd), expected)
    room = np.empty(41)
    with pytest.raises(ValueError, match="out: the arrays overlap"):
        m.mass_matrix_and_bias(s["q"][0], s["qd"][0], out=(room[:36].reshape(6, 6), room[35:]))


def test_numbers_that_are_not_finite_pass_through(load):
    m = load("puma560")
    q = np.zeros((2, 6))
    q[1, 2] = np.nan
    M = m.mass_matrix(q)
    assert np.isfinite(M[0]).all() and np.isnan(M[1]).any()
    assert not np.isfinite(m.inverse_dynamics(np.zeros(6), np.zeros(6), [np.inf] + [0] * 5)).all()


def test_threads_do_not_change_a_bit(load):
    m = load("tree_every_joint")
    s = random_states(m, 5003)
    expected = m.inverse_dynamics_derivatives(s["q"], s["qd"], s["qdd"], threads=1)
    for threads in (0, 2, np.int64(3), 64):
        found = m.inverse_dynamics_derivatives(s["q"], s["qd"], s["qdd"], threads=threads)
        assert all(np.array_equal(a, b) for a, b in zip(found, expected))
    # Callers' own threads at once.
    found = {}
    callers = [threading.Thread(target=lambda k=k: found.update({k: m.bias(s["q"], s["qd"])})) for k in range(4)]
    for caller in callers:
        caller.start()
    for caller in callers:
        caller.join()
    assert all(np.array_equal(found[k], m.bias(s["q"], s["qd"], threads=1)) for k in range(4))


def test_what_fails_in_a_thread_fails_the_call(load, monkeypatch):
    m = load("puma560")
    entry = m._mass_matrix.entry
    main = threading.current_thread()

    def fails_elsewhere(*arguments):
        if threading.current_thread() is not main:
            raise MemoryError("no room")
        return entry(*arguments)

    monkeypatch.setattr(m._mass_matrix, "entry", fails_elsewhere)
    with pytest.raises(MemoryError, match="no room"):
        m.mass_matrix(np.zeros((5000, 6)), threads=2)
    monkeypatch.setattr(m._mass_matrix, "entry", lambda *arguments: 1)
    with pytest.raises(RuntimeError, match="puma560_mass_matrix returned 1"):
        m.mass_matrix(np.zeros(6))


def test_float_modules_compute_in_float(load):
    m = load("puma560", ["inverse_dynamics", "mass_matrix"], scalar="float")
    exact = load("puma560")
    s = random_states(exact, 3)
    M = m.mass_matrix(s["q"])
    assert M.dtype == np.float32 and m.function_names == ("inverse_dynamics", "mass_matrix", "coordinate_rates")
    assert np.allclose(M, exact.mass_matrix(s["q"]), rtol=1e-4, atol=1e-4)


@pytest.mark.parametrize("name", ["tree_every_joint", "runtime_parameters", "paper/rolling_disc"])
def test_stubs_match_the_module(load, name):
    m = load(name)
    tree = ast.parse(pathlib.Path(m.__file__).with_suffix(".pyi").read_text())
    functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert tuple(functions) == (*m.function_names, "simulate")
    for function, node in functions.items():
        found = inspect.signature(getattr(m, function)).parameters.values()
        assert [p.name for p in found if p.kind == p.POSITIONAL_OR_KEYWORD] == [a.arg for a in node.args.args]
        assert [p.name for p in found if p.kind == p.KEYWORD_ONLY] == [a.arg for a in node.args.kwonlyargs]
        without = [p.name for p in found if p.default is p.empty and p.kind == p.POSITIONAL_OR_KEYWORD]
        assert without == [a.arg for a in node.args.args[:len(node.args.args) - len(node.args.defaults)]]
        doc = inspect.getdoc(getattr(m, function))
        assert doc and (function == "simulate" or "Operations:" in doc) and "kBody" not in doc
    constants = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    imported = {"collections", "ctypes", "difflib", "numpy", "os", "sys", "threading"}
    classes = {node.name for node in tree.body if isinstance(node, ast.ClassDef)}
    public = {k for k in vars(m) if not k.startswith("_")} - imported
    assert public == constants | set(functions) | classes
    for node in (node for node in tree.body if isinstance(node, ast.ClassDef)):
        assert [field.target.id for field in node.body] == list(getattr(m, node.name)._fields)


def test_only_numpy_is_imported(load):
    m = load("puma560")
    code = ("import sys, numpy\nbefore = set(sys.modules)\nimport puma560\n"
            "extra = {n.split('.')[0] for n in set(sys.modules) - before} - set(sys.stdlib_module_names) - {'puma560'}\n"
            "assert not extra, extra")
    subprocess.run([sys.executable, "-B", "-c", code], cwd=pathlib.Path(m.__file__).parent, check=True,
                   env={**os.environ, "PYTHONPATH": "."})


def test_a_library_of_other_files_is_refused(load, tmp_path):
    m = load("puma560")
    folder = pathlib.Path(m.__file__).parent
    text = (folder / "puma560.py").read_text()
    (tmp_path / "puma560.py").write_text(text)
    run = [sys.executable, "-B", "-c", "import puma560"]
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True)
    assert "there is no" in done.stderr and "compile it from puma560.c" in done.stderr
    library = next(folder.glob("libalembert_puma560*"))
    (tmp_path / library.name).write_bytes(library.read_bytes())
    subprocess.run(run, cwd=tmp_path, check=True)
    key = text.split('if key() != b"')[1][:16]
    (tmp_path / "puma560.py").write_text(text.replace(key, "0" * 16))
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True)
    assert "ImportError" in done.stderr and "compile it again" in done.stderr


def test_mechanisms_that_python_cannot_import_are_refused(tmp_path):
    for name, reason in (("lambda", "a keyword of Python"), ("numpy", "the name of another module in use")):
        text = (ROOT / "mechanisms" / "pendulum.yaml").read_text().replace("name: pendulum", f"name: {name}", 1)
        (tmp_path / "m.yaml").write_text(text)
        with pytest.raises(alembert.Error, match=f"'{name}' cannot name a Python module: it is {reason}"):
            alembert.load(tmp_path / "m.yaml", cache=tmp_path / "cache")
