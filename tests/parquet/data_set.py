"""Reads a data set of `taxel batch` with pyarrow: data_set.py TAXEL LAYOUT. The rows are those of `taxel play`,
bit for bit, and files and columns are those of LeRobot's version 3. Exits with 77 if pyarrow is not installed."""
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import pyarrow.parquet as pq
except ImportError as error:
    print(f"skipped: {error} (scripts/setup installs pyarrow)")
    sys.exit(77)

TAXEL, LAYOUT = sys.argv[1], pathlib.Path(sys.argv[2])
PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}
LEROBOT = {"episode_index", "tasks", "length", "data/chunk_index", "data/file_index", "dataset_from_index", "dataset_to_index",
           "meta/episodes/chunk_index", "meta/episodes/file_index"}


def taxel(*arguments, folder):
    result = subprocess.run([TAXEL, *arguments, "--quiet"], cwd=folder, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr


def small_layout(folder):
    """Writes our fingertip with its first five taxels."""
    layout = json.loads(LAYOUT.read_text())
    layout["mesh"]["file"] = str((LAYOUT.parent / layout["mesh"]["file"]).resolve())
    layout["taxels"] = layout["taxels"][:5]
    (folder / "five.taxels.json").write_text(json.dumps(layout))


def write_jobs(folder, layouts):
    density = {"/layout/sampling/density": 1e5}
    lines = [{**layout, "scenario": PRESS, "set": {**density, "/scenario/depth": {"values": [0.0004, 0.0008]}}} for layout in layouts]
    (folder / "jobs.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))


def check_rows(folder, out):
    """Compares each episode with a run of its own."""
    rows = pq.read_table(out / "data").to_pylist()
    episodes = pq.read_table(out / "meta/episodes").to_pylist()
    assert LEROBOT <= set(episodes[0]), LEROBOT - set(episodes[0])
    assert [row["index"] for row in rows] == list(range(len(rows)))
    for number, episode in enumerate(episodes):
        part = rows[episode["dataset_from_index"]:episode["dataset_to_index"]]
        assert episode["episode_index"] == number and len(part) == episode["length"]
        assert all(row["episode_index"] == number and row["frame_index"] == i for i, row in enumerate(part))
        (folder / "one.json").write_text(episode["taxel/scenario"])
        layout = pq.read_table(out / "meta/layouts.parquet").to_pylist()[episode["taxel/layout"]]
        (out / "meta/one.taxels.json").write_text(layout["layout"])  # next to its mesh
        taxel("play", "one.json", "--layout", out / "meta/one.taxels.json", "--out", f"run{number}", folder=folder)
        played = np.load(folder / f"run{number}/readings.npz")
        for column, array in ("observation.tactile", "readings"), ("observation.force", "force"), ("timestamp", "time"):
            read = np.array([row[column] for row in part])
            assert read.shape == played[array].shape and read.tobytes() == played[array].tobytes(), column
        assert list(played["taxel_ids"]) == layout["taxel_ids"]
    return episodes


def check_meta(out, shape):
    info = json.loads((out / "meta/info.json").read_text())
    schema = pq.read_schema(next((out / "data").rglob("*.parquet")))
    assert list(info["features"]) == schema.names and info["codebase_version"] == "v3.0"
    assert info["features"]["observation.tactile"]["shape"] == shape
    tasks = pq.read_table(out / "meta/tasks.parquet")
    assert tasks.to_pylist() == [{"task_index": 0, "__index_level_0__": "fingertip press"}]
    assert json.loads(tasks.schema.metadata[b"pandas"])["index_columns"] == ["__index_level_0__"]
    stats = json.loads((out / "meta/stats.json").read_text())
    force = np.array([row["observation.force"] for row in pq.read_table(out / "data").to_pylist()])
    assert np.allclose(stats["observation.force"]["mean"], force.mean(0), rtol=1e-12, atol=1e-15)
    assert np.allclose(stats["observation.force"]["std"], force.std(0), rtol=1e-9, atol=1e-15)


def check_filter(out):
    """A reader finds the rows of an episode by the limits of the row groups."""
    rows = pq.read_table(out / "data", filters=[("episode_index", "==", 1)])
    assert set(rows["episode_index"].to_pylist()) == {1}


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    small_layout(work)
    for title, layouts, width in ("one", [{}], [12]), ("two", [{}, {"layout": "five.taxels.json"}], [-1]):
        write_jobs(work, layouts)
        taxel("batch", "jobs.jsonl", "--out", title, "--float64", folder=work)
        assert len(check_rows(work, work / title)) == 2 * len(layouts)
        check_meta(work / title, width)
        check_filter(work / title)
print("pyarrow reads the rows of taxel play")
