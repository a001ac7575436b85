"""Tests taxel.batch on a local Ray cluster with two actors, some of which are killed."""
import collections
import json
import os
import pathlib
import shutil
import signal
import tempfile
import unittest
from unittest import mock

import ray

import taxel
from taxel import batch_process, programs

COUNT = int(os.environ["TAXEL_RAY_JOBS"])
PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}


def presses(count):
    """Returns a list of `count` short presses of four layouts."""
    changes = {"/layout/sampling/density": 1e5, "/layout/sampling/seed": {"values": [1, 2, 3, 4]},
               "/scenario/depth": {"uniform": [3e-4, 9e-4]}}
    return [{"layout": taxel.FINGERTIP, "scenario": PRESS, "set": changes, "repeat": count // 4}]


def files_of(folder):
    """Returns the bytes of all files of a batch."""
    files = (path for path in pathlib.Path(folder).rglob("*") if path.is_file())
    names = {str(path.relative_to(folder)): path for path in files}
    return {name: path.read_bytes() for name, path in names.items() if not name.startswith(".batch")}


def actors():
    """Returns the process ids of the actors of this test: the parents of their worker processes."""
    parents = set()
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            arguments = (folder / "cmdline").read_bytes().split(b"\0")
            if arguments[0] == bytes(programs.path_of("taxel")) and b"--worker" in arguments:
                parents.add(int((folder / "stat").read_text().rpartition(")")[2].split()[1]))
        except (FileNotFoundError, ProcessLookupError):
            continue
    return sorted(parents - {1})


class Killer:
    """A progress callback that kills actors after a number of jobs."""

    def __init__(self, after, count):
        self.after, self.count, self.killed = after, count, []

    def __call__(self, state):
        if state.finished < self.after or self.killed:
            return
        self.killed = actors()[: self.count]
        for process in self.killed:
            os.kill(process, signal.SIGKILL)


class RayTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = tempfile.mkdtemp(prefix="r", dir="/tmp")  # sockets need short paths
        ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, object_store_memory=100 << 20,
                 _temp_dir=cls.cluster)

    @classmethod
    def tearDownClass(cls):
        ray.shutdown()
        shutil.rmtree(cls.cluster, ignore_errors=True)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def run_on_ray(self, out, jobs, workers=2, **options):
        return taxel.batch(jobs, out, executor="ray", workers=workers, data_set=False, **options)

    def assert_same_files(self, one, other):
        one, other = files_of(one), files_of(other)
        self.assertEqual(sorted(one), sorted(other))
        self.assertEqual([name for name in one if one[name] != other[name]], [])

    def test_killed_actor_loses_and_repeats_nothing(self):
        taxel.batch(presses(COUNT), "here", group=2, data_set=False)
        killer = Killer(COUNT // 2, 1)
        result = self.run_on_ray("away", presses(COUNT), group=2, progress=killer)
        self.assertEqual(len(killer.killed), 1)
        self.assertEqual((result.episodes, result.failed), (COUNT, ()))
        self.assert_same_files("away", "here")
        records = [json.loads(line.split(" ", 1)[1])
                   for line in pathlib.Path("away/.batch/journal").read_text().splitlines()]
        groups = [record["group"] for record in records if "group" in record]
        self.assertEqual(set(collections.Counter(groups).values()), {1})
        self.assertEqual(len(groups), COUNT // 2)

    def test_lost_actor_fails_its_jobs_only(self):
        result = self.run_on_ray("away", presses(COUNT), group=1, progress=Killer(COUNT // 2, 1), max_restarts=0)
        self.assertEqual(result.episodes + len(result.failed), COUNT)
        self.assertEqual(len(result.failed), 1)
        self.assertIn("the worker that ran this job ended once: ", result.failed[0].error)

    def test_batch_without_actors_is_continued_by_either_executor(self):
        taxel.batch(presses(COUNT), "here", group=1, data_set=False)
        with self.assertRaisesRegex(taxel.Error, "all Ray workers have ended.*the same call continues"):
            self.run_on_ray("away", presses(COUNT), workers=1, group=1, progress=Killer(COUNT // 4, 1), max_restarts=0)
        self.assertFalse(pathlib.Path("away/batch.json").exists())
        with self.assertRaises(KeyboardInterrupt):
            self.run_on_ray("away", presses(COUNT), group=1, progress=self.interrupt_after(COUNT // 2))
        result = taxel.batch(presses(COUNT), "away", group=1, data_set=False)
        self.assertGreaterEqual(result.resumed, COUNT // 2)
        self.assertEqual((result.episodes, result.failed), (COUNT, ()))
        self.assert_same_files("away", "here")

    def interrupt_after(self, count):
        def interrupt(state):
            if state.finished >= count:
                raise KeyboardInterrupt
        return interrupt

    def test_bad_input_raises_errors(self):
        with self.assertRaises(taxel.Error) as caught:
            self.run_on_ray("away", "absent.jsonl")
        self.assertEqual(caught.exception.file, "absent.jsonl")
        pathlib.Path("full/shards").mkdir(parents=True)
        with self.assertRaisesRegex(taxel.Error, "full: has"):
            self.run_on_ray("full", presses(4))

    def test_nodes_with_another_version_are_refused(self):
        original = batch_process.BatchProcess.next_event

        def other_version(process, timeout=None):
            event = original(process, timeout)
            return {**event, "program": "taxel 9"} if event and event["event"] == "program" else event
        with mock.patch.object(batch_process.BatchProcess, "next_event", other_version):
            with self.assertRaisesRegex(taxel.Error, "a Ray node has taxel .*, this machine has taxel 9"):
                self.run_on_ray("away", presses(4))


if __name__ == "__main__":
    unittest.main()
