"""Tests taxel.Layout: arrays, files, checks and edits."""
import copy
import gc
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import taxel


class LayoutTest(unittest.TestCase):
    def setUp(self):
        self.layout = taxel.Layout.read(taxel.FINGERTIP)

    def expect_error(self, pointer, call):
        before = self.layout.to_json()
        with self.assertRaises(taxel.Error) as caught:
            call()
        self.assertEqual(caught.exception.pointer, pointer)
        self.assertEqual(caught.exception.file, str(taxel.FINGERTIP))
        self.assertEqual(self.layout.to_json(), before)

    def test_arrays_have_the_values_of_the_file(self):
        self.assertEqual(len(self.layout), 12)
        self.assertEqual(self.layout.ids.tolist(), list(range(12)))
        self.assertEqual(self.layout.names[4], "right tip")
        self.assertEqual(self.layout.unit, "Pa")
        for index in (0, 11):
            taxel_of_file = self.layout.value(f"/taxels/{index}")
            self.assertEqual(self.layout.centers[index].tolist(), taxel_of_file["center"])
            self.assertEqual(self.layout.normals[index].tolist(), taxel_of_file["normal"])
            self.assertEqual(self.layout.radii[index], taxel_of_file["radius"])

    def test_arrays_are_read_only_views_without_copies(self):
        centers = self.layout.centers
        self.assertEqual((centers.shape, centers.dtype, centers.flags.writeable), ((12, 3), np.float64, False))
        self.assertEqual(centers.ctypes.data, self.layout.centers.ctypes.data)
        self.assertGreater(centers.strides[0], 24)  # the other members of a taxel are in between
        with self.assertRaises(ValueError):
            centers[0, 0] = 1

    def test_arrays_stay_valid_after_edits_and_deletion(self):
        centers = self.layout.centers
        expected = centers.copy()
        self.layout.centers = expected + 0.001
        self.layout.delete_taxels(range(1, 12))
        np.testing.assert_array_equal(centers, expected)
        np.testing.assert_array_equal(self.layout.centers, expected[:1] + 0.001)
        del self.layout
        gc.collect()
        np.testing.assert_array_equal(centers, expected)

    def test_arrays_of_no_taxels_are_empty(self):
        self.layout.delete_taxels(self.layout.ids)
        self.assertEqual(self.layout.centers.shape, (0, 3))
        self.assertEqual(self.layout.radii.shape, (0,))

    def test_edits_change_the_given_values_only(self):
        self.layout.radii = 0.005
        self.layout.set_taxels([3, 1], radii=[0.004, 0.003], names=["three", "one"])
        self.assertEqual(self.layout.radii[:5].tolist(), [0.005, 0.003, 0.005, 0.004, 0.005])
        self.assertEqual((self.layout.names[1], self.layout.names[3]), ("one", "three"))
        self.layout.set_value("/material/modulus", np.float64(6e4))
        self.assertEqual(self.layout.value("/material/modulus"), 6e4)
        self.layout.reorder_taxels(self.layout.ids[::-1])
        self.assertEqual(self.layout.ids.tolist(), list(range(11, -1, -1)))

    def test_added_and_mirrored_taxels_get_new_ids(self):
        ids = self.layout.add_taxels([[0.001, -0.007, 0.012]], [[0, -1, 0]], names=["extra"])
        self.assertEqual(ids.tolist(), [12])
        self.layout.mirror_taxels(ids, [1, 0, 0])
        self.assertEqual(self.layout.ids.tolist(), list(range(14)))
        np.testing.assert_allclose(self.layout.centers[13], [-0.001, -0.007, 0.012], rtol=0, atol=1e-12)

    def test_a_mirrored_layout_is_that_of_the_other_hand(self):
        other = self.layout.mirrored("y")
        self.assertEqual(other.value("/mesh/scale"), [1, -1, 1])
        np.testing.assert_array_equal(other.centers * [1, -1, 1], self.layout.centers)
        np.testing.assert_array_equal(other.mirrored("y").normals, self.layout.normals)
        with self.assertRaisesRegex(ValueError, "axis"):
            self.layout.mirrored("w")

    def test_arrays_of_another_kind_or_shape_are_refused(self):
        cases = [(TypeError, "radii", lambda: setattr(self.layout, "radii", "wide")),
                 (TypeError, "centers", lambda: setattr(self.layout, "centers", np.zeros((12, 3), dtype=complex))),
                 (ValueError, r"\(12, 3\)", lambda: setattr(self.layout, "centers", np.zeros((12, 2)))),
                 (ValueError, r"\(12, 3\)", lambda: setattr(self.layout, "normals", np.zeros((11, 3)))),
                 (ValueError, "finite", lambda: setattr(self.layout, "centers", np.full((12, 3), np.nan))),
                 (ValueError, "finite", lambda: self.layout.set_value("/material/modulus", float("inf"))),
                 (ValueError, "names", lambda: self.layout.set_taxels([1, 2], names=["one"])),
                 (ValueError, "masked", lambda: setattr(self.layout, "radii", np.ma.masked_less(np.arange(12.0) + 1, 3))),
                 (ValueError, "masked", lambda: self.layout.delete_taxels(np.ma.masked_equal([1, 2], 2))),
                 (ValueError, "2147483647", lambda: self.layout.delete_taxels([2**63])),
                 (ValueError, "2147483647", lambda: self.layout.delete_taxels([-1])),
                 (TypeError, "ids", lambda: self.layout.delete_taxels([1.5]))]
        before = self.layout.to_json()
        for kind, words, call in cases:
            with self.subTest(words=words), self.assertRaisesRegex(kind, words):
                call()
        self.assertEqual(self.layout.to_json(), before)

    def test_arrays_with_an_empty_mask_are_taken(self):
        self.layout.radii = np.ma.array(np.full(12, 0.004))
        self.assertEqual(set(self.layout.radii), {0.004})

    def test_lengths_beyond_the_farthest_vertex_are_refused(self):
        self.expect_error("/taxels/0/radius", lambda: setattr(self.layout, "radii", 1e300))
        self.expect_error("/taxels/3/center", lambda: self.layout.set_taxels([3], centers=[[0, 1e300, 0]]))
        for pointer in ("/taxels/1/radius", "/readout/max_depth", "/material/thickness", "/mesh/repair/join"):
            self.expect_error(pointer, lambda: self.layout.set_value(pointer, 1e300))

    def test_keys_that_no_layout_has_are_refused(self):
        with self.assertRaisesRegex(taxel.Error, 'did you mean "modulus"'):
            self.layout.set_value("/material/modolus", 6e4)
        self.expect_error("/material/modolus", lambda: self.layout.set_value("/material/modolus", 6e4))
        self.expect_error("/calibration/gian", lambda: self.layout.set_value("/calibration", {"gian": 2}))
        self.layout.set_value("/calibration", {"gain": 2})
        kept = taxel.Layout.parse(self.layout.to_json().replace('"gain": 2', '"gain": 2, "note": "a"'), self.layout.file)
        kept.set_value("/calibration/note", "b")  # a key that the file had
        self.assertEqual(kept.value("/calibration/note"), "b")

    def test_broken_rules_raise_errors_with_json_pointers(self):
        self.expect_error("/taxels/2/radius", lambda: self.layout.set_taxels([2], radii=-1.0))
        self.expect_error("/sampling/density", lambda: self.layout.set_value("/sampling/density", -1))
        self.expect_error("/sampling/denisty", lambda: self.layout.value("/sampling/denisty"))
        self.expect_error("taxel 99", lambda: self.layout.delete_taxels([99]))
        with self.assertRaises(taxel.Error) as caught:
            taxel.Layout.parse('{"format": "taxel-layout"', "broken.json")
        self.assertEqual(caught.exception.file, "broken.json")
        with self.assertRaises(taxel.Error) as caught:
            taxel.Layout.read("absent.taxels.json")
        self.assertEqual(caught.exception.file, "absent.taxels.json")

    def test_check_lists_problems_of_values_and_mesh(self):
        self.assertFalse([p for p in self.layout.check() if p.severity != "note"])
        far = self.layout.copy()
        far.set_taxels([5], centers=[[0, 0, 0.5]])
        problems = [p for p in far.check() if p.severity != "note"]
        self.assertTrue(problems)
        self.assertTrue(all(p.pointer.startswith("/taxels/5") for p in problems), problems)
        self.assertFalse(far.check(mesh=False))
        far.set_taxels([5], centers=far.centers[3:4])
        (same,) = far.check(mesh=False)
        self.assertEqual(same.message.count("(taxel"), 1)

    def test_files_are_read_back_from_another_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "copy.taxels.json"
            self.assertEqual(self.layout.write(file), [])
            read = taxel.Layout.read(file)
            self.assertEqual(read, self.layout.absolute())
            self.assertTrue(pathlib.Path(read.mesh_file).samefile(self.layout.mesh_file))
            with self.assertRaisesRegex(taxel.Error, "extension"):
                self.layout.write(pathlib.Path(folder) / "copy.pdf")

    def test_scenes_that_were_written_are_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scene.xml"
            self.layout.write(file)
            read = taxel.Layout.read(file)
            np.testing.assert_array_equal(read.centers, self.layout.centers)
            self.assertTrue(pathlib.Path(read.mesh_file).samefile(self.layout.mesh_file))
            read.write(pathlib.Path(folder) / "same.taxels.json")  # and one whose mesh is relative, next to the scene
            with self.assertRaisesRegex(taxel.Error, 'no sensor "thumb", but "Fingertip, 12 taxels"'):
                taxel.Layout.read(file, sensor="thumb")
            file.write_text("<mujoco/>")
            with self.assertRaisesRegex(taxel.Error, "holds no layout"):
                taxel.Layout.read(file)

    def test_files_that_are_no_text_are_refused_in_words(self):
        picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(256)) * 4
        with tempfile.TemporaryDirectory() as name:
            for folder in (os.fsencode(name), os.path.join(os.fsencode(name), b"\xff\xfe")):  # a name that is no UTF-8
                os.makedirs(folder, exist_ok=True)
                for extension in (b"png", b"txt", b"json", b"xml", b"csv", b"yaml", b"npz", b"urdf"):
                    file = os.fsdecode(os.path.join(folder, b"a." + extension))
                    pathlib.Path(file).write_bytes(picture)
                    for call in (taxel.Layout.read, taxel.Recording.read, taxel.contact):
                        with self.subTest(file=ascii(file), call=call), self.assertRaises(taxel.Error) as caught:
                            call(file)
                        self.assertEqual(caught.exception.file, file)

    def test_long_messages_are_cut_at_both_ends(self):
        text = self.layout.to_json().replace('"radius": 0.006', f'"radius": "begin{"x" * 100000}end"', 1)
        for broken, where in ((text, "/taxels/0/radius"), (self.layout.to_json().replace("}", ', "' + "k" * 100000 + '": 1}', 1), "")):
            with self.subTest(where=where):
                try:
                    layout = taxel.Layout.parse(broken)
                except taxel.Error as error:
                    self.assertEqual(error.pointer, where)
                    self.assertLess(len(error.message), 400)
                    continue
                for problem in layout.check(mesh=False):
                    self.assertLess(len(problem.pointer) + len(problem.message) + len(problem.fix), 1000)

    def test_copies_and_pickles_are_independent(self):
        for twin in (copy.copy(self.layout), copy.deepcopy(self.layout), self.layout.copy()):
            self.assertEqual(twin, self.layout)
            twin.name = "twin"
            self.assertNotEqual(twin, self.layout)
        self.assertEqual(pickle.loads(pickle.dumps(self.layout)), self.layout.absolute())


class ErrorTest(unittest.TestCase):
    def test_errors_are_value_errors_that_can_be_pickled(self):
        error = taxel.Error("finger.json", "/taxels/3/radius", "must be greater than 0")
        self.assertIsInstance(error, ValueError)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((again.file, again.pointer, again.message), error.args)
        self.assertEqual(str(again), "finger.json: /taxels/3/radius: must be greater than 0")


if __name__ == "__main__":
    unittest.main()
