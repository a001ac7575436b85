// Voronoi cells of samples on a surface, exactly on each face.
//
// In the plane of a face, the squared distances to two samples differ by a linear function, also if the samples are
// above or below the plane. So the part of a face that is nearest to one sample is a convex polygon, and the parts of
// all samples fill the face.
//
// 1. A face is halved across its longest edge until its pieces are about as large as the spacing of the samples.
// 2. The owners of a piece are the samples no farther from its centre than the nearest one plus the diameter of the
//    piece. Pieces with more than eight owners are halved again.
// 3. Each owner's part is the piece cut by the bisecting lines to the other owners.
//
// Pitfalls: a sample on the opposite side of a thin wall may be nearer than those on the same side, so only samples of
// the same wall count, unless there are none. Several samples at one place have no bisecting line; the first one owns
// the area. Halving ends after 64 times, where very many cells meet in one point. Cost: about O(n) for n samples, by a
// grid; each thread keeps the samples that it has gathered for the next face.
#include "core/layout/sampling/voronoi_area.h"

#include <array>

#include "core/base/parallel.h"
#include "core/layout/field/point_grid.h"

namespace taxel {
namespace {

struct Share {
  int sample;
  double area;
};

/// Returns true if two points lie on the same wall: normals more than 90 degrees apart belong to opposite sides of a
/// thin part, and their distance through it says nothing about evenness.
bool same_wall(const dvec3& normal_a, const dvec3& normal_b) {
  const double right_angle = -1e-9;  // a cosine of 0 with rounding: faces of a box that meet at an edge are one wall
  return glm::dot(normal_a, normal_b) > right_angle;
}

constexpr double kSearch = 2.5;        // cell of the grid, in spacings
constexpr double kPiece = 1.0;         // largest radius of a piece, in spacings
constexpr std::size_t kMaxOwners = 8;  // pieces with more owners are halved
constexpr int kMaxHalvings = 64;       // ends the halving where many cells meet in one point

template <class Vec>
double squared(const Vec& v) {
  return glm::dot(v, v);
}

/// The plane of a face.
struct Frame {
  dvec3 origin{0}, u{0}, v{0}, normal{0};
  [[nodiscard]] dvec2 flat(const dvec3& p) const { return {glm::dot(p - origin, u), glm::dot(p - origin, v)}; }
  [[nodiscard]] dvec3 point(const dvec2& p) const { return origin + p.x * u + p.y * v; }
};

/// A triangle in it, and the smallest circle about its centroid.
struct Piece {
  std::array<dvec2, 3> corners;
  dvec2 center{0};
  double radius = 0;
  explicit Piece(const std::array<dvec2, 3>& c) : corners(c), center((c[0] + c[1] + c[2]) / 3.0) {
    radius = std::sqrt(std::max({squared(c[0] - center), squared(c[1] - center), squared(c[2] - center)}));
  }
  /// Across the longest edge.
  [[nodiscard]] std::array<Piece, 2> halves() const {
    const auto& t = corners;
    const std::array<double, 3> edge{squared(t[1] - t[0]), squared(t[2] - t[1]), squared(t[0] - t[2])};
    const auto k = static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
    const dvec2 &from = t[k], &to = t[(k + 1) % 3], &apex = t[(k + 2) % 3], middle = 0.5 * (from + to);
    return {Piece({from, middle, apex}), Piece({middle, to, apex})};
  }
};

/// A sample seen from the plane of a face: at `flat`, and `height2` above or below it, squared.
struct Site {
  dvec2 flat{0};
  double height2 = 0;
  int sample = 0;
  double distance2 = 0;  ///< from the centre of the piece at hand
  [[nodiscard]] bool before(const Site& b) const {
    return distance2 != b.distance2 ? distance2 < b.distance2 : sample < b.sample;
  }
};
using Sites = std::vector<Site>;

/// Those sites that can be the nearest of some point of the piece, nearest first: no farther from its centre than the
/// nearest one plus the diameter. Returns that distance.
double find_owners(const Piece& piece, Sites& sites, Sites& owners) {
  double nearest2 = std::numeric_limits<double>::infinity();
  for (Site& s : sites) {
    s.distance2 = squared(s.flat - piece.center) + s.height2;
    nearest2 = std::min(nearest2, s.distance2);
  }
  const double limit = std::sqrt(nearest2) + 2.0 * piece.radius;
  owners.clear();
  for (const Site& s : sites) {
    if (s.distance2 > limit * limit) continue;
    owners.push_back(s);
    for (std::size_t i = owners.size() - 1; i > 0 && s.before(owners[i - 1]); --i) std::swap(owners[i - 1], owners[i]);
  }
  return limit;
}

/// If several samples are at one place, the one with the lowest index owns the area. Such samples have equal distances.
void drop_coincident(Sites& owners) {
  std::size_t kept = 0;
  for (const Site& s : owners) {
    bool again = false;
    for (std::size_t i = kept; i-- > 0 && owners[i].distance2 == s.distance2 && !again;)
      again = owners[i].flat == s.flat && owners[i].height2 == s.height2;
    if (!again) owners[kept++] = s;
  }
  owners.resize(kept);
}

/// Cuts faces into the cells of nearby samples, and calls sink(sample, polygon, frame) with each part. One per thread:
/// it keeps its memory.
template <class Sink>
class FaceCutter {
 public:
  FaceCutter(const std::vector<SurfaceSample>& samples, const PointGrid& grid, double spacing, Sink sink)
      : samples_(samples), grid_(grid), spacing_(spacing), sink_(std::move(sink)), owners_(kMaxHalvings + 1) {}

  void cut(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& normal) {
    const dvec3 u = any_perpendicular(normal);
    frame_ = {(a + b + c) / 3.0, u, glm::cross(normal, u), normal};
    const Piece face({frame_.flat(a), frame_.flat(b), frame_.flat(c)});
    const double finest = 1.0 / 256.0;  // smallest piece as a fraction of the face; limits work on thin faces
    halve(face, std::max(kPiece * spacing_, finest * face.radius));
  }

 private:
  struct Near {
    dvec3 position, normal;
    int sample;
  };

  void halve(const Piece& piece, double radius) {
    if (piece.radius > radius) {
      for (const Piece& half : piece.halves()) halve(half, radius);
      return;
    }
    for (double reach = spacing_ + 2.0 * piece.radius;; reach *= 2.0) {
      gather(frame_.point(piece.center), reach);
      for (const bool any_wall : {false, true}) {
        sites_.clear();
        for (const Near& s : near_)
          if (any_wall || same_wall(s.normal, frame_.normal)) sites_.push_back(site_of(s));
        if (find_owners(piece, sites_, owners_[0]) > reach) continue;
        drop_coincident(owners_[0]);
        return cut_piece(piece, 0);
      }
    }
  }
  [[nodiscard]] Site site_of(const Near& s) const {
    const double height = glm::dot(s.position - frame_.origin, frame_.normal);
    return {frame_.flat(s.position), height * height, s.sample, 0.0};
  }

  /// Gathers all samples within `reach` of a point, and more. Consecutive faces are mostly neighbours, so that one call
  /// serves several faces.
  void gather(const dvec3& center, double reach) {
    if (glm::distance(center, gathered_center_) + reach <= gathered_reach_) return;
    gathered_center_ = center;
    gathered_reach_ = reach + 0.5 * spacing_;
    near_.clear();
    grid_.visit_near(center, gathered_reach_, [&](int i) {
      const SurfaceSample& s = samples_[static_cast<std::size_t>(i)];
      if (squared(s.position - center) <= gathered_reach_ * gathered_reach_) near_.push_back({s.position, s.normal, i});
    });
  }

  /// Shares out a piece between owners_[depth]; halves it first while they are many. The owners of a half are among
  /// those of the whole.
  void cut_piece(const Piece& piece, int depth) {
    const auto level = static_cast<std::size_t>(depth);
    if (owners_[level].size() > kMaxOwners && depth < kMaxHalvings) {
      for (const Piece& half : piece.halves()) {
        find_owners(half, owners_[level], owners_[level + 1]);
        cut_piece(half, depth + 1);
      }
      return;
    }
    for (const Site& owner : owners_[level]) {
      cell_.assign(piece.corners);
      for (const Site& other : owners_[level]) {
        if (other.sample == owner.sample || cell_.empty()) continue;
        // |x - owner|^2 - |x - other|^2, linear in x, is at most 0.
        cell_.cut(2.0 * (other.flat - owner.flat),
                  (squared(owner.flat) + owner.height2) - (squared(other.flat) + other.height2));
      }
      if (!cell_.empty()) sink_(owner.sample, cell_, frame_);
    }
  }

  const std::vector<SurfaceSample>& samples_;
  const PointGrid& grid_;
  double spacing_;
  Sink sink_;
  dvec3 gathered_center_{0};
  double gathered_reach_ = -1.0;
  std::vector<Near> near_;
  Frame frame_;
  Sites sites_;
  std::vector<Sites> owners_;  // sites of the piece at each depth of halving
  ConvexPolygon cell_;
};

std::vector<dvec3> positions_of(const std::vector<SurfaceSample>& samples) {
  std::vector<dvec3> positions;
  positions.reserve(samples.size());
  for (const SurfaceSample& s : samples) positions.push_back(s.position);
  return positions;
}

/// Returns the nearest sample within `reach`, or -1.
int nearest_within(double reach, const SurfaceSample& point, const std::vector<SurfaceSample>& samples,
                   const PointGrid& grid, bool any_wall) {
  int nearest = -1;
  double nearest2 = reach * reach;
  grid.visit_near(point.position, reach, [&](int i) {
    const SurfaceSample& s = samples[static_cast<std::size_t>(i)];
    const double distance2 = squared(s.position - point.position);
    if (distance2 > nearest2 || (distance2 == nearest2 && nearest >= 0 && i > nearest)) return;
    if (any_wall || same_wall(s.normal, point.normal)) nearest = i, nearest2 = distance2;
  });
  return nearest;
}

}  // namespace

std::vector<int> cells_of(std::span<const SurfaceSample> points, const std::vector<SurfaceSample>& samples,
                          double spacing) {
  const PointGrid grid(positions_of(samples), spacing);
  std::vector<int> cells;
  cells.reserve(points.size());
  for (const SurfaceSample& point : points) {
    int cell = -1;
    for (double reach = spacing; cell < 0 && reach <= 4 * spacing; reach *= 2)
      cell = nearest_within(reach, point, samples, grid, false);
    for (double reach = 4 * spacing; cell < 0; reach *= 2) cell = nearest_within(reach, point, samples, grid, true);
    cells.push_back(cell);
  }
  return cells;
}

TriMesh surface_of_cells(const TriMesh& mesh, const std::vector<SurfaceSample>& samples,
                         const std::vector<bool>& is_wanted, double spacing) {
  const double sliver = 1e-10 * spacing * spacing;  // no triangle without a normal
  const PointGrid grid(positions_of(samples), kSearch * spacing);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  FaceCutter cutter(samples, grid, spacing, [&](int sample, const ConvexPolygon& part, const Frame& frame) {
    if (!is_wanted[static_cast<std::size_t>(sample)] || part.area() <= sliver) return;
    const std::vector<dvec2>& corners = part.corners();
    const auto first = static_cast<int>(vertices.size());
    for (const dvec2& corner : corners) vertices.push_back(frame.point(corner));
    for (int i = 1; i + 1 < static_cast<int>(corners.size()); ++i)
      if (part.triangle_area(i) > sliver) faces.emplace_back(first, first + i, first + i + 1);
  });
  for (int f = 0; f < mesh.face_count(); ++f)
    cutter.cut(mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2),
               mesh.face_normals()[static_cast<std::size_t>(f)]);
  return {std::move(vertices), std::move(faces)};
}

void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples) {
  const int chunk = 64;
  const double spacing = std::sqrt(mesh.area() / static_cast<double>(samples.size()));
  const PointGrid grid(positions_of(samples), kSearch * spacing);

  std::vector<std::vector<Share>> shares(static_cast<std::size_t>((mesh.face_count() + chunk - 1) / chunk));
  parallel_chunks(mesh.face_count(), chunk, [&](int begin, int end) {
    std::vector<Share>& own = shares[static_cast<std::size_t>(begin / chunk)];
    FaceCutter cutter(samples, grid, spacing, [&](int sample, const ConvexPolygon& part, const Frame&) {
      own.push_back({sample, std::abs(part.area())});
    });
    for (int f = begin; f < end; ++f)
      cutter.cut(mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2),
                 mesh.face_normals()[static_cast<std::size_t>(f)]);
  });

  for (SurfaceSample& s : samples) s.area = 0.0;
  for (const auto& part : shares)
    for (const Share& share : part) samples[static_cast<std::size_t>(share.sample)].area += share.area;
  double total = 0.0;
  for (const SurfaceSample& s : samples) total += s.area;
  for (SurfaceSample& s : samples) s.area *= mesh.area() / total;  // removes rounding errors
}

}  // namespace taxel
