"""Runs the programs in examples/python as they stand, in the folder `/`."""
import pathlib
import subprocess
import sys
import unittest

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples" / "python"
PYTHON = [sys.executable, *(["-S"] if sys.flags.no_site else [])]


def lines_of(name):
    result = subprocess.run([*PYTHON, str(EXAMPLES / name)], cwd="/", capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout.splitlines()


class ExamplesTest(unittest.TestCase):
    def test_press_prints_the_readings_of_twelve_taxels(self):
        lines = lines_of("press.py")
        self.assertEqual(len(lines), 12)
        pads = [float(line.split()[-2]) for line in lines if "pad mid" in line]
        self.assertEqual(len(pads), 2)
        self.assertGreater(min(pads), 1000)
        self.assertTrue(all(line.endswith(" Pa") for line in lines))

    def test_attach_reads_all_five_fingers(self):
        lines = lines_of("attach.py")
        self.assertEqual([line.split()[0] for line in lines], ["thumb", "index", "middle", "ring", "little"])
        self.assertTrue(all(float(line.split()[-2]) > 10 for line in lines), lines)

    def test_rollout_reads_less_where_the_target_is_higher(self):
        peaks = [float(line.split()[-2]) for line in lines_of("rollout.py")]
        self.assertEqual(len(peaks), 16)
        self.assertEqual(peaks, sorted(peaks, reverse=True))
        self.assertGreater(peaks[-1], 0)


if __name__ == "__main__":
    unittest.main()
