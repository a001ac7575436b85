#!/usr/bin/env python3
"""Tests the plugins of all versions of MuJoCo in one of them.

    versions.py --mujoco VERSION --recorded VERSION --cache FOLDER --taxel PROGRAM --scene FILE --work FOLDER [--refusals] VERSION=LIBRARY...

--recorded is the version with which the program `taxel` records, and each VERSION=LIBRARY is a plugin. With --refusals,
the plugins of the other versions have to refuse this MuJoCo, and its own plugin is not tested. The packages of
Python come from the cache of scripts/setup. Exits with status 77 (skipped) and a reason if this MuJoCo is not there.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
HERE = pathlib.Path(__file__).resolve().parent


def environment_of(cache, version, recorded):
    """Returns the variables of a process that imports this MuJoCo and nothing of the user's own packages."""
    name = f"mujoco-core-{version}" if version == recorded else f"mujoco-{version}"
    variables = dict(os.environ, PYTHONPATH=f"{cache / name}:{cache / 'python-packages'}", PYTHONNOUSERSITE="1",
                     PYTHONDONTWRITEBYTECODE="1", MUJOCO_GL="disable")
    show = "import mujoco; print(mujoco.__version__)"
    result = subprocess.run([sys.executable, "-S", "-c", show], env=variables, capture_output=True, text=True)
    if result.stdout.strip() == version:
        return variables
    reason = (result.stderr.strip().splitlines() or [f"it imports MuJoCo {result.stdout.strip()}"])[-1]
    print(f"Python {sys.version.split()[0]} has no MuJoCo {version} in {cache / name}, so its plugin is untested "
          f"(scripts/setup installs it): {reason}")
    sys.exit(SKIPPED)


def library_of_another(cache, version):
    """Returns the library of another MuJoCo in the cache."""
    libraries = sorted(cache.glob("mujoco-*/mujoco/libmujoco.so.*"))
    return next(library for library in libraries if not library.name.endswith(f".so.{version}"))


def loads_alone(plugin, version):
    """Loads the plugin in a process without MuJoCo. Returns 0 if the plugin then names the MuJoCo that it needs."""
    load = [sys.executable, "-S", "-c", f"import ctypes; ctypes.CDLL({plugin!r})"]
    result = subprocess.run(load, capture_output=True, text=True)
    if result.returncode == 0 and f"load the plugin from MuJoCo {version}" in result.stderr:
        return 0
    print(f"the plugin without MuJoCo: status {result.returncode}, {result.stderr}")
    return 1


def test_own_plugin(plugin, args, sweep, python, variables, folder):
    """Runs the tests of the plugin of this MuJoCo. Returns 0 if all pass."""
    second = library_of_another(pathlib.Path(args.cache), args.mujoco)
    failures = 0
    for script, *arguments in (("right_version.py", sweep, args.recorded), ("attached.py", sweep),
                               ("sharing.py", pathlib.Path(args.scene).resolve()), ("two_mujocos.py", sweep, second),
                               ("refused_scenes.py",),
                               ("patched.py", pathlib.Path(args.taxel).resolve(), args.recorded)):
        command = [*python, str(HERE / script), plugin, *map(str, arguments)]
        failures |= subprocess.run(command, env=variables, cwd=folder).returncode
    return failures | loads_alone(plugin, args.mujoco)


def main():
    parser = argparse.ArgumentParser()
    for name in ("mujoco", "recorded", "cache", "taxel", "scene", "work"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--refusals", action="store_true")
    parser.add_argument("plugins", nargs="+", metavar="VERSION=LIBRARY")
    args = parser.parse_args()
    cache, work = pathlib.Path(args.cache), pathlib.Path(args.work).resolve()
    plugins = dict(plugin.split("=", 1) for plugin in args.plugins)
    variables = environment_of(cache, args.mujoco, args.recorded)
    if args.mujoco not in plugins:
        print(f"there is no plugin for MuJoCo {args.mujoco}, because its headers were absent: configure the build again")
        sys.exit(SKIPPED)
    shutil.rmtree(work, ignore_errors=True)
    elsewhere = work / "elsewhere"  # MuJoCo writes its log into the working folder
    elsewhere.mkdir(parents=True)
    sweep = work / "sweep"
    subprocess.run([args.taxel, "sweep", "--quiet", "--threads", "1", "--object", "box", "--density", "1e5", "--out",
                    str(sweep)], check=True, stdout=subprocess.DEVNULL)
    python = [sys.executable, "-S"]
    failures = 0 if args.refusals else test_own_plugin(plugins[args.mujoco], args, sweep, python, variables, elsewhere)
    for version, plugin in plugins.items():
        if version == args.mujoco:
            continue
        wrong = [*python, str(HERE / "wrong_version.py"), plugin, version, str(sweep), plugins[args.mujoco]]
        result = subprocess.run(wrong, env=variables, cwd=elsewhere, capture_output=True, text=True)
        refuses = result.returncode == 0 and "start a new process" in result.stdout + result.stderr
        print(f"plugin for MuJoCo {version} in MuJoCo {args.mujoco}: {'refuses' if refuses else 'FAILS'}")
        if not refuses:
            print(result.stdout + result.stderr)
            failures = 1
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
