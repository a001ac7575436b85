#include "core/layout/voronoi_area.h"

#include <array>

#include "core/base/parallel.h"
#include "core/layout/point_grid.h"
#include "core/layout/sample_elimination.h"

namespace taxel {
namespace {

using Triangle = std::array<dvec3, 3>;
struct Share {
  int sample;
  double area;
};
struct Candidate {
  double distance;
  int sample;
};
constexpr double kPiece = 0.4;   // largest radius of a piece, in spacings
constexpr double kSearch = 2.0;  // first search radius, in spacings

double polygon_area(const std::vector<dvec3>& polygon) {
  dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * glm::length(sum);
}

/// Cuts faces into the cells of nearby samples. One per thread: it keeps its memory.
class FaceCutter {
 public:
  FaceCutter(const std::vector<SurfaceSample>& samples, const PointGrid& grid, double spacing)
      : samples_(samples), grid_(grid), spacing_(spacing) {}

  /// Appends what each sample gets of the triangle. Pieces not much smaller than a cell are halved across their longest
  /// edge first, so that the number of samples that one piece is cut between stays small.
  void cut(const Triangle& t, const dvec3& normal, std::vector<Share>& shares) {
    const dvec3 center = (t[0] + t[1] + t[2]) / 3.0;
    const double radius = std::sqrt(std::max({squared(t[0] - center), squared(t[1] - center), squared(t[2] - center)}));
    if (radius > kPiece * spacing_) {
      const std::array<double, 3> edge{squared(t[1] - t[0]), squared(t[2] - t[1]), squared(t[0] - t[2])};
      const auto k = static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
      const dvec3 &from = t[k], &to = t[(k + 1) % 3], &apex = t[(k + 2) % 3];
      const dvec3 middle = 0.5 * (from + to);
      cut({from, middle, apex}, normal, shares);
      cut({middle, to, apex}, normal, shares);
      return;
    }
    find_owners(center, radius, normal);
    for (const Candidate& owner : owners_) {
      polygon_.assign(t.begin(), t.end());
      for (const Candidate& other : owners_)
        if (other.sample != owner.sample && !polygon_.empty())
          clip(position(owner.sample), position(other.sample), owner.sample < other.sample);
      if (polygon_.size() >= 3) shares.push_back({owner.sample, polygon_area(polygon_)});
    }
  }

 private:
  static double squared(const dvec3& v) { return glm::dot(v, v); }
  [[nodiscard]] const dvec3& position(int sample) const { return samples_[static_cast<std::size_t>(sample)].position; }

  /// All samples that can be the nearest of some point of the ball, nearest first: no farther from its centre than the
  /// nearest one plus the diameter. Widens the search until that is certain.
  void find_owners(const dvec3& center, double radius, const dvec3& normal) {
    for (double reach = kSearch * spacing_;; reach *= 2.0) {
      candidates_.clear();
      grid_.visit_near(center, reach, [&](int s) { candidates_.push_back({glm::distance(position(s), center), s}); });
      const auto on_wall = [&](const Candidate& c) {
        return same_wall(samples_[static_cast<std::size_t>(c.sample)].normal, normal);
      };
      if (take_owners(reach, radius, on_wall) || take_owners(reach, radius, [](const Candidate&) { return true; }))
        return;
    }
  }
  template <class Allowed>
  bool take_owners(double reach, double radius, const Allowed& allowed) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Candidate& c : candidates_)
      if (allowed(c)) nearest = std::min(nearest, c.distance);
    const double limit = nearest + 2.0 * radius;
    if (!(limit <= reach)) return false;
    owners_.clear();
    for (const Candidate& c : candidates_)
      if (c.distance <= limit && allowed(c)) owners_.push_back(c);
    std::sort(owners_.begin(), owners_.end(), [](const Candidate& a, const Candidate& b) {
      return std::pair(a.distance, a.sample) < std::pair(b.distance, b.sample);
    });
    return true;
  }

  /// Keeps what is nearer to `mine` (Sutherland, Hodgman 1974). Coincident samples: the lower number keeps all.
  void clip(const dvec3& mine, const dvec3& other, bool keeps_ties) {
    if (mine == other) {
      if (!keeps_ties) polygon_.clear();
      return;
    }
    const dvec3 towards = other - mine, middle = 0.5 * (mine + other);
    sides_.clear();
    for (const dvec3& p : polygon_) sides_.push_back(glm::dot(towards, p - middle));
    if (*std::max_element(sides_.begin(), sides_.end()) <= 0.0) return;
    clipped_.clear();
    for (std::size_t i = 0, from = polygon_.size() - 1; i < polygon_.size(); from = i++) {
      const double a = sides_[from], b = sides_[i];
      if ((a <= 0.0) != (b <= 0.0)) clipped_.push_back(polygon_[from] + (polygon_[i] - polygon_[from]) * (a / (a - b)));
      if (b <= 0.0) clipped_.push_back(polygon_[i]);
    }
    polygon_.swap(clipped_);
  }

  const std::vector<SurfaceSample>& samples_;
  const PointGrid& grid_;
  double spacing_;
  std::vector<Candidate> candidates_, owners_;
  std::vector<dvec3> polygon_, clipped_;
  std::vector<double> sides_;
};

}  // namespace

void assign_voronoi_areas(const TriMesh& mesh, std::vector<SurfaceSample>& samples) {
  const int chunk = 64;
  const double spacing = std::sqrt(mesh.area() / static_cast<double>(samples.size()));
  std::vector<dvec3> positions;
  positions.reserve(samples.size());
  for (const SurfaceSample& s : samples) positions.push_back(s.position);
  const PointGrid grid(positions, kSearch * spacing);

  std::vector<std::vector<Share>> shares(static_cast<std::size_t>((mesh.face_count() + chunk - 1) / chunk));
  parallel_chunks(mesh.face_count(), chunk, [&](int begin, int end) {
    FaceCutter cutter(samples, grid, spacing);
    for (int f = begin; f < end; ++f)
      cutter.cut({mesh.vertex(f, 0), mesh.vertex(f, 1), mesh.vertex(f, 2)},
                 mesh.face_normals()[static_cast<std::size_t>(f)], shares[static_cast<std::size_t>(begin / chunk)]);
  });

  for (SurfaceSample& s : samples) s.area = 0.0;
  double total = 0.0;
  for (const auto& part : shares)
    for (const Share& share : part) {
      samples[static_cast<std::size_t>(share.sample)].area += share.area;
      total += share.area;
    }
  for (SurfaceSample& s : samples) s.area *= mesh.area() / total;  // takes out what rounding left
}

}  // namespace taxel
