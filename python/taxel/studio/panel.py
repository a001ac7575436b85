"""The window "Taxels" in MuJoCo's Studio: choices, bars of the present readings, and their plot over time."""

from __future__ import annotations

import mujoco
import numpy as np
from mujoco.studio.dear_imgui import dear_imgui as imgui
from mujoco.studio.implot import implot

from taxel.studio.surface import MOST_TRIANGLES, footprint
from taxel.studio.view_state import SECONDS, SensorView, ViewState

_CURVES = 12  # most taxels in the plot
_POINTS = 240  # points of a curve
_HEIGHT = 230.0
_BELOW = 70.0  # space for the status bar, and that of the page in the browser


def build_panel(state: ViewState, flags: np.ndarray) -> None:
    """Builds the window and its entry in the menu View, and changes the user's choices. `flags` are the viewer's visualization flags."""
    if imgui.BeginMainMenuBar():
        if imgui.BeginMenu("View"):
            if imgui.MenuItem("Taxels", "", state.shows_panel):
                state.shows_panel = not state.shows_panel
            imgui.EndMenu()
        imgui.EndMainMenuBar()
    flags[mujoco.mjtVisFlag.mjVIS_TRANSPARENT] = state.sees_through
    if state.shows_panel:
        _build_window(state)


def _build_window(state: ViewState) -> None:
    _place_window(state)
    is_expanded, state.shows_panel = imgui.Begin("Taxels", True)
    if is_expanded:
        _build_choices(state)
        sensor = state.sensors[state.chosen]
        _build_numbers(sensor)
        counts = state.scene.marks
        taxels = sum(len(each.values) for each in state.sensors if each.has_readings)
        if counts.taxels < taxels:
            imgui.TextUnformatted(f"MuJoCo's renderer has room for {counts.taxels} of {taxels} taxels: the most pressed are drawn")
        if sensor.surface.is_cut:
            imgui.TextUnformatted(f"The contact surface has more triangles than are drawn here ({MOST_TRIANGLES})")
        if sensor.has_readings:
            _build_plots(state, sensor)
        else:
            imgui.TextUnformatted("The sensor has no readings: its output is " + " ".join(sensor.shown.sensor.output))
    imgui.End()


def _place_window(state: ViewState) -> None:
    """Puts the window at the lower edge of the view whenever the display has a new size, as after a browser connects."""
    display = imgui.GetIO().DisplaySize
    if (display.x, display.y) == state.display:
        return
    state.display = (display.x, display.y)
    left, right = 0.22 * display.x, 0.75 * display.x
    imgui.SetNextWindowPos(imgui.Vec2(left, display.y - _HEIGHT - _BELOW), int(imgui.Cond.Always))
    imgui.SetNextWindowSize(imgui.Vec2(right - left, _HEIGHT), int(imgui.Cond.Always))


def _build_choices(state: ViewState) -> None:
    imgui.SetNextItemWidth(170)
    _, state.chosen = imgui.Combo("##sensor", state.chosen, [sensor.shown.name for sensor in state.sensors])
    imgui.SameLine()
    _, state.draws_bars = imgui.Checkbox("Bars", state.draws_bars)
    imgui.SameLine()
    _, state.draws_forces = imgui.Checkbox("Forces", state.draws_forces)
    imgui.SameLine()
    _, state.sees_through = imgui.Checkbox("See through bodies", state.sees_through)
    imgui.SameLine()
    imgui.SetNextItemWidth(80)
    unit = state.sensors[state.chosen].shown.sensor.unit
    _, state.full_scale = imgui.InputFloat(f"Full scale [{unit}], 0: largest", state.full_scale, format="%.5g")
    state.full_scale = max(state.full_scale, 0.0) if np.isfinite(state.full_scale) else 0.0


def describe(sensor: SensorView) -> str:
    """Returns the newest numbers of a sensor in one line."""
    parts = []
    if sensor.has_readings and len(sensor.values):
        most = int(np.argmax(np.nan_to_num(sensor.values)))
        parts.append(f"{sensor.values[most]:.5g} {sensor.shown.sensor.unit} at {sensor.shown.sensor.names[most]}")
        parts.append(f"largest so far {sensor.largest:.5g} {sensor.shown.sensor.unit}")
    if sensor.force is not None:
        parts.append(f"force {float(np.linalg.norm(sensor.force)):.4g} N")
    if sensor.area is not None:
        parts.append(f"area {1e6 * sensor.area:.4g} mm2")
    return "   ".join(parts)


def _build_numbers(sensor: SensorView) -> None:
    imgui.TextUnformatted(describe(sensor))


def _build_plots(state: ViewState, sensor: SensorView) -> None:
    space = imgui.GetContentRegionAvail()
    height = max(space.y, 80.0)
    plain = int(implot.Flags.NoMouseText)
    top = state.scale_of(sensor) or 1.0
    unit = sensor.shown.sensor.unit
    if implot.BeginPlot("##bars", imgui.Vec2(max(0.55 * space.x - height, 80.0), height), plain | int(implot.Flags.NoLegend)):
        implot.SetupAxes("taxel", unit)
        implot.SetupAxesLimits(-0.7, len(sensor.values) - 0.3, 0, 1.05 * top, int(implot.Cond.Always))
        implot.PlotBars("readings", list(range(len(sensor.values))), sensor.values.tolist(), 0.7)
        implot.EndPlot()
    imgui.SameLine()
    _build_contact(sensor, height)
    imgui.SameLine()
    if implot.BeginPlot("##time", imgui.Vec2(-1, height), plain):
        implot.SetupAxes("time [s]", unit)
        start = max(state.time - SECONDS, 0.0)
        implot.SetupAxesLimits(start, start + SECONDS, 0, 1.05 * top, int(implot.Cond.Always))
        implot.SetupLegend(int(implot.Location.East), int(implot.LegendFlags.Outside))
        times, rows = sensor.history.curves(SECONDS, _POINTS)
        for taxel in curves_to_draw(rows):
            implot.PlotLine(f"{sensor.shown.sensor.names[taxel]}##{taxel}", times.tolist(), rows[:, taxel].tolist())
        implot.EndPlot()


def _build_contact(sensor: SensorView, height: float) -> None:
    """Builds the plot of the contact surface from above, in the colours of the pressure."""
    flags = int(implot.Flags.NoMouseText) | int(implot.Flags.NoLegend)
    if not implot.BeginPlot("##contact", imgui.Vec2(height, height), flags):
        return
    corners = footprint(sensor.surface)
    sensor.reach = max(sensor.reach, 1.1 * float(np.abs(corners).max(initial=0.0)))
    implot.SetupAxes("contact [mm]", "")
    wide = sensor.aspect * sensor.reach
    implot.SetupAxesLimits(-wide, wide, -sensor.reach, sensor.reach, int(implot.Cond.Always))
    place, size = implot.GetPlotPos(), implot.GetPlotSize()
    sensor.aspect = size.x / max(size.y, 1.0)
    pixels = to_pixels(corners, (wide, sensor.reach), (place.x, place.y), (size.x, size.y))
    implot.PushPlotClipRect()
    drawing = imgui.GetWindowDrawList()
    for (a, b, c), color in zip(pixels.tolist(), pack(sensor.surface.colors)):
        drawing.AddTriangleFilled(imgui.Vec2(*a), imgui.Vec2(*b), imgui.Vec2(*c), color)
    implot.PopPlotClipRect()
    implot.EndPlot()


def to_pixels(
    corners: np.ndarray, reach: tuple[float, float], place: tuple[float, float], size: tuple[float, float]
) -> np.ndarray:
    """Returns the pixels of triangles (n, 3, 2) in a plot from -reach to reach, whose upper left corner is `place`.

    The corners are counter-clockwise on the screen: Dear ImGui then blurs edges inwards, without spikes at sharp corners.
    """
    pixels = np.array(place) + 0.5 * np.array(size) * (1 + corners * [1, -1] / np.array(reach))
    sides = pixels[:, 1:] - pixels[:, :1]
    clockwise = sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0] > 0
    pixels[clockwise] = pixels[clockwise][:, ::-1]
    return pixels


def pack(colors: np.ndarray) -> list[int]:
    """Returns colours (n, 4) from 0 to 1 as Dear ImGui wants them: red in the lowest byte, opacity in the highest."""
    parts = np.round(255 * np.clip(colors, 0, 1)).astype(np.uint32) << np.array([0, 8, 16, 24], np.uint32)
    return np.bitwise_or.reduce(parts, axis=1).tolist()


def curves_to_draw(rows: np.ndarray) -> list[int]:
    """Returns the numbers of the taxels in the plot: those with readings, the largest ones if there are many."""
    peaks = np.nan_to_num(rows.max(axis=0)) if len(rows) else np.zeros(rows.shape[1])
    largest = np.argsort(-peaks, kind="stable")[:_CURVES]
    return sorted(int(taxel) for taxel in largest if peaks[taxel] > 0)
