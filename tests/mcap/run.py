"""Reads the files of taxel.mcap with the MCAP readers of PyPI. Names, units, times and all numbers are those of
readings.npz, bit for bit.

Installs the package from the build into a folder. Exits with 77 if a package of PyPI is not installed."""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from environment_of_package import package_of_arguments  # noqa: E402  tests/python

try:
    import numpy as np
    from mcap.reader import NonSeekingReader, make_reader
    from mcap_ros2.decoder import DecoderFactory
except ImportError as error:
    print(f"skipped: {error} (scripts/setup installs mcap, mcap-ros2-support, zstandard, numpy and pyarrow)")
    sys.exit(77)

package_of_arguments(["programs", "data"])
import taxel  # noqa: E402  the installed package
import taxel.mcap  # noqa: E402
import taxel.programs  # noqa: E402

LAYOUT = taxel.FINGERTIP
PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}
TYPES = {"readings": "taxel_msgs/msg/TactileReadings", "readings_error": "taxel_msgs/msg/TactileReadings",
         "calibrated": "taxel_msgs/msg/TactileReadings", "slip": "taxel_msgs/msg/TactileReadings",
         "shear_e1": "taxel_msgs/msg/TactileReadings", "shear_e2": "taxel_msgs/msg/TactileReadings",
         "force": "geometry_msgs/msg/Vector3Stamped", "uncovered_force": "geometry_msgs/msg/Vector3Stamped",
         "contact": "taxel_msgs/msg/TactileContact", "pose": "geometry_msgs/msg/PoseStamped"}


def run_program(*arguments, folder, out):
    """Runs the program taxel in `folder`. The files of the run are in its folder `out`."""
    program = [taxel.programs.path_of("taxel"), *arguments, "--out", out, "--quiet"]
    result = subprocess.run(program, cwd=folder, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr


def record(*arguments, folder, out):
    """Runs the program, and converts its folder as a user does."""
    run_program(*arguments, folder=folder, out=out)
    taxel.mcap.write(folder / out, folder / out / "readings.mcap")


def write_layout(file, changes):
    """Writes our fingertip with few samples and these changes."""
    layout = json.loads(LAYOUT.read_text())
    layout["mesh"]["file"] = str((LAYOUT.parent / layout["mesh"]["file"]).resolve())
    layout["sampling"]["density"] = 1e6
    for key, value in changes.items():
        layout[key] = {**layout.get(key, {}), **value}
    layout["taxels"][0]["name"] = ""
    file.write_text(json.dumps(layout))


class Bag:
    """The messages of a file by topic, each with its time in nanoseconds."""

    def __init__(self, path):
        with open(path, "rb") as file:
            reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
            self.header, self.summary = reader.get_header(), reader.get_summary()
            self.messages = {channel.topic: [] for channel in self.summary.channels.values()}
            times = []
            for schema, channel, message, decoded in reader.iter_decoded_messages():
                assert message.publish_time == message.log_time and message.sequence == len(self.messages[channel.topic])
                self.messages[channel.topic].append((message.log_time, decoded))
                times.append(message.log_time)
            assert times == sorted(times)
            self.attachments = {item.name: item.data for item in reader.iter_attachments()}
            self.metadata = {item.name: item.metadata for item in reader.iter_metadata()}
            file.seek(0)  # the stream reader checks the checksum of the data
            assert len(list(NonSeekingReader(file, validate_crcs=True).iter_messages())) == len(times)
        self.channels = {channel.topic: channel for channel in self.summary.channels.values()}

    def decoded(self, topic):
        return [decoded for _, decoded in self.messages[topic]]


def same_bits(read, expected, title):
    read = np.array(read, dtype=expected.dtype)
    assert read.shape == expected.shape and read.tobytes() == expected.tobytes(), title


def numbers(value):
    """Returns the numbers of a vector, point or quaternion (in the order of readings.npz, w first)."""
    return [value.w, value.x, value.y, value.z] if hasattr(value, "w") else [value.x, value.y, value.z]


def check_stamps(bag, time):
    for topic, messages in bag.messages.items():
        assert [at for at, _ in messages] == [round(t * 1e9) for t in time], topic
        for at, message in messages:
            for stamped in message.transforms if topic == "/tf" else [message]:
                assert stamped.header.stamp.sec * 10**9 + stamped.header.stamp.nanosec == at, topic


def check_statistics(bag, rows):
    statistics = bag.summary.statistics
    assert statistics.message_count == sum(len(messages) for messages in bag.messages.values())
    assert statistics.channel_message_counts == {number: rows for number in bag.summary.channels}
    assert statistics.channel_count == len(bag.summary.channels) and statistics.schema_count == len(bag.summary.schemas)
    assert statistics.chunk_count == len(bag.summary.chunk_indexes) >= 1
    assert statistics.attachment_count == len(bag.attachments) and statistics.metadata_count == len(bag.metadata)
    times = [at for messages in bag.messages.values() for at, _ in messages]
    assert (statistics.message_start_time, statistics.message_end_time) == (min(times), max(times))


def check_values(bag, npz, prefix, topic, array, unit):
    """Checks the values of all taxels, and their names and unit."""
    messages = bag.decoded(topic)
    same_bits([message.values for message in messages], array, topic)
    names = [name or f"taxel_{number}" for name, number in zip(npz[prefix + "taxel_names"], npz[prefix + "taxel_ids"])]
    for message in messages:
        assert list(message.ids) == list(npz[prefix + "taxel_ids"]) and message.names == names, topic
        assert message.unit == unit and message.header.frame_id == topic.split("/")[2], topic
    assert bag.channels[topic].metadata["values.unit"] == unit, topic


def check_sensor(bag, npz, geom, sensor):
    """Checks all topics of one sensor and returns their names."""
    prefix = geom + "/" if len(npz["sensor_geoms"]) > 1 else ""
    begin = f"/taxel/{sensor}/"
    unit = str(npz[prefix + "readings_unit"])
    topics = {"readings", "force", "contact", "pose"}
    check_values(bag, npz, prefix, begin + "readings", npz[prefix + "readings"], unit)
    if prefix + "readings_error" in npz:
        topics.add("readings_error")
        check_values(bag, npz, prefix, begin + "readings_error", npz[prefix + "readings_error"], unit)
    if prefix + "calibrated" in npz:
        topics.add("calibrated")
        check_values(bag, npz, prefix, begin + "calibrated", npz[prefix + "calibrated"], str(npz[prefix + "calibrated_unit"]))
    for axis in (0, 1) if prefix + "shear" in npz else ():
        topics.add(f"shear_e{axis + 1}")
        check_values(bag, npz, prefix, begin + f"shear_e{axis + 1}", npz[prefix + "shear"][:, :, axis].copy(), unit)
    if prefix + "slip" in npz:
        topics.add("slip")
        check_values(bag, npz, prefix, begin + "slip", npz[prefix + "slip"], "1")
    same_bits([numbers(message.vector) for message in bag.decoded(begin + "force")], npz[prefix + "force"], "force")
    assert bag.channels[begin + "force"].metadata["vector.unit"] == "N"
    if prefix + "uncovered" in npz:
        topics.add("uncovered_force")
        same_bits([numbers(m.vector) for m in bag.decoded(begin + "uncovered_force")], npz[prefix + "uncovered"], "uncovered")
    contact = bag.decoded(begin + "contact")
    for field, array in ("time", "time"), ("travel", "travel"), ("area", prefix + "area"), ("polygons", prefix + "polygons"):
        same_bits([getattr(message, field) for message in contact], npz[array], field)
    poses = bag.decoded(begin + "pose")
    same_bits([numbers(message.pose.position) for message in poses], npz[prefix + "sensor_pos"], "pose")
    same_bits([numbers(message.pose.orientation) for message in poses], npz[prefix + "sensor_quat"], "pose")
    assert {message.header.frame_id for message in poses} == {"world"}
    layout = bag.attachments[bag.metadata["taxel/" + sensor]["layout"]]
    assert layout.decode() == str(npz[prefix + "layout"]) and bag.metadata["taxel/" + sensor]["geom"] == geom
    return {begin + topic for topic in topics}


def check_transforms(bag, npz, frames, has_mocap):
    """Checks the frames of all objects, and of the mocap body, if the run moves one."""
    for row, message in enumerate(bag.decoded("/tf")):
        found = {item.child_frame_id: item.transform for item in message.transforms}
        assert list(found) == frames + (["mocap"] if has_mocap else []), list(found)
        for number, name in enumerate(frames[len(npz["sensor_geoms"]):]):
            same_bits(numbers(found[name].translation), npz["object_pos"][row, number], name)
            same_bits(numbers(found[name].rotation), npz["object_quat"][row, number], name)
        if has_mocap:
            same_bits(numbers(found["mocap"].translation), npz["mocap_pos"][npz["step"][row]], "mocap")


def check_bag(folder, sensors, objects, has_mocap=True):
    """Compares readings.mcap with readings.npz. `sensors` has the name in topics of each geom."""
    bag, npz = Bag(folder / "readings.mcap"), np.load(folder / "readings.npz")
    assert bag.header.profile == "ros2" and bag.header.library.startswith("taxel "), bag.header
    topics = {"/tf"}
    for geom, sensor in sensors.items():
        topics |= check_sensor(bag, npz, geom, sensor)
    assert set(bag.messages) == topics, set(bag.messages) ^ topics
    for topic, channel in bag.channels.items():
        schema = bag.summary.schemas[channel.schema_id]
        assert schema.name == ("tf2_msgs/msg/TFMessage" if topic == "/tf" else TYPES[topic.split("/")[-1]])
        assert schema.encoding == "ros2msg" and channel.message_encoding == "cdr"
        assert "offered_qos_profiles" in channel.metadata
    check_transforms(bag, npz, [*sensors.values(), *objects], has_mocap)
    check_stamps(bag, npz["time"])
    check_statistics(bag, len(npz["time"]))
    return bag, npz


def check_plays(folder):
    """A scenario around layouts with each kind of values."""
    (folder / "press.json").write_text(json.dumps(PRESS))
    kinds = {"plain": {}, "calibrated": {"calibration": {"gain": 0.001, "unit": "V", "noise": 0.01}},
             "sticking": {"material": {"tangential_stiffness": 2e8}},
             "force": {"readout": {"aggregate": "force", "shear": True}}}
    for kind, changes in kinds.items():
        write_layout(folder / "layout.json", changes)
        record("play", "press.json", "--layout", "layout.json", "--error-bars", folder=folder, out=kind)
        bag, npz = check_bag(folder / kind, {"finger": "finger"}, ["box"])
        assert npz["readings"].max() > 0, "the press touches nothing"
        assert 0 < npz["readings_error"].max() < npz["readings"].max(), "the error bars are not of these readings"
        assert ("slip" in npz) == (kind == "sticking"), "slip is recorded if and only if friction sticks"
        assert kind != "sticking" or 0 < npz["slip"].max() <= 1, "nothing slips"
        assert bag.attachments["scenario.json"] == (folder / kind / "scenario.json").read_bytes()
        assert bag.metadata["taxel"]["program"] == bag.header.library and bag.metadata["taxel"]["timestep"] == "0.001"
    play = ("play", "press.json", "--layout", "layout.json")
    record(*play, folder=folder, out="force")
    first = (folder / "force/readings.mcap").read_bytes()
    record(*play, folder=folder, out="force")
    assert first == (folder / "force/readings.mcap").read_bytes(), "the same run has other bytes"
    run_program(*play, folder=folder, out="force")
    assert not (folder / "force/readings.mcap").exists(), "a file of an older run is left"


def check_sweep(folder):
    """A long recording has several chunks."""
    taxel.sweep(out=folder / "sweep", density=1e6, record_every=1e-5, mcap=True)
    bag, npz = check_bag(folder / "sweep", {"finger": "finger"}, ["box"])
    assert bag.summary.statistics.chunk_count > 1
    assert bag.attachments["sweep.json"] == (folder / "sweep/sweep.json").read_bytes()
    with open(folder / "sweep/readings.mcap", "rb") as file:  # a part of the time, found by the index
        late = int(npz["time"][-10] * 1e9) - 1
        part = list(make_reader(file).iter_messages(topics=["/taxel/finger/force"], starting_at=late))
    assert len(part) == 10


def check_module(folder):
    """`python -m taxel.mcap` writes the file of `mcap=True`."""
    taxel.sweep(out=folder / "sweep", density=1e6, mcap=True)
    at_once = (folder / "sweep/readings.mcap").read_bytes()
    (folder / "sweep/readings.mcap").unlink()
    taxel.mcap.main([str(folder / "sweep"), str(folder / "sweep/readings.mcap")])
    assert (folder / "sweep/readings.mcap").read_bytes() == at_once, "the converted file differs"


def check_run(folder):
    """Names of geoms that ROS does not accept, two sensors, and no mocap body."""
    write_layout(folder / "layout.json", {})
    layout = json.loads((folder / "layout.json").read_text())
    fingers = "".join(f"""<body pos="{x} 0 0.05"><freejoint/><geom name="{name}" type="mesh" mesh="finger" mass="0.02"/></body>"""
                      for x, name in ((0, "left tip"), (0.1, "left/tip")))
    sensors = "".join(f"""<plugin name="{name}" plugin="taxel.sensor" objtype="geom" objname="{name}">
        <config key="layout" value="layout.json"/></plugin>""" for name in ("left tip", "left/tip"))
    (folder / "scene.xml").write_text(f"""<mujoco><extension><plugin plugin="taxel.sensor"/></extension>
        <asset><mesh name="finger" file="{layout['mesh']['file']}"/></asset>
        <worldbody><geom name="3 floor" type="plane" size="1 1 0.1"/>{fingers}</worldbody>
        <sensor>{sensors}</sensor></mujoco>""")
    record("run", "scene.xml", "--seconds", "0.1", folder=folder, out="run")
    check_bag(folder / "run", {"left tip": "left_tip", "left/tip": "left_tip_2"}, ["geom_3_floor"], has_mocap=False)


def check_batch(folder):
    """Each run of a batch is a file, with the rows of its NPZ. The same call writes what is missing, and nothing else."""
    write_layout(folder / "layout.json", {})
    job = {"layout": folder / "layout.json", "scenario": PRESS, "set": {"/scenario/depth": {"values": [0.0004, 0.0008]}}}
    taxel.batch([job], folder / "data", mcap=True)
    runs = sorted((folder / "data/runs").glob("*.mcap"))
    assert len(runs) == 2 and len(list((folder / "data/runs").iterdir())) == 4
    first, stamp = runs[0].read_bytes(), runs[1].stat().st_mtime_ns
    runs[0].unlink()
    taxel.batch([job], folder / "data", mcap=True)
    assert runs[0].read_bytes() == first and runs[1].stat().st_mtime_ns == stamp
    for number, run in enumerate(runs):
        one = folder / f"one{number}"
        one.mkdir()
        run.rename(one / "readings.mcap")
        run.with_suffix(".npz").rename(one / "readings.npz")
        bag, _ = check_bag(one, {"finger": "finger"}, ["box"])
        assert json.loads(bag.attachments["scenario.json"])["kind"] == "press"


with tempfile.TemporaryDirectory() as name:
    for check in (check_plays, check_sweep, check_module, check_run, check_batch):
        work = pathlib.Path(name) / check.__name__
        work.mkdir()
        check(work)
print("the readers of PyPI read the numbers of readings.npz")
