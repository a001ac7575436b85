"""The geoms that the plugin adds to the scene of MuJoCo's visualizer."""
import mujoco
import numpy as np

CONTACT = (mujoco.mjtVisFlag.mjVIS_CONTACTPOINT, mujoco.mjtVisFlag.mjVIS_CONTACTFORCE)


def contact_geoms(model, data, flags=CONTACT, room=20000):
    """Returns the triangles of the contact surface, as rows of place, size, matrix and colour, and the arrows of forces."""
    options = mujoco.MjvOption()
    options.flags[:] = 0
    for flag in flags:
        options.flags[flag] = 1
    scene = mujoco.MjvScene(model, room)
    mujoco.mjv_updateScene(model, data, options, None, mujoco.MjvCamera(), mujoco.mjtCatBit.mjCAT_DECOR, scene)
    geoms = scene.geoms[: scene.ngeom]
    rows = [[np.concatenate([geom.pos, geom.size, geom.mat.flatten(), geom.rgba]) for geom in geoms if geom.type == shape]
            for shape in (mujoco.mjtGeom.mjGEOM_TRIANGLE, mujoco.mjtGeom.mjGEOM_ARROW)]
    return rows[0], rows[1]
