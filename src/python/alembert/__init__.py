"""alembert.load("robot.urdf") or load("arm.yaml"): the equations of motion as a Python module.

The command `alembert` writes them as C and Python, the C compiler compiles them, and a folder keeps both for the next time.
alembert.simulate moves them in time.
Needs numpy. The command is $ALEMBERT_EXECUTABLE, or what is installed with this package, or what PATH has; the compiler is $CC or
cc; the folder is `alembert` in $XDG_CACHE_HOME or ~/.cache. alembert.torch has gradients for PyTorch.
"""
import hashlib
import importlib.util
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import warnings
from types import ModuleType
from typing import Iterable, List, Optional, Tuple, Union

from .simulation import Motion, simulate

__all__ = ["load", "simulate", "Motion", "Error", "executable"]

_FLAGS = ["-std=c99", "-O2", "-fno-math-errno", "-shared", "-fPIC"]
_importing = threading.Lock()


class Error(RuntimeError):
    """The generator or the compiler refused; the text says why."""


def executable() -> str:
    """The command `alembert` that load() runs."""
    named = os.environ.get("ALEMBERT_EXECUTABLE")
    if named:
        if shutil.which(named) is None:
            raise Error(f"ALEMBERT_EXECUTABLE is {named}, which is no program")
        return named
    here = pathlib.Path(__file__).resolve()
    near = [folder / "bin" / "alembert" for folder in here.parents[2:6]]
    # In the source tree: what was built last.
    builds = [path for root in here.parents[3:4] for pattern in ("build/generator/alembert", "build/*/generator/alembert")
              for path in root.glob(pattern)]
    near += sorted(builds, key=lambda path: path.stat().st_mtime, reverse=True)
    found = next((str(path) for path in near if os.access(path, os.X_OK) and path.is_file()), shutil.which("alembert"))
    if found is None:
        raise Error("the command alembert is neither beside this package nor in PATH: set ALEMBERT_EXECUTABLE to it")
    return found


def _run(command: List[str], missing: str) -> Tuple[str, str]:
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise Error(f"{command[0]}: {error.strerror}. {missing}") from None
    if done.returncode != 0:
        raise Error((done.stderr or done.stdout).strip() or f"{command[0]} ended with {done.returncode}")
    return done.stdout, done.stderr


def _library(name: str) -> str:
    ending = ".dylib" if sys.platform == "darwin" else ".so"
    return f"libalembert_{name}{ending}"


def _build(folder: pathlib.Path, description: pathlib.Path, importing: Optional[List[str]], generating: List[str],
           compiler: List[str]) -> None:
    """The files of C and Python, the library and what the generator warned of, all in `folder`."""
    generator, said = executable(), ""
    if importing is not None:
        imported = folder / "description.yaml"
        said += _run([generator, "import", str(description), "--out", str(imported), *importing], "")[1]
        description = imported
    said += _run([generator, "generate", str(description), "--language", "python", "--out-dir", str(folder), *generating],
                 "")[1]
    name = next((folder / "python").glob("*.py")).stem
    sources = [str(folder / "src" / f"{name}{ending}.c") for ending in ("", "_states")]
    library = folder / "python" / _library(name)
    _run([*compiler, *_FLAGS, f"-I{folder / 'include'}", *sources, "-lm", "-o", str(library)],
         "Set CC to a C compiler.")
    (folder / "warnings.txt").write_text(said)


def _import(folder: pathlib.Path, key: str) -> ModuleType:
    path = next((folder / "python").glob("*.py"))
    name = f"alembert_loaded_{path.stem}_{key[:16]}"
    with _importing:
        if name not in sys.modules:
            spec = importlib.util.spec_from_file_location(name, path)
            assert spec is not None and spec.loader is not None
            module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(module)
            sys.modules[name] = module
        return sys.modules[name]


def load(description: Union[str, "os.PathLike[str]"], functions: Union[str, Iterable[str]] = "all", *,
         root: str = "fixed", massless: str = "keep", scalar: str = "double", options: Iterable[str] = (),
         cache: Union[str, "os.PathLike[str]", None] = None) -> ModuleType:
    """The module of a mechanism described by YAML or, with a name in .urdf or .xml, by URDF.

    functions  "all", "default", or names of functions
    root       of URDF: "fixed" or "floating"
    massless   of URDF, for joints that move no mass: "keep", "armature=VALUE", "freeze", "drop"
    scalar     "double" or "float"
    options    more options of `alembert generate`
    cache      folder to keep what is compiled in

    The same description, options, generator and compiler give the same module without compiling again. Raises Error with the
    text of the generator or compiler; what they only warn of is a warning.
    """
    path = pathlib.Path(description)
    content = path.read_bytes()
    importing = None
    if path.suffix.lower() in (".urdf", ".xml"):
        importing = ["--root", root, "--massless", massless]
    elif root != "fixed" or massless != "keep":
        raise ValueError("root and massless are for URDF")
    names = [functions] if isinstance(functions, str) else list(functions)
    generating = ["--scalars", scalar, *options]
    if names != ["default"]:
        generating += ["--functions", ",".join(names)]
    compiler = shlex.split(os.environ.get("CC") or "cc")
    generator = executable()
    stat = os.stat(shutil.which(generator) or generator)
    identity = [_run([generator, "--version"], "")[0], str(stat.st_size), str(stat.st_mtime_ns),
                _run([*compiler, "--version"], "Set CC to a C compiler.")[0], *compiler, *_FLAGS, *(importing or ["yaml"]),
                *generating]
    key = hashlib.sha256(repr(identity).encode() + content).hexdigest()[:32]
    if cache is None:
        home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
        cache = os.path.join(home, "alembert")
    store = pathlib.Path(cache).absolute()
    store.mkdir(mode=0o700, parents=True, exist_ok=True)
    folder = store / key
    if not folder.exists():
        # Whoever is first renames a whole folder; who comes second takes that.
        work = pathlib.Path(tempfile.mkdtemp(prefix="building-", dir=store))
        try:
            _build(work, path, importing, generating, compiler)
            try:
                work.rename(folder)
            except OSError:
                if not folder.exists():
                    raise
        finally:
            shutil.rmtree(work, ignore_errors=True)
    said = (folder / "warnings.txt").read_text()
    if said:
        warnings.warn(said.strip(), stacklevel=2)
    return _import(folder, key)
