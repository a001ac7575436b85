"""Drake on its own tets against our kernel on the same tets: area, force and centroid, pose by pose."""
import dataclasses

import numpy as np

import drake_peer
import shapes
from cases import MODULUS, rotation

POSES = 40  # compared of each pair of shapes
TRIES = 1000
SOFT = {"sphere": (0.05,), "box": (0.04, 0.05, 0.06), "capsule": (0.03, 0.04), "cylinder": (0.03, 0.05),
        "ellipsoid": (0.03, 0.04, 0.06)}
OTHER = {"sphere": (0.04,), "box": (0.03, 0.04, 0.05)}  # rigid, and soft
OTHER_MODULUS = 3 * MODULUS
SOFT_EDGE, OTHER_EDGE = 0.008, 0.010  # m


@dataclasses.dataclass
class Row:
    soft: str
    other: str
    tets: int
    poses: int          # that touch without back faces
    filtered: int       # that touch with back faces, which Drake cuts off at one angle and we between two: not compared
    area: float = 0     # largest relative difference over the poses
    force: float = 0    # of the force vector
    centroid: float = 0  # of the area's centroid, relative to the root of the area


def exported(library, pair, number, modulus, folder):
    """Drake's tets of body 0 or 1 as an unscaled VTK file, and our body of them: p = 0 at the boundary, E at the medial axis."""
    mesh = pair.mesh(number)
    x = np.array(mesh.vertices())
    tets = np.array([[e.vertex(i) for i in range(4)] for e in mesh.tetrahedra()])
    pressure = np.full(len(x), modulus)
    pressure[sorted(shapes.boundary_vertices(tets))] = 0
    file = folder / f"drake_{number}.vtk"
    shapes.write_vtk(file, x, tets, pressure)
    return library.tets(file, modulus)


def exported_triangles(library, pair, folder):
    mesh = pair.mesh(1)
    path = folder / "drake_triangles.obj"
    shapes.write_obj(path, np.array(mesh.vertices()), [[t.vertex(i) for i in range(3)] for t in mesh.triangles()])
    return library.shape("mesh", file=path)


def random_pose(rng, x_soft, x_other):
    """The other body pushed into the soft one from a random side, both at random orientations: 1 to 8 % of the soft one's
    size deep, measured along the line of the centres."""
    turn = [v / np.linalg.norm(v) for v in (rng.standard_normal(4), rng.standard_normal(4))]
    side = rng.standard_normal(3)
    side /= np.linalg.norm(side)
    reach = np.max(x_soft @ rotation(turn[0]).T @ side) - np.min(x_other @ rotation(turn[1]).T @ side)
    depth = rng.uniform(0.01, 0.08) * np.ptp(x_soft, axis=0).max()
    offset = rng.uniform(-0.01, 0.01, 3)
    return np.array([*offset, *turn[0]]), np.array([*(offset + side * (reach - depth)), *turn[1]])


def compare(library, folder, soft, other, other_modulus, seed):
    properties = drake_peer.compliant(other_modulus, OTHER_EDGE) if other_modulus > 0 else drake_peer.rigid(OTHER_EDGE)
    drakes = drake_peer.Pair(drake_peer.shape(soft, SOFT[soft]), drake_peer.compliant(MODULUS, SOFT_EDGE),
                             drake_peer.shape(other, OTHER[other]), properties)
    b = (exported(library, drakes, 1, other_modulus, folder) if other_modulus > 0
         else exported_triangles(library, drakes, folder))
    ours = library.pair(exported(library, drakes, 0, MODULUS, folder), b)
    row = Row(soft, ("soft " if other_modulus > 0 else "rigid ") + other, drakes.mesh(0).num_elements(), 0, 0)
    x = np.array(drakes.mesh(0).vertices())
    rng = np.random.default_rng(seed)
    x_other = np.array(drakes.mesh(1).vertices())
    for _ in range(TRIES):
        if row.poses == POSES:
            break
        pose = random_pose(rng, x, x_other)
        mine, theirs = ours.contact(*pose), drakes.contact(*pose)
        if mine.polygons == 0 and theirs is None:
            continue
        if mine.back_faces > 0:
            row.filtered += 1
            continue
        row.poses += 1
        if theirs is None or mine.polygons == 0:
            row.area = row.force = row.centroid = float("inf")
            continue
        row.area = max(row.area, abs(mine.area - theirs.area) / theirs.area)
        row.force = max(row.force, np.linalg.norm(np.array(mine.force) - theirs.force) / np.linalg.norm(theirs.force))
        apart = np.linalg.norm(np.array(mine.centroid) - theirs.centroid)
        row.centroid = max(row.centroid, apart / theirs.area**0.5)
    return row


def run(library, folder):
    pairs = [(soft, other, modulus) for modulus in (0, OTHER_MODULUS) for soft in SOFT for other in OTHER]
    return [compare(library, folder, *pair, seed) for seed, pair in enumerate(pairs)]
