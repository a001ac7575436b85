#!/usr/bin/env python3
"""Each row of tests/tiers.txt names tests that exist, and has a reason.

A renamed test would otherwise return to the first tier without a word.

usage: check_tiers.py TIERS BUILD_FOLDER
"""
import pathlib
import subprocess
import sys


def tests_of(program, pattern):
    """Returns the number of tests of a GoogleTest program that match a pattern."""
    listed = subprocess.run([program, "--gtest_list_tests", f"--gtest_filter={pattern}"], capture_output=True, text=True, check=True)
    return sum(line.startswith("  ") for line in listed.stdout.splitlines())


def problems(rows, programs):
    """Yields the problems of the rows of the list. `programs` has the test programs by name."""
    for number, row in enumerate(rows, 1):
        if not row or row.startswith("#"):
            continue
        words = row.split()
        if len(words) < 4 or words[0] not in ("slow", "nightly"):
            yield f"line {number}: must be: slow or nightly, program, pattern, reason"
        elif words[1] not in programs:
            yield f"line {number}: no program {words[1]} was built"
        elif tests_of(programs[words[1]], words[2]) == 0:
            yield f"line {number}: {words[1]} has no test {words[2]}"


def main():
    rows = pathlib.Path(sys.argv[1]).read_text().splitlines()
    found = pathlib.Path(sys.argv[2]).glob("tests/**/test_*")
    programs = {path.name: path for path in found if path.is_file() and path.stat().st_mode & 0o100}
    wrong = list(problems(rows, programs))
    for line in wrong:
        print(f"tests/tiers.txt: {line}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
