"""Joins batches of the program into data sets and reads them with pyarrow. The rows are those of `taxel play`, bit for
bit, files and columns are those of LeRobot's version 3, and each episode is played again.

Installs the package from the build into a folder. Exits with 77 if pyarrow is not installed."""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))
from environment_of_package import package_of_arguments  # noqa: E402  tests/python

try:
    import numpy as np
    import pyarrow.parquet as pq
except ImportError as error:
    print(f"skipped: {error} (scripts/setup installs pyarrow)")
    sys.exit(77)

package_of_arguments(["programs", "data"])
import taxel  # noqa: E402  the installed package
import taxel.data_set  # noqa: E402
import taxel.programs  # noqa: E402

LAYOUT = taxel.FINGERTIP
PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}
LEROBOT = {"episode_index", "tasks", "length", "data/chunk_index", "data/file_index", "dataset_from_index", "dataset_to_index",
           "meta/episodes/chunk_index", "meta/episodes/file_index"}


def run_program(*arguments, folder):
    command = [taxel.programs.path_of("taxel"), *arguments, "--quiet"]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True)
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
        run_program("play", "one.json", "--layout", out / "meta/one.taxels.json", "--out", f"run{number}", folder=folder)
        (out / "meta/one.taxels.json").unlink()
        played = np.load(folder / f"run{number}/readings.npz")
        for column, array in ("observation.tactile", "readings"), ("observation.force", "force"), ("timestamp", "time"):
            read = np.array([row[column] for row in part])
            assert read.shape == played[array].shape and read.tobytes() == played[array].tobytes(), column
        assert list(played["taxel_ids"]) == layout["taxel_ids"]
    return episodes


def check_run(out, folder, has_all_rows):
    """An episode becomes a run that is read again, and one that differs from its rows is refused."""
    taxel.data_set.write_run(out, 1, folder / "again")
    readings = taxel.Recording.read(folder / "again").sensors[0].readings
    rows = pq.read_table(out / "data", filters=[("episode_index", "==", 1)])
    recorded = rows["observation.tactile"].combine_chunks().flatten().to_numpy()
    assert not has_all_rows or np.array_equal(readings.ravel().astype(recorded.dtype), recorded)
    episodes = out / "episodes.jsonl"
    text = episodes.read_text()
    lines = [json.loads(line) for line in text.splitlines()]
    lines[1]["scenario"] = lines[0]["scenario"]  # of another depth
    episodes.write_text("".join(json.dumps(line) + "\n" for line in lines))
    try:
        taxel.data_set.write_run(out, 1, folder / "other")
    except taxel.Error as error:
        assert "episode 1: " in str(error) and "the batch was written by taxel" in str(error), error
    else:
        raise AssertionError("a run with other readings is accepted")
    assert not (folder / "other").exists()
    episodes.write_text(text)


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
    cases = [("one", [{}], [12], ["--float64"]), ("two", [{}, {"layout": "five.taxels.json"}], [-1], ["--float64"]),
             ("rounded", [{}], [12], []), ("resampled", [{}], [12], ["--fps", "50"])]
    for title, layouts, width, options in cases:
        (work / title).mkdir()
        write_jobs(work, layouts)
        run_program("batch", "jobs.jsonl", "--out", work / title / "data", *options, folder=work)
        taxel.data_set.write(work / title / "data")
        if options == ["--float64"]:
            assert len(check_rows(work / title, work / title / "data")) == 2 * len(layouts)
            check_meta(work / title / "data", width)
        check_filter(work / title / "data")
        check_run(work / title / "data", work / title, has_all_rows="--fps" not in options)
print("pyarrow reads the rows of taxel play")
