"""Kills taxelstudio while it writes, and checks the remaining files.

kill_writers.py TAXELSTUDIO MESH LAYOUT [KILLS [SIGNALS [WRITER]]]

Each writer (save, export, recording, video) is killed KILLS times (default 5) with SIGKILL at phases spread over its
work, and ended SIGNALS times (default 2) by each of SIGTERM, SIGINT and SIGHUP. During every second run another process
keeps a core busy. After each run every file must be complete, no temporary file may remain after the next start of the
program, a signal must end the program with status 128 + number within 10 s, and an edit older than the autosave
interval must be kept.
"""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zipfile

SIGNALS = [signal.SIGTERM, signal.SIGINT, signal.SIGHUP]
IDLE = {"do": "wait_idle"}


def key(name, *mods):
    return {"event": "key", "key": name, "mods": list(mods)}


def text(words):
    return {"event": "text", "text": words}


def typed(path):
    """Returns the steps that replace the path of an open file dialog and confirm it, twice if the file exists."""
    return [IDLE, key("a", "ctrl"), text(str(path)), IDLE, key("Enter"), IDLE, key("Enter"), IDLE]


EDIT = [IDLE, key("1", "ctrl"), IDLE, key("a"), IDLE, key("f"), text("3"), IDLE, key("Enter"), IDLE,
        {"do": "wait_for", "pointer": "/history/dirty", "equals": True}]


def script_of(writer, folder):
    """Returns the script lines and the lines that are repeated forever."""
    if writer == "save":
        first = EDIT + [key("s", "ctrl")] + typed(folder / "saved.taxelproj") + [{"do": "dump_state", "file": "ready"}]
        again = [key("z", "ctrl"), IDLE, key("s", "ctrl"), IDLE, key("y", "ctrl"), IDLE, key("s", "ctrl"), IDLE]
        return first, again * 400
    if writer == "export":
        once = [key("e", "ctrl")] + typed(folder / "out.taxels.json")
        return EDIT + [{"do": "dump_state", "file": "ready"}], once * 200
    if writer == "recording":
        ready = [IDLE, {"do": "dump_state", "file": "ready"}]
        once = [key("r", "ctrl"), {"do": "wait_for", "pointer": "/simulation/history/recording/steps", "least": 30},
                key("r", "ctrl"), IDLE]
        return ready, once * 100
    run = {"do": "wait_for", "pointer": "/simulation/step", "least": 40}
    # By the palette: in this small window the menu is longer than the window.
    video = [key("Space"), IDLE, key("k", "ctrl"), IDLE, text("export video"), IDLE,
             key("Enter")] + typed(folder / "out-video")
    return [IDLE, run, {"do": "dump_state", "file": "ready"}], video


def wait_for(path, seconds=60):
    end = time.monotonic() + seconds
    while not path.exists():
        if time.monotonic() > end:
            raise SystemExit(f"FAILED: {path} did not appear in {seconds} s")
        time.sleep(0.005)


def check_file(path):
    """Parses a file by its extension. Returns a complaint if the file is incomplete, else None."""
    try:
        if path.suffix in (".json", ".taxelproj"):
            json.loads(path.read_text())
        elif path.suffix == ".npz":
            with zipfile.ZipFile(path) as archive:
                bad = archive.testzip()
                if bad:
                    return f"{path}: {bad} is damaged"
        elif path.suffix == ".csv":
            lines = path.read_text().split("\n")
            if lines[-1] != "" or len({line.count(",") for line in lines[:-1]}) > 1:
                return f"{path}: a row is incomplete"
        elif path.suffix == ".png":
            if not path.read_bytes().endswith(b"IEND\xaeB`\x82"):
                return f"{path}: is cut"
    except (ValueError, zipfile.BadZipFile, UnicodeDecodeError) as error:
        return f"{path}: {error}"
    return None


def run_once(program, mesh, layout, writer, number, loaded, phase):
    folder = pathlib.Path(tempfile.mkdtemp(prefix="kill_writers_"))
    shutil.copy(mesh, folder / pathlib.Path(mesh).name)
    own = json.loads(pathlib.Path(layout).read_text())
    own["mesh"]["file"] = pathlib.Path(mesh).name
    own["sampling"]["density"] = 1e5
    (folder / "finger.taxels.json").write_text(json.dumps(own))
    first, again = script_of(writer, folder)
    lines = first + again + [{"do": "rest", "seconds": 600}]
    (folder / "s.jsonl").write_text("\n".join(json.dumps(line) for line in lines) + "\n")
    base = [program, "--headless", "--size", "640x480", "--state-dir", "state"]
    busy = subprocess.Popen([sys.executable, "-c", "while True: pass"]) if loaded else None
    complaints = []
    try:
        with open(folder / "log.txt", "w") as log:
            child = subprocess.Popen(base + ["--live", "--script", "s.jsonl", "finger.taxels.json"], cwd=folder,
                                     stdout=log, stderr=log)
        wait_for(folder / "ready")
        time.sleep(phase)
        if child.poll() is not None:
            complaints.append(f"ended by itself: {(folder / 'log.txt').read_text()[-300:]}")
        asked = time.monotonic()
        child.send_signal(number)
        status = child.wait(60)
        if number != signal.SIGKILL and status != 128 + number:
            complaints.append(f"status {status}, expected {128 + number}")
        if number != signal.SIGKILL and time.monotonic() - asked > 10:
            complaints.append("took more than 10 s to end")
        parts = [path for path in folder.rglob("*.part")]
        if number != signal.SIGKILL and parts:
            complaints.append(f"left {[path.name for path in parts]}")
        if number != signal.SIGKILL and writer == "export":
            if not list((folder / "state" / "autosave").glob("*.taxelproj")):
                complaints.append("the edit is lost")
    finally:
        if busy:
            busy.kill()
            busy.wait()
    for path in folder.rglob("*"):
        if path.is_file() and ".part" not in str(path) and path.suffix != ".jsonl":
            complaint = check_file(path)
            if complaint:
                complaints.append(complaint)
    # The next write to the same paths, or the recovery of a recording, removes the files of a killed process.
    if number == signal.SIGKILL and any(folder.rglob("*.part")):
        next_lines = first + again[: 16 if writer != "video" else len(again)]
        next_lines += [IDLE, {"do": "quit"}]
        if writer == "recording":
            next_lines = [IDLE, {"event": "click", "at": {"widget": "Recover"}}, IDLE, {"do": "quit"}]
        (folder / "ready").unlink()
        (folder / "next.jsonl").write_text("\n".join(json.dumps(line) for line in next_lines) + "\n")
        arguments = ["--state-dir", "other", "--live", "--script", "next.jsonl", "finger.taxels.json"]
        if writer == "recording":
            arguments = ["--state-dir", "state", "--script", "next.jsonl", "--empty"]
        subprocess.run(base[:-2] + arguments, cwd=folder, capture_output=True, timeout=120)
        left = [str(path.relative_to(folder)) for path in folder.rglob("*.part") if "state" not in path.parts]
        if left:
            complaints.append(f"after the next write: {left}")
    if not complaints:
        shutil.rmtree(folder)
    else:
        complaints = [f"{folder}: {complaint}" for complaint in complaints]
    return complaints


def main():
    program, mesh, layout = (str(pathlib.Path(argument).absolute()) for argument in sys.argv[1:4])
    kills = int(sys.argv[4]) if len(sys.argv) > 4 else 5
    signals = int(sys.argv[5]) if len(sys.argv) > 5 else 2
    random.seed(1)
    failures = 0
    writers = sys.argv[6:7] or ["save", "export", "recording", "video"]
    for writer in writers:
        plan = [(signal.SIGKILL, kills)] + [(number, signals) for number in SIGNALS]
        for number, count in plan:
            bad = 0
            for i in range(count):
                # Phases cover the first second after the writer has begun and, in one of ten runs, a later idle time.
                phase = random.uniform(1.5, 3) if i % 10 == 9 else random.random()
                complaints = run_once(program, mesh, layout, writer, number, i % 2 == 1, phase)
                bad += bool(complaints)
                for complaint in complaints:
                    print("  ", complaint, flush=True)
            failures += bad
            print(f"{writer}: {count} x {signal.Signals(number).name}: {bad} bad", flush=True)
    if failures:
        raise SystemExit(f"FAILED: {failures} runs left something wrong")


main()
