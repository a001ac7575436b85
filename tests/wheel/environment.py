"""Virtual environments with a wheel, in which the build, its sources and its libraries are hidden."""
import pathlib
import subprocess
import sys
import venv

SKIPPED = 77
ALWAYS_THERE = ("ld-linux", "libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "libgcc_s.so", "libstdc++.so")
GRAPHICS = ("libEGL.so.1", "libGL.so.1", "libGLX.so.0", "libOpenGL.so.0", "libX11.so.6", "libXcursor.so.1", "libXi.so.6",
            "libXinerama.so.1", "libXrandr.so.2")


def skip(reason):
    print(reason)
    sys.exit(SKIPPED)


def only_wheel(name):
    """Returns the only file of this name, which may have wildcards."""
    wheels = list(pathlib.Path(name).parent.glob(pathlib.Path(name).name))
    if len(wheels) != 1:
        skip(f"{len(wheels)} files are named {name}, not 1: make the wheel first")
    return wheels[0]


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


def hiding_script(folders, build):
    """Returns a shell script that hides folders and the libraries of the build and then becomes its arguments."""
    libraries = libraries_to_hide(build)
    lines = ["set -e"]
    lines += [f"[ ! -d '{folder}' ] || mount -t tmpfs -o ro none '{folder}'" for folder in folders]
    lines += [f"[ ! -e '{library}' ] || mount --bind /dev/null '{library}'" for library in libraries]
    script = "\n".join([*lines, 'exec "$@"'])
    if subprocess.run(["unshare", "-m", "bash", "-c", script, "bash", "true"], capture_output=True).returncode != 0:
        skip("the build cannot be hidden: `unshare -m` needs the rights of root")
    print("hidden: " + ", ".join([*folders, *(library.name for library in libraries)]))
    return script


class Environment:
    """A virtual environment with a wheel and a MuJoCo. Its programs run without the build."""

    def __init__(self, folder, script, wheel, mujoco):
        """`mujoco` is a requirement of pip, such as mujoco==3.17.0. Skips the test if it cannot be installed."""
        self.folder = folder
        self.script = script
        venv.create(folder / "venv", with_pip=True)
        pip = [folder / "venv" / "bin" / "python", "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--only-binary=:all:"]
        result = subprocess.run([*map(str, pip), mujoco, "numpy"], capture_output=True, text=True)
        if result.returncode != 0:
            reason = (result.stderr.strip().splitlines() or ["no reason given"])[-1]
            skip(f"{mujoco} cannot be installed for Python {sys.version.split()[0]}, so the wheel is untested with it: {reason}")
        subprocess.run([*map(str, pip), str(wheel)], check=True)

    def run(self, *command, hidden=True):
        """Returns what a program prints, and ends the test if it fails. With `hidden` it does not see the build."""
        whole = [*(["unshare", "-m", "bash", "-c", self.script, "bash"] if hidden else []), *map(str, command)]
        clean = {"PATH": f"{self.folder / 'venv' / 'bin'}:/usr/bin:/bin", "HOME": str(self.folder), "LANG": "C.UTF-8"}
        result = subprocess.run(whole, cwd=self.folder, env=clean, capture_output=True, text=True)
        print(f"$ {' '.join(map(str, command))}\n{result.stdout}{result.stderr}", end="", flush=True)
        if result.returncode != 0:
            sys.exit(f"status {result.returncode}")
        return result.stdout
