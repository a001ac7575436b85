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
import subprocess
import sys
import tempfile
import time
import venv

SKIPPED = 77
HERE = pathlib.Path(__file__).parent.resolve()
ALWAYS_THERE = ("ld-linux", "libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "libgcc_s.so", "libstdc++.so")
GRAPHICS = ("libEGL.so.1", "libGL.so.1", "libGLX.so.0", "libOpenGL.so.0", "libX11.so.6", "libXcursor.so.1", "libXi.so.6",
            "libXinerama.so.1", "libXrandr.so.2")


def skip(reason):
    print(reason)
    sys.exit(SKIPPED)


def libraries_of(files):
    """Returns the paths of the shared libraries of the system that these files load, with their dependencies."""
    found = set()
    for file in files:
        for line in subprocess.run(["ldd", str(file)], capture_output=True, text=True).stdout.splitlines():
            if "=> /" in line:
                found.add(pathlib.Path(line.split("=>")[1].split()[0]).resolve())
    return found


def libraries_to_hide(build):
    """Returns the libraries that the build uses and that a system with OpenGL need not have."""
    system = [folder for folder in pathlib.Path("/usr/lib").glob("*-linux-gnu")]
    graphics = [file for folder in system for name in GRAPHICS for file in folder.glob(name)]
    graphics += [file for folder in system for pattern in ("libEGL_*.so.*", "libGLX_*.so.*", "dri/*.so") for file in folder.glob(pattern)]
    built = [*(build / "bin").glob("taxel*"), *(build / "lib").rglob("*.so"), *(build / "python").rglob("*.so")]
    hidden = libraries_of(built) - libraries_of(graphics)
    return sorted(file for file in hidden if not file.name.startswith(ALWAYS_THERE) and not file.is_relative_to(build))


def hiding_script(folders, libraries):
    """Returns a shell script that hides folders and files and then becomes its arguments."""
    lines = ["set -e"]
    lines += [f"[ ! -d '{folder}' ] || mount -t tmpfs -o ro none '{folder}'" for folder in folders]
    lines += [f"[ ! -e '{library}' ] || mount --bind /dev/null '{library}'" for library in libraries]
    return "\n".join([*lines, 'exec "$@"'])


class Environment:
    """A virtual environment that runs its programs without the build."""

    def __init__(self, folder, script):
        self.folder = folder
        self.script = script

    def run(self, *command):
        whole = ["unshare", "-m", "bash", "-c", self.script, "bash", *map(str, command)]
        clean = {"PATH": f"{self.folder / 'venv' / 'bin'}:/usr/bin:/bin", "HOME": str(self.folder), "LANG": "C.UTF-8"}
        result = subprocess.run(whole, cwd=self.folder, env=clean, capture_output=True, text=True)
        print(f"$ {' '.join(map(str, command))}\n{result.stdout}{result.stderr}", end="", flush=True)
        if result.returncode != 0:
            sys.exit(f"status {result.returncode}")
        return result.stdout


def install(folder, wheel, version):
    venv.create(folder / "venv", with_pip=True)
    pip = [folder / "venv" / "bin" / "python", "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--only-binary=:all:"]
    result = subprocess.run([*map(str, pip), f"mujoco-core=={version}", "numpy"], capture_output=True, text=True)
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        skip(f"mujoco-core {version} cannot be installed for Python {sys.version.split()[0]}: {reason}")
    subprocess.run([*map(str, pip), str(wheel)], check=True)


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
    for peak in (by_program, float(by_module), float(by_plugin)):
        if abs(peak - largest) > 1e-6 * largest:
            sys.exit(f"the peak is {peak} {unit}, the golden one {largest}")
    import_time = "import time; t = time.perf_counter(); import taxel; taxel.Layout; print(time.perf_counter() - t)"
    fastest = min(float(environment.run("python", "-c", import_time)) for _ in range(3))
    if fastest > 0.3:
        sys.exit(f"importing taxel takes {fastest:.3f} s")
    print(f"Python {sys.version.split()[0]}: golden peak {largest} {unit} by program, module and plugin; import {fastest:.3f} s")


def main():
    parser = argparse.ArgumentParser()
    for name in ("wheel", "version", "golden", "build"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--hide", nargs="+", default=[])
    args = parser.parse_args()
    wheels = list(pathlib.Path(args.wheel).parent.glob(pathlib.Path(args.wheel).name))  # the name may have wildcards
    if len(wheels) != 1:
        skip(f"{len(wheels)} files are named {args.wheel}, not 1: make the wheel first")
    wheel = wheels[0]
    build = pathlib.Path(args.build).resolve()
    libraries = libraries_to_hide(build)
    script = hiding_script(args.hide, libraries)
    if subprocess.run(["unshare", "-m", "bash", "-c", script, "bash", "true"], capture_output=True).returncode != 0:
        skip("the build cannot be hidden: `unshare -m` needs the rights of root")
    print("hidden: " + ", ".join([*args.hide, *(library.name for library in libraries)]))
    with tempfile.TemporaryDirectory(prefix="taxel-wheel") as name:
        folder = pathlib.Path(name)
        start = time.monotonic()
        install(folder, wheel, args.version)
        shutil.copy(HERE / "golden_peak.py", folder)
        check(Environment(folder, script), args.golden)
        print(f"{time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    main()
