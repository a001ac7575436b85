#!/usr/bin/env python3
"""Checks that each module is at home in any program: it exports no symbol, because its initialiser runs on loading and
needs no name; it is not linked to a MuJoCo and names no folder of libraries, so it loads no second MuJoCo; it needs no
library that only scenes need. exports.py LIBRARY..."""
import shutil
import subprocess
import sys

# Symbols that sanitizers and coverage add to every library.
FOREIGN = ("__asan", "__ubsan", "__tsan", "__odr_asan", "__gcov")
UNWANTED = ("libmujoco", "libzip", "libtinyxml2")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines()


def offences(library):
    names = [line.split()[-1] for line in output_of("nm", "-D", "--defined-only", library)]
    found = [f"exports {name}" for name in names if not name.startswith(FOREIGN)]
    for line in output_of("readelf", "-d", library):
        value = line.partition("[")[2].rstrip("]")
        if "(NEEDED)" in line and value.startswith(UNWANTED):
            found.append(f"needs {value}")
        if "(RPATH)" in line or "(RUNPATH)" in line:
            found.append(f"searches libraries in {value}")
    return found


def main(libraries):
    if not libraries:
        sys.exit("no library is given")
    if shutil.which("nm") is None or shutil.which("readelf") is None:
        print("nm or readelf (binutils) is absent")
        sys.exit(77)
    found = [f"{library}: {offence}" for library in libraries for offence in offences(library)[:20]]
    print("\n".join(found))
    sys.exit(1 if found else 0)


main(sys.argv[1:])
