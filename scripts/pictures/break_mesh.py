#!/usr/bin/env python3
"""Breaks a sound OBJ mesh like typical meshes from the web: a hole, a fin and a fold on its +x side.

Usage: break_mesh.py IN.obj OUT.obj
"""
import sys


def main():
    vertices, faces = [], []
    for line in open(sys.argv[1]):
        words = line.split()
        if words and words[0] == "v":
            vertices.append([float(x) for x in words[1:4]])
        elif words and words[0] == "f":
            faces.append([int(w.split("/")[0]) - 1 for w in words[1:4]])

    def distance(face, place):
        middle = [sum(vertices[v][k] for v in face) / 3 for k in range(3)]
        return sum((middle[k] - place[k]) ** 2 for k in range(3)) ** 0.5

    def nearest(place):
        return min(faces, key=lambda face: distance(face, place))

    # The hole: all faces within 2.4 mm of a point on the side are removed.
    faces = [face for face in faces if distance(face, (0.0086, 0.0012, 0.0190)) > 0.0024]
    # The fin: a third face at an edge extends 4 mm out of the skin.
    a, b, _ = nearest((0.0062, -0.0045, 0.0130))
    vertices.append([(p + q) / 2 for p, q in zip(vertices[a], vertices[b])])
    vertices[-1][0] += 0.003
    vertices[-1][1] -= 0.003
    faces.append([a, b, len(vertices) - 1])
    # The fold: two faces are back to back at one edge.
    a, b, _ = nearest((0.0060, 0.0030, 0.0260))
    vertices.append([(p + q) / 2 for p, q in zip(vertices[a], vertices[b])])
    vertices[-1][0] += 0.003
    vertices[-1][2] += 0.002
    faces += [[a, b, len(vertices) - 1], [b, a, len(vertices) - 1]]

    with open(sys.argv[2], "w") as out:
        for v in vertices:
            out.write("v {:.9f} {:.9f} {:.9f}\n".format(*v))
        for f in faces:
            out.write("f {} {} {}\n".format(*(v + 1 for v in f)))


main()
