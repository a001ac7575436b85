#!/usr/bin/env python3
"""Checks that each file, folder and test that docs/theory.md names for an equation exists.

    check_theory.py SOURCE_FOLDER
"""
import pathlib
import re
import sys

CODE = re.compile(r"`([^`\n]+)`")
FILE = re.compile(r"^[\w/]+\.(?:cpp|h|md|py)$")
FOLDER = re.compile(r"^[a-z]\w*(?:/[a-z]\w*)+$")
TEST = re.compile(r"^([A-Z]\w+)\.([A-Z]\w*)?(\*)?$")
DEFINED = re.compile(r"^TEST(?:_P|_F)?\(\s*(\w+),\s*(\w+)\)", re.M)


def complaints(text, files, tests):
    """Yields the missing names of the text: `files` are paths below the root, `tests` are pairs of suite and name."""
    folders = {path.rpartition("/")[0] for path in files}
    for word in CODE.findall(text):
        test = TEST.match(word)
        if FILE.match(word):
            if not any(path == word or path.endswith("/" + word) for path in files):
                yield f"no file {word}"
        elif FOLDER.match(word):
            if not any(folder == word or folder.endswith("/" + word) for folder in folders):
                yield f"no folder {word}"
        elif test:
            suite, name, more = test.group(1), test.group(2) or "", test.group(3)
            found = [n for s, n in tests if s == suite and (n.startswith(name) if more else n == name)]
            if not found:
                yield f"no test {word}"


def main(root):
    root = pathlib.Path(root)
    files = [p.relative_to(root).as_posix() for folder in ("src", "tests", "docs") for p in (root / folder).rglob("*.*")]
    tests = [t for p in (root / "tests").rglob("*.cpp") for t in DEFINED.findall(p.read_text())]
    found = list(complaints((root / "docs/theory.md").read_text(), files, tests))
    for line in found:
        print(f"docs/theory.md: {line}")
    return 1 if found else 0


def self_test():
    files, tests = ["src/core/hydro/clip.cpp"], [("Clip", "CutsRight")]
    fine = "`clip.cpp` `hydro/clip.cpp` `core/hydro` `Clip.*` `Clip.Cuts*` `Clip.CutsRight` `p = E x` `Tet`"
    assert not list(complaints(fine, files, tests))
    for broken in ("`clop.cpp`", "`core/hydra`", "`Clip.Draws*`", "`Clip.Cuts`", "`Clop.*`"):
        assert list(complaints(broken, files, tests)), broken


if __name__ == "__main__":
    self_test()
    sys.exit(main(sys.argv[1]))
