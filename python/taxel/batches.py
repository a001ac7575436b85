"""Lists of jobs, run on the cores of this machine or on a Ray cluster, as one batch and its data set."""

from __future__ import annotations

import dataclasses
import os
import pathlib
import tempfile
import typing

import numpy as np

from taxel import _core, json_text
from taxel import data_set as data_sets
from taxel import mcap as mcap_files
from taxel.batch_folder import BatchFolder
from taxel.batch_process import BatchProcess
from taxel.errors import Error
from taxel.runs import Path, layout_file

_DIGITS_OF_RUNS = 32  # the names of files in runs/ have the first digits of a job's id

Jobs = typing.Union[Path, typing.Iterable[typing.Mapping[str, typing.Any]]]


@dataclasses.dataclass(frozen=True)
class Observation:
    """The values of one row of a scene, before the step in which the policy acts."""

    job: str  #: id of the job
    policy: str  #: the name that the job gives its policy
    seed: int  #: seed of the job's random values
    is_first: bool  #: the first row of the job
    time: float  #: [s]
    row: dict[str, np.ndarray]  #: columns of the data set (docs/many_runs.md); `action` has the controls before
    actions: list[str]  #: names of the numbers in `action`; the actuators are the first ones


#: Returns the controls of all actuators, in the order of Observation.actions.
Policy = typing.Callable[[Observation], typing.Sequence[float]]


@dataclasses.dataclass(frozen=True)
class BatchProgress:
    """The state of a batch that runs."""

    jobs: int  #: jobs of the list
    finished: int  #: jobs that have ended, now or in an earlier call
    failed: int  #: jobs that have failed in this call
    seconds: float  #: time since the start [s]
    seconds_left: float | None  #: expected time until the end [s]; None before the first job has ended


@dataclasses.dataclass(frozen=True)
class FailedJob:
    """A job, or a whole line of the list, without an episode."""

    line: int  #: line of the list, or place in it, from 1
    number: int | None  #: index among the jobs of the line, from 0; None for a whole line
    job: str  #: id of the job; empty for a whole line
    error: str  #: the reason


@dataclasses.dataclass(frozen=True)
class BatchResult:
    """A finished batch. Its shards, and its data set, are in `folder`."""

    folder: pathlib.Path
    episodes: int
    frames: int
    resumed: int  #: jobs that an earlier call had finished
    failed: tuple[FailedJob, ...]  #: all lines and jobs without an episode, also those of earlier calls


def batch(
    jobs: Jobs,
    out: Path,
    *,
    executor: str = "threads",
    workers: int | None = None,
    progress: typing.Callable[[BatchProgress], typing.Any] | None = None,
    float64: bool = False,
    poses: bool = False,
    npz: bool = False,
    mcap: bool = False,
    data_set: bool = True,
    group: int = 16,
    fps: int | None = None,
    max_restarts: int = 3,
    policy: Policy | None = None,
) -> BatchResult:
    """Runs a list of jobs as `taxel batch` does, and joins the results in the folder `out` into a data set.

    `jobs` is a file with one JSON object on a line, or a list of dicts with the same keys. Relative paths of a list begin
    in the working directory; "layout" may also be a Layout. `executor` is "threads", the cores of this machine, or
    "ray", the actors of a Ray cluster (pip install "ray>=2.60"): the cluster to which ray.init() has connected, or
    one on this machine. Both give the same bytes. `workers` is the number of threads or actors, by default one for each
    core. `progress` is called with a BatchProgress a few times per second; an exception of it ends the batch.
    `float64`, `poses`, `npz`, `group` and `fps` are the options of the program. `mcap` includes `npz`, and converts each
    runs/ID.npz to runs/ID.mcap when the batch is complete; it needs the package mcap. `npz` and `mcap` go with "threads"
    only. `data_set` writes the data set for LeRobot, pandas and others as taxel.data_set.write() does, when the batch is
    complete (docs/many_runs.md); it needs the package pyarrow, and False leaves the files of the program alone.

    `policy` sets the controls of jobs whose scene names a policy. It is called with the Observation of each row, one row at
    a time, and its controls hold until the next row; an exception of it ends the batch. A policy that gives the same
    controls for the same observations keeps the bytes of a continued batch. The name in the job is part of the job's id:
    another policy needs another name, or another folder. It goes with "threads" only.

    A call that was interrupted in any way is continued by the same call, with either executor. With "ray", a worker that
    ends is started again up to `max_restarts` times, and then its jobs fail. Failed jobs are in the result, and the
    others go on. Raises Error if nothing can run or be written; all finished groups are then kept.

        result = taxel.batch([{"scenario": {"kind": "press"}, "set": {"/scenario/depth": {"uniform": [5e-4, 1e-3]}},
                               "repeat": 1000}], "data")
    """
    if executor not in ("threads", "ray"):
        raise Error("", "executor", f'must be "threads" or "ray", is {executor!r}')
    for name, value, least in ("workers", workers, 1), ("group", group, 1), ("fps", fps, 1), ("max_restarts", max_restarts, 0):
        if value is not None and (isinstance(value, bool) or not isinstance(value, int) or value < least):
            raise Error("", name, f"must be a whole number of at least {least}, is {value!r}")
    for name, is_set in ("npz", npz), ("mcap", mcap):
        if executor == "ray" and is_set:
            raise Error("", name, 'needs the executor "threads": Ray actors send no recordings')
    if policy is not None and (executor == "ray" or not callable(policy)):
        raise Error("", "policy", 'must be a function, and needs the executor "threads"')
    if mcap:
        mcap_files.check_library()  # before jobs that may take long
    if data_set:
        _check_data_set_can_be_written(out)
    with tempfile.TemporaryDirectory(prefix="taxel") as folder:
        arguments, files = _list_arguments(jobs, pathlib.Path(folder))
        arguments += ["--out", os.fspath(out), "--group", str(group)]
        if fps is not None:
            arguments += ["--fps", str(fps)]
        flags = {"--float64": float64, "--poses": poses, "--npz": npz or mcap}
        arguments += [flag for flag, is_set in flags.items() if is_set]
        watch = _Watch(progress)
        if executor == "threads":
            if workers is not None:
                arguments += ["--workers", str(workers)]
            _run_here(arguments, files, watch, policy)
        else:
            from taxel.ray_batch import run_on_ray

            run_on_ray(arguments, files, watch, workers, max_restarts)
    finished = BatchFolder(out)
    if data_set:
        data_sets.write(out)
    if mcap:
        _write_mcap_files(finished)
    return _result(finished, watch.report)


class _Watch:
    """Receives the events of the program that the caller sees, and keeps the report."""

    def __init__(self, progress: typing.Callable[[BatchProgress], typing.Any] | None) -> None:
        self._progress = progress
        self.report: dict[str, typing.Any] = {}

    def __call__(self, event: dict[str, typing.Any]) -> None:
        if event["event"] == "result":
            self.report = event
        elif event["event"] == "progress" and self._progress is not None:
            names = [field.name for field in dataclasses.fields(BatchProgress)]
            self._progress(BatchProgress(**{name: event[name] for name in names}))


def _run_here(arguments: list[str], files: dict[str, str], watch: _Watch, policy: Policy | None) -> None:
    seen: set[str] = set()
    with BatchProcess(arguments, files, policy=policy is not None) as process:
        for event in process.all_events():
            if event["event"] == "observation" and policy is not None:
                controls = policy(_observation_of(event, event["job"] not in seen))
                seen.add(event["job"])
                process.send_action(event["job"], [float(value) for value in controls])
            else:
                watch(event)


def _observation_of(event: dict[str, typing.Any], is_first: bool) -> Observation:
    row = {name: np.atleast_1d(np.asarray(values, np.float64)) for name, values in event["row"].items()}
    return Observation(event["job"], event["policy"], event["seed"], is_first, event["row"]["timestamp"], row, event["actions"])


def _check_data_set_can_be_written(out: Path) -> None:
    data_sets.check_new_folder(out)
    try:
        data_sets.check_library()
    except Error as error:
        raise Error(error.file, error.pointer, f"{error.message}, or data_set=False without a data set") from error


def _write_mcap_files(batch: BatchFolder) -> None:
    """Writes runs/ID.mcap of a finished batch for each runs/ID.npz that has none, or an older one.

    An archive has no scenario: that of its job is in the list of episodes. Raises Error naming the file.
    """
    for episode in batch.episodes():
        archive = batch.folder / "runs" / f"{episode.job[:_DIGITS_OF_RUNS]}.npz"
        file = archive.with_suffix(".mcap")
        if file.exists() and file.stat().st_mtime_ns >= archive.stat().st_mtime_ns:
            continue  # an earlier call that was interrupted has written it
        name = "scene.json" if batch.of_scenes else "scenario.json"
        notes = mcap_files.RunNotes(batch.head["program"], name, episode.scenario.encode())
        mcap_files.write_with_notes(archive, file, notes)


def _list_arguments(jobs: Jobs, folder: pathlib.Path) -> tuple[list[str], dict[str, str]]:
    """Returns the program's arguments for a list, and the names of its files in messages."""
    if isinstance(jobs, (str, os.PathLike)):
        return [os.fspath(jobs)], {os.fspath(jobs): os.fspath(jobs)}
    files: dict[str, str] = {}
    path = folder / "jobs.jsonl"
    with path.open("w", encoding="utf-8") as text:
        for index, job in enumerate(jobs):
            if not isinstance(job, typing.Mapping):
                raise TypeError(f"jobs[{index}] must be a dict, is of the type {type(job).__name__}")
            text.write(json_text.dump(_plain_job(job, index, folder, files)) + "\n")
    return [str(path), "--folder", os.getcwd()], {**files, str(path): "jobs"}


def _plain_job(
    job: typing.Mapping[str, typing.Any], index: int, folder: pathlib.Path, files: dict[str, str]
) -> dict[str, typing.Any]:
    """Returns a job with paths as texts. A layout in memory is written into a file of its own."""
    plain = typing.cast("dict[str, typing.Any]", _with_texts(job))
    if isinstance(plain.get("layout"), _core.Layout):
        place = folder / str(index)
        place.mkdir()
        path, name = layout_file(plain["layout"], place)
        plain["layout"], files[path] = path, name
    return plain


def _with_texts(value: typing.Any) -> typing.Any:
    """Returns a value with paths as texts."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, typing.Mapping):
        return {key: _with_texts(one) for key, one in value.items()}
    return [_with_texts(one) for one in value] if isinstance(value, (list, tuple)) else value


def _result(batch: BatchFolder, report: dict[str, typing.Any]) -> BatchResult:
    """Reads the counts from the folder, because the report of a batch that was complete before has none."""
    failed = (FailedJob(entry["line"], entry.get("number"), entry.get("job", ""), entry["error"]) for entry in batch.failed())
    return BatchResult(batch.folder, batch.head["episodes"], batch.head["frames"], report["resumed"], tuple(failed))
