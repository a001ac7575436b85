"""Recorded runs as MCAP files of ROS 2 messages, for Foxglove and other readers (docs/mcap.md).

    python -m taxel.mcap result result.mcap          # result: a folder of taxel play, sweep or run

    import taxel.mcap
    taxel.mcap.write("result", "result.mcap")

Needs the package mcap: pip install "taxel-studio[mcap]".

All messages of a topic have the same length: frames, names and ids do not change, and the numbers of each row are at
the same places. So a topic has one template of bytes, and NumPy writes the numbers of many rows into copies of the
template. The package mcap makes the file: records, compressed chunks, indices and checksums.
"""

from __future__ import annotations

import contextlib
import dataclasses
import json
import os
import pathlib
import re
import struct
import sys
import typing

import numpy as np

from taxel import _core
from taxel.errors import Error

Path = typing.Union[str, "os.PathLike[str]"]
Arrays = typing.Mapping[str, typing.Any]

_WORLD = "world"
_MOCAP = "mocap"
_SHARE = "1"  # the unit of a share from 0 to 1
_ROWS_AT_ONCE = 1000  # rows whose messages are in memory; more rows at once are not faster
_MAX_SECONDS = 2**31 - 1  # builtin_interfaces/Time has seconds of 32 bits
_RUN_FILES = ("scenario.json", "sweep.json")

# Fields of the types of messages. A type is listed after all types that use it. Names and types of the fields are those
# of ROS 2 where the package is one of ROS 2. taxel_msgs is ours.
_DEFINITIONS = {
    "taxel_msgs/TactileReadings": """\
# Values of all taxels of one sensor at one time.
# The time since the start of the run, and the frame of the sensor's mesh.
std_msgs/Header header
# Name of the sensor's geom in the scene.
string sensor
# Unit of the values, such as Pa or N.
string unit
# Ids of the taxels in the layout, in the order of the values.
int32[] ids
# Names of the taxels; taxel_ID for a taxel without a name.
string[] names
float64[] values
""",
    "taxel_msgs/TactileContact": """\
# The contact of one sensor at one time.
std_msgs/Header header
# Time since the start of the run, not rounded to nanoseconds [s].
float64 time
# Distance that the mocap body has moved [m].
float64 travel
# Area of the contact surfaces [m^2].
float64 area
# Number of polygons of the contact surfaces.
uint32 polygons
""",
    "geometry_msgs/Vector3Stamped": "std_msgs/Header header\ngeometry_msgs/Vector3 vector\n",
    "geometry_msgs/PoseStamped": "std_msgs/Header header\ngeometry_msgs/Pose pose\n",
    "tf2_msgs/TFMessage": "geometry_msgs/TransformStamped[] transforms\n",
    "geometry_msgs/TransformStamped": """\
std_msgs/Header header
string child_frame_id
geometry_msgs/Transform transform
""",
    "geometry_msgs/Transform": "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n",
    "geometry_msgs/Pose": "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
    "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z\n",
    "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z\n",
    "geometry_msgs/Quaternion": "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n",
    "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id\n",
    "builtin_interfaces/Time": "int32 sec\nuint32 nanosec\n",
}


def write(folder: Path, file: Path) -> None:
    """Writes the recording of a run as an MCAP file of ROS 2 messages.

    `folder` is a folder of `taxel sweep`, `play` or `run`, or its readings.npz. Each row of the recording is a message
    on each topic (docs/mcap.md lists them), with all numbers of readings.npz, bit for bit, in SI units. The times of
    the messages are rounded to nanoseconds. Layouts are attachments, and so is scenario.json or sweep.json of the
    folder, the newer one if there are both. Without either, as for an .npz file of another name, the file has no
    scenario, and the version of this package instead of that of the run.

    `file` is replaced by the finished file, or stays as it is. Equal folders give equal bytes. Raises Error that names
    the file and the field if the recording is broken, if a time is not 0 to 2147483647 s, if `file` cannot be written,
    or if the package mcap is not installed.
    """
    check_library()
    run_file = _run_file(folder)
    notes = RunNotes(f"taxel {_core.__version__}") if run_file is None else _read_notes(run_file)
    write_with_notes(folder, file, notes)


@dataclasses.dataclass(frozen=True)
class RunNotes:
    """Facts about a run that its readings.npz does not hold."""

    program: str  #: versions of the program and of MuJoCo
    file_name: str = ""  #: name of a JSON file about the run, such as scenario.json; empty without one
    file_bytes: bytes = b""  #: content of this file


def write_with_notes(recording: Path, file: Path, notes: RunNotes) -> None:
    """Writes a recording, a folder or an .npz file, as write() does, with these notes. Raises the errors of write()."""
    path = pathlib.Path(_core.Recording.read(recording).file)  # names the broken array of a file, and its rule
    with np.load(path, allow_pickle=False) as archive:
        arrays = {name: archive[name] for name in archive.files}
    times = _nanoseconds(arrays["time"], str(path))
    target = pathlib.Path(os.path.realpath(file))  # a link stays a link
    temporary = target.with_name(f".{target.name}.{os.getpid()}.tmp")
    try:
        with temporary.open("xb") as stream:
            _write_records(stream, arrays, times, notes)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.replace(target)
    except OSError as error:
        raise Error(os.fspath(file), "", f"cannot be written: {error.strerror or error}") from error
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink()


def check_library() -> None:
    """Raises Error with the remedy if the package mcap, or Zstandard, is not installed."""
    try:
        import mcap.writer  # noqa: F401
        import zstandard  # noqa: F401
    except ModuleNotFoundError as error:
        package = str(error.name).partition(".")[0]
        raise Error("", "mcap", f'needs the package {package}: pip install "taxel-studio[mcap]"') from error


def _run_file(recording: Path) -> pathlib.Path | None:
    """Returns the newest file about the run next to readings.npz, or None if there is none."""
    path = pathlib.Path(recording)
    if not path.is_dir() and path.name != "readings.npz":
        return None
    folder = path if path.is_dir() else path.parent
    files = [folder / name for name in _RUN_FILES if (folder / name).is_file()]
    return max(files, key=lambda found: found.stat().st_mtime_ns, default=None)


def _read_notes(file: pathlib.Path) -> RunNotes:
    try:
        content = file.read_bytes()
        run = json.loads(content)
    except OSError as error:
        raise Error(str(file), "", f"cannot be read: {error.strerror or error}") from error
    except ValueError as error:
        raise Error(str(file), "", f"is not JSON: {error}") from error
    versions = run.get("versions") if isinstance(run, dict) else None
    if not isinstance(versions, dict):
        raise Error(str(file), "/versions", "must be an object")
    for key in "taxel", "mujoco":
        if not isinstance(versions.get(key), str):
            raise Error(str(file), f"/versions/{key}", "must be a text")
    return RunNotes(f"taxel {versions['taxel']}, MuJoCo {versions['mujoco']}", file.name, content)


def _nanoseconds(time: typing.Any, file: str) -> typing.Any:
    """Returns times [s], shape (rows,), as whole nanoseconds, with halves rounded up.

    Raises Error if ROS has no stamp for a time.
    """
    for value in time[~((time >= 0) & (time < _MAX_SECONDS))][:1]:
        raise Error(file, "time", f"must be 0 to {_MAX_SECONDS} s in a message of ROS 2, is {_number_text(value)} s")
    exact = time * 1e9
    whole = np.floor(exact)
    return (whole + (exact - whole >= 0.5)).astype(np.int64)


def _number_text(value: float) -> str:
    """Returns the shortest text of a number: 1, 0.001, 1e-05."""
    return repr(float(value)).removesuffix(".0")


class _FrameNames:
    """Gives each name a part of a topic that ROS 2 accepts and no other name has.

    It has letters, digits and single underscores, and begins with a letter.
    """

    def __init__(self) -> None:
        self._taken: set[str] = set()

    def add(self, name: str) -> str:
        """Returns "thumb_tip" for "thumb tip", and "thumb_tip_2" if that is taken; "geom_3" for "3"; "geom" for ""."""
        base = re.sub("[^A-Za-z0-9]+", "_", name).strip("_") or "geom"
        base = f"geom_{base}" if base[0].isdigit() else base
        chosen, number = base, 2
        while chosen in self._taken:
            chosen, number = f"{base}_{number}", number + 1
        self._taken.add(chosen)
        return chosen


def _definition(kind: str) -> str:
    """Returns the definition of a type as the schema encoding "ros2msg" has it.

    The fields come first, then the definition of each type that they use, after a line of 80 "=" and a line with its
    name.
    """
    used, text = [kind], _DEFINITIONS[kind]
    for name, fields in _DEFINITIONS.items():
        if any(re.search(rf"^{name}(\[\])? ", _DEFINITIONS[user], re.MULTILINE) for user in used):
            used.append(name)
            text += "=" * 80 + f"\nMSG: {name}\n{fields}"
    return text


class _Template:
    """The bytes of a topic's messages, with gaps for the numbers of each row.

    The encoding is plain CDR, little endian (OMG, DDS-RTPS 2.3): each number begins at a multiple of its size after the
    head of four bytes.
    """

    def __init__(self) -> None:
        self._bytes = bytearray(b"\0\1\0\0")
        self._columns: list[tuple[int, typing.Any]] = []

    def _align(self, size: int) -> None:
        self._bytes += bytes(-(len(self._bytes) - 4) % size)

    def add_count(self, count: int) -> None:
        """Appends a number of elements, which is the same in all rows."""
        self._align(4)
        self._bytes += struct.pack("<I", count)

    def add_text(self, text: str) -> None:
        """Appends a text with its length and a closing zero."""
        encoded = text.encode()
        self.add_count(len(encoded) + 1)
        self._bytes += encoded + b"\0"

    def add_texts(self, texts: typing.Sequence[str]) -> None:
        self.add_count(len(texts))
        for text in texts:
            self.add_text(text)

    def add_ids(self, ids: typing.Any) -> None:
        """Appends a list of int32, shape (n,), which is the same in all rows."""
        self.add_count(len(ids))
        self._bytes += np.asarray(ids, "<i4").tobytes()

    def add_column(self, values: typing.Any, kind: str = "<f8") -> None:
        """Appends the numbers of each row, shape (rows,) or (rows, k), in the type `kind` of NumPy."""
        column = np.ascontiguousarray(values, kind).reshape(len(values), -1)
        if column.shape[1] == 0:  # a list without elements has no padding
            return
        self._align(column.itemsize)
        self._columns.append((len(self._bytes), column))
        self._bytes += bytes(column.itemsize * column.shape[1])

    def add_header(self, times: typing.Any, frame: str) -> None:
        """Appends std_msgs/Header: times in nanoseconds, shape (rows,), and a frame."""
        self.add_column(times // 10**9, "<i4")
        self.add_column(times % 10**9, "<u4")
        self.add_text(frame)

    def add_pose(self, positions: typing.Any, quaternions: typing.Any) -> None:
        """Appends geometry_msgs/Pose or Transform, whose quaternions are x y z w.

        Shapes are (rows, 3) for positions and (rows, 4) for quaternions w x y z.
        """
        self.add_column(positions)
        self.add_column(np.asarray(quaternions)[:, [1, 2, 3, 0]])

    def messages(self, rows: slice) -> list[bytes]:
        """Returns the messages of these rows."""
        count = len(range(*rows.indices(len(self._columns[0][1]))))
        table = np.tile(np.frombuffer(bytes(self._bytes), np.uint8), (count, 1))
        for begin, column in self._columns:
            numbers = column[rows].view(np.uint8)
            table[:, begin : begin + numbers.shape[1]] = numbers
        joined, size = table.tobytes(), len(self._bytes)
        return [joined[i : i + size] for i in range(0, len(joined), size)]


@dataclasses.dataclass(frozen=True)
class _Topic:
    name: str
    kind: str  #: key of _DEFINITIONS
    units: dict[str, str]  #: unit of each field
    template: _Template


def _valid_text(value: typing.Any) -> str:
    """Returns a text of an archive with "?" for each code point that UTF-8 does not have."""
    return str(value).encode("utf-8", "replace").decode()


class _Sensor:
    """One sensor of a recording: its arrays, and the name that topics and frames have for it."""

    def __init__(self, arrays: Arrays, geom: str, prefix: str, frame: str) -> None:
        self._arrays = arrays
        self._prefix = prefix
        self.geom = geom
        self.frame = frame
        self.ids = self["taxel_ids"]
        names = [_valid_text(name) for name in self["taxel_names"]]
        self.names = [name or f"taxel_{number}" for name, number in zip(names, self.ids)]
        if "readings_unit" in self:
            self.unit = _valid_text(self["readings_unit"])
        else:  # recordings of versions that had one unit for all sensors
            (self.unit,) = re.findall('"readings": "([^"]*)', str(arrays["units"]))[:1]

    def __contains__(self, name: str) -> bool:
        return self._prefix + name in self._arrays

    def __getitem__(self, name: str) -> typing.Any:
        return self._arrays[self._prefix + name]

    def metadata(self) -> dict[str, str]:
        seed = int(self["seed"]) % 2**64  # the archive has the bits of an unsigned number as a signed one
        layout = f"{self.frame}.taxels.json"
        facts = {"geom": self.geom, "layout": layout, "readings.unit": self.unit, "seed": str(seed)}
        if "calibrated_unit" in self:
            facts["calibrated.unit"] = _valid_text(self["calibrated_unit"])
        return facts

    def topics(self, times: typing.Any) -> typing.Iterator[_Topic]:
        """Yields the topics of the sensor in the order of their messages. `times` are in nanoseconds, shape (rows,)."""
        if len(self.ids) > 0:
            yield self._values("readings", self["readings"], self.unit, times)
        if "readings_error" in self:
            yield self._values("readings_error", self["readings_error"], self.unit, times)
        if "calibrated_unit" in self:
            yield self._values("calibrated", self["calibrated"], _valid_text(self["calibrated_unit"]), times)
        if "shear" in self:
            for axis in (0, 1):
                yield self._values(f"shear_e{axis + 1}", self["shear"][:, :, axis], self.unit, times)
        if "slip" in self:
            yield self._values("slip", self["slip"], _SHARE, times)
        yield self._force("force", self["force"], times)
        if "uncovered" in self:
            yield self._force("uncovered_force", self["uncovered"], times)
        yield self._contact(times)
        pose = _Template()
        pose.add_header(times, _WORLD)
        pose.add_pose(self["sensor_pos"], self["sensor_quat"])
        units = {"pose.position.unit": "m", "pose.orientation.unit": "1"}
        yield _Topic(self._topic("pose"), "geometry_msgs/PoseStamped", units, pose)

    def _topic(self, name: str) -> str:
        return f"/taxel/{self.frame}/{name}"

    def _values(self, name: str, values: typing.Any, unit: str, times: typing.Any) -> _Topic:
        template = _Template()
        template.add_header(times, self.frame)
        template.add_text(self.geom)
        template.add_text(unit)
        template.add_ids(self.ids)
        template.add_texts(self.names)
        template.add_count(len(self.ids))
        template.add_column(values)
        return _Topic(self._topic(name), "taxel_msgs/TactileReadings", {"values.unit": unit}, template)

    def _force(self, name: str, values: typing.Any, times: typing.Any) -> _Topic:
        template = _Template()
        template.add_header(times, _WORLD)
        template.add_column(values)
        return _Topic(self._topic(name), "geometry_msgs/Vector3Stamped", {"vector.unit": "N"}, template)

    def _contact(self, times: typing.Any) -> _Topic:
        template = _Template()
        template.add_header(times, self.frame)
        for column in self._arrays["time"], self._arrays["travel"], self["area"]:
            template.add_column(column)
        template.add_column(self["polygons"], "<u4")
        units = {"time.unit": "s", "travel.unit": "m", "area.unit": "m^2", "polygons.unit": "1"}
        return _Topic(self._topic("contact"), "taxel_msgs/TactileContact", units, template)


def _transforms(sensors: typing.Sequence[_Sensor], objects: typing.Sequence[str], arrays: Arrays,
                times: typing.Any) -> _Topic:
    """Returns the topic /tf: the frames of all sensors and objects, and of the mocap body if the run moves one."""
    frames = [(sensor.frame, sensor["sensor_pos"], sensor["sensor_quat"]) for sensor in sensors]
    for number, name in enumerate(objects):
        frames.append((name, arrays["object_pos"][:, number], arrays["object_quat"][:, number]))
    # A run without a mocap body has the identity in each step.
    if (arrays["mocap_pos"] != 0).any() or (arrays["mocap_quat"] != [1, 0, 0, 0]).any():
        frames.append((_MOCAP, arrays["mocap_pos"][arrays["step"]], arrays["mocap_quat"][arrays["step"]]))
    template = _Template()
    template.add_count(len(frames))
    for name, positions, quaternions in frames:
        template.add_header(times, _WORLD)
        template.add_text(name)
        template.add_pose(positions, quaternions)
    return _Topic("/tf", "tf2_msgs/TFMessage", {"translation.unit": "m", "rotation.unit": "1"}, template)


def _write_records(stream: typing.BinaryIO, arrays: Arrays, times: typing.Any, notes: RunNotes) -> None:
    """Writes the whole file. `times` are those of the rows in nanoseconds, shape (rows,)."""
    from mcap.writer import Writer

    names = _FrameNames()
    for own in _WORLD, _MOCAP:
        names.add(own)
    geoms = [_valid_text(geom) for geom in arrays["sensor_geoms"]]
    sensors = [_Sensor(arrays, geom, f"{raw}/" if len(geoms) > 1 else "", names.add(geom))
               for geom, raw in zip(geoms, arrays["sensor_geoms"])]
    objects = [names.add(str(name)) for name in arrays["object_names"]]
    writer = Writer(stream, enable_data_crcs=True)
    writer.start("ros2", notes.program)
    _write_notes(writer, sensors, _number_text(arrays["timestep"]), notes)
    topics = [topic for sensor in sensors for topic in sensor.topics(times)]
    topics.append(_transforms(sensors, objects, arrays, times))
    channels = _add_channels(writer, topics)
    stamps = times.tolist()
    for begin in range(0, len(stamps), _ROWS_AT_ONCE):
        rows = slice(begin, begin + _ROWS_AT_ONCE)
        columns = [topic.template.messages(rows) for topic in topics]
        for row, messages in enumerate(zip(*columns), begin):
            for channel, message in zip(channels, messages):
                writer.add_message(channel, stamps[row], message, stamps[row], row)
    writer.finish()


def _write_notes(writer: typing.Any, sensors: typing.Sequence[_Sensor], timestep: str, notes: RunNotes) -> None:
    """Writes metadata and attachments. They come first, so that a reader of a stream knows them before the messages."""
    run = {"program": notes.program, "timestep": timestep, "timestep.unit": "s", "time": "since the start of the run"}
    writer.add_metadata("taxel", run)
    for sensor in sensors:
        facts = sensor.metadata()
        writer.add_metadata(f"taxel/{sensor.frame}", facts)
        writer.add_attachment(0, 0, facts["layout"], "application/json", _valid_text(sensor["layout"]).encode())
    if notes.file_name:
        writer.add_attachment(0, 0, notes.file_name, "application/json", notes.file_bytes)


def _add_channels(writer: typing.Any, topics: typing.Sequence[_Topic]) -> list[int]:
    """Adds the types of messages and the channels, and returns the numbers of the channels, parallel to `topics`."""
    schemas: dict[str, int] = {}
    channels = []
    for topic in topics:
        if topic.kind not in schemas:
            name = topic.kind.replace("/", "/msg/")
            schemas[topic.kind] = writer.register_schema(name, "ros2msg", _definition(topic.kind).encode())
        # The profile "ros2" requires the quality of service, which a recording does not have.
        metadata = {**topic.units, "offered_qos_profiles": ""}
        channels.append(writer.register_channel(topic.name, "cdr", schemas[topic.kind], metadata))
    return channels


def main(arguments: typing.Sequence[str]) -> int:
    """Runs `python -m taxel.mcap` with these arguments, and returns its exit status: 0, or 2 after an error."""
    usage = ("usage: python -m taxel.mcap FOLDER FILE.mcap\n"
             "Writes the recording of a run as ROS 2 messages (docs/mcap.md).")
    if list(arguments) in (["-h"], ["--help"]):
        print(usage)
        return 0
    if len(arguments) != 2:
        print(usage, file=sys.stderr)
        return 2
    folder, file = arguments
    try:
        if not file.endswith(".mcap"):  # swapped arguments must not replace a recording
            raise Error(file, "", "must end in .mcap")
        write(folder, file)
    except Error as error:
        print(f"taxel.mcap: {error}", file=sys.stderr)
        return 2
    if _run_file(folder) is None:
        print(f"taxel.mcap: note: no {' or '.join(_RUN_FILES)} is next to the recording: {file} has the version of "
              "this package, and no scenario", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
