"""Runs commands of taxel side by side and on full disks, and checks the files after them.

disk_stress.py TAXEL SOURCE_DIR [pairs N | full PHASES]

pairs: N pairs (default 200) of `play`, `sweep`, `run`, `study` and `batch`, started into two new sibling folders of a
new folder. One of each pair fails by itself or is ended by a signal at a random time; the other must end with status 0
and have the bytes of a run alone, and nothing else may be in the folder.

full: every writer on a disk with room for 1/11, 2/11 ... of what it writes (PHASES of them, default 10): a tmpfs in a
mount namespace of its own, or without the right to mount, a limit of the size of files. The old content of a file must
stay, no part of a file may be left, a batch must continue, and the rows that a run has computed must be recovered.
"""
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

FEW_PAGES = 12 * 4096  # bytes on a disk that are too few for ten phases
KINDS = ["play", "sweep", "run", "study", "batch"]
PRESS = {"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"}
SIGNALS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def prepare(folder, source):
    """Writes the input files of all commands, good ones and bad ones. The bad ones fail after the folder is made."""
    (folder / "press.json").write_text(json.dumps(PRESS))
    study = {"format": "taxel-study", "version": 1, "scenario": PRESS,
             "parameters": [{"parameter": "depth", "values": [0.0003, 0.0004, 0.0005]}]}
    (folder / "study.json").write_text(json.dumps(study))
    study["parameters"] = [{"parameter": "finger_mass", "values": [1e-15, 2e-15]}]
    (folder / "bad_study.json").write_text(json.dumps(study))
    job = {"scenario": PRESS, "set": {"/layout/sampling/density": 1e4, "/scenario/depth": {"values": [3e-4, 4e-4, 5e-4]}}}
    (folder / "jobs.jsonl").write_text(json.dumps(job) + "\n")
    (folder / "bad_jobs.jsonl").write_text(json.dumps({"scenario": dict(PRESS, finger_mass=1e-15)}) + "\n")
    (folder / "bad.taxels.json").write_text("{}")
    shutil.copy(source / "assets/scenes/press.xml", folder / "scene.xml")
    for name in ("layouts", "meshes"):
        shutil.copytree(source / "assets" / name, folder.parent / name, dirs_exist_ok=True)
    (folder / "bad_scene.xml").write_text("<mujoco><worldbody><geom name='g' size='1'/></worldbody></mujoco>")


def command(kind, out, bad=False):
    dense = ["--density", "1e4"]
    words = {"play": ["play", "press.json"] + dense,
             "sweep": ["sweep", "--object", "box", "--before", "0.002", "--past", "0.001"] + dense,
             "run": ["run", "bad_scene.xml" if bad else "scene.xml", "--seconds", "0.1"],
             "study": ["study", "bad_study.json" if bad else "study.json"] + dense,
             "batch": ["batch", "bad_jobs.jsonl" if bad else "jobs.jsonl", "--workers", "2", "--group", "1"]}[kind]
    if bad and kind in ("play", "sweep"):
        words += ["--layout", "bad.taxels.json"]
    return words + ["--out", str(out)]


def files_of(folder):
    """Returns the bytes of all files below a folder, but those with which a batch continues."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and ".batch" not in path.parts}


def names_of(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*"))


def hear_signals():
    """A program in the background of a shell ignores SIGINT."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_DFL)


def start(taxel, words, folder, log):
    return subprocess.Popen([taxel] + words, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=open(log, "w"), preexec_fn=hear_signals)


def check_pair(taxel, kind, folder, whole, rng, way):
    """Runs one pair. Returns complaints and what has happened to the ended one."""
    complaints = []
    results = folder / "results" / "deep"
    bad = command(kind, results / "1", bad=way == "fails")
    good = command(kind, results / "2")
    first, second = ((bad, "bad.txt"), (good, "good.txt")) if rng.random() < 0.5 else ((good, "good.txt"), (bad, "bad.txt"))
    children = {}
    for words, log in (first, second):
        children[log] = start(taxel, words, folder, folder / log)
        time.sleep(rng.choice([0, 0, rng.uniform(0, 0.05)]))
    if way == "ends":
        time.sleep(rng.uniform(0, 0.8) ** 2)
        children["bad.txt"].send_signal(rng.choice(SIGNALS))
        if rng.random() < 0.5:
            time.sleep(0.04)
            children["bad.txt"].send_signal(signal.SIGINT)
    ended, status = children["bad.txt"].wait(), children["good.txt"].wait()
    if status != 0:
        complaints.append(f"the other run ends with {status}: {(folder / 'good.txt').read_text()}")
    elif files_of(results / "2") != whole:
        complaints.append("the other run has other files")
    parts = [name for name in names_of(folder) if name.endswith(".part")]
    if parts:
        complaints.append(f"left {parts}")
    if way == "fails" and ended not in (1, 2):
        complaints.append(f"the failing run ends with {ended}")
    if way == "fails" and kind != "batch" and (results / "1").exists():
        complaints.append(f"the failing run leaves {names_of(results / '1')}")
    allowed = {"results", "results/deep", "results/deep/1", "results/deep/2"}
    strange = [name for name in names_of(folder) if name.startswith("results") and name not in allowed
               and not name.startswith(("results/deep/1/", "results/deep/2/"))]
    if strange:
        complaints.append(f"strange files: {strange}")
    return complaints, ended


def pairs(taxel, source, count):
    rng = random.Random(57)
    base = pathlib.Path(tempfile.mkdtemp(prefix="disk_stress_"))
    work = base / "work"
    work.mkdir()
    prepare(work, source)
    whole = {}
    for kind in KINDS:
        subprocess.run([taxel] + command(kind, "whole_" + kind), cwd=work, check=True, capture_output=True)
        whole[kind] = files_of(work / f"whole_{kind}")
    bad, ends = 0, {}
    for i in range(count):
        kind = KINDS[i % len(KINDS)]
        way = "fails" if i // len(KINDS) % 2 == 0 else "ends"
        complaints, ended = check_pair(taxel, kind, work, whole[kind], rng, way)
        ends[(way, ended)] = ends.get((way, ended), 0) + 1
        if complaints:
            bad += 1
            print(f"FAILED: pair {i}, {kind}, {way}: {'; '.join(complaints)}", flush=True)
        shutil.rmtree(work / "results", ignore_errors=True)
    shutil.rmtree(base)
    shown = ", ".join(f"{way} with {status}: {n}" for (way, status), n in sorted(ends.items()))
    print(f"{count} pairs, {bad} complaints; of the ended ones: {shown}")
    return bad


class Disk:
    """A small disk, or a limit of the size of files.

    A disk consists of whole pages, so a file of a few pages is tried with a limit, which is exact to the byte.
    """

    def __init__(self, base):
        self.base, self.size = base, 0
        self.is_disk = self.can_mount = os.environ.get("DISK_STRESS_MOUNTS") == "1"
        base.mkdir()

    def resize(self, size):
        self.size = size
        if not self.is_disk:
            return
        mounted = os.path.ismount(self.base)
        how = ["mount", "-o", f"remount,size={size}", str(self.base)] if mounted else \
            ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(self.base)]
        subprocess.run(how, check=True)

    def empty(self):
        if self.is_disk and os.path.ismount(self.base):
            subprocess.run(["umount", str(self.base)], check=True)
        elif not self.is_disk:
            shutil.rmtree(self.base)
            self.base.mkdir()

    def limit(self):
        if not self.is_disk and self.size < 1 << 30:
            resource.setrlimit(resource.RLIMIT_FSIZE, (self.size, resource.RLIM_INFINITY))


def used(folder):
    return sum((path.stat().st_size + 4095) // 4096 * 4096 for path in folder.rglob("*") if path.is_file())


def rows_of(csv):
    return csv.read_text().splitlines()


def check_run(taxel, out, whole, inputs, message):
    """Checks what a run has left. Returns complaints and the number of recovered rows."""
    if not (out / "unfinished.rows").exists():
        return ([f"left {names_of(out)}"] if out.exists() else []), 0
    said = message.split("; the ")[-1].split(" rows so far")[0] if "rows so far" in message else "none"
    recovered = out.parent / "recovered"
    convert = subprocess.run([taxel, "convert", str(out / "unfinished.rows"), str(recovered)], cwd=inputs,
                             capture_output=True, text=True)
    if convert.returncode != 0:
        return [f"the rows cannot be recovered: {convert.stderr}"], 0
    lines = rows_of(recovered / "readings.csv")
    complaints = [] if lines == rows_of(whole / "readings.csv")[:len(lines)] else ["the recovered rows differ"]
    if said != str(len(lines) - 1):
        complaints.append(f"{len(lines) - 1} rows were recovered, the message says {said}")
    return complaints, len(lines) - 1


def full_phase(taxel, writer, words, disk, size, inputs, whole):
    disk.resize(size)
    out = disk.base / "out"
    is_file = out.with_suffix(writer[1]) if writer[1] else None
    if is_file:
        is_file.write_text("old")
    child = subprocess.run([taxel] + words, cwd=inputs, capture_output=True, text=True, preexec_fn=disk.limit)
    complaints, rows = [], 0
    disk.resize(1 << 30)
    if child.returncode == 0:
        return complaints, rows, True
    if child.returncode != 2:
        complaints.append(f"ends with {child.returncode}: {child.stderr}")
    parts = [name for name in names_of(disk.base) if name.endswith(".part")]
    if parts:
        complaints.append(f"left {parts}")
    if is_file and is_file.read_text() != "old":
        complaints.append("the old file is not as it was")
    if writer[0] in ("play", "sweep", "run"):
        more, rows = check_run(taxel, out, whole, inputs, child.stderr)
        complaints += more
    elif writer[0] == "study":
        for path in out.rglob("run_*.csv") if out.exists() else []:
            rows += len(rows_of(path)) - 1
            if path.read_bytes() != (whole / path.name).read_bytes():
                complaints.append(f"{path.name} differs")
    elif writer[0] == "batch":
        again = subprocess.run([taxel] + words, cwd=inputs, capture_output=True, text=True)
        if again.returncode != 0 or files_of(out) != files_of(whole):
            complaints.append(f"does not continue: {again.stderr}")
    return complaints, rows, False


def full(taxel, source, phases):
    if os.environ.get("DISK_STRESS_MOUNTS") is None:
        can = os.geteuid() == 0 and subprocess.run(["unshare", "-m", "true"], capture_output=True).returncode == 0
        os.environ["DISK_STRESS_MOUNTS"] = "1" if can else "0"
        if can:
            os.execvp("unshare", ["unshare", "-m", sys.executable] + sys.argv)
    base = pathlib.Path(tempfile.mkdtemp(prefix="disk_stress_"))
    inputs = base / "work"
    inputs.mkdir()
    prepare(inputs, source)
    disk = Disk(base / "disk")
    print("a tmpfs" if disk.can_mount else "limits of the size of files: this user cannot mount")
    layout = str(source / "assets/layouts/fingertip.taxels.json")
    large = json.loads(pathlib.Path(layout).read_text())
    large["mesh"]["file"] = str(source / "assets/meshes/fingertip.obj")
    large["taxels"] = [dict(large["taxels"][i % 12], id=i) for i in range(1000)]
    (inputs / "large.taxels.json").write_text(json.dumps(large))
    writers = [((kind, ""), command(kind, disk.base / "out")) for kind in KINDS]
    single = [("samples", ".csv", ["samples", layout, "--density", "1e6", "--out"]),
              ("mesh", ".stl", ["mesh", str(source / "assets/meshes/fingertip.obj"), "--out"]),
              ("convert", ".csv", ["convert", str(inputs / "large.taxels.json")]), ("messages", ".jsonl", ["convert", str(base / "whole_run")]),
              ("plot", ".svg", ["plot", str(base / "whole_run"), "--out"])]
    writers += [((name, extension), words + [str(disk.base / f"out{extension}")]) for name, extension, words in single]
    bad = 0
    for writer, words in writers:
        disk.resize(1 << 30)
        subprocess.run([taxel] + words, cwd=inputs, check=True, capture_output=True)
        whole = base / f"whole_{writer[0]}"
        if writer[1]:
            whole.mkdir()
            shutil.copy(disk.base / f"out{writer[1]}", whole)
        else:
            shutil.copytree(disk.base / "out", whole)
        disk.empty()
        disk.is_disk = disk.can_mount and used(whole) > FEW_PAGES
        need = used(whole) if disk.is_disk else max(path.stat().st_size for path in whole.rglob("*") if path.is_file())
        counts, done = [], 0
        for phase in range(1, phases + 1):
            size = max(4096 * 3 if disk.is_disk else 1, need * phase // (phases + 1))
            complaints, rows, is_done = full_phase(taxel, writer, words, disk, size, inputs, whole)
            counts.append(rows)
            done += is_done
            if complaints:
                bad += 1
                print(f"FAILED: {writer[0]} with room for {size} of {need} bytes: {'; '.join(complaints)}", flush=True)
            disk.empty()
        print(f"{writer[0]}: {phases} phases of {need} bytes of {'a disk' if disk.is_disk else 'one file'}, {done} were done; "
              f"rows recovered: {counts}", flush=True)
        disk.is_disk = disk.can_mount
    if disk.can_mount and os.path.ismount(disk.base):
        disk.empty()
    shutil.rmtree(base)
    print(f"{bad} complaints")
    return bad


def main():
    taxel, source = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
    what = sys.argv[3] if len(sys.argv) > 3 else "all"
    number = int(sys.argv[4]) if len(sys.argv) > 4 else None
    bad = 0
    if what in ("all", "pairs"):
        bad += pairs(taxel, source, number or 200)
    if what in ("all", "full"):
        bad += full(taxel, source, number or 10)
    raise SystemExit(1 if bad else 0)


if __name__ == "__main__":
    main()
