#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs the tests of this folder with it.

NumPy and pyarrow are in the cache of scripts/setup. Exits with status 77 (skipped) and a reason if they are not.
"""
import argparse
import pathlib
import sys

HERE = pathlib.Path(__file__).parent.resolve()
sys.path.insert(0, str(HERE.parent / "python"))
from environment_of_package import environment_of, install, run_tests  # noqa: E402  tests/python


def main():
    parser = argparse.ArgumentParser()
    for name in ("work", "cache", "cmake", "build", "tag"):
        parser.add_argument(f"--{name}", required=True)
    args = parser.parse_args()
    work, cache = pathlib.Path(args.work).resolve(), pathlib.Path(args.cache)
    variables = environment_of([work / "package", cache / "parquet-packages"], "numpy, pyarrow.dataset",
                               f"NumPy or no pyarrow in {cache}, so the worked cases are untested")
    install(args.cmake, args.build, args.tag, work / "package", ["programs", "data"])
    sys.exit(run_tests(HERE, work, variables))


if __name__ == "__main__":
    main()
