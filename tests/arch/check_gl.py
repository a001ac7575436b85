#!/usr/bin/env python3
"""Checks that the sources use nothing of OpenGL above the version in src/ui/gl/offscreen_context.h.

The versions of functions and constants come from <GL/glcorearb.h>, the registry's own header. A driver that is told to
offer an older version still has the newer functions, so running the program does not show all of them.
"""
import pathlib
import re
import sys

HEADER = pathlib.Path("/usr/include/GL/glcorearb.h")
SKIPPED = 77
SHADER_WORDS = {
    # GLSL above 4.10: binding points in the source, storage buffers, locations of uniforms, images.
    r"\bbinding\s*=": "binding (GLSL 4.20)",
    r"\bstd430\b|^\s*(?:readonly |writeonly |layout\([^)]*\) )*buffer\b": "storage buffers (GLSL 4.30)",
    r"\blayout\s*\([^)]*location[^)]*\)\s*uniform\b": "locations of uniforms (GLSL 4.30)",
    r"\b[ui]?image(?:1D|2D|3D|Buffer)\b": "images (GLSL 4.20)",
}


def newer_names(header, major, minor):
    """Returns the names of functions and constants above the version, each with its version."""
    newer, level = {}, None
    for line in header.splitlines():
        begin = re.match(r"#ifndef GL_(VERSION_(\d)_(\d)|[A-Z0-9]+_\w+)$", line)
        if begin:
            level = (int(begin[2]), int(begin[3])) if begin[2] else "an extension"
        name = re.match(r"#define (GL_\w+)\s+0x|GLAPI .*APIENTRY (gl\w+) \(", line)
        if name and level is not None and (level == "an extension" or level > (major, minor)):
            text = level if isinstance(level, str) else "OpenGL {}.{}".format(*level)
            newer.setdefault(name[1] or name[2], text)
        elif name:
            newer[name[1] or name[2]] = None  # in the core, whatever extension has had it before
    return {name: text for name, text in newer.items() if text}


def complaints(root, header):
    root = pathlib.Path(root)
    version = re.search(r"kMajor = (\d), kMinor = (\d)", (root / "src/ui/gl/offscreen_context.h").read_text())
    major, minor = int(version[1]), int(version[2])
    newer = newer_names(header, major, minor)
    for path in sorted((root / "src").rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for name in re.findall(r"\bgl[A-Z]\w*(?=\()|\bGL_[A-Z0-9_]+\b", line.split("//")[0]):
                if name in newer:
                    yield f"{path.relative_to(root)}:{number}: {name} is of {newer[name]}, not of {major}.{minor}"
    for path in sorted((root / "shaders").iterdir()):
        text = path.read_text()
        if path.suffix in (".vert", ".frag") and not text.startswith(f"#version {major}{minor}0 core\n"):
            yield f"{path.relative_to(root)}:1: begins with another version than {major}{minor}0 core"
        for number, line in enumerate(text.splitlines(), 1):
            for pattern, words in SHADER_WORDS.items():
                if re.search(pattern, line.split("//")[0]):
                    yield f"{path.relative_to(root)}:{number}: {words}"


def main(root):
    if not HEADER.exists():
        print(f"skipped: {HEADER} is absent")
        return SKIPPED
    found = list(complaints(root, HEADER.read_text()))
    for line in found:
        print(line)
    print(f"{len(found)} uses of a newer OpenGL")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
