"""The programs of this package, `taxel` and `taxelstudio`.

The programs bring their own MuJoCo. They run as processes of their own, so that the process of the caller never has two.
"""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
import typing

from taxel.errors import Error


def path_of(name: str) -> pathlib.Path:
    """Returns the path of a program. Raises Error if the package was built without it."""
    path = pathlib.Path(__file__).parent / "bin" / name
    if not path.exists():
        raise Error(str(path), "", f"is missing: this package was built without {name}")
    return path


def run(arguments: typing.Sequence[str], files: typing.Mapping[str, str]) -> None:
    """Runs `taxel` with these arguments. `files` maps the files of the arguments to their names in messages.

    Raises Error with the program's message. Notes and warnings of the program go to stderr.
    """
    command = [str(path_of("taxel")), *arguments]
    # The child process does not hold Python's lock, and Python waits without it.
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          text=True, encoding="utf-8", errors="replace") as process:
        try:
            _, messages = process.communicate()
        except BaseException:
            process.terminate()
            raise
    lines = messages.splitlines()
    if process.returncode == 0:
        for line in lines:
            print(line, file=sys.stderr)
        return
    raise error_of(arguments, messages, process.returncode, files)


def error_of(
    arguments: typing.Sequence[str], messages: str, status: int, files: typing.Mapping[str, str]
) -> Error:
    """Returns the error of a program that has failed. The last line of `messages`, its stderr, has the reason."""
    lines = messages.splitlines()
    message = lines[-1].removeprefix("taxel: ") if lines else f"taxel ended with the status {status}"
    return _split(message.removeprefix(f"{arguments[0]}: "), files)


def _split(message: str, files: typing.Mapping[str, str]) -> Error:
    """Splits "FILE: WHERE: message" into its parts. The file is one of `files`."""
    file = ""
    for path, name in files.items():
        if message.startswith(path + ": "):
            file, message = name, message[len(path) + 2 :]
            break
    pointer, colon, rest = message.partition(": ")
    if colon and pointer.startswith(("/", "--")) and " " not in pointer:
        return Error(file, pointer, rest)
    return Error(file, "", message)


def _replace_process(name: str) -> typing.NoReturn:
    try:
        program = str(path_of(name))
    except Error as error:
        sys.exit(f"{name}: {error}")
    os.execv(program, [name, *sys.argv[1:]])


def taxel() -> typing.NoReturn:
    """Becomes the program `taxel`: the command that pip installs."""
    _replace_process("taxel")


def taxelstudio() -> typing.NoReturn:
    """Becomes the program `taxelstudio`: the command that pip installs."""
    _replace_process("taxelstudio")
