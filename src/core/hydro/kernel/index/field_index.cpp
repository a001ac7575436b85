#include "core/hydro/kernel/index/field_index.h"

#include <algorithm>
#include <tuple>

namespace taxel {
namespace {

PackedTet packed(const PressureField& field, const Tet& tet) {
  PackedTet out;
  for (std::size_t i = 0; i < 4; ++i) {
    const int corner = static_cast<int>(i);
    out.nx[i] = tet.normal[i].x;
    out.ny[i] = tet.normal[i].y;
    out.nz[i] = tet.normal[i].z;
    out.offset[i] = tet.offset[i];
    out.neighbour[i] = tet.neighbour[corner];
    if (field.report().core && tet.neighbour[corner] < 0 && !field.is_skin(tet, corner)) out.core_faces |= 1u << i;
  }
  out.gradient = {tet.gradient.x, tet.gradient.y, tet.gradient.z};
  out.constant = tet.constant;
  out.size = tet.size;
  return out;
}

}  // namespace

FieldIndex::FieldIndex(PressureFieldPtr field_ptr, const TriMesh* skin)
    : field_(std::move(field_ptr)), grid_(*field_), goes_on_(skin != nullptr) {
  if (skin != nullptr) grid_.mark_core(*field_, *skin);
  const PressureField& field = *field_;
  std::vector<Aabb> boxes;
  boxes.reserve(field.tets().size());
  tets_.reserve(field.tets().size());
  for (const Tet& tet : field.tets()) {
    tets_.push_back(packed(field, tet));
    mean_tet_size_ += tet.size;
    Aabb& box = boxes.emplace_back();
    for (int i = 0; i < 4; ++i) box.include(field.vertices()[static_cast<std::size_t>(tet.vertices[i])]);
  }
  if (!tets_.empty()) mean_tet_size_ /= static_cast<double>(tets_.size());
  tree_ = WideBvh(boxes);
  index_boundary();
}

void FieldIndex::index_boundary() {
  std::vector<Aabb> boxes;
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    for (int face = 0; face < 4; ++face) {
      if (tets_[t].neighbour[static_cast<std::size_t>(face)] >= 0) continue;
      const bool skin = field_->is_skin(field_->tets()[t], face);
      ends_inside_ = ends_inside_ || !skin;
      BoundaryFace boundary{{}, static_cast<std::int32_t>(t), face, skin};
      Aabb& box = boxes.emplace_back();
      std::size_t k = 0;
      for (int i = 0; i < 4; ++i) {
        if (i == face) continue;
        boundary.vertices[k] = field_->tets()[t].vertices[i];
        box.include(vertex(boundary.vertices[k++]));
      }
      boundary_faces_.push_back(boundary);
    }
  }
  boundary_tree_ = WideBvh(boxes);
  convex_ = !ends_inside_ && boundary_is_convex();
}

/// A closed surface of one piece without handles (Euler: V - E + F = 2) that bends inward at no edge. Then the grid
/// learns its faces.
bool FieldIndex::boundary_is_convex() {
  constexpr double kFlat = 1e-9;  // rounding error of coplanar faces, as a fraction of the tet's size
  struct Side {
    std::int32_t low, high, face, opposite, edge;
  };
  std::vector<DistanceGrid::Face> faces;
  std::vector<Side> sides;
  std::vector<char> is_used(field_->vertices().size(), 0);
  std::ptrdiff_t vertices = 0;
  for (std::size_t f = 0; f < boundary_faces_.size(); ++f) {
    const auto& [v, t, side, skin] = boundary_faces_[f];
    const PackedTet& tet = tets_[static_cast<std::size_t>(t)];
    const auto i = static_cast<std::size_t>(side);
    faces.push_back({{tet.nx[i], tet.ny[i], tet.nz[i]}, tet.offset[i], t, side});
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int32_t a = v[c], b = v[(c + 1) % 3];
      sides.push_back(
          {std::min(a, b), std::max(a, b), static_cast<std::int32_t>(f), v[(c + 2) % 3], static_cast<std::int32_t>(c)});
      vertices += is_used[static_cast<std::size_t>(a)] == 0 ? 1 : 0;
      is_used[static_cast<std::size_t>(a)] = 1;
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  const auto bends_inward = [&](const Side& at, const Side& other) {
    const DistanceGrid::Face& face = faces[static_cast<std::size_t>(at.face)];
    const double size = tets_[static_cast<std::size_t>(face.tet)].size;
    return glm::dot(face.n, vertex(other.opposite)) + face.offset < -kFlat * size;
  };
  if (sides.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Side &a = sides[i], &b = sides[i + 1];
    const bool shared = a.low == b.low && a.high == b.high;
    const bool third = i + 2 < sides.size() && sides[i + 2].low == a.low && sides[i + 2].high == a.high;
    if (!shared || third || bends_inward(a, b)) return false;
    faces[static_cast<std::size_t>(a.face)].neighbours[static_cast<std::size_t>(a.edge)] = b.face;
    faces[static_cast<std::size_t>(b.face)].neighbours[static_cast<std::size_t>(b.edge)] = a.face;
  }
  const auto edges = static_cast<std::ptrdiff_t>(sides.size() / 2);
  if (vertices - edges + static_cast<std::ptrdiff_t>(faces.size()) != 2) return false;
  grid_.set_faces(std::move(faces));
  return true;
}

}  // namespace taxel
