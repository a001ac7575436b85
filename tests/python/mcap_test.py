"""Tests the bytes of taxel.mcap: templates of messages, definitions, names, errors. tests/mcap reads whole files."""
import contextlib
import importlib.util
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np

import taxel
import taxel.mcap
from taxel.mcap import _DEFINITIONS, _definition, _FrameNames, _nanoseconds, _number_text, _Template, _valid_text

ALL = slice(None)
HAS_LIBRARY = importlib.util.find_spec("mcap") is not None
COARSE = {"density": 1e5, "past": 0, "object": "box"}


class TemplateTest(unittest.TestCase):
    def test_numbers_are_aligned_after_the_head(self):
        template = _Template()
        template.add_text("ab")
        template.add_column([-2], "<i4")
        template.add_column([1.0])
        template.add_count(0)
        template.add_column(np.zeros((1, 0)))
        template.add_ids([7])
        template.add_texts(["x", ""])
        template.add_count(1)
        template.add_column([-0.0])
        self.assertEqual(template.messages(ALL), [bytes.fromhex(
            "00 01 00 00"              # plain CDR, little endian
            "03 00 00 00 61 62 00 00"  # "ab", one byte of padding
            "fe ff ff ff 00 00 00 00"  # -2, padding
            "00 00 00 00 00 00 f0 3f"  # 1.0
            "00 00 00 00"              # a list without elements has no padding
            "01 00 00 00 07 00 00 00"  # list of one number
            "02 00 00 00"              # list of two texts
            "02 00 00 00 78 00 00 00"  # "x"
            "01 00 00 00 00 00 00 00"  # ""
            "01 00 00 00 00 00 00 00"  # list of one number, which begins at a multiple of 8
            "00 00 00 00 00 00 00 80")])

    def test_each_row_has_its_own_numbers(self):
        template = _Template()
        template.add_header(np.array([1_250_000_000, 2]), "w")
        template.add_column([[1, 2, -2], [0, 0, 0.5]])
        first, second = template.messages(ALL)
        self.assertEqual(first, bytes.fromhex(
            "00 01 00 00 01 00 00 00 80 b2 e6 0e 02 00 00 00 77 00"
            "00 00 00 00 00 00 00 00 f0 3f 00 00 00 00 00 00 00 40 00 00 00 00 00 00 00 c0"))
        self.assertEqual(second[:12], bytes.fromhex("00 01 00 00 00 00 00 00 02 00 00 00"))
        self.assertEqual(second[-8:], bytes.fromhex("00 00 00 00 00 00 e0 3f"))
        self.assertEqual(template.messages(slice(1, 5)), [second])

    def test_quaternions_are_written_with_w_last(self):
        template = _Template()
        template.add_pose([[0, 1, 2]], [[0.5, 1, 2, -2]])
        (message,) = template.messages(ALL)
        np.testing.assert_array_equal(np.frombuffer(message[4:], "<f8"), [0, 1, 2, 1, 2, -2, 0.5])


class TextsTest(unittest.TestCase):
    def test_definitions_define_the_type_of_each_field(self):
        for kind in list(_DEFINITIONS)[:5]:
            text = _definition(kind)
            defined = re.findall(r"^MSG: (.*)$", text, re.MULTILINE)
            used = set(re.findall(r"^(\w+/\w+)", text, re.MULTILINE))
            self.assertEqual(sorted(used), sorted(defined), kind)
        self.assertTrue(_definition("geometry_msgs/Vector3Stamped").startswith(
            "std_msgs/Header header\ngeometry_msgs/Vector3 vector\n" + "=" * 80
            + "\nMSG: geometry_msgs/Vector3\nfloat64 x\n"))

    def test_frame_names_are_valid_and_differ(self):
        names = _FrameNames()
        given = ["thumb/tip, left", "thumb tip left", "3", "__\u00e4__", ""]
        self.assertEqual([names.add(name) for name in given],
                         ["thumb_tip_left", "thumb_tip_left_2", "geom_3", "geom", "geom_2"])

    def test_texts_are_utf_8(self):
        self.assertEqual((_valid_text("\u00e4"), _valid_text("a\ud800")), ("\u00e4", "a?"))

    def test_numbers_have_their_shortest_text(self):
        texts = [_number_text(value) for value in (1.0, 0.001, 1e-5, 2.5e-6)]
        self.assertEqual(texts, ["1", "0.001", "1e-05", "2.5e-06"])


class TimesTest(unittest.TestCase):
    def test_times_are_rounded_to_nanoseconds(self):
        times = np.array([0, 2.0000000004, 0.9999999999, 0.5e-9, 2147483646.5])
        self.assertEqual(_nanoseconds(times, "").tolist(), [0, 2 * 10**9, 10**9, 1, 2147483646500000000])

    def test_times_without_a_stamp_are_refused(self):
        for value, text in (-0.5, "-0.5"), (3e9, "3000000000"):
            with self.assertRaises(taxel.Error) as caught:
                _nanoseconds(np.array([0, value]), "readings.npz")
            self.assertEqual(str(caught.exception),
                             f"readings.npz: time: must be 0 to 2147483647 s in a message of ROS 2, is {text} s")


@unittest.skipUnless(HAS_LIBRARY, "the package mcap is not installed (scripts/setup installs it)")
class FilesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        taxel.sweep(out=cls.folder / "run", mcap=True, **COARSE)
        cls.bytes = (cls.folder / "run/readings.mcap").read_bytes()

    def write_archive(self, name, **changes):
        """Writes the run's archive with other arrays into a folder of its own, and returns the archive."""
        with np.load(self.folder / "run/readings.npz") as archive:
            arrays = {**archive, **changes}
        (self.folder / name).mkdir()
        np.savez(self.folder / name / "readings.npz", **arrays)
        return self.folder / name / "readings.npz"

    def assert_error(self, text, folder, file):
        with self.assertRaises(taxel.Error) as caught:
            taxel.mcap.write(folder, file)
        self.assertIn(text, str(caught.exception))

    def test_equal_folders_give_equal_bytes(self):
        taxel.mcap.write(self.folder / "run/readings.npz", self.folder / "again.mcap")
        self.assertEqual((self.folder / "again.mcap").read_bytes(), self.bytes)

    def test_rows_do_not_depend_on_the_size_of_a_block(self):
        with unittest.mock.patch.object(taxel.mcap, "_ROWS_AT_ONCE", 7):
            taxel.mcap.write(self.folder / "run", self.folder / "blocks.mcap")
        self.assertEqual((self.folder / "blocks.mcap").read_bytes(), self.bytes)

    def test_archive_alone_has_the_version_of_the_package(self):
        archive = self.folder / "alone.npz"
        archive.write_bytes((self.folder / "run/readings.npz").read_bytes())
        messages = io.StringIO()
        with contextlib.redirect_stderr(messages):
            self.assertEqual(taxel.mcap.main([str(archive), str(self.folder / "alone.mcap")]), 0)
        self.assertIn("no scenario.json or sweep.json is next to the recording", messages.getvalue())
        head = (self.folder / "alone.mcap").read_bytes()[:100]
        self.assertIn(f"taxel {taxel.__version__}".encode(), head)

    def test_broken_input_is_named_and_nothing_is_written(self):
        rows = len(taxel.Recording.read(self.folder / "run"))
        late = self.write_archive("late", time=np.linspace(0, 3e9, rows))
        out = self.folder / "out"
        out.mkdir()
        self.assert_error(f"{late}: time: must be 0 to 2147483647 s", late, out / "x.mcap")
        self.assert_error("readings", self.write_archive("nan", readings=np.array([[np.nan]])), out / "x.mcap")
        self.assert_error("absent", self.folder / "absent", out / "x.mcap")
        for text, message in (("[", ": is not JSON"), ("[]", ": /versions: must be an object"),
                              ('{"versions": {"taxel": 1}}', ": /versions/taxel: must be a text")):
            run_file = self.folder / "late/sweep.json"
            run_file.write_text(text)
            self.assert_error(f"{run_file}{message}", self.folder / "late", out / "x.mcap")
        self.assertEqual(list(out.iterdir()), [])
        target = self.folder / "no/x.mcap"
        self.assert_error(f"{target}: cannot be written", self.folder / "run", target)
        (out / "x.mcap").mkdir()
        self.assert_error("cannot be written", self.folder / "run", out / "x.mcap")
        self.assertEqual(os.listdir(out), ["x.mcap"])

    def test_newest_file_about_the_run_is_attached(self):
        folder = self.write_archive("newest").parent
        run = json.loads((self.folder / "run/sweep.json").read_text())
        for name, version, age in ("scenario.json", "new", 0), ("sweep.json", "old", 100):
            run["versions"]["taxel"] = version
            (folder / name).write_text(json.dumps(run))
            os.utime(folder / name, (1e9 - age, 1e9 - age))
        taxel.mcap.write(folder, folder / "x.mcap")
        self.assertIn(b"taxel new, MuJoCo", (folder / "x.mcap").read_bytes()[:100])

    def test_link_stays_a_link(self):
        link = self.folder / "link.mcap"
        link.symlink_to("linked.mcap")
        taxel.mcap.write(self.folder / "run", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual((self.folder / "linked.mcap").read_bytes(), self.bytes)

    def test_module_refuses_swapped_arguments(self):
        run, other = self.folder / "run", self.folder / "other.npz"
        for arguments, text in (([], "usage: python -m taxel.mcap"), ([str(run), str(other)], "must end in .mcap")):
            result = subprocess.run([sys.executable, "-m", "taxel.mcap", *arguments], capture_output=True, text=True)
            self.assertEqual(result.returncode, 2)
            self.assertIn(text, result.stderr)
        self.assertFalse(other.exists())


class OptionTest(unittest.TestCase):
    def test_option_needs_a_folder(self):
        for call in (lambda: taxel.sweep(mcap=True), lambda: taxel.play({"kind": "press"}, mcap=True)):
            with self.assertRaisesRegex(taxel.Error, "^mcap: needs out, the folder for readings.mcap$"):
                call()

    def test_absent_library_is_named_with_the_remedy_before_the_run(self):
        text = ("import sys, taxel; sys.modules['mcap'] = None\n"
                "for call in (taxel.sweep, lambda **options: taxel.batch([], **options)):\n"
                "  try: call(out='out', mcap=True)\n"
                "  except taxel.Error as error: print(error)")
        result = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True)
        remedy = 'mcap: needs the package mcap: pip install "taxel-studio[mcap]"\n'
        self.assertEqual(result.stdout, 2 * remedy, result.stderr)


if __name__ == "__main__":
    unittest.main()
