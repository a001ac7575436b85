#include "core/mesh/repair/steps/solid.h"

namespace taxel {

manifold::Manifold make_solid(const Draft& draft, const std::vector<int>& faces, SolidFaces kind) {
  manifold::MeshGL64 mesh;
  std::vector<int> points;
  for (const int f : faces)
    for (int c = 0; c < 3; ++c) points.push_back(draft.faces[at(f)][c]);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const int v : points) {
    const dvec3& p = draft.points[at(v)];
    mesh.vertProperties.insert(mesh.vertProperties.end(), {p.x, p.y, p.z});
  }
  using Index = decltype(mesh.triVerts)::value_type;
  for (const int f : faces) {
    ivec3 face = draft.faces[at(f)];
    if (kind == SolidFaces::inside_out) std::swap(face.y, face.z);
    for (int c = 0; c < 3; ++c)
      mesh.triVerts.push_back(
          static_cast<Index>(std::lower_bound(points.begin(), points.end(), face[c]) - points.begin()));
    if (kind != SolidFaces::mergeable) mesh.faceID.push_back(static_cast<Index>(f));
  }
  mesh.runOriginalID.push_back(manifold::Manifold::ReserveIDs(1));
  mesh.runIndex = {0, static_cast<Index>(mesh.triVerts.size())};
  return manifold::Manifold(mesh);
}

namespace {

template <class LoadedOf>
void append(Draft& draft, const manifold::Manifold& solid, const LoadedOf& loaded_of) {
  const manifold::MeshGL64 mesh = solid.GetMeshGL64();
  const int first = draft.point_count();
  const auto points = static_cast<std::size_t>(mesh.NumVert());
  std::vector<int> number(points);
  for (std::size_t v = 0; v < points; ++v) {
    number[v] = first + static_cast<int>(v);
    const auto p = mesh.GetVertPos(v);
    draft.points.emplace_back(p.x, p.y, p.z);
  }
  for (std::size_t i = 0; i < mesh.mergeFromVert.size(); ++i)
    number[mesh.mergeFromVert[i]] = number[mesh.mergeToVert[i]];
  for (std::size_t t = 0; t < static_cast<std::size_t>(mesh.NumTri()); ++t) {
    const ivec3 face(number[mesh.triVerts[3 * t]], number[mesh.triVerts[3 * t + 1]], number[mesh.triVerts[3 * t + 2]]);
    draft.add(face, loaded_of(static_cast<std::size_t>(mesh.faceID[t])));
  }
}

}  // namespace

void append_solid(Draft& draft, const manifold::Manifold& solid, const std::vector<int>& source_loaded) {
  append(draft, solid, [&](std::size_t number) { return source_loaded[number]; });
}

void append_wrapped(Draft& draft, const manifold::Manifold& solid) {
  append(draft, solid, [](std::size_t) { return kWrappedFace; });
}

}  // namespace taxel
