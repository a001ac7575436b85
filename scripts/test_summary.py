#!/usr/bin/env python3
"""Reads ctest's JUnit report, and GoogleTest's reports of tests that share a process, and lists the tests that passed,
failed and were skipped, with the reasons; then the tests that took longer than 20 s.

usage: test_summary.py REPORT [FOLDER_OF_GTEST_REPORTS]
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

LONG = 20  # seconds


@dataclass
class Case:
    name: str
    seconds: float
    failed: bool
    skipped: str | None  # the reason, or None


def skip_reason(output):
    """Returns the message that GoogleTest prints after 'file:line: Skipped', or the last line of the output."""
    match = re.search(r": Skipped\n+(.+)", output)
    if match:
        return match.group(1).strip()
    lines = [line for line in output.splitlines() if line.strip()]
    return lines[-1].strip() if lines else "no reason given"


def of_ctest(case):
    is_skipped = case.find("skipped") is not None or case.get("status") in ("notrun", "disabled")
    reason = skip_reason(case.findtext("system-out") or "") if is_skipped else None
    return Case(case.get("name"), float(case.get("time") or 0), case.find("failure") is not None, reason)


def of_gtest(case):
    skipped = case.find("skipped")
    reason = None if skipped is None else skip_reason(f": Skipped\n{skipped.get('message') or skipped.text or ''}")
    name = f"{case.get('classname')}.{case.get('name')}"
    return Case(name, float(case.get("time") or 0), case.find("failure") is not None, reason)


def read_cases(report, gtest_reports):
    """Returns all tests. A test of ctest that has a report of GoogleTest is replaced by the tests in that report, unless
    it failed and none of them did: then its process ended early."""
    cases = []
    for node in ElementTree.parse(report).getroot().findall(".//testcase"):
        case = of_ctest(node)
        inner = gtest_reports / f"{case.name}.xml" if gtest_reports else None
        if inner is None or not inner.exists() or case.skipped:
            cases.append(case)
            continue
        found = [of_gtest(n) for n in ElementTree.parse(inner).getroot().iter("testcase") if n.get("status") == "run"]
        cases += found
        if case.failed and not any(one.failed for one in found):
            cases.append(case)
    return cases


def main(report, gtest_reports=None):
    cases = read_cases(report, gtest_reports and pathlib.Path(gtest_reports))
    reasons = {}
    for case in cases:
        if case.skipped:
            reasons.setdefault(case.skipped, []).append(case.name)
    for reason, names in sorted(reasons.items()):
        print(f"skipped ({len(names)}): {reason}: {', '.join(names)}")
    long = sorted((case for case in cases if case.seconds > LONG), key=lambda case: -case.seconds)
    if long:
        print(f"longer than {LONG} s: {', '.join(f'{case.name} {case.seconds:.0f} s' for case in long)}")
    failed = [case for case in cases if case.failed]
    for case in failed:
        print(f"failed: {case.name}")
    skipped = sum(case.skipped is not None for case in cases)
    print(f"tests: {len(cases) - len(failed) - skipped} passed, {len(failed)} failed, {skipped} skipped")


if __name__ == "__main__":
    main(*sys.argv[1:])
