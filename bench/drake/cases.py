"""The contact classes of the bench: two bodies on both sides, and the paths on which they touch."""
import dataclasses

import numpy as np

import drake_peer
import shapes

MODULUS = 5.0e4  # Pa
SOFT_RADIUS, OTHER_RADIUS = 0.050, 0.040  # m
POSES = 20  # of a path


def about(axis, angle):
    axis = np.asarray(axis, dtype=float)
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * axis / np.linalg.norm(axis))])


def product(q, r):
    w, x, y, z = q
    return np.array([w * r[0] - x * r[1] - y * r[2] - z * r[3], w * r[1] + x * r[0] + y * r[3] - z * r[2],
                     w * r[2] - x * r[3] + y * r[0] + z * r[1], w * r[3] + x * r[2] - y * r[1] + z * r[0]])


def rotation(q):
    w, x, y, z = q
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


@dataclasses.dataclass
class Case:
    name: str
    ours: object       # taxel_peer.Pair
    all_faces: object  # the same pair, in which back faces count
    drakes: object     # drake_peer.Pair
    paths: dict        # name -> list of (X_WA, X_WB)


# Orientations that no symmetry of a tessellation shares.
TURN_A, TURN_B = about((0.3, -0.5, 0.8), 0.7), about((-0.6, 0.2, 0.5), 1.9)


def sphere_paths():
    """Press: deeper and deeper. Slide: around the soft sphere, neither turns. Roll: both turn, without slip."""
    reach = SOFT_RADIUS + OTHER_RADIUS

    def pose(depth, travel, roll):
        angle = travel / SOFT_RADIUS
        place = (reach - depth) * np.array([np.sin(angle), 0.1 * np.sin(angle), np.cos(angle)])
        place *= (reach - depth) / np.linalg.norm(place)
        return (np.array([0, 0, 0, *TURN_A]), np.array([*place, *product(about((0, 1, 0), roll), TURN_B)]))

    travel = np.linspace(0, 0.010, POSES)
    return {"press": [pose(d, 0, 0) for d in np.linspace(0.0005, 0.005, POSES)],
            "slide": [pose(0.004, t, 0) for t in travel],
            "roll": [pose(0.004, t, t / SOFT_RADIUS + t / OTHER_RADIUS) for t in travel]}


class Sphere:
    """A sphere on both sides: soft as the star of its triangles, or rigid."""

    def __init__(self, library, folder, name, mesh, radius, modulus):
        vertices, faces = mesh
        if modulus > 0:
            self.file = folder / f"{name}.vtk"
            x, tets = shapes.star(vertices * radius, faces)
            shapes.write_vtk(self.file, x, tets)
            self.ours = library.tets(self.file, modulus)
            self.properties = drake_peer.compliant(modulus)
        else:
            self.file = folder / f"{name}.obj"
            shapes.write_obj(self.file, vertices * radius, faces)
            self.ours = library.shape("mesh", file=self.file)
            self.properties = drake_peer.rigid()

    def drakes(self):
        return drake_peer.shape("mesh", file=self.file), self.properties


def pair(library, name, a, b, paths):
    return Case(name, library.pair(a.ours, b.ours), library.pair(a.ours, b.ours, all_faces=True),
                drake_peer.Pair(*a.drakes(), *b.drakes()), paths)


def sphere_cases(library, folder):
    meshes = {"2k": shapes.octahedral_sphere(4), "8k": shapes.octahedral_sphere(5), "20k": shapes.icosphere(5)}
    soft = {n: Sphere(library, folder, "soft" + n, meshes[n], SOFT_RADIUS, MODULUS) for n in ("2k", "20k")}
    other = {n: Sphere(library, folder, "other" + n, meshes[n], OTHER_RADIUS, 2 * MODULUS) for n in ("2k", "20k")}
    rigid = {n: Sphere(library, folder, "rigid" + n, meshes[n], OTHER_RADIUS, 0) for n in ("8k", "20k")}
    for tets, triangles in (("2k", "8k"), ("2k", "20k"), ("20k", "20k")):
        yield pair(library, f"soft {tets} tets x rigid {triangles} triangles", soft[tets], rigid[triangles], sphere_paths())
    for tets in ("2k", "20k"):
        yield pair(library, f"soft {tets} x soft {tets} tets", soft[tets], other[tets], sphere_paths())


class Pad:
    """The pad of a layout. Drake takes every vertex of the boundary for skin, so it gets the pad with its core filled by tets to
    one inner point; its modulus makes the pressure in the pad the same, p = (E/H) depth. We get the pad as it is or, where
    `filled`, the very tets that Drake gets, so that both have the same work."""

    def __init__(self, library, folder, layout, thickness, modulus, filled):
        self.ours = library.layout(layout)
        self.vertices, pad, pressure = library.field(self.ours)
        inner = [face for face in boundary_faces(pad) if all(pressure[v] > 0 for v in face)]
        apex = self.vertices[sorted({v for face in inner for v in face})].mean(axis=0)
        x = np.vstack([self.vertices, apex])
        tets = oriented(x, np.vstack([pad, [(*face, len(self.vertices)) for face in inner]]))
        self.file = folder / "filled_pad.vtk"
        shapes.write_vtk(self.file, x, tets)
        skin = [face for face in boundary_faces(pad) if all(pressure[v] == 0 for v in face)]
        at_apex = modulus / thickness * depth_below(self.vertices, skin, apex)
        self.properties = drake_peer.compliant(at_apex)
        if filled:
            self.ours = library.tets(self.file, at_apex)

    def drakes(self):
        return drake_peer.shape("mesh", file=self.file), self.properties


def boundary_faces(tets):
    count = {}
    for tet in tets:
        for skip in range(4):
            face = tuple(int(v) for i, v in enumerate(tet) if i != skip)
            count.setdefault(tuple(sorted(face)), []).append(face)
    return [found[0] for found in count.values() if len(found) == 1]


def oriented(x, tets):
    a, b, c, d = (x[tets[:, i]] for i in range(4))
    flip = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) < 0
    tets = tets.copy()
    tets[flip, 0], tets[flip, 1] = tets[flip, 1], tets[flip, 0].copy()
    return tets


def depth_below(x, faces, point):
    """Distance to the nearest plane of a face: for a convex skin the distance to the skin."""
    a, b, c = (x[[face[i] for face in faces]] for i in range(3))
    n = np.cross(b - a, c - a)
    return np.min(np.abs(np.einsum("ij,ij->i", n, point - a)) / np.linalg.norm(n, axis=1))


class RigidBox:
    def __init__(self, library, half_size):
        self.ours = library.shape("box", half_size)
        self.half_size = half_size

    def drakes(self):
        return drake_peer.shape("box", self.half_size), drake_peer.rigid()


def finger_paths(vertices):
    """The fingertip, tilted so that pad and tip face down, on the edge of a box: pressed, drawn along, and rolled."""
    tilt = about((1, 0, 0), 0.75 * np.pi)

    def pose(depth, travel, roll):
        q = product(about((0, 1, 0), roll), tilt)
        down = (rotation(q) @ vertices.T).T
        low = down[np.argmin(down[:, 2])]
        place = np.array([travel - low[0], -low[1], -low[2] - depth])
        return np.array([*place, *q]), np.array([0, 0.023, -0.025, *about((0, 0, 1), 0.2)])

    return {"press": [pose(d, 0, 0) for d in np.linspace(0.0003, 0.0015, POSES)],
            "slide": [pose(0.001, t, 0) for t in np.linspace(0, 0.008, POSES)],
            "roll": [pose(0.001, 0, r) for r in np.linspace(-0.4, 0.4, POSES)]}


def finger_cases(library, folder, layout, thickness, modulus):
    box = RigidBox(library, (0.025, 0.025, 0.025))
    for filled, name in ((False, "pad finger x box"), (True, "pad finger, core filled, x box")):
        finger = Pad(library, folder, layout, thickness, modulus, filled)
        yield pair(library, name, finger, box, finger_paths(finger.vertices))


class SoftPrimitive:
    """A soft primitive with its medial-axis field. Both sides get its tets, with Drake's rule for their pressures."""

    def __init__(self, library, folder, name, kind, size, modulus, edge):
        made = library.shape(kind, size, resolution=edge, modulus=modulus)
        self.vertices, tets, _ = library.field(made)
        self.file = folder / f"{name}.vtk"
        shapes.write_vtk(self.file, self.vertices, tets)
        self.ours = library.tets(self.file, modulus)
        self.properties = drake_peer.compliant(modulus)

    def drakes(self):
        return drake_peer.shape("mesh", file=self.file), self.properties


class RigidHalfSpace:
    """z <= 0 of its frame."""

    def __init__(self, library):
        self.ours = library.shape("plane")

    def drakes(self):
        return drake_peer.shape("plane"), drake_peer.rigid()


def on_top_paths(vertices, turn, top, deepest, other):
    """A body with the orientation `turn`, its lowest point on the height `top`: pressed, drawn along, and rolled."""

    def pose(depth, travel, roll):
        q = product(about((0, 1, 0), roll), turn)
        low = np.min((rotation(q) @ vertices.T)[2])
        return np.array([travel, 0.0002, top - low - depth, *q]), other

    return {"press": [pose(d, 0, 0) for d in np.linspace(0.1 * deepest, deepest, POSES)],
            "slide": [pose(0.8 * deepest, t, 0) for t in np.linspace(0, 0.004, POSES)],
            "roll": [pose(0.8 * deepest, 0, r) for r in np.linspace(-0.2, 0.2, POSES)]}


LYING = product(about((1, 0, 0), 0.5 * np.pi), about((0, 0, 1), 0.3))


def unequal_cases(library, folder):
    """Two soft bodies with tets of very different sizes, and two of fine and of medium ones."""
    still = np.array([0, 0, 0, 1.0, 0, 0, 0])
    capsule = SoftPrimitive(library, folder, "capsule", "capsule", (0.008, 0.02), MODULUS, 0.0006)
    box = SoftPrimitive(library, folder, "box", "box", (0.03, 0.03, 0.01), 4 * MODULUS, 0.01)
    paths = on_top_paths(capsule.vertices, LYING, 0.01, 0.001, still)
    yield pair(library, "soft fine capsule x soft box, 24 tets", capsule, box, paths)
    yield pair(library, "soft box, 24 tets, x soft fine capsule", box, capsule,
               {name: [(b, a) for a, b in poses] for name, poses in paths.items()})
    fine = SoftPrimitive(library, folder, "ellipsoid", "ellipsoid", (0.012, 0.010, 0.008), MODULUS, 0.0006)
    for edge in (0.0006, 0.0012):
        sphere = SoftPrimitive(library, folder, f"sphere{edge}", "sphere", (0.015,), 2 * MODULUS, edge)
        name = f"soft ellipsoid 0.6 mm x soft sphere {1e3 * edge:.1f} mm"
        yield pair(library, name, fine, sphere, on_top_paths(fine.vertices, TURN_A, 0.015, 0.0015, still))


def half_space_cases(library, folder):
    """Rigid ones: Drake has no contact of soft ones with soft bodies."""
    ground = np.array([0, 0, 0, *about((0, 0, 1), 0.2)])
    for edge in (0.0006, 0.0015):
        sphere = SoftPrimitive(library, folder, f"ball{edge}", "sphere", (0.02,), MODULUS, edge)
        yield pair(library, f"soft sphere {1e3 * edge:.1f} mm x rigid half-space", sphere, RigidHalfSpace(library),
                   on_top_paths(sphere.vertices, TURN_A, 0, 0.003, ground))
