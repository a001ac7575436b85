#!/usr/bin/env python3
"""Makes a virtual environment with only mujoco-core, records sweeps with `taxel`, and runs plugin_test.py in it.

Exits with status 77 (skipped) and a reason if the environment cannot be made.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.resolve().parent / "python"))
from environment_of_package import make_environment  # noqa: E402  tests/python


def record_all(taxel, sweeps):
    """Runs `taxel sweep` for each pair of folder and options, all at the same time."""
    running = []
    for folder, options in sweeps:
        shutil.rmtree(folder, ignore_errors=True)
        command = [taxel, "sweep", "--quiet", "--threads", "1", "--out", str(folder), *options]
        running.append(subprocess.Popen(command, stdout=subprocess.DEVNULL))
    if any([process.wait() for process in running]):
        sys.exit("taxel sweep failed")
    return [folder for folder, _ in sweeps]


def main():
    parser = argparse.ArgumentParser()
    for name in ("version", "venv", "work", "taxel", "plugin", "real"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work = pathlib.Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    python = make_environment(pathlib.Path(args.venv), args.version)
    # The coarse sweep is only as long as the quick tests need, which add 13 mm themselves.
    coarse = ["--object", "box", "--density", "1e5", "--past", "0"]
    sweeps = [(work / "coarse", coarse), (work / "own", []), (work / "box", ["--object", "box"]),
              (work / "paper", ["--as-in-the-paper"])]
    real = pathlib.Path(args.real) / "shadow_fingertip.taxels.json"
    if real.exists():
        sweeps.append((work / "real", ["--layout", str(real)]))
    else:
        print(f"only the project's own finger: {real} is absent")
    folders = record_all(args.taxel, sweeps)
    # Runs in another folder, so the scene must find its files without the working folder.
    test = pathlib.Path(__file__).with_name("plugin_test.py").resolve()
    elsewhere = work / "elsewhere"
    elsewhere.mkdir(exist_ok=True)
    command = [str(python), str(test), args.plugin, *map(str, folders)]
    sys.exit(subprocess.run(command, cwd=elsewhere).returncode)


if __name__ == "__main__":
    main()
