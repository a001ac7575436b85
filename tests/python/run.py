#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs the tests of this folder with it.

The tests run in a virtual environment with mujoco-core and NumPy. Exits with status 77 (skipped) and a reason if the
environment cannot be made.
"""
import argparse
import os
import pathlib
import subprocess
import sys

from environment_of_package import install, make_environment


def main():
    parser = argparse.ArgumentParser()
    for name in ("version", "work", "cmake", "build", "tag", "golden"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work = pathlib.Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    python = make_environment(work / "venv", args.version)
    install(args.cmake, args.build, args.tag, work / "package")
    # Runs in an empty folder, so that nothing is found in the working directory.
    elsewhere = work / "elsewhere"
    elsewhere.mkdir(exist_ok=True)
    environment = {**os.environ, "PYTHONPATH": str(work / "package"), "TAXEL_GOLDEN": args.golden}
    tests = str(pathlib.Path(__file__).parent.resolve())
    command = [str(python), "-m", "unittest", "discover", "--start-directory", tests, "--pattern", "*_test.py"]
    sys.exit(subprocess.run(command, cwd=elsewhere, env=environment).returncode)


if __name__ == "__main__":
    main()
