#!/usr/bin/env python3
"""A warning of the compiler fails the build of .ci/run, and not the build of scripts/demo.

    werror_test.py SOURCE_FOLDER CMAKE

Builds a library with one warning, with the options that cmake/Warnings.cmake gives to all our targets.
"""
import pathlib
import subprocess
import sys
import tempfile

PROJECT = """
cmake_minimum_required(VERSION 3.24)
project(Warned LANGUAGES CXX)
option(TAXEL_WERROR "" OFF)
include({warnings})
add_library(warned STATIC warned.cpp)
target_link_libraries(warned PRIVATE taxel_options)
"""
WARNED = "int half(int whole, int unused) { return whole / 2; }\n"


def build(cmake, source, folder, *options):
    """Returns the exit status of the build, and its output."""
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(PROJECT.format(warnings=source / "cmake" / "Warnings.cmake"))
    (folder / "warned.cpp").write_text(WARNED)
    subprocess.run([cmake, "-S", folder, "-B", folder / "build", *options], check=True, capture_output=True)
    done = subprocess.run([cmake, "--build", folder / "build"], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def main():
    source, cmake = pathlib.Path(sys.argv[1]), sys.argv[2]
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        status, output = build(cmake, source, folder / "user")
        assert status == 0, f"a warning fails a user's build:\n{output}"
        assert "unused" in output, f"the compiler did not warn:\n{output}"
        status, output = build(cmake, source, folder / "ci", "-DTAXEL_WERROR=ON")
        assert status != 0 and "unused" in output, f"a warning does not fail the build with TAXEL_WERROR:\n{output}"
    assert "--werror" in (source / ".ci" / "run").read_text(), ".ci/run does not ask for warnings as errors"
    assert "WERROR" not in (source / "scripts" / "demo").read_text(), "scripts/demo asks for warnings as errors"


main()
