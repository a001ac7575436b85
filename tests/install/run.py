#!/usr/bin/env python3
"""Unpacks the tarball of cpack into a folder and tests its content.

    run.py --cmake cmake --cpack cpack --build build/release --source . --cache ~/.cache/taxelstudio --mujoco FOLDER --versions 4.0.1 ...

--versions are the versions of MuJoCo for which the build has a plugin.
"""
import argparse
import configparser
import csv
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import xml.etree.ElementTree as xml

ARGS = argparse.Namespace()
PROGRAMS = ("taxel", "taxelstudio")


def run(*command, cwd=None):
    """Returns what a program prints. Raises AssertionError with its messages if it fails."""
    result = subprocess.run([str(word) for word in command], cwd=cwd, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    if result.returncode != 0:
        raise AssertionError(f"{command}: status {result.returncode}\n{result.stdout}{result.stderr}")
    return result.stdout


def make_tree(folder):
    """Returns the folder of the unpacked tarball, which is not the folder that it was installed to."""
    run(ARGS.cpack, "--config", pathlib.Path(ARGS.build) / "CPackConfig.cmake", "-B", folder / "made")
    (tarball,) = (folder / "made").glob("taxel-studio-*.tar.gz")
    with tarfile.open(tarball) as archive:
        archive.extractall(folder / "unpacked")
    shutil.rmtree(folder / "made")
    (tree,) = (folder / "unpacked").iterdir()
    return tree


class TarballTest(unittest.TestCase):
    tree = pathlib.Path()
    folder = pathlib.Path()

    def test_programs_run_from_the_unpacked_folder(self):
        for program in PROGRAMS:
            self.assertRegex(run(self.tree / "bin" / program, "--version", cwd="/"), r"MuJoCo \d")
        libraries = run("ldd", self.tree / "bin" / "taxel")
        self.assertIn(str(self.tree), re.search(r"libmujoco\S* => (\S+)", libraries).group(1).replace("/bin/..", ""))

    def test_no_file_points_into_the_build_the_sources_or_the_cache(self):
        forbidden = [str(pathlib.Path(path).resolve()).encode() for path in (ARGS.build, ARGS.source, ARGS.cache)]
        files = [file for file in self.tree.rglob("*") if file.is_file()]
        self.assertGreater(len(files), 30)
        for file in files:
            self.assertFalse(file.is_symlink(), file)
            for path in forbidden:
                self.assertFalse(path in file.read_bytes(), f"{file} has the path {path.decode()}")

    def test_cmake_finds_the_package_and_programs_in_c_and_cpp_read_the_sensor(self):
        for name in ("c", "cpp"):
            example, build = pathlib.Path(ARGS.source) / "examples" / name, self.folder / name
            run(ARGS.cmake, "-S", example, "-B", build, f"-Dtaxel_ROOT={self.tree}", f"-DMUJOCO={ARGS.mujoco}")
            run(ARGS.cmake, "--build", build)
        name, reading, unit = re.fullmatch(r"(.*): (\S+) (\S+)\n", run(self.folder / "c" / "press", cwd="/")).groups()
        self.assertEqual((name, unit), ("fingertip taxels", "Pa"))
        forces = dict(line.split(" m: ") for line in run(self.folder / "cpp" / "presses", cwd="/").splitlines())
        # `taxel run` computes the same 200 steps without the plugin library.
        scene, out = self.tree / "share/taxel/scenes/press.xml", self.folder / "run"
        run(self.tree / "bin" / "taxel", "run", scene, "--seconds", "0.2", "--out", out)
        with open(out / "readings.csv", encoding="utf-8") as table:
            last = {column: float(value) for column, value in list(csv.DictReader(table))[-1].items()}
        largest = max(value for column, value in last.items() if column.startswith("taxel_"))
        self.assertGreater(largest, 1000)
        self.assertAlmostEqual(float(reading), largest, delta=1e-9 * largest)
        force = math.hypot(*(last[f"force_{axis}"] for axis in "xyz"))
        self.assertAlmostEqual(float(forces["0"].split()[0]), force, delta=1e-5 * force)
        self.assertEqual(len(forces), 4)

    def test_has_a_plugin_for_each_version_that_loads_no_mujoco_of_its_own(self):
        libraries = {file.parent.name: file for file in self.tree.rglob("libtaxel_plugin.so")}
        self.assertEqual(sorted(libraries), sorted(f"mujoco-{version}" for version in ARGS.versions))
        for file in libraries.values():
            entries = run("readelf", "-d", file)
            self.assertNotIn("libmujoco", entries)
            self.assertNotIn("PATH", entries)

    def test_cmake_finds_the_plugin_of_each_version(self):
        project = self.folder / "all"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.24)\nproject(p C)\nfind_package(taxel 0.1 REQUIRED)\n"
            "foreach(version IN LISTS taxel_PLUGIN_VERSIONS)\n"
            "  get_target_property(file taxel::plugin_${version} IMPORTED_LOCATION)\n"
            '  message(STATUS "plugin ${version} ${file}")\nendforeach()\n')
        found = run(ARGS.cmake, "-S", project, "-B", project / "b", f"-Dtaxel_ROOT={self.tree}")
        files = dict(re.findall(r"-- plugin (\S+) (\S+)", found))
        self.assertEqual(files, {version: str(self.tree / f"lib/taxel/mujoco-{version}/libtaxel_plugin.so")
                                 for version in ARGS.versions})

    def test_cmake_refuses_another_version_of_the_package(self):
        project = self.folder / "old"
        project.mkdir()
        (project / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.24)\nproject(p NONE)\nfind_package(taxel 0.99 REQUIRED)\n")
        with self.assertRaisesRegex(AssertionError, "0.99"):
            run(ARGS.cmake, "-S", project, "-B", project / "b", f"-Dtaxel_ROOT={self.tree}")


class ShellTest(unittest.TestCase):
    tree = pathlib.Path()
    folder = pathlib.Path()

    def complete(self, *words):
        """Returns the words with which bash completes the last one."""
        program = words[0]
        script = self.tree / "share/bash-completion/completions" / program
        text = f'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _{program}; echo "${{COMPREPLY[*]}}"'
        return run("bash", "-c", text, script, *words).split()

    def test_bash_completes_commands_options_and_words(self):
        self.assertEqual(self.complete("taxel", "sw"), ["sweep"])
        self.assertIn("presets", self.complete("taxel", ""))
        self.assertEqual(self.complete("taxel", "sweep", "--de"), ["--depth", "--density"])
        self.assertEqual(self.complete("taxel", "sweep", "--out", ""), [])  # bash offers files
        self.assertEqual(self.complete("taxel", "--completion", ""), ["bash", "fish", "zsh"])
        self.assertEqual(self.complete("taxelstudio", "--head"), ["--headless"])
        self.assertEqual(self.complete("taxelstudio", "my"), [])

    def test_pages_and_scripts_name_every_command_and_option(self):
        commands = re.findall(r"^  (\w+)  ", run(self.tree / "bin" / "taxel", "--help").split("Subcommands:")[1], re.MULTILINE)
        self.assertGreater(len(commands), 10)
        helps = {"taxel": [run(self.tree / "bin" / "taxel", *words, "--help") for words in [[], *([c] for c in commands)]],
                 "taxelstudio": [run(self.tree / "bin" / "taxelstudio", "--help")]}
        for program, texts in helps.items():
            options = set(re.findall(r"^  (?:-\w,)?--([\w-]+)", "\n".join(texts), re.MULTILINE))
            self.assertGreater(len(options), 15)
            page = (self.tree / "share/man/man1" / f"{program}.1").read_text().replace("\\-", "-")
            for word in [*(["--" + option for option in options]), *(f".SS taxel {c}" for c in commands if program == "taxel")]:
                self.assertIn(word, page)
            bash, fish, zsh = ((self.tree / "share" / file).read_text() for file in (
                f"bash-completion/completions/{program}", f"fish/vendor_completions.d/{program}.fish", f"zsh/site-functions/_{program}"))
            for option in options:
                self.assertIn(f"--{option}", bash)
                self.assertIn(f" -l {option} ", fish)
                self.assertIn(f"*--{option}[", zsh)

    def test_pages_have_no_error_of_troff(self):
        if shutil.which("groff") is None:
            self.skipTest("groff is not installed")
        for program in PROGRAMS:
            page = self.tree / "share/man/man1" / f"{program}.1"
            result = subprocess.run(["groff", "-man", "-Tascii", "-ww", "-z", str(page)], capture_output=True, text=True)
            self.assertEqual((result.returncode, result.stderr), (0, ""))


class DesktopTest(unittest.TestCase):
    tree = pathlib.Path()
    folder = pathlib.Path()

    def test_entry_names_an_installed_program_icon_and_known_types(self):
        entry = configparser.ConfigParser(interpolation=None)
        entry.optionxform = str
        entry.read(self.tree / "share/applications/taxelstudio.desktop")
        values = entry["Desktop Entry"]
        self.assertTrue((self.tree / "bin" / values["Exec"].split()[0]).exists())
        icon = self.tree / f"share/icons/hicolor/scalable/apps/{values['Icon']}.svg"
        self.assertTrue(xml.parse(icon).getroot().tag.endswith("svg"))
        space = "{http://www.freedesktop.org/standards/shared-mime-info}"
        types = xml.parse(self.tree / "share/mime/packages/taxelstudio.xml").getroot().findall(f"{space}mime-type")
        listed = values["MimeType"].strip(";").split(";")
        endings = {t.find(f"{space}glob").get("pattern") for t in types}
        self.assertEqual(endings, {"*.taxelproj", "*.taxels.json", "*.taxelframe"})
        for mime_type in types:
            self.assertIn(mime_type.get("type"), listed)


def main():
    parser = argparse.ArgumentParser()
    for name in ("cmake", "cpack", "build", "source", "cache", "mujoco"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--versions", nargs="+", required=True)
    parser.parse_args(namespace=ARGS)
    with tempfile.TemporaryDirectory(prefix="taxel-install") as name:
        folder = pathlib.Path(name)
        tree = make_tree(folder)
        for test in (TarballTest, ShellTest, DesktopTest):
            test.tree, test.folder = tree, folder
        result = unittest.main(argv=sys.argv[:1], exit=False, verbosity=2).result
    sys.exit(0 if result.wasSuccessful() else 1)


if __name__ == "__main__":
    main()
