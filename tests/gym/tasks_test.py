"""Tests single environments: spaces, episodes, rewards and their meaning."""
import time
import unittest
import warnings

import controllers
import gymnasium
import numpy as np
from gymnasium.utils.env_checker import check_env

import taxel.gym
from taxel.gym.objects import KINDS, SHAPES

IDS = ("taxel/Press-v0", "taxel/Slide-v0")


class SpacesTest(unittest.TestCase):
    def test_the_checker_of_gymnasium_accepts_both_without_a_warning(self):
        for name in IDS:
            with warnings.catch_warnings():
                warnings.simplefilter("error")
                check_env(gymnasium.make(name).unwrapped, skip_render_check=True)

    def test_times_are_printed(self):
        for name in IDS:
            start = time.perf_counter()
            gymnasium.make(name, density=2.1e6 if name == IDS[0] else 2.2e6)  # its own density, so that nothing is compiled yet
            first = time.perf_counter()
            gymnasium.make_vec(name, num_envs=64)
            second = time.perf_counter()
            print(f"{name}: made in {first - start:.3f} s, a vector environment of 64 in {second - first:.3f} s")
            self.assertLess(second - start, 60)

    def test_metadata_names_each_number_with_unit_and_scale(self):
        for name in IDS:
            env = gymnasium.make(name)
            entries = env.metadata["observation"]
            self.assertEqual(env.observation_space.metadata, entries)
            self.assertEqual(env.observation_space.shape, (len(entries),))
            self.assertEqual(env.observation_space.dtype, np.float32)
            self.assertEqual(len({entry["name"] for entry in entries}), len(entries))
            self.assertEqual([entry["unit"] for entry in env.metadata["action"]], ["m/s"] * 3)

    def test_observations_are_quantities_divided_by_their_scales(self):
        env = gymnasium.make(IDS[0], objects="sphere")
        observation, _, _, _, info = controllers.play(env, controllers.press, 1)[-1]
        entries = env.metadata["observation"]
        value = {entry["name"]: float(x) * entry["scale"] for entry, x in zip(entries, observation)}
        largest = int(info["readings"].argmax())
        self.assertGreater(info["readings"][largest], 1000)
        self.assertEqual(entries[largest]["unit"], "Pa")
        np.testing.assert_allclose(observation[:12] * entries[0]["scale"], info["readings"], rtol=1e-6, atol=1e-3)
        for name, expected in (("force z", info["force"][2]), ("contact area", info["area"]),
                               ("position z", info["position"][2]), ("commanded force", info["commanded_force"])):
            self.assertAlmostEqual(value[name] / expected, 1, places=5, msg=name)
        np.testing.assert_array_equal(info["taxels"], np.arange(12))


class EpisodesTest(unittest.TestCase):
    def test_same_seed_gives_the_same_bytes(self):
        for name in IDS:
            first, second = gymnasium.make(name), gymnasium.make(name)
            controllers.play(second, controllers.by_chance, 99)  # an earlier episode leaves nothing behind
            one = controllers.play(first, controllers.CONTROLLERS[name], 5)
            two = controllers.play(second, controllers.CONTROLLERS[name], 5)
            self.assertEqual(len(one), len(two))
            for a, b in zip(one, two):
                self.assertEqual(a[0].tobytes(), b[0].tobytes())
                self.assertEqual(a[1:4], b[1:4])
                self.assertEqual({k: np.asarray(v).tolist() for k, v in a[4].items()},
                                 {k: np.asarray(v).tolist() for k, v in b[4].items()})

    def test_objects_and_goals_change_with_the_seed(self):
        for name, goal in zip(IDS, ("commanded_force", "distance")):
            env = gymnasium.make(name)
            infos = [env.reset(seed=seed)[1] for seed in range(100)]
            self.assertEqual({info["object"] for info in infos}, {shape.name for shape in SHAPES})
            self.assertEqual(len({info[goal] for info in infos}), 100)
            self.assertTrue(all(info["area"] == 0 for info in infos), "an episode begins without contact")

    def test_option_chooses_an_object_and_each_one_is_felt(self):
        env = gymnasium.make(IDS[0])
        felt = []
        for shape in SHAPES:
            info = controllers.play(env, controllers.press, 4, {"object": shape.name, "force": 0.7})[-1][4]
            self.assertEqual(info["object"], shape.name)
            self.assertAlmostEqual(info["normal_force"], 0.7, delta=0.02)
            felt.append(info["readings"])
        for i, one in enumerate(felt):
            for two in felt[:i]:
                self.assertGreater(np.abs(one - two).max(), 100)  # [Pa]
        for kind in KINDS:
            self.assertIn(kind, gymnasium.make(IDS[1], objects=[kind]).reset(seed=0)[1]["object"])

    def test_press_follows_the_levels_of_the_option(self):
        env = gymnasium.make(IDS[0])
        steps = controllers.play(env, controllers.press, 2, {"force": [0.3, 0.9, 0.5]})
        self.assertEqual(len(steps), 151)
        self.assertEqual([steps[k][4]["commanded_force"] for k in (0, 49, 50, 99, 100, 150)], [0.3, 0.3, 0.9, 0.9, 0.5, 0.5])
        for k in (49, 99, 150):
            self.assertAlmostEqual(steps[k][4]["normal_force"], steps[k - 1][4]["commanded_force"], delta=0.02)

    def test_too_much_force_ends_an_episode_as_a_failure(self):
        for name in IDS:
            env = gymnasium.make(name)
            last = controllers.play(env, lambda info, rng: np.array([0, 0, -1], dtype=np.float32), 0)[-1]
            self.assertGreater(last[4]["normal_force"], 2)
            self.assertEqual(last[1:4], (-10.0, True, False))

    def test_an_idle_episode_is_truncated_without_a_reward(self):
        for name, steps in zip(IDS, (150, 200)):
            idle = controllers.play(gymnasium.make(name), lambda info, rng: np.zeros(3, dtype=np.float32), 0)
            self.assertEqual(len(idle) - 1, steps)
            self.assertEqual(idle[-1][2:4], (False, True))
            self.assertLessEqual(controllers.score(idle), 0)


class RewardsTest(unittest.TestCase):
    def test_press_has_the_reward_of_its_formula(self):
        env = gymnasium.make(IDS[0])
        steps = controllers.play(env, controllers.by_chance, 8, {"force": 0.2}) + controllers.play(env, controllers.press, 8)
        above = 0
        for before, after in zip(steps, steps[1:]):
            if after[1] in (0.0, -10.0):
                continue
            force, command = after[4]["normal_force"], before[4]["commanded_force"]
            e = (force - command) / command
            above += e > 0.1
            self.assertAlmostEqual(after[1], 1 - min(abs(e), 1) - 2 * min(max(e - 0.1, 0), 1), places=12)
        self.assertGreater(above, 0)

    def test_slide_has_the_reward_of_its_formula_and_counts_a_way_once(self):
        env = gymnasium.make(IDS[1])

        def there_and_back(info, rng):
            action = controllers.slide(info, rng)
            there_and_back.count += 1
            return action * np.float32([-1, -1, 1]) if there_and_back.count % 50 > 35 else action

        there_and_back.count = 0
        steps = controllers.play(env, there_and_back, 3)
        farthest, gained = 0.0, 0.0
        for _, reward, _, _, info in steps[1:]:
            (a, b), force, way = info["bounds"], info["normal_force"], min(info["along"], info["distance"])
            gain = 10 * max(way - farthest, 0) / info["distance"] if a <= force <= b else 0
            outside = max(a - force, 0) / a + max(force - b, 0) / b
            penalty = 0.02 * min(outside, 1) + 0.02 * min(abs(info["deviation"]) / 0.005, 1)
            self.assertAlmostEqual(reward, gain - penalty, places=12)
            farthest, gained = max(farthest, way), gained + gain
        self.assertTrue(steps[-1][2])
        self.assertGreaterEqual(steps[-1][4]["along"], steps[-1][4]["distance"])
        self.assertLess(gained, 10.000001)

    def test_proportional_controller_is_far_better_than_chance(self):
        for name, least in zip(IDS, (100, 8)):
            env = gymnasium.make(name)
            good = [controllers.score(controllers.play(env, controllers.CONTROLLERS[name], seed)) for seed in range(20)]
            chance = [controllers.score(controllers.play(env, controllers.by_chance, seed)) for seed in range(20)]
            print(f"{name}: controller {np.mean(good):.1f} (worst {min(good):.1f}), chance {np.mean(chance):.1f} "
                  f"(best {max(chance):.1f})")
            self.assertGreater(min(good), least)
            self.assertGreater(min(good), max(chance))


if __name__ == "__main__":
    unittest.main()
