"""Runs the code of the pages unchanged, in the folder `/`: README.md, python/README.md and docs/*.md."""
import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import taxel
from taxel import programs

ROOT = pathlib.Path(__file__).parents[2]
PAGES = ["README.md", "python/README.md", *sorted(f"docs/{page.name}" for page in (ROOT / "docs").glob("*.md"))]
#: Packages that some pages need. A page whose packages are absent is skipped.
OPTIONAL = ("gymnasium", "mcap", "mcap_ros2", "pyarrow", "ray")
#: Packages that the tests never install. A block that imports one of them is left out.
NEVER = ("lerobot",)  # needs PyTorch
PYTHON = [sys.executable, *(["-S"] if sys.flags.no_site else [])]


def blocks_of(page, language):
    """Returns the blocks of a language as pairs of line and text."""
    text = (ROOT / page).read_text()
    found = re.finditer(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    return [(text.count("\n", 0, match.start(1)) + 1, match[1]) for match in found]


def packages_of(block):
    return re.findall(r"^(?:import|from) (\w+)", block, re.MULTILINE)


def program_of(page):
    """Returns all Python code of a page as one program, in which each line has its number in the page."""
    program = ""
    for line, block in blocks_of(page, "python"):
        if not set(packages_of(block)) & set(NEVER):
            program += "\n" * (line - 1 - program.count("\n")) + block
    return program


def run_code_of(page):
    """Runs all code of a page as one program in the folder `/`, and returns its output."""
    before = set(os.listdir("/"))
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / f"{pathlib.Path(page).stem}.md.py"
        file.write_text(program_of(page))
        result = subprocess.run([*PYTHON, str(file)], cwd="/", capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(f"{page}: {result.stderr}")
    written = set(os.listdir("/")) - before
    if written:
        raise AssertionError(f"{page}: writes into the working directory: {written}")
    return result.stdout


class PagesTest(unittest.TestCase):
    def test_code_of_every_page_runs_in_the_root_folder(self):
        printed = {
            "README.md": r"^fingertip taxels [\s\S]* Pa\n$",
            "python/README.md": r"^fingertip taxels [\s\S]* Pa\n$",
            "docs/python.md": r"^fingertip 2855\.4\d* Pa\n[\s\S]*/taxels/3/radius must be greater than 0",
            "docs/plugin.md": r"^\[[\s\S]*\]\n$",
            "docs/gym.md": r"reading right pad low Pa",
            "docs/mcap.md": r"( Pa\n.*){501}",
            "docs/many_runs.md": r"20 of 20\n",
        }
        with_code = [page for page in PAGES if program_of(page)]
        self.assertEqual(set(with_code), set(printed))
        for page in with_code:
            missing = [name for name in packages_of(program_of(page)) if name in OPTIONAL and not importlib.util.find_spec(name)]
            with self.subTest(page=page):
                if missing:
                    self.skipTest(f"{page} needs {', '.join(missing)}")
                self.assertRegex(run_code_of(page), printed[page])

    def test_commands_of_the_pages_have_these_options(self):
        helps, count = {}, 0
        for page in PAGES:
            for line, block in blocks_of(page, "sh"):
                for text in re.findall(r"^taxel (.*)$", block, re.MULTILINE):
                    command, *words = text.partition(" #")[0].split()
                    if command not in helps:
                        result = subprocess.run([programs.path_of("taxel"), command, "--help"], capture_output=True, text=True)
                        helps[command] = result.stdout
                    for word in words:
                        is_known = not word.startswith("--") or re.search(rf"{word}\b", helps[command])
                        self.assertTrue(helps[command] and is_known, f"{page}, line {line}: taxel {text}")
                    count += 1
        self.assertGreater(count, 20)

    def test_documents_of_the_pages_are_read(self):
        kinds = set()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(taxel.Layout.read(taxel.FINGERTIP).mesh_file, folder)
            for page in PAGES:
                for line, block in blocks_of(page, "json"):
                    for document in documents_of(block):
                        with self.subTest(page=page, line=line):
                            kinds.add(check_document(document, pathlib.Path(folder)))
        self.assertEqual(kinds, {"taxel-layout", "taxel-project", "taxel-study", "calibration", "text"})

    def test_links_of_the_pages_lead_to_files_and_headings(self):
        count = 0
        for page in sorted({*PAGES, *(str(path.relative_to(ROOT)) for path in (ROOT / "docs").rglob("*.md"))}):
            for target in re.findall(r"\]\(([^)\s]+)\)", (ROOT / page).read_text()):
                if target.startswith("http"):
                    continue
                name, _, heading = target.partition("#")
                file = (ROOT / page).parent / name if name else ROOT / page
                self.assertTrue(file.exists(), f"{page}: {target}")
                if heading and file.suffix == ".md":
                    self.assertIn(heading, anchors_of(file.read_text()), f"{page}: {target}")
                count += 1
        self.assertGreater(count, 50)

    def test_parts_of_scenes_are_well_formed(self):
        blocks = blocks_of("docs/plugin.md", "xml")
        self.assertGreater(len(blocks), 3)
        for _, block in blocks:
            xml.etree.ElementTree.fromstring(f"<mujoco>{block}</mujoco>")


def anchors_of(text):
    """Returns the names by which links refer to the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def documents_of(block):
    """Returns the documents of a block: one, one on each line, or the value of a key."""
    if block.startswith('"'):
        return [json.loads(f"{{{block}}}")]
    try:
        return [json.loads(block)]
    except json.JSONDecodeError:
        return [json.loads(line) for line in block.splitlines()]


def check_document(document, folder):
    """Raises AssertionError if the program refuses a document. Returns the kind of the document."""
    kind = document.get("format", "text")
    if "calibration" in document:
        kind, document = "calibration", {**json.loads(taxel.FINGERTIP.read_text()), **document}
    if kind in ("taxel-layout", "calibration"):
        layout = taxel.Layout.parse(json.dumps(document), str(taxel.FINGERTIP))
        wrong = [problem for problem in layout.check(mesh=False) if problem.severity != "note"]
        assert not wrong, wrong
    elif kind != "text":
        file = folder / "document.json"
        file.write_text(json.dumps(document))
        result = subprocess.run([programs.path_of("taxel"), "check", file], capture_output=True, text=True)
        assert result.returncode < 2 and " 0 errors" in result.stdout, result.stdout + result.stderr
    return kind


if __name__ == "__main__":
    unittest.main()
