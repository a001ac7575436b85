"""Thin rigid bodies in a soft box: our force against Drake's, on Drake's tets of the box."""
import dataclasses

import numpy as np

import agreement
import drake_peer
import shapes
from cases import MODULUS, about, product, rotation

BOX = (0.03, 0.03, 0.02)  # m, halves: the pressure is E d/20 mm below the middle of its top
POSES = 20
# Walls of a body that is tilted farther are partly within the range of angles of our smooth factor, and wholly on one side of
# Drake's hard limit.
LARGEST_TILT = np.radians(10)
SIDES = 48  # of round shapes


def box(x, y, z, corner=(0, 0, 0)):
    """A box of these sides. The middle of its lower face is at `corner`."""
    v = np.array([(i * x / 2, j * y / 2, k * z) for k in (0, 1) for j in (-1, 1) for i in (-1, 1)]) + corner
    f = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5)]
    return v, np.array(f)


def together(*meshes):
    faces, count = [], 0
    for v, f in meshes:
        faces.append(f + count)
        count += len(v)
    return np.vstack([v for v, _ in meshes]), np.vstack(faces)


def turned(profile, closed):
    """The solid that a profile of points (radius, z) sweeps about z. The profile runs counterclockwise about the solid; where it
    is not closed, its ends are on the axis."""
    n = len(profile)
    v, ring = [], []  # ring[k]: indices of the vertices of profile point k
    for r, z in profile:
        if r == 0:
            ring.append([len(v)] * SIDES)
            v.append((0, 0, z))
            continue
        ring.append(list(range(len(v), len(v) + SIDES)))
        v += [(r * np.cos(a), r * np.sin(a), z) for a in 2 * np.pi * np.arange(SIDES) / SIDES]
    faces = []
    for k in range(n if closed else n - 1):
        lower, upper = ring[k], ring[(k + 1) % n]
        for i in range(SIDES):
            a, b, c, d = lower[i], lower[(i + 1) % SIDES], upper[(i + 1) % SIDES], upper[i]
            faces += [t for t in ((a, b, c), (a, c, d)) if len(set(t)) == 3]
    return np.array(v), np.array(faces)


def extruded(outline, length):
    """A prism of a convex or concave outline of points (x, z), given as two sides of the same number of points: below and above."""
    below, above = outline
    n = len(below)
    v = np.array([(x, y, z) for y in (-length / 2, length / 2) for x, z in (*below, *above)])
    front, back = (lambda i: i), (lambda i: 2 * n + i)
    faces = []

    def quad(a, b, c, d):
        faces.extend([(a, b, c), (a, c, d)])

    for i in range(n - 1):
        quad(front(i), front(i + 1), front(n + i + 1), front(n + i))
        quad(back(i + 1), back(i), back(n + i), back(n + i + 1))
        quad(front(i + 1), front(i), back(i), back(i + 1))
        quad(front(n + i), front(n + i + 1), back(n + i + 1), back(n + i))
    quad(front(0), front(n), back(n), back(0))
    quad(front(2 * n - 1), front(n - 1), back(n - 1), back(2 * n - 1))
    return v, np.array(faces)


def lying(mesh):
    """The axis of a turned solid from z to y."""
    v, f = mesh
    return v @ rotation(about((1, 0, 0), np.pi / 2)).T, f


def tube(outer, wall, length):
    h = length / 2
    return turned([(outer, -h), (outer, h), (outer - wall, h), (outer - wall, -h)], closed=True)


def spoon(radius, wall, reach):
    """A part of a spherical shell, its hollow side up, out to the distance `reach` from the axis."""
    angle = np.linspace(0, np.arcsin(reach / radius), 12)
    outside = [(radius * np.sin(a), radius * (1 - np.cos(a))) for a in angle]
    inside = [((radius - wall) * np.sin(a), radius - (radius - wall) * np.cos(a)) for a in angle[::-1]]
    return turned([*outside, *inside], closed=False)


def cup(radius, wall, height):
    return turned([(0, 0), (radius, 0), (radius, height), (radius - wall, height), (radius - wall, wall), (0, wall)], closed=False)


def ridge(width, rise, wall, length):
    """A folded sheet, its fold below: both flanks rise by `rise` on half the width."""
    below = [(-width / 2, rise), (0, 0), (width / 2, rise)]
    return extruded((below, [(x, z + wall) for x, z in below]), length)


def blade(width, height, length):
    """A wedge, its edge below."""
    return extruded(([(0, 0), (1e-5, 0)], [(-width / 2, height), (width / 2, height)]), length)


BODIES = {
    "card of 0.2 mm": box(0.020, 0.014, 0.0002),
    "foil of 0.02 mm": box(0.020, 0.014, 0.00002),
    "cup, wall of 0.3 mm, on its bottom": cup(0.008, 0.0003, 0.012),
    "blade, 1 mm wide 10 mm above its edge": blade(0.001, 0.010, 0.016),
    "ring, wall of 0.4 mm, upright": lying(tube(0.008, 0.0004, 0.006)),
    "spoon, wall of 0.3 mm": spoon(0.012, 0.0003, 0.007),
    "two cards of 0.2 mm, 0.2 mm apart": together(box(0.020, 0.014, 0.0002), box(0.020, 0.014, 0.0002, (0, 0, 0.0004))),
    "tube, wall of 0.3 mm, lying": lying(tube(0.005, 0.0003, 0.016)),
    "ridge of a sheet of 0.2 mm": ridge(0.016, 0.004, 0.0002, 0.014),
    "sheet of 0.2 mm on its edge": box(0.020, 0.0002, 0.014),
}


@dataclasses.dataclass
class Row:
    name: str
    poses: int = 0
    force: float = 0            # largest difference of the force vectors, relative to Drake's
    all_faces: float = 0        # the same if all faces of ours count


def pose(rng, vertices):
    """The body's lowest point 0.5 to 3 mm below the top, turned about the vertical and tilted a little."""
    axis = rng.uniform(0, 2 * np.pi)
    tilt = about((np.cos(axis), np.sin(axis), 0), rng.uniform(0, LARGEST_TILT))
    q = product(tilt, about((0, 0, 1), rng.uniform(0, 2 * np.pi)))
    low = np.min((rotation(q) @ vertices.T)[2])
    return np.array([*rng.uniform(-0.002, 0.002, 2), BOX[2] - rng.uniform(0.0005, 0.003) - low, *q])


def compare(library, folder, name, mesh, seed):
    file = folder / "thin.obj"
    shapes.write_obj(file, *mesh)
    drakes = drake_peer.Pair(drake_peer.shape("box", BOX), drake_peer.compliant(MODULUS), drake_peer.shape("mesh", file=file),
                             drake_peer.rigid())
    soft, rigid = agreement.exported(library, drakes, 0, MODULUS, folder), library.shape("mesh", file=file)
    ours, all_faces = library.pair(soft, rigid), library.pair(soft, rigid, all_faces=True)
    row, rng, still = Row(name), np.random.default_rng(seed), np.array([0, 0, 0, 1.0, 0, 0, 0])
    for _ in range(POSES):
        at = pose(rng, mesh[0])
        theirs = drakes.contact(still, at)
        largest = np.linalg.norm(theirs.force)
        row.poses += 1
        for pair, column in ((ours, "force"), (all_faces, "all_faces")):
            apart = np.linalg.norm(np.array(pair.contact(still, at).force) - theirs.force) / largest
            setattr(row, column, max(getattr(row, column), apart))
    return row


def run(library, folder):
    return [compare(library, folder, name, mesh, seed) for seed, (name, mesh) in enumerate(BODIES.items())]
