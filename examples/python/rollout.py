"""Presses a fingertip onto a box with 16 targets, two simulations at a time, and prints the largest reading of each.

Needs MuJoCo and this package, which is not on PyPI: in a clone, after scripts/setup, pip install . mujoco
"""
import mujoco
import mujoco.rollout
import numpy as np

import taxel

model = taxel.load_model(taxel.EXAMPLES / "scenes/press.xml")
data = [mujoco.MjData(model) for _ in range(2)]  # one for each thread
state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
mujoco.mj_getState(model, data[0], state, mujoco.mjtState.mjSTATE_FULLPHYSICS)

targets = np.linspace(-0.001, 0.002, 16)  # of the slide [m]
control = np.repeat(targets[:, None, None], 200, axis=1)  # (simulations, steps, actuators)
_, sensordata = mujoco.rollout.rollout(model, data, np.tile(state, (16, 1)), control)

sensor = taxel.readings(model, data[0])["fingertip taxels"]
readings = np.asarray(sensordata)[:, :, : len(sensor.ids)]  # (simulations, steps, taxels)
for target, largest in zip(targets, readings.max(axis=(1, 2))):
    print(f"{1000 * target:6.2f} mm {largest:9.1f} {sensor.unit}")
