// The sides of faces, patch by patch, and the signed distance to the body that they are made into.
//
// The winding number says which places are inside even where faces cross, repeat or end, but it is expensive, and one
// face of a broken mesh can be wrong. So it is asked as rarely as possible:
//
// 1. Cells of two edges that no face is near have one winding number each; if the mesh is closed, one for each
//    connected region of such cells.
// 2. Near faces, the nearest face gives distance and side. A patch of faces between crossings and rims has one answer
//    for each of its two sides: the winding number at some of its faces, without the face itself, is the mean of both
//    sides.
// 3. It is computed point by point only where faces cross or end, and in cells where it is no whole number, next to a
//    hole.
//
// Sheets have no inside: the body is behind the faces down to the thickness, or around them, and ends at the rim in a
// wall at right angles. Distances are exact within two edges of the faces; farther away only the sign is.
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/self_intersection.h"
#include "core/mesh/query/triangle.h"
#include "core/mesh/repair/wrap/wrap.h"

namespace taxel {
namespace {

/// A nonzero entry for each face that crosses another one or has a corner at an edge where the surface ends.
std::vector<char> find_unknown(const TriMesh& mesh, std::vector<char> crosses) {
  std::vector<char> unknown = std::move(crosses), ends(mesh.vertices().size(), 0);
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h)
    if (edges.twin(h) < 0) ends[at(edges.from(h))] = ends[at(edges.to(h))] = 1;
  for (int f = 0; f < mesh.face_count(); ++f)
    for (int c = 0; c < 3; ++c)
      if (ends[at(mesh.faces()[at(f)][c])] != 0) unknown[at(f)] = 1;
  return unknown;
}

}  // namespace

FaceSideFinder::FaceSideFinder(const TriMesh& mesh, std::vector<char> crosses, const WindingNumber& winding)
    : mesh_(mesh), winding_(winding), patch_of_face_(mesh.faces().size(), -1) {
  const std::vector<char> unknown = find_unknown(mesh, std::move(crosses));
  DisjointSets sets(mesh.faces().size());
  const EdgeTopology& edges = mesh.topology();
  for (int h = 0; h < edges.half_edge_count(); ++h) {
    const int other = edges.face_across(h);
    if (other >= 0 && unknown[at(h / 3)] == 0 && unknown[at(other)] == 0) sets.unite(h / 3, other);
  }
  for (int f = 0; f < mesh.face_count(); ++f) {
    if (unknown[at(f)] != 0) continue;
    const int first = sets.find(f);
    if (first == f) patches_.emplace_back();
    patch_of_face_[at(f)] = first == f ? static_cast<int>(patches_.size()) - 1 : patch_of_face_[at(first)];
    patches_[at(patch_of_face_[at(f)])].push_back(f);
  }
  sides_.resize(patches_.size());
}

FaceSides FaceSideFinder::sides_of(int face) {
  const int patch = patch_of_face_[at(face)];
  if (patch < 0) return FaceSides::unknown;
  if (!sides_[at(patch)]) sides_[at(patch)] = sides_of_patch(patches_[at(patch)]);
  return *sides_[at(patch)];
}

/// Around a face, without itself, faces wind by the mean of both sides: half more is inside, half less outside.
FaceSides FaceSideFinder::sides_of_patch(const std::vector<int>& patch) const {
  constexpr int kMaxFaces = 8;  // evaluated faces of a patch with rims
  constexpr double kMargin = 0.3;
  const int count = mesh_.closed() ? 1 : std::min(kMaxFaces, static_cast<int>(patch.size()));
  double mean = 0;
  for (int i = 0; i < count; ++i) {
    const int f = patch[patch.size() * (2 * at(i) + 1) / (2 * at(count))];
    const dvec3 center = (mesh_.vertex(f, 0) + mesh_.vertex(f, 1) + mesh_.vertex(f, 2)) / 3.0;
    mean += winding_.without(center, f) / count;
  }
  const double inner = mean + 0.5, outer = mean - 0.5;
  if (outer > 0.5 + kMargin) return FaceSides::both_inside;
  if (inner < 0.5 - kMargin) return FaceSides::both_outside;
  return inner > 0.5 + kMargin && outer < 0.5 - kMargin ? FaceSides::skin : FaceSides::unknown;
}

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

/// Returns true only if p is farther than `reach` from the box, by more than rounding.
bool is_beyond(const Aabb& box, const dvec3& p, double reach) {
  constexpr double kRounding = 1 + 1e-9;
  const dvec3 outside = glm::max(glm::max(box.lo - p, p - box.hi), dvec3(0));
  return glm::dot(outside, outside) > kRounding * reach * reach;
}

}  // namespace

WrapField::WrapField(const Draft& draft, const std::vector<int>& faces, WrapKind kind, const RepairLimits& limits)
    : kind_(kind), edge_(limits.edge), thickness_(limits.thickness) {
  index_ = std::make_unique<MeshIndex>(mesh_of(draft, faces));
  nearest_ = std::make_unique<NearestInTurn>(*index_);
  const TriMesh& mesh = index_->mesh();
  const double margin = kReach * edge_ + (kind == WrapKind::solid ? 0 : thickness_);
  bounds_.include(mesh.bounds().lo - margin);
  bounds_.include(mesh.bounds().hi + margin);
  std::vector<char> crosses = find_crossings();
  if (kind == WrapKind::solid) {
    winding_ = std::make_unique<WindingNumber>(mesh.vertices(), mesh.faces());
    sides_ = std::make_unique<FaceSideFinder>(mesh, std::move(crosses), *winding_);
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

/// Sets crossing_count_ and returns a nonzero entry for each face that crosses another one. A list of all pairs would
/// take long if there are many.
std::vector<char> WrapField::find_crossings() {
  constexpr std::size_t kManyPairs = 2000, kFacesOfAPair = 8;
  const TriMesh& mesh = index_->mesh();
  const std::size_t most = std::max(kManyPairs, mesh.faces().size() / kFacesOfAPair);
  const auto pairs = find_crossing_pairs(mesh.vertices(), mesh.faces(), index_->tree(), most);
  crossing_count_ = static_cast<int>(pairs ? pairs->size() : most + 1);
  if (!pairs)
    return find_crossing_faces(mesh.vertices(), mesh.faces(), index_->tree(), std::vector<int>(mesh.faces().size(), 0));
  std::vector<char> crosses(mesh.faces().size(), 0);
  for (const auto& [f, g] : *pairs) crosses[at(f)] = crosses[at(g)] = 1;
  return crosses;
}

/// Cells near faces are evaluated point by point, and so are cells with a fractional winding number near a hole. For
/// all other cells one winding number decides.
void WrapField::classify_cells() {
  constexpr double kCellEdges = 2;
  constexpr double kWhole = 0.1;  // largest distance of the winding number from a whole number
  width_ = kCellEdges * edge_;
  counts_ = ivec3(glm::ceil(bounds_.extent() / width_));
  cells_.assign(at(counts_.x) * at(counts_.y) * at(counts_.z), Cell::uncertain);
  for (int f = 0; f < index_->mesh().face_count(); ++f) mark_near(f);
  if (index_->mesh().closed()) return classify_by_regions();
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

/// Between closed faces the winding number is constant: one for each connected region of cells that no face is near.
void WrapField::classify_by_regions() {
  std::vector<ivec3> front;
  for (int z = 0; z < counts_.z; ++z) {
    for (int y = 0; y < counts_.y; ++y) {
      for (int x = 0; x < counts_.x; ++x) {
        if (cells_[cell_index({x, y, z})] != Cell::uncertain) continue;
        const Cell kind = (*winding_)(cell_center({x, y, z})) > 0.5 ? Cell::inside : Cell::outside;
        const auto reach = [&](const ivec3& c) {
          if (glm::any(glm::lessThan(c, ivec3(0))) || glm::any(glm::greaterThanEqual(c, counts_))) return;
          Cell& cell = cells_[cell_index(c)];
          if (cell != Cell::uncertain) return;
          cell = kind;
          front.push_back(c);
        };
        reach({x, y, z});
        while (!front.empty()) {
          const ivec3 c = front.back();
          front.pop_back();
          for (int axis = 0; axis < 3; ++axis) {
            ivec3 step(0);
            step[axis] = 1;
            reach(c + step);
            reach(c - step);
          }
        }
      }
    }
  }
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
        const dvec3 center = cell_center({x, y, z});
        if (cell == Cell::near_faces || is_beyond(box, center, reach)) continue;
        const TrianglePoint nearest =
            nearest_on_triangle(center, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
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
  if (kind == Cell::uncertain) return (*winding_)(p) > 0.5 ? -far : far;
  const SurfacePoint point = nearest_->closest_point(p);
  const double distance = std::min(point.distance, far);
  const Aabb& box = index_->mesh().bounds();
  if (glm::any(glm::lessThan(p, box.lo)) || glm::any(glm::greaterThan(p, box.hi))) return distance;  // outside for sure
  switch (sides_->sides_of(point.face)) {
    case FaceSides::skin:
      return index_->with_sign(p, point).signed_distance < 0 ? -distance : distance;
    case FaceSides::both_inside:
      return -far;
    case FaceSides::both_outside:
      return far;
    case FaceSides::unknown:
      break;
  }
  return (*winding_)(p) > 0.5 ? -distance : distance;
}

/// Distance from a point of the sheet to its rim, at most `most`.
double WrapField::rim_distance(const dvec3& p, double most) const {
  double least = most;
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
  const SurfacePoint point = nearest_->closest_point(p);
  if (point.distance > far) return far;
  const dvec3 normal = index_->mesh().face_normals()[at(point.face)];
  const dvec3 offset = p - point.position;
  const double height = glm::dot(offset, normal);
  const double across = kind_ == WrapKind::two_sided_sheet ? point.distance - 0.5 * thickness_
                                                           : std::max(height, point.distance - thickness_);
  bool on_rim = false;
  for (int c = 0; c < 3; ++c)
    on_rim = on_rim || (is_rim_[at(3 * point.face + c)] != 0 && point.barycentric[(c + 2) % 3] == 0);
  if (on_rim) return std::max(across, glm::length(offset - height * normal));
  if (across >= 0) return across;
  return std::max(across, -rim_distance(point.position, std::min(kReach * edge_, -across)));
}

}  // namespace taxel
