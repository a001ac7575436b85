"""What the window of the companion shows: the newest readings, their history, and the user's choices."""

from __future__ import annotations

import mujoco
import numpy as np

from taxel import scenes
from taxel.studio import decor
from taxel.studio.history import History
from taxel.studio.marks import Mark
from taxel.studio.scene import Scene, ShownSensor
from taxel.studio.surface import NO_SURFACE, Surface

SECONDS = 5.0  # length of the plot


class SensorView:
    """One sensor in the window."""

    def __init__(self, shown: ShownSensor) -> None:
        self.shown = shown
        self.values = np.zeros(len(shown.sensor.names))
        self.history = History(len(self.values))
        self.force: np.ndarray | None = None
        self.torque: np.ndarray | None = None
        self.area: float | None = None
        self.largest = 0.0
        """Largest reading so far, the full scale unless the user sets it."""
        self.largest_force = 0.0
        self.surface = NO_SURFACE
        """The newest contact surface."""
        self.reach = 1.0
        """Half of the height of the plot of the contact surface [mm]. It only grows."""
        self.aspect = 1.3
        """Width of that plot divided by its height."""

    @property
    def has_readings(self) -> bool:
        """Whether the sensor has "readings" in its output."""
        return "readings" in self.shown.sensor.output

    def take(self, time: float, sensordata: np.ndarray, surface: Surface) -> None:
        """Takes the values and the contact surface of one step."""
        self.surface = surface.of(self.shown.geom)
        read = scenes.read_sensor(self.shown.sensor, sensordata)
        self.force, self.torque, self.area = read.force, read.torque, read.area
        if self.force is not None:
            self.largest_force = max(self.largest_force, float(np.nan_to_num(np.linalg.norm(self.force))))
        if read.values is not None:
            self.values = read.values
            self.history.append(time, read.values)
            self.largest = max(self.largest, float(np.nan_to_num(np.max(read.values, initial=0.0))))


class ViewState:
    """All sensors of the scene in the window."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.sensors = [SensorView(sensor) for sensor in scene.sensors]
        self.chosen = 0
        """Number of the sensor in the panel."""
        self.time = 0.0
        self.shows_panel = True
        self.display = (0.0, 0.0)
        """Size of the display in pixels at which the panel was placed."""
        self.draws_bars = True
        self.draws_forces = True
        self.sees_through = True
        self.full_scale = 0.0
        """Full scale of all sensors in their unit, or 0 for the largest reading so far of each."""
        extent = float(scene.plain.stat.extent)
        spread = [float(np.ptp(sensor.centers, axis=0).max()) for sensor in scene.sensors if len(sensor.centers) > 1]
        self.bar = min(max(spread, default=0.1 * extent), 0.3 * extent)
        """Length of a bar and of a force at full scale [m]."""

    def take(self, time: float, sensordata: np.ndarray, surface: Surface) -> None:
        """Takes the values and the contact surfaces of one step."""
        self.time = time
        for sensor in self.sensors:
            sensor.take(time, sensordata, surface)

    def scale_of(self, sensor: SensorView) -> float:
        """Returns the reading of the last colour, or 0 if there was no reading yet."""
        return self.full_scale if self.full_scale > 0 else sensor.largest

    def marks(self, data: mujoco.MjData) -> list[Mark | None]:
        """Returns the marks of all sensors, with the poses in the viewer's data. Their number is `scene.marks.total`.

        If the renderer has no room for all taxels, those with the largest readings are drawn.
        """
        taxels: list[Mark | None] = []
        forces: list[Mark | None] = []
        fractions: list[np.ndarray] = []
        largest_force = max(sensor.largest_force for sensor in self.sensors)
        for sensor in self.sensors:
            geom = self.scene.plain_geom(sensor.shown.geom)
            position, rotation = data.geom_xpos[geom], data.geom_xmat[geom].reshape(3, 3)
            if sensor.has_readings:
                bar, scale = self.bar if self.draws_bars else 0.0, self.scale_of(sensor)
                taxels += decor.taxel_marks(sensor.shown, position, rotation, sensor.values, scale, bar)
                fractions.append(np.nan_to_num(sensor.values) / (scale or 1.0))
            if "wrench" not in sensor.shown.sensor.output:
                continue
            if self.draws_forces and sensor.force is not None and sensor.torque is not None:
                wrench = (sensor.force, sensor.torque)
                forces += decor.force_marks(sensor.shown, position, rotation, wrench, largest_force, 1.2 * self.bar)
            else:
                forces += [None, None]
        counts = self.scene.marks
        if len(taxels) > counts.taxels:
            largest = np.argsort(-np.concatenate(fractions), kind="stable")[: counts.taxels]
            taxels = [taxels[taxel] for taxel in np.sort(largest)]
        return taxels + forces[: 2 * counts.forces]
