#!/usr/bin/env python3
"""Tests that the comparison with Drake is skipped without an error if Drake is absent. drake_test.py bench/drake/run"""
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.abspath(sys.argv[1])


class DrakeTest(unittest.TestCase):
    def test_is_skipped_if_drake_is_absent(self):
        with tempfile.TemporaryDirectory() as cache:
            environment = dict(os.environ, TAXEL_CACHE=cache, BUILD=os.path.join(cache, "build"))
            result = subprocess.run([SCRIPT], env=environment, capture_output=True, text=True)
            self.assertEqual(os.listdir(cache), [], "nothing is built for a comparison that cannot run")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "", "no table without a peer")
        self.assertIn("skipped", result.stderr)
        self.assertIn(cache, result.stderr)
        self.assertIn("scripts/setup --bench", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
