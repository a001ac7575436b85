#!/usr/bin/env python3
"""The check of tests/tiers.txt notices each kind of wrong row."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from check_tiers import problems  # noqa: E402

PROGRAM = "#!/bin/sh\necho Suite.\ncase \"$2\" in *Suite*) echo '  HasATest' ;; esac\n"


class CheckTiers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        program = pathlib.Path(self.folder.name) / "test_some"
        program.write_text(PROGRAM)
        program.chmod(0o755)
        self.programs = {"test_some": program}

    def found(self, row):
        return list(problems([row], self.programs))

    def test_accepts_a_row_with_a_test_and_a_reason(self):
        self.assertEqual(self.found("slow test_some Suite.* kills"), [])
        self.assertEqual(self.found("# a comment"), [])

    def test_notices_each_kind_of_wrong_row(self):
        self.assertEqual(self.found("slow test_some Renamed.* kills"), ["line 1: test_some has no test Renamed.*"])
        self.assertEqual(self.found("slow test_other Suite.* kills"), ["line 1: no program test_other was built"])
        for row in ("slow test_some Suite.*", "never test_some Suite.* kills"):
            self.assertEqual(self.found(row), ["line 1: must be: slow or nightly, program, pattern, reason"])


if __name__ == "__main__":
    unittest.main()
