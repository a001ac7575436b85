#!/usr/bin/env python3
"""Checks the limits of folders, types and functions, cyclic includes, headers with one user, and the rules of purity.py.

A room is a header with its source file of the same name; x_impl.h belongs to room x. offenders.txt lists everything
that breaks a limit today, with its figure. The figure must not grow, and a line that is no longer needed must be
removed.
"""
import collections
import pathlib
import sys

from check_house import includes
from cpp_text import data_members, has_methods, methods, scopes
from purity import impure_states, mutable_statics, waits

MAX_FOLDER_FILES = 40
MAX_FUNCTION_LINES = 60
MAX_MEMBERS = 20  # members of a type with methods
MAX_METHODS = 25


def sources(root):
    return [path for path in sorted((pathlib.Path(root) / "src").rglob("*")) if path.suffix in (".h", ".cpp")]


def full_folders(root):
    """Yields pairs of the offender and its figure."""
    source = pathlib.Path(root) / "src"
    files = collections.Counter(path.parent for path in source.rglob("*") if path.is_file())
    for folder, count in sorted(files.items()):
        if count > MAX_FOLDER_FILES:
            yield f"folder {folder.relative_to(root).as_posix()}", count


def long_scopes(root):
    for path in sources(root):
        name = path.relative_to(root).as_posix()
        for scope in scopes(path.read_text()):
            lines = scope.last_line - scope.first_line + 1
            if scope.kind == "function" and lines > MAX_FUNCTION_LINES:
                yield f"function {name} {scope.name}", lines
            members = data_members(scope) if scope.kind == "type" else 0
            if members > MAX_MEMBERS and has_methods(scope):
                yield f"members {name} {scope.name}", members
            if scope.kind == "type" and methods(scope) > MAX_METHODS:
                yield f"methods {name} {scope.name}", methods(scope)


def room_of(path):
    """Returns the room of a source file or header, relative to src."""
    return pathlib.PurePosixPath(path).with_suffix("").as_posix().removesuffix("_impl")


def circles(root):
    """Returns groups of rooms that include each other, directly or through others, by Tarjan's algorithm (1972)."""
    source = pathlib.Path(root) / "src"
    rooms = collections.defaultdict(set)
    for path in sources(root):
        room = room_of(path.relative_to(source))
        for _, header in includes(path):
            other = room_of(header)
            if other != room and (source / header).exists():
                rooms[room].add(other)
    index, low, stack, found = {}, {}, [], []

    def visit(room):
        index[room] = low[room] = len(index)
        stack.append(room)
        for other in sorted(rooms.get(room, ())):
            if other not in index:
                visit(other)
            if other in stack:
                low[room] = min(low[room], low[other])
        if low[room] == index[room]:
            group = stack[stack.index(room):]
            del stack[stack.index(room):]
            if len(group) > 1:
                found.append(sorted(group))

    sys.setrecursionlimit(10000)
    for room in sorted(rooms):
        if room not in index:
            visit(room)
    for group in sorted(found):
        yield f"circle {group[0]}", len(group)


def lonely_headers(root):
    """Counts the headers that one other room includes, and no test: they could be a part of that room."""
    users = collections.defaultdict(set)
    for folder in ("src", "tests", "bench"):
        for path in sorted((pathlib.Path(root) / folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                room = room_of(path.relative_to(root))
                for _, header in includes(path):
                    users[header].add(room)
    count = 0
    for path in sources(root):
        header = path.relative_to(pathlib.Path(root) / "src")
        others = users[header.as_posix()] - {"src/" + room_of(header)}
        count += path.suffix == ".h" and len(others) == 1 and others.pop().startswith("src/")
    if count:
        yield "headers with one user", count


def offenders(root):
    rules = (full_folders, long_scopes, circles, lonely_headers, impure_states, waits, mutable_statics)
    return dict(offender for rule in rules for offender in rule(root))


def listed(root):
    file = pathlib.Path(root) / "tests/arch/offenders.txt"
    lines = file.read_text().splitlines() if file.exists() else []
    return {line.rsplit(" ", 1)[0]: int(line.rsplit(" ", 1)[1]) for line in lines if line}


def complaints(root):
    today, allowed = offenders(root), listed(root)
    for what, figure in today.items():
        if figure > allowed.get(what, 0):
            yield f"{what}: {figure}, " + (f"was {allowed[what]}" if what in allowed else "a new offender")
    for what, figure in allowed.items():
        if today.get(what, 0) < figure:
            yield f"{what}: {today.get(what, 'none')}, offenders.txt says {figure}: lower it there"


def main(root, *write):
    if write == ("--write",):  # used after a figure has become smaller
        text = "".join(f"{what} {figure}\n" for what, figure in offenders(root).items())
        (pathlib.Path(root) / "tests/arch/offenders.txt").write_text(text)
    found = list(complaints(root))
    print("\n".join([*found, f"{len(found)} broken limits"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
