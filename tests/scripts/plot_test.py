#!/usr/bin/env python3
"""The plot of a sweep shows the taxels that respond and leaves two files, nothing else. plot_test.py plot_sweep.gp"""
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SCRIPT = str(pathlib.Path(sys.argv[1]).resolve())
HEAD = "time,travel,force_x,force_y,force_z,area,polygons,taxel_0,taxel_1,taxel_2,taxel_7"


def bump(travel, center, height):
    return height * math.exp(-((travel - center) / 0.002) ** 2)


def write_readings(path):
    """Taxel 1 and 7 respond, taxel 2 stays below 5 % of the largest, taxel 0 is silent."""
    rows = [HEAD]
    for i in range(241):
        travel = i * 1e-4
        readings = [0, bump(travel, 0.010, 8000), bump(travel, 0.012, 300), bump(travel, 0.015, 2500)]
        rows.append(",".join(str(value) for value in [travel / 0.01, travel, 0, 0, 1, 1e-5, 100, *readings]))
    path.write_text("\n".join(rows) + "\n")


def plot(folder, csv):
    command = ["gnuplot", "-e", f"csv='{csv}'; base='taxels'", SCRIPT]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


class PlotTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def test_two_files_and_no_stray_one(self):
        write_readings(self.folder / "readings.csv")
        done = plot(self.folder, "readings.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.files(), ["readings.csv", "taxels.png", "taxels.svg"])
        self.assertTrue((self.folder / "taxels.png").read_bytes().startswith(b"\x89PNG"))

    def test_the_taxels_that_respond_are_named(self):
        write_readings(self.folder / "readings.csv")
        plot(self.folder, "readings.csv")
        picture = (self.folder / "taxels.svg").read_text()
        for name, shown in (("taxel 0", False), ("taxel 1", True), ("taxel 2", False), ("taxel 7", True)):
            self.assertEqual(f">{name}<" in picture, shown, name)

    def test_missing_readings_are_one_clear_line_and_no_file(self):
        done = plot(self.folder, "nowhere.csv")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nowhere.csv: cannot be read", done.stderr)
        self.assertEqual(self.files(), [])


if __name__ == "__main__":
    if shutil.which("gnuplot") is None:
        print("gnuplot is absent")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
