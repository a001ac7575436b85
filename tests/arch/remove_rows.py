#!/usr/bin/env python3
"""Removes each row of features.cpp in turn: the window has to compile and link without it, and to draw its first frames.

Usage: remove_rows.py SOURCE_FOLDER BUILD_FOLDER"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROW = re.compile(r"&(k\w+),")


def compile_command(build, source):
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if pathlib.Path(entry["file"]).resolve() == source.resolve():
            return shlex.split(entry["command"]), entry["directory"]
    raise SystemExit(f"{source}: no command compiles it")


def link_command(build):
    lines = subprocess.run(["ninja", "-C", build, "-t", "commands", "bin/taxelstudio"], capture_output=True, text=True, check=True)
    return next(line for line in reversed(lines.stdout.splitlines()) if "-o bin/taxelstudio " in line)


def attempt(row, source, build, folder):
    """Returns the reason why the window cannot do without a row, or None."""
    folder = pathlib.Path(folder) / row
    folder.mkdir()
    text = source.read_text()
    assert ROW.search(text)
    (folder / "features.cpp").write_text(text.replace(f"&{row},", ""))
    command, directory = compile_command(build, source)
    command[command.index("-o") + 1] = str(folder / "features.o")
    command[command.index("-c") + 1] = str(folder / "features.cpp")
    compiled = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    if compiled.returncode:
        return f"it does not compile: {compiled.stderr[:600]}"
    link = link_command(build).replace("-o bin/taxelstudio ", f"-o {folder}/taxelstudio {folder}/features.o ", 1)
    linked = subprocess.run(link, shell=True, cwd=build, capture_output=True, text=True, check=False)
    if linked.returncode:
        return f"it does not link: {linked.stderr[:600]}"
    run = [folder / "taxelstudio", "--headless", "--frames", "3", "--state-dir", folder / "state", "--dump-state", folder / "state.json"]
    ended = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=False, timeout=120)
    for file in ("taxelstudio", "features.o"):
        os.remove(folder / file)
    if ended.returncode:
        return f"it ends with {ended.returncode}: {ended.stderr[:600]}"
    return None


def main(root, build):
    source, build = pathlib.Path(root) / "src/app/studio/features.cpp", pathlib.Path(build).resolve()
    rows = ROW.findall(source.read_text())
    if len(rows) < 40:
        raise SystemExit(f"{source}: only {len(rows)} rows were found")
    failed = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        reasons = pool.map(lambda row: attempt(row, source, build, folder), rows)
        for row, reason in zip(rows, reasons):
            if reason:
                failed += 1
                print(f"without {row}: {reason}")
    print(f"{len(rows)} rows removed in turn, {failed} cannot be missed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
