"""Tests objects that one thread changes while another one computes with them without Python's lock."""
import threading
import unittest

import numpy as np

import taxel

ROUNDS = 12


class Editor:
    """As a context manager, a thread that edits a layout all the time."""

    def __init__(self, layout):
        self._layout = layout
        self._is_over = threading.Event()
        self._thread = threading.Thread(target=self._edit)
        self.edits = 0

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._is_over.set()
        self._thread.join()

    def _edit(self):
        while not self._is_over.is_set():
            self.edits += 1
            self._layout.name = f"edit {self.edits} " + "of a name that is longer than a short text " * 4
            self._layout.radii = 0.005 + 1e-6 * (self.edits % 100)


class ThreadsTest(unittest.TestCase):
    def setUp(self):
        self.layout = taxel.Layout.read(taxel.FINGERTIP)
        self.layout.set_value("/sampling/density", 1e5)

    def test_models_are_built_of_a_layout_that_is_edited(self):
        with Editor(self.layout) as editor:
            models = [taxel.SensorModel(self.layout, "preview") for _ in range(ROUNDS)]
        self.assertGreater(editor.edits, ROUNDS)
        for model in models:
            radii = model.layout.radii
            np.testing.assert_array_equal(radii, radii[0])  # of one state of the layout
            self.assertTrue(model.layout.name.startswith(("edit", "Fingertip")))

    def test_a_layout_is_checked_while_it_is_edited(self):
        with Editor(self.layout) as editor:
            for _ in range(ROUNDS):
                self.assertFalse([problem for problem in self.layout.check() if problem.severity == "error"])
            for _ in range(100 * ROUNDS):
                self.layout.check(mesh=False)
        self.assertGreater(editor.edits, ROUNDS)

    def test_a_model_is_read_by_threads_after_its_object_is_gone(self):
        box = {"shape": {"type": "box", "size": [0.02, 0.02, 0.02]}, "pos": [0, -0.0265, 0.012]}
        models = [taxel.SensorModel(self.layout, "preview")]
        expected = taxel.contact({"a": {}, "b": box}, models[0]).readings
        found = []

        def read():
            for _ in range(ROUNDS):
                found.append(taxel.contact({"a": {}, "b": box}, models[-1]).readings)

        threads = [threading.Thread(target=read) for _ in range(3)]
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            models[:] = [taxel.SensorModel(self.layout, "preview")]
        for readings in found:
            np.testing.assert_array_equal(readings, expected)


if __name__ == "__main__":
    unittest.main()
