"""Steps of a simulation."""
import mujoco
import numpy as np


def sensor_rows(model, data, steps):
    """Makes steps, and returns data.sensordata after each of them."""
    rows = []
    for _ in range(steps):
        mujoco.mj_step(model, data)
        rows.append(data.sensordata.copy())
    return np.array(rows)
