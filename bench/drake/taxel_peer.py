"""Our kernel, through the C functions of contact_library.cpp."""
import ctypes
import numpy as np

SHAPES = ["plane", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "tets"]  # order of ShapeType
FIELDS = ["pad", "medial_axis", "star", "tets"]  # order of FieldKind


class Contact(ctypes.Structure):
    _fields_ = [("nanoseconds", ctypes.c_double), ("polygons", ctypes.c_double), ("area", ctypes.c_double),
                ("max_pressure", ctypes.c_double), ("force", ctypes.c_double * 3), ("centroid", ctypes.c_double * 3),
                ("pressure_centroid", ctypes.c_double * 3), ("back_faces", ctypes.c_double)]


class Refused(Exception):
    """The kernel, or the maker of a body, says no; the message says why."""


def _numbers(array, kind):
    flat = np.ascontiguousarray(array, dtype=kind)
    return flat, flat.ctypes.data_as(ctypes.c_void_p)


class Library:
    def __init__(self, path):
        self.c = ctypes.CDLL(str(path))
        pointer = ctypes.c_void_p
        self.c.taxel_last_error.restype = ctypes.c_char_p
        for name in ("taxel_shape", "taxel_layout", "taxel_pair"):
            getattr(self.c, name).restype = pointer
        for name in ("taxel_field_size", "taxel_use_instruction_set"):
            getattr(self.c, name).restype = ctypes.c_bool

    def use(self, instruction_set):
        """From here on only this one, such as "AVX2"."""
        if not self.c.taxel_use_instruction_set(instruction_set.encode()):
            raise Refused(f"no instruction set {instruction_set} here")

    def _made(self, body):
        if not body:
            raise Refused(self.c.taxel_last_error().decode())
        return ctypes.c_void_p(body)

    def shape(self, kind, size=(), file="", resolution=0.0, field="medial_axis", modulus=0.0, thickness=0.0):
        _, size_at = _numbers(list(size) + [0.0] * (3 - len(size)), np.float64)
        number = ctypes.c_double
        return self._made(self.c.taxel_shape(SHAPES.index(kind), size_at, str(file).encode(), number(resolution),
                                             FIELDS.index(field), number(modulus), number(thickness)))

    def tets(self, file, modulus):
        """A soft body from a VTK file: its own pressures where it has some, else Drake's rule."""
        return self.shape("tets", file=file, field="tets", modulus=modulus)

    def layout(self, file):
        return self._made(self.c.taxel_layout(str(file).encode()))

    def field(self, body):
        """Vertices (n, 3), tets (m, 4) and pressures (n) of a soft body."""
        n, m = ctypes.c_int(), ctypes.c_int()
        if not self.c.taxel_field_size(body, ctypes.byref(n), ctypes.byref(m)):
            raise Refused("no tets: not a soft body")
        x, t, p = np.empty((n.value, 3)), np.empty((m.value, 4), dtype=np.int32), np.empty(n.value)
        self.c.taxel_field(body, *(a.ctypes.data_as(ctypes.c_void_p) for a in (x, t, p)))
        return x, t, p

    def pair(self, a, b, all_faces=False):
        """Where `all_faces`, those that oppose the pressure count too, as they do by brute force."""
        return Pair(self, ctypes.c_void_p(self.c.taxel_pair(a, b, ctypes.c_bool(all_faces))))


class Pair:
    def __init__(self, library, handle):
        self.library, self.handle = library, handle

    def contact(self, X_WA, X_WB, repeat=1):
        """Poses are 7 numbers, x y z w x y z. The time is that of the fastest repetition, measured in C++."""
        return self._call(self.library.c.taxel_contact, X_WA, X_WB, repeat)

    def brute_force(self, X_WA, X_WB):
        """Every tet against every triangle or tet: time, polygons, area and force."""
        return self._call(self.library.c.taxel_brute_force, X_WA, X_WB)

    def _call(self, function, X_WA, X_WB, *numbers):
        out = Contact()
        a, a_at = _numbers(X_WA, np.float64)
        b, b_at = _numbers(X_WB, np.float64)
        if function(self.handle, a_at, b_at, *numbers, ctypes.byref(out)) != 0:
            raise Refused(self.library.c.taxel_last_error().decode())
        return out
