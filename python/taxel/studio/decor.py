"""Bars of taxels, pressed taxels and forces as decorative geoms of MuJoCo's visualizer."""

from __future__ import annotations

import mujoco
import numpy as np

from taxel.studio.scene import ShownSensor

#: Colours from no reading to the full scale: dark blue, blue, green, yellow, red.
COLORS = np.array([[0.16, 0.19, 0.45], [0.13, 0.45, 0.75], [0.20, 0.70, 0.55], [0.95, 0.80, 0.25], [0.85, 0.25, 0.15]])
#: Height of the disc on a pressed taxel, and least height of a bar [m].
THICKNESS = 2e-4
_FORCE_COLOR = np.array([0.95, 0.45, 0.1, 1.0], np.float32)


def color_of(value: float) -> np.ndarray:
    """Returns the colour of a reading as a fraction of the full scale: red, green, blue and opacity, shape (4,)."""
    place = float(np.clip(value, 0, 1)) * (len(COLORS) - 1)
    below = min(int(place), len(COLORS) - 2)
    mixed = COLORS[below] + (place - below) * (COLORS[below + 1] - COLORS[below])
    return np.append(mixed, 1).astype(np.float32)


def places(sensor: ShownSensor, data: mujoco.MjData) -> tuple[np.ndarray, np.ndarray]:
    """Returns centres [m] and outward normals of all taxels in the world, both (n, 3)."""
    R_WG = data.geom_xmat[sensor.geom].reshape(3, 3)
    return sensor.centers @ R_WG.T + data.geom_xpos[sensor.geom], sensor.normals @ R_WG.T


def taxel_geoms(
    sensor: ShownSensor, data: mujoco.MjData, values: np.ndarray, full_scale: float, bar: float
) -> list[mujoco.MjvGeom]:
    """Returns one geom for each taxel: its bar along the outward normal, or a flat disc with `bar` = 0.

    `values` has the readings (n,), of which `full_scale` gives the last colour and a bar of the length `bar` [m].
    """
    centers, normals = places(sensor, data)
    fractions = np.clip(np.nan_to_num(values / full_scale), 0, 1) if full_scale > 0 else np.zeros(len(values))
    geoms = []
    for center, normal, radius, fraction in zip(centers, normals, sensor.radii, fractions):
        end = center + normal * max(bar * fraction, THICKNESS)
        width = 0.22 * radius if bar > 0 else 0.5 * radius
        geoms.append(_connector(mujoco.mjtGeom.mjGEOM_CYLINDER, width, center, end, color_of(fraction)))
    return geoms


def force_geom(
    sensor: ShownSensor, data: mujoco.MjData, force: np.ndarray, torque: np.ndarray, full_scale: float, length: float
) -> mujoco.MjvGeom | None:
    """Returns the arrow of the force on a sensor, or None without a force.

    `force` [N] and `torque` [N m] are about the origin of the mesh file's frame, in world axes. The arrow ends at the
    point of the force's line that is nearest to the pressed side of the sensor, and is `length` [m] long at `full_scale`.
    """
    size = float(np.linalg.norm(force))
    if not np.isfinite(size) or size <= 1e-9 or full_scale <= 0:
        return None
    R_WG = data.geom_xmat[sensor.geom].reshape(3, 3)
    origin = R_WG @ sensor.origin + data.geom_xpos[sensor.geom]
    # The points origin + cross(force, torque) / |force|^2 + s force have the same torque.
    nearest = origin + np.cross(force, torque) / size**2
    direction = force / size
    centers, _ = places(sensor, data)
    entry = float(np.min((centers - nearest) @ direction)) if len(centers) else 0.0
    tip = nearest + entry * direction
    start = tip - direction * max(length * min(size / full_scale, 1), 1e-3)
    return _connector(mujoco.mjtGeom.mjGEOM_ARROW, 0.03 * length, start, tip, _FORCE_COLOR)


def _connector(
    kind: mujoco.mjtGeom, width: float, start: np.ndarray, end: np.ndarray, color: np.ndarray
) -> mujoco.MjvGeom:
    geom = mujoco.MjvGeom()
    mujoco.mjv_initGeom(geom, int(kind), np.zeros(3), np.zeros(3), np.eye(3).flatten(), color)
    mujoco.mjv_connector(geom, int(kind), width, start, end)
    geom.category = int(mujoco.mjtCatBit.mjCAT_DECOR)
    return geom
