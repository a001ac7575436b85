"""How dense must a fingertip's layout be to tell an edge's position within 0.5 mm?

A fingertip presses on an edge again and again, at random places, depths and tilts. A kernel ridge regression learns the
position of the edge from the readings, for layouts of several densities. The program prints a table of their errors and
the answer, and writes table.csv and a plot of it. docs/edge_position.md explains the method and the result.

Needs this package, which is not on PyPI: in a clone, after scripts/setup, pip install ".[data]"
python edge_position.py --out edge_position
"""
import argparse
import csv
import dataclasses
import pathlib
import sys
import time

import numpy as np
import pyarrow.dataset
import pyarrow.parquet

import taxel
from plot import draw_errors

REQUIRED = 0.5  # largest error that is allowed [mm]
SHARE = 95  # percentage of the touches that must keep it
# The edge runs along y. Its radius and the size of its box give the height of its top.
SCENARIO = {"kind": "press", "shape": "edge", "box_size": 0.05, "edge_radius": 0.001, "hold": 0, "record_interval": 0.02}
EDGE_HEIGHT = SCENARIO["box_size"] * np.sqrt(2) - SCENARIO["edge_radius"] * (np.sqrt(2) - 1)  # [m]
RANDOM = {"/scenario/place": {"uniform": [-0.004, 0.004]},  # position of the edge [m]
          "/scenario/depth": {"uniform": [0.0012, 0.002]},  # of the lowest point of the finger below the edge [m]
          "/scenario/tilt_deg": {"uniform": [15, 25]}}
LEAST_FORCE = 0.1  # a weaker touch does not count, because a robot would press on [N]
LEVELS = 255  # of a reading with noise: 8 bits over the full scale


@dataclasses.dataclass(frozen=True)
class Placed:
    """The taxels of one layout in the sensor that has the taxels of all layouts."""

    spacing: float  #: mean distance of neighbours [mm]
    number: int  #: index among the layouts of this spacing
    columns: slice


@dataclasses.dataclass(frozen=True)
class Row:
    """A row of the table."""

    noise: float  #: standard deviation, as a fraction of the full scale
    spacing: float  #: [mm]
    taxels: int
    per_cm2: float
    rms: float  #: root mean square of the errors [mm]
    rms_low: float  #: 95 % interval of the bootstrap [mm]
    rms_high: float
    within: float  #: 95 % of the touches have no larger error [mm]
    within_low: float  #: 95 % interval of the bootstrap [mm]
    within_high: float


class TouchedSkin:
    """The samples of the skin that an edge may touch: those that face the pad's side, at the front of the finger."""

    def __init__(self):
        model = taxel.SensorModel(taxel.Layout.read(taxel.FINGERTIP))
        pad_side = -model.sample_normals[:, 1] > 0.5  # at most 60 degrees from the direction of the pad
        touched = pad_side & (model.sample_positions[:, 2] > 0.014)
        self.points = model.sample_positions[touched]
        self.normals = model.sample_normals[touched]
        self.area = model.sample_areas[touched].sum()  # [m^2]

    def count(self, spacing):
        """Returns the number of taxels of a hexagonal grid of this spacing [mm]."""
        count = round(self.area / ((spacing * 1e-3) ** 2 * np.sqrt(3) / 2))
        if count < 2:
            sys.exit(f"--spacings: {spacing:g} mm leaves fewer than two taxels on {1e6 * self.area:.0f} mm^2 of skin")
        return count

    def spread(self, count, rng):
        """Returns indices of samples that are spread evenly: Lloyd's method, from random samples."""
        centers = self.points[rng.choice(len(self.points), count, replace=False)]
        for _ in range(30):
            nearest = squared_distances(self.points, centers).argmin(axis=1)
            centers = np.array([self.points[nearest == k].mean(axis=0) for k in range(count)])
        return squared_distances(centers, self.points).argmin(axis=1)


def squared_distances(a, b):
    """Returns the squared distance of each row of a to each row of b."""
    squares = np.sum(a * a, axis=1)[:, None] + np.sum(b * b, axis=1) - 2 * a @ b.T
    return np.maximum(squares, 0)


def make_layouts(options, folder):
    """Writes each layout as a file of its own, and all.taxels.json, which has the taxels of all. Returns their places."""
    skin, everything, placed = TouchedSkin(), taxel.Layout.read(taxel.FINGERTIP).absolute(), []
    everything.delete_taxels(np.arange(len(everything.centers)))
    empty = everything.copy()
    for spacing in options.spacings:
        count = skin.count(spacing)
        for number in range(options.layouts):
            rng = np.random.default_rng([options.seed, round(1000 * spacing), number])
            chosen = skin.spread(count, rng)
            taxels = {"centers": skin.points[chosen], "normals": skin.normals[chosen],
                      "radii": options.radius * spacing * 1e-3}
            layout = empty.copy()
            layout.set_value("/name", f"spacing {spacing:g} mm, layout {number}")
            layout.add_taxels(**taxels)
            layout.write(folder / f"spacing_{spacing:g}mm_{number}.taxels.json")
            first = len(everything.centers)
            everything.add_taxels(**taxels)
            placed.append(Placed(spacing, number, slice(first, first + count)))
    everything.write(folder / "all.taxels.json")
    return skin, placed


def press(options, folder):
    """Makes the runs, or continues them. Returns the folder of the data set. Ends the program if no run is possible."""
    job = {"layout": folder / "all.taxels.json", "scenario": SCENARIO, "set": RANDOM, "repeat": options.runs,
           "seed": options.seed}

    def show(state):
        if sys.stderr.isatty():
            left = "" if state.seconds_left is None else f", {state.seconds_left:.0f} s left"
            end = "\n" if state.finished == state.jobs else ""
            print(f"\r{state.finished} of {state.jobs} runs{left}    ", end=end, file=sys.stderr)

    try:
        result = taxel.batch([job], folder / "data", poses=True, workers=options.workers, progress=show)
    except taxel.Error as error:
        sys.exit(str(error))
    for failed in result.failed:
        print(f"run {failed.number} failed: {failed.error}", file=sys.stderr)
    return result.folder


def numbers(table, name):
    """Returns a column of lists of equal length as an array, shape (rows, n)."""
    values = table[name].combine_chunks().flatten().to_numpy(zero_copy_only=False)
    return values.reshape(table.num_rows, -1).astype(float)


def read_touches(data):
    """Reads the row of the largest force of each run, unless the force is less than LEAST_FORCE.

    Returns readings (touches, taxels) [Pa], positions of the edge along the finger, in the frame of the mesh (touches,)
    [mm], and forces (touches,) [N].
    """
    limits = ["dataset_from_index", "dataset_to_index"]  # rows of each run
    runs = pyarrow.parquet.read_table(data / "meta/episodes", columns=limits).to_pylist()
    force = numbers(pyarrow.parquet.read_table(data / "data", columns=["observation.force"]), "observation.force")[:, 2]
    rows = np.array([first + force[first:last].argmax() for first, last in (map(run.get, limits) for run in runs)])
    rows = rows[force[rows] >= LEAST_FORCE]
    columns = ["observation.tactile", "observation.sensor_pose"]
    touches = pyarrow.dataset.dataset(data / "data").take(rows, columns=columns)  # reads the file in parts
    pose = numbers(touches, "observation.sensor_pose")
    w, x, y, z = (pose[:, 3:] / np.linalg.norm(pose[:, 3:], axis=1, keepdims=True)).T
    along = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=1)  # the finger, in the world
    position = np.sum(along * ([0, 0, EDGE_HEIGHT] - pose[:, :3]), axis=1)
    return numbers(touches, "observation.tactile"), 1000 * position, force[rows]


def measure(readings, full_scale, noise, rng):
    """Returns the readings of a device as fractions of the full scale: without noise, or with noise and 8 bits."""
    values = readings / full_scale
    if noise == 0:
        return values
    return np.round((values + rng.normal(0, noise, values.shape)) * LEVELS) / LEVELS


def pattern(values):
    """Divides the readings of each touch by their norm: what remains hardly depends on the force."""
    norm = np.linalg.norm(values, axis=1, keepdims=True)
    return values / np.maximum(norm, 1e-9)


class KernelRidge:
    """Kernel ridge regression with a Gaussian kernel. Leave-one-out errors choose its width and ridge."""

    WIDTHS = np.array([0.3, 1, 3, 10])  # squared, in medians of the squared distances
    RIDGES = 10.0 ** np.arange(-7, 1)

    def __init__(self, inputs, targets):
        self.inputs, self.mean, self.range = inputs, targets.mean(), (targets.min(), targets.max())
        squares, best = squared_distances(inputs, inputs), np.inf
        for width in self.WIDTHS * np.median(squares):
            values, vectors = np.linalg.eigh(np.exp(-squares / width))
            values = np.maximum(values, 0)
            parts = vectors.T @ (targets - self.mean)
            for ridge in self.RIDGES:
                # The error of a touch by the regression without this touch, in closed form: residual / (1 - leverage).
                kept = values / (values + ridge)
                residual = targets - self.mean - vectors @ (kept * parts)
                error = np.mean((residual / (1 - (vectors * vectors) @ kept)) ** 2)
                if error < best:
                    best, self.width, self.weights = error, width, vectors @ (parts / (values + ridge))

    def predict(self, inputs):
        """Returns a target for each row of inputs, within the range of the targets that were learned."""
        values = np.exp(-squared_distances(inputs, self.inputs) / self.width) @ self.weights + self.mean
        return np.clip(values, *self.range)


def test_errors(readings, positions, noise, rng):
    """Learns from 60 % of the touches. Returns the errors of the others [mm]."""
    count = round(0.6 * len(positions))
    values = pattern(measure(readings, readings[:count].max(), noise, rng))
    return KernelRidge(values[:count], positions[:count]).predict(values[count:]) - positions[count:]


def rms(errors):
    return np.sqrt(np.mean(errors**2))


def within(errors):
    return np.percentile(abs(errors), SHARE)


def bootstrap(figure, errors, rng):
    """Returns a figure of the errors and its 95 % interval, over layouts and touches: errors is (layouts, touches)."""
    values = []
    for _ in range(1000):
        layouts, touches = (rng.integers(size, size=size) for size in errors.shape)
        values.append(figure(errors[np.ix_(layouts, touches)]))
    return figure(errors), *np.percentile(values, [2.5, 97.5])


def make_table(options, skin, placed, readings, positions):
    rows = []
    for noise in options.noise:
        for spacing in options.spacings:
            rng = np.random.default_rng([options.seed, round(1e6 * noise), round(1000 * spacing)])
            columns = [layout.columns for layout in placed if layout.spacing == spacing]
            errors = np.array([test_errors(readings[:, part], positions, noise, rng) for part in columns])
            taxels = skin.count(spacing)
            rows.append(Row(noise, spacing, taxels, taxels / (1e4 * skin.area), *bootstrap(rms, errors, rng),
                            *bootstrap(within, errors, rng)))
    return rows


def name_of(noise):
    return f"noise of {100 * noise:g} % of full scale, 8 bits" if noise else "no noise"


def print_table(rows):
    for noise in dict.fromkeys(row.noise for row in rows):
        print(f"\n{name_of(noise)}\nspacing  taxels  per cm^2  RMS error (95 % interval)     {SHARE} % of touches within")
        for row in rows:
            if row.noise == noise:
                errors = [f"{value:.3f} mm ({low:.3f} to {high:.3f})" for value, low, high in
                          ((row.rms, row.rms_low, row.rms_high), (row.within, row.within_low, row.within_high))]
                print(f"{row.spacing:4g} mm  {row.taxels:6}  {row.per_cm2:8.1f}  {'   '.join(errors)}")


def print_answers(rows):
    """Prints the widest spacing that suffices, also at the upper end of its interval, as all closer ones do."""
    print(f"\nTo tell the position of the edge within {REQUIRED} mm in {SHARE} % of the touches:")
    for noise in dict.fromkeys(row.noise for row in rows):
        answer = None
        for row in sorted((row for row in rows if row.noise == noise), key=lambda row: row.spacing):
            if row.within_high > REQUIRED:
                break
            answer = row
        enough = f"{answer.spacing:g} mm or less, {answer.per_cm2:.1f} taxels per cm^2" if answer else "none of these spacings"
        print(f"{name_of(noise)}: {enough}")


def write_results(rows, folder):
    """Writes table.csv and edge_position.svg."""
    with open(folder / "table.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(field.name for field in dataclasses.fields(Row))
        writer.writerows(dataclasses.astuple(row) for row in rows)
    (folder / "edge_position.svg").write_text(draw_errors(rows, name_of, REQUIRED), encoding="utf-8")


def at_least(kind, least):
    """Returns a function that reads a number of an option."""
    def parse(text):
        value = kind(text)
        if not least <= value < np.inf:
            raise argparse.ArgumentTypeError(f"must be at least {least}, is {text}")
        return value
    parse.__name__ = kind.__name__  # in messages of argparse
    return parse


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--out", type=pathlib.Path, default="edge_position", help="folder of layouts, data set, table and plot")
    add("--runs", type=at_least(int, 10), default=2000)
    add("--spacings", type=at_least(float, 1), nargs="+", default=[1.5, 2, 3, 4, 5, 6, 8], help="of the taxels [mm]")
    add("--radius", type=at_least(float, 0.1), default=0.6, help="of the fields, in spacings; 0.6 just covers the skin")
    add("--layouts", type=at_least(int, 1), default=4, help="number of layouts of each spacing")
    add("--noise", type=at_least(float, 0), nargs="+", default=[0, 0.01, 0.03], help="standard deviations, in full scales")
    add("--seed", type=at_least(int, 0), default=1, help="of layouts, touches and noise")
    add("--workers", type=at_least(int, 1), help="number of runs at the same time (default: the number of cores)")
    return parser.parse_args()


def main():
    options = parse_options()
    options.out.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    skin, placed = make_layouts(options, options.out)
    data = press(options, options.out)
    readings, positions, forces = read_touches(data)
    print(f"{options.runs} runs, {len(positions)} touches of {forces.min():.2f} to {forces.max():.2f} N, edge at "
          f"{positions.min():.1f} to {positions.max():.1f} mm, {readings.shape[1]} taxels in {len(placed)} layouts")
    middle = time.monotonic()
    rows = make_table(options, skin, placed, readings, positions)
    print_table(rows)
    print_answers(rows)
    write_results(rows, options.out)
    print(f"layouts and runs {middle - start:.0f} s, regressions {time.monotonic() - middle:.0f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
