#!/usr/bin/env python3
"""Installs a wheel next to one version of MuJoCo into a new virtual environment, and replays the sweep with its plugin.

    versions.py --wheel WHEEL --mujoco 3.17.0 --plugins 4.0.1 3.17.0 --golden sweep_peaks.json --build build/release --hide FOLDER...

--plugins are the versions of MuJoCo for which the wheel must have a plugin. In any other version the package must refuse.
Exits with status 77 (skipped) and a reason if the environment cannot be made.
"""
import argparse
import json
import pathlib
import shutil
import sys
import tempfile

from environment import Environment, hiding_script, only_wheel

HERE = pathlib.Path(__file__).parent.resolve()
LOAD = """
import warnings
warnings.simplefilter("always")
with warnings.catch_warnings(record=True) as caught:
    import mujoco  # 4.0 and later warn of an entry point that fails
import taxel
try:
    taxel.load_plugin()
except taxel.Error as error:
    print(error, *(warning.message for warning in caught))
"""
LOAD_ANOTHER = """
import pathlib
import mujoco, taxel
mujoco.mj_loadPluginLibrary(str(pathlib.Path(taxel.__file__).parent / "lib/taxel/mujoco-{version}/libtaxel_plugin.so"))
try:
    mujoco.MjModel.from_xml_path(str(taxel.EXAMPLES / "scenes/press.xml"))
    print("loads")
except ValueError as error:
    print("refuses:", error)
"""


def requirement(version):
    """Returns the package that has the library. From 4.0.1 on, `mujoco` itself is only a shim."""
    return f"mujoco-core=={version}" if version == "4.0.1" else f"mujoco=={version}"


def fail(reason):
    sys.exit(f"versions.py: {reason}")


def replay(environment, version, golden):
    """Replays the sweep without the build, and with the build and its cache in reach."""
    largest = max(json.loads(pathlib.Path(golden).read_text()).values())
    for hidden in (True, False):
        words = environment.run("python", "in_mujoco.py", "run", hidden=hidden).split()
        if words[0] != version or words[2] != "1" or f"mujoco-{version}" not in words[3]:
            fail(f"MuJoCo {words[0]} was loaded {words[2]} times, with the plugin {words[3]}")
        # Other last digits can cost or save an iteration of friction: docs/plugin.md.
        if abs(float(words[1]) - largest) > 1e-8 * largest:
            fail(f"the peak is {words[1]} Pa, the golden one {largest}")
    print(f"MuJoCo {version}: peak {words[1]} Pa, golden {largest} Pa, one libmujoco")


def check_plugins_of_others(environment, version, plugins):
    """Loads each other plugin of the wheel by its path. In MuJoCo 4.0 and later, the right one is there already."""
    expected = "loads" if version >= "4" else "refuses"
    for other in plugins:
        if other == version:
            continue
        log = environment.folder / "MUJOCO_LOG.TXT"  # MuJoCo writes its warnings into the working folder
        log.unlink(missing_ok=True)
        said = environment.run("python", "-c", LOAD_ANOTHER.format(version=other)) + log.read_text()
        for words in (expected, f"built for MuJoCo {other}", f"this is MuJoCo {version}"):
            if words not in said:
                fail(f'the plugin for MuJoCo {other} does not say "{words}"')


def check_absent_plugin(environment, version, plugins):
    """Checks the package in a MuJoCo for which it has no plugin."""
    said = environment.run("python", "-c", LOAD)
    entry_point = ["Failed to load mujoco plugin entry point taxel"] if version >= "4" else []
    for words in (f"MuJoCo {version} is installed", *plugins, *entry_point):
        if words not in said:
            fail(f'the package does not say "{words}"')


def main():
    parser = argparse.ArgumentParser()
    for name in ("wheel", "mujoco", "golden", "build"):
        parser.add_argument(f"--{name}", required=True)
    for name in ("plugins", "hide"):
        parser.add_argument(f"--{name}", nargs="+", default=[])
    args = parser.parse_args()
    wheel = only_wheel(args.wheel)
    script = hiding_script(args.hide, pathlib.Path(args.build).resolve())
    with tempfile.TemporaryDirectory(prefix="taxel-wheel") as name:
        folder = pathlib.Path(name)
        environment = Environment(folder, script, wheel, requirement(args.mujoco))
        installed = environment.run("python", "-c", "import taxel; print(*taxel.plugin_versions())").split()
        if installed != args.plugins:
            fail(f"the wheel has plugins for MuJoCo {', '.join(installed)}, expected are {', '.join(args.plugins)}")
        if args.mujoco in args.plugins:
            shutil.copy(HERE / "in_mujoco.py", folder)
            replay(environment, args.mujoco, args.golden)
            check_plugins_of_others(environment, args.mujoco, args.plugins)
            (library,) = folder.glob(f"venv/lib/python*/site-packages/taxel/lib/taxel/mujoco-{args.mujoco}")
            shutil.rmtree(library)
            args.plugins.remove(args.mujoco)
        check_absent_plugin(environment, args.mujoco, args.plugins)


if __name__ == "__main__":
    main()
