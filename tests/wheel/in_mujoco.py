"""Replays the sweep in the installed MuJoCo and prints the largest reading: in_mujoco.py FOLDER

MuJoCo 4.0 and later have loaded the plugin by the entry point of the package, and need no call.
"""
import os
import sys

import mujoco
import numpy as np

import taxel

if int(mujoco.__version__.split(".")[0]) < 4:
    taxel.load_plugin()
taxel.sweep(out=sys.argv[1])
os.chdir(sys.argv[1])  # before 3.17 a model does not say in which folder its files are
recorded = np.load("readings.npz")
model = mujoco.MjModel.from_xml_path("scene.xml")
data = mujoco.MjData(model)
peaks = []
for pos, quat in zip(recorded["mocap_pos"], recorded["mocap_quat"]):
    data.mocap_pos[0], data.mocap_quat[0] = pos, quat
    mujoco.mj_step(model, data)
    (sensor,) = taxel.readings(model, data).values()
    peaks.append(sensor.values.max())
with open("/proc/self/maps", encoding="utf-8") as maps:
    mujocos = {line.split()[-1] for line in maps if "libmujoco.so" in line}
print(mujoco.__version__, max(peaks[step] for step in recorded["step"]), len(mujocos), taxel.load_plugin())
