"""Compares the pad of this program with finite elements of an elastic layer, and writes tables and pictures.

    compare.py TAXEL OUT.md PICTURES_FOLDER

A rigid ball and a long rigid cylinder are pressed into a layer of 2 mm by 5 to 20 % of its thickness, without friction.
`taxel material` gives the modulus of the pad, `taxel contact` its force, contact radius and pressures.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import matplotlib
import numpy as np

from layer import Layer

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402 (the backend is chosen first)

THICKNESS = 2e-3
POISSONS = (0.3, 0.4, 0.45, 0.49, 0.499)
RADII = (2e-3, 4e-3, 8e-3, 16e-3)
DEPTHS = (0.05, 0.10, 0.15, 0.20)  # of the thickness
BASES = ("bonded", "sliding")
BODIES = ("ball", "cylinder")
UNIT = 1e5  # modulus of the contact cases; pressures and forces are proportional to it


class Program:
    """The program `taxel`, with a memory of its answers."""

    def __init__(self, path):
        self.path, self.results = path, {}

    def run(self, *arguments):
        key = tuple(str(a) for a in arguments)
        if key not in self.results:
            done = subprocess.run([self.path, *key, "--json"], check=True, capture_output=True, text=True)
            self.results[key] = json.loads(done.stdout)
        return self.results[key]

    def modulus(self, poisson, base, body, contact_radius=None):
        """Returns the modulus of the pad for E = 1 Pa."""
        options = ["--youngs", 1, "--poisson", poisson, "--thickness", THICKNESS]
        options += ["--bonded"] if base == "bonded" else []
        options += ["--cylinder"] if body == "cylinder" else []
        options += ["--contact-radius", repr(contact_radius)] if contact_radius else []
        return self.run("material", *options)["modulus"]

    def contact(self, radius, depth, body):
        """Returns force (per length for a cylinder), contact radius and largest pressure of a pad of 1 Pa."""
        edge = np.sqrt(2 * radius * depth) / 8
        if body == "ball":
            one = self._case({"type": "sphere", "size": [radius]}, radius, depth, edge)
            cap = one["area"] / (2 * np.pi * radius)  # height of the part of the ball that is in the pad
            return one["force"][2] / UNIT, np.sqrt(2 * radius * cap - cap ** 2), one["max_pressure"] / UNIT
        half = (4e-3, 6e-3)  # the difference of two lengths has no ends
        two = [self._case({"type": "cylinder", "size": [radius, h]}, radius, depth, edge) for h in half]
        length = 2 * (half[1] - half[0])
        arc = (two[1]["area"] - two[0]["area"]) / length  # of the circle of the cylinder
        return ((two[1]["force"][2] - two[0]["force"][2]) / UNIT / length,
                radius * np.sin(arc / (2 * radius)), two[1]["max_pressure"] / UNIT)

    def _case(self, shape, radius, depth, edge):
        key = (shape["type"], tuple(shape["size"]), depth, edge)
        if key in self.results:
            return self.results[key]
        lying = [np.sqrt(0.5), 0, np.sqrt(0.5), 0] if shape["type"] == "cylinder" else [1, 0, 0, 0]
        case = {"format": "contact-case", "version": 1,
                "a": {"shape": shape, "resolution": edge, "pos": [0, 0, radius - depth], "quat": lying},
                "b": {"shape": {"type": "plane"},
                      "material": {"modulus": UNIT, "thickness": THICKNESS, "dissipation": 0}}}
        with tempfile.TemporaryDirectory() as folder:
            name = pathlib.Path(folder) / "case.json"
            name.write_text(json.dumps(case))
            answer = json.loads(subprocess.run([self.path, "contact", str(name), "--json"], check=True,
                                               capture_output=True, text=True).stdout)
        self.results[key] = answer
        return answer


def press_all():
    """Returns {(nu, base, body): (layer, {(R, depth): Contact})}."""
    found = {}
    for poisson in POISSONS:
        for base in BASES:
            for body in BODIES:
                layer = Layer(poisson, THICKNESS, base == "bonded", body == "ball", fine=7e-3, count=140)
                found[poisson, base, body] = layer, {(r, d): layer.press(r, d * THICKNESS) for r in RADII for d in DEPTHS}
                print(f"finite elements: nu {poisson}, {base}, {body}", file=sys.stderr)
    return found


def overlap(radius, depth):
    return round(float(np.sqrt(2 * radius * depth * THICKNESS)), 12)


def percent(value):
    return f"{100 * value:+.0f} %"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def verification():
    """Returns rows that check the finite elements against closed forms, and the largest error."""
    rows, worst = [], 0.0
    for poisson in (0.3, 0.499):
        layer = Layer(poisson, THICKNESS, True, True, 6e-3, count=30, wall=True)
        modulus = (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson))
        error = layer.deflection(np.ones(len(layer.across))) * modulus / THICKNESS - 1
        rows.append(("confined compression, u = p H (1 + nu)(1 - 2 nu)/((1 - nu) E)", str(poisson), f"{error:.1e}"))
        worst = max(worst, abs(error))
        thick = Layer(poisson, 0.1, True, True, 1e-3, count=60, width=0.2)
        error = thick.press(5e-3, 5e-5).force * (1 - poisson ** 2) / (4 / 3 * np.sqrt(5e-3) * 5e-5 ** 1.5) - 1
        rows.append(("Hertz, ball of 5 mm, depth 0.05 mm, layer of 100 mm", str(poisson), f"{error:.1e}"))
        worst = max(worst, abs(error))
    return rows, worst


def force_tables(found, program):
    """Returns the text of the tables of force errors, after a summary."""
    text, all_right = "", []
    for body in BODIES:
        for base in BASES:
            rows = []
            for poisson in POISSONS:
                presses = found[poisson, base, body][1]
                right, edges, peaks = [], [], []
                thin = []
                for (r, d), fem in presses.items():
                    force, edge, peak = program.contact(r, d * THICKNESS, body)
                    modulus = program.modulus(poisson, base, body, overlap(r, d))
                    right.append(modulus * force / fem.force - 1)
                    edges.append(edge / fem.radius - 1)
                    peaks.append(modulus * peak / fem.pressure[0] - 1)
                    thin.append(program.modulus(poisson, base, body) * force / fem.force - 1)
                all_right += right
                rows.append([str(poisson)] + [f"{percent(min(v))} to {percent(max(v))}" for v in (right, edges, peaks, thin)])
            text += f"{body.capitalize()}, {base} base, all radii and depths:\n\n"
            text += table(["nu", "force, `--contact-radius` of the press", "contact radius", "largest pressure",
                           "force, thin-layer modulus"], rows) + "\n"
    return (f"With the modulus for the contact radius of each press, sqrt(2 R depth), the force of all {len(all_right)} "
            f"presses is off by {percent(min(all_right))} to {percent(max(all_right))}. Contact radius and largest "
            "pressure are not those of the layer, because its skin also sinks or bulges next to the ball: at small depths "
            "the pad's contact is too wide and its pressure too low, and on a thin rubber layer its pressure is too "
            "high.\n\n" + text)


def one_modulus_table(found, program):
    """Returns the errors of one modulus for all presses of a ball, and for all balls."""
    rows = []
    for poisson in POISSONS:
        presses = found[poisson, "bonded", "ball"][1]
        for name, radius in (("contact radius of each ball at 20 %", None), ("1 thickness, all balls", THICKNESS)):
            errors = {d: [] for d in DEPTHS}
            for (r, d), fem in presses.items():
                modulus = program.modulus(poisson, "bonded", "ball", radius or overlap(r, DEPTHS[-1]))
                errors[d].append(modulus * program.contact(r, d * THICKNESS, "ball")[0] / fem.force - 1)
            rows.append([str(poisson), name] + [f"{percent(min(e))} to {percent(max(e))}" for e in errors.values()])
    return table(["nu", "modulus for"] + [f"depth {100 * d:.0f} %" for d in DEPTHS], rows)


def shape_factor_line(found, program):
    """Returns a sentence on the modulus of Gent and Lindley 1959 for bonded blocks, at nu = 0.499."""
    errors = []
    for (r, d), fem in found[0.499, "bonded", "ball"][1].items():
        radius = overlap(r, d)
        modulus = 1 + 2 * (radius / (2 * THICKNESS)) ** 2
        errors.append(modulus * program.contact(r, d * THICKNESS, "ball")[0] / fem.force - 1)
    return (f"For comparison, E (1 + 2 S^2), S = a/(2 H), of Gent and Lindley 1959 for blocks glued on both sides (nu = "
            f"0.499, ball): {percent(min(errors))} to {percent(max(errors))}, so it is not used.")


def draw_pressures(found, program, folder):
    figure, axes = plt.subplots(2, 3, figsize=(10, 5.5), constrained_layout=True)
    radius, depth = 8e-3, 0.2 * THICKNESS
    for axis, (base, poisson) in zip(axes.flat, [(b, n) for b in BASES for n in (0.3, 0.45, 0.499)]):
        layer, presses = found[poisson, base, "ball"]
        axis.plot(1e3 * layer.across, presses[radius, 0.2].pressure, label="finite elements")
        at = np.linspace(0, np.sqrt(2 * radius * depth - depth ** 2), 200)
        shape = (depth - radius + np.sqrt(radius ** 2 - at ** 2)) / THICKNESS
        axis.plot(1e3 * at, program.modulus(poisson, base, "ball", overlap(radius, 0.2)) * shape, "--", label="pad")
        axis.set(title=f"{base}, nu = {poisson}", xlim=(0, 4.5), ylim=(0, None))
        axis.set(xlabel="distance from the axis [mm]", ylabel="pressure / E")
    axes.flat[0].legend(frameon=False)
    save(figure, folder / "layer_pressure.svg")


def draw_forces(found, program, folder):
    figure, axes = plt.subplots(1, 3, figsize=(10, 3.2), constrained_layout=True)
    depths = np.linspace(0.01, 0.2, 20)
    for axis, poisson in zip(axes, (0.3, 0.45, 0.499)):
        for color, radius in enumerate(RADII):
            layer = found[poisson, "bonded", "ball"][0]
            forces = [layer.press(radius, d * THICKNESS).force for d in depths]
            axis.plot(100 * depths, forces, color=f"C{color}", label=f"R = {1e3 * radius:.0f} mm")
            modulus = program.modulus(poisson, "bonded", "ball", overlap(radius, 0.2))
            x = depths * THICKNESS
            axis.plot(100 * depths, modulus / THICKNESS * np.pi * x ** 2 * (radius - x / 3), "--", color=f"C{color}")
        axis.set(title=f"bonded, nu = {poisson}", xlabel="depth [% of the thickness]", ylabel="force / E [m^2]", yscale="log")
    axes[0].legend(frameon=False)
    save(figure, folder / "layer_force.svg")


def save(figure, name):
    matplotlib.rcParams["svg.hashsalt"] = "taxel"
    figure.savefig(name, metadata={"Date": None})
    plt.close(figure)


def page(found, program, folder):
    checks, _ = verification()
    draw_pressures(found, program, folder)
    draw_forces(found, program, folder)
    return f"""## Layers against finite elements

A rigid ball and a long rigid cylinder (R = 2, 4, 8 and 16 mm) on an elastic layer of 2 mm, pressed by 5, 10, 15 and 20 % of its thickness, without friction, nu = 0.3 to 0.499. Finite elements: linear elasticity,
quadratic displacements with linear pressures (Taylor and Hood), contact by an active set; made by `scripts/finite_elements/run`. The pad has the modulus of `taxel material`, its contact is that of `taxel contact`. Errors
are those of the pad against the finite elements, smallest to largest. Large strain is left out on both sides: at 20 % a rubber is stiffer than a linear solid, and the page does not say by how much.

Finite elements against closed forms:

{table(["check", "nu", "error"], checks)}
{force_tables(found, program)}
One modulus for a whole press, bonded base, ball. A pad's force grows with the square of the depth, that of a layer with the power 1.5 (thick), 2 (thin) or 3 (thin and incompressible), so one modulus is right at one contact radius:

{one_modulus_table(found, program)}
{shape_factor_line(found, program)}

![Pressures of a ball of 8 mm at 20 %](pictures/layer_pressure.svg)
![Forces of balls on a bonded layer; dashed: pads with one modulus for each ball](pictures/layer_force.svg)
"""


def main():
    program, out, folder = Program(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    out.write_text(page(press_all(), program, folder))


if __name__ == "__main__":
    main()
