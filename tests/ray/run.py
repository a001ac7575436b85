#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs ray_test.py with it and with Ray from the cache.

Exits with status 77 (skipped) and the reason if Ray cannot be imported. `--jobs N` runs another number of jobs.
"""
import argparse
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).parent.resolve()
sys.path.insert(0, str(HERE.parent / "python"))
from environment_of_package import SKIPPED, install  # noqa: E402  tests/python


def main():
    parser = argparse.ArgumentParser()
    for name in ("work", "cmake", "build", "tag", "ray"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--jobs", default="40")
    args = parser.parse_args()
    work = pathlib.Path(args.work)
    work.mkdir(parents=True, exist_ok=True)
    paths = os.pathsep.join([str(work / "package"), args.ray])
    environment = {**os.environ, "PYTHONPATH": paths, "PYTHONNOUSERSITE": "1", "TAXEL_RAY_JOBS": args.jobs}
    found = subprocess.run([sys.executable, "-c", "import ray"], env=environment, capture_output=True, text=True)
    if found.returncode != 0:
        reason = (found.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"skipped: Ray cannot be imported from {args.ray} ({reason}); scripts/setup installs it")
        sys.exit(SKIPPED)
    install(args.cmake, args.build, args.tag, work / "package")
    sys.exit(subprocess.run([sys.executable, str(HERE / "ray_test.py"), "-v"], cwd=work, env=environment).returncode)


if __name__ == "__main__":
    main()
