"""Tests the types that checkers such as mypy and pyright see."""
import dataclasses
import importlib.util
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import taxel
from docs_test import PAGES, PYTHON, program_of
from examples_test import EXAMPLES


class TypesTest(unittest.TestCase):
    def test_arrays_that_may_be_absent_may_be_used_without_a_check(self):
        """An array | None would make `sensor.values.max()` an error, so the types say array | Any (PEP 484, typeshed)."""
        package = pathlib.Path(taxel.__file__).parent
        types = re.findall(r"-> (.*NDArray.*):$", (package / "_core.pyi").read_text(), re.MULTILINE)
        types += [field.type for field in dataclasses.fields(taxel.SensorReadings)]
        self.assertGreater(len(types), 30)
        self.assertEqual([one for one in types if "| None" in one or "Optional" in one], [])

    def test_pages_and_examples_pass_mypy(self):
        if not importlib.util.find_spec("mypy"):
            self.skipTest(f"Python {sys.version.split()[0]} has no mypy: pip install mypy")
        with tempfile.TemporaryDirectory() as folder:
            for page in PAGES:
                if program_of(page):
                    (pathlib.Path(folder) / (re.sub(r"\W", "_", page) + ".py")).write_text(program_of(page))
            for example in EXAMPLES.glob("*.py"):
                (pathlib.Path(folder) / f"example_{example.name}").write_text(example.read_text())
            # The package counts as installed, so that only errors of the pages are reported.
            command = [*PYTHON, "-m", "mypy", "--ignore-missing-imports", "--follow-imports=silent", "."]
            result = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                                    env={"PYTHONPATH": ":".join(sys.path), "MYPYPATH": str(pathlib.Path(taxel.__file__).parents[1])})
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
