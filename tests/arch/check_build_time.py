#!/usr/bin/env python3
"""No file may take a large share of the time in which the programs of scripts/demo are compiled.

Reads the log of ninja. The log has wall times, which grow with the load of the machine and fall with the compiler
cache; so the check compares shares of the total, which an even load changes little. It is skipped unless one run of
ninja compiled nearly all objects, without the cache: times of two runs under different loads must not be compared. The
aim is 15 s in a build of 700 s, a share of 15/700: files above it are reported, and above twice the share the check
fails, because the same file's share differed by 1.2 between two builds on a machine with other work.

usage: check_build_time.py BUILD_FOLDER
"""
import pathlib
import re
import statistics
import sys

AIM = 100 * 15 / 700  # per cent
MAX_SHARE = 2 * AIM
FOREIGN = re.compile(r"/(imgui|manifold)\.dir/")
CACHED = 0.5  # seconds; an object of the compiler cache takes less
MIN_COMPILED = 0.9  # of the objects, in one run of ninja
SAME_RUN = 15  # seconds between two estimates of the begin of one run


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


def main():
    folder = pathlib.Path(sys.argv[1])
    log = folder / ".ninja_log"
    if not log.exists():
        print(f"skipped: no {log}")
        return 77
    objects = {name: row for name, row in compilations(log.read_text()).items() if (folder / name).exists()}
    seconds = of_one_run(objects) if objects else {}
    if len(seconds) < MIN_COMPILED * len(objects) or not objects:
        print(f"skipped: one run of ninja compiled {len(seconds)} of {len(objects)} objects")
        return 77
    found = sorted(shares(seconds).items(), key=lambda item: -item[1])
    for name, share in found:
        if share > AIM:
            print(f"{name}: {share:.2f} % of the time to compile the programs, the aim is {AIM:.2f} %")
    broken = sum(share > MAX_SHARE for _, share in found)
    print(f"{broken} files take more than {MAX_SHARE:.2f} %")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
