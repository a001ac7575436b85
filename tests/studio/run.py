#!/usr/bin/env python3
"""Installs the package and MuJoCo 4.0.0 with its Studio, and runs the tests of this folder.

Screenshots of the window stay in the folder `images` of --work. Exits with status 77 (skipped) and a reason if the
environment cannot be made.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).parent.resolve()
sys.path.insert(0, str(HERE.parent / "python"))
from environment_of_package import SKIPPED, install  # noqa: E402  tests/python

REQUIREMENTS = ["4.0.0.txt", "python.txt", "studio.txt"]


def make_environment(folder, requirements):
    """Returns the Python of an environment with these packages, by hash. It is made again when the lists change."""
    python = folder / "bin" / "python"
    wanted = "".join((requirements / name).read_text() for name in REQUIREMENTS)
    made = folder / "made_of.txt"
    if made.exists() and made.read_text() == wanted:
        return python
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder, with_pip=True)
    command = [str(python), "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--no-deps", "--require-hashes",
               "--only-binary=:all:"]
    for name in REQUIREMENTS:
        command += ["-r", str(requirements / name)]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"the Studio of MuJoCo 4.0.0 cannot be installed for Python {sys.version.split()[0]}: {reason}")
        sys.exit(SKIPPED)
    made.write_text(wanted)
    return python


def main():
    parser = argparse.ArgumentParser()
    for name in ("work", "cmake", "build", "tag", "requirements"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work = pathlib.Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    python = make_environment(work / "venv", pathlib.Path(args.requirements))
    install(args.cmake, args.build, args.tag, work / "package")
    for name in ("elsewhere", "images", "home"):  # Studio writes its settings into the home folder
        (work / name).mkdir(exist_ok=True)
    environment = {**os.environ, "PYTHONPATH": str(work / "package"), "HOME": str(work / "home"),
                   "TAXEL_IMAGES": str(work / "images")}
    command = [str(python), "-m", "unittest", "discover", "--start-directory", str(HERE), "--pattern", "*_test.py", "-v"]
    sys.exit(subprocess.run(command, cwd=work / "elsewhere", env=environment).returncode)


if __name__ == "__main__":
    main()
