"""Gymnasium environments: a fingertip with tactile sensors that presses and slides on changing objects, and a hand that
grasps.

    import gymnasium
    import taxel.gym                                 # registers taxel/Press-v0 and taxel/Slide-v0
    env = gymnasium.make("taxel/Press-v0")
    envs = gymnasium.make_vec("taxel/Slide-v0", num_envs=64)      # stepped by threads, the bytes of 64 single ones

`taxel.gym.Press`, `taxel.gym.Slide` and `taxel.gym.Grasp` say what actions, observations and rewards are. Needs the packages
gymnasium and mujoco.
"""

from __future__ import annotations

try:
    import gymnasium
except ModuleNotFoundError as error:
    if error.name != "gymnasium":
        raise
    raise ModuleNotFoundError('taxel.gym needs the package gymnasium: pip install gymnasium',
                              name="gymnasium") from error

from taxel.gym.env import FingertipEnv, Press, Slide
from taxel.gym.grasp import Grasp
from taxel.gym.vector import FingertipVectorEnv, PressVector, SlideVector

__all__ = ["FingertipEnv", "FingertipVectorEnv", "Grasp", "Press", "PressVector", "Slide", "SlideVector"]

for _name in ("Press", "Slide"):
    gymnasium.register(f"taxel/{_name}-v0", entry_point=f"taxel.gym:{_name}", vector_entry_point=f"taxel.gym:{_name}Vector")
gymnasium.register("taxel/Grasp-v0", entry_point="taxel.gym:Grasp")
