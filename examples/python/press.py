"""Presses a fingertip onto a box and prints the readings of its tactile sensor.

Needs MuJoCo and this package, which is not on PyPI: in a clone, after scripts/setup, pip install . mujoco
"""
import mujoco

import taxel

model = taxel.load_model(taxel.EXAMPLES / "scenes/press.xml")
data = mujoco.MjData(model)
mujoco.mj_step(model, data, nstep=200)
for name, sensor in taxel.readings(model, data).items():
    for taxel_name, value in zip(sensor.names, sensor.values):
        print(f"{name}: {taxel_name:15} {value:8.1f} {sensor.unit}")
