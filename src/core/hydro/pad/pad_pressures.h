// Computes the pressures at the vertices of a pad.
#pragma once

#include <vector>

#include "core/hydro/pad/pad_layers.h"

namespace taxel {

/// Returns min(depth, most) of a point inside the mesh. Fast, since only skin within the distance `most` is tested.
double depth_inside(const MeshIndex& index, const dvec3& x, double most);

/// Returns true if, within three percent, `distance` [m] is the distance of a point inside the mesh to the nearest
/// skin, so that no other part of the skin is nearer.
bool is_nearest_skin(const MeshIndex& index, const dvec3& x, double distance);

/// Two measures of the depth of the inner vertices, one value per leg [m], at most the thickness. They only differ
/// where the skin is concave: there the distance to the skin exceeds the depth below the planes of the faces around the
/// vertex.
struct PadDepths {
  std::vector<double> below_skin;
  std::vector<double> below_planes;  ///< area-weighted mean over the faces of the leg, at most below_skin
  std::vector<double> planes;        ///< unlimited area-weighted mean; the thickness for a leg without faces
};

PadDepths pad_depths(const TriMesh& mesh, const PadShape& shape, double thickness);

/// Flags the legs at which the normals of the skin diverge too much for one layer: the two depths differ by more than a
/// tenth of the thickness.
std::vector<char> diverging_legs(const PadDepths& depths, double thickness);

/// Returns p = E depth/H at all vertices of a pad; 0 on the skin. At middle vertices, and at inner vertices of legs
/// without a middle vertex, the depth is the smaller of the two measures, so that the stiffness at the skin is E/H. At
/// inner vertices of legs with a middle vertex, the depth is the value between the two measures with which the prisms
/// around the leg approximate the distance to the skin best. Cost: a closest-point query per face around these legs.
std::vector<double> pad_pressures(const MeshIndex& index, const PadShape& shape, const PadLayers& layers,
                                  const PadDepths& depths, double modulus, double thickness);

}  // namespace taxel
