#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs the tests of this folder with it.

The tests run in a virtual environment with mujoco-core and NumPy. Exits with status 77 (skipped) and a reason if the
environment cannot be made.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import venv

SKIPPED = 77
COMPONENTS = ["programs", "plugin", "data"]


def make_environment(folder, version):
    """Returns the environment's Python. The environment is made once, and again if it is incomplete."""
    python = folder / "bin" / "python"
    done = folder / f"mujoco-core-{version}"
    if done.exists():
        return python
    shutil.rmtree(folder, ignore_errors=True)
    venv.create(folder, with_pip=True)
    pip = [str(python), "-m", "pip", "--quiet", "--disable-pip-version-check", "install"]
    result = subprocess.run([*pip, "--only-binary=:all:", f"mujoco-core=={version}"], capture_output=True, text=True)
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"mujoco-core {version} cannot be installed for Python {sys.version.split()[0]}: {reason}")
        sys.exit(SKIPPED)
    done.touch()
    return python


def install(cmake, build, tag, folder):
    """Installs the package into folder/taxel, as it is in the wheel but for taxelstudio."""
    shutil.rmtree(folder, ignore_errors=True)
    for component in [*COMPONENTS, f"python_{tag}"]:
        command = [cmake, "--install", build, "--component", component, "--prefix", str(folder / "taxel")]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


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
