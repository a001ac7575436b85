#!/usr/bin/env python3
"""Tests that the plots of a sweep and of a study show the responding taxels and write exactly two files.
plot_test.py plot_sweep.gp plot_study.gp"""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT, STUDY = (str(pathlib.Path(name).resolve()) for name in sys.argv[1:3])
HEAD = "time,travel,force_x,force_y,force_z,area,polygons,taxel_0,taxel_1,taxel_2,taxel_7"


def bump(travel, center, height):
    return height * math.exp(-((travel - center) / 0.002) ** 2)


def write_readings(path):
    """Writes readings: taxels 1 and 7 respond, taxel 2 stays below 5 % of the largest reading, taxel 0 reads zero."""
    rows = [HEAD]
    for i in range(241):
        travel = i * 1e-4
        readings = [0, bump(travel, 0.010, 8000), bump(travel, 0.012, 300), bump(travel, 0.015, 2500)]
        rows.append(",".join(str(value) for value in [travel / 0.01, travel, 0, 0, 1, 1e-5, 100, *readings]))
    path.write_text("\n".join(rows) + "\n")


def plot(folder, csv):
    command = ["gnuplot", "-e", f"csv='{csv}'; base='taxels'", SCRIPT]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def plot_study(folder, study):
    command = ["gnuplot", "-e", f"study='{study}'; base='multiples'", STUDY]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


class PlotTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_writes_exactly_two_files(self):
        write_readings(self.folder / "readings.csv")
        done = plot(self.folder, "readings.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.files(), ["readings.csv", "taxels.png", "taxels.svg"])
        self.assertTrue((self.folder / "taxels.png").read_bytes().startswith(b"\x89PNG"))

    def test_names_the_responding_taxels(self):
        write_readings(self.folder / "readings.csv")
        plot(self.folder, "readings.csv")
        picture = (self.folder / "taxels.svg").read_text()
        for name, shown in (("taxel 0", False), ("taxel 1", True), ("taxel 2", False), ("taxel 7", True)):
            self.assertEqual(f">{name}<" in picture, shown, name)

    def test_reports_missing_readings_in_one_line_and_writes_nothing(self):
        done = plot(self.folder, "nowhere.csv")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nowhere.csv: cannot be read", done.stderr)
        self.assertEqual(self.files(), [])

    def test_draws_one_plot_per_run_of_a_study(self):
        (self.folder / "out").mkdir()
        for name in ("run_000", "run_002"):
            write_readings(self.folder / "out" / f"{name}.csv")
        (self.folder / "out" / "runs.csv").write_text("file,depth,seed\nrun_000.csv,0.001,1\nrun_002.csv,0.001,2\n")
        done = plot_study(self.folder, "out")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.files(), ["multiples.png", "multiples.svg", "out"])
        picture = (self.folder / "multiples.svg").read_text()
        for title in ("depth 0.001, seed 1", "depth 0.001, seed 2", "taxel 1", "taxel 7"):
            self.assertIn(f">{title}<", picture)
        self.assertNotIn(">taxel 2<", picture)

    def test_reports_a_missing_study_in_one_line(self):
        done = plot_study(self.folder, "nowhere")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nowhere/runs.csv: cannot be read", done.stderr)


if __name__ == "__main__":
    if shutil.which("gnuplot") is None:
        print("gnuplot is absent")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
