#include "core/mesh/topology/subdivide.h"

#include <fmt/format.h>

#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include "core/base/error.h"
#include "core/mesh/topology/half_edge_mesh.h"

namespace taxel {

TriMesh subdivide(const TriMesh& mesh, int times, SubdivisionScheme scheme) {
  if (times < 1) throw Error("", "", fmt::format("must be subdivided 1 time or more, asked for are {}", times));
  double faces = mesh.face_count();
  for (int i = 0; i < times && faces <= static_cast<double>(kMaxSubdividedFaces); ++i) faces *= 4;
  if (faces > static_cast<double>(kMaxSubdividedFaces))
    throw Error("", "",
                fmt::format("has {} faces: subdivided {} times it has more than {}", mesh.face_count(), times,
                            kMaxSubdividedFaces));
  HalfEdgeMesh half_edges = to_half_edges(mesh);
  OpenMesh::Subdivider::Uniform::LoopT<HalfEdgeMesh, double> splitter;
  splitter.attach(half_edges);
  // Without moved vertices Loop's split is the midpoint scheme.
  splitter(static_cast<std::size_t>(times), scheme == SubdivisionScheme::loop);
  splitter.detach();
  half_edges.garbage_collection();
  return from_half_edges(half_edges);
}

}  // namespace taxel
