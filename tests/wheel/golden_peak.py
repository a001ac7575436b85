import sys, mujoco, numpy, taxel
run = taxel.sweep(out=sys.argv[1])
recorded = numpy.load(f"{sys.argv[1]}/readings.npz")
model = mujoco.MjModel.from_xml_path(f"{sys.argv[1]}/scene.xml")
data = mujoco.MjData(model)
peaks = []
for pos, quat in zip(recorded["mocap_pos"], recorded["mocap_quat"]):
    data.mocap_pos[0], data.mocap_quat[0] = pos, quat
    mujoco.mj_step(model, data)
    (sensor,) = taxel.readings(model, data).values()
    peaks.append(sensor.values.max())
print(run.sensors[0].readings.max(), max(peaks[step] for step in recorded["step"]), sensor.unit)
