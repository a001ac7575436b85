"""Reads the folder of a finished batch: its head, its layouts, its episodes and the rows of its shards.

docs/many_runs.md lists the files. Nothing but NumPy is needed.
"""

from __future__ import annotations

import contextlib
import dataclasses
import hashlib
import itertools
import json
import os
import pathlib
import re
import typing
import zipfile
import zlib

import numpy as np

from taxel.errors import Error

Path = typing.Union[str, "os.PathLike[str]"]
Arrays = typing.Dict[str, typing.Any]

FORMAT = "taxel-batch"
VERSION = 1
MESHES = "meshes"
AGAIN = "run the same `taxel batch` command again"

TACTILE = "observation.tactile"
FORCE = "observation.force"
CALIBRATED = "observation.calibrated"
SHEAR = "observation.shear"
TRAVEL = "observation.travel"
SENSOR_POSE = "observation.sensor_pose"
MOCAP_POSE = "action"
TIMESTAMP = "timestamp"
#: Recorded columns in the order of a data set.
RECORDED = (TACTILE, FORCE, CALIBRATED, SHEAR, TRAVEL, SENSOR_POSE, MOCAP_POSE, TIMESTAMP)
#: Columns with one number in each row. The others have a list of numbers.
PLAIN = (TRAVEL, TIMESTAMP)
_NEEDED = (TACTILE, FORCE, TRAVEL, TIMESTAMP)

# Columns of scenes. After a dot at the end, the name of a sensor or a body follows.
TACTILE_OF = TACTILE + "."
CALIBRATED_OF = CALIBRATED + "."
SHEAR_OF = SHEAR + "."
FORCE_OF = FORCE + "."
TORQUE_OF = "observation.torque."
SENSOR_POSE_OF = SENSOR_POSE + "."
POSE_OF = "observation.pose."
STATE = "observation.state"
_PREFIXES_OF_SCENES = (TACTILE_OF, CALIBRATED_OF, SHEAR_OF, FORCE_OF, TORQUE_OF, SENSOR_POSE_OF, POSE_OF)


@dataclasses.dataclass(frozen=True)
class Layout:
    """A layout of the batch: the meaning of the readings."""

    key: str  #: hash of the layout and its mesh
    name: str
    unit: str  #: of the readings: Pa, Pa m^2 or N
    calibrated_unit: str  #: empty without a calibration
    taxel_ids: list[int]
    taxel_names: list[str]
    layout: str  #: text of the layout file; its mesh is meshes/SHA256.EXTENSION


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene of the batch: the meaning of its columns."""

    key: str  #: hash of the scene, its files, and the changes that are compiled
    name: str  #: name of the scene's file
    sensors: dict[str, Layout]  #: by the names of the sensors in the names of columns; without taxels for soft geoms
    state: list[str]  #: names of the joints
    state_unit: str  #: rad, m, or "rad, m"
    action: list[str]  #: names of the actuators and of the coordinates of mocap bodies


@dataclasses.dataclass(frozen=True)
class Episode:
    """A run of the batch, without its rows."""

    episode: int
    rows: int
    shard: str  #: archive with the rows: path below the folder
    first_row: int  #: first row in the shard
    layout: int  #: index of the layout, or of the scene
    task: str
    line: int  #: line in the list of jobs
    number: int  #: index among the jobs of the line
    seed: int
    job: str  #: id of the job
    duration: float  #: time from the first row to the last [s]
    largest_force: float  #: [N]
    peak: float  #: largest reading, in the unit of the layout
    peak_taxel: int  #: id of the taxel of the peak; -1 if all readings are 0
    changes: str  #: JSON object: changed values by JSON pointer
    scenario: str  #: text of the scenario file, or of the scene's keys (docs/many_runs.md)
    peak_sensor: str  #: sensor of the peak in a scene; empty for a scenario


_TYPES: dict[str, tuple[typing.Any, typing.Any, str]] = {  # types of a value and of the elements of a list, in words
    "str": (str, object, "a text"), "int": (int, object, "a whole number"), "float": ((int, float), object, "a number"),
    "list[int]": (list, int, "a list of whole numbers"), "list[str]": (list, str, "a list of texts")}
_FIELDS = {kind: [(field.name, *_TYPES[str(field.type)]) for field in dataclasses.fields(kind)] for kind in (Layout, Episode)}


@dataclasses.dataclass(frozen=True)
class ShardColumns:
    """The columns of a shard, as the archive describes them."""

    widths: dict[str, int]  #: numbers in a row of each column
    sums: list[list[typing.Any]]  #: name, checksum and size of each array: equal sums mean equal rows


class BatchFolder:
    """A finished batch. Raises Error that names the file: it is missing, damaged, or of another version."""

    def __init__(self, folder: Path) -> None:
        self.folder = pathlib.Path(folder)
        self.head = self._read_head()
        self.bits: int = self.head["bits"]
        self.of_scenes = self.head.get("runs") == "scenes"
        self.scenes = list(self._read_scenes()) if self.of_scenes else []
        self.layouts = self._layouts_of_scenes() if self.of_scenes else list(self._read_layouts())

    def episodes(self) -> typing.Iterator[Episode]:
        """Yields the episodes in their order. Reads line by line."""
        file = self.folder / "episodes.jsonl"
        shard, row, index = "", 0, -1
        for index, (place, line, value) in enumerate(_lines_of(file)):
            if not isinstance(value.get("changes"), dict):
                raise Error(str(file), f"{place}: /changes", f"must be an object: {AGAIN}")
            if self.of_scenes:
                value = {**value, "layout": value.get("of_scene"), "scenario": value.get("scene")}
            value = {"peak_sensor": "", **value, "changes": _changes_text(line)}
            episode = _read_record(Episode, value, str(file), place)
            row = row if episode.shard == shard else 0
            shard = episode.shard
            kinds = len(self.scenes if self.of_scenes else self.layouts)
            has_place = episode.episode == index and episode.rows > 0 and 0 <= episode.layout < kinds
            if not has_place or episode.first_row != row or not _is_below(shard, "shards"):
                raise Error(str(file), place, f"is damaged: the episode has no place in the batch; {AGAIN}")
            row += episode.rows
            yield episode
        if index + 1 != self.head["episodes"]:
            raise Error(str(file), "", f"has {index + 1} episodes, and batch.json has {self.head['episodes']}: {AGAIN}")

    def shards(self) -> typing.Iterator[tuple[str, list[Episode]]]:
        """Yields the shards with their episodes, in the order of the episodes."""
        seen = set()
        for shard, episodes in itertools.groupby(self.episodes(), lambda episode: episode.shard):
            if shard in seen:
                raise Error(str(self.folder / "episodes.jsonl"), "", f"is damaged: {shard} is in two places; {AGAIN}")
            seen.add(shard)
            yield shard, list(episodes)

    def describe_shard(self, shard: str, episodes: typing.Sequence[Episode]) -> ShardColumns:
        """Returns the columns of a shard, which must have the rows of these episodes."""
        widths, sums = {}, []
        with _Archive(self.folder / shard) as archive:
            for name in archive.names():
                shape, kind = archive.describe(name)
                widths[name] = self._checked_width(archive.file, name, shape, kind)
                if shape[0] != sum(episode.rows for episode in episodes):
                    raise Error(archive.file, name, f"has {shape[0]} rows, and episodes.jsonl has others: {AGAIN}")
                sums.append(archive.sums(name))
            for name in (TIMESTAMP,) if self.of_scenes else _NEEDED:
                if name not in widths:
                    raise Error(archive.file, name, f"is missing: {AGAIN}")
            if self.of_scenes:
                self._check_widths_of_scene(archive.file, widths, episodes)
                return ShardColumns(widths, sums)
            taxels = {len(self.layouts[episode.layout].taxel_ids) for episode in episodes}
            if taxels != {widths[TACTILE]}:
                raise Error(archive.file, TACTILE, f"has {widths[TACTILE]} readings in a row, and the layout has other "
                                                   f"taxels: {AGAIN}")
        return ShardColumns(widths, sums)

    def read_shard(self, shard: str) -> Arrays:
        """Returns the columns of a shard: (rows,) for those of PLAIN, else (rows, width)."""
        with _Archive(self.folder / shard) as archive:
            return {name: archive.read(name) for name in archive.names()}

    def read_rows(self, episode: Episode) -> Arrays:
        """Returns the rows of one episode."""
        self.describe_shard(episode.shard, [other for other in self.episodes() if other.shard == episode.shard])
        rows = slice(episode.first_row, episode.first_row + episode.rows)
        return {name: column[rows] for name, column in self.read_shard(episode.shard).items()}

    def failed(self) -> list[dict[str, typing.Any]]:
        """Returns the lines and jobs without an episode."""
        file = self.folder / "failed.jsonl"
        if not file.exists():
            return []
        return [value for _, _, value in _lines_of(file)]

    def index_sha256(self) -> str:
        """Returns the SHA-256 of everything but the shards, summary.csv and the meshes, whose names are in the layouts."""
        sums = hashlib.sha256()
        for name in "batch.json", "episodes.jsonl", "layouts.jsonl", "scenes.jsonl", "failed.jsonl":
            with contextlib.suppress(FileNotFoundError), (self.folder / name).open("rb") as file:
                sums.update(hashlib.file_digest(file, "sha256").digest())
        return sums.hexdigest()

    def meshes(self) -> list[pathlib.Path]:
        """Returns the meshes of the layouts, also of those whose jobs all failed. Each must be as its name says. A batch of
        scenes has none."""
        if self.of_scenes:
            return []
        folder = self.folder / MESHES
        files = {path for path in folder.iterdir() if path.is_file()} if folder.is_dir() else set()
        files |= {self.folder / mesh for layout in self.layouts if (mesh := _mesh_of(layout)) is not None}
        for file in sorted(files):
            if hashlib.sha256(read_bytes(file)).hexdigest() != file.name.partition(".")[0]:
                raise Error(str(file), "", f"was changed, because its name is the SHA-256 of its bytes: remove it; {AGAIN}")
        return sorted(files)

    def _read_head(self) -> dict[str, typing.Any]:
        file = self.folder / "batch.json"
        if not file.exists():
            if not self.folder.is_dir():
                raise Error(str(self.folder), "", "no such folder")
            if (self.folder / ".batch").exists():
                raise Error(str(file), "", f"no such file: the batch is not finished; {AGAIN}")
            raise Error(str(file), "", "no such file: the folder is not of `taxel batch`, or was copied in part")
        try:
            head = json.loads(read_bytes(file))
        except ValueError as error:
            raise Error(str(file), "", f"is not JSON: {error}; {AGAIN}") from error
        if not isinstance(head, dict) or head.get("format") != FORMAT:
            raise Error(str(file), "/format", f"must be {FORMAT}: the file does not describe a batch")
        if head.get("version") != VERSION:
            raise Error(str(file), "/version", f"is {head.get('version')!r}, this package reads version {VERSION}: use the "
                                               "package of the program that wrote the batch")
        for name in "bits", "group_size", "episodes", "frames", "failed":
            if type(head.get(name)) is not int or head[name] < 0:
                raise Error(str(file), f"/{name}", f"must be a whole number, is {head.get(name)!r}: {AGAIN}")
        for name in "program", "jobs", "poses":
            if not isinstance(head.get(name), str):
                raise Error(str(file), f"/{name}", f"must be a text, is {head.get(name)!r}: {AGAIN}")
        if head["bits"] not in (32, 64):
            raise Error(str(file), "/bits", f"must be 32 or 64, is {head['bits']}: {AGAIN}")
        if "fps" in head and (type(head["fps"]) is not int or head["fps"] < 1):
            raise Error(str(file), "/fps", f"must be a whole number of at least 1, is {head['fps']!r}: {AGAIN}")
        return head

    def _read_layouts(self) -> typing.Iterator[Layout]:
        file = self.folder / "layouts.jsonl"
        for place, _, value in _lines_of(file):
            layout = _read_record(Layout, value, str(file), place)
            if len(layout.taxel_ids) != len(layout.taxel_names):
                raise Error(str(file), f"{place}: /taxel_names", f"must have as many texts as taxel_ids: {AGAIN}")
            if _mesh_of(layout) is None:
                raise Error(str(file), f"{place}: /layout", f"must be a layout whose mesh is in {MESHES}: {AGAIN}")
            yield layout

    def _read_scenes(self) -> typing.Iterator[Scene]:
        file = self.folder / "scenes.jsonl"
        for place, _, value in _lines_of(file):
            try:
                sensors = {one["sensor"]: _read_record(Layout, one, str(file), place) for one in value["sensors"]}
                yield Scene(value["key"], value["name"], sensors, value["state"], value["state_unit"], value["action"])
            except (KeyError, TypeError) as error:
                raise Error(str(file), place, f"is damaged ({error}): {AGAIN}") from error

    def _layouts_of_scenes(self) -> list[Layout]:
        """Returns the layouts of all sensors with taxels, each once."""
        layouts = (layout for scene in self.scenes for layout in scene.sensors.values() if layout.taxel_ids)
        return list({layout.key: layout for layout in layouts}.values())

    def _check_widths_of_scene(self, file: str, widths: dict[str, int], episodes: typing.Sequence[Episode]) -> None:
        for scene in {self.scenes[episode.layout].key: self.scenes[episode.layout] for episode in episodes}.values():
            for name, layout in scene.sensors.items():
                width = widths.get(TACTILE_OF + name, 0)
                if width != len(layout.taxel_ids):
                    raise Error(file, TACTILE_OF + name, f"has {width} readings in a row, and the sensor has "
                                                         f"{len(layout.taxel_ids)} taxels: {AGAIN}")

    def _checked_width(self, file: str, name: str, shape: tuple[int, ...], kind: typing.Any) -> int:
        is_known = name in RECORDED
        if self.of_scenes:
            is_known = name in (TIMESTAMP, STATE, MOCAP_POSE) or name.startswith(_PREFIXES_OF_SCENES)
        if not is_known:
            raise Error(file, name, "is no column that this package knows: use the package of the program that wrote it")
        if kind != np.dtype(f"f{self.bits // 8}"):
            raise Error(file, name, f"has numbers of the type {kind}, and batch.json has {self.bits} bits: {AGAIN}")
        if len(shape) != (1 if name in PLAIN else 2):
            raise Error(file, name, f"has the shape {shape}: {AGAIN}")
        return 1 if name in PLAIN else shape[1]


class _Archive:
    """The arrays of a shard. Raises Error that names the file and the remedy."""

    def __init__(self, path: pathlib.Path) -> None:
        self.file = str(path)
        if not path.exists():
            raise Error(self.file, "", f"no such file: {AGAIN}")
        with self._errors():
            self._zip = zipfile.ZipFile(path)

    def __enter__(self) -> _Archive:
        return self

    def __exit__(self, *_: object) -> None:
        self._zip.close()

    def names(self) -> list[str]:
        """Returns the names of the arrays. The archive may have other members."""
        return [name[:-4] for name in self._zip.namelist() if name.endswith(".npy")]

    def describe(self, name: str) -> tuple[tuple[int, ...], typing.Any]:
        """Returns shape and type of an array without its numbers."""
        with self._errors(name), self._zip.open(name + ".npy") as member:
            version = np.lib.format.read_magic(member)
            read = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
            shape, _, kind = read(member)
            return shape, kind

    def sums(self, name: str) -> list[typing.Any]:
        member = self._zip.getinfo(name + ".npy")
        return [name, member.CRC, member.file_size]

    def read(self, name: str) -> typing.Any:
        with self._errors(name), self._zip.open(name + ".npy") as member:
            array = np.lib.format.read_array(member, allow_pickle=False)
            member.read()  # the end of the member, at which its checksum is compared
            return array

    def _errors(self, name: str = "") -> _ShardErrors:
        return _ShardErrors(self.file, name)


class _ShardErrors:
    """Turns the exceptions of a damaged archive into Error."""

    def __init__(self, file: str, name: str) -> None:
        self._place = file, name

    def __enter__(self) -> None:
        pass

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, _: object) -> None:
        if isinstance(error, OSError):
            raise Error(*self._place, f"cannot be read: {error.strerror or error}") from error
        damages = (zipfile.BadZipFile, zlib.error, EOFError, ValueError, KeyError, NotImplementedError, RuntimeError)
        if isinstance(error, damages) and not isinstance(error, Error):
            raise Error(*self._place, f"is damaged ({error}): remove it; {AGAIN}") from error


def _mesh_of(layout: Layout) -> str | None:
    """Returns the path of the mesh of a layout below the folder of the batch, or None if it is elsewhere."""
    try:
        name = json.loads(layout.layout)["mesh"]["file"]
    except (ValueError, KeyError, TypeError):
        return None
    return name if isinstance(name, str) and _is_below(name, MESHES) else None


def _is_below(name: str, folder: str) -> bool:
    parts = pathlib.PurePosixPath(name).parts
    return len(parts) == 2 and parts[0] == folder and parts[1] != ".."


def read_bytes(file: pathlib.Path) -> bytes:
    """Returns the bytes of a file of a batch. Raises Error that names it and the remedy."""
    try:
        return file.read_bytes()
    except FileNotFoundError as error:
        raise Error(str(file), "", f"no such file: {AGAIN}") from error
    except OSError as error:
        raise Error(str(file), "", f"cannot be read: {error.strerror or error}") from error


def _lines_of(file: pathlib.Path) -> typing.Iterator[tuple[str, str, dict[str, typing.Any]]]:
    """Yields each line's place, text and object."""
    try:
        with file.open(encoding="utf-8") as lines:
            for number, line in enumerate(lines, 1):
                if not line.endswith("\n"):
                    raise Error(str(file), f"line {number}", f"is cut short: {AGAIN}")
                try:
                    value = json.loads(line)
                except ValueError as error:
                    raise Error(str(file), f"line {number}", f"is not JSON: {error}; {AGAIN}") from error
                if not isinstance(value, dict):
                    raise Error(str(file), f"line {number}", f"must be an object: {AGAIN}")
                yield f"line {number}", line, value
    except FileNotFoundError as error:
        raise Error(str(file), "", f"no such file: {AGAIN}") from error
    except UnicodeDecodeError as error:
        raise Error(str(file), "", f"is not UTF-8: {error}; {AGAIN}") from error
    except OSError as error:
        raise Error(str(file), "", f"cannot be read: {error.strerror or error}") from error


def _changes_text(line: str) -> str:
    """Returns the changes of an episode with the digits of the file, which Python may write otherwise.

    Quotes inside of texts are escaped, so the first match is the key of the line.
    """
    key = re.search(r'"changes"\s*:\s*', line)
    assert key is not None
    _, end = json.JSONDecoder().raw_decode(line, key.end())
    return line[key.end() : end]


Record = typing.TypeVar("Record", Layout, Episode)


def _read_record(kind: type[Record], value: dict[str, typing.Any], file: str, place: str) -> Record:
    """Returns an object as a record, whose fields are members of the object."""
    for name, types, element, type_name in _FIELDS[kind]:
        if name not in value:
            raise Error(file, f"{place}: /{name}", f"is missing: {AGAIN}")
        is_good = isinstance(value[name], types) and not isinstance(value[name], bool)
        if not is_good or (types is list and not all(isinstance(one, element) for one in value[name])):
            raise Error(file, f"{place}: /{name}", f"must be {type_name}: {AGAIN}")
    return kind(**{name: value[name] for name, *_ in _FIELDS[kind]})
