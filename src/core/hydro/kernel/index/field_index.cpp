// The indices of a pressure field that answer the questions of the contact kernel by one look-up: how far is the
// nearest tet, which tet is near, on which side of the body is a point.
//
// - Grid of distances. Each tet marks the cells that it may touch (no plane of the tet has the cell outside), and each
//   marked cell keeps a tet from which a search begins. A separable distance transform, one axis after the other, gives
//   every other cell a lower bound of its distance to the marked ones. Bounds are rounded down, since one that is too
//   large would lose contact.
// - Core. Cells without tets inside of the skin are found by the nonzero winding number along lines of cells. The lines
//   are moved by an irrational part of a cell, so that they practically never pass through an edge, and a line that
//   enters and leaves a different number of faces marks nothing.
// - Gaps. Cells that the skin crosses next to a face of the core may hold a gap between tets that reaches up to the
//   skin.
// - Faces of a convex body. Each cell keeps a plane of the boundary from which it is far outside. The best face of the
//   cells before it is the first guess, and a climb from face to face improves it. Any face would be right; a better
//   one excludes more boxes.
//
// Cost: once per body, for about 32768 to 131072 cells.
#include "core/hydro/kernel/index/field_index.h"

#include <algorithm>
#include <tuple>

#include "core/base/math.h"

namespace taxel {
namespace {

/// Returns true if a cube about `center` may meet the tet: no plane of the tet has it wholly outside.
bool may_meet(const Tet& tet, const dvec3& center, double half_edge) {
  for (std::size_t i = 0; i < 4; ++i) {
    const dvec3& n = tet.normal[i];
    const double reach = half_edge * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    if (glm::dot(n, center) + tet.offset[i] < -reach) return false;
  }
  return true;
}

/// Squared gap, in cells, between two intervals of one cell each that are `steps` apart.
float gap(int steps) {
  const auto g = static_cast<float>(std::max(0, std::abs(steps) - 1));
  return g * g;
}

/// along[i] = min over j of along[j] + gap(i - j): one axis of the separable distance transform.
void spread_line(std::vector<float>& along, std::vector<float>& scratch, const std::vector<float>& gaps) {
  const int n = static_cast<int>(along.size());
  scratch = along;
  for (int j = 0; j < n; ++j) {
    if (scratch[at(j)] == std::numeric_limits<float>::infinity()) continue;
    const float* from = gaps.data() + (n - 1 - j);  // gap(i - j) at i
    for (int i = 0; i < n; ++i) along[at(i)] = std::min(along[at(i)], scratch[at(j)] + from[i]);
  }
}

}  // namespace

DistanceGrid::DistanceGrid(const PressureField& field) {
  constexpr double kCellsPerTet = 16, kFewest = 32768, kMostCells = 131072;
  if (field.tets().empty()) return;
  const double wanted = std::clamp(kCellsPerTet * static_cast<double>(field.tets().size()), kFewest, kMostCells);
  const Aabb& box = field.bounds();
  const dvec3 extent = glm::max(box.extent(), dvec3(1e-3 * box.diagonal()));
  edge_ = std::cbrt(extent.x * extent.y * extent.z / wanted);
  edge_ = std::max(edge_, std::max({extent.x, extent.y, extent.z}) / 256.0);
  per_metre_ = 1.0 / edge_;
  const double margin = 1e-6 * box.diagonal();
  for (int axis = 0; axis < 3; ++axis)
    dims_[axis] = 1 + static_cast<int>(std::floor((extent[axis] + 2 * margin) / edge_));
  low_ = box.center() - 0.5 * edge_ * dvec3(dims_);
  cells_.resize(at(dims_.x) * at(dims_.y) * at(dims_.z));
  mark(field);
}

void DistanceGrid::mark(const PressureField& field) {
  std::vector<char> marked(cells_.size(), 0);
  for (int t = 0; t < static_cast<int>(field.tets().size()); ++t) {
    const Tet& tet = field.tets()[at(t)];
    Aabb box;
    for (int i = 0; i < 4; ++i) box.include(field.vertices()[at(tet.vertices[i])]);
    const ivec3 from(glm::clamp((box.lo - low_) / edge_ - 1e-6, dvec3(0), dvec3(dims_ - 1)));
    const ivec3 to(glm::clamp((box.hi - low_) / edge_ + 1e-6, dvec3(0), dvec3(dims_ - 1)));
    for (int z = from.z; z <= to.z; ++z) {
      for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
          const dvec3 center = low_ + edge_ * (dvec3(x, y, z) + 0.5);
          if (!may_meet(tet, center, 0.500001 * edge_)) continue;
          marked[index(x, y, z)] = 1;
          std::int32_t& near = cells_[index(x, y, z)].tet;
          if (near < 0 || may_meet(tet, center, 0)) near = t;
        }
      }
    }
  }
  spread(marked);
}

/// Counts the crossings of the skin with lines along x, one per row of cells. A cell is inside if more faces were
/// entered than left before it (nonzero winding). Each line passes the middles of its cells, moved by an irrational
/// fraction of a cell, so that it practically never meets an edge or a corner of a face. A line that enters and leaves
/// a different number of faces marks no cell.
void DistanceGrid::mark_core(const PressureField& field, const TriMesh& skin) {
  if (cells_.empty()) return;
  mark_gaps(field, skin);
  const double shift_y = 0.5 + 1e-3 * std::sqrt(2.0), shift_z = 0.5 - 1e-3 * std::sqrt(3.0);
  std::vector<int> turns(cells_.size() + at(dims_.y) * at(dims_.z), 0);  // one more per line: what lies behind it
  const std::size_t stride = at(dims_.x) + 1;
  const auto line_of = [&](int y, int z) { return stride * (at(y) + at(dims_.y) * at(z)); };
  for (int f = 0; f < skin.face_count(); ++f) {
    std::array<dvec3, 3> p;
    for (int c = 0; c < 3; ++c) p[at(c)] = (skin.vertex(f, c) - low_) * per_metre_ - dvec3(0, shift_y, shift_z);
    const double twice = (p[1].y - p[0].y) * (p[2].z - p[0].z) - (p[1].z - p[0].z) * (p[2].y - p[0].y);
    if (twice == 0) continue;
    const auto range = [&](int axis, int& from, int& to) {
      from = std::max(0, static_cast<int>(std::ceil(std::min({p[0][axis], p[1][axis], p[2][axis]}))));
      to = std::min(dims_[axis] - 1, static_cast<int>(std::floor(std::max({p[0][axis], p[1][axis], p[2][axis]}))));
    };
    int y_from = 0, y_to = 0, z_from = 0, z_to = 0;
    range(1, y_from, y_to);
    range(2, z_from, z_to);
    for (int z = z_from; z <= z_to; ++z) {
      for (int y = y_from; y <= y_to; ++y) {
        std::array<double, 3> w;  // twice the areas opposite to the corners, seen along x
        for (std::size_t c = 0; c < 3; ++c) {
          const dvec3 &a = p[(c + 1) % 3], &b = p[(c + 2) % 3];
          w[c] = (a.y - y) * (b.z - z) - (a.z - z) * (b.y - y);
        }
        const bool all_in = twice > 0 ? (w[0] > 0 && w[1] > 0 && w[2] > 0) : (w[0] < 0 && w[1] < 0 && w[2] < 0);
        if (!all_in) continue;
        const double x = (w[0] * p[0].x + w[1] * p[1].x + w[2] * p[2].x) / (w[0] + w[1] + w[2]);
        const int cell = std::clamp(static_cast<int>(std::ceil(x - 0.5)), 0, dims_.x);  // first middle behind the face
        turns[line_of(y, z) + at(cell)] += twice > 0 ? -1 : 1;  // a face that looks along x leads out
      }
    }
  }
  for (int z = 0; z < dims_.z; ++z) {
    for (int y = 0; y < dims_.y; ++y) {
      const int* line = turns.data() + line_of(y, z);
      int sum = 0;
      for (std::size_t x = 0; x < stride; ++x) sum += line[x];
      if (sum != 0) continue;
      for (int x = 0; x < dims_.x; ++x) {
        sum += line[x];
        Cell& cell = cells_[index(x, y, z)];
        const bool is_crossed = (gaps_[index(x, y, z)] & kSkin) != 0;
        if ((sum <= 0 && !is_crossed) || cell.tet >= 0) continue;
        cell.distance = 0;
        cell.tet = kCoreCell;
      }
    }
  }
}

/// A point that no tet holds is found by a walk that leaves the tets by a face of the skin if it is outside, or if it
/// lies in a gap between tets that reaches up to the skin. Only cells that the skin crosses next to a core's face can
/// hold such gaps: where the pad is whole, the core is a thickness away.
void DistanceGrid::mark_gaps(const PressureField& field, const TriMesh& skin) {
  constexpr double kNear = 4;  // cells: a core's face that is deeper than this has no gap at the skin
  gaps_.assign(cells_.size(), 0);
  for (int f = 0; f < skin.face_count(); ++f)
    mark_triangle({skin.vertex(f, 0), skin.vertex(f, 1), skin.vertex(f, 2)}, 0, kSkin);
  if (!field.report().core) return;
  for (const Tet& tet : field.tets()) {
    for (int i = 0; i < 4; ++i) {
      if (tet.neighbour[i] >= 0 || field.is_skin(tet, i)) continue;
      std::array<dvec3, 3> corners;
      double least = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k) {
        corners[at(k)] = field.vertices()[at(tet.vertices[(i + 1 + k) % 4])];
        least = std::min(least, glm::dot(tet.gradient, corners[at(k)]) + tet.constant);
      }
      if (least <= kNear * edge_ * glm::length(tet.gradient)) mark_triangle(corners, edge_, kNearCore);
    }
  }
}

bool DistanceGrid::may_hold_gap(const Aabb& box) const {
  constexpr double kMostCells = 512;
  if (gaps_.empty()) return false;
  const dvec3 from = glm::floor(glm::clamp((box.lo - low_) * per_metre_, dvec3(0), dvec3(dims_ - 1)));
  const dvec3 to = glm::floor(glm::clamp((box.hi - low_) * per_metre_, dvec3(0), dvec3(dims_ - 1)));
  const dvec3 counts = to - from + 1.0;
  if (counts.x * counts.y * counts.z > kMostCells) return true;
  for (int z = static_cast<int>(from.z); z <= static_cast<int>(to.z); ++z) {
    for (int y = static_cast<int>(from.y); y <= static_cast<int>(to.y); ++y) {
      for (int x = static_cast<int>(from.x); x <= static_cast<int>(to.x); ++x)
        if (gaps_[index(x, y, z)] == kGap) return true;
    }
  }
  return false;
}

/// Sets a bit of the cells that a triangle passes at most `margin` away, along each axis.
void DistanceGrid::mark_triangle(const std::array<dvec3, 3>& corners, double margin, std::uint8_t bit) {
  Aabb box;
  for (const dvec3& corner : corners) box.include(corner);
  const dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double reach = (0.500001 * edge_ + margin) * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
  const ivec3 from(glm::clamp((box.lo - margin - low_) / edge_ - 1e-6, dvec3(0), dvec3(dims_ - 1)));
  const ivec3 to(glm::clamp((box.hi + margin - low_) / edge_ + 1e-6, dvec3(0), dvec3(dims_ - 1)));
  for (int z = from.z; z <= to.z; ++z) {
    for (int y = from.y; y <= to.y; ++y) {
      for (int x = from.x; x <= to.x; ++x) {
        const dvec3 center = low_ + edge_ * (dvec3(x, y, z) + 0.5);
        if (std::abs(glm::dot(n, center - corners[0])) <= reach) gaps_[index(x, y, z)] |= bit;
      }
    }
  }
}

/// Spreads the distances from the marked cells. The distance of two cells is the smallest distance of their points.
void DistanceGrid::spread(const std::vector<char>& marked) {
  std::vector<float> squared(cells_.size());
  for (std::size_t c = 0; c < squared.size(); ++c)
    squared[c] = marked[c] != 0 ? 0.0f : std::numeric_limits<float>::infinity();
  std::vector<float> line, scratch, gaps;
  const ivec3 stride(1, dims_.x, dims_.x * dims_.y);
  for (int axis = 0; axis < 3; ++axis) {
    const int n = dims_[axis], u = (axis + 1) % 3, v = (axis + 2) % 3;
    line.resize(at(n));
    gaps.clear();
    for (int s = 1 - n; s < n; ++s) gaps.push_back(gap(s));
    for (int b = 0; b < dims_[v]; ++b) {
      for (int a = 0; a < dims_[u]; ++a) {
        const int first = a * stride[u] + b * stride[v];
        for (int i = 0; i < n; ++i) line[at(i)] = squared[at(first + i * stride[axis])];
        spread_line(line, scratch, gaps);
        for (int i = 0; i < n; ++i) squared[at(first + i * stride[axis])] = line[at(i)];
      }
    }
  }
  for (std::size_t c = 0; c < cells_.size(); ++c)
    cells_[c].distance = static_cast<float>(edge_) * 0.99999f * std::sqrt(squared[c]);
}

void DistanceGrid::set_faces(std::vector<Face> faces) {
  faces_ = std::move(faces);
  if (faces_.empty()) return;
  for (int z = 0; z < dims_.z; ++z) {
    for (int y = 0; y < dims_.y; ++y) {
      for (int x = 0; x < dims_.x; ++x) {
        const dvec3 middle = low_ + edge_ * (dvec3(x, y, z) + 0.5);
        const auto value = [&](std::int32_t f) { return glm::dot(faces_[at(f)].n, middle) + faces_[at(f)].offset; };
        std::int32_t best = 0;
        double least = value(best);
        const auto consider = [&](std::int32_t f) {
          const double v = value(f);
          if (!(v < least)) return;
          least = v;
          best = f;
        };
        if (x > 0) consider(cells_[index(x - 1, y, z)].face);
        if (y > 0) consider(cells_[index(x, y - 1, z)].face);
        if (z > 0) consider(cells_[index(x, y, z - 1)].face);
        for (std::int32_t from = -1; from != best;) {
          from = best;
          for (const std::int32_t neighbour : faces_[at(from)].neighbours) consider(neighbour);
        }
        cells_[index(x, y, z)].face = best;
      }
    }
  }
}

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
