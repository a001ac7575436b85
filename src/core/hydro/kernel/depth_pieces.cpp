#include "core/hydro/kernel/depth_pieces.h"

#include "core/base/index.h"
#include "core/hydro/kernel/plane/plane_pieces.h"

namespace taxel {
namespace {

/// Edges of a facet are 2^kFacetLevels units of the lattice long, the squares of a plane 2^kSquareLevels.
constexpr int kFacetLevels = 24, kSquareLevels = 12;

}  // namespace

void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const FacetTree& rigid,
                      const RigidTransform& X_SR, const DepthPieceSize& size, SurfaceWriter& writer,
                      DepthWorkspace& workspace) {
  constexpr std::int32_t kLeg = 1 << kFacetLevels;
  constexpr LatticeCorner kO{0, 0}, kU{kLeg, 0}, kUV{kLeg, kLeg}, kV{0, kLeg};
  for (const DepthWorkspace::DeepFacet& deep : workspace.facets) {
    const FacetTree::Facet& facet = rigid.facets()[at(deep.facet)];
    std::array<dvec3, 3> x;
    for (std::size_t c = 0; c < 3; ++c) x[c] = X_SR(rigid.vertices()[at(facet.vertex[c])]);
    const dvec3 normal = X_SR.R * facet.normal;
    const LatticePlane plane{writer.triangle(x, normal), normal, facet.face, kLeg};
    PlanePieces pieces(depth, tets, size, plane, writer, workspace);
    pieces.cover(deep.first, deep.last);
    pieces.add(facet.corners == 4 ? LatticePolygon{{kO, kU, kUV, kV}, 4} : LatticePolygon{{kO, kU, kV}, 3},
               kFacetLevels);
  }
}

void add_depth_pieces(const DepthFieldPtr& depth, const FieldIndex& tets, const RigidTransform& X_SR,
                      const DepthPieceSize& size, SurfaceWriter& writer, DepthWorkspace& workspace) {
  constexpr std::int32_t kUnits = 1 << kSquareLevels;
  // Squares are counted from the point of the plane below the middle of the body, which slides along with it.
  const Aabb& body = depth->skin()->bounds();
  const double edge = std::max(2 * depth->thickness(), body.diagonal() / 1024);
  const dvec3 normal = X_SR.R[2], u = edge * X_SR.R[0], v = edge * X_SR.R[1];
  const dvec3 origin = body.center() - glm::dot(body.center() - X_SR.p, normal) * normal;
  dvec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
  for (int corner = 0; corner < 8; ++corner) {
    const dvec3 x((corner & 1) != 0 ? body.hi.x : body.lo.x, (corner & 2) != 0 ? body.hi.y : body.lo.y,
                  (corner & 4) != 0 ? body.hi.z : body.lo.z);
    const dvec2 uv(glm::dot(x - origin, X_SR.R[0]) / edge, glm::dot(x - origin, X_SR.R[1]) / edge);
    lo = glm::min(lo, uv);
    hi = glm::max(hi, uv);
  }
  const LatticePlane plane{writer.triangle({origin, origin + u, origin + v}, normal), normal, -1, kUnits};
  const std::size_t covered = writer.polygon_count();
  PlanePieces pieces(depth, tets, size, plane, writer, workspace);
  pieces.cover(0, covered);
  for (int j = static_cast<int>(std::floor(lo.y)); j < static_cast<int>(std::ceil(hi.y)); ++j) {
    for (int i = static_cast<int>(std::floor(lo.x)); i < static_cast<int>(std::ceil(hi.x)); ++i) {
      const LatticeCorner a{i * kUnits, j * kUnits};
      pieces.add({{a, {a.i + kUnits, a.j}, {a.i + kUnits, a.j + kUnits}, {a.i, a.j + kUnits}}, 4}, kSquareLevels);
    }
  }
}

}  // namespace taxel
