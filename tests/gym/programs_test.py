"""Tests whole programs: the example, registration by name, and images."""
import os
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).parents[2]
BY_NAME = """
import gymnasium
env = gymnasium.make("taxel.gym:taxel/Press-v0")
env.reset(seed=0)
print(env.spec.id)
"""
DRAW = """
import gymnasium, numpy as np
import taxel.gym
try:
    env = gymnasium.make("taxel/Press-v0", render_mode="rgb_array", objects="grip")
    env.reset(seed=0)
    first = env.render()
except taxel.Error as error:
    print("no image:", error)
    raise SystemExit
again = env.render()
for _ in range(10):
    env.step(np.array([0, 0, 1], dtype=np.float32))
last = env.render()
vector = gymnasium.make_vec("taxel/Press-v0", num_envs=2, render_mode="rgb_array", objects="grip")
vector.reset(seed=0)
images = vector.render()
print(first.shape, first.dtype, first.std() > 10, (first == again).all(), (first == last).all(),
      (images[0] == first).all(), (images[1] == first).all())
env.close()
vector.close()
"""


def run(code, **variables):
    """Runs code in a new process, and returns its output."""
    result = subprocess.run([sys.executable, "-S", "-c", code], env={**os.environ, **variables}, capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout


class ProgramsTest(unittest.TestCase):
    def test_name_with_the_module_needs_no_import(self):
        self.assertEqual(run(BY_NAME), "taxel/Press-v0\n")

    def test_images_show_the_simulation(self):
        printed = run(DRAW, MUJOCO_GL="egl", PYOPENGL_PLATFORM="egl").strip()
        if printed.startswith("no image"):
            self.skipTest(f"this machine cannot draw by EGL: {printed}")
        self.assertEqual(printed, "(480, 480, 3) uint8 True True False True False")

    def test_absence_of_opengl_is_an_error_with_a_remedy(self):
        printed = run(DRAW, MUJOCO_GL="disable")
        self.assertRegex(printed, r"^no image: render_mode: MuJoCo cannot draw: .*MUJOCO_GL=egl")

    def test_example_follows_the_force_on_all_objects(self):
        lines = run((ROOT / "examples/python/learn.py").read_text()).splitlines()
        rewards = [float(line.split()[-1]) for line in lines[-2:]]
        self.assertGreater(rewards[0], 50)
        self.assertLess(rewards[1], 20)


if __name__ == "__main__":
    unittest.main()
