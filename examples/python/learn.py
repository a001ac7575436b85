"""Learns to press with a commanded force: searches the gain of a controller in 16 environments at a time.

Needs this package, which is not on PyPI: in a clone, after scripts/setup, pip install ".[gym]"
"""
import gymnasium
import numpy as np

import taxel.gym

COUNT = 16
envs = gymnasium.make_vec("taxel/Press-v0", num_envs=COUNT)
names = [entry["name"] for entry in envs.metadata["observation"]]
force, commanded = names.index("force z"), names.index("commanded force")


def mean_reward(gains, seed):
    """Plays an episode in each environment, with the gain of each, and returns the mean reward of an episode for each."""
    observations, _ = envs.reset(seed=[seed] * COUNT)  # the same object and commands for all gains
    total, running = np.zeros(COUNT), np.ones(COUNT, dtype=bool)
    while running.any():
        down = gains * (observations[:, commanded] - observations[:, force])
        actions = np.stack([np.zeros(COUNT), np.zeros(COUNT), -np.clip(down, -1, 1)], axis=1)
        observations, rewards, terminated, truncated, _ = envs.step(actions)
        total += rewards * running
        running &= ~(terminated | truncated)
    return total


gains = np.linspace(0, 45, COUNT)
rewards = np.mean([mean_reward(gains, seed) for seed in range(2)], axis=0)
best = int(rewards.argmax())
print(f"gain {gains[best]:.2f}: mean reward {rewards[best]:.1f}")
print(f"gain {gains[0]:.2f}: mean reward {rewards[0]:.1f}")
envs.close()
