"""The package of the build and the environment in which tests of several folders run it."""
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
