#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs the tests of this folder with it.

NumPy and pyarrow are in the cache of scripts/setup. Exits with status 77 (skipped) and a reason if they are not.
"""
import argparse
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.resolve().parent / "python"))
from environment_of_package import SKIPPED, install  # noqa: E402  tests/python

COMPONENTS = ["programs", "data"]


def environment_of(cache, package):
    """Returns the variables of a process that has these packages and nothing of the user's own."""
    folders = [package, cache / "parquet-packages"]
    variables = dict(os.environ, PYTHONPATH=os.pathsep.join(map(str, folders)), PYTHONNOUSERSITE="1",
                     PYTHONDONTWRITEBYTECODE="1")
    result = subprocess.run([sys.executable, "-S", "-c", "import numpy, pyarrow.dataset"], env=variables, capture_output=True, text=True)
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"Python {sys.version.split()[0]} has no pyarrow in {cache}, so the worked cases are untested (scripts/setup "
              f"installs it): {reason}")
        sys.exit(SKIPPED)
    return variables


def main():
    parser = argparse.ArgumentParser()
    for name in ("work", "cache", "cmake", "build", "tag"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work = pathlib.Path(args.work).resolve()
    elsewhere = work / "elsewhere"  # an empty folder, so that nothing is found in the working directory
    elsewhere.mkdir(parents=True, exist_ok=True)
    variables = environment_of(pathlib.Path(args.cache), work / "package")
    install(args.cmake, args.build, args.tag, work / "package", COMPONENTS)
    tests = str(pathlib.Path(__file__).parent.resolve())
    command = [sys.executable, "-S", "-m", "unittest", "discover", "--start-directory", tests, "--pattern", "*_test.py"]
    sys.exit(subprocess.run(command, cwd=elsewhere, env=variables).returncode)


if __name__ == "__main__":
    main()
