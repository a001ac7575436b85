"""The Parquet files of a data set: rows, episodes, tasks and layouts. Needs pyarrow."""

from __future__ import annotations

import contextlib
import json
import os
import pathlib
import typing

import numpy as np

from taxel import batch_folder as batches
from taxel.batch_folder import Episode, Layout, Scene
from taxel.data_set_survey import FILES_PER_CHUNK, INDICES, PATTERN, Survey
from taxel.errors import Error

if typing.TYPE_CHECKING:
    import pyarrow

_MAX_FILE_BYTES = 100 << 20  # a larger file of rows is followed by another one
_EPISODES_PER_ROW_GROUP = 1024
_MAX_LIST_VALUES = 2**31 - 1  # of a column in a row group: Arrow's lists count in 32 bits
_COMPRESSION_LEVEL = 9  # of Zstandard


class _Statistics:
    """Least, largest and mean value and standard deviation of each component of a column."""

    def __init__(self, components: int) -> None:
        self._components = components
        self._count = 0
        self._min = np.full(components, np.inf)
        self._max = np.full(components, -np.inf)
        self._mean = np.zeros(components)
        self._squares = np.zeros(components)  # sums of the squared differences from the mean

    def add(self, values: typing.Any) -> None:
        """Adds the rows of a shard. With one component, it follows all numbers of the rows."""
        table = np.asarray(values, np.float64).reshape(-1, self._components)
        count = len(table)
        if count == 0:
            return
        self._min = np.minimum(self._min, table.min(axis=0))
        self._max = np.maximum(self._max, table.max(axis=0))
        # Differences from the first row: the mean of equal numbers is then exact, and their deviation 0.
        shifted = table - table[0]
        mean = shifted.mean(axis=0)
        squares = ((shifted - mean) ** 2).sum(axis=0)
        # Chan, Golub and LeVeque 1979: the statistics of two parts together.
        total = self._count + count
        step = table[0] + mean - self._mean
        if self._count == 0:
            self._mean, self._squares = table[0] + mean, squares
        else:
            self._mean = self._mean + step * (count / total)
            self._squares = self._squares + squares + step**2 * (self._count * count / total)
        self._count = total

    def summary(self) -> dict[str, typing.Any] | None:
        """Returns the entry of meta/stats.json, or None without numbers."""
        if self._count == 0 or self._components == 0:
            return None
        return {"min": self._min.tolist(), "max": self._max.tolist(), "mean": self._mean.tolist(),
                "std": np.sqrt(self._squares / self._count).tolist(), "count": [self._count]}


def _field(name: str, kind: str, is_list: bool = False) -> pyarrow.Field:
    """Returns a column without missing values: int64, float32, float64 or string, or lists of them."""
    import pyarrow as pa

    types = {"int64": pa.int64(), "float32": pa.float32(), "float64": pa.float64(), "string": pa.string()}
    inner = types[kind]
    return pa.field(name, pa.list_(pa.field("element", inner, nullable=False)) if is_list else inner, nullable=False)


class _ParquetFile:
    """A Parquet file that is written row group by row group."""

    def __init__(self, path: pathlib.Path, schema: pyarrow.Schema, notes: typing.Mapping[str, str] | None = None) -> None:
        import pyarrow.parquet
        import pyarrow.types

        path.parent.mkdir(parents=True, exist_ok=True)
        self._schema = schema
        self._file = path.open("xb")
        # Readings compress best as plain numbers, and indices as differences. Readers find rows by the limits of numbers.
        numbers = [field.name for field in schema if pyarrow.types.is_primitive(field.type)]
        indices = {field.name: "DELTA_BINARY_PACKED" for field in schema if pyarrow.types.is_integer(field.type)}
        self._writer = pyarrow.parquet.ParquetWriter(
            self._file, schema, compression="zstd", compression_level=_COMPRESSION_LEVEL, store_schema=False,
            use_dictionary=False, column_encoding=indices, write_statistics=numbers)
        if notes:
            self._writer.add_key_value_metadata(notes)

    def add(self, columns: typing.Sequence[typing.Any]) -> None:
        """Adds a row group."""
        import pyarrow as pa

        arrays = [column if isinstance(column, pa.Array) else pa.array(column, field.type)
                  for column, field in zip(columns, self._schema)]
        table = pa.Table.from_arrays(arrays, schema=self._schema)
        self._writer.write_table(table, row_group_size=max(1, table.num_rows))

    def size(self) -> int:
        return self._file.tell()

    def finish(self) -> None:
        """Ends the file, and waits until it is on the disk."""
        self._writer.close()
        self._file.flush()
        os.fsync(self._file.fileno())
        self._file.close()

    def close(self) -> None:
        """Leaves an incomplete file, which the caller removes."""
        if not self._file.closed:
            with contextlib.suppress(Exception):
                self._writer.close()
            self._file.close()


class RowFiles:
    """The files of rows: a row group for each shard, and a new file after _MAX_FILE_BYTES."""

    def __init__(self, folder: pathlib.Path, survey: Survey) -> None:
        import pyarrow as pa

        self._folder = folder
        self._survey = survey
        self._columns = survey.columns()
        fields = [_field(name, survey.number_type, name not in batches.PLAIN) for name in self._columns]
        self._schema = pa.schema([*fields, *(_field(name, "int64") for name in INDICES)])
        components = {name: max(1, survey.widths[name]) for name in self._columns}
        self._statistics = {name: _Statistics(components.get(name, 1)) for name in self._schema.names}
        self._file: _ParquetFile | None = None
        self.file_number = -1
        self.row_group = -1  #: row group of the latest shard in its file
        self.frames = 0  #: rows that were written

    def add(self, shard: str, episodes: typing.Sequence[Episode]) -> None:
        if self._file is None or self._file.size() > _MAX_FILE_BYTES:
            self.finish()
            self.file_number += 1
            self.row_group = -1
            path = PATTERN.format(chunk_index=self.file_number // FILES_PER_CHUNK,
                                   file_index=self.file_number % FILES_PER_CHUNK)
            self._file = _ParquetFile(self._folder / "data" / path, self._schema)
        arrays = self._survey.source.read_shard(shard)
        rows = sum(episode.rows for episode in episodes)
        cells = [self._cells(name, arrays.get(name), rows, shard) for name in self._columns]
        for name, values in zip(INDICES, self._indices(episodes)):
            self._statistics[name].add(values)
            cells.append(values)
        self._file.add(cells)
        self.row_group += 1
        self.frames += rows

    def finish(self) -> None:
        if self._file is not None:
            self._file.finish()

    def close(self) -> None:
        if self._file is not None:
            self._file.close()

    def statistics(self) -> dict[str, typing.Any]:
        """Returns meta/stats.json. Columns without numbers are left out."""
        summaries = {name: statistics.summary() for name, statistics in self._statistics.items()}
        return {name: summary for name, summary in summaries.items() if summary is not None}

    def _cells(self, name: str, values: typing.Any, rows: int, shard: str) -> typing.Any:
        """Returns a column of a shard. A shard without the column has empty lists."""
        import pyarrow as pa

        if values is None:
            values = np.empty((rows, 0), self._survey.number_type)
        if values.size > _MAX_LIST_VALUES:
            raise Error(str(self._survey.source.folder / shard), name, "has too many numbers for one row group: run the batch "
                                                                       "in another folder with a smaller --group")
        self._statistics[name].add(values)
        if name in batches.PLAIN:
            return values
        offsets = np.arange(rows + 1, dtype=np.int32) * np.int32(values.shape[1])
        kind = self._schema.field(name).type
        return pa.ListArray.from_arrays(offsets, pa.array(values.reshape(-1), kind.value_type), type=kind)

    def _indices(self, episodes: typing.Sequence[Episode]) -> list[typing.Any]:
        """Returns the columns of INDICES."""
        lengths = [episode.rows for episode in episodes]
        frame = np.concatenate([np.arange(length, dtype=np.int64) for length in lengths])
        tasks = [self._survey.tasks[episode.task] for episode in episodes]
        return [frame, np.repeat(np.array([episode.episode for episode in episodes], np.int64), lengths),
                np.arange(self.frames, self.frames + len(frame), dtype=np.int64),
                np.repeat(np.array(tasks, np.int64), lengths)]


# Columns of the table of episodes after `tasks`, with their types and their values: of the episode, its first row in the
# data set, and the files of rows.
_EPISODE_COLUMNS: dict[str, tuple[str, typing.Callable[[Episode, int, RowFiles], typing.Any]]] = {
    "episode_index": ("int64", lambda episode, first, rows: episode.episode),
    "length": ("int64", lambda episode, first, rows: episode.rows),
    "data/chunk_index": ("int64", lambda episode, first, rows: rows.file_number // FILES_PER_CHUNK),
    "data/file_index": ("int64", lambda episode, first, rows: rows.file_number % FILES_PER_CHUNK),
    "dataset_from_index": ("int64", lambda episode, first, rows: first),
    "dataset_to_index": ("int64", lambda episode, first, rows: first + episode.rows),
    "meta/episodes/chunk_index": ("int64", lambda episode, first, rows: 0),
    "meta/episodes/file_index": ("int64", lambda episode, first, rows: 0),
    "taxel/row_group": ("int64", lambda episode, first, rows: rows.row_group),
    "taxel/first_row": ("int64", lambda episode, first, rows: episode.first_row),
    "taxel/layout": ("int64", lambda episode, first, rows: episode.layout),
    "taxel/line": ("int64", lambda episode, first, rows: episode.line),
    "taxel/number": ("int64", lambda episode, first, rows: episode.number),
    "taxel/seed": ("int64", lambda episode, first, rows: (episode.seed + 2**63) % 2**64 - 2**63),  # of 64 bits, unsigned
    "taxel/peak_taxel": ("int64", lambda episode, first, rows: episode.peak_taxel),
    "taxel/job": ("string", lambda episode, first, rows: episode.job),
    "taxel/scenario": ("string", lambda episode, first, rows: episode.scenario),
    "taxel/changes": ("string", lambda episode, first, rows: episode.changes),
    "taxel/duration": ("float64", lambda episode, first, rows: episode.duration),
    "taxel/largest_force": ("float64", lambda episode, first, rows: episode.largest_force),
    "taxel/peak": ("float64", lambda episode, first, rows: episode.peak),
}


#: Names of columns in a data set of scenes instead of those of scenarios.
_NAMES_OF_SCENES = {"taxel/layout": "taxel/of_scene", "taxel/scenario": "taxel/scene"}


class EpisodeTable:
    """The table of episodes. The first columns are LeRobot's."""

    def __init__(self, folder: pathlib.Path, of_scenes: bool) -> None:
        import pyarrow as pa

        self._values = dict(_EPISODE_COLUMNS)
        if of_scenes:
            self._values = {_NAMES_OF_SCENES.get(name, name): value for name, value in self._values.items()}
            self._values["taxel/peak_sensor"] = ("string", lambda episode, first, rows: episode.peak_sensor)
        fields = [_field(name, kind) for name, (kind, _) in self._values.items()]
        schema = pa.schema([_field("tasks", "string", is_list=True), *fields])
        self._file = _ParquetFile(folder / "meta/episodes" / PATTERN.format(chunk_index=0, file_index=0), schema)
        self._tasks: list[list[str]] = []
        self._columns: list[list[typing.Any]] = [[] for _ in fields]

    def add(self, episodes: typing.Sequence[Episode], rows: RowFiles) -> None:
        """Adds the episodes of a shard, whose rows were added to `rows` last."""
        first = rows.frames - sum(episode.rows for episode in episodes)
        for episode in episodes:
            self._tasks.append([episode.task])
            for column, (_, value) in zip(self._columns, self._values.values()):
                column.append(value(episode, first, rows))
            first += episode.rows
            if len(self._tasks) == _EPISODES_PER_ROW_GROUP:
                self._flush()

    def finish(self) -> None:
        self._flush()
        self._file.finish()

    def close(self) -> None:
        self._file.close()

    def _flush(self) -> None:
        if self._tasks:
            self._file.add([self._tasks, *self._columns])
        self._tasks = []
        self._columns = [[] for _ in self._columns]


def _write_table(path: pathlib.Path, schema: pyarrow.Schema, columns: typing.Sequence[typing.Any],
                 notes: typing.Mapping[str, str] | None = None) -> None:
    file = _ParquetFile(path, schema, notes)
    with contextlib.closing(file):
        file.add(columns)
        file.finish()


def write_tasks(path: pathlib.Path, tasks: typing.Mapping[str, int]) -> None:
    """Writes the table of tasks, whose index pandas finds by a note."""
    import pyarrow as pa

    texts = {"pandas_type": "unicode", "numpy_type": "object"}
    numbers = {"pandas_type": "int64", "numpy_type": "int64", "metadata": None}
    note = {"index_columns": ["__index_level_0__"],
            "column_indexes": [{"name": None, "field_name": None, **texts, "metadata": {"encoding": "UTF-8"}}],
            "columns": [{"name": "task_index", "field_name": "task_index", **numbers},
                        {"name": None, "field_name": "__index_level_0__", **texts, "metadata": None}],
            "creator": {"library": "taxel", "version": "1"}, "pandas_version": "2.2.0"}
    schema = pa.schema([_field("task_index", "int64"), _field("__index_level_0__", "string")])
    notes = {"pandas": json.dumps(note, separators=(",", ":"))}
    _write_table(path, schema, [list(tasks.values()), list(tasks)], notes)


def write_layouts(path: pathlib.Path, layouts: typing.Sequence[Layout]) -> None:
    import pyarrow as pa

    kinds = {"key": "string", "name": "string", "unit": "string", "calibrated_unit": "string", "taxel_ids": "int64",
             "taxel_names": "string", "layout": "string"}
    schema = pa.schema([_field(name, kind, name.startswith("taxel_")) for name, kind in kinds.items()])
    _write_table(path, schema, [[getattr(layout, name) for layout in layouts] for name in kinds])


def write_scenes(path: pathlib.Path, scenes: typing.Sequence[Scene]) -> None:
    import pyarrow as pa

    lists = {"sensors": [list(scene.sensors) for scene in scenes],
             "layouts": [[layout.key for layout in scene.sensors.values()] for scene in scenes],
             "state": [scene.state for scene in scenes], "action": [scene.action for scene in scenes]}
    texts = {name: [getattr(scene, name) for scene in scenes] for name in ("key", "name", "state_unit")}
    schema = pa.schema([*(_field(name, "string") for name in texts), *(_field(name, "string", True) for name in lists)])
    _write_table(path, schema, [*texts.values(), *lists.values()])
