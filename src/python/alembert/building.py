"""What load() and rollout() build with: the command, compilers, and a folder that keeps what was built."""
import contextlib
import hashlib
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
from typing import Callable, Iterator, List, Tuple, Union


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


def run(command: List[str], missing: str) -> Tuple[str, str]:
    """What a command writes to its outputs."""
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8", errors="replace")
    except OSError as error:
        raise Error(f"{command[0]}: {error.strerror}. {missing}") from None
    if done.returncode != 0:
        raise Error((done.stderr or done.stdout).strip() or f"{command[0]} ended with {done.returncode}")
    return done.stdout, done.stderr


def identity(compiler: List[str], missing: str) -> List[str]:
    """Tells generators and compilers apart."""
    generator = executable()
    stat = os.stat(shutil.which(generator) or generator)
    return [run([generator, "--version"], "")[0], str(stat.st_size), str(stat.st_mtime_ns),
            run([*compiler, "--version"], missing)[0], *compiler]


def flags_of(variable: str) -> List[str]:
    """Flags of the compiler that the environment gives, CFLAGS or CXXFLAGS: they follow the package's own."""
    return shlex.split(os.environ.get(variable, ""))


def folder_state(folder: str) -> str:
    """Tells the headers of alembert in a folder apart."""
    digest = hashlib.sha256()
    for path in sorted(pathlib.Path(folder, "alembert").glob("*.hpp")):
        digest.update(path.name.encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()


def store(cache: Union[str, "os.PathLike[str]", None]) -> pathlib.Path:
    """The folder that keeps what is built."""
    if cache is None:
        home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
        cache = os.path.join(home, "alembert")
    folder = pathlib.Path(cache).absolute()
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    return folder


@contextlib.contextmanager
def _locked(path: pathlib.Path) -> Iterator[None]:
    """Holds a file, where the system lets it, against other processes and threads: until they die at the latest."""
    try:
        import fcntl
    except ImportError:
        yield
        return
    with open(path, "w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        try:
            yield
        finally:
            path.unlink(missing_ok=True)  # who waits for it finds what was built; if nothing was, two may build the same


def once(keep: pathlib.Path, key: str, build: Callable[[pathlib.Path], None]) -> pathlib.Path:
    """The folder `key`, built if it is not there. Of those who build the same, the others wait for the first."""
    folder = keep / key
    if folder.exists():
        return folder
    with _locked(keep / f".{key}.lock"):
        if folder.exists():
            return folder
        # A whole folder is renamed: what stands there is complete, where nobody can lock either.
        work = pathlib.Path(tempfile.mkdtemp(prefix="building-", dir=keep))
        try:
            build(work)
            try:
                work.rename(folder)
            except OSError:
                if not folder.exists():
                    raise
        finally:
            shutil.rmtree(work, ignore_errors=True)
    return folder


def library_ending() -> str:
    return ".dylib" if sys.platform == "darwin" else ".so"
