"""Tests taxel.batch on the cores of this machine, and the programs behind it: one that gives groups away, one that runs
them. Most batches are without their data sets (data_set_test.py), and need no pyarrow."""
import importlib.util
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

import taxel
import taxel.data_set
from taxel import programs
from taxel.batch_process import BatchProcess
from taxel.group_worker import GroupWorker

PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}
COARSE = {"/layout/sampling/density": 1e5}


def presses(count, seeds=(1, 2)):
    """Returns a line with `count` short presses for each seed of the samples."""
    changes = {**COARSE, "/layout/sampling/seed": {"values": list(seeds)}, "/scenario/depth": {"uniform": [3e-4, 9e-4]}}
    return {"scenario": PRESS, "set": changes, "repeat": count}


def run_batch(jobs, out, **options):
    """Runs a batch without its data set."""
    return taxel.batch(jobs, out, data_set=False, **options)


def files_of(folder):
    """Returns the bytes of all files of a batch."""
    files = (path for path in pathlib.Path(folder).rglob("*") if path.is_file())
    names = {str(path.relative_to(folder)): path for path in files}
    return {name: path.read_bytes() for name, path in names.items() if not name.startswith(".batch")}


class BatchCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        self.folder = pathlib.Path(folder.name).resolve()

    def write_list(self, *jobs):
        path = self.folder / "jobs.jsonl"
        path.write_text("".join(json.dumps(job) + "\n" for job in jobs))
        return path

    def assert_same_files(self, one, other):
        one, other = files_of(one), files_of(other)
        self.assertEqual(sorted(one), sorted(other))
        self.assertEqual([name for name in one if one[name] != other[name]], [])

    def run_program(self, *arguments, **options):
        return subprocess.run([programs.path_of("taxel"), "batch", *arguments], capture_output=True, **options)


class ThreadsTest(BatchCase):
    def test_batch_has_the_bytes_of_the_program(self):
        self.write_list(presses(5))
        self.assertEqual(self.run_program("jobs.jsonl", "--out", "program", "--poses", "--group", "3").returncode, 0)
        states = []
        result = run_batch("jobs.jsonl", "here", poses=True, group=3, workers=2, progress=states.append)
        self.assertEqual((result.episodes, result.resumed, result.failed), (10, 0, ()))
        self.assertEqual((states[-1].jobs, states[-1].finished, states[-1].seconds_left), (10, 10, 0))
        self.assert_same_files("here", "program")
        self.assertGreater(result.frames, 50)
        run_batch([presses(5)], self.folder / "dicts", poses=True, group=3)
        self.assert_same_files("dicts", "program")
        again = run_batch("jobs.jsonl", "here", poses=True, group=3)
        self.assertEqual((again.episodes, again.frames), (result.episodes, result.frames))

    def test_layouts_are_files_or_in_memory(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.delete_taxels([0])
        (self.folder / "below").mkdir()
        layout.absolute().write("below/eleven.taxels.json")
        jobs = [{"layout": layout, "scenario": PRESS, "set": COARSE},
                {"layout": pathlib.Path("below/eleven.taxels.json"), "scenario": PRESS, "set": COARSE, "seed": 1}]
        result = run_batch(jobs, "out")
        self.assertEqual((result.episodes, result.failed), (2, ()))
        layouts = [json.loads(line) for line in pathlib.Path("out/layouts.jsonl").read_text().splitlines()]
        self.assertEqual({len(layout["taxel_ids"]) for layout in layouts}, {11})

    def test_failed_jobs_are_listed_and_the_others_run(self):
        heavy = {**COARSE, "/scenario/finger_mass": {"values": [0.02, 1e-15]}}
        jobs = [{"scenario": PRESS, "set": heavy}, {"scenario": PRESS, "set": {"/scenario/dept": 1}}]
        result = run_batch(jobs, "out")
        self.assertEqual(result.episodes, 1)
        self.assertEqual([(job.line, job.number) for job in result.failed], [(2, None), (1, 1)])
        self.assertIn("/scenario/dept: unknown key", result.failed[0].error)
        self.assertIn("inertia", result.failed[1].error)
        self.assertEqual(run_batch(jobs, "out"), result)

    @unittest.skipUnless(importlib.util.find_spec("pyarrow"), "the package pyarrow is not installed (scripts/setup installs it)")
    def test_data_set_is_joined_after_the_jobs(self):
        heavy = {**COARSE, "/scenario/finger_mass": {"values": [0.02, 1e-15, 0.03]}}
        result = taxel.batch([{"scenario": PRESS, "set": heavy}], "out")
        self.assertEqual((result.episodes, len(result.failed)), (2, 1))
        info = json.loads(pathlib.Path("out/meta/info.json").read_text())
        self.assertEqual((info["total_episodes"], info["total_frames"]), (2, result.frames))
        stamp = pathlib.Path("out/meta/info.json").stat().st_mtime_ns
        self.assertEqual(taxel.batch([{"scenario": PRESS, "set": heavy}], "out").episodes, 2)
        self.assertEqual(pathlib.Path("out/meta/info.json").stat().st_mtime_ns, stamp)
        taxel.data_set.write_run("out", 1, "run")
        taxel.Recording.read("run")
        with self.assertRaisesRegex(taxel.Error, "run: exists already"):
            taxel.data_set.write_run("out", 1, "run")
        with self.assertRaisesRegex(taxel.Error, "out: episode: must be 0 to 1, is 2"):
            taxel.data_set.write_run("out", 2, "other")

    def test_batch_that_is_left_continues(self):
        def leave(state):
            if state.finished >= 6:
                raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            run_batch([presses(20)], "out", group=1, workers=1, progress=leave)
        self.assertFalse(pathlib.Path("out/batch.json").exists())
        result = run_batch([presses(20)], "out", group=1)
        self.assertGreaterEqual(result.resumed, 6)
        run_batch([presses(20)], "whole", group=1)
        self.assert_same_files("out", "whole")

    def test_bad_input_raises_errors(self):
        pathlib.Path("full/data").mkdir(parents=True)
        jobs = [presses(1)]
        cases = [("absent.jsonl", "", "", lambda: run_batch("absent.jsonl", "out")),
                 ("jobs", "", "no job$", lambda: run_batch([], "out")),
                 ("jobs", "", "line 1: /scenario/kind: must be one of", lambda: run_batch([{"scenario": {"kind": "prss"}}], "out")),
                 ("", "executor", "threads", lambda: run_batch(jobs, "out", executor="mpi")),
                 ("", "workers", "at least 1", lambda: run_batch(jobs, "out", workers=0)),
                 ("", "npz", "threads", lambda: run_batch(jobs, "out", executor="ray", npz=True)),
                 ("", "mcap", "threads", lambda: run_batch(jobs, "out", executor="ray", mcap=True)),
                 ("", "--group", "4096", lambda: run_batch(jobs, "out", group=5000)),
                 ("full", "", 'has "data" already', lambda: taxel.batch(jobs, "full"))]
        for file, pointer, text, call in cases:
            with self.subTest(text=text), self.assertRaisesRegex(taxel.Error, text) as caught:
                call()
            self.assertEqual((caught.exception.file, caught.exception.pointer), (file, pointer))
        with self.assertRaisesRegex(TypeError, r"jobs\[1\] must be a dict"):
            run_batch([presses(1), 7], "out")

    def test_absent_ray_is_named_with_the_remedy(self):
        text = ("import sys, taxel; sys.modules['ray'] = None\n"
                "try: taxel.batch([], 'out', executor='ray', data_set=False)\n"
                "except taxel.Error as error: print(error)")
        result = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
        self.assertIn('executor: "ray" needs Ray: pip install "ray>=2.60"', result.stdout, result.stderr)


class WorkersTest(BatchCase):
    """The way of a group to another machine and back, without Ray."""

    def run_away(self, out, worker, jobs="jobs.jsonl", change=lambda package: package):
        """Runs a list by a worker."""
        with BatchProcess([str(jobs), "--out", out, "--workers", "3", "--group", "2"], {}, remote=True) as process:
            for event in process.all_events():
                if event["event"] != "group":
                    continue
                package = event["package"]
                contents = {sha256: pathlib.Path(path).read_bytes() for path, sha256 in package["files"].items()}
                shard = worker.run(change(package), contents.__getitem__)
                process.send_shard(package["group"], shard)
                process.send_shard(package["group"], b"the second result of a group is ignored")

    def worker(self, max_restarts=1):
        worker = GroupWorker(max_restarts)
        self.addCleanup(worker.close)
        return worker

    def test_files_travel_with_the_jobs(self):
        """The worker has neither layout, meshes nor objects, and the layouts have two names."""
        layout = json.loads(taxel.FINGERTIP.read_text())
        mesh = (taxel.FINGERTIP.parent / layout["mesh"]["file"]).read_bytes()
        layout["mesh"]["file"] = "skin.obj"
        for name in "a", "b":
            (self.folder / name).mkdir()
            (self.folder / name / "skin.obj").write_bytes(mesh)
            (self.folder / name / "finger.taxels.json").write_text(json.dumps(layout))
        (self.folder / "cube.obj").write_bytes(box_obj(0.01))
        on_cube = {"scenario": {**{key: PRESS[key] for key in PRESS if key != "shape"}, "object": "cube.obj"}, "set": COARSE}
        self.write_list(*({"layout": f"{name}/finger.taxels.json", "scenario": PRESS, "seed": i, "set": COARSE}
                          for i, name in enumerate("aba")), on_cube, presses(2))
        result = self.run_program("jobs.jsonl", "--out", "here", "--group", "2")
        self.assertEqual(result.returncode, 0, result.stderr)

        def hide(package):  # the worker finds no file of the list
            return json.loads(json.dumps(package).replace(str(self.folder), "/nowhere"))
        self.run_away("away", self.worker(), change=hide)
        self.assert_same_files("away", "here")

    def test_errors_name_the_files_of_the_list(self):
        (self.folder / "broken.obj").write_text("v 0 0 0\n")
        on_broken = {"scenario": {**{key: PRESS[key] for key in PRESS if key != "shape"}, "object": "broken.obj"}}
        self.write_list({**on_broken, "set": COARSE}, presses(1))
        self.assertEqual(self.run_program("jobs.jsonl", "--out", "here", "--group", "2").returncode, 1)
        self.run_away("away", self.worker())
        self.assert_same_files("away", "here")
        self.assertIn(str(self.folder / "broken.obj"), pathlib.Path("away/failed.jsonl").read_text())

    def test_job_that_ends_its_worker_fails_and_the_others_go_on(self):
        self.write_list(presses(2, seeds=[1]))
        worker = self.worker(max_restarts=2)
        program = self.folder / "taxel"
        # A worker that ends itself before the second job, unless this job has failed.
        program.write_text(f"""#!{sys.executable}
import json, os, subprocess, sys
with subprocess.Popen([{str(programs.path_of("taxel"))!r}, *sys.argv[1:]], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as real:
    out = sys.stdout.buffer
    out.write(real.stdout.readline()); out.flush()
    for line in sys.stdin.buffer:
        if "error" not in json.loads(line)["jobs"][1]:
            out.write(b'{{"event":"job"}}\\n'); out.flush()
            os.kill(os.getpid(), 9)
        real.stdin.write(line); real.stdin.flush()
        while True:
            event = real.stdout.readline()
            out.write(event); out.flush()
            if json.loads(event)["event"] == "shard":
                out.write(real.stdout.read(json.loads(event)["bytes"])); out.flush()
                break
""")
        program.chmod(0o755)
        original = programs.path_of
        self.addCleanup(setattr, programs, "path_of", original)
        starts = []

        def path_of(name):
            starts.append(name)
            return program
        with BatchProcess(["jobs.jsonl", "--out", "out"], {}, remote=True) as process:
            programs.path_of = path_of
            for event in process.all_events():
                if event["event"] == "group":
                    process.send_shard(event["package"]["group"], worker.run(event["package"], None))
                elif event["event"] == "result":
                    result = event
        self.assertEqual((result["episodes"], len(result["failed"])), (1, 1))
        self.assertEqual(result["failed"][0]["error"], "the worker that ran this job ended 3 times: by the signal SIGKILL")
        self.assertEqual(len(starts), 4)

    def test_killed_worker_runs_the_group_again(self):
        self.write_list(presses(4))
        self.assertEqual(self.run_program("jobs.jsonl", "--out", "here", "--group", "2").returncode, 0)
        worker = self.worker()
        kills = iter([True, False, True, False, False])

        def kill(package):
            worker.versions()
            if next(kills, False):
                worker._process.send_signal(signal.SIGKILL)
            return package
        self.run_away("away", worker, change=kill)
        self.assert_same_files("away", "here")

    def test_damaged_results_and_a_lost_reader_end_the_batch(self):
        self.write_list(presses(4))
        message = "all finished groups are kept, and the same command continues"
        for reply, text in ((b"PK\3\4", "the result of group"), (None, "stdin has ended")):
            with self.subTest(text=text), self.assertRaisesRegex(taxel.Error, f"{text}.*{message}"):
                with BatchProcess(["jobs.jsonl", "--out", "out", "--group", "2"], {}, remote=True) as process:
                    while process.next_event()["event"] != "group":
                        pass
                    if reply is None:
                        process._process.stdin.close()
                    else:
                        for event in process.all_events():
                            if event["event"] == "group":
                                process.send_shard(event["package"]["group"], reply)
        self.assertEqual(run_batch("jobs.jsonl", "out", group=2).episodes, 8)

    def test_changed_files_and_groups_of_others_are_refused(self):
        self.write_list(presses(1))
        worker = self.worker()
        package = {"files": {"/x/skin.obj": "0" * 64}, "jobs": []}
        with self.assertRaisesRegex(taxel.Error, "skin.obj: has changed"):
            worker.run(package, lambda sha256: b"other")
        with self.assertRaisesRegex(taxel.Error, "/version"):
            worker.run({"files": {}, "jobs": [], "version": 0}, None)
        for arguments, text in ((["--worker", "jobs.jsonl"], "jobs: is not read with --worker"),
                                (["--out", "x"], "jobs: is required"), (["jobs.jsonl"], "--out: is required"),
                                (["jobs.jsonl", "--out", "x", "--remote"], "--events")):
            result = self.run_program(*arguments, stdin=subprocess.DEVNULL)
            self.assertEqual(result.returncode, 2)
            self.assertIn(text, result.stderr.decode())


def box_obj(half):
    """Returns the OBJ text of a box whose faces point outward."""
    corners = [(x, y, z) for z in (-half, half) for y in (-half, half) for x in (-half, half)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + ["f " + " ".join(map(str, face)) for face in faces]
    return ("\n".join(lines) + "\n").encode()


if __name__ == "__main__":
    unittest.main()
