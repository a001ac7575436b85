#!/usr/bin/env python3
"""Tests many data of one model, the robot hand that grasps a ball: sharing.py LIBRARY SCENE"""
import copy
import gc
import os
import pickle
import sys
import time
import unittest

import mujoco
import numpy as np

from stepping import sensor_rows

PLUGIN, SCENE = sys.argv[1:]
MIB = 1 << 20
# A sanitizer keeps freed memory back or shadows it. AddressSanitizer finds leaks itself.
SANITIZED = any(library in os.environ.get("LD_PRELOAD", "") for library in ("libasan", "libtsan"))


def resident():
    """Returns the memory of this process [MiB]."""
    gc.collect()
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / MIB


def run(model, data, steps=20):
    return sensor_rows(model, data, steps)


class SharingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        os.chdir(os.path.dirname(SCENE))  # before 3.17 a model does not say from which folder its meshes are
        cls.model = mujoco.MjModel.from_xml_path(SCENE)
        begin = time.perf_counter()
        cls.data = mujoco.MjData(cls.model)
        cls.first = time.perf_counter() - begin

    def test_further_data_need_less_than_5_mib_each(self):
        before, begin = resident(), time.perf_counter()
        data = [mujoco.MjData(self.model)]
        second = time.perf_counter() - begin
        begin = time.perf_counter()
        data += [mujoco.MjData(self.model) for _ in range(63)]
        seconds, each = second + time.perf_counter() - begin, (resident() - before) / 64
        print(f"first data {1e3 * self.first:.0f} ms, second {1e3 * second:.0f} ms, 64 more {1e3 * seconds:.0f} ms "
              f"and {each:.2f} MiB each")
        expected = run(self.model, data[0])
        np.testing.assert_array_equal(run(self.model, data[63]), expected)
        if not SANITIZED:
            self.assertLess(each, 5)

    @unittest.skipIf(SANITIZED, "a sanitizer keeps freed memory back")
    def test_a_thousand_data_made_and_freed_leave_nothing_behind(self):
        for _ in range(100):
            run(self.model, mujoco.MjData(self.model), 1)
        before = resident()
        for _ in range(1000):
            run(self.model, mujoco.MjData(self.model), 1)
        grown = resident() - before
        print(f"1000 data made and freed: {grown:+.2f} MiB")
        self.assertLess(grown, 2)

    def test_copies_of_any_kind_continue_like_the_original(self):
        run(self.model, self.data, 5)
        copies = [copy.copy(self.data), copy.deepcopy(self.data), pickle.loads(pickle.dumps(self.data)),
                  copy.deepcopy(pickle.loads(pickle.dumps(copy.copy(self.data))))]
        expected = run(self.model, self.data)
        for one in copies:
            np.testing.assert_array_equal(run(self.model, one), expected)
            np.testing.assert_array_equal(run(self.model, copy.deepcopy(one)), run(self.model, one))
        while copies:  # in an order other than that of their making
            copies.pop(len(copies) // 2)
            gc.collect()
        run(self.model, self.data, 1)

    def test_copies_of_the_model_have_data_of_their_own(self):
        for model in (copy.copy(self.model), copy.deepcopy(self.model), pickle.loads(pickle.dumps(self.model))):
            data = mujoco.MjData(model)
            expected = run(self.model, mujoco.MjData(self.model))
            np.testing.assert_array_equal(run(model, data), expected)

    def test_data_outlive_their_model(self):
        model = mujoco.MjModel.from_xml_path(SCENE)
        data = [mujoco.MjData(model) for _ in range(2)]
        text = pickle.dumps(data[0])
        del model
        gc.collect()
        run(data[1].model, data[1], 2)
        del data
        other = pickle.loads(text)
        run(other.model, other, 2)


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    unittest.main(argv=sys.argv[:1], verbosity=1)
