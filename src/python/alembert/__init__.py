"""alembert.load("robot.urdf"), load("body.osim") or load("arm.yaml"): the equations of motion as a Python module.

The command `alembert` writes them as C and Python, the C compiler compiles them, and a folder keeps both for the next time.
alembert.simulate moves them in time, alembert.rollout many of them at once, on a cluster too.
Needs numpy. The command is $ALEMBERT_EXECUTABLE, or what is installed with this package, or what PATH has; the compiler is
$CC or cc, with $CFLAGS; the folder is `alembert` in $XDG_CACHE_HOME or ~/.cache. alembert.torch has gradients for PyTorch.
"""
import hashlib
import importlib.util
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import threading
import warnings
from types import ModuleType
from typing import Iterable, List, Optional, Tuple, Union

from .building import Error, executable, flags_of, identity, library_ending, once, run, store
from .rollouts import STATUSES, Rollouts, rollout
from .shards import open_rollouts
from .simulation import Motion, simulate

__all__ = ["load", "simulate", "Motion", "rollout", "Rollouts", "STATUSES", "open_rollouts", "Error", "executable"]

_FLAGS = ["-std=c99", "-O2", "-fno-math-errno", "-shared", "-fPIC"]
_PLACE = "<description>"  # stands in what is kept of warnings for the file that is loaded
_importing = threading.Lock()


def _is_robot(content: bytes) -> bool:
    """Whether it is XML and not a description."""
    encoding = "utf-16" if content.startswith((b"\xff\xfe", b"\xfe\xff")) else "utf-8-sig"
    return content.decode(encoding, errors="replace").lstrip().startswith("<")


def _build(folder: pathlib.Path, content: bytes, description: Optional[pathlib.Path], generating: List[str],
           compiling: List[str]) -> None:
    """The description, the files of C and Python, the library and what the generator warned of, all in `folder`."""
    kept = folder / "description.yaml"
    kept.write_bytes(content)
    read = str(description or kept)
    try:
        said = run([executable(), "generate", read, "--language", "python", "--out-dir", str(folder), *generating], "")[1]
    except Error as error:
        raise Error(str(error).replace(str(kept), _PLACE)) from None
    name = next((folder / "python").glob("*.py")).stem
    sources = [str(folder / "src" / f"{name}{ending}.c") for ending in ("", "_states")]
    library = folder / "python" / f"libalembert_{name}{library_ending()}"
    run([*compiling, f"-I{folder / 'include'}", *sources, "-lm", "-o", str(library)], "Set CC to a C compiler.")
    (folder / "warnings.txt").write_text(said.replace(read, _PLACE), encoding="utf-8")


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
         importing: Iterable[str] = (), cache: Union[str, "os.PathLike[str]", None] = None) -> ModuleType:
    """The module of a mechanism: a description, or a robot or body as URDF, xacro, MJCF, SDF or OpenSim.

    functions  "all", "default", or names of functions
    root       of a robot: "fixed" or "floating"
    massless   of a robot, for joints that move no mass: "keep", "armature=VALUE", "freeze", "drop"
    scalar     "double" or "float"
    options    more options of `alembert generate`
    importing  more options of `alembert import`, for a robot: ("--include", folder), for example
    cache      folder to keep what is compiled in

    The same description, options, generator and compiler give the same module without compiling again; a robot is imported each
    time, because its files may include others. Raises Error with the text of the generator or compiler; what they only warn of is a
    warning.
    """
    path = pathlib.Path(description)
    place = str(path)
    content = path.read_bytes()
    keep = store(cache)
    read: Optional[pathlib.Path] = path
    said = ""
    if _is_robot(content):
        # Beside the folders that keep descriptions: meshes are named from there.
        with tempfile.TemporaryDirectory(prefix="importing-", dir=keep) as work:
            kept = pathlib.Path(work, "description.yaml")
            said = run([executable(), "import", str(path), "--out", str(kept), "--root", root, "--massless", massless, *importing],
                       "")[1]
            content = kept.read_bytes()
        read = None
        place += ", imported"  # as the command says it: lines are those of the description, which is not kept in a file of the user's
    elif root != "fixed" or massless != "keep" or [*importing]:
        raise ValueError("root, massless and importing are for robots, and this is a description")
    names = [functions] if isinstance(functions, str) else list(functions)
    generating = ["--scalars", scalar, *options]
    if names != ["default"]:
        generating += ["--functions", ",".join(names)]
    compiler = shlex.split(os.environ.get("CC") or "cc")
    compiling = [*compiler, *_FLAGS, *flags_of("CFLAGS")]
    building = [*identity(compiler, "Set CC to a C compiler."), *compiling, *generating]
    key = hashlib.sha256(repr(building).encode() + content).hexdigest()[:32]
    try:
        folder = once(keep, key, lambda work: _build(work, content, read, generating, compiling))
    except Error as error:
        raise Error(str(error).replace(_PLACE, place)) from None
    said += (folder / "warnings.txt").read_text(encoding="utf-8").replace(_PLACE, place)
    if "warning:" in said:  # and not only notes
        warnings.warn(said.strip(), stacklevel=2)
    module = _import(folder, key)
    # What rollout() compiles from, and where.
    module._alembert_description = ((folder / "description.yaml").read_text(encoding="utf-8"), tuple(options))  # type: ignore[attr-defined]
    module._alembert_cache = cache  # type: ignore[attr-defined]
    return module
