"""Drake's kernel, through pydrake's SceneGraph: one pair of bodies at given poses."""
import time

import numpy as np
from pydrake.common.eigen_geometry import Quaternion
from pydrake.geometry import (AddCompliantHydroelasticProperties, AddCompliantHydroelasticPropertiesForHalfSpace,
                              AddRigidHydroelasticProperties, Box, Capsule, Cylinder, Ellipsoid, FramePoseVector,
                              GeometryFrame, GeometryInstance, HalfSpace, HydroelasticContactRepresentation, Mesh,
                              ProximityProperties, SceneGraph, Sphere)
from pydrake.math import RigidTransform


def shape(kind, size=(), file=""):
    """Drake's shape for the names and sizes of MuJoCo, which counts halves."""
    if kind == "plane":
        return HalfSpace()
    if kind == "sphere":
        return Sphere(size[0])
    if kind == "box":
        return Box(*(2 * s for s in size))
    if kind == "capsule":
        return Capsule(size[0], 2 * size[1])
    if kind == "cylinder":
        return Cylinder(size[0], 2 * size[1])
    if kind == "ellipsoid":
        return Ellipsoid(*size)
    return Mesh(str(file))


def rigid(resolution=1.0):
    properties = ProximityProperties()
    AddRigidHydroelasticProperties(resolution, properties)
    return properties


def compliant(modulus, resolution=1.0):
    properties = ProximityProperties()
    AddCompliantHydroelasticProperties(resolution, modulus, properties)
    return properties


def compliant_half_space(modulus, thickness):
    properties = ProximityProperties()
    AddCompliantHydroelasticPropertiesForHalfSpace(thickness, modulus, properties)
    return properties


def transform(pose):
    return RigidTransform(Quaternion(np.asarray(pose[3:])), np.asarray(pose[:3]))


class Contact:
    """As taxel_peer.Contact: world frame, force on A, centroid of the area."""

    def __init__(self, surface, a_is_M):
        self.polygons = surface.num_faces()
        self.area = surface.total_area()
        self.centroid = np.array(surface.centroid())
        mesh, field = surface.poly_mesh_W(), surface.poly_e_MN()
        force, moment, total = np.zeros(3), np.zeros(3), 0.0
        for f in range(self.polygons):
            # pressure is linear on a polygon, so its integral is the area times the value at the centroid
            at = surface.centroid(f)
            load = field.EvaluateCartesian(f, at) * surface.area(f)
            force += load * np.asarray(surface.face_normal(f))  # from N into M
            moment += load * np.asarray(at)
            total += load
        self.force = force if a_is_M else -force
        self.max_pressure = max(field.EvaluateAtVertex(v) for v in range(mesh.num_vertices()))


class Pair:
    def __init__(self, a, a_properties, b, b_properties):
        self.scene = SceneGraph()
        self.source = self.scene.RegisterSource("bench")
        self.frames, self.ids = [], []
        for name, body, properties in (("a", a, a_properties), ("b", b, b_properties)):
            frame = self.scene.RegisterFrame(self.source, GeometryFrame(name))
            geometry = self.scene.RegisterGeometry(self.source, frame, GeometryInstance(RigidTransform(), body, name))
            self.scene.AssignRole(self.source, geometry, properties)
            self.frames.append(frame)
            self.ids.append(geometry)
        self.context = self.scene.CreateDefaultContext()

    def mesh(self, number):
        """The tets (or triangles) that Drake made of body 0 or 1, None for a half-space."""
        return self.scene.model_inspector().maybe_get_hydroelastic_mesh(self.ids[number])

    def place(self, X_WA, X_WB):
        """The query at these poses, with everything that depends on poses alone evaluated."""
        poses = FramePoseVector()
        poses.set_value(self.frames[0], transform(X_WA))
        poses.set_value(self.frames[1], transform(X_WB))
        self.scene.get_source_pose_port(self.source).FixValue(self.context, poses)
        query = self.scene.get_query_output_port().Eval(self.context)
        surfaces(query)
        return query

    def contact(self, X_WA, X_WB):
        """None where nothing touches."""
        found = surfaces(self.place(X_WA, X_WB))
        return Contact(found[0], found[0].id_M() == self.ids[0]) if found else None


def surfaces(query):
    return query.ComputeContactSurfaces(HydroelasticContactRepresentation.kPolygon)


def nanoseconds(query, repeat=1):
    """Of the fastest of some calls, the interpreter's part included (see overhead in compare.py)."""
    best = float("inf")
    for _ in range(repeat):
        start = time.perf_counter_ns()
        result = query.ComputeContactSurfaces(HydroelasticContactRepresentation.kPolygon)
        best = min(best, time.perf_counter_ns() - start)
        del result  # freed outside of the measured time
    return best
