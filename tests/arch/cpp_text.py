"""Parses C++ for the checks: without comments and texts, into statements and scopes."""
import functools
import re

_IGNORED = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>[^()\s\\]{0,16})\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'',
    re.DOTALL,
)
_BRACE = re.compile(r"[{}]")
_ACCESS = re.compile(r"\b(public|private|protected)\s*:$")
_TYPE = re.compile(r"\b(class|struct|union)\s+(?:\[\[\w+\]\]\s*)?([\w:]+)?[^()=]*$")


def bare(text):
    """Returns the text with blanked comments, literals and preprocessor lines. Every line keeps its number."""

    def blank(match):
        kept = "\n" * match.group(0).count("\n")
        return kept if match.group(0).startswith("/") else '""' + kept

    # 1'000 is a number and not the beginning of a character.
    text = re.sub(r"(?<=[0-9a-fA-F])'(?=[0-9a-fA-F])", "", text)
    text = _IGNORED.sub(blank, text)
    lines, goes_on = [], False
    for line in text.split("\n"):
        directive = goes_on or line.lstrip().startswith("#")
        goes_on = directive and line.rstrip().endswith("\\")
        lines.append("" if directive else line)
    return "\n".join(lines)


class Scope:
    """A pair of braces outside functions, or a function's body."""

    def __init__(self, kind, name, head, line):
        self.kind, self.name, self.head, self.first_line = kind, name, head, line
        self.last_line = line
        self.statements = []  # declarations of a type that end with a semicolon
        self.bodies = []  # heads of the functions that are defined in a type


def _name_of_function(head):
    before = head[: head.index("(")]
    words = re.findall(r"[\w:~<>]+|operator\S+", before)
    return words[-1] if words else "?"


def _kind(head):
    if re.search(r"\bnamespace\b|extern\s*\"\"", head):
        return "namespace", ""
    if re.search(r"\benum\b", head):
        return "value", ""
    found = _TYPE.search(re.sub(r"template\s*<.*?>\s*(?=class|struct|union)", "", head, flags=re.DOTALL))
    if found:
        return "type", found.group(2) or "?"
    outside = re.sub(r"\([^()]*\)", "()", re.sub(r"\([^()]*\)", "()", head))
    if "(" in head and not re.search(r"(?<![=!<>])=(?!=)", outside.replace("operator=", "")):
        return "function", _name_of_function(head)
    return "value", ""


def _end_of_body(text, begin):
    """Returns the index of the brace that closes the body whose opening brace is before `begin`, or the text's length."""
    depth = 1
    for brace in _BRACE.finditer(text, begin):
        depth += 1 if brace.group() == "{" else -1
        if depth == 0:
            return brace.start()
    return len(text)


@functools.lru_cache(maxsize=None)
def scopes(text):
    """Returns all types and functions of a file. Bodies of functions are not parsed."""
    text = bare(text)
    found, open_scopes, head, line, head_line, at = [], [], "", 1, 1, 0
    while at < len(text):
        character = text[at]
        at += 1
        top = open_scopes[-1] if open_scopes else None
        if character == "\n":
            line += 1
        if character == "{":
            kind, name = _kind(head)
            scope = Scope(kind, name, head.strip(), head_line)
            if kind in ("function", "value"):  # only the end of the scope matters
                end = _end_of_body(text, at)
                line += text.count("\n", at, end)
                scope.last_line = line
                if kind == "function" and end < len(text):
                    found.append(scope)
                    if top is not None:
                        top.bodies.append(scope.head)
                head = "" if kind == "function" else head + "{}"
                at = end + 1
            else:
                open_scopes.append(scope)
                head = ""
        elif character == "}":
            if top is not None:
                top.last_line = line
                open_scopes.pop()
                if top.kind == "type":
                    found.append(top)
            head = ""
        elif character == ";":
            if top is not None and top.kind == "type" and head.strip():
                top.statements.append(head.strip())
            head = ""
        else:
            if not character.isspace() and not head.strip():
                head, head_line = "", line
            head += character
            if character == ":" and _ACCESS.search(head):
                head = ""
    return found


def _top_level(statement):
    """Returns the text without the content of brackets of any kind, and without values."""
    for pattern in (r"\{[^{}]*\}", r"\([^()]*\)", r"\[[^\[\]]*\]", r"<[^<>]*>"):
        before = None
        while before != statement:
            before, statement = statement, re.sub(pattern, "", statement)
    return re.sub(r"=[^,]*", "", statement)


def data_members(scope):
    """Returns the number of data members that a type declares."""
    count = 0
    for statement in scope.statements:
        if re.match(r"(using|typedef|friend|static|template|enum|class|struct|union|constexpr)\b", statement):
            continue
        values = re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", re.sub(r"<[^<>]*>", "", statement)))
        declared = re.split(r"[={]", values)[0]
        if "(" in declared:
            continue  # a method
        count += 1 + _top_level(statement).count(",")
    return count


def methods(scope):
    """Returns the number of methods that a type declares, with its constructors, without deleted and defaulted ones."""
    count = 0
    for declared in scope.bodies + [s for s in scope.statements if not re.search(r"=\s*(default|delete)$", s)]:
        if re.match(r"(using|typedef|friend|enum|static_assert)\b", declared):
            continue
        head = re.sub(r"\boperator\s*[^\s\w(]+", "operator", re.sub(r"\balignas\s*\([^()]*\)", "", declared))
        before = None
        while before != head:
            before, head = head, re.sub(r"<[^<>]*>", "", head)
        head = re.split(r"[={]", head)[0]
        count += "(" in head and not re.search(r"\(\s*\*", head)  # int (*f)(int) is a data member
    return count


def has_methods(scope):
    return any("(" in re.split(r"[={]", re.sub(r"<[^<>]*>", "", s))[0] for s in scope.statements)
