#!/usr/bin/env python3
"""Our contact kernel side by side with Drake's: time, agreement on the same tets, thin bodies, error against closed forms.

Run by bench/drake/run, which finds Drake and builds the library. Exits 1 where the two disagree on the same tets by more than
1e-6, on thin bodies by more than 2 %, or our error against a closed form is more than a fifth of Drake's: speed alone never fails."""
import argparse
import importlib.metadata
import json
import logging
import os
import pathlib
import platform
import sys
import tempfile

import accuracy
import agreement
import cases
import report
import speed
import thin
from taxel_peer import Library

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LARGEST_DIFFERENCE = 1e-6
LARGEST_PART_OF_ERROR = 0.2
LARGEST_THIN_DIFFERENCE = 0.02
ROUNDING = 1e-10


def processor():
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def all_cases(library, folder):
    yield from cases.sphere_cases(library, folder)
    yield from cases.unequal_cases(library, folder)
    yield from cases.half_space_cases(library, folder)
    layout = SOURCE / "assets/layouts/fingertip.taxels.json"
    material = json.loads(layout.read_text())["material"]
    yield from cases.finger_cases(library, folder, layout, material["thickness"], material["modulus"])


def say(row):
    if row.refused:
        print(f"{row.name:38} {row.path:6} {row.refused}", file=sys.stderr)
    else:
        print(f"{row.name:38} {row.path:6} {row.polygons:6.0f} polygons  ours {row.ours_us:8.1f} us  Drake {row.drake_us:8.1f} us  "
              f"ratio {row.ratio:5.1f}  area {row.area_difference:.0e}  force {row.force_difference:.0e}  "
              f"brute force {row.brute_ratio:.0f}  differs {row.brute_difference:.0e}", file=sys.stderr, flush=True)


def failures(same_tets, thin_bodies, closed_forms):
    for row in same_tets:
        if row.poses < 30 or max(row.area, row.force, row.centroid) > LARGEST_DIFFERENCE:
            yield f"same tets, {row.soft} and {row.other}: {row}"
    for row in thin_bodies:
        if row.force > LARGEST_THIN_DIFFERENCE:
            yield f"thin body, {row.name}: {row}"
    for row in closed_forms:
        for ours, theirs in ((row.force, row.drake_force), (row.area, row.drake_area)):
            if ours > max(LARGEST_PART_OF_ERROR * theirs, ROUNDING):
                yield f"closed form, {row.name}: {row}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("library", help="libtaxel_contact_c.so of this build")
    parser.add_argument("--out", help="write the tables there, as Markdown, instead of to stdout")
    parser.add_argument("--only", choices=["speed", "agreement", "thin", "accuracy"], help="one of the four tables")
    parser.add_argument("--match", default="", help="only the speed classes whose name contains this")
    parser.add_argument("--instruction-set", help="ours uses this one alone, such as AVX2, instead of the best there is")
    parser.add_argument("--no-brute-force", action="store_true", help="leave brute force out of the speed table: it takes minutes")
    options = parser.parse_args()
    logging.getLogger("drake").setLevel(logging.ERROR)  # it warns of deformable bodies, which are not meant here
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    library = Library(options.library)
    if options.instruction_set:
        library.use(options.instruction_set)
    text = (f"# Side by side with Drake {importlib.metadata.version('drake')}\n\n"
            f"Written by `bench/drake/run --out bench/drake/results.md`. Processor: {processor()}, one core; "
            f"load average at the start {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores. "
            f"Instruction set of ours: {options.instruction_set or 'the best there is'}.\n")
    same_tets, thin_bodies, closed_forms = [], [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if options.only in (None, "speed"):
            chosen = (c for c in all_cases(library, folder) if options.match in c.name)
            text += "\n" + report.speed(*speed.run(chosen, say, not options.no_brute_force))
        if options.only in (None, "agreement"):
            same_tets = agreement.run(library, folder)
            text += "\n" + report.agreement(same_tets)
        if options.only in (None, "thin"):
            thin_bodies = thin.run(library, folder)
            text += "\n" + report.thin(thin_bodies)
        if options.only in (None, "accuracy"):
            closed_forms = accuracy.run(library)
            text += "\n" + report.accuracy(closed_forms)
    if options.out:
        part = pathlib.Path(options.out + ".part")
        part.write_text(text)
        part.rename(options.out)
    else:
        print(text)
    found = list(failures(same_tets, thin_bodies, closed_forms))
    for line in found:
        print("FAIL " + line, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
