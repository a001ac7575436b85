"""Tests the hand that grasps: spaces, episodes, the end of a grasp, and bad input."""
import unittest
import warnings

import gymnasium
import numpy as np
from gymnasium.utils.env_checker import check_env

import taxel.gym
from taxel.gym.grasp import DURATION, FAILURE_REWARD, FINGERS

NAME = "taxel/Grasp-v0"


def play(env, action, steps=DURATION, **reset):
    """Plays up to `steps` steps of one action. Returns the steps as (observation, reward, terminated, truncated, info)."""
    env.reset(**reset)
    played = []
    while len(played) < steps and not (played and (played[-1][2] or played[-1][3])):
        played.append(env.step(np.full(len(FINGERS), action, dtype=np.float32)))
    return played


class GraspTest(unittest.TestCase):
    def test_the_checker_of_gymnasium_accepts_it_without_a_warning(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            check_env(gymnasium.make(NAME).unwrapped, skip_render_check=True)

    def test_observation_has_all_readings_and_angles_with_their_scales(self):
        env = gymnasium.make(NAME)
        observation, _, _, _, info = play(env, 0.2, steps=20, seed=1)[-1]
        entries = env.metadata["observation"]
        self.assertEqual(observation.shape, (len(entries),))
        self.assertEqual(len({entry["name"] for entry in entries}), len(entries))
        readings = np.concatenate([info["readings"][finger] for finger in FINGERS])
        self.assertEqual(readings.shape, (60,))
        self.assertGreater(sum(values.max() > 1000 for values in info["readings"].values()), 3, "most fingers touch the ball")
        scales = np.array([entry["scale"] for entry in entries[:60]])
        np.testing.assert_allclose(observation[:60], np.clip(readings / scales, 0, 1), atol=1e-6)
        self.assertEqual(sum(entry["name"].startswith("angle") for entry in entries), 20)

    def test_same_seed_gives_the_same_bytes(self):
        first, second = gymnasium.make(NAME), gymnasium.make(NAME)
        play(second, 0.5, steps=15, seed=9)  # an earlier episode leaves nothing behind
        one, two = play(first, 0.1, steps=15, seed=4), play(second, 0.1, steps=15, seed=4)
        for a, b in zip(one, two):
            self.assertEqual(a[0].tobytes(), b[0].tobytes())
            self.assertEqual(a[4]["ball"].tobytes(), b[4]["ball"].tobytes())

    def test_firmer_hand_holds_a_pull_longer_and_an_open_hand_nothing(self):
        env = gymnasium.make(NAME)
        options = {"shift": [0, 0], "pull": 1.6}
        opened, scripted, firmer = (play(env, action, seed=0, options=options) for action in (-1, 0, 0.25))
        self.assertEqual([len(opened), opened[-1][2], sum(step[1] for step in opened)], [24, True, 0])
        self.assertTrue(scripted[-1][2] and scripted[-1][1] == 0, "the pull ends the grasp")
        self.assertGreater(len(firmer), len(scripted) + 5)
        self.assertGreater(scripted[-1][4]["pull"], 0.5)

    def test_force_above_the_limit_ends_the_episode(self):
        last = play(gymnasium.make(NAME), 1, seed=0)[-1]
        self.assertEqual((last[1], last[2]), (FAILURE_REWARD, True))

    def test_bad_input_is_named(self):
        env = gymnasium.make(NAME).unwrapped
        with self.assertRaises(gymnasium.error.ResetNeeded):
            env.step(np.zeros(5))
        for options, error, pattern in (({"pull": -1}, ValueError, r"options\['pull'\] must have 1 number from 0 to 10 N/s"),
                                        ({"shift": [0.1, 0]}, ValueError, r"options\['shift'\] must have 2 numbers from -0.01"),
                                        ({"shift": "left"}, TypeError, "must be real numbers"),
                                        ({"object": "ball"}, ValueError, "'object' is unknown; the options are shift, pull")):
            with self.assertRaisesRegex(error, pattern):
                env.reset(seed=0, options=options)
        env.reset(seed=0)
        with self.assertRaisesRegex(ValueError, r"action must have the shape \(5,\)"):
            env.step(np.zeros(3))


if __name__ == "__main__":
    unittest.main()
