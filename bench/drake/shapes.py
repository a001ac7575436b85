"""Meshes that both sides get, in every bit the same; and the files that carry them."""
import numpy as np


def subdivided(vertices, faces, times):
    """Every triangle into four, new vertices on the unit sphere."""
    vertices = [np.asarray(v, dtype=float) / np.linalg.norm(v) for v in vertices]
    for _ in range(times):
        middle_of, finer = {}, []

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle_of:
                m = vertices[i] + vertices[j]
                middle_of[key] = len(vertices)
                vertices.append(m / np.linalg.norm(m))
            return middle_of[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        faces = finer
    return np.array(vertices), np.array(faces)


def octahedral_sphere(times):
    """8 * 4^n triangles."""
    x = np.eye(3)
    corners = [x[0], x[1], -x[0], -x[1], x[2], -x[2]]
    faces = [(i, (i + 1) % 4, 4) for i in range(4)] + [((i + 1) % 4, i, 5) for i in range(4)]
    return subdivided(corners, faces, times)


def icosphere(times):
    """20 * 4^n triangles."""
    g = (1 + 5**0.5) / 2
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
               (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    return subdivided(corners, faces, times)


def star(vertices, faces):
    """Tets from the origin to every face; the last vertex is the origin."""
    apex = len(vertices)
    tets = [(a, c, b, apex) for a, b, c in faces]
    return np.vstack([vertices, np.zeros((1, 3))]), np.array(tets)


def boundary_vertices(tets):
    """Vertices of faces that belong to one tet alone."""
    count = {}
    for tet in tets:
        for skip in range(4):
            face = tuple(sorted(int(v) for i, v in enumerate(tet) if i != skip))
            count[face] = count.get(face, 0) + 1
    return {v for face, n in count.items() if n == 1 for v in face}


def write_obj(path, vertices, faces):
    lines = ["v {!r} {!r} {!r}".format(*(float(c) for c in v)) for v in vertices]
    lines += ["f {} {} {}".format(*(int(i) + 1 for i in f)) for f in faces]
    path.write_text("\n".join(lines) + "\n")


def write_vtk(path, vertices, tets, pressure=None):
    """Legacy VTK, ASCII, every bit of every number; pressures [Pa] as point data, which we read and Drake passes over."""
    lines = ["# vtk DataFile Version 3.0", "tets of the contact bench", "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(vertices)} double"]
    lines += ["{!r} {!r} {!r}".format(*(float(c) for c in v)) for v in vertices]
    lines += [f"CELLS {len(tets)} {5 * len(tets)}"]
    lines += ["4 {} {} {} {}".format(*(int(i) for i in t)) for t in tets]
    lines += [f"CELL_TYPES {len(tets)}"] + ["10"] * len(tets)
    if pressure is not None:
        lines += [f"POINT_DATA {len(vertices)}", "SCALARS pressure double 1", "LOOKUP_TABLE default"]
        lines += [repr(float(p)) for p in pressure]
    path.write_text("\n".join(lines) + "\n")
