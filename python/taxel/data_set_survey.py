"""The shards of a batch as a whole: what a data set needs before its rows are written."""

from __future__ import annotations

import dataclasses
import hashlib
import json
import math
import typing

from taxel import batch_folder as batches
from taxel.batch_folder import BatchFolder, Layout, Scene
from taxel.errors import Error

#: Columns that are computed from the place of a row, after the recorded ones.
INDICES = ("frame_index", "episode_index", "index", "task_index")
FILES_PER_CHUNK = 1000
PATTERN = "chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"


@dataclasses.dataclass
class Survey:
    """The shards as a whole: everything that a data set needs before its rows are written."""

    source: BatchFolder
    tasks: dict[str, int] = dataclasses.field(default_factory=dict)
    widths: dict[str, int] = dataclasses.field(default_factory=dict)  #: numbers in a row; -1 if it differs between rows
    shards: int = 0
    episodes: int = 0
    frames: int = 0
    rate: float = 1.0  #: rows a second
    sha256: str = ""  #: of everything that the data set depends on

    @property
    def number_type(self) -> str:
        return f"float{self.source.bits}"

    def columns(self) -> list[str]:
        """Returns the recorded columns in their order: those of scenes in the order of the shards."""
        if self.source.of_scenes:
            return list(self.widths)
        return [name for name in batches.RECORDED if name in self.widths]

    def features(self) -> dict[str, typing.Any]:
        """Returns the columns as in meta/info.json."""
        features: dict[str, typing.Any] = {}
        for name in self.columns():
            feature = {"dtype": self.number_type, "shape": [self.widths[name]],
                       "names": self._components(name) or None}
            unit = self._unit(name)
            features[name] = {**feature, "unit": unit} if unit else feature
        for name in INDICES:
            features[name] = {"dtype": "int64", "shape": [1], "names": None}
        return features

    def _components(self, column: str) -> list[str]:
        """Returns the names of the numbers of a column, or nothing if they differ between rows."""
        if not self.source.of_scenes:
            return _components(column, self.source.layouts)
        names = [_components_of_scene(column, scene) for scene in self.source.scenes]
        return names[0] if names and all(one == names[0] for one in names) else []

    def _unit(self, column: str) -> str:
        if not self.source.of_scenes:
            return _unit(column, self.source.layouts)
        units = {_unit_of_scene(column, scene) for scene in self.source.scenes}
        return "mixed" if len(units) > 1 else units.pop() if units else ""

    def info(self) -> dict[str, typing.Any]:
        """Returns meta/info.json. The keys are those of LeRobot's version 3."""
        rate = int(self.rate) if self.rate == int(self.rate) else self.rate
        return {"codebase_version": "v3.0", "robot_type": "taxel", "total_episodes": self.episodes,
                "total_frames": self.frames, "total_tasks": len(self.tasks), "chunks_size": FILES_PER_CHUNK,
                "data_files_size_in_mb": 100, "video_files_size_in_mb": 200, "fps": rate,
                "splits": {"train": f"0:{self.episodes}"}, "data_path": f"data/{PATTERN}", "video_path": None,
                "features": self.features()}

    def head(self) -> dict[str, typing.Any]:
        """Returns meta/taxel.json without the list of files."""
        head = self.source.head
        units = {name: feature["unit"] for name, feature in self.features().items() if "unit" in feature}
        made = {"format": "taxel-data-set", "version": 1, "program": head["program"], "jobs": head["jobs"],
                "bits": head["bits"], "group_size": head["group_size"], "episodes": self.episodes,
                "frames": self.frames, "failed": head["failed"], "units": units, "poses": head["poses"]}
        more = {name: head[name] for name in ("fps", "runs") if name in head}
        return {**made, **more, "batch_sha256": self.sha256}


def survey_of(source: BatchFolder) -> Survey:
    """Reads the descriptions of all shards."""
    survey = Survey(source)
    shards_of: dict[str, int] = {}
    duration, sums = 0.0, hashlib.sha256(source.index_sha256().encode())
    for shard, episodes in source.shards():
        columns = source.describe_shard(shard, episodes)
        for name, width in columns.widths.items():
            survey.widths[name] = width if survey.widths.get(name, width) == width else -1
            shards_of[name] = shards_of.get(name, 0) + 1
        for episode in episodes:
            survey.tasks.setdefault(episode.task, len(survey.tasks))
            survey.frames += episode.rows
            duration += episode.duration
        survey.episodes += len(episodes)
        survey.shards += 1
        sums.update(json.dumps(columns.sums).encode())
    for name, count in shards_of.items():
        if count != survey.shards:
            survey.widths[name] = -1
    if survey.frames != source.head["frames"]:
        raise Error(str(source.folder / "batch.json"), "/frames", f"is {source.head['frames']}, and the episodes have "
                                                                  f"{survey.frames} rows: {batches.AGAIN}")
    survey.sha256 = sums.hexdigest()
    survey.rate = _rate(survey.frames - survey.episodes, duration)
    if "fps" in source.head:
        survey.rate = source.head["fps"]
    return survey


def _rate(steps: int, duration: float) -> float:
    """Returns the rows a second without the rounding of times."""
    if duration <= 0:
        return 1.0
    rate = steps / duration
    nearest = max(1.0, math.floor(rate + 0.5))
    return nearest if abs(rate - nearest) <= 1e-6 * nearest else rate


def _taxels(layouts: typing.Sequence[Layout]) -> list[str]:
    """Returns the common names of the taxels, or nothing if the layouts differ."""
    if len({(tuple(layout.taxel_ids), tuple(layout.taxel_names)) for layout in layouts}) != 1:
        return []
    return [name or f"taxel_{number}" for number, name in zip(layouts[0].taxel_ids, layouts[0].taxel_names)]


def _components(column: str, layouts: typing.Sequence[Layout]) -> list[str]:
    """Returns the names of the numbers of a column."""
    if column == batches.FORCE:
        return ["x", "y", "z"]
    if column in (batches.SENSOR_POSE, batches.MOCAP_POSE):
        return ["x", "y", "z", "qw", "qx", "qy", "qz"]
    if column in (batches.TACTILE, batches.CALIBRATED):
        return _taxels(layouts)
    if column == batches.SHEAR:
        return [f"{taxel} {axis}" for taxel in _taxels(layouts) for axis in ("e1", "e2")]
    return []


def _components_of_scene(column: str, scene: Scene) -> list[str]:
    """Returns the names of the numbers of a column of a scene."""
    if column == batches.STATE:
        return scene.state
    if column == batches.MOCAP_POSE:
        return scene.action
    if column.startswith((batches.FORCE_OF, batches.TORQUE_OF)):
        return ["x", "y", "z"]
    if column.startswith((batches.POSE_OF, batches.SENSOR_POSE_OF)):
        return ["x", "y", "z", "qw", "qx", "qy", "qz"]
    kind, layout = _sensor_of(column, scene)
    if layout is None:
        return []
    return _components(kind.removesuffix("."), [layout])


def _unit_of_scene(column: str, scene: Scene) -> str:
    units = {batches.STATE: scene.state_unit, batches.TIMESTAMP: "s"}
    if column in units:
        return units[column]
    if column.startswith(batches.FORCE_OF):
        return "N"
    if column.startswith(batches.TORQUE_OF):
        return "N m"
    kind, layout = _sensor_of(column, scene)
    return _unit(kind.removesuffix("."), [layout] if layout is not None else [])


def _sensor_of(column: str, scene: Scene) -> tuple[str, Layout | None]:
    """Returns the kind of a column of a sensor, with the dot at its end, and the layout of the sensor."""
    for kind in batches.TACTILE_OF, batches.CALIBRATED_OF, batches.SHEAR_OF:
        if column.startswith(kind):
            return kind, scene.sensors.get(column.removeprefix(kind))
    return column, None


def _unit(column: str, layouts: typing.Sequence[Layout]) -> str:
    """Returns the unit of a column, "mixed" if that of the layouts differs, or an empty text."""
    units: set[str] = set()
    if column in (batches.TACTILE, batches.SHEAR):
        units = {layout.unit for layout in layouts}
    elif column == batches.CALIBRATED:
        units = {layout.calibrated_unit for layout in layouts}
    else:
        return {batches.FORCE: "N", batches.TRAVEL: "m", batches.TIMESTAMP: "s"}.get(column, "")
    return "mixed" if len(units) > 1 else units.pop() if units else ""
