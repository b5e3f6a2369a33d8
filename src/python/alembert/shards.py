"""Rollouts in shards: on the workers of Dask, into a folder, or both.

A shard is a run of neighbouring motions, and its result a function of what is given for them alone: who does it, how often and
when changes nothing. A folder is an array of Zarr (format 2, one dimension, not compressed): a record a motion and a chunk a
shard, whose file appears under its name when it is complete; the attributes, .zattrs, say what they are of. A rollout that was
cut off is called again and does what is missing.
"""
import base64
import hashlib
import json
import os
import pathlib
import pickle
import time
import uuid
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union

import numpy
from numpy.typing import NDArray

from . import rollouts

__all__ = ["RolloutFolder", "open_rollouts", "run_all"]

_ARRAY, _MANIFEST, _PART = ".zarray", ".zattrs", ".part-"
# Shards that a worker's thread has been given beside the one it does.
_AHEAD = 3


Planned = Union[rollouts.Plan, rollouts.SampledPlan]


def _fields(plan: Planned) -> List[Any]:
    nq, nv, ns = plan.sizes
    return [("q", "<f8", (plan.rows, nq)), ("qd", "<f8", (plan.rows, nv)), ("states", "<f8", (plan.rows, ns)),
            ("steps", "<i8"), ("status", "<i4"), ("stopped", "|b1")]


def _digest(plan: Planned, size: int) -> str:
    """Tells rollouts apart, but for what functions do: of these only whether there are any."""
    digest = hashlib.sha256()
    # Threads change nothing.
    numbers = sorted((name, value) for name, value in plan.numbers.items() if name != "threads")
    said = (tuple(plan.source), plan.count, size, numbers, plan.policy is not None, plan.stop is not None)
    digest.update(repr(said).encode())
    for name in sorted(plan.arrays):
        array = numpy.ascontiguousarray(plan.arrays[name])
        digest.update(f"{name} {array.dtype.str} {array.shape}".encode())
        digest.update(array.tobytes())
    return digest.hexdigest()


def _file(folder: pathlib.Path, index: int) -> pathlib.Path:
    return folder / str(index)


def _durable(path: pathlib.Path, write: Any) -> None:
    """A file that is there as a whole or not at all, whoever else writes the same."""
    part = path.with_name(f"{_PART}{path.name}-{uuid.uuid4().hex}")
    try:
        with open(part, "wb") as file:
            write(file)
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
    finally:
        if part.exists():
            part.unlink()


def _do(plan: rollouts.Plan, index: int, size: int, out: Optional[str], cache: Any) -> Optional[NDArray[Any]]:
    """A shard: into its file, or as an array."""
    fields = numpy.dtype(_fields(plan))
    if out is not None and _is_whole(_file(pathlib.Path(out), index), size * fields.itemsize):
        return None
    found = rollouts.run(plan, cache)
    # Chunks of Zarr have one size: behind the last motion of the last one are zeros.
    records = numpy.zeros(plan.count if out is None else size, fields)
    for name in records.dtype.names or ():
        records[name][:plan.count] = found[name]
    if out is None:
        return records
    _durable(_file(pathlib.Path(out), index), lambda file: file.write(records.tobytes()))
    return None


def _on_worker(pickled: bytes, index: int, size: int, out: Optional[str]) -> Tuple[int, Optional[NDArray[Any]]]:
    """What a worker runs: it takes the mechanism from its own cache, or builds it there."""
    return index, _do(pickle.loads(pickled), index, size, out, None)


def _is_whole(path: pathlib.Path, size: int) -> bool:
    """Whether a shard is there with all of its bytes."""
    return path.exists() and path.stat().st_size == size


class RolloutFolder:
    """What a rollout left in a folder; shards are mapped, not read."""

    def __init__(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        self.folder = pathlib.Path(folder)
        try:
            manifest = json.loads((self.folder / _MANIFEST).read_text())
            array = json.loads((self.folder / _ARRAY).read_text())
        except FileNotFoundError as error:
            raise ValueError(f"{self.folder}: there is no {pathlib.Path(error.filename).name}, so this is no folder of a rollout") from None
        self.manifest: Dict[str, Any] = manifest
        self._dtype = numpy.dtype([tuple(tuple(part) if isinstance(part, list) else part for part in field) for field in array["dtype"]])
        self.t: NDArray[Any] = numpy.array(manifest["t"], dtype=float)
        self.count: int = manifest["count"]

    def __len__(self) -> int:
        """Shards of the whole rollout."""
        return int(self.manifest["shards"])

    @property
    def missing(self) -> List[int]:
        """Shards that are not done."""
        return [index for index in range(len(self)) if not self._has(index)]

    def _has(self, index: int) -> bool:
        return _is_whole(_file(self.folder, index), int(self.manifest["shard"]) * self._dtype.itemsize)

    def __getitem__(self, index: int) -> NDArray[Any]:
        """The records of a shard (negative: from the last), with fields q, qd, states, steps, status, stopped."""
        if not -len(self) <= index < len(self):
            raise IndexError(f"{self.folder}: there are shards 0 to {len(self) - 1}, not {index}")
        index = int(index) % len(self)
        if not self._has(index):
            raise ValueError(f"{self.folder}: shard {index} is not done; `missing` has all that are not, and the same rollout does them")
        size = int(self.manifest["shard"])
        return numpy.memmap(_file(self.folder, index), self._dtype, "r", shape=(size,))[:self.count - index * size]

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return (self[index] for index in range(len(self)))

    def read(self) -> rollouts.Rollouts:
        """All of it, in memory."""
        return rollouts.Rollouts(self.t, **_joined(list(self)))


def open_rollouts(folder: Union[str, "os.PathLike[str]"]) -> RolloutFolder:
    """The folder that rollout(..., out=folder) wrote, complete or not."""
    return RolloutFolder(folder)


def _joined(records: List[NDArray[Any]]) -> Dict[str, NDArray[Any]]:
    return {name: numpy.concatenate([r[name] for r in records]) for name in records[0].dtype.names or ()}


def _prepared(plan: Planned, size: int, count: int, folder: pathlib.Path) -> None:
    """The folder with its manifest; ValueError if it is of another rollout."""
    folder.mkdir(parents=True, exist_ok=True)
    manifest = {"format": 2, "mechanism": plan.source.name, "rollout": _digest(plan, size), "count": plan.count, "shard": size,
                "shards": count, "method": rollouts.METHODS[plan.numbers["stepper"]], "step": plan.numbers["h"],
                "steps": plan.numbers["steps"], "t": plan.moments().tolist()}
    path = folder / _MANIFEST
    if path.exists():
        found = json.loads(path.read_text())
        other = [name for name in manifest if found.get(name) != manifest[name]]
        if other:
            raise ValueError(f"out: {folder} holds another rollout (of other {', '.join(other)}): give a folder of its own")
    else:
        # What stands where chunks are missing is no motion.
        none = numpy.zeros((), _fields(plan))
        for name in ("q", "qd", "states"):
            none[name] = numpy.nan
        none["steps"] = none["status"] = -1
        array = {"zarr_format": 2, "shape": [plan.count], "chunks": [size], "dtype": _fields(plan), "order": "C",
                 "compressor": None, "filters": None, "fill_value": base64.b64encode(none.tobytes()).decode()}
        for name, content in ((_ARRAY, array), (_MANIFEST, manifest)):
            _durable(folder / name, lambda file: file.write((json.dumps(content, indent=1) + "\n").encode()))
    for part in folder.glob(f"{_PART}*"):
        # A dead process left it: writing one takes no day.
        if time.time() - part.stat().st_mtime > 86400:
            part.unlink()


def _by_client(plan: Planned, size: int, todo: List[int], client: Any, out: Optional[str]) -> Iterator[Tuple[int, Any]]:
    """Results as they come; not more shards are under way than keep the workers busy."""
    import cloudpickle  # comes with distributed
    from distributed import as_completed

    call = uuid.uuid4().hex[:12]

    def submitted(index: int) -> Any:
        part = plan.part(index * size, min(plan.count, (index + 1) * size))
        return client.submit(_on_worker, cloudpickle.dumps(part), index, size, out, key=f"alembert-{call}-{index}", pure=False)

    ahead = max(1, sum(client.nthreads().values())) * (1 + _AHEAD)
    waiting = iter(todo)
    running = [submitted(index) for _, index in zip(range(ahead), waiting)]
    completed = as_completed(running)
    try:
        for future in completed:
            yield future.result()
            running.remove(future)
            future.release()
            for index in waiting:
                running.append(submitted(index))
                completed.add(running[-1])
                break
    finally:
        for future in running:
            future.release()


def run_all(plan: Planned, size: int, client: Any, out: Union[str, "os.PathLike[str]", None], cache: Any) -> Any:
    """All shards of a rollout that are not done: results by name, or the folder."""
    if plan.count == 0:
        raise ValueError("q: expected at least one motion to cut into shards, found none")
    size = min(size, plan.count)
    count = -(-plan.count // size)
    folder = None if out is None else pathlib.Path(out).absolute()
    todo = list(range(count))
    if folder is not None:
        _prepared(plan, size, count, folder)
        todo = RolloutFolder(folder).missing
    place = None if folder is None else str(folder)
    found: Dict[int, NDArray[Any]] = {}
    if client is not None:
        for index, records in _by_client(plan, size, todo, client, place):
            found[index] = records
    else:
        for index in todo:
            records = _do(plan.part(index * size, min(plan.count, (index + 1) * size)), index, size, place, cache)
            if records is not None:
                found[index] = records
    if folder is None:
        return _joined([found[index] for index in range(count)])
    left = RolloutFolder(folder).missing
    if left:
        raise OSError(f"out: shards {left} were done and are not in {folder}: workers must see the same folder")
    return RolloutFolder(folder)
