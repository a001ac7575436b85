"""Tests that bad input gets a clear error."""
import subprocess
import sys
import unittest

import gymnasium
import numpy as np

import taxel
import taxel.gym

IDS = ("taxel/Press-v0", "taxel/Slide-v0")
BLOCK_GYMNASIUM = "import sys; sys.modules['gymnasium'] = None; import taxel.gym"


class ErrorsTest(unittest.TestCase):
    def assert_error(self, error, pattern, function, *args, **options):
        with self.assertRaisesRegex(error, pattern):
            function(*args, **options)

    def test_bad_actions_are_named(self):
        envs = [gymnasium.make(name).unwrapped for name in IDS]
        vector = gymnasium.make_vec(IDS[0], num_envs=2)
        vector.reset(seed=0)
        for env in envs:
            env.reset(seed=0)
            self.assert_error(ValueError, r"action must have the shape \(3,\), has \(2,\)", env.step, np.zeros(2))
            self.assert_error(ValueError, r"action must have the shape \(3,\), has \(\)", env.step, 0.5)
            self.assert_error(TypeError, "action must have real numbers, has values of the type bool", env.step, np.ones(3, dtype=bool))
            self.assert_error(TypeError, "type complex128", env.step, np.zeros(3, dtype=complex))
            self.assert_error(TypeError, "type <U1", env.step, ["a", "b", "c"])
            for bad in (np.nan, np.inf):
                self.assert_error(ValueError, "action must be finite", env.step, np.array([0, bad, 0]))
        self.assert_error(ValueError, r"action must have the shape \(2, 3\), has \(3,\)", vector.step, np.zeros(3))
        self.assert_error(ValueError, "action must be finite", vector.step, np.full((2, 3), np.nan))

    def test_a_refused_action_changes_nothing(self):
        one, two = gymnasium.make(IDS[0]).unwrapped, gymnasium.make(IDS[0]).unwrapped
        for env in (one, two):
            env.reset(seed=3)
        self.assert_error(ValueError, "finite", one.step, np.array([0, np.nan, 0]))
        down = np.array([0, 0, -1], dtype=np.float32)
        for _ in range(10):
            self.assertEqual(one.step(down)[0].tobytes(), two.step(down)[0].tobytes())

    def test_actions_outside_of_the_space_are_cut_off(self):
        results = []
        for value in (1.0, 5):
            env = gymnasium.make(IDS[0]).unwrapped
            env.reset(seed=3)
            results.append(env.step(np.array([0, 0, -value]))[0].tobytes())
        self.assertEqual(results[0], results[1])

    def test_unknown_objects_and_options_are_named_with_the_known_ones(self):
        message = "'cube' is unknown; the objects are sphere, cylinder, edge, grip, sphere 8 mm"
        env = gymnasium.make(IDS[0]).unwrapped
        self.assert_error(ValueError, "objects: " + message, gymnasium.make, IDS[0], objects=["sphere", "cube"])
        self.assert_error(ValueError, r"options\['object'\]: " + message, env.reset, options={"object": "cube"})
        self.assert_error(ValueError, "objects must name at least one", gymnasium.make, IDS[0], objects=[])
        self.assert_error(TypeError, "objects must be a name or names, is 3", gymnasium.make, IDS[0], objects=3)
        self.assert_error(ValueError, "'forces' is unknown; the options are object, force", env.reset, options={"forces": 1})
        self.assert_error(TypeError, "options must be a dict", env.reset, options=[1])

    def test_bad_goals_are_named_with_their_range(self):
        press, slide = (gymnasium.make(name).unwrapped for name in IDS)
        for env, options, error, pattern in (
            (press, {"force": 5}, ValueError, r"options\['force'\] must be from 0.02 to 1.5 N, is 5"),
            (press, {"force": np.nan}, ValueError, "must be from 0.02 to 1.5 N"),
            (press, {"force": "1 N"}, TypeError, "must be a number, is '1 N'"),
            (press, {"force": []}, ValueError, "must have 1 to 150 levels, has 0"),
            (slide, {"bounds": [1, 0.5]}, ValueError, "smallest and the largest normal force"),
            (slide, {"bounds": 0.5}, ValueError, "smallest and the largest normal force"),
            (slide, {"direction": True}, TypeError, r"options\['direction'\] must be a number"),
            (slide, {"distance": 1.0}, ValueError, "must be from 0.001 to 0.024 m, is 1.0"),
        ):
            self.assert_error(error, pattern, env.reset, options=options)

    def test_steps_outside_of_an_episode_ask_for_reset(self):
        env = gymnasium.make(IDS[0]).unwrapped
        action = np.array([0, 0, -1], dtype=np.float32)
        self.assert_error(gymnasium.error.ResetNeeded, "call reset", env.step, action)
        env.reset(seed=0)
        while not env.step(action)[2]:
            pass
        self.assert_error(gymnasium.error.ResetNeeded, "the episode has ended", env.step, action)
        vector = gymnasium.make_vec(IDS[0], num_envs=2)
        self.assert_error(gymnasium.error.ResetNeeded, "no episode has begun", vector.step, np.zeros((2, 3)))

    def test_bad_arguments_of_the_constructors_are_named(self):
        make, make_vec = gymnasium.make, gymnasium.make_vec
        self.assert_error(ValueError, 'render_mode must be None or "rgb_array"', taxel.gym.Press, render_mode="ascii")
        self.assert_error(ValueError, "threads must be a whole number above 0, is 0", make_vec, IDS[0], num_envs=2, threads=0)
        self.assert_error(ValueError, "num_envs must be a whole number above 0, is 0", make_vec, IDS[0], num_envs=0)
        self.assert_error(ValueError, "not a valid AutoresetMode", make_vec, IDS[0], num_envs=1, autoreset_mode="never")
        self.assert_error(taxel.Error, "/sampling/density", make, IDS[0], density=-1.0)
        vector = make_vec(IDS[0], num_envs=2)
        self.assert_error(ValueError, "seed must be a number or 2 numbers, has 3", vector.reset, seed=[1, 2, 3])
        self.assert_error(ValueError, r"options\['reset_mask'\] must have 2 truth values", vector.reset,
                          options={"reset_mask": np.zeros(2, dtype=bool)})

    def test_layouts_that_cannot_be_used_are_named(self):
        make = gymnasium.make
        self.assert_error(taxel.Error, "absent.taxels.json", make, IDS[0], layout="absent.taxels.json")
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/readout/aggregate", "weighted_sum")
        self.assert_error(taxel.Error, "/readout/aggregate: must give readings in Pa or N", make, IDS[0], layout=layout)
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/mesh/file", "/absent/finger.obj")
        self.assert_error(taxel.Error, "absent/finger.obj", make, IDS[0], layout=layout)

    def test_a_layout_of_ones_own_changes_the_observation(self):
        layout = taxel.Layout.read(taxel.FINGERTIP)
        layout.set_value("/readout/aggregate", "force")
        layout.delete_taxels([11])
        env = gymnasium.make(IDS[0], layout=layout)
        entries = env.metadata["observation"]
        self.assertEqual([entry["unit"] for entry in entries[:12]], ["N"] * 12)
        self.assertEqual(entries[11]["name"], "force x")
        self.assertEqual(env.reset(seed=0)[1]["taxels"].tolist(), list(range(11)))

    def test_absence_of_gymnasium_names_the_package_to_install(self):
        result = subprocess.run([sys.executable, "-S", "-c", BLOCK_GYMNASIUM], capture_output=True, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertIn('taxel.gym needs the package gymnasium: pip install gymnasium', result.stderr)


if __name__ == "__main__":
    unittest.main()
