"""Finds the words of a C++ file: comments, string literals and the names of tests, each with its line."""
import re
from dataclasses import dataclass

from cpp_text import scopes

_TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)'
    r'|(?P<raw>\bR"(?P<tag>[^()\s\\]{0,16})\((?P<body>.*?)\)(?P=tag)")'
    r'|(?P<string>"(?:\\.|[^"\\\n])*")'
    r"|(?P<digits>(?<=[0-9a-fA-F])'(?=[0-9a-fA-F]))"
    r"|(?P<character>'(?:\\.|[^'\\\n])+')",
    re.DOTALL,
)
_TEST = re.compile(r"^(?:TEST|TEST_P|TEST_F|TYPED_TEST|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+)", re.M)


@dataclass
class Literal:
    line: int
    text: str  # text without the quotes
    raw: bool
    begin: int  # offset of the token in the file
    end: int


@dataclass
class Comment:
    """A comment behind code, or a block of whole lines of one kind."""

    line: int
    text: str  # the lines without their slashes, joined by line ends
    mark: str  # "//", "///", "///<" or "/*"
    alone: bool  # is on its own lines
    last_line: int = 0
    in_function: bool = False
    next_code: str = ""  # the line directly below, stripped


class Words:
    def __init__(self, text):
        self.lines = text.split("\n")
        self.literals, single = [], []
        for token in _TOKEN.finditer(text):
            line = text.count("\n", 0, token.start()) + 1
            if token.group("string") is not None:
                if not self.lines[line - 1].lstrip().startswith("#include"):
                    self.literals.append(Literal(line, token.group()[1:-1], False, token.start(), token.end()))
            elif token.group("raw") is not None:
                self.literals.append(Literal(line, token.group("body"), True, token.start(), token.end()))
            elif token.group("comment") is not None:
                single.append(self._comment(text, token, line))
        self.comments = self._blocks(single)
        self.tests = [(text.count("\n", 0, m.start()) + 1, m.group(1), m.group(2)) for m in _TEST.finditer(text)]
        self._mark_functions(text)

    def _comment(self, text, token, line):
        whole = token.group()
        mark = re.match(r"///<|///|//|/\*", whole).group()
        body = whole[len(mark):-2] if mark == "/*" else whole[len(mark):]
        start = text.rfind("\n", 0, token.start()) + 1
        return Comment(line, body.strip() if mark == "/*" else body[1:] if body.startswith(" ") else body, mark,
                       not text[start:token.start()].strip(), line + whole.count("\n"))

    def _blocks(self, single):
        blocks = []
        for comment in single:
            last = blocks[-1] if blocks else None
            follows = last is not None and comment.alone and comment.line == last.last_line + 1 and comment.mark != "/*"
            if follows and last.alone and last.mark == comment.mark:
                last.text += "\n" + comment.text
                last.last_line = comment.line
            elif follows and not last.alone and self._continues(comment, last):
                last.text += "\n" + comment.text  # a trailing comment that continues in the next line
                last.last_line = comment.line
            else:
                blocks.append(comment)
        for block in blocks:
            block.next_code = self.lines[block.last_line].strip() if block.last_line < len(self.lines) else ""
        return blocks

    def _continues(self, comment, last):
        column = self.lines[last.line - 1].find("//")
        return self.lines[comment.line - 1].find("//") == column and comment.mark == last.mark

    def _mark_functions(self, text):
        bodies = [(s.first_line, s.last_line) for s in scopes(text) if s.kind == "function"]
        for comment in self.comments:
            comment.in_function = any(first < comment.line <= last for first, last in bodies)
