"""The package of the build and the environment in which tests of several folders run it."""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import venv

SKIPPED = 77
COMPONENTS = ["programs", "plugin", "data"]


def make_environment(folder, version):
    """Returns the Python of an environment with mujoco-core. It is made once, and again if it is incomplete.

    Ends the process with status 77 and the reason if MuJoCo cannot be installed.
    """
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
        print(f"mujoco-core {version} cannot be installed for Python {sys.version.split()[0]}: {reason}")
        sys.exit(SKIPPED)
    done.touch()
    return python


def install(cmake, build, tag, folder, components=COMPONENTS):
    """Installs the package into folder/taxel, as it is in the wheel but for components that are not named."""
    shutil.rmtree(folder, ignore_errors=True)
    for component in [*components, f"python_{tag}"]:
        command = [cmake, "--install", build, "--component", component, "--prefix", str(folder / "taxel")]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def package_of_arguments(components):
    """Installs the package as the arguments of this process say, and makes it importable: --work, --cmake, --build, --tag.

    Returns its folder.
    """
    parser = argparse.ArgumentParser()
    for option in ("work", "cmake", "build", "tag"):
        parser.add_argument(f"--{option}", required=True)
    args = parser.parse_args()
    folder = pathlib.Path(args.work).resolve() / "package"
    install(args.cmake, args.build, args.tag, folder, components)
    sys.path.insert(0, str(folder))
    return folder


def environment_of(folders, imports, untested, **others):
    """Returns the variables of a process that has the packages in `folders` and nothing of the user's own.

    Ends the process with status 77 and the reason if Python cannot import `imports` from them. `untested` names the packages
    and says which tests need them. `others` are further variables.
    """
    variables = dict(os.environ, PYTHONPATH=os.pathsep.join(map(str, folders)), PYTHONNOUSERSITE="1",
                     PYTHONDONTWRITEBYTECODE="1")
    variables.pop("MUJOCO_GL", None)
    variables.update(others)
    result = subprocess.run([sys.executable, "-S", "-c", f"import {imports}"], env=variables, capture_output=True, text=True)
    if result.returncode != 0:
        reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
        print(f"Python {sys.version.split()[0]} has no {untested} (scripts/setup installs them): {reason}")
        sys.exit(SKIPPED)
    return variables


def run_tests(tests, work, variables, pattern="*_test.py"):
    """Runs the unit tests in the folder `tests` in files of this pattern, and returns their exit status. `variables` are those of environment_of()."""
    elsewhere = work / "elsewhere"  # an empty folder, so that nothing is found in the working directory
    elsewhere.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, "-S", "-m", "unittest", "discover", "--start-directory", str(tests), "--pattern", pattern]
    return subprocess.run(command, cwd=elsewhere, env=variables).returncode
