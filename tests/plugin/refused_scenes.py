"""A scene that the plugin refuses leaves no memory behind.

    refused_scenes.py PLUGIN

MuJoCo initialises a plugin while it compiles a scene, and jumps out of that on an error. The memory of the mjData that
it has allocated by then is reserved but hardly used, so the address space of the process shows it.
"""
import sys

import mujoco

SCENES = 60
SCENE = """<mujoco>
  <size memory="20M"/>
  <extension><plugin plugin="taxel.sensor"><instance name="a">
    <config key="layout" value="no such file.json"/><config key="geom" value="box"/></instance></plugin></extension>
  <worldbody><body><geom name="box" type="box" size="1 1 1"/></body></worldbody>
  <sensor><plugin plugin="taxel.sensor" instance="a"/></sensor>
</mujoco>"""


def address_space():
    """Returns the size of the address space of this process in MB."""
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmSize")) / 1024


def refuse(times):
    for _ in range(times):
        try:
            mujoco.MjModel.from_xml_string(SCENE)
        except ValueError as error:
            assert "no such file.json" in str(error), error
        else:
            sys.exit("a scene without its layout was accepted")


mujoco.mj_loadPluginLibrary(sys.argv[1])
refuse(5)
before = address_space()
refuse(SCENES)
grown = address_space() - before
if grown > 20 * SCENES / 4:
    sys.exit(f"{SCENES} refused scenes of 20 MB have left {grown:.0f} MB")
