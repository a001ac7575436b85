"""A batch as one data set for LeRobot, pandas, Polars and DuckDB (docs/many_runs.md), and its episodes as runs.

    python -m taxel.data_set data                    # data: a folder of taxel batch

    import taxel.data_set
    taxel.data_set.write("data")                     # data/data and data/meta: Parquet in the shape of LeRobot's version 3
    taxel.data_set.write_run("data", 17, "run")      # plays episode 17 again, into a folder that the window opens

Needs the package pyarrow for data sets: pip install "taxel-studio[data]".

The program writes one archive of arrays for each group of jobs, a shard. Each shard becomes one row group, so the memory
does not grow with the number of rows.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import json
import math
import os
import pathlib
import shutil
import sys
import tempfile
import typing

import numpy as np

from taxel import batch_folder as batches
from taxel import data_set_tables as tables
from taxel import json_text, published_files
from taxel.batch_folder import BatchFolder, Episode
from taxel.data_set_survey import Survey, survey_of
from taxel.errors import Error

Path = typing.Union[str, "os.PathLike[str]"]
Progress = typing.Callable[[float], typing.Any]

_INFO = "meta/info.json"
_HEAD = "meta/taxel.json"


def write(batch: Path, out: Path | None = None, progress: Progress | None = None) -> None:
    """Joins the shards of a batch into one data set.

    `batch` is the folder of a finished `taxel batch`, and `out` the folder that receives data, meta and summary.csv, by
    default the batch's own, which has summary.csv already. `progress` is called with the finished fraction; an exception
    of it ends the writing.

    The files appear together when all are complete, meta/info.json last. A data set of the same batch that is as it was
    written is left as it is, and one with a missing file is written again. Raises Error that names the file and the
    remedy if the batch is not finished or damaged, if a file of the data set was changed or is of something else, if a
    file cannot be written, or if pyarrow is not installed.
    """
    check_library()
    source = BatchFolder(batch)
    target = source.folder if out is None else pathlib.Path(out)
    is_own = target.exists() and target.samefile(source.folder)
    survey = survey_of(source)
    with published_files.PublishedFolder(target) as folder:
        recorded = _recorded_files(target, survey)
        if recorded and not folder.missing(recorded):
            _check_no_other_rows(target, {file.name for file in recorded})
            folder.forget_interrupted()
            return
        known = recorded | folder.interrupted()
        if recorded:
            known.add(published_files.described(target, _HEAD))
        _check_is_free(target, survey, ["data", "meta"] if is_own else ["data", "meta", "summary.csv"], bool(known))
        staging = folder.empty_staging()
        try:
            _write_files(staging, survey, is_own, progress or (lambda fraction: None))
        except OSError as error:
            raise Error(error.filename or str(staging), "", f"cannot be written: {error.strerror or error}") from error
        files = folder.staged()
        _check_no_other_rows(target, {file.name for file in (*files, *known)})
        head = {**survey.head(), "files": [dataclasses.asdict(file) for file in files]}
        _write_text(staging / _HEAD, head)
        folder.publish([*files, published_files.described(staging, _HEAD)], known, last=_INFO)


def check_new_folder(out: Path) -> None:
    """Raises Error if a folder of no batch has files with the names of a data set. Reads no content."""
    folder = pathlib.Path(out)
    for name in "data", "meta":
        if os.path.lexists(folder / name) and not (folder / ".batch").exists():
            raise Error(str(folder), "", f'has "{name}" already, which is not of a batch: give another folder, or remove it')


def check_library() -> None:
    """Raises Error with the remedy if the package pyarrow is not installed."""
    try:
        import pyarrow.parquet  # noqa: F401
    except ModuleNotFoundError as error:
        package = str(error.name).partition(".")[0]
        raise Error("", "data_set", f'needs the package {package}: pip install "taxel-studio[data]"') from error


def _recorded_files(target: pathlib.Path, survey: Survey) -> set[published_files.PublishedFile]:
    """Returns the files of the data set in the target, or nothing if it has none.

    Raises Error if it is one of another batch.
    """
    path = target / _HEAD
    try:
        head = json.loads(path.read_bytes())
        files = published_files.read_descriptions(head.pop("files"))
    except FileNotFoundError:
        return set()
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise Error(str(path), "", "is not of a data set that this package has written: remove the folders data and meta, "
                                   "or give another folder") from error
    if head != json.loads(json_text.document(survey.head())):
        raise Error(str(path), "", "is of another batch, or was changed: remove the folders data and meta, or give another "
                                   "folder")
    return files


def _check_is_free(target: pathlib.Path, survey: Survey, names: typing.Sequence[str], has_list: bool) -> None:
    """Raises Error if the target has files with the names of a data set. Without their list, meta/info.json must be ours."""
    taken = [name for name in names if os.path.lexists(target / name)]
    info = target / _INFO
    is_ours = has_list or (info.is_file() and info.read_text(encoding="utf-8", errors="replace") == _text(survey.info()))
    if taken and not is_ours:
        raise Error(str(target), "", f'has "{taken[0]}" already, which is not of this data set: remove it, or give another '
                                     "folder")


def _check_no_other_rows(target: pathlib.Path, names: set[str]) -> None:
    """Raises Error for a file that readers of the data set would take for one of it."""
    for file in sorted((target / "data").rglob("*.parquet")):
        if file.relative_to(target).as_posix() not in names:
            raise Error(str(file), "", "is not of this data set, and would be read with it: remove it")


def _text(value: typing.Any) -> str:
    return json_text.document(value) + "\n"


def _write_text(path: pathlib.Path, value: typing.Any) -> None:
    """Writes a JSON document, and waits until it is on the disk."""
    _write_bytes(path, _text(value).encode())


def _write_bytes(path: pathlib.Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("wb") as file:
        file.write(content)
        file.flush()
        os.fsync(file.fileno())


def _write_files(folder: pathlib.Path, survey: Survey, is_own: bool, progress: Progress) -> None:
    """Writes all files but meta/taxel.json into an empty folder."""
    source = survey.source
    rows, table = tables.RowFiles(folder, survey), tables.EpisodeTable(folder, source.of_scenes)
    with contextlib.closing(rows), contextlib.closing(table):
        for number, (shard, episodes) in enumerate(source.shards()):
            progress(number / survey.shards)
            rows.add(shard, episodes)
            table.add(episodes, rows)
        rows.finish()
        table.finish()
    tables.write_tasks(folder / "meta/tasks.parquet", survey.tasks)
    tables.write_layouts(folder / "meta/layouts.parquet", source.layouts)
    if source.of_scenes:
        tables.write_scenes(folder / "meta/scenes.parquet", source.scenes)
    for mesh in source.meshes():
        _write_bytes(folder / "meta" / batches.MESHES / mesh.name, batches.read_bytes(mesh))
    if (source.folder / "failed.jsonl").exists():
        _write_bytes(folder / "meta/failed.jsonl", batches.read_bytes(source.folder / "failed.jsonl"))
    if not is_own:
        _write_bytes(folder / "summary.csv", batches.read_bytes(source.folder / "summary.csv"))
    _write_text(folder / "meta/stats.json", rows.statistics())
    _write_text(folder / _INFO, survey.info())
    progress(1.0)


def write_run(batch: Path, episode: int, folder: Path) -> None:
    """Plays an episode of a batch again, and writes the run into a new folder.

    The folder has the files of `taxel play`: the layout, its mesh, scenario.json and the recording, which the window and
    the other commands open. All rows of the batch are compared with the run: readings, forces, times and travels have the
    same bits, with numbers of 32 bits after rounding. Raises Error if they differ, and then no folder is written; if the
    folder has files already; if the batch has no such episode or is damaged; and the errors of taxel.play().
    """
    source = BatchFolder(batch)
    if source.of_scenes:
        raise Error(str(source.folder), "episode", "is of a scene, and only episodes of scenarios are played again: run the "
                                                   "scene by taxel.batch() with one job, or by `taxel run`")
    target = pathlib.Path(folder)
    if target.is_file() or (target.is_dir() and any(target.iterdir())):
        raise Error(str(target), "", "exists already: give another folder")
    found = next((one for one in source.episodes() if one.episode == episode), None)
    if found is None:
        raise Error(str(source.folder), "episode", f"must be 0 to {source.head['episodes'] - 1}, is {episode}")
    rows = source.read_rows(found)
    absolute = target.absolute()
    temporary = absolute.with_name(f".{absolute.name}.{os.getpid()}.tmp")
    try:
        difference = _difference(_play(source, found, temporary), rows, source)
        if difference:
            raise Error(str(source.folder), f"episode {episode}", f"{difference}: the batch was written by "
                                                                  f"{source.head['program']}, and other versions may compute other bits")
        temporary.replace(target)
    except OSError as error:
        raise Error(str(target), "", f"cannot be written: {error.strerror or error}") from error
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _play(source: BatchFolder, episode: Episode, folder: pathlib.Path) -> typing.Any:
    """Plays an episode into a folder, and returns the recording."""
    from taxel import runs

    with tempfile.TemporaryDirectory(prefix="taxel") as name:
        files = pathlib.Path(name)
        scenario, layout = files / "scenario.json", files / "layout.taxels.json"
        scenario.write_text(episode.scenario, encoding="utf-8")
        layout.write_text(source.layouts[episode.layout].layout, encoding="utf-8")
        for mesh in source.meshes():
            (files / batches.MESHES).mkdir(exist_ok=True)
            shutil.copyfile(mesh, files / batches.MESHES / mesh.name)
        try:
            return runs.play(scenario, layout, folder)
        except Error as error:
            raise Error(str(source.folder), f"episode {episode.episode}", f"cannot be played: {error}") from error


def _difference(run: typing.Any, rows: batches.Arrays, source: BatchFolder) -> str:
    """Returns how a run differs from the rows of its episode, or an empty text."""
    sensor = run.sensors[0]
    columns = {batches.TIMESTAMP: run.time, batches.TRAVEL: run.travel, batches.FORCE: sensor.force,
               batches.TACTILE: sensor.readings}
    if "fps" in source.head:
        columns = _resampled(columns, source.head["fps"])
    if len(columns[batches.TIMESTAMP]) != len(rows[batches.TIMESTAMP]):
        return f"has {len(rows[batches.TIMESTAMP])} rows, and the run has {len(columns[batches.TIMESTAMP])}"
    for name, values in columns.items():
        played, recorded = np.ascontiguousarray(values, rows[name].dtype), np.ascontiguousarray(rows[name])
        if played.shape != recorded.shape:
            return f"has the shape {recorded.shape} of {name}, and the run has {played.shape}"
        if played.tobytes() != recorded.tobytes():
            differs = (played.view(np.uint8) != recorded.view(np.uint8)).reshape(len(played), -1).any(axis=1)
            largest = np.abs(played.astype(np.float64) - recorded).max()
            return f"{name} of the run differs in {differs.sum()} of {len(differs)} rows, by up to {largest:.3g}"
    return ""


def _resampled(columns: batches.Arrays, fps: int) -> batches.Arrays:
    """Returns rows at whole multiples of 1 / fps, interpolated linearly, in the order of operations of the program."""
    time = np.asarray(columns[batches.TIMESTAMP])
    rounding = 1e-9  # of a multiple of 1 / fps
    first, last = math.ceil(time[0] * fps - rounding), math.floor(time[-1] * fps + rounding)
    times = np.arange(first, max(first, last) + 1) / fps
    after = np.searchsorted(time, times)
    before = np.maximum(after - 1, 0)
    is_held = (after == 0) | (after == len(time))
    after = np.where(is_held, before, after)
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.where(is_held, 0, (times - time[before]) / (time[after] - time[before]))
    made = {}
    for name, values in columns.items():
        column = np.asarray(values).reshape(len(time), -1)
        parts = share[:, None]
        mixed = np.where(parts == 0, column[before], (1 - parts) * column[before] + parts * column[after])
        made[name] = mixed.reshape(len(times), *np.shape(values)[1:])
    made[batches.TIMESTAMP] = times
    return made


def main(arguments: typing.Sequence[str]) -> int:
    """Runs `python -m taxel.data_set` with these arguments, and returns its exit status: 0, or 2 after an error."""
    parser = argparse.ArgumentParser(prog="python -m taxel.data_set", description="Joins the folder of a finished `taxel "
                                     "batch` into one data set (docs/many_runs.md).")
    parser.add_argument("batch", metavar="BATCH", help="folder of the batch")
    parser.add_argument("--out", metavar="FOLDER", help="folder for the data set (default: that of the batch)")
    options = parser.parse_args(arguments)
    try:
        write(options.batch, options.out)
    except Error as error:
        print(f"taxel.data_set: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
