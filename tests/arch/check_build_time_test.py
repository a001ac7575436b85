#!/usr/bin/env python3
"""check_build_time.py finds a dear file, whatever the load of the machine, and is skipped for cached builds."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).with_name("check_build_time.py")


def log_of(seconds, later=()):
    """A log in which a second run of ninja, an hour later, compiled the objects `later`."""
    lines = ["# ninja log v5"]
    for name, value in seconds.items():
        end = 1000 + round(1000 * value)
        written = 10**6 * (end + (3600000 if name in later else 0))
        lines.append(f"1000\t{end}\t{written}\t{name}\tabc")
    return "\n".join(lines) + "\n"


class BuildTime(unittest.TestCase):
    def run_on(self, seconds, missing=(), later=()):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name in seconds:
                if name not in missing:
                    (root / name).parent.mkdir(parents=True, exist_ok=True)
                    (root / name).touch()
            (root / ".ninja_log").write_text(log_of(seconds, later))
            command = [sys.executable, SCRIPT, root]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            return done.returncode, done.stdout

    @staticmethod
    def even(count=100, each=4.0):
        return {f"src/a.dir/file{i}.cpp.o": each for i in range(count)}

    def test_accepts_even_files(self):
        self.assertEqual(self.run_on(self.even())[0], 0)

    def test_names_a_dear_file_at_any_load(self):
        for load in (1, 3):
            seconds = {name: load * value for name, value in (self.even() | {"src/a.dir/dear.cpp.o": 20.0}).items()}
            code, text = self.run_on(seconds)
            self.assertEqual(code, 1)
            self.assertIn("src/a.dir/dear.cpp.o: 4.76 %", text)

    def test_counts_precompiled_headers(self):
        self.assertEqual(self.run_on(self.even() | {"src/a.dir/cmake_pch.hxx.gch": 20.0})[0], 1)

    def test_ignores_tests_foreign_code_and_removed_files(self):
        seconds = self.even()
        for name in ("tests/t.dir/long.cpp.o", "src/CMakeFiles/imgui.dir/imgui.cpp.o", "src/a.dir/removed.cpp.o"):
            seconds[name] = 90.0
        self.assertEqual(self.run_on(seconds, missing=["src/a.dir/removed.cpp.o"])[0], 0)

    def test_reports_a_file_above_the_aim(self):
        code, text = self.run_on(self.even() | {"src/a.dir/dear.cpp.o": 12.0})
        self.assertEqual(code, 0)
        self.assertIn("src/a.dir/dear.cpp.o: 2.91 %", text)

    def test_is_skipped_for_objects_of_several_runs(self):
        seconds = self.even(20) | {"src/a.dir/dear.cpp.o": 90.0}
        self.assertEqual(self.run_on(seconds, later=[f"src/a.dir/file{i}.cpp.o" for i in range(5)])[0], 77)

    def test_is_skipped_for_a_cached_build_or_without_a_log(self):
        cached = {name: 0.1 for name in self.even(20)} | {"src/a.dir/dear.cpp.o": 12.0}
        self.assertEqual(self.run_on(cached)[0], 77)
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, SCRIPT, folder], check=False, capture_output=True)
            self.assertEqual(done.returncode, 77)


if __name__ == "__main__":
    unittest.main()
