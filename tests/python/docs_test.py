"""Runs the Python code of the pages that describe the package."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
# The entry point of the wheel loads the plugin on `import mujoco`. The tests' package has no entry points.
START = "import taxel; taxel.load_plugin()\n"


def run_code_of(page):
    """Runs all code of a page as one program in an empty folder, and returns its output."""
    blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / page).read_text(), re.MULTILINE | re.DOTALL)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "page.py"
        file.write_text(START + "\n".join(blocks))
        result = subprocess.run([sys.executable, str(file)], cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(f"{page}: {result.stderr}")
    return result.stdout


class PagesTest(unittest.TestCase):
    def test_readme_prints_readings_with_their_unit(self):
        for page in ("README.md", "python/README.md"):
            self.assertRegex(run_code_of(page), r"^fingertip taxels [\s\S]* Pa\n$")

    def test_guide_prints_what_its_comments_say(self):
        printed = run_code_of("docs/python.md")
        self.assertRegex(printed, r"^fingertip 2855\.4\d* Pa\n")
        self.assertIn("/taxels/3/radius must be greater than 0", printed)


if __name__ == "__main__":
    unittest.main()
