#!/usr/bin/env python3
"""Checks for plain English in comments, texts, test names, documents and commit subjects.

words_allowed.txt lists the files that break a rule today, with their number of offences. A number may only fall.

  check_words.py ROOT                 fails on every file with more offences than its line allows, or with fewer
  check_words.py ROOT --write         lowers the numbers to today's; without words_allowed.txt it lists all of today's
  check_words.py ROOT --list [PATH]   prints each offence of the files below PATH
"""
import collections
import pathlib
import re
import subprocess
import sys

from cpp_text import scopes
from cpp_words import Words

CODE_FOLDERS = ("src", "tests", "bench")
SHADERS = "shaders"
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "docs/**/*.md", "bench/**/*.md")
ALLOWED = "tests/arch/words_allowed.txt"
MAX_TRAILING = 80  # characters of a comment behind a member
MAX_TEST_NAME = 60
MAX_SUBJECT = 72
FILES_WITHOUT_BODY = 3  # a commit that changes more says why in its body

BANNED = re.compile(r"\b(anew|told|tells|\w*Wish|\w*News|the hand|stands|beside|likewise|homeless|by clock|so many)\b",
                    re.IGNORECASE)
# "what" in the sense of "the thing that". A question keeps its "what", and so do "what happens" and "what to do".
RELATIVE_WHAT = re.compile(r"(?<![`\w.])what (?:is|it|the|was|are|were|has|they|its|a|an|of|one|can|cannot|this|that)\b[^.?\n]*(.?)",
                           re.IGNORECASE)
# Texts that use a banned word in its proper sense, each with the reason.
EXCEPTIONS = (
    (re.compile(r"\bthe hand(?= of five fingers|'s fingers|.s palm)|\b(?:robot|five-finger(?:ed)?|artificial|prosthetic) hand\b",
                re.IGNORECASE), "a robot hand is a hand"),
    (re.compile(r"\bthe hand\b(?=[^.]*\bfingers?\b)", re.IGNORECASE), "the example model of a robot hand with fingers"),
    (re.compile(r"\bstands for\b"), "the usual verb between a symbol and its meaning"),
)
POINTLESS_BEGIN = re.compile(r"(of|that|what|which|whose|as|none|null|else|likewise|where)\b", re.IGNORECASE)
TEST_BEGIN = re.compile(r"(What|Nothing|Of|That|As|Where|Up|Likewise)(?![a-z])")
SUMMARY_BEGIN = re.compile(r"(what|where|which|whose|that|how|of|as|likewise)\b", re.IGNORECASE)
LOWER_WORD = re.compile(r"(?!taxel(?:studio)?\b)(?:a|[a-z]{2,})(?:-[a-z]+)*(?=[ ,;:!?]|\.(?:\s|$)|$)")  # programs keep their name


def banned_words(text):
    """Yields each banned word of a text."""
    for exception, _ in EXCEPTIONS:
        text = exception.sub("", text)
    for match in BANNED.finditer(text):
        yield match.group(1)
    for match in RELATIVE_WHAT.finditer(text):
        if match.group(1) != "?":
            yield " ".join(match.group().split()[:2])


def one_line(text):
    return " ".join(text.split())


def split_name(name):
    """'ReadsZeroOnce' -> 'Reads Zero Once', so that words are found in it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name)


def check_banned(words):
    """Check 1."""
    for comment in words.comments:
        for word in banned_words(one_line(comment.text)):
            yield comment.line, f"'{word}' in a comment"
    for literal in words.literals:
        for word in banned_words(one_line(literal.text)):
            yield literal.line, f"'{word}' in a text"
    for line, _, name in words.tests:
        for word in banned_words(split_name(name)):
            yield line, f"'{word}' in a test name"


def check_trailing(words):
    """Check 2: comments behind members."""
    for comment in words.comments:
        if comment.mark != "///<":
            continue
        text = one_line(comment.text)
        if POINTLESS_BEGIN.match(text):
            yield comment.line, f"a comment behind a member begins with '{text.split()[0]}'"
        if len(text) > MAX_TRAILING:
            yield comment.line, f"a comment behind a member has {len(text)} characters, at most {MAX_TRAILING}"
        if re.match(r"\s*\};?\s*///<", words.lines[comment.line - 1]):
            yield comment.line, "a comment of a member is behind a lone brace"


def begins_lower(text, next_code):
    """Returns whether a block begins with a small letter that is not a name of the code."""
    match = LOWER_WORD.match(text)
    return match is not None and not re.search(rf"\b{re.escape(match.group())}\b", next_code)


def is_declaration(line):
    return bool(line) and not line.startswith(("}", "#", "//", "public", "private", "protected"))


def check_blocks(words):
    """Check 3: comments on lines of their own."""
    for comment in words.comments:
        text = comment.text.strip()
        if comment.mark.startswith("///") and "///" in text:
            yield comment.line, "a comment within a comment"
        if not comment.alone or not text or comment.mark in ("/*", "///<") or set(text) <= set("-=/ \n"):
            continue
        if begins_lower(text, comment.next_code):
            yield comment.line, f"a comment begins with the small letter of '{text.split()[0]}'"
        ends = re.search(r"[.!?:][)`\"']*$", text) or re.search(r"https?://\S+$|^\s{2,}\S.*$", comment.text.split("\n")[-1])
        if not comment.in_function and is_declaration(comment.next_code) and not ends:
            yield comment.last_line, "a comment above a declaration ends without a full stop"


def check_literals(words, text):
    """Check 4: literals broken after a single word."""
    before = None
    for literal in words.literals:
        joined = before is not None and not before.raw and not literal.raw
        between = text[before.end:literal.begin] if joined else "x"
        if joined and not between.strip() and "\n" in between and re.fullmatch(r"[A-Za-z]{2,}[,:;]? ", before.text):
            yield before.line, f"a text is broken after the single word '{before.text.strip()}'"
        before = literal


def check_tests(words):
    """Check 5."""
    for line, suite, name in words.tests:
        if len(name) > MAX_TEST_NAME:
            yield line, f"the test name {suite}.{name} has {len(name)} characters, at most {MAX_TEST_NAME}"
        if TEST_BEGIN.match(name):
            yield line, f"the test name {suite}.{name} begins with '{TEST_BEGIN.match(name).group(1)}'"


def check_summary(words):
    """Check 6, first half: the first line of a header or of a test."""
    first = words.comments[0] if words.comments and words.comments[0].line == 1 else None
    if first is None or first.mark not in ("//", "/*"):
        yield 1, "no summary in the first line"
    elif SUMMARY_BEGIN.match(first.text.strip()):
        yield 1, f"the summary begins with '{first.text.split()[0]}'"
    elif not re.search(r"[.!?:](?=[)\s`\"']|$)", one_line(first.text)):
        yield 1, "the summary is no sentence"


def thrown_in(text):
    """Yields the names of the functions of a source file that throw an Error themselves."""
    lines = text.split("\n")
    for scope in scopes(text):
        body = "\n".join(line.split("//")[0] for line in lines[scope.first_line - 1:scope.last_line])
        if scope.kind == "function" and re.search(r"\bthrow\s+\w*Error\b", body):
            yield scope.name.split("::")[-1]


def check_throws(words, source_text):
    """Check 6, second half: a function of a header that throws in the room's source file says so."""
    throwing, access = set(thrown_in(source_text)) - {"?"}, "public"
    for number, line in enumerate(words.lines, 1):
        access = (re.match(r"\s*(public|private|protected):", line) or [0, "public" if line.startswith("}") else access])[1]
        match = re.match(r"\s*(?!return\b|throw\b|//)[\w:<>,&*\s\[\]]*?[\s&*](\w+)\(", line)
        if not match or match.group(1) not in throwing or access == "private" or re.search(r"noreturn|= delete", line):
            continue
        about = [c.text for c in words.comments if c.last_line == number - 1 or c.line == number]
        above = number - 1
        while above > 0 and words.lines[above - 1].strip() and not about:  # an overload shares the comment above it
            above -= 1
            about = [c.text for c in words.comments if c.last_line == above]
        if not re.search(r"\b(throws?|Error)\b", "\n".join(about), re.IGNORECASE):
            yield number, f"{match.group(1)}() throws and its comment does not say so"


def code_offences(path, text):
    words = Words(text)
    yield from check_banned(words)
    yield from check_trailing(words)
    yield from check_blocks(words)
    yield from check_literals(words, text)
    yield from check_tests(words)
    if path.suffix == ".h" or path.name.endswith("_test.cpp"):
        yield from check_summary(words)
    source = path.with_suffix(".cpp")
    if path.suffix == ".h" and source.exists():
        yield from check_throws(words, source.read_text())


def document_offences(text):
    for number, line in enumerate(text.split("\n"), 1):
        for word in banned_words(re.sub(r"`[^`]*`", "", line)):
            yield number, f"'{word}' in a document"


def offences(root, below=""):
    """Returns the offences as path below the root -> pairs of line and message, for paths that begin with `below`."""
    root, found = pathlib.Path(root), {}

    def chosen(paths):
        return [p for p in sorted(paths) if p.relative_to(root).as_posix().startswith(below)]

    code = [p for folder in CODE_FOLDERS for p in (root / folder).rglob("*") if p.suffix in (".h", ".cpp")]
    shaders = [p for p in (root / SHADERS).glob("*") if p.is_file()]
    documents = [p for pattern in DOCUMENTS for p in root.glob(pattern)]
    for path in chosen(code):
        found[path.relative_to(root).as_posix()] = sorted(code_offences(path, path.read_text()))
    for path in chosen(shaders):
        found[path.relative_to(root).as_posix()] = list(check_banned(Words(path.read_text())))
    for path in chosen(documents):
        found[path.relative_to(root).as_posix()] = list(document_offences(path.read_text()))
    return {name: list_ for name, list_ in found.items() if list_}


def allowed(root):
    file = pathlib.Path(root) / ALLOWED
    lines = file.read_text().splitlines() if file.exists() else []
    return {line.rsplit(" ", 1)[0]: int(line.rsplit(" ", 1)[1]) for line in lines if line}


def subject_complaints(commits):
    """Check 7, for triples of subject, body and number of changed files."""
    for subject, body, files in commits:
        if len(subject) > MAX_SUBJECT:
            yield f"commit '{subject}': {len(subject)} characters, at most {MAX_SUBJECT}"
        if re.search(r"\bWIP\b|^Merge branch\b", subject, re.IGNORECASE):
            yield f"commit '{subject}': one purpose and its reason, no work in progress and no merge"
        if files > FILES_WITHOUT_BODY and not body.strip():
            yield f"commit '{subject}': changes {files} files and its body does not say why"


def commits_since_tag(root):
    """Returns the commits since the last tag and a reason, which is empty unless there are no commits to check."""

    def git(*arguments):
        return subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, text=True, check=False)

    try:
        if git("rev-parse", "--git-dir").returncode != 0:
            return [], "not a git checkout"
    except FileNotFoundError:
        return [], "no git on this machine"
    tag = git("describe", "--tags", "--abbrev=0")
    if tag.returncode != 0:
        return [], "no tag"
    log = git("log", "--format=%x01%s%x02%b%x03", "--name-only", f"{tag.stdout.strip()}..HEAD").stdout
    commits = []
    for entry in log.split("\x01")[1:]:
        subject, rest = entry.split("\x02", 1)
        body, files = rest.split("\x03", 1)
        commits.append((subject, body, len(files.split("\n")) - files.split("\n").count("")))
    return commits, ""


def complaints(root):
    today, limit = offences(root), allowed(root)
    for name, found in today.items():
        if len(found) > limit.get(name, 0):
            yield from (f"{name}:{line}: {message}" for line, message in found)
            yield f"{name}: {len(found)} offences, allowed are {limit.get(name, 0)}"
    for name, count in limit.items():
        if len(today.get(name, [])) < count:
            yield f"{name}: {len(today.get(name, []))} offences, {ALLOWED} says {count}: run check_words.py . --write"


def write(root):
    today, file, limit = offences(root), pathlib.Path(root) / ALLOWED, allowed(root)
    first = not file.exists()
    counts = {name: len(found) for name, found in today.items() if first or name in limit}
    kept = {name: count if first else min(count, limit[name]) for name, count in counts.items()}
    file.write_text("".join(f"{name} {count}\n" for name, count in sorted(kept.items())))


def print_list(root, below=""):
    kinds = collections.Counter()
    for name, found in offences(root, below).items():
        for line, message in found:
            print(f"{name}:{line}: {message}")
            kinds[re.sub(r"'[^']*'|\d+|[\w.]+\(\)|[A-Z]\w*\.\w+", "..", message)] += 1
    for message, count in kinds.most_common():
        print(f"{count:6} {message}")


def main(root, option="", *rest):
    if option == "--list":
        print_list(root, *rest)
        return 0
    if option == "--write":
        write(root)
    found = list(complaints(root))
    commits, skipped = commits_since_tag(root)
    found += subject_complaints(commits)
    if skipped:
        print(f"commit subjects: skipped, {skipped}")
    print("\n".join([*found, f"{len(found)} broken rules of words"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
