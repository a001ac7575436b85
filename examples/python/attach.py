"""Puts twelve taxels on each fingertip of a robot hand that has no sensors, and prints the largest reading of each.

Needs MuJoCo and this package, which is not on PyPI: in a clone, after scripts/setup, pip install . mujoco
"""
import mujoco

import taxel

taxel.load_plugin()
spec = mujoco.MjSpec.from_file(str(taxel.EXAMPLES / "scenes/hand_grasps_ball.xml"))
for sensor in list(spec.sensors):
    spec.delete(sensor)
for plugin in list(spec.plugins):  # the instances of the sensors, which MuJoCo 4 has deleted already
    spec.delete(plugin)

layout = taxel.Layout.read(taxel.EXAMPLES / "layouts/hand_fingertip.taxels.json")
layout.set_value("/material/modulus", 8e4)  # [Pa]
for finger in ("thumb", "index", "middle", "ring", "little"):
    taxel.attach(spec, finger, layout, others=["ball"], output=["readings", "wrench"])

model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_resetDataKeyframe(model, data, 0)
mujoco.mj_step(model, data, nstep=250)
for sensor in taxel.readings(model, data).values():
    strongest = sensor.values.argmax()
    print(f"{sensor.geom:7} taxel {sensor.ids[strongest]:2} {sensor.values[strongest]:9.1f} {sensor.unit}")
