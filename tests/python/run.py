#!/usr/bin/env python3
"""Installs the package from the build into a folder and runs tests of this folder with it.

MuJoCo, NumPy and the packages that some pages need are in the cache of scripts/setup. Exits with status 77 (skipped) and a
reason if MuJoCo or NumPy is not.
"""
import argparse
import pathlib
import sys

from environment_of_package import COMPONENTS, environment_of, install, run_tests

HERE = pathlib.Path(__file__).parent.resolve()
OPTIONAL = ("gymnasium", "mcap", "parquet", "ray", "mypy")


def main():
    parser = argparse.ArgumentParser()
    for name in ("mujoco", "recorded", "work", "cache", "cmake", "build", "tag", "golden"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--tests", default="*_test.py", help="pattern of the files")
    parser.add_argument("--components", nargs="*", default=COMPONENTS, help="of the package, besides the module")
    args = parser.parse_args()
    work, cache = pathlib.Path(args.work).resolve(), pathlib.Path(args.cache)
    mujoco = cache / (f"mujoco-core-{args.mujoco}" if args.mujoco == args.recorded else f"mujoco-{args.mujoco}")
    folders = [work / "package", mujoco, cache / "python-packages", *(cache / f"{name}-packages" for name in OPTIONAL)]
    # Nothing is drawn: MuJoCo 3 would import the package glfw, which is not in the cache.
    variables = environment_of(folders, "mujoco, numpy", f"MuJoCo {args.mujoco} in {cache}, so the package is untested in it",
                               MUJOCO_GL="disable", TAXEL_GOLDEN=args.golden)
    install(args.cmake, args.build, args.tag, work / "package", args.components)
    sys.exit(run_tests(HERE, work, variables, args.tests))


if __name__ == "__main__":
    main()
