#!/usr/bin/env python3
"""No file may take a large share of the time in which the programs of scripts/demo are compiled.

Reads the log of ninja. The log has wall times, which grow with the load of the machine and fall with the compiler
cache; so the check compares shares of the total, which an even load changes little. It is skipped unless one run of
ninja compiled nearly all objects, without the cache: times of two runs under different loads must not be compared. A
file of 15 s in a build of 700 s has a share of 15/700. build_time_allowed.txt lists the objects that have a larger
share today, with their share in percent: a share may not grow. The check reports lines that are not needed any more,
but does not fail for them, because two builds of the same sources differ.

usage: check_build_time.py BUILD_FOLDER [ALLOWED_FILE]
"""
import pathlib
import re
import statistics
import sys

MAX_SHARE = 100 * 15 / 700  # per cent
FOREIGN = re.compile(r"/(imgui|manifold)\.dir/")
CACHED = 0.5  # seconds; an object of the compiler cache takes less
MIN_COMPILED = 0.9  # of the objects, in one run of ninja
SAME_RUN = 15  # seconds between two estimates of the begin of one run
TOLERANCE = 1.25  # of an allowed share: two builds differ by this much


def compilations(log):
    """(seconds, begin of the run of ninja) of the newest compilation of each object of the programs, by name.

    Tests and foreign code do not count. The log has the times of a run from its begin, and the time of day at the end.
    """
    found = {}
    for line in log.splitlines():
        fields = line.split("\t")
        if len(fields) < 4:
            continue
        begin, end, written, name = int(fields[0]), int(fields[1]), int(fields[2]), fields[3]
        if name.startswith("src/") and name.endswith((".o", ".gch")) and not FOREIGN.search(name):
            found[name] = ((end - begin) / 1000, written / 1e9 - end / 1000)
    return found


def of_one_run(found):
    """Seconds of the objects that were compiled, not taken from the cache, in the run of most objects."""
    middle = statistics.median(begin for _, begin in found.values())
    return {
        name: seconds for name, (seconds, begin) in found.items() if seconds > CACHED and abs(begin - middle) < SAME_RUN
    }


def shares(seconds):
    total = sum(seconds.values())
    return {name: 100 * value / total for name, value in seconds.items()}


def read_allowed(path):
    lines = path.read_text().splitlines() if path.exists() else []
    return {name: float(share) for share, name in (line.split(" ", 1) for line in lines if line)}


def problems(found, allowed):
    for name, share in sorted(found.items(), key=lambda item: -item[1]):
        limit = max(MAX_SHARE, TOLERANCE * allowed.get(name, 0))
        if share > limit:
            yield f"{name}: {share:.2f} % of the time to compile the programs, allowed is {limit:.2f} %"


def needless(found, allowed):
    """The listed objects that are below the limit with a margin."""
    return [name for name in allowed if found.get(name, 0) * TOLERANCE < MAX_SHARE]


def main():
    folder = pathlib.Path(sys.argv[1])
    allowed_file = sys.argv[2] if len(sys.argv) > 2 else pathlib.Path(__file__).with_name("build_time_allowed.txt")
    log = folder / ".ninja_log"
    if not log.exists():
        print(f"skipped: no {log}")
        return 77
    objects = {name: row for name, row in compilations(log.read_text()).items() if (folder / name).exists()}
    seconds = of_one_run(objects) if objects else {}
    if len(seconds) < MIN_COMPILED * len(objects) or not objects:
        print(f"skipped: one run of ninja compiled {len(seconds)} of {len(objects)} objects")
        return 77
    found, allowed = shares(seconds), read_allowed(pathlib.Path(allowed_file))
    for name in needless(found, allowed):
        print(f"note: {name} is below the limit, remove its line from the list")
    broken = list(problems(found, allowed))
    print("\n".join(broken + [f"{len(broken)} files take too long"]))
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
