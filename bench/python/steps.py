#!/usr/bin/env python3
"""Prints a table of steps per second in one version of MuJoCo: steps.py LIBRARY SWEEP SCENE

SWEEP is a folder of `taxel sweep`, SCENE the hand of five fingers. Each row is a way to step several simulations of one
model. All rows run alternately, so that changes of the machine's speed affect all of them.
"""
import importlib.util
import os
import pathlib
import statistics
import sys
import time
import xml.etree.ElementTree as xml

import mujoco
import mujoco.rollout
import numpy as np

ROUNDS = int(os.environ.get("ROUNDS", "9"))
FULL = mujoco.mjtState.mjSTATE_FULLPHYSICS
HAS_BATCH = importlib.util.find_spec("mujoco.batch") is not None


class Case:
    """Simulations of one model: their first states, and the values of `spec` in each of their steps."""

    def __init__(self, model, states, controls, spec):
        self.model, self.states, self.controls, self.spec = model, states, controls, spec
        self.steps = controls.shape[0] * controls.shape[1]
        self.data = [mujoco.MjData(model) for _ in range(2)]

    def loop(self):
        """Calls mj_step for each step, as most programs do."""
        data, sensed = self.data[0], np.zeros((*self.controls.shape[:2], self.model.nsensordata))
        for row, (state, controls) in enumerate(zip(self.states, self.controls)):
            mujoco.mj_resetData(self.model, data)
            mujoco.mj_setState(self.model, data, state, FULL)
            for step, control in enumerate(controls):
                mujoco.mj_setState(self.model, data, control, self.spec)
                mujoco.mj_step(self.model, data)
                sensed[row, step] = data.sensordata
        return sensed

    def rollout(self, threads):
        for data in self.data:
            mujoco.mj_resetData(self.model, data)
        return mujoco.rollout.rollout(self.model, self.data[:threads], self.states, self.controls,
                                      control_spec=int(self.spec), persistent_pool=True)[1]

    def batch(self, threads):
        """One call per step for all simulations, as for a policy that reads them in each step."""
        from mujoco.batch import Batch

        rows, steps = self.controls.shape[:2]
        batch = Batch(self.model, nsim=rows, nthread=threads)
        sensed = np.zeros((rows, steps, self.model.nsensordata))
        if self.spec == mujoco.mjtState.mjSTATE_CTRL:
            targets = [(batch.bind("ctrl"), self.controls)]
        else:
            targets = [(batch.bind("mocap_pos"), self.controls[..., :3].reshape(rows, steps, 1, 3)),
                       (batch.bind("mocap_quat"), self.controls[..., 3:].reshape(rows, steps, 1, 4))]
        for row, state in enumerate(self.states):
            mujoco.mj_setState(self.model, self.data[0], state, FULL)
            integration = np.zeros(mujoco.mj_stateSize(self.model, mujoco.mjtState.mjSTATE_INTEGRATION))
            mujoco.mj_getState(self.model, self.data[0], integration, mujoco.mjtState.mjSTATE_INTEGRATION)
            batch.state[row] = integration
        values = batch.bind("sensordata") if self.model.nsensordata else None
        for step in range(steps):
            for array, wanted in targets:
                array[:] = wanted[:, step]
            batch.step()
            if values is not None:
                sensed[:, step] = values
        return sensed


WAYS = {"loop of mj_step": Case.loop}
for count in (1, 2):
    WAYS[f"mujoco.rollout, threads: {count}"] = lambda case, n=count: case.rollout(n)
    if HAS_BATCH:
        WAYS[f"mujoco.batch, threads: {count}"] = lambda case, n=count: case.batch(n)


def without_plugin(text):
    root = xml.fromstring(text)
    for part in ("extension", "sensor"):
        for element in root.findall(part):
            root.remove(element)
    return xml.tostring(root, encoding="unicode")


def models(file):
    """Returns the models of a scene with the plugin and without."""
    os.chdir(pathlib.Path(file).parent)  # before 3.17 a model does not say in which folder its files are
    bare = pathlib.Path(file).with_name("without_plugin.xml")  # finds the scene's meshes
    bare.write_text(without_plugin(pathlib.Path(file).read_text()))
    return mujoco.MjModel.from_xml_path(str(file)), mujoco.MjModel.from_xml_path(str(bare))


def state_of(model, data):
    state = np.zeros(mujoco.mj_stateSize(model, FULL))
    mujoco.mj_getState(model, data, state, FULL)
    return state


def sweep_case(model, folder, simulations=2):
    """The recorded sweep, simultaneously in several simulations."""
    recorded = np.load(folder / "readings.npz")
    moves = np.hstack([recorded["mocap_pos"].reshape(-1, 3), recorded["mocap_quat"].reshape(-1, 4)])
    states = np.tile(state_of(model, mujoco.MjData(model)), (simulations, 1))
    spec = mujoco.mjtState.mjSTATE_MOCAP_POS | mujoco.mjtState.mjSTATE_MOCAP_QUAT
    return Case(model, states, np.tile(moves, (simulations, 1, 1)), spec)


def hand_case(model, simulations=8, steps=250):
    """The hand that holds its grip, in several simulations with controls of their own."""
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    states = np.tile(state_of(model, data), (simulations, 1))
    scale = 1 + 0.01 * np.arange(simulations)
    controls = np.tile(data.ctrl, (simulations, steps, 1)) * scale[:, None, None]
    return Case(model, states, controls, mujoco.mjtState.mjSTATE_CTRL)


def measure(cases):
    """Returns steps per second of each case and way. Ends if a way reads other bytes than the loop."""
    rates = {}
    expected = {name: case.loop() for name, case in cases.items()}
    for turn in range(ROUNDS + 1):
        for name, case in cases.items():
            for way, run in WAYS.items():
                begin = time.perf_counter()
                sensed = run(case)
                seconds = time.perf_counter() - begin
                if sensed.tobytes() != expected[name].tobytes():
                    sys.exit(f"{way}, {name}: other bytes than the loop")
                if turn > 0:  # the first round warms up
                    rates.setdefault((name, way), []).append(case.steps / seconds)
    return rates


def main():
    plugin, sweep, scene = sys.argv[1:]
    mujoco.mj_loadPluginLibrary(plugin)
    sweep = pathlib.Path(sweep)
    with_plugin, without = models(sweep / "scene.xml")
    cases = {"sweep": sweep_case(with_plugin, sweep), "sweep without": sweep_case(without, sweep)}
    with_plugin, without = models(scene)
    cases |= {"hand": hand_case(with_plugin), "hand without": hand_case(without)}
    load = os.getloadavg()[0]
    rates = measure(cases)
    print(f"\nMuJoCo {mujoco.__version__}, medians of {ROUNDS} rounds (smallest to largest), load {load:.1f} to {os.getloadavg()[0]:.1f}, "
          f"the same bytes in all ways"
          f"{'' if HAS_BATCH else '; this version has no mujoco.batch'}\n")
    print(f"| steps per second | {' | '.join(cases)} |")
    print("| --- |" + " --- |" * len(cases))
    for way in WAYS:
        cells = []
        for name in cases:
            values = rates[name, way]
            cells.append(f"{statistics.median(values):,.0f} ({min(values):,.0f} to {max(values):,.0f})")
        print(f"| {way} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
