#!/usr/bin/env python3
"""Makes a virtual environment with mujoco-core alone, records sweeps with `taxel`, and runs plugin_test.py in it.

Exits 77 (skipped) with a reason where the environment cannot be made.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import venv

SKIPPED = 77


def skip(reason):
    print(reason)
    sys.exit(SKIPPED)


def make_environment(folder, version):
    """The environment's Python; made once, made anew when it was left half-done."""
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
        skip(f"mujoco-core {version} cannot be installed for Python {sys.version.split()[0]}: {reason}")
    done.touch()
    return python


def record(taxel, folder, options):
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([taxel, "sweep", "--quiet", "--out", str(folder), *options], check=True)
    return folder


def main():
    parser = argparse.ArgumentParser()
    for name in ("version", "venv", "work", "taxel", "plugin", "real"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work = pathlib.Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    python = make_environment(pathlib.Path(args.venv), args.version)
    folders = [record(args.taxel, work / "coarse", ["--density", "1e5"]), record(args.taxel, work / "own", [])]
    real = pathlib.Path(args.real) / "shadow_fingertip.taxels.json"
    if real.exists():
        folders.append(record(args.taxel, work / "real", ["--layout", str(real)]))
    else:
        print(f"only the project's own finger: {real} is absent")
    # From another folder: the scene must find its files by itself.
    test = pathlib.Path(__file__).with_name("plugin_test.py").resolve()
    elsewhere = work / "elsewhere"
    elsewhere.mkdir(exist_ok=True)
    command = [str(python), str(test), args.plugin, *map(str, folders)]
    sys.exit(subprocess.run(command, cwd=elsewhere).returncode)


if __name__ == "__main__":
    main()
