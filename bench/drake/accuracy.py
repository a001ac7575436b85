"""Both on their own tessellations of one shape, ours with no more tets than Drake's, against the closed form: shapes on a rigid
plane (A1, A4, A5, A6 of docs/theory/hydro.md; capsule: A1 + A6; ellipsoid: the affine image of A1), and two soft spheres (A7)."""
import dataclasses

import numpy as np

import drake_peer
from cases import MODULUS, about, product

POSES = 100


def spherical_cap(R, x):
    """A1."""
    return np.pi * MODULUS * x * x * (1 - 2 * x / (3 * R)), np.pi * (2 * R * x - x * x)


def lying(R, x, length):
    """A6: a stretch of a cylinder, without its ends."""
    h = R - x
    a = np.sqrt(R * R - h * h)
    return MODULUS * (a - h * h / R * np.arcsinh(a / h)) * length, 2 * a * length


def sphere(size, n, depth):
    return size[0] - depth, spherical_cap(size[0], depth)


def ellipsoid(size, n, depth):
    """In y = x/semi-axes the body is the unit ball and p = E (1 - |y|); the plane n x = h becomes the plane at h/|S n|, and its
    areas grow by det S/|S n|."""
    reach = np.linalg.norm(np.array(size) * n)
    force, area = spherical_cap(1.0, depth / reach)
    scale = np.prod(size) / reach
    return reach - depth, (force * scale, area * scale)


def capsule(size, n, depth):
    force, area = spherical_cap(size[0], depth)
    more_force, more_area = lying(size[0], depth, 2 * size[1])
    return size[0] - depth, (force + more_force, area + more_area)


def standing(size, n, depth):
    R, H = size[0], min(size)
    return size[1] - depth, (np.pi * MODULUS * (R**3 - (R - depth)**3) / (3 * H), np.pi * R * R)


def box(size, n, depth):
    H, (a, b, _) = min(size), (2 * s for s in size)
    return size[2] - depth, (MODULUS / H * (depth * a * b - depth**2 * (a + b) + 4 * depth**3 / 3), a * b)


# name -> kind, size, Drake's resolution hint, depth, closed form, which directions may face the plane
SHAPES = {
    "sphere": ("sphere", (0.05,), 0.008, 0.0025, sphere, "any"),
    "ellipsoid": ("ellipsoid", (0.03, 0.04, 0.05), 0.008, 0.002, ellipsoid, "any"),
    "capsule, lying": ("capsule", (0.03, 0.05), 0.007, 0.002, capsule, "side"),
    "cylinder, standing": ("cylinder", (0.03, 0.05), 0.006, 0.002, standing, "end"),
    "box": ("box", (0.03, 0.04, 0.05), 0.01, 0.002, box, "end"),
}


@dataclasses.dataclass
class Row:
    name: str
    tets: int
    drake_tets: int
    force: float        # mean relative error over the poses
    drake_force: float
    area: float
    drake_area: float


def directions(kind, rng):
    """Unit vectors in the body's frame that shall point down."""
    if kind == "end":
        return [np.array([0.0, 0.0, -1.0])]
    found = rng.standard_normal((POSES, 3))
    if kind == "side":
        found[:, 2] = 0
    return found / np.linalg.norm(found, axis=1)[:, None]


def turned_down(n):
    """A rotation that takes the unit vector n to -z."""
    axis, cosine = np.cross(n, (0, 0, -1)), -n[2]
    if np.linalg.norm(axis) < 1e-12:
        return about((1, 0, 0), 0.0 if cosine > 0 else np.pi)
    return about(axis, np.arctan2(np.linalg.norm(axis), cosine))


def finest_within(library, kind, size, tets, modulus=MODULUS):
    """Our tessellation with the most tets that are not more than Drake's."""
    best, best_count = None, 0
    for edge in np.geomspace(2 * min(size), 0.02 * min(size), 60):
        body = library.shape(kind, size, resolution=edge, modulus=modulus)
        count = len(library.field(body)[1])
        if count > tets:
            break
        if count > best_count:
            best, best_count = body, count
    return best, best_count


def compare(library, name, seed):
    kind, size, hint, depth, closed_form, facing = SHAPES[name]
    drakes = drake_peer.Pair(drake_peer.shape(kind, size), drake_peer.compliant(MODULUS, hint), drake_peer.shape("plane"),
                             drake_peer.rigid())
    drake_tets = drakes.mesh(0).num_elements()
    body, tets = finest_within(library, kind, size, drake_tets)
    ours = library.pair(body, library.shape("plane"))
    ground = np.array([0, 0, 0, 1.0, 0, 0, 0])
    errors = []
    for n in directions(facing, np.random.default_rng(seed)):
        height, (force, area) = closed_form(size, n, depth)
        q = product(about((0, 0, 1), 0.3), turned_down(n))
        pose = (np.array([0, 0, height, *q]), ground)
        mine, theirs = ours.contact(*pose), drakes.contact(*pose)
        errors.append([mine.force[2] / force - 1, theirs.force[2] / force - 1, mine.area / area - 1, theirs.area / area - 1])
    return Row(name, tets, drake_tets, *np.mean(np.abs(errors), axis=0))


def two_spheres(R, modulus_a, modulus_b, depth, steps=20000):
    """A7: force and area of the surface kA rA - kB rB = EA - EB of two soft spheres of one radius, by the midpoint rule over the
    radius: at each radius the height where the pressures agree, by bisection."""
    D, kA, kB = 2 * R - depth, modulus_a / R, modulus_b / R
    rim = np.sqrt(R * R - D * D / 4)
    rho = (np.arange(steps) + 0.5) * rim / steps
    low, high = np.zeros(steps), np.full(steps, D)
    for _ in range(60):
        z = (low + high) / 2
        above = kA * (R - np.hypot(rho, z)) > kB * (R - np.hypot(rho, D - z))
        low, high = np.where(above, z, low), np.where(above, high, z)
    rA, rB = np.hypot(rho, z), np.hypot(rho, D - z)
    gradient = -kA * np.array([rho, z]) / rA + kB * np.array([rho, z - D]) / rB
    ring = 2 * np.pi * rho * rim / steps
    return np.sum(ring * kA * (R - rA)), np.sum(ring * np.linalg.norm(gradient, axis=0) / np.abs(gradient[1]))


def compare_two_spheres(library, seed):
    R, modulus_a, modulus_b, hint, depth = 0.05, 1e5, 4e5, 0.008, 0.004
    drakes = drake_peer.Pair(drake_peer.shape("sphere", (R,)), drake_peer.compliant(modulus_a, hint),
                             drake_peer.shape("sphere", (R,)), drake_peer.compliant(modulus_b, hint))
    drake_tets = drakes.mesh(0).num_elements()
    a, tets = finest_within(library, "sphere", (R,), drake_tets, modulus_a)
    b, _ = finest_within(library, "sphere", (R,), drake_tets, modulus_b)
    ours = library.pair(a, b)
    force, area = two_spheres(R, modulus_a, modulus_b, depth)
    rng = np.random.default_rng(seed)
    errors = []
    for _ in range(POSES):
        turn = [q / np.linalg.norm(q) for q in rng.standard_normal((2, 4))]
        pose = (np.array([0, 0, 0, *turn[0]]), np.array([0, 0, depth - 2 * R, *turn[1]]))
        mine, theirs = ours.contact(*pose), drakes.contact(*pose)
        errors.append([mine.force[2] / force - 1, theirs.force[2] / force - 1, mine.area / area - 1, theirs.area / area - 1])
    return Row("two soft spheres", tets, drake_tets, *np.mean(np.abs(errors), axis=0))


def run(library):
    rows = [compare(library, name, seed) for seed, name in enumerate(SHAPES)]
    return rows + [compare_two_spheres(library, len(SHAPES))]
