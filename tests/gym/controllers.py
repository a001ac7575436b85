"""Controllers by hand that solve the tasks from `info`, and a random one."""
import numpy as np

GAIN = 3.0  # fraction of the largest speed for an error of 1 N


def press(info, rng):
    """Moves down or up in proportion to the error of the force."""
    error = info["commanded_force"] - info["normal_force"]
    return np.array([0, 0, -np.clip(GAIN * error, -1, 1)], dtype=np.float32)


def slide(info, rng):
    """Holds the middle of the bounds, and moves along the direction while the force is within them."""
    smallest, largest = info["bounds"]
    force, direction = info["normal_force"], info["direction"]
    speed = 0.6 if smallest < force < largest else 0.0
    left = np.array([-direction[1], direction[0]])
    across = speed * direction - 150 * info["deviation"] * left
    down = np.clip(GAIN * ((smallest + largest) / 2 - force), -1, 1)
    return np.array([*across, -down], dtype=np.float32)


def by_chance(info, rng):
    """Returns any action."""
    return rng.uniform(-1, 1, size=3).astype(np.float32)


CONTROLLERS = {"taxel/Press-v0": press, "taxel/Slide-v0": slide}


def play(env, controller, seed, options=None):
    """Plays one episode. Returns the steps as (observation, reward, terminated, truncated, info), that of reset first."""
    rng = np.random.default_rng(seed)
    observation, info = env.reset(seed=seed, options=options)
    steps = [(observation, 0.0, False, False, info)]
    while not (steps[-1][2] or steps[-1][3]):
        steps.append(env.step(controller(steps[-1][4], rng)))
    return steps


def score(steps):
    """Returns the sum of the rewards."""
    return sum(step[1] for step in steps)
