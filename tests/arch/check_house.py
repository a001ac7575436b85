#!/usr/bin/env python3
"""Checks the rules of docs/architecture.md by reading includes and counting lines."""
import collections
import pathlib
import re
import sys

LAYERS = ["base", "mesh", "layout", "hydro", "sensor", "document", "run", "sim"]

# Header prefix -> the only places (path prefixes or globs below src/) that may include the header.
LIBRARIES = {
    "OpenMesh/": ["core/mesh/topology/*", "core/mesh/repair/**/*"],
    "manifold/": ["core/mesh/repair/**/*"],
    "tiny_gltf.h": ["core/mesh/formats/glb_writer.cpp"],
    "nlohmann/": ["**/*_json.cpp", "app/studio/nouns/**/*_dump.cpp", "app/studio/frame/feature.h"],
    "yaml-cpp/": ["core/layout/formats/**/*"],
    "zip.h": ["core/base/archive/*"],
    "mujoco/": ["core/sim/**/*", "app/**/*"],
    "epoxy/": ["ui/**/*", "app/studio/**/*"],
    "GL/": ["ui/**/*"],
    "EGL/": ["ui/gl/offscreen_context.cpp"],
    "epoxy/egl.h": ["ui/gl/offscreen_context.cpp"],
    "epoxy/glx.h": [],
    "GLFW/": ["app/studio/**/*"],
    "imgui": ["ui/**/*", "app/studio/**/*"],
    "portable_file_dialogs.h": ["core/base/os/file_chooser.cpp"],
    "implot": ["ui/**/*", "app/studio/**/*"],
    "nanobind/": ["app/python/*"],
    "CLI/": ["app/cli/command_line.cpp", "app/studio/shell/options.cpp", "app/help/*.cpp"],
    "iostream": [],
    "fstream": [],
}
# Headers of the operating system, and functions of the standard library whose answers are the system's: a port to another
# system is the work of this folder.
SYSTEM_FOLDER = "core/base/os/"
SYSTEM_HEADER = re.compile(
    r"(?:unistd|fcntl|dlfcn|signal|link|elf|spawn|poll|pwd|grp|termios|pthread|sched|dirent|execinfo|glob|wordexp|ftw"
    r"|semaphore|syslog|netdb|ifaddrs|mqueue|aio|malloc|windows|io|process|direct)\.h"
    r"|csignal|(?:sys|linux|asm|arpa|net|netinet|mach|mach-o|bits)/.*"
)
SYSTEM_CALL = re.compile(r"\b(?:getenv|setenv|putenv|environ|popen|(?:std)?::system|__linux__|__APPLE__|_WIN32)\b")
# The rooms of the window: each uses only rooms to its left, and itself.
WINDOW_ROOMS = ["frame", "host", "nouns", "shell"]
# The state, drawing and pointer handling of a feature of the window.
FREE_OF_FILES = re.compile(r"app/studio/nouns/.*_(?:state|panel|tool)\.(?:h|cpp)")
UI_NEVER = ("fstream", "filesystem", "core/base/files.h", "core/mesh/mesh_io.h", "core/layout/file/layout_json.h")
# An exception may quote a long file. The window shows it by shown_message() only.
WHOLE_MESSAGE = re.compile(r"\.what\(\)")
MAX_FILE_LINES = 600
# The headers of the kernels, which only few sources may reach by their includes: a change of a kernel compiles little.
KERNEL_HEADERS = re.compile(r"core/(?:hydro/kernel/.*|sensor/rays/(?:ray_.*|surface_caster|tet_table))\.h")
MAX_KERNEL_SOURCES = 20
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')

# Code in which a seed gives the same samples on every machine. It uses only IEEE arithmetic and roots, and no function
# whose rounding or random numbers depend on the library.
SAME_EVERYWHERE = ["core/base/rng.h", "core/layout/sampling/*"]
DIFFERS = re.compile(
    r"\b(?:std|glm)::((?:a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p)?|pow|cbrt|hypot|tgamma|lgamma|erfc?|fma"
    r"|mt19937\w*|minstd\w+|default_random_engine|random_device|\w+_distribution|shuffle|sample|hash)\b)"
)


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1)


def layer_of(name):
    """Returns the layer of a path: 1 for 'core/mesh/query/bvh.h', -1 for a path outside core."""
    parts = name.split("/")
    return LAYERS.index(parts[1]) if len(parts) > 2 and parts[0] == "core" and parts[1] in LAYERS else -1


def window_room_of(name):
    """Returns the room of a path of the window: 0 for 'app/studio/frame/app.h', -1 for any other path."""
    parts = name.split("/")
    return WINDOW_ROOMS.index(parts[2]) if parts[:2] == ["app", "studio"] and parts[2] in WINDOW_ROOMS else -1


def matches(relative, patterns):
    """Returns whether a path matches a glob: * is any part of a name, ** any number of folders."""
    return any(re.fullmatch(as_regex(pattern), relative) for pattern in patterns)


def as_regex(pattern):
    parts = {"**/": "(?:.*/)?", "**": ".*", "*": "[^/]*"}
    return "".join(parts.get(part) or re.escape(part) for part in re.split(r"(\*\*/|\*\*|\*)", pattern))


def check_include(relative, header):
    """Returns the complaint about one include, or None."""
    if SYSTEM_HEADER.fullmatch(header) and not relative.startswith(SYSTEM_FOLDER):
        return f"{header} belongs in {SYSTEM_FOLDER}: calls of the operating system have one folder"
    own, other = layer_of(relative), layer_of(header)
    if own >= 0 and other > own:
        return f"core/{LAYERS[own]} must not use {header}: it lies to its right"
    if relative.startswith("core/") and header.split("/")[0] in ("ui", "app"):
        return f"core must not use {header}"
    if relative.startswith("ui/"):
        if header.startswith("core/sim/"):
            return f"the window must not use {header}: what it shows of a run is in core/run"
        if header.startswith("app/") or header in UI_NEVER:
            return f"the window must not use {header}"
    if FREE_OF_FILES.fullmatch(relative):
        if header.startswith(("core/sim/", "nlohmann/", "epoxy/", "ui/gl/")) or header in UI_NEVER:
            return f"a feature's state, panel and tool must not use {header}"
    if re.fullmatch(r"app/studio/nouns/.*_job\.(?:h|cpp)", relative):
        if header.startswith(("imgui", "implot", "epoxy/", "ui/gl/")):
            return f"a feature's job must not use {header}"
    own, other = window_room_of(relative), window_room_of(header)
    if 0 <= own < other:
        return f"app/studio/{WINDOW_ROOMS[own]} must not use {header}: it lies to its right"
    if relative.startswith("app/cli/") and header.startswith("ui/"):
        return f"the command line must not use {header}"
    if relative.startswith("app/plugin/") and header.startswith(("ui/", "app/cli", "app/studio")):
        return f"the plugin must not use {header}"
    for prefix, allowed in LIBRARIES.items():
        if header.startswith(prefix) and not matches(relative, allowed):
            return f"{header} belongs in {allowed or 'no file'}"
    return None


def system_calls(relative, text):
    if relative.startswith(SYSTEM_FOLDER):
        return
    for number, line in enumerate(text.splitlines(), 1):
        for match in SYSTEM_CALL.finditer(line.split("//")[0]):
            yield f"src/{relative}:{number}: {match.group(0)} belongs in {SYSTEM_FOLDER}"


def whole_messages(relative, text):
    if not relative.startswith("app/studio/"):
        return
    for number, line in enumerate(text.splitlines(), 1):
        if WHOLE_MESSAGE.search(line.split("//")[0]):
            yield f"src/{relative}:{number}: the window shows messages by shown_message(), which cuts long ones"


def library_bits(relative, text):
    if not matches(relative, SAME_EVERYWHERE):
        return
    for number, line in enumerate(text.splitlines(), 1):
        for match in DIFFERS.finditer(line.split("//")[0]):
            yield f"src/{relative}:{number}: {match.group(1)} differs between machines"


def widely_included_kernels(source):
    graph = {
        path.relative_to(source).as_posix(): {header for _, header in includes(path)}
        for path in source.rglob("*")
        if path.suffix in (".h", ".cpp")
    }
    sources = collections.Counter()
    for name in graph:
        if not name.endswith(".cpp"):
            continue
        reached, pending = set(), {name}
        while pending:
            reached |= pending
            pending = set().union(*(graph.get(file, ()) for file in pending)) - reached
        sources.update(reached)
    for header, count in sorted(sources.items()):
        if KERNEL_HEADERS.fullmatch(header) and count > MAX_KERNEL_SOURCES:
            yield f"src/{header}: reaches {count} sources, at most {MAX_KERNEL_SOURCES}: declare its types in other headers"


def complaints(root):
    source = pathlib.Path(root) / "src"
    yield from widely_included_kernels(source)
    for path in sorted(source.rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        relative = path.relative_to(source).as_posix()
        for number, header in includes(path):
            complaint = check_include(relative, header)
            if complaint:
                yield f"src/{relative}:{number}: {complaint}"
        yield from library_bits(relative, path.read_text())
        yield from system_calls(relative, path.read_text())
        yield from whole_messages(relative, path.read_text())
        lines = len(path.read_text().splitlines())
        if lines > MAX_FILE_LINES:
            yield f"src/{relative}: {lines} lines, at most {MAX_FILE_LINES}: one noun a file"


def main(root):
    found = list(complaints(root))
    for line in found:
        print(line)
    print(f"{len(found)} broken rules")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
