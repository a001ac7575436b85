"""Tests that a vector environment gives the bytes of single ones, with any number of threads."""
import unittest

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode, SyncVectorEnv

import taxel.gym

IDS = ("taxel/Press-v0", "taxel/Slide-v0")


def flat(infos, prefix=""):
    """Returns the arrays of nested infos by their paths."""
    found = {}
    for name, value in infos.items():
        if isinstance(value, dict):
            found.update(flat(value, f"{prefix}{name}/"))
        else:
            found[prefix + name] = value
    return found


class VectorTest(unittest.TestCase):
    def assert_same(self, one, two):
        for a, b in zip(one[:-1], two[:-1]):
            self.assertEqual(a.dtype, b.dtype)
            self.assertEqual(a.tobytes(), b.tobytes())
        first, second = flat(one[-1]), flat(two[-1])
        self.assertEqual(first.keys(), second.keys())
        for name, value in first.items():
            if value.dtype == object:
                self.assertEqual([np.asarray(x).tolist() for x in value], [np.asarray(x).tolist() for x in second[name]], name)
            else:
                self.assertEqual(value.dtype, second[name].dtype, name)
                self.assertEqual(value.tobytes(), second[name].tobytes(), name)

    def compare(self, name, count, threads, mode, steps):
        single = SyncVectorEnv([lambda: gymnasium.make(name)] * count, autoreset_mode=mode)
        vector = gymnasium.make_vec(name, num_envs=count, threads=threads, autoreset_mode=mode)
        self.assertIsInstance(vector, taxel.gym.FingertipVectorEnv)
        self.assertEqual(vector.observation_space, single.observation_space)
        self.assertEqual(vector.action_space, single.action_space)
        self.assert_same(single.reset(seed=7), vector.reset(seed=7))
        rng = np.random.default_rng(1)
        ends = 0
        for _ in range(steps):
            actions = rng.uniform(-1, 1, size=(count, 3)).astype(np.float32)
            actions[0] = 0, 0, -1  # ends its episodes
            one = single.step(actions)
            self.assert_same(one, vector.step(actions))
            ends += int((one[2] | one[3]).sum())
        self.assertGreater(ends, 2)
        vector.close()
        single.close()

    def test_vector_gives_the_bytes_of_single_environments(self):
        for name in IDS:
            for threads in (1, 2, 5):
                self.compare(name, 5, threads, AutoresetMode.NEXT_STEP, 160)

    def test_same_step_mode_gives_the_last_observations(self):
        self.compare(IDS[0], 3, 2, AutoresetMode.SAME_STEP, 160)
        self.compare(IDS[1], 3, 2, AutoresetMode.SAME_STEP, 210)

    def test_disabled_mode_resets_by_mask_only(self):
        vector = gymnasium.make_vec(IDS[0], num_envs=3, autoreset_mode="Disabled")
        single = SyncVectorEnv([lambda: gymnasium.make(IDS[0])] * 3, autoreset_mode="Disabled")
        self.assert_same(single.reset(seed=1), vector.reset(seed=1))
        actions = np.zeros((3, 3), dtype=np.float32)
        actions[1, 2] = -1
        ended = np.zeros(3, dtype=bool)
        while not ended.any():
            result = single.step(actions)
            self.assert_same(result, vector.step(actions))
            ended = result[2]
        self.assertEqual(ended.tolist(), [False, True, False])
        with self.assertRaisesRegex(gymnasium.error.ResetNeeded, r"episodes of \[1\] have ended"):
            vector.step(actions)
        mask = {"reset_mask": ended}
        one, two = single.reset(seed=[4, 5, 6], options=dict(mask)), vector.reset(seed=[4, 5, 6], options=dict(mask))
        self.assert_same(one, two)
        self.assert_same(single.step(actions), vector.step(actions))

    def test_a_seed_gives_the_same_bytes_in_every_row(self):
        vector = gymnasium.make_vec(IDS[1], num_envs=4)
        observations, infos = vector.reset(seed=[3, 8, 3, 8])
        self.assertEqual(observations[0].tobytes(), observations[2].tobytes())
        self.assertNotEqual(observations[0].tobytes(), observations[1].tobytes())
        self.assertEqual(infos["object"][1], infos["object"][3])
        self.assertEqual(infos["readings"].shape, (4, 12))
        self.assertEqual(infos["force"].shape, (4, 3))


if __name__ == "__main__":
    unittest.main()
