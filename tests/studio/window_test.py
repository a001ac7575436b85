"""Tests `python -m taxel.studio`: its errors, and its window under Xvfb."""
import contextlib
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import zlib
from unittest import mock

import numpy as np

import taxel
from taxel.studio import requirements

SCENES = taxel.EXAMPLES / "scenes"
WIDTH, HEIGHT = 1280, 860


def command(*arguments, display=None):
    environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    if display:
        environment["DISPLAY"] = display
    words = [sys.executable, "-m", "taxel.studio", *map(str, arguments)]
    return subprocess.Popen(words, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def run(*arguments):
    process = command(*arguments)
    output, _ = process.communicate(timeout=60)
    return process.returncode, output


class ErrorTest(unittest.TestCase):
    def test_mistakes_end_with_one_line_and_status_1(self):
        cases = [(["absent.xml", "--gfx", "web"], "absent.xml: not found"),
                 ([SCENES / "press.xml", "--gfx", "crayon"], 'opengl_headless.*is "crayon"'),
                 ([SCENES / "press.xml", "--gfx", "opengl"], "MuJoCo 4.0.0.*use opengl_headless"),
                 ([SCENES / "press.xml"], "DISPLAY is not set.*--gfx web")]
        for arguments, words in cases:
            with self.subTest(words=words):
                status, output = run(*arguments)
                self.assertEqual((status, output.count("\n")), (1, 1), output)
                self.assertRegex(output, "^taxel.studio: .*" + words)

    def test_mujoco_without_studio_is_an_error_with_the_version_that_has_it(self):
        with mock.patch("importlib.util.find_spec", lambda _: None):
            with self.assertRaisesRegex(taxel.Error, "has no Studio.*pip install mujoco==4.0.0"):
                requirements.require_studio()
        with mock.patch("importlib.import_module", side_effect=ImportError("Version mismatch")):
            with self.assertRaisesRegex(taxel.Error, "Version mismatch.*pip install mujoco==4.0.0"):
                requirements.require_studio()


@contextlib.contextmanager
def screen():
    """Yields the display of a virtual screen and the file with its pixels."""
    with tempfile.TemporaryDirectory() as folder:
        reading, writing = os.pipe()
        words = ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", folder, "-nolisten", "tcp"]
        server = subprocess.Popen(words, pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        try:
            with os.fdopen(reading) as numbers:
                yield f":{int(numbers.readline())}", pathlib.Path(folder) / "Xvfb_screen0"
        finally:
            server.terminate()
            server.wait()


def pixels(file):
    """Returns the pixels of a file in the format XWD, shape (height, width, 3)."""
    data = file.read_bytes()
    head = struct.unpack(">25I", data[:100])
    size, width, height, line, colors = head[0], head[4], head[5], head[12], head[19]
    rows = np.frombuffer(data, np.uint8, line * height, size + 12 * colors).reshape(height, line)
    return rows[:, : 4 * width].reshape(height, width, 4)[:, :, 2::-1]


def write_png(file, image):
    height, width, _ = image.shape
    lines = np.concatenate([np.zeros((height, 1), np.uint8), image.reshape(height, -1)], axis=1).tobytes()

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    parts = [chunk(b"IHDR", header), chunk(b"IDAT", zlib.compress(lines)), chunk(b"IEND", b"")]
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))


def has_panel(image):
    """Returns whether both plots of the window "Taxels" are in the lower part of the view: bars and curves in blue."""
    view = image[HEIGHT * 2 // 3 :, WIDTH // 5 : WIDTH * 4 // 5].astype(int)
    near = np.abs(view - [76, 114, 176]).max(axis=2) < 12  # the first colour of ImPlot
    white = np.abs(view - 245).max(axis=2) < 10
    return int(near.sum()) > 100 and int(white.sum()) > 20000


@unittest.skipUnless(shutil.which("Xvfb"), "Xvfb is not installed")
class WindowTest(unittest.TestCase):
    def show(self, scene, seconds=4):
        """Shows a scene until the panel is on the screen and for some seconds more, and returns the image."""
        with screen() as (display, file):
            process = command(scene, "--width", WIDTH, "--height", HEIGHT, display=display)
            try:
                end = time.monotonic() + 120
                while process.poll() is None and time.monotonic() < end and not has_panel(pixels(file)):
                    time.sleep(0.5)
                time.sleep(seconds)
                image = pixels(file)
            finally:
                process.send_signal(signal.SIGINT)
                output, _ = process.communicate(timeout=60)
        write_png(pathlib.Path(os.environ["TAXEL_IMAGES"]) / f"{pathlib.Path(scene).stem}.png", image)
        self.assertEqual(process.returncode, 0, output)
        self.assertIn("Shutting down", output)
        self.assertTrue(has_panel(image), "the window has no plots")
        return image

    def test_press_shows_bars_and_the_force(self):
        image = self.show(SCENES / "press.xml")
        view = image[80 : HEIGHT * 2 // 3, WIDTH // 4 : WIDTH * 3 // 4].astype(int)
        orange = (view[:, :, 0] > 150) & (view[:, :, 0] - view[:, :, 2] > 80)
        self.assertGreater(int(orange.sum()), 100)  # the bars of the pressed taxels, and the arrow of the force

        panel = image[HEIGHT * 2 // 3 :, WIDTH // 4 : WIDTH * 3 // 4].astype(int)
        red = np.abs(panel - [217, 64, 38]).max(axis=2) < 40
        self.assertGreater(int(red.sum()), 30)  # the middle of the contact surface

    def test_hand_stays_on_the_screen(self):
        self.show(SCENES / "hand_grasps_ball.xml")


if __name__ == "__main__":
    unittest.main()
