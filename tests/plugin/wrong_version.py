#!/usr/bin/env python3
"""Tests a plugin that is built for another MuJoCo: wrong_version.py LIBRARY VERSION FOLDER RIGHT

VERSION is the one for which the library is built. FOLDER was written by `taxel sweep`. RIGHT is the plugin for this
MuJoCo, which is loaded at the end and warns that it comes too late.
"""
import os
import sys
import unittest

import mujoco

from loaded import loaded_mujocos

PLUGIN, VERSION, FOLDER, RIGHT = sys.argv[1:]
CONTACT = """
<mujoco>
  <extension>
    <plugin plugin="taxel.contact">
      <instance name="soft"><config key="materials" value='{"ball": {"modulus": 1e5}}'/></instance>
    </plugin>
  </extension>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 1"/>
    <body pos="0 0 0.02"><freejoint/><geom name="ball" type="sphere" size="0.02"/></body>
  </worldbody>
</mujoco>
"""


class WrongVersionTest(unittest.TestCase):
    def check(self, load):
        with self.assertRaises(ValueError) as caught:
            load()
        self.assertIn(f"this taxel plugin is built for MuJoCo {VERSION}", str(caught.exception))
        self.assertIn(f"this is MuJoCo {mujoco.__version__}", str(caught.exception))

    def test_scenes_with_sensors_name_both_versions(self):
        os.chdir(FOLDER)
        self.check(lambda: mujoco.MjModel.from_xml_path("scene.xml"))

    def test_scenes_with_soft_contact_name_both_versions(self):
        self.check(lambda: mujoco.MjModel.from_xml_string(CONTACT))

    def test_scenes_without_the_plugin_load(self):
        mujoco.MjModel.from_xml_string("<mujoco/>")

    def test_the_process_has_one_mujoco(self):
        self.assertEqual(len(loaded_mujocos()), 1)


if __name__ == "__main__":
    mujoco.mj_loadPluginLibrary(PLUGIN)
    program = unittest.main(argv=sys.argv[:1], verbosity=1, exit=False)
    mujoco.mj_loadPluginLibrary(RIGHT)
    sys.exit(0 if program.result.wasSuccessful() else 1)
