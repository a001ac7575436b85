// Nearest points for many queries that are near each other; nearest.h states why each result is right.
//
// NearFaces. The eighth query of a cell lists the faces that can be nearest to a point of the cell, and the next ones
// compare lower bounds of four faces at once, d^2 + s^2 with the distance d from the plane and s beyond an edge. Only
// faces whose bound is below the best distance are measured exactly, so the bits are those of the tree. A list costs as
// much as eight searches. All memory has a fixed size; when it is full, all cells start again.
//
// NearestGuess. For each face, the faces are listed that a ball touching it from behind may reach. A guess is proved by
// comparing the planes of this list with the distance found, which is faster than a search; unproved guesses go to the
// tree.
//
// Pitfalls: bounds are in single precision and reduced by their rounding; the planes of needles say nothing and their
// bound is 0.
#include "core/mesh/query/nearest.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/mesh/query/triangle.h"

namespace taxel {
namespace {

constexpr std::uint32_t kUnlisted = 8;         // queries of a cell: as much work in the tree as a list
constexpr std::size_t kMostListed = 512;       // faces: the tree is as fast as longer lists
constexpr std::size_t kMostBlocks = 1u << 16;  // 18 MB
constexpr int kCellBits = 14;                  // 16384 cells, 0.9 MB

}  // namespace

NearFaces::NearFaces(const MeshIndex& index, double edge)
    : index_(&index), edge_(edge), cells_(std::size_t{1} << kCellBits) {
  constexpr std::size_t kMostOfACell = kMostListed / kWidth;
  blocks_.reserve(kMostBlocks + kMostOfACell);
  listed_.reserve(kMostListed + 1);
  bounds_.reserve(kMostOfACell);
}

SurfacePoint NearFaces::closest_point(const dvec3& p) {
  const Cell& cell = cell_of(p);
  if (cell.first == cell.last) return index_->closest_point(p);
  const dvec3 local = p - cell.middle;
  const std::array<float, 3> x{static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)};
  const Block* const blocks = blocks_.data() + cell.first;
  const std::size_t count = cell.last - cell.first;
  bounds_.resize(count);
  Lanes least = std::numeric_limits<float>::infinity() - Lanes{};
  Numbers nearest{};  // block with the least bound of each lane
  for (std::size_t b = 0; b < count; ++b) {
    const Lanes squared = squared_bounds(cell, blocks[b], x);
    const Numbers is_less = squared < least;
    bounds_[b].squared = squared;
    least = is_less ? squared : least;
    nearest = is_less ? static_cast<std::int32_t>(b) - Numbers{} : nearest;
  }
  const TriMesh& mesh = index_->mesh();
  SurfacePoint best;
  double best_squared = std::numeric_limits<double>::infinity();
  float limit = 0;  // squared bounds above it are of faces that are too far
  const auto test = [&](std::size_t block, int lane) {
    constexpr double kRoundUp = 1 + 8 * std::numeric_limits<float>::epsilon();
    const int face = blocks[block].number[at(lane)];
    const TrianglePoint q = nearest_on_triangle(p, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
    if (q.squared_distance > best_squared || (q.squared_distance == best_squared && face > best.face)) return;
    best_squared = q.squared_distance;
    best = {q.position, face, q.barycentric, 0};
    limit = static_cast<float>(kRoundUp * best_squared);
  };
  int first = 0;
  for (int lane = 1; lane < kWidth; ++lane) first = least[lane] < least[first] ? lane : first;
  const std::size_t first_block = at(nearest[first]);
  test(first_block, first);
  for (std::size_t b = 0; b < count; ++b) {
    const Numbers is_near = bounds_[b].squared <= limit;
    const auto halves = std::bit_cast<std::array<std::int64_t, 2>>(is_near);
    if ((halves[0] | halves[1]) == 0) continue;
    for (int lane = 0; lane < kWidth; ++lane)
      if (is_near[lane] != 0 && !(b == first_block && lane == first)) test(b, lane);
  }
  best.distance = std::sqrt(best_squared);
  return best;
}

/// Returns d^2 + s^2 for four faces: d is the distance from the face's plane, and s how far x is beyond the edge that
/// it is farthest beyond. No point of the triangle is nearer; nearest to a corner of the triangle it may be farther.
NearFaces::Lanes NearFaces::squared_bounds(const Cell& cell, const Block& block, const std::array<float, 3>& x) {
  const auto position = [&](const Planes& plane) {
    return plane.nx * x[0] + plane.ny * x[1] + (plane.nz * x[2] + plane.offset);
  };
  const Lanes d = position(block.face);
  const Lanes away = (d < 0.0f ? -d : d) - cell.rounding;
  const Lanes a = position(block.edge[0]), b = position(block.edge[1]), c = position(block.edge[2]);
  const Lanes ab = a > b ? a : b;
  const Lanes beyond = (ab > c ? ab : c) - cell.rounding;
  const Lanes least_away = away > 0.0f ? away : Lanes{}, least_beyond = beyond > 0.0f ? beyond : Lanes{};
  return least_away * least_away + least_beyond * least_beyond;
}

const NearFaces::Cell& NearFaces::cell_of(const dvec3& p) {
  constexpr double kMost = 1 << 20;  // cells on either side of the origin; points beyond are in none
  const dvec3 steps = glm::floor(p / edge_);
  static const Cell none;
  if (!(std::max({std::abs(steps.x), std::abs(steps.y), std::abs(steps.z)}) < kMost)) return none;
  const auto bits = [&](double n) { return static_cast<std::uint64_t>(n + kMost); };
  const std::uint64_t key = bits(steps.x) << 42 | bits(steps.y) << 21 | bits(steps.z);
  if (blocks_.size() > kMostBlocks) {
    std::fill(cells_.begin(), cells_.end(), Cell{});
    blocks_.clear();
  }
  constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;
  Cell& cell = cells_[key * kGoldenRatio >> (64 - kCellBits)];
  if (cell.key != key) {
    cell = {};
    cell.key = key;
  }
  if (++cell.queries == kUnlisted) list_faces(edge_ * (steps + 0.5), cell);
  return cell;
}

/// Points of the cell are within r of its middle, so their distances from the mesh, and from each face, differ from
/// those of the middle by at most r.
void NearFaces::list_faces(const dvec3& middle, Cell& cell) {
  const double r = 0.5 * std::sqrt(3.0) * edge_;
  const double reach = (index_->closest_point(middle).distance + 2 * r) * (1 + 1e-9);
  listed_.clear();
  index_->tree().visit_near(middle, reach, [&](int face) {
    const TriMesh& mesh = index_->mesh();
    const TrianglePoint q =
        nearest_on_triangle(middle, mesh.vertex(face, 0), mesh.vertex(face, 1), mesh.vertex(face, 2));
    const bool is_full = listed_.size() > kMostListed;
    if (q.squared_distance <= reach * reach && !is_full) listed_.push_back(face);
    return is_full ? 0.0 : reach;
  });
  if (listed_.size() > kMostListed) return;
  cell.middle = middle;
  std::sort(listed_.begin(), listed_.end());
  cell.first = static_cast<std::uint32_t>(blocks_.size());
  for (std::size_t i = 0; i < listed_.size(); ++i) {
    if (i % kWidth == 0) blocks_.emplace_back().face.offset += std::numeric_limits<float>::infinity();
    set(middle, listed_[i], static_cast<int>(i % kWidth), blocks_.back());
  }
  cell.last = static_cast<std::uint32_t>(blocks_.size());
  // The planes pass within `reach` plus the size of a face of the middle.
  double farthest = reach;
  for (const int face : listed_) {
    for (int c = 0; c < 3; ++c) farthest = std::max(farthest, glm::distance(middle, index_->mesh().vertex(face, c)));
  }
  cell.rounding = static_cast<float>(16 * std::numeric_limits<float>::epsilon() * farthest);
}

void NearFaces::set(const dvec3& middle, int face, int lane, Block& block) const {
  constexpr float kExact = 1e-9f;
  block.number[at(lane)] = face;
  block.face.offset[lane] = 0;
  // The normal of a needle is not exact: its planes remain 0, and so does the bound of its distance.
  if (index_->normal_error(face) > kExact) return;
  const TriMesh& mesh = index_->mesh();
  const dvec3& n = mesh.face_normals()[at(face)];
  const auto set_plane = [&](const dvec3& normal, const dvec3& through, Planes& planes) {
    planes.nx[lane] = static_cast<float>(normal.x);
    planes.ny[lane] = static_cast<float>(normal.y);
    planes.nz[lane] = static_cast<float>(normal.z);
    planes.offset[lane] = static_cast<float>(glm::dot(normal, middle - through));
  };
  set_plane(n, mesh.vertex(face, 0), block.face);
  for (int e = 0; e < 3; ++e) {
    const dvec3 along = mesh.vertex(face, (e + 1) % 3) - mesh.vertex(face, e);
    set_plane(glm::normalize(glm::cross(along, n)), mesh.vertex(face, e), block.edge[e]);
  }
}

NearestGuess::NearestGuess(const MeshIndex& index, double most) : index_(index), most_(most) {
  const TriMesh& mesh = index.mesh();
  const dvec3 reach = glm::max(glm::abs(mesh.bounds().lo), glm::abs(mesh.bounds().hi));
  slack_ = 1e-12 * (reach.x + reach.y + reach.z);
  std::vector<std::vector<int>> around(at(mesh.face_count()));
  parallel_chunks(mesh.face_count(), 64, [&](int begin, int end) {
    for (int f = begin; f < end; ++f) around[at(f)] = faces_around(f);
  });
  first_.assign(1, 0);
  for (const std::vector<int>& faces : around) {
    for (const int other : faces) {
      const dvec3& n = mesh.face_normals()[at(other)];
      around_.push_back(other);
      nx_.push_back(n.x), ny_.push_back(n.y), nz_.push_back(n.z);
      offset_.push_back(-glm::dot(n, mesh.vertex(other, 0)));
    }
    first_.push_back(static_cast<std::uint32_t>(around_.size()));
  }
}

/// Returns the faces that a ball of radius most_ or less may reach if it touches a face from behind, ascending.
std::vector<int> NearestGuess::faces_around(int face) const {
  const TriMesh& mesh = index_.mesh();
  // The balls are within most_ of a point most_ behind the face.
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  const dvec3 middle = (a + b + c) / 3.0;
  const double r = std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)});
  std::vector<int> faces = index_.faces_near(middle - most_ * mesh.face_normals()[at(face)], most_ + r);
  std::erase_if(faces, [&](int other) { return other == face || !may_be_nearer(face, other); });
  return faces;
}

/// Returns false only if no ball of radius most_ or less that touches a face from behind reaches another face. The ball
/// at s that reaches y has the radius |y - s|^2 / (2 n (s - y)). For a part of the face with the middle c and the
/// circumradius r, |y - s| >= |y - c| - r, and n (s - y) = n (c - y) is largest at a corner of the other face.
bool NearestGuess::may_be_nearer(int face, int other) const {
  const TriMesh& mesh = index_.mesh();
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  const dvec3& n = mesh.face_normals()[at(face)];
  double below = 0;
  for (int i = 0; i < 3; ++i) below = std::max(below, glm::dot(n, a - mesh.vertex(other, i)));
  if (!(below > 0)) return false;
  const double clear = std::sqrt(2 * below * most_);
  const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  for (const std::array<dvec3, 3>& part :
       {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{bc, ca, ab}}) {
    const dvec3 middle = (part[0] + part[1] + part[2]) / 3.0;
    const double r =
        std::max({glm::distance(middle, part[0]), glm::distance(middle, part[1]), glm::distance(middle, part[2])});
    const TrianglePoint q =
        nearest_on_triangle(middle, mesh.vertex(other, 0), mesh.vertex(other, 1), mesh.vertex(other, 2));
    if (std::sqrt(q.squared_distance) - r <= clear) return true;
  }
  return false;
}

/// Returns the face around `face` whose plane is nearest to x, if it is nearer than `within`, otherwise -1.
int NearestGuess::nearer_plane(int face, const dvec3& x, double within) const {
  const std::uint32_t first = first_[at(face)], end = first_[at(face) + 1];
  bool any = false;
  for (std::uint32_t i = first; i < end; ++i)
    any |= std::abs(nx_[i] * x.x + ny_[i] * x.y + nz_[i] * x.z + offset_[i]) < within;
  int nearest = -1;
  if (!any) return nearest;
  for (std::uint32_t i = first; i < end; ++i) {
    const double away = std::abs(nx_[i] * x.x + ny_[i] * x.y + nz_[i] * x.z + offset_[i]);
    if (away < within) within = away, nearest = around_[i];
  }
  return nearest;
}

/// Returns the face across the edge that the nearest point of a face is on, or -1.
int NearestGuess::across(int face, const dvec3& barycentric) const {
  const int e = barycentric.z == 0 ? 0 : barycentric.x == 0 ? 1 : 2;  // edge e runs from corner e to the next one
  return index_.mesh().topology().face_across(3 * face + e);
}

SurfacePoint NearestGuess::closest_point(const dvec3& x, int& guess) const {
  const TriMesh& mesh = index_.mesh();
  constexpr int kSteps = 8;
  double within = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps && guess >= 0; ++i) {
    const int f = guess;
    const TrianglePoint q = nearest_on_triangle(x, mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2));
    const double h = std::sqrt(q.squared_distance);
    const bool nearer_than_before = h < within;
    within = std::min(within, h);
    if (!(q.barycentric.x > 0 && q.barycentric.y > 0 && q.barycentric.z > 0)) {
      if (!nearer_than_before) break;  // the walk turns back, as below a concave edge
      guess = across(f, q.barycentric);
      continue;
    }
    const bool behind = glm::dot(mesh.face_normals()[at(f)], x - mesh.vertex(f, 0)) <= 0;
    if (!behind || h > most_) break;
    const int nearer = nearer_plane(f, x, h - slack_);
    if (nearer < 0) return {q.position, f, q.barycentric, h};
    guess = nearer;
  }
  const SurfacePoint s = index_.closest_point(x, within);
  guess = s.face;
  return s;
}

}  // namespace taxel
