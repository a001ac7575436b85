#include "core/mesh/repair/wrap/wrap_field.h"

#include <fmt/format.h>

#include "core/base/parallel.h"
#include "core/mesh/query/point_triangle.h"

namespace taxel {
namespace {

constexpr double kReach = 2;  // edges around the faces in which distances are exact

TriMeshPtr mesh_of(const Draft& draft, const std::vector<int>& faces) {
  std::vector<ivec3> chosen;
  for (const int f : faces) chosen.push_back(draft.faces[at(f)]);
  std::vector<dvec3> points = draft.points;
  Draft part{std::move(points), std::move(chosen), std::vector<int>(faces.size(), 0)};
  drop_unused_points(part);
  return std::make_shared<const TriMesh>(std::move(part.points), std::move(part.faces));
}

}  // namespace

WrapField::WrapField(const Draft& draft, const std::vector<int>& faces, WrapKind kind, const RepairLimits& limits)
    : kind_(kind), edge_(limits.edge), thickness_(limits.thickness) {
  index_ = std::make_unique<MeshIndex>(mesh_of(draft, faces));
  const TriMesh& mesh = index_->mesh();
  const double margin = kReach * edge_ + (kind == WrapKind::solid ? 0 : thickness_);
  bounds_.include(mesh.bounds().lo - margin);
  bounds_.include(mesh.bounds().hi + margin);
  check_lattice();
  if (kind == WrapKind::solid) {
    winding_ = std::make_unique<WindingNumber>(mesh.vertices(), mesh.faces());
    classify_cells();
    return;
  }
  is_rim_.assign(3 * mesh.faces().size(), 0);
  std::vector<Aabb> boxes;
  const EdgeTopology& edges = mesh.topology();
  for (const std::span<const int> edge : edges.edges_of(EdgeKind::boundary)) {
    is_rim_[at(edge[0])] = 1;
    rim_.emplace_back(mesh.vertices()[at(edges.low(edge[0]))], mesh.vertices()[at(edges.high(edge[0]))]);
    boxes.emplace_back();
    boxes.back().include(rim_.back().first);
    boxes.back().include(rim_.back().second);
  }
  rim_tree_.build(boxes);
}

/// The lattice of a wrap has two nodes per cube of one edge.
void WrapField::check_lattice() const {
  constexpr double kMaxNodes = 5e7;
  const dvec3 cells = bounds_.extent() / edge_;
  const double nodes = 2 * cells.x * cells.y * cells.z;
  if (nodes <= kMaxNodes) return;
  throw Error("", "/mesh/repair/edge",
              fmt::format("must be at least {:.2g} to wrap a mesh of this size, is {}",
                          1.1 * edge_ * std::cbrt(nodes / kMaxNodes), edge_));
}

/// Cells near faces are evaluated point by point, and so are cells with a fractional winding number near a hole. For
/// all other cells one winding number decides.
void WrapField::classify_cells() {
  constexpr double kCellEdges = 4;
  constexpr double kWhole = 0.1;  // largest distance of the winding number from a whole number
  width_ = kCellEdges * edge_;
  counts_ = ivec3(glm::ceil(bounds_.extent() / width_));
  cells_.assign(at(counts_.x) * at(counts_.y) * at(counts_.z), Cell::uncertain);
  for (int f = 0; f < index_->mesh().face_count(); ++f) mark_near(f);
  parallel_chunks(counts_.z, 1, [&](int begin, int end) {
    for (int z = begin; z < end; ++z) {
      for (int y = 0; y < counts_.y; ++y) {
        for (int x = 0; x < counts_.x; ++x) {
          Cell& cell = cells_[cell_index({x, y, z})];
          if (cell == Cell::near_faces) continue;
          const double winding = (*winding_)(cell_center({x, y, z}));
          if (std::abs(winding - std::round(winding)) <= kWhole) cell = winding > 0.5 ? Cell::inside : Cell::outside;
        }
      }
    }
  });
}

void WrapField::mark_near(int face) {
  const TriMesh& mesh = index_->mesh();
  Aabb box;
  for (int c = 0; c < 3; ++c) box.include(mesh.vertex(face, c));
  const double reach = kReach * edge_ + 0.5 * std::sqrt(3.0) * width_;
  const ivec3 low = glm::max(ivec3(glm::floor((box.lo - reach - bounds_.lo) / width_)), ivec3(0));
  const ivec3 high = glm::min(ivec3(glm::floor((box.hi + reach - bounds_.lo) / width_)), counts_ - 1);
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        Cell& cell = cells_[cell_index({x, y, z})];
        if (cell == Cell::near_faces) continue;
        const TrianglePoint nearest = nearest_on_triangle(cell_center({x, y, z}), mesh.vertex(face, 0),
                                                          mesh.vertex(face, 1), mesh.vertex(face, 2));
        if (nearest.squared_distance <= reach * reach) cell = Cell::near_faces;
      }
    }
  }
}

double WrapField::operator()(const dvec3& p) const {
  return kind_ == WrapKind::solid ? solid_distance(p) : sheet_distance(p);
}

double WrapField::solid_distance(const dvec3& p) const {
  const double far = kReach * edge_;
  const ivec3 cell(glm::floor((p - bounds_.lo) / width_));
  if (glm::any(glm::lessThan(cell, ivec3(0))) || glm::any(glm::greaterThanEqual(cell, counts_))) return far;
  const Cell kind = cells_[cell_index(cell)];
  if (kind == Cell::inside) return -far;
  if (kind == Cell::outside) return far;
  const double sign = (*winding_)(p) > 0.5 ? -1 : 1;
  if (kind == Cell::uncertain) return sign * far;
  const SurfacePoint nearest = index_->closest_point(p, far);
  return sign * (nearest.face >= 0 ? nearest.distance : far);
}

/// Distance from a point of the sheet to its rim, at most two edges.
double WrapField::rim_distance(const dvec3& p) const {
  double least = kReach * edge_;
  Aabb near_box;
  near_box.include(p - least);
  near_box.include(p + least);
  rim_tree_.visit([&](const Aabb& box) { return box.overlaps(near_box); },
                  [&](int i) {
                    dvec3 nearest;
                    nearest_on_segment(p, rim_[at(i)].first, rim_[at(i)].second, nearest);
                    least = std::min(least, glm::distance(p, nearest));
                  });
  return least;
}

/// Behind the faces down to the thickness, and nothing beyond the rim: the body ends there in a wall at right angles to
/// the sheet.
double WrapField::sheet_distance(const dvec3& p) const {
  const double far = thickness_ + kReach * edge_;
  const SurfacePoint nearest = index_->closest_point(p, far);
  if (nearest.face < 0) return far;
  const dvec3 normal = index_->mesh().face_normals()[at(nearest.face)];
  const dvec3 offset = p - nearest.position;
  const double height = glm::dot(offset, normal);
  const double across = kind_ == WrapKind::two_sided_sheet ? nearest.distance - 0.5 * thickness_
                                                           : std::max(height, nearest.distance - thickness_);
  bool on_rim = false;
  for (int c = 0; c < 3; ++c)
    on_rim = on_rim || (is_rim_[at(3 * nearest.face + c)] != 0 && nearest.barycentric[(c + 2) % 3] == 0);
  return std::max(across, on_rim ? glm::length(offset - height * normal) : -rim_distance(nearest.position));
}

}  // namespace taxel
