#!/usr/bin/env python3
"""Replays a recorded sweep in plain MuJoCo: scene.xml, the plugin, and the mocap poses of every step.

    replay.py libtaxel_plugin.so FOLDER

Exits with status 0 if every recorded row is reproduced to the last digit.
"""
import pathlib
import sys

import mujoco
import numpy as np


def replay(folder):
    """Returns the recorded readings and the readings that this MuJoCo computes."""
    folder = pathlib.Path(folder)
    recorded = np.load(folder / "readings.npz")
    model = mujoco.MjModel.from_xml_path(str(folder / "scene.xml"))
    data = mujoco.MjData(model)
    rows = {int(step): row for row, step in enumerate(recorded["step"])}
    readings = np.full_like(recorded["readings"], np.nan)
    for step, (pos, quat) in enumerate(zip(recorded["mocap_pos"], recorded["mocap_quat"])):
        data.mocap_pos[0] = pos
        data.mocap_quat[0] = quat
        mujoco.mj_step(model, data)
        if step in rows:
            readings[rows[step]] = data.sensordata
    return recorded["readings"], readings


def main():
    plugin, folder = sys.argv[1:]
    mujoco.mj_loadPluginLibrary(plugin)
    recorded, replayed = replay(folder)
    same = np.array_equal(recorded, replayed)
    print(f"{len(recorded)} rows, largest reading {recorded.max():.1f} Pa: {'the same' if same else 'different'}")
    if not same:
        print(f"largest difference {np.nanmax(np.abs(recorded - replayed)):.3g} Pa")
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
