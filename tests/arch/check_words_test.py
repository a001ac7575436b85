#!/usr/bin/env python3
"""Shows that check_words.py detects each kind of broken rule, and accepts text that keeps the rules."""
import pathlib
import tempfile

import check_words

HEAD = "// A file of the test.\n#pragma once\n"
LONG = "x" * 81
BROKEN = {  # text with one offence -> part of the message
    "src/a/comment.h": (HEAD + "/// The mesh is read anew.\nstruct A;\n", "'anew' in a comment"),
    "src/a/block.h": (HEAD + "/// The pose that\n/// is told by the run.\nstruct A;\n", "'told' in a comment"),
    "src/a/what.h": (HEAD + "/// Returns what is near.\nint f();\n", "'what is' in a comment"),
    "src/a/text.cpp": ('const char* kText = "so many";\n', "'so many' in a text"),
    "src/a/raw.cpp": ('const char* kText = R"(line\nby clock)";\n', "'by clock' in a text"),
    "src/a/type.h": (HEAD + "/// Holds a ProbeWish.\nstruct A;\n", "'ProbeWish' in a comment"),
    "tests/a/name_test.cpp": ("// Tests.\nTEST(A, TellsTheReason) {}\n", "'Tells' in a test name"),
    "docs/page.md": ("# Page\n\nThe pose stands in the file.\n", "'stands' in a document"),
    "shaders/a.frag": ("// beside the line\nvoid main() {}\n", "'beside' in a comment"),
    "src/a/fragment.h": (HEAD + "struct A {\n  int i = 0;  ///< of the geom\n};\n", "begins with 'of'"),
    "src/a/behind.h": (HEAD + f"struct A {{\n  int i = 0;  ///< {LONG}\n}};\n", "has 81 characters"),
    "src/a/behind_two_lines.h": (HEAD + "struct A {\n  int i = 0;  ///< none:\n              ///< no geom\n};\n", "begins with 'none:'"),
    "src/a/brace.h": (HEAD + "struct A {\n  struct {\n    int j;\n  };  ///< the number\n};\n", "a lone brace"),
    "src/a/within.h": (HEAD + "/// The state. /// The rest.\nstruct A;\n", "a comment within a comment"),
    "src/a/small.h": (HEAD + "/// the state.\nstruct A;\n", "the small letter of 'the'"),
    "src/a/stop.h": (HEAD + "/// The state\nstruct A;\n", "without a full stop"),
    "src/a/literal.cpp": ('auto t = call("The "\n              "rest of it");\n', "broken after the single word 'The'"),
    "tests/a/long_test.cpp": ("// Tests.\nTEST(A, Reads" + "X" * 56 + ") {}\n", "has 61 characters"),
    "tests/a/begin_test.cpp": ("// Tests.\nTEST_F(A, AsLongAsItRuns) {}\n", "begins with 'As'"),
    "src/a/no_summary.h": ("#pragma once\n", "no summary"),
    "src/a/what_summary.h": ("// How a sensor reads.\n#pragma once\n", "the summary begins with 'How'"),
    "src/a/no_sentence.h": ("// A sensor\n#pragma once\n", "the summary is no sentence"),
    "tests/a/no_summary_test.cpp": ('#include "a.h"\n', "no summary"),
    "src/a/throws.h": (HEAD + "/// Reads a file.\nint read_it(int a);\n", "read_it() throws"),
}
SOURCES = {"src/a/throws.cpp": 'int read_it(int a) {\n  if (a) throw Error("a");\n  return 0;\n}\n',
           "src/a/says.cpp": 'int read_it(int a) {\n  if (a) throw Error("a");\n  return 0;\n}\n'}
FINE = {
    "src/a/fine.h": HEAD + "/// The state: what happens next? `p_W` is a point.\nstruct A {\n  int i = 0;  ///< index of the geom, or -1\n"
                           "  // x is the first.\n  int x;\n};\n",
    "src/a/fine.cpp": 'int f() {\n  // in a function\n  throw "one long text that "\n        "goes on";\n  return e.what() + 1\'000;\n}\n'.replace(
        "// in", "// In"),
    "src/a/names.h": HEAD + "/// taxel_ids of the layout.\nint f();\n\n/// radius(taxel) is positive.\ndouble radius(int taxel);\n",
    "src/a/says.h": HEAD + "/// Reads a file. Throws Error if it is missing.\nint read_it(int a);\n\n"
                           "// The next one is no function.\nread_it(const A&) = delete;\n",
    "tests/a/fine_test.cpp": "// Tests.\nTEST(A, ReadsWhatHappensAfterWhatever) {}\nTEST(A, UpdatesAspect) {}\n",
    "docs/page.md": "# What is a taxel?\n\nThe letter E stands for the modulus; `stands` is a key. The hand of five fingers closes.\n",
}
COMMITS = [("x" * 73, "", 1), ("WIP on it", "", 1), ("Merge branch 'a'", "", 1), ("Move the house", " \n", 4)]
FINE_COMMITS = [("x" * 72, "", 3), ("Move the house", "Because it is small.", 4)]


def with_files(files, act):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return act(folder)


found = with_files({**SOURCES, **{name: text for name, (text, _) in BROKEN.items()}}, check_words.offences)
for name, (_, message) in BROKEN.items():
    messages = [m for _, m in found.get(name, [])]
    assert len(messages) == 1 and message in messages[0], f"{name}: {messages} instead of '{message}'"
assert set(found) == set(BROKEN), f"wrongly blamed: {set(found) - set(BROKEN)}"
found = with_files({**SOURCES, **FINE}, check_words.offences)
assert not found, f"wrongly blamed: {found}"

# A number of the list may be neither too small nor too large, and --write only lowers it.
one = {"docs/a.md": "told anew\n", "docs/b.md": "fine\n", "docs/c.md": "told\n", "docs/new.md": "anew\n"}
listed = {**one, check_words.ALLOWED: "docs/a.md 1\ndocs/b.md 1\ndocs/c.md 2\n"}
lines = with_files(listed, lambda root: list(check_words.complaints(root)))
assert "docs/a.md: 2 offences, allowed are 1" in lines and "docs/new.md: 1 offences, allowed are 0" in lines, lines
assert sum("run check_words.py . --write" in line for line in lines) == 2, lines


def written(root):
    check_words.write(root)
    return (pathlib.Path(root) / check_words.ALLOWED).read_text()


assert with_files(listed, written) == "docs/a.md 1\ndocs/c.md 1\n"
first = {**one, "tests/arch/README": ""}
assert with_files(first, written) == "docs/a.md 2\ndocs/c.md 1\ndocs/new.md 1\n"

blamed = list(check_words.subject_complaints(COMMITS))
assert len(blamed) == len(COMMITS), blamed
assert not list(check_words.subject_complaints(FINE_COMMITS))
commits, skipped = with_files({}, check_words.commits_since_tag)
assert commits == [] and skipped, "a folder without git has no commits to check"
print("every broken rule of words is seen")
