#!/usr/bin/env python3
"""Reads ctest's JUnit report and lists the tests that passed, failed and were skipped, with the reasons."""
import re
import sys
import xml.etree.ElementTree as ElementTree


def skip_reason(case):
    """Returns the message that GoogleTest prints after 'file:line: Skipped', or the report's own message."""
    output = case.findtext("system-out") or ""
    match = re.search(r": Skipped\n+(.+)", output)
    if match:
        return match.group(1).strip()
    lines = [line for line in output.splitlines() if line.strip()]
    return lines[-1].strip() if lines else "no reason given"


def main(path):
    cases = ElementTree.parse(path).getroot().findall(".//testcase")
    skipped = [case for case in cases if case.find("skipped") is not None or case.get("status") in ("notrun", "disabled")]
    failed = [case for case in cases if case.find("failure") is not None]
    reasons = {}
    for case in skipped:
        reasons.setdefault(skip_reason(case), []).append(case.get("name"))
    for reason, names in sorted(reasons.items()):
        print(f"skipped ({len(names)}): {reason}: {', '.join(names)}")
    for case in failed:
        print(f"failed: {case.get('name')}")
    print(f"tests: {len(cases) - len(skipped) - len(failed)} passed, {len(failed)} failed, {len(skipped)} skipped")


if __name__ == "__main__":
    main(sys.argv[1])
