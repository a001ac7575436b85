#!/usr/bin/env python3
"""Installs a wheel into a new virtual environment of the Python that runs this script, and tries it there.

    run.py --wheel WHEEL --version 4.0.1 --golden sweep_peaks.json --build build/release --hide FOLDER...

The wheel runs in a mount namespace in which the source tree, the cache and every shared library of the build are hidden.
Of the system it has glibc, libstdc++, and OpenGL and X11 with their own dependencies. Exits with status 77 (skipped) and a
reason if no such namespace or no environment can be made.
"""
import argparse
import json
import pathlib
import shutil
import sys
import tempfile
import time

from environment import Environment, hiding_script, only_wheel

HERE = pathlib.Path(__file__).parent.resolve()


def check(environment, golden):
    """Runs the programs and the script, and compares their peaks with the golden one."""
    peaks = json.loads(pathlib.Path(golden).read_text())
    largest = max(peaks.values())
    environment.run("taxel", "--version")
    environment.run("taxel", "sweep", "--out", "sweep")
    sensor = json.loads((environment.folder / "sweep" / "sweep.json").read_text())["sensors"][0]
    by_program = max(taxel["peak"] for taxel in sensor["taxels"])
    environment.run("taxelstudio", "--headless", "--frames", "30", "--screenshot", "window.png")
    if (environment.folder / "window.png").stat().st_size < 10000:
        sys.exit("taxelstudio wrote no image")
    # The script does not load the plugin: `import mujoco` does, by the entry point of the wheel.
    by_module, by_plugin, unit = environment.run("python", "golden_peak.py", "run").split()
    read = (by_program, float(by_module), float(by_plugin))
    for peak in read:
        if abs(peak - largest) > 1e-12 * largest:
            sys.exit(f"the peak is {peak} {unit}, the golden one {largest}")
    import_time = "import time; t = time.perf_counter(); import taxel; taxel.Layout; print(time.perf_counter() - t)"
    fastest = min(float(environment.run("python", "-c", import_time)) for _ in range(3))
    if fastest > 0.3:
        sys.exit(f"importing taxel takes {fastest:.3f} s")
    print(f"Python {sys.version.split()[0]}: peaks {read} {unit} by program, module and plugin, golden {largest}; "
          f"import {fastest:.3f} s")


def main():
    parser = argparse.ArgumentParser()
    for name in ("wheel", "version", "golden", "build"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--hide", nargs="+", default=[])
    args = parser.parse_args()
    wheel = only_wheel(args.wheel)
    script = hiding_script(args.hide, pathlib.Path(args.build).resolve())
    with tempfile.TemporaryDirectory(prefix="taxel-wheel") as name:
        folder = pathlib.Path(name)
        start = time.monotonic()
        environment = Environment(folder, script, wheel, f"mujoco-core=={args.version}")
        shutil.copy(HERE / "golden_peak.py", folder)
        check(environment, args.golden)
        print(f"{time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    main()
