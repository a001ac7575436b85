"""The task Grasp: a hand with sixty taxels closes around a ball, lifts it, and holds it against a growing pull."""

from __future__ import annotations

import pathlib
import typing

import gymnasium
import numpy as np

import taxel
from taxel import model_plugins
from taxel.gym import rendering
from taxel.gym.channels import Channel, normalise
from taxel.gym.episodes import checked_actions, checked_options
from taxel.gym.spaces import box_of

if typing.TYPE_CHECKING:
    import mujoco

FINGERS = ("index", "middle", "ring", "little", "thumb")
#: Time steps of MuJoCo for one action.
STEPS_PER_ACTION = 25
#: Number of actions after which an episode is truncated.
DURATION = 100
#: Force on one fingertip at which an episode ends as a failure [N].
FORCE_LIMIT = 15.0
#: Reward of a step that exceeds FORCE_LIMIT.
FAILURE_REWARD = -10.0

_SCENE = pathlib.Path("scenes") / "hand_grasps_ball.xml"
_CLOSING = 0.6  # control of the joints of a finger at an action of 1
_OPEN = -0.6  # at the start
_SLEW = 2.0  # largest change of a control in a second
_LIFTED = 24  # actions after which the ball must be in the air, and the pull begins
_SHIFT = 0.004  # largest displacement of the ball from its stand along one axis [m]
_PULL = (0.8, 1.6)  # growth of the pull [N/s]
_JOINT_SCALE = 2.0  # angle that is 1 in an observation [rad]


class Grasp(gymnasium.Env):
    """taxel/Grasp-v0: close a hand around a ball, and hold it as long as possible.

    A hand with twelve taxels on each of five fingertips (the scene hand_grasps_ball.xml) is open around a ball. It
    rises by itself; after 1.2 s the ball must be in the air, and a pull down on the ball begins, which grows by 0.8 to
    1.6 N a second. The ball begins up to 4 mm from the middle along x and y. `metadata["observation"]` lists the
    observation: the readings, the angles of the finger joints, and the closing of each finger.

    The action has a number for each finger, in the order index, middle, ring, little, thumb: the closing to which the
    finger moves, at most 2 in a second. 0 is the closing of the scene, 1 is firmer by 0.6 rad of its springs, and -1 is
    open. One step is 25 time steps, 50 ms.

        reward = 1 while the ball is held, else 0

    The episode ends (terminated) when the ball is on its stand after 1.2 s or has fallen, and with a reward of -10 if the
    force on a fingertip exceeds 15 N; it is truncated after 100 steps. Options: "shift", the place of the ball (x, y) [m],
    and "pull", the growth of the pull [N/s].

    `info` has the readings and forces of the fingertips in SI units by finger, the position of the ball, whether it is
    held, and the pull.
    """

    metadata: dict[str, typing.Any] = {"render_modes": ["rgb_array"], "render_fps": 20}

    def __init__(self, *, render_mode: str | None = None) -> None:
        import mujoco

        self.render_mode = rendering.checked_mode(render_mode)
        self._model = _model()
        self._data = mujoco.MjData(self._model)
        self._sensors = {sensor.geom: sensor for sensor in model_plugins.sensors_of(self._model)}
        self._ball = int(self._model.body("ball").id)
        names = [self._model.actuator(number).name for number in range(self._model.nu)]
        self._closing = [[number for number, name in enumerate(names)
                          if name.split()[0] == finger and name.split()[-1] in ("close", "middle", "tip")]
                         for finger in FINGERS]
        joints = [self._model.joint(number) for number in range(self._model.njnt)]
        joints = [joint for joint in joints if joint.name.split()[0] in FINGERS]
        self._angles = [int(joint.qposadr.item()) for joint in joints]
        self._channels = _channels(self._sensors, [joint.name for joint in joints])
        self.observation_space = box_of(self._channels)
        action = [Channel(f"closing {finger}", "rad", _CLOSING) for finger in FINGERS]
        self.action_space = box_of(action)
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": 20,
                         "observation": [channel.as_dict() for channel in self._channels],
                         "action": [channel.as_dict() for channel in action]}
        self._camera = rendering.Camera(self._model, camera=-1)
        self._setpoint = np.zeros(len(FINGERS))
        self._steps = 0
        self._growth = 0.0
        self._height = 0.0
        self._running = False

    def reset(self, *, seed: int | None = None, options: dict[str, typing.Any] | None = None
              ) -> tuple[np.ndarray, dict[str, typing.Any]]:
        """Begins an episode. Raises ValueError or TypeError for a bad option."""
        import mujoco

        super().reset(seed=seed)
        options = checked_options(options, ("shift", "pull"))
        shift, growth = self.np_random.uniform(-_SHIFT, _SHIFT, size=2), self.np_random.uniform(*_PULL)
        if "shift" in options:
            shift = _numbers(options["shift"], "shift", -0.01, 0.01, 2, "m")
        if "pull" in options:
            growth = float(_numbers([options["pull"]], "pull", 0.0, 10.0, 1, "N/s")[0])
        mujoco.mj_resetData(self._model, self._data)
        place = int(self._model.body("ball").jntadr.item())
        place = int(self._model.jnt_qposadr[place])
        self._data.qpos[place : place + 2] += shift
        self._setpoint[:] = _OPEN
        self._growth, self._steps, self._running = growth, 0, True
        self._set_controls()
        mujoco.mj_forward(self._model, self._data)
        self._height = float(self._data.xpos[self._ball, 2])
        return self._observation(), self._information()

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict[str, typing.Any]]:
        """Carries out one action. Raises ValueError or TypeError for a bad action, ResetNeeded outside of an episode."""
        if not self._running:
            raise gymnasium.error.ResetNeeded("the episode has ended or not begun: call reset() before step()")
        aims = _CLOSING * checked_actions(action, self.action_space.shape)
        most = _SLEW * STEPS_PER_ACTION * self._model.opt.timestep
        self._setpoint += np.clip(aims - self._setpoint, -most, most)
        self._set_controls()
        self._data.xfrc_applied[self._ball, 2] = -self._pull()
        self._simulate()
        self._steps += 1
        force = max(float(np.linalg.norm(force)) for force in self._forces().values())
        is_crushed, is_lost = force > FORCE_LIMIT, self._steps >= _LIFTED and not self._is_held()
        reward = FAILURE_REWARD if is_crushed else float(self._is_held())
        truncated = self._steps >= DURATION and not (is_crushed or is_lost)
        self._running = not (is_crushed or is_lost or truncated)
        return self._observation(), reward, is_crushed or is_lost, truncated, self._information()

    def render(self) -> np.ndarray | None:
        """Returns an image, uint8, shape (480, 480, 3), or None without a render mode. Raises Error without OpenGL."""
        return None if self.render_mode is None else self._camera.draw(self._data)

    def close(self) -> None:
        """Frees the drawing library."""
        self._camera.close()

    def _simulate(self) -> None:
        """Makes the time steps of an action. Only the last one computes readings, which nothing else needs."""
        import mujoco

        no_sensors = int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
        self._model.opt.disableflags |= no_sensors
        mujoco.mj_step(self._model, self._data, STEPS_PER_ACTION - 1)
        self._model.opt.disableflags &= ~no_sensors
        mujoco.mj_step(self._model, self._data)

    def _set_controls(self) -> None:
        for setpoint, actuators in zip(self._setpoint, self._closing):
            self._data.ctrl[actuators] = setpoint

    def _pull(self) -> float:
        """Returns the pull on the ball [N]."""
        begun = max(0, self._steps - _LIFTED) * STEPS_PER_ACTION * self._model.opt.timestep
        return float(self._growth * begun)

    def _is_held(self) -> bool:
        """Returns True if the ball is in the air: 4 mm above its place on the stand."""
        return bool(self._data.xpos[self._ball, 2] > self._height + 0.004)

    def _forces(self) -> dict[str, np.ndarray]:
        """Returns the force on each fingertip [N]."""
        forces = {}
        for finger in FINGERS:
            sensor = self._sensors[finger]
            first = sensor.address + len(sensor.ids)
            forces[finger] = self._data.sensordata[first : first + 3].copy()
        return forces

    def _readings(self) -> dict[str, np.ndarray]:
        found = {}
        for finger in FINGERS:
            sensor = self._sensors[finger]
            found[finger] = self._data.sensordata[sensor.address : sensor.address + len(sensor.ids)].copy()
        return found

    def _observation(self) -> np.ndarray:
        values = np.concatenate([*self._readings().values(), self._data.qpos[self._angles], self._setpoint])
        return normalise(self._channels, values[None])[0]

    def _information(self) -> dict[str, typing.Any]:
        return {"readings": self._readings(), "force": self._forces(), "ball": self._data.xpos[self._ball].copy(),
                "held": self._is_held(), "pull": self._pull()}


def _model() -> mujoco.MjModel:
    """Returns the scene, whose sensors give readings and wrenches. Each environment has its own: its options change."""
    import mujoco

    from taxel.scenes import make_layouts_absolute

    taxel.load_plugin()
    file = taxel.EXAMPLES / _SCENE
    spec = mujoco.MjSpec.from_file(str(file))
    make_layouts_absolute(spec, file.parent)
    for plugin in spec.plugins:
        if plugin.plugin_name == model_plugins.SENSOR:
            plugin.config = {**dict(plugin.config), "output": "readings wrench"}
    return spec.compile()


def _channels(sensors: dict[str, model_plugins.ModelSensor], joints: list[str]) -> list[Channel]:
    readings = []
    for finger in FINGERS:
        sensor = sensors[finger]
        scale = sensor.layout.value("/material/modulus") / 2 if sensor.unit == "Pa" else 2.0
        readings += [Channel(f"reading {finger} {name or number}", sensor.unit, scale, 0.0)
                     for number, name in zip(sensor.ids.tolist(), sensor.names)]
    return [*readings, *(Channel(f"angle {joint}", "rad", _JOINT_SCALE) for joint in joints),
            *(Channel(f"closing {finger}", "rad", _CLOSING) for finger in FINGERS)]


def _numbers(value: typing.Any, name: str, low: float, high: float, count: int, unit: str) -> np.ndarray:
    array = np.asarray(value)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"options[{name!r}] must be real numbers, is {value!r}")
    if array.shape != (count,) or not ((array >= low) & (array <= high)).all():
        raise ValueError(f"options[{name!r}] must have {count} number{'' if count == 1 else 's'} from {low:g} to {high:g} "
                         f"{unit}, is {value!r}")
    return array.astype(np.float64)
