"""Tests taxel.data_set on small batches that are made here. tests/data_set runs it on batches of the program."""
import contextlib
import hashlib
import importlib.util
import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
import zipfile
from unittest import mock

import numpy as np

import taxel
import taxel.data_set
from taxel import batch_folder, data_set_tables, json_text

PYTHON = [sys.executable, *(["-S"] if sys.flags.no_site else [])]
MESH = b"v 0 0 0\n"
MESH_NAME = hashlib.sha256(MESH).hexdigest() + ".obj"
HAS_LIBRARY = importlib.util.find_spec("pyarrow") is not None


class Batch:
    """A batch whose rows are random numbers: a list of shards, each with a layout and the lengths of its episodes."""

    def __init__(self, folder, bits=32, fps=None):
        self.folder, self.bits, self.fps = pathlib.Path(folder), bits, fps
        self.rng = np.random.default_rng(7)
        self.episodes, self.layouts, self.failed, self.shards = [], [], [], 0

    def add_layout(self, taxels, unit="Pa", calibrated_unit=""):
        number = len(self.layouts)
        layout = json.dumps({"mesh": {"file": f"meshes/{MESH_NAME}"}})
        names = ["", *(f"taxel {i}" for i in range(1, taxels))]
        self.layouts.append({"key": f"key{number}", "name": f"layout {number}", "unit": unit, "calibrated_unit": calibrated_unit,
                             "taxel_ids": list(range(taxels)), "taxel_names": names, "layout": layout})
        return number

    def add_shard(self, layout, lengths, columns=(), task="press"):
        """Writes a shard, and returns its arrays. `columns` are the columns that not all batches have."""
        rows, taxels = sum(lengths), len(self.layouts[layout]["taxel_ids"])
        widths = {"observation.tactile": taxels, "observation.force": 3, "observation.calibrated": taxels,
                  "observation.shear": 2 * taxels, "observation.sensor_pose": 7, "action": 7}
        arrays = {name: self.rng.normal(0, 1, (rows, widths[name])) for name in widths
                  if name in ("observation.tactile", "observation.force", *columns)}
        time = np.concatenate([np.arange(length) * 0.01 for length in lengths])
        arrays = {name: array.astype(f"f{self.bits // 8}") for name, array in
                  {**arrays, "timestamp": time, "observation.travel": 0.1 * time}.items()}
        shard = f"shards/{self.shards:064x}.npz"
        (self.folder / "shards").mkdir(parents=True, exist_ok=True)
        np.savez_compressed(self.folder / shard, **arrays)
        with zipfile.ZipFile(self.folder / shard, "a") as archive:
            archive.writestr("head.json", "{}")
        self.shards += 1
        first = 0
        for length in lengths:
            index = len(self.episodes)
            self.episodes.append({
                "episode": index, "rows": length, "shard": shard, "first_row": first, "layout": layout, "task": task, "line": 1,
                "number": index, "seed": 2**64 - 1, "job": f"{index:064x}", "duration": 0.01 * (length - 1),
                "largest_force": 1.5, "peak": 2.5, "peak_taxel": -1, "changes": {"/scenario/depth": 0.001},
                "scenario": '{"kind": "press"}\n'})
            first += length
        return arrays

    def write(self):
        (self.folder / "meshes").mkdir(parents=True, exist_ok=True)
        (self.folder / "meshes" / MESH_NAME).write_bytes(MESH)
        (self.folder / "summary.csv").write_text("episode\n")
        for name in "episodes", "layouts", "failed":
            lines = getattr(self, name)
            if lines or name != "failed":
                (self.folder / f"{name}.jsonl").write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines))
        head = {"format": "taxel-batch", "version": 1, "program": "taxel 0.1.0, MuJoCo 4.0.1", "jobs": "0" * 64, "bits": self.bits,
                "group_size": 16, "episodes": len(self.episodes), "frames": sum(one["rows"] for one in self.episodes),
                "failed": len(self.failed), "poses": "x y z [m], then the quaternion w x y z"}
        (self.folder / "batch.json").write_text(json.dumps(head | ({"fps": self.fps} if self.fps else {})))
        return self.folder


def simple_batch(folder):
    batch = Batch(folder)
    batch.add_layout(3)
    batch.add_shard(0, [4, 2])
    batch.add_shard(0, [5])
    return batch.write()


def files_of(folder):
    """Returns the bytes of the files below data and meta, by their names."""
    files = (path for part in ("data", "meta") for path in (folder / part).rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def contents_of(folder):
    """Returns files_of() without the list of files, in which only a folder of its own has summary.csv."""
    files = files_of(folder)
    del files["meta/taxel.json"]
    return files


@unittest.skipUnless(HAS_LIBRARY, "the package pyarrow is not installed (scripts/setup installs it)")
class DataSetCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def read(self, name):
        import pyarrow.parquet

        return pyarrow.parquet.read_table(self.folder / name)

    def json(self, name):
        return json.loads((self.folder / name).read_text())

    def assert_error(self, text, call):
        with self.assertRaises(taxel.Error) as caught:
            call()
        self.assertRegex(str(caught.exception), text)


class ColumnsTest(DataSetCase):
    def test_rows_and_indices_are_those_of_the_shards(self):
        batch = Batch(self.folder, bits=64)
        batch.add_layout(3)
        shards = [batch.add_shard(0, [4, 2]), batch.add_shard(0, [5], task="slide, left")]
        taxel.data_set.write(batch.write())
        table = self.read("data")
        for name, first in shards[0].items():
            column = np.array(table[name].to_pylist())
            self.assertEqual(column.tobytes(), np.concatenate([first, shards[1][name]]).tobytes(), name)
        self.assertEqual(table["frame_index"].to_pylist(), [0, 1, 2, 3, 0, 1, 0, 1, 2, 3, 4])
        self.assertEqual(table["episode_index"].to_pylist(), [0] * 4 + [1] * 2 + [2] * 5)
        self.assertEqual(table["index"].to_pylist(), list(range(11)))
        self.assertEqual(table["task_index"].to_pylist(), [0] * 6 + [1] * 5)
        self.assertEqual(table.schema.names, ["observation.tactile", "observation.force", "observation.travel", "timestamp",
                                              "frame_index", "episode_index", "index", "task_index"])
        self.assertEqual(str(table.schema.field("observation.tactile")), "pyarrow.Field<observation.tactile: "
                         "list<element: double not null> not null>")
        info = self.json("meta/info.json")
        self.assertEqual((info["total_episodes"], info["total_frames"], info["total_tasks"], info["fps"]), (3, 11, 2, 100))
        self.assertEqual(info["features"]["observation.tactile"], {"dtype": "float64", "shape": [3], "unit": "Pa",
                                                                   "names": ["taxel_0", "taxel 1", "taxel 2"]})
        self.assertEqual(self.read("meta/tasks.parquet")["__index_level_0__"].to_pylist(), ["press", "slide, left"])

    def test_episodes_have_their_places_and_exact_texts(self):
        simple_batch(self.folder)
        lines = self.folder / "episodes.jsonl"
        lines.write_text(lines.read_text().replace('"/scenario/depth": 0.001', '"/scenario/depth":1e+15,"a":"\u00e4"'))
        taxel.data_set.write(self.folder)
        rows = self.read("meta/episodes").to_pylist()
        self.assertEqual([row["taxel/changes"] for row in rows], ['{"/scenario/depth":1e+15,"a":"\u00e4"}'] * 3)
        self.assertEqual([row["taxel/scenario"] for row in rows], ['{"kind": "press"}\n'] * 3)
        places = [[row[key] for key in ("dataset_from_index", "dataset_to_index", "taxel/row_group", "taxel/first_row")] for row in rows]
        self.assertEqual(places, [[0, 4, 0, 0], [4, 6, 0, 4], [6, 11, 1, 0]])
        self.assertEqual({row["taxel/seed"] for row in rows}, {-1})  # the bits of 2^64 - 1
        self.assertEqual([row["tasks"] for row in rows], [["press"]] * 3)

    def test_layouts_that_differ_give_lists_of_several_lengths(self):
        batch = Batch(self.folder, fps=50)
        batch.add_layout(3, calibrated_unit="V")
        batch.add_layout(2, unit="N")
        first = batch.add_shard(0, [4], columns=["observation.calibrated", "observation.shear"])
        second = batch.add_shard(1, [3])
        taxel.data_set.write(batch.write())
        features = self.json("meta/info.json")["features"]
        for name, unit in ("tactile", "mixed"), ("calibrated", "mixed"), ("shear", "mixed"):
            feature = features[f"observation.{name}"]
            self.assertEqual((feature["shape"], feature["names"], feature["unit"]), ([-1], None, unit), name)
        self.assertEqual(self.json("meta/info.json")["fps"], 50)
        table = self.read("data")
        self.assertEqual([len(row) for row in table["observation.tactile"].to_pylist()], [3] * 4 + [2] * 3)
        self.assertEqual([len(row) for row in table["observation.shear"].to_pylist()], [6] * 4 + [0] * 3)
        values = np.concatenate([first["observation.tactile"].ravel(), second["observation.tactile"].ravel()]).astype(float)
        statistics = self.json("meta/stats.json")["observation.tactile"]
        self.assertEqual((statistics["count"], statistics["min"], statistics["max"]), ([18], [values.min()], [values.max()]))
        np.testing.assert_allclose((statistics["mean"], statistics["std"]), ([values.mean()], [values.std()]), rtol=1e-12)
        self.assertEqual(self.read("meta/layouts.parquet")["taxel_ids"].to_pylist(), [[0, 1, 2], [0, 1]])

    def test_statistics_are_those_of_all_rows(self):
        batch = Batch(self.folder, bits=64)
        batch.add_layout(2)
        parts = [batch.add_shard(0, [100]) for _ in range(3)]
        taxel.data_set.write(batch.write())
        statistics = self.json("meta/stats.json")
        for name in "observation.tactile", "observation.force", "timestamp":
            rows = np.concatenate([part[name] for part in parts]).reshape(300, -1)
            found = statistics[name]
            self.assertEqual((found["min"], found["max"]), (rows.min(axis=0).tolist(), rows.max(axis=0).tolist()))
            np.testing.assert_allclose(found["mean"], rows.mean(axis=0), rtol=1e-12, atol=1e-14)
            np.testing.assert_allclose(found["std"], rows.std(axis=0), rtol=1e-12)
        self.assertEqual(statistics["task_index"]["std"], [0])

    def test_failed_jobs_alone_give_a_data_set_without_rows(self):
        batch = Batch(self.folder)
        batch.failed.append({"line": 1, "error": "broken"})
        taxel.data_set.write(batch.write())
        self.assertEqual((self.folder / "meta/failed.jsonl").read_bytes(), (self.folder / "failed.jsonl").read_bytes())
        self.assertEqual(self.json("meta/info.json")["splits"], {"train": "0:0"})
        self.assertEqual((self.read("meta/episodes").num_rows, self.json("meta/stats.json")), (0, {}))
        self.assertFalse((self.folder / "data").exists())

    def test_files_of_rows_are_limited(self):
        batch = Batch(self.folder)
        batch.add_layout(8)
        for _ in range(5):
            batch.add_shard(0, [50])
        with mock.patch.object(data_set_tables, "_MAX_FILE_BYTES", 3000):
            taxel.data_set.write(batch.write())
        names = sorted(path.name for path in (self.folder / "data/chunk-000").iterdir())
        self.assertGreater(len(names), 2)
        import pyarrow.parquet

        for row in self.read("meta/episodes").to_pylist():
            file = self.folder / f"data/chunk-000/file-{row['data/file_index']:03d}.parquet"
            group = pyarrow.parquet.ParquetFile(file).read_row_group(row["taxel/row_group"])
            self.assertEqual(set(group["episode_index"].to_pylist()), {row["episode_index"]})
        self.assertEqual(self.read("data")["index"].to_pylist(), list(range(250)))


class PublishingTest(DataSetCase):
    def setUp(self):
        super().setUp()
        self.batch = simple_batch(self.folder / "batch")

    def write(self, out=None, **options):
        taxel.data_set.write(self.batch, out and self.folder / out, **options)

    def test_other_folder_has_the_same_files_and_the_summary(self):
        fractions = []
        self.write(progress=fractions.append)
        self.write("out")
        self.assertEqual(contents_of(self.batch), contents_of(self.folder / "out"))
        self.assertEqual((self.folder / "out/summary.csv").read_text(), "episode\n")
        self.assertEqual((self.folder / "out/meta/meshes" / MESH_NAME).read_bytes(), MESH)
        self.assertEqual(fractions, [0, 0.5, 1])
        self.assertEqual({path.name for path in (self.folder / "out").iterdir()}, {"data", "meta", "summary.csv"})

    def test_complete_data_set_is_left_as_it_is(self):
        self.write()
        stamps = {path: path.stat().st_mtime_ns for path in self.batch.rglob("*") if path.is_file()}
        self.write()
        (self.batch / ".data_set").mkdir()
        (self.batch / ".data_set/files.json").write_text("[]")  # a call that was interrupted at its end
        self.write()
        self.assertFalse((self.batch / ".data_set").exists())
        self.assertEqual(stamps, {path: path.stat().st_mtime_ns for path in self.batch.rglob("*") if path.is_file()})

    def test_missing_files_are_written_again_and_changed_ones_refused(self):
        self.write("out")
        whole = files_of(self.folder / "out")
        for name in whole:
            with self.subTest(name=name):
                path = self.folder / "out" / name
                path.unlink()
                self.write("out")
                self.assertEqual(files_of(self.folder / "out"), whole)
                path.write_bytes(whole[name].replace(b"p", b"q") + b"x")
                self.assert_error(f"{path.name}.*: (is not as it was written|is not of a data set).*give another folder",
                                  lambda: self.write("out"))
                path.write_bytes(whole[name])

    def test_folders_of_something_else_are_refused(self):
        for name in "data", "meta", "summary.csv":
            with self.subTest(name=name):
                (self.folder / f"full_{name}" / name).mkdir(parents=True)
                self.assert_error(f'full_{name}: has "{name}" already', lambda: self.write(f"full_{name}"))
                self.assertEqual([path.name for path in (self.folder / f"full_{name}").iterdir()], [name])
        other = simple_batch(self.folder / "other")
        (other / "episodes.jsonl").write_text((other / "episodes.jsonl").read_text().replace("press", "slide"))
        for text in "[]", "1", '{"files": 1}', '{"files": [{"name": "a", "bytes": [], "sha256": "b"}]}':
            (self.folder / "broken/meta").mkdir(parents=True, exist_ok=True)
            (self.folder / "broken/meta/taxel.json").write_text(text)
            self.assert_error("taxel.json: is not of a data set", lambda: self.write("broken"))
        self.write("out")
        self.assert_error("taxel.json: is of another batch", lambda: taxel.data_set.write(other, self.folder / "out"))
        (self.folder / "out/data/extra.parquet").write_bytes(b"")
        self.assert_error("extra.parquet: is not of this data set", lambda: self.write("out"))
        (self.folder / "out/meta/stats.json").unlink()
        self.assert_error("extra.parquet: is not of this data set", lambda: self.write("out"))

    def test_killed_call_leaves_nothing_half_written(self):
        """The first files are moved, and then the process ends: the next call completes the data set."""
        code = ("import os, pathlib, signal, sys, taxel.data_set\n"
                "left = [int(sys.argv[2])]\n"
                "def kill(*arguments):\n"
                "    left[0] -= 1\n"
                "    if left[0] < 0: os.kill(os.getpid(), signal.SIGKILL)\n"
                "    return original(*arguments)\n"
                "original, pathlib.Path.replace = pathlib.Path.replace, kill\n"
                "taxel.data_set.write(sys.argv[1])")
        self.write()
        whole = files_of(self.batch)
        for count in 0, 1, 2, 7:
            for name in "data", "meta":
                shutil.rmtree(self.batch / name)
            with self.subTest(count=count):
                result = subprocess.run([*PYTHON, "-c", code, str(self.batch), str(count)])
                self.assertEqual(result.returncode, -signal.SIGKILL)
                self.assertFalse((self.batch / "meta/info.json").exists())
                if count % 2:
                    result = subprocess.run([*PYTHON, "-c", code, str(self.batch), "2"])  # interrupted twice
                self.write()
                self.assertEqual(files_of(self.batch), whole)
                self.assertFalse((self.batch / ".data_set").exists())

    def test_call_with_another_library_is_completed_if_it_was_interrupted(self):
        """Another version of pyarrow may write other bytes, here another level of compression: files of both are there."""
        self.write()
        (self.batch / "meta/stats.json").unlink()
        original, left = pathlib.Path.replace, [3]

        def stop(*arguments):
            left[0] -= 1
            if left[0] < 0:
                raise KeyboardInterrupt
            return original(*arguments)

        with mock.patch.object(data_set_tables, "_COMPRESSION_LEVEL", 1):
            with mock.patch.object(pathlib.Path, "replace", stop), self.assertRaises(KeyboardInterrupt):
                self.write()
            self.write()
            files = files_of(self.batch)
            self.write("out")
            self.assertEqual(contents_of(self.batch), contents_of(self.folder / "out"))
        self.write()
        self.assertEqual(files_of(self.batch), files, "it is complete")

    def test_exceptions_of_the_caller_and_errors_leave_nothing(self):
        def stop(fraction):
            raise KeyboardInterrupt
        before = sorted(self.batch.rglob("*"))
        with self.assertRaises(KeyboardInterrupt):
            self.write(progress=stop)
        self.assertEqual(sorted(self.batch.rglob("*")), before)
        with mock.patch.object(os, "fsync", side_effect=OSError(28, "No space left on device")):
            self.assert_error("cannot be written: No space left on device", self.write)
        self.assertEqual(sorted(self.batch.rglob("*")), before)

    def test_link_in_the_place_of_the_own_folder_is_refused(self):
        (self.folder / "elsewhere").mkdir()
        (self.batch / ".data_set").symlink_to(self.folder / "elsewhere")
        self.assert_error(r"\.data_set: is of something else", self.write)


class BrokenTest(DataSetCase):
    def test_broken_batches_are_named_with_the_remedy(self):
        def change(name, old, new):
            def apply(folder):
                path = folder / name
                self.assertIn(old, path.read_text())
                path.write_text(path.read_text().replace(old, new, 1))
            return apply

        def shard_with(**changes):
            def apply(folder):
                path = folder / "shards" / f"{1:064x}.npz"
                with np.load(path) as archive:
                    arrays = {name: archive[name] for name in archive.files if not name.endswith("json")}
                np.savez(path, **{name: array for name, array in (arrays | changes).items() if array is not None})
            return apply

        def damage(folder):
            path = folder / "shards" / f"{1:064x}.npz"
            content = bytearray(path.read_bytes())
            content[len(content) // 2] ^= 0xFF
            path.write_bytes(content)
        tactile = "observation.tactile"
        again = "run the same `taxel batch` command again"
        cases = [
            (lambda folder: (folder / "batch.json").unlink(), "batch.json: no such file: the folder is not of `taxel batch`"),
            (lambda folder: ((folder / "batch.json").unlink(), (folder / ".batch").mkdir()), f"batch.json: .*not finished; {again}"),
            (lambda folder: (folder / "batch.json").write_text("{"), f"batch.json: is not JSON.*{again}"),
            (change("batch.json", '"version": 1', '"version": 2'), "batch.json: /version: is 2, this package reads version 1: use"),
            (change("batch.json", '"frames": 11', '"frames": 12'), f"batch.json: /frames: is 12.*{again}"),
            (change("batch.json", '"episodes": 3', '"episodes": 2'), f"episodes.jsonl: has 3 episodes.*{again}"),
            (change("batch.json", '"bits": 32', '"bits": 64'), f"npz: .*float32, and batch.json has 64 bits: {again}"),
            (change("episodes.jsonl", '"rows": 2', '"rows": 3'), f"episodes.jsonl|npz: .*has 6 rows.*{again}"),
            (change("episodes.jsonl", '"layout": 0', '"layout": 1'), f"episodes.jsonl: line 1: is damaged.*{again}"),
            (change("episodes.jsonl", '"task": "press"', '"task": 7'), f"episodes.jsonl: line 1: /task: must be a text: {again}"),
            (change("episodes.jsonl", '"job"', '"jab"'), f"episodes.jsonl: line 1: /job: is missing: {again}"),
            (change("episodes.jsonl", "shards/", "../"), f"episodes.jsonl: line 1: is damaged.*{again}"),
            (change("episodes.jsonl", '{"episode"', '"episode"'), f"episodes.jsonl: line 1: is not JSON.*{again}"),
            (lambda folder: (folder / "layouts.jsonl").unlink(), f"layouts.jsonl: no such file: {again}"),
            (lambda folder: (folder / "shards" / f"{1:064x}.npz").unlink(), f"1.npz: no such file: {again}"),
            (damage, f"1.npz: .*is damaged.*{again}"),
            (shard_with(**{tactile: np.zeros((4, 3), np.float32)}), f"1.npz: {tactile}: has 4 rows.*{again}"),
            (shard_with(**{tactile: np.zeros((5, 2), np.float32)}), f"1.npz: {tactile}: has 2 readings.*{again}"),
            (shard_with(**{tactile: np.zeros(5, np.float32)}), f"1.npz: {tactile}: has the shape.*{again}"),
            (shard_with(**{tactile: None}), f"1.npz: {tactile}: is missing: {again}"),
            (shard_with(new=np.zeros(5, np.float32)), "1.npz: new: is no column that this package knows"),
            (change(f"meshes/{MESH_NAME}", "v 0", "v 1"), f"{MESH_NAME}: was changed.*{again}"),
            (lambda folder: (folder / "meshes" / MESH_NAME).unlink(), f"{MESH_NAME}: no such file: {again}"),
            (change("layouts.jsonl", "[0,", "[[],"), f"layouts.jsonl: line 1: /taxel_ids: must be a list of whole numbers: {again}"),
            (change("layouts.jsonl", "[0,", "[0.5,"), f"layouts.jsonl: line 1: /taxel_ids: must be a list of whole.*{again}"),
            (change("layouts.jsonl", '[""', "[null"), f"layouts.jsonl: line 1: /taxel_names: must be a list of texts: {again}"),
            (change("layouts.jsonl", "meshes/", "../"), f"layouts.jsonl: line 1: /layout: must be a layout.*{again}"),
        ]
        for number, (apply, text) in enumerate(cases):
            with self.subTest(text=text):
                folder = simple_batch(self.folder / str(number))
                apply(folder)
                self.assert_error(text, lambda: taxel.data_set.write(folder))
                self.assertFalse((folder / "data").exists() or (folder / "meta").exists() or (folder / ".data_set").exists())
        self.assert_error("absent: no such folder", lambda: taxel.data_set.write(self.folder / "absent"))

    def test_module_writes_a_data_set_or_says_why_not(self):
        folder = simple_batch(self.folder / "batch")
        self.assertEqual(taxel.data_set.main([str(folder), "--out", str(self.folder / "out")]), 0)
        self.assertTrue((self.folder / "out/meta/info.json").exists())
        messages = io.StringIO()
        with contextlib.redirect_stderr(messages):
            self.assertEqual(taxel.data_set.main([str(self.folder / "absent")]), 2)
        self.assertRegex(messages.getvalue(), "^taxel.data_set: .*absent: no such folder\n$")


class WithoutLibraryTest(unittest.TestCase):
    def test_absent_library_is_named_with_the_remedy_before_the_jobs(self):
        text = ("import sys, taxel, taxel.data_set; sys.modules['pyarrow'] = None\n"
                "for call in (lambda: taxel.data_set.write('absent'), lambda: taxel.batch([], 'out')):\n"
                "  try: call()\n"
                "  except taxel.Error as error: print(error)")
        result = subprocess.run([*PYTHON, "-c", text], capture_output=True, text=True)
        remedy = 'data_set: needs the package pyarrow: pip install "taxel-studio[data]"'
        self.assertEqual(result.stdout, f"{remedy}\n{remedy}, or data_set=False without a data set\n", result.stderr)

    def test_documents_have_one_key_on_a_line(self):
        value = {"a": [1, 2.5], "b": [[1], []], "c": {}, "d": [float("nan"), "\u00e4", None], "e": True}
        self.assertEqual(json_text.document(value), '{\n  "a": [1, 2.5],\n  "b": [\n    [1],\n    []\n  ],\n  "c": {},\n'
                                                    '  "d": [null, "\u00e4", null],\n  "e": true\n}')

    def test_rows_of_an_episode_are_read_without_the_library(self):
        with tempfile.TemporaryDirectory() as folder:
            batch = Batch(folder)
            batch.add_layout(3)
            arrays = batch.add_shard(0, [4, 2])
            read = batch_folder.BatchFolder(batch.write())
            rows = read.read_rows(list(read.episodes())[1])
            self.assertEqual(rows["observation.tactile"].tolist(), arrays["observation.tactile"][4:].tolist())


if __name__ == "__main__":
    unittest.main()
