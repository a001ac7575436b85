"""Finite elements of an elastic layer under a rigid ball or a long rigid cylinder.

The layer is linearly elastic. Displacements are quadratic and the pressure field of the mixed form is linear
(Taylor and Hood 1973), so that nothing locks as Poisson's ratio comes near 0.5. One factorisation gives the compliance
of the surface; each contact is then a small complementarity problem of contact pressures that are linear along the
surface. All numbers are in SI units, with E = 1 Pa.
"""
import dataclasses

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as sparse_linalg
import skfem
from skfem.helpers import div, sym_grad, ddot


@dataclasses.dataclass
class Contact:
    """Result of one press. For a cylinder, force is per metre of its length and radius is half the width."""
    force: float
    radius: float
    pressure: np.ndarray


def graded(fine, count, end, ratio):
    """Returns coordinates from 0: `count` equal steps up to `fine`, then steps that grow by `ratio` up to `end`."""
    steps = [fine / count] * count
    while sum(steps) < end:
        steps.append(steps[-1] * ratio)
    at = np.concatenate(([0.0], np.cumsum(steps)))
    at[count + 1:] = fine + (at[count + 1:] - fine) * (end - fine) / (at[-1] - fine)
    return at


class Layer:
    """An elastic layer on a rigid base, fixed to it (`bonded`) or free to slide. `axial` chooses rings, else a strip."""

    def __init__(self, poisson, thickness, bonded, axial, fine, count=120, width=None, rows=14, wall=False):
        self.axial, self.thickness, self.poisson = axial, thickness, poisson
        width = width or fine + 12 * thickness
        across = graded(fine, count, width, 1.25)
        first = min(fine / count, thickness / rows)
        down = graded(first, 1, thickness, 1.25)
        mesh = skfem.MeshQuad.init_tensor(across, np.sort(thickness - down))
        mesh = mesh.with_boundaries({"axis": lambda x: x[0] < 1e-12, "base": lambda x: x[1] < 1e-12,
                                     "top": lambda x: x[1] > thickness * (1 - 1e-9),
                                     "wall": lambda x: x[0] > width * (1 - 1e-9)})
        self.across = across
        u = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
        p = u.with_element(skfem.ElementQuad1())
        shear = 1 / (2 * (1 + poisson))
        first_lame = poisson / ((1 + poisson) * (1 - 2 * poisson))

        def ring(w):  # circumference over 2 pi
            return w.x[0] if axial else 1.0

        def hoop(v, w):  # strain around the axis
            return v.value[0] / w.x[0] if axial else 0.0

        @skfem.BilinearForm
        def stiffness(a, b, w):
            return 2 * shear * (ddot(sym_grad(a), sym_grad(b)) + hoop(a, w) * hoop(b, w)) * ring(w)

        @skfem.BilinearForm
        def coupling(a, q, w):
            return (div(a) + hoop(a, w)) * q * ring(w)

        @skfem.BilinearForm
        def mass(a, b, w):
            return a * b * ring(w)

        k, b, m = stiffness.assemble(u), coupling.assemble(u, p), mass.assemble(p)
        system = sparse.bmat([[k, b.T], [b, -m / first_lame]], format="csc")  # unknowns: u, lambda div u
        fixed = [u.get_dofs("axis").all("u^1"), u.get_dofs("base").all("u^2")]
        if bonded:
            fixed.append(u.get_dofs("base").all("u^1"))
        if wall:
            fixed.append(u.get_dofs("wall").all("u^1"))
        free = np.setdiff1d(np.arange(system.shape[0]), np.unique(np.concatenate(fixed)))
        self._compress(mesh, u, system, free, ring)

    def _compress(self, mesh, u, system, free, ring):
        """Fills the compliance of the surface: weighted deflections by the pressures at the surface's corners."""
        top = u.boundary("top")
        hats = skfem.FacetBasis(mesh, skfem.ElementQuad1(), facets=mesh.boundaries["top"], intorder=5)

        @skfem.BilinearForm
        def load(q, v, w):
            return -q * v[1] * ring(w)

        @skfem.BilinearForm
        def weigh(q, r, w):
            return q * r * ring(w)

        top = skfem.FacetBasis(mesh, u.elem, facets=mesh.boundaries["top"], intorder=5)
        corners = hats.get_dofs("top").all()
        corners = corners[np.argsort(mesh.p[0, corners])]
        loads = load.assemble(hats, top)[:, corners]
        all_loads = sparse.vstack([loads, sparse.csc_matrix((system.shape[0] - loads.shape[0], loads.shape[1]))]).tocsc()
        solved = sparse_linalg.splu(system[free][:, free]).solve(all_loads[free].toarray())
        self.compliance = all_loads[free].T @ solved
        self.weights = weigh.assemble(hats, hats)[corners][:, corners].toarray()  # of pressures, per 2 pi

    def deflection(self, pressure):
        """Returns the mean deflection of the surface under pressures at its corners."""
        ones = np.ones(len(pressure))
        return ones @ self.compliance @ pressure / (ones @ self.weights @ ones)

    def press(self, radius, depth):
        """Presses a rigid ball (or cylinder) of a radius, without friction."""
        inside = self.across < radius
        shape = np.where(inside, radius - np.sqrt(np.maximum(radius ** 2 - np.minimum(self.across, radius) ** 2, 0)), radius)
        wanted = self.weights @ (depth - shape)
        active = self.across ** 2 < 2 * radius * depth
        for _ in range(200):
            pressure = np.zeros(len(self.across))
            pressure[active] = np.linalg.solve(self.compliance[np.ix_(active, active)], wanted[active])
            short = self.compliance @ pressure - wanted  # positive: the surface is clear of the ball
            new = np.where(active, pressure > 0, short < -1e-12 * abs(wanted).max()) & inside
            if (new == active).all():
                break
            active = new
        else:
            raise RuntimeError("the contact did not settle")
        force = (2 * np.pi if self.axial else 2.0) * (np.ones(len(pressure)) @ self.weights @ pressure)
        last = np.flatnonzero(active)[-1]
        return Contact(force, 0.5 * (self.across[last] + self.across[last + 1]), pressure)
