"""alembert.load("robot.urdf") or load("arm.yaml"): the equations of motion as a Python module.

The command `alembert` writes them as C and Python, the C compiler compiles them, and a folder keeps both for the next time.
alembert.simulate moves them in time, alembert.rollout many of them at once, on a cluster too.
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
import threading
import warnings
from types import ModuleType
from typing import Iterable, List, Optional, Tuple, Union

from .building import Error, executable, identity, library_ending, once, run, store
from .rollouts import STATUSES, Rollouts, rollout
from .shards import open_rollouts
from .simulation import Motion, simulate

__all__ = ["load", "simulate", "Motion", "rollout", "Rollouts", "STATUSES", "open_rollouts", "Error", "executable"]

_FLAGS = ["-std=c99", "-O2", "-fno-math-errno", "-shared", "-fPIC"]
_importing = threading.Lock()


def _build(folder: pathlib.Path, description: pathlib.Path, importing: Optional[List[str]], generating: List[str],
           compiler: List[str]) -> None:
    """The files of C and Python, the library and what the generator warned of, all in `folder`."""
    generator, said = executable(), ""
    kept = folder / "description.yaml"
    if importing is not None:
        said += run([generator, "import", str(description), "--out", str(kept), *importing], "")[1]
        description = kept
    elif description.suffix.lower() in (".yaml", ".yml"):
        shutil.copyfile(description, kept)
    said += run([generator, "generate", str(description), "--language", "python", "--out-dir", str(folder), *generating], "")[1]
    name = next((folder / "python").glob("*.py")).stem
    sources = [str(folder / "src" / f"{name}{ending}.c") for ending in ("", "_states")]
    library = folder / "python" / f"libalembert_{name}{library_ending()}"
    run([*compiler, *_FLAGS, f"-I{folder / 'include'}", *sources, "-lm", "-o", str(library)], "Set CC to a C compiler.")
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
    building = [*identity(compiler, "Set CC to a C compiler."), *_FLAGS, *(importing or ["yaml"]), *generating]
    key = hashlib.sha256(repr(building).encode() + content).hexdigest()[:32]
    folder = once(store(cache), key, lambda work: _build(work, path, importing, generating, compiler))
    said = (folder / "warnings.txt").read_text()
    if said:
        warnings.warn(said.strip(), stacklevel=2)
    module = _import(folder, key)
    kept = folder / "description.yaml"
    if kept.exists():  # what rollout() compiles from, and where
        module._alembert_description = (kept.read_text(), tuple(options))  # type: ignore[attr-defined]
        module._alembert_cache = cache  # type: ignore[attr-defined]
    return module
