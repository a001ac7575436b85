"""The marks of tactile sensors: bars or discs of taxels, and forces."""

from __future__ import annotations

import mujoco
import numpy as np

from taxel.studio.marks import Mark
from taxel.studio.scene import ShownSensor

#: Colours from no reading to the full scale: dark blue, blue, green, yellow, red.
COLORS = np.array([[0.25, 0.30, 0.62], [0.13, 0.45, 0.75], [0.20, 0.70, 0.55], [0.95, 0.80, 0.25], [0.85, 0.25, 0.15]])
#: Height of the disc of a taxel, and least height of its bar [m].
THICKNESS = 4e-4
_FORCE_COLOR = np.array([0.95, 0.45, 0.1, 1.0])


def color_of(value: float) -> np.ndarray:
    """Returns the colour of a reading as a fraction of the full scale: red, green, blue and opacity, shape (4,)."""
    place = float(np.clip(value, 0, 1)) * (len(COLORS) - 1)
    below = min(int(place), len(COLORS) - 2)
    mixed = COLORS[below] + (place - below) * (COLORS[below + 1] - COLORS[below])
    return np.append(mixed, 1.0)


def taxel_marks(
    sensor: ShownSensor, position: np.ndarray, rotation: np.ndarray, values: np.ndarray, full_scale: float, bar: float
) -> list[Mark | None]:
    """Returns one mark for each taxel: its bar along the outward normal, or a flat disc with `bar` = 0.

    `position` (3,) [m] and `rotation` (3, 3) are the geom's pose in the world. `values` has the readings (n,), of which
    `full_scale` gives the last colour and a bar of the length `bar` [m].
    """
    centers, normals = sensor.centers @ rotation.T + position, sensor.normals @ rotation.T
    fractions = np.clip(np.nan_to_num(values / full_scale), 0, 1) if full_scale > 0 else np.zeros(len(values))
    width = 0.25 if bar > 0 else 0.6
    return [
        Mark(center, center + normal * max(bar * fraction, THICKNESS), width * radius, color_of(fraction))
        for center, normal, radius, fraction in zip(centers, normals, sensor.radii, fractions)
    ]


def force_marks(
    sensor: ShownSensor,
    position: np.ndarray,
    rotation: np.ndarray,
    wrench: tuple[np.ndarray, np.ndarray],
    full_scale: float,
    length: float,
) -> list[Mark | None]:
    """Returns shaft and head of the force on a sensor, or two times None without a force.

    `wrench` has force [N] and torque [N m] about the origin of the mesh file's frame, in world axes. The arrow lies on
    the force's line of action, ends at the taxels, and is `length` [m] long at the force `full_scale`.
    """
    force, torque = wrench
    size = float(np.linalg.norm(force))
    if not np.isfinite(size) or size <= 1e-9 or full_scale <= 0:
        return [None, None]
    origin = rotation @ sensor.origin + position
    # The points origin + cross(force, torque) / |force|^2 + s force have no torque across the force.
    nearest = origin + np.cross(force, torque) / size**2
    direction = force / size
    centers = sensor.centers @ rotation.T + position
    tip = nearest + direction * float(np.min((centers - nearest) @ direction, initial=np.inf if len(centers) else 0.0))
    long = max(length * min(size / full_scale, 1.0), 0.05 * length)
    neck = tip - direction * min(0.3 * length, 0.5 * long)
    thin, thick = 0.03 * length, 0.07 * length
    head = Mark(neck, tip, thick, _FORCE_COLOR, mujoco.mjtGeom.mjGEOM_ELLIPSOID)
    return [Mark(tip - direction * long, neck, thin, _FORCE_COLOR), head]
