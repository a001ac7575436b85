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
RIGID = {"sphere": (0.04,), "box": (0.03, 0.04, 0.05)}
SOFT_EDGE, RIGID_EDGE = 0.008, 0.010  # m


@dataclasses.dataclass
class Row:
    soft: str
    rigid: str
    tets: int
    poses: int          # that touch and from which Drake's face filter takes nothing
    filtered: int       # that touch and from which it takes something: not compared
    area: float = 0     # largest relative difference over the poses
    force: float = 0    # of the force vector
    centroid: float = 0  # of the area's centroid, relative to the root of the area


def exported(pair, folder, name):
    """Drake's tets as an unscaled VTK file, and their numbers: 0 at the boundary, E at the medial axis."""
    mesh = pair.mesh(0)
    x = np.array(mesh.vertices())
    tets = np.array([[e.vertex(i) for i in range(4)] for e in mesh.tetrahedra()])
    shapes.write_vtk(folder / f"{name}.vtk", x, tets)
    pressure = np.full(len(x), MODULUS)
    pressure[sorted(shapes.boundary_vertices(tets))] = 0
    return x, tets, pressure


def exported_triangles(pair, folder, name):
    mesh = pair.mesh(1)
    path = folder / f"{name}.obj"
    shapes.write_obj(path, np.array(mesh.vertices()), [[t.vertex(i) for i in range(3)] for t in mesh.triangles()])
    return path


def random_pose(rng, x_soft, x_rigid):
    """The rigid body pushed into the soft one from a random side, both at random orientations: 1 to 8 % of the soft one's
    size deep, measured along the line of the centres."""
    turn = [v / np.linalg.norm(v) for v in (rng.standard_normal(4), rng.standard_normal(4))]
    side = rng.standard_normal(3)
    side /= np.linalg.norm(side)
    reach = np.max(x_soft @ rotation(turn[0]).T @ side) - np.min(x_rigid @ rotation(turn[1]).T @ side)
    depth = rng.uniform(0.01, 0.08) * np.ptp(x_soft, axis=0).max()
    offset = rng.uniform(-0.01, 0.01, 3)
    return np.array([*offset, *turn[0]]), np.array([*(offset + side * (reach - depth)), *turn[1]])


def compare(library, folder, soft, rigid, seed):
    drakes = drake_peer.Pair(drake_peer.shape(soft, SOFT[soft]), drake_peer.compliant(MODULUS, SOFT_EDGE),
                             drake_peer.shape(rigid, RIGID[rigid]), drake_peer.rigid(RIGID_EDGE))
    x, tets, pressure = exported(drakes, folder, f"drake_{soft}")
    file = exported_triangles(drakes, folder, f"drake_rigid_{rigid}")
    ours = library.pair(library.tets(x, tets, pressure, MODULUS), library.shape("mesh", file=file))
    row = Row(soft, rigid, len(tets), 0, 0)
    rng = np.random.default_rng(seed)
    x_rigid = np.array(drakes.mesh(1).vertices())
    for _ in range(TRIES):
        if row.poses == POSES:
            break
        pose = random_pose(rng, x, x_rigid)
        mine, theirs = ours.contact(*pose), drakes.contact(*pose)
        if mine.polygons == 0 and theirs is None:
            continue
        if mine.dropped_by_drake > 0:
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
    return [compare(library, folder, soft, rigid, seed)
            for seed, (soft, rigid) in enumerate((s, r) for s in SOFT for r in RIGID)]
