// Pressures at the vertices of a pad.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_layers.h"

namespace taxel {

/// min(depth, most) of a point inside the mesh: cheap, since only the skin that near is looked at.
double depth_inside(const MeshIndex& index, const dvec3& x, double most);

/// Whether the skin nearest to a point inside the mesh is the one at this distance [m] from it, but for three percent:
/// no other part of the skin is nearer.
bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance);

/// Two readings of how deep the inner vertices lie, per leg [m], at most the thickness. They agree but where the skin
/// is concave: there the distance to the skin exceeds the depth below the planes of the faces around.
struct PadDepths {
  std::vector<double> below_skin;
  std::vector<double> below_planes;  ///< area-weighted mean over the faces around, at most below_skin
  std::vector<double> planes;        ///< the same without any limit; the thickness for a leg without faces
};

PadDepths pad_depths(const TriMesh& mesh, const PadShape& shape, double thickness);

/// Legs at which the skin's normals diverge so much that one layer cannot follow: the two depths differ by more than a
/// tenth of the thickness.
std::vector<char> diverging_legs(const PadDepths& depths, double thickness);

/// p = E depth/H at all vertices of a pad: none on the skin. At middle vertices, and at inner ones of legs that have no
/// middle vertex, the depth is that below the planes where this is less: the stiffness at the skin is then E/H. Inner
/// vertices behind a middle one are free of that and take a depth between the two, by which the prisms around hold the
/// distance to the skin best. Cost: a closest-point query per face around these.
std::vector<double> pad_pressures(const MeshIndex& index, const PadShape& shape, const PadLayers& layers,
                                  const PadDepths& depths, double modulus, double thickness);

}  // namespace taxel
