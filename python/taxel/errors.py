"""The exception for bad input."""

from __future__ import annotations


class Error(ValueError):
    """Bad input, such as a broken rule of a layout.

    `file` is the file, or an empty text. `pointer` is the place in it: a JSON pointer such as /taxels/3/radius, a line or
    a taxel, or an empty text. `message` says which rule is broken by which value. `str()` joins the three.
    """

    def __init__(self, file: str, pointer: str, message: str) -> None:
        super().__init__(file, pointer, message)
        self.file = file
        self.pointer = pointer
        self.message = message

    def __str__(self) -> str:
        return ": ".join(part for part in self.args if part)
