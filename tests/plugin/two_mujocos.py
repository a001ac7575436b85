#!/usr/bin/env python3
"""Tests the plugin in a process that has loaded a second MuJoCo: two_mujocos.py LIBRARY FOLDER SECOND

SECOND is the library of another version of MuJoCo. FOLDER was written by `taxel sweep`.
"""
import ctypes
import os
import sys
import unittest

import mujoco

PLUGIN, FOLDER, SECOND = sys.argv[1:]


class TwoMujocosTest(unittest.TestCase):
    def test_works_in_the_right_one_and_refuses_in_the_other(self):
        second = ctypes.CDLL(SECOND, mode=os.RTLD_NOW | os.RTLD_LOCAL)
        second.mj_versionString.restype = ctypes.c_char_p
        second.mj_loadXML.restype = ctypes.c_void_p
        mujoco.mj_loadPluginLibrary(PLUGIN)
        os.chdir(FOLDER)
        model = mujoco.MjModel.from_xml_path("scene.xml")
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data)
        reason = ctypes.create_string_buffer(2000)
        self.assertIsNone(second.mj_loadXML(b"scene.xml", None, reason, 2000))
        self.assertIn(f"built for MuJoCo {mujoco.__version__}", reason.value.decode())
        self.assertIn(f"this is MuJoCo {second.mj_versionString().decode()}", reason.value.decode())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
