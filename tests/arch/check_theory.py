#!/usr/bin/env python3
"""Checks that each file, folder and test that the theory, the architecture and the decisions name exists.

    check_theory.py SOURCE_FOLDER
"""
import pathlib
import re
import sys

FOLDERS = ("src", "tests", "docs", "python", "bench", "examples", "assets", "shaders", "cmake", "scripts")
CODE = re.compile(r"`([^`\n]+)`")
FILE = re.compile(r"^[\w/]+\.(?:cpp|h|md|py)$")
FOLDER = re.compile(r"^[a-z]\w*(?:/[a-z]\w*)+$")
TEST = re.compile(r"^([A-Z]\w+)\.([A-Z]\w*)?(\*)?$")
DEFINED = re.compile(r"^TEST(?:_P|_F)?\(\s*(\w+),\s*(\w+)\)", re.M)


def complaints(text, files, tests):
    """Yields the missing names of the text: `files` are paths below the root, `tests` are pairs of suite and name."""
    folders = {path.rpartition("/")[0] for path in files} | set(files)  # scripts have no extension
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
    files = [p.relative_to(root).as_posix() for folder in FOLDERS for p in (root / folder).rglob("*")
             if p.is_file()]
    tests = [t for p in (root / "tests").rglob("*.cpp") for t in DEFINED.findall(p.read_text())]
    pages = [root / "docs/theory.md", root / "docs/architecture.md", *sorted((root / "docs/theory").glob("*.md")),
             *sorted((root / "docs/decisions").glob("*.md"))]
    found = [f"{page.relative_to(root)}: {line}" for page in pages for line in complaints(page.read_text(), files, tests)]
    print("\n".join(found))
    return 1 if found else 0


def self_test():
    files, tests = ["src/core/hydro/clip.cpp", "scripts/lint"], [("Clip", "CutsRight")]
    fine = "`scripts/lint` `clip.cpp` `hydro/clip.cpp` `core/hydro` `Clip.*` `Clip.Cuts*` `Clip.CutsRight` `p = E x` `Tet`"
    assert not list(complaints(fine, files, tests))
    for broken in ("`clop.cpp`", "`core/hydra`", "`scripts/lunt`", "`Clip.Draws*`", "`Clip.Cuts`", "`Clop.*`"):
        assert list(complaints(broken, files, tests)), broken


if __name__ == "__main__":
    self_test()
    sys.exit(main(sys.argv[1]))
