#include "core/layout/sampling/voronoi_area.h"

#include <array>

#include "core/base/parallel.h"
#include "core/layout/point_grid.h"

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
using Candidates = std::vector<Candidate>;

/// Whether two points lie on the same wall: normals more than 90 degrees apart belong to opposite sides of a thin part,
/// and their distance through it says nothing about evenness.
bool same_wall(const dvec3& normal_a, const dvec3& normal_b) {
  const double right_angle = -1e-9;  // a cosine of 0 with rounding: faces of a box that meet at an edge are one wall
  return glm::dot(normal_a, normal_b) > right_angle;
}

constexpr double kSearch = 1.5;        // cell of the grid, in spacings
constexpr std::size_t kMaxOwners = 6;  // pieces with more owners are halved
constexpr int kMaxHalvings = 64;       // ends the halving where many cells meet in one point

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
      : samples_(samples), grid_(grid), spacing_(spacing), owners_(kMaxHalvings + 1) {}

  /// Appends what each sample gets of the face.
  void cut(const Triangle& face, const dvec3& normal, std::vector<Share>& shares) {
    const double finest = 1.0 / 256.0;  // of the face: bounds the work on faces that are long and thin
    halve(face, normal, std::max(spacing_, finest * ball_of(face).radius), shares);
  }

 private:
  struct Ball {
    dvec3 center;
    double radius;
  };
  static double squared(const dvec3& v) { return glm::dot(v, v); }
  static Ball ball_of(const Triangle& t) {
    const dvec3 center = (t[0] + t[1] + t[2]) / 3.0;
    return {center, std::sqrt(std::max({squared(t[0] - center), squared(t[1] - center), squared(t[2] - center)}))};
  }
  [[nodiscard]] const dvec3& position(int sample) const { return samples_[static_cast<std::size_t>(sample)].position; }

  /// Halves across the longest edge until pieces have `radius`, then shares each out.
  void halve(const Triangle& t, const dvec3& normal, double radius, std::vector<Share>& shares) {
    const Ball ball = ball_of(t);
    if (ball.radius > radius) {
      for (const Triangle& half : halves(t)) halve(half, normal, radius, shares);
      return;
    }
    for (double reach = spacing_ + 2.0 * ball.radius;; reach *= 2.0) {
      near_.clear();
      grid_.visit_near(ball.center, reach, [&](int s) { near_.push_back({0.0, s}); });
      same_wall_.clear();
      for (const Candidate& c : near_)
        if (same_wall(samples_[static_cast<std::size_t>(c.sample)].normal, normal)) same_wall_.push_back(c);
      for (const Candidates* candidates : {&same_wall_, &near_})
        if (find_owners(ball, *candidates, owners_[0]) <= reach) return cut_piece(t, 0, shares);
    }
  }
  static std::array<Triangle, 2> halves(const Triangle& t) {
    const std::array<double, 3> edge{squared(t[1] - t[0]), squared(t[2] - t[1]), squared(t[0] - t[2])};
    const auto k = static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
    const dvec3 &from = t[k], &to = t[(k + 1) % 3], &apex = t[(k + 2) % 3], middle = 0.5 * (from + to);
    return {Triangle{from, middle, apex}, Triangle{middle, to, apex}};
  }

  /// Those candidates that can be the nearest of some point of the ball, nearest first: no farther from its centre than
  /// the nearest one plus the diameter. Returns that distance.
  double find_owners(const Ball& ball, const Candidates& candidates, Candidates& owners) const {
    owners.clear();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Candidate& c : candidates) {
      owners.push_back({glm::distance(position(c.sample), ball.center), c.sample});
      nearest = std::min(nearest, owners.back().distance);
    }
    const double limit = nearest + 2.0 * ball.radius;
    std::erase_if(owners, [&](const Candidate& c) { return c.distance > limit; });
    std::sort(owners.begin(), owners.end(), [](const Candidate& a, const Candidate& b) {
      return std::pair(a.distance, a.sample) < std::pair(b.distance, b.sample);
    });
    drop_coincident(owners);
    return limit;
  }
  /// Of samples at one place the lowest number owns all. They stand among equal distances.
  void drop_coincident(Candidates& owners) const {
    std::size_t kept = 0;
    for (const Candidate& c : owners) {
      bool again = false;
      for (std::size_t i = kept; i-- > 0 && owners[i].distance == c.distance && !again;)
        again = position(owners[i].sample) == position(c.sample);
      if (!again) owners[kept++] = c;
    }
    owners.resize(kept);
  }

  /// Shares out a piece between owners_[depth]; halves it first while they are many. The owners of a half are among
  /// those of the whole.
  void cut_piece(const Triangle& t, int depth, std::vector<Share>& shares) {
    const auto level = static_cast<std::size_t>(depth);
    if (owners_[level].size() > kMaxOwners && depth < kMaxHalvings) {
      for (const Triangle& half : halves(t)) {
        find_owners(ball_of(half), owners_[level], owners_[level + 1]);
        cut_piece(half, depth + 1, shares);
      }
      return;
    }
    for (const Candidate& owner : owners_[level]) {
      polygon_.assign(t.begin(), t.end());
      for (const Candidate& other : owners_[level])
        if (other.sample != owner.sample && !polygon_.empty()) clip(position(owner.sample), position(other.sample));
      if (polygon_.size() >= 3) shares.push_back({owner.sample, polygon_area(polygon_)});
    }
  }

  /// Keeps what is nearer to `mine` than to `other` (Sutherland, Hodgman 1974).
  void clip(const dvec3& mine, const dvec3& other) {
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
  Candidates near_, same_wall_;
  std::vector<Candidates> owners_;  // of the piece at each depth of halving
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
  for (const auto& part : shares)
    for (const Share& share : part) samples[static_cast<std::size_t>(share.sample)].area += share.area;
  double total = 0.0;
  for (const SurfaceSample& s : samples) total += s.area;
  for (SurfaceSample& s : samples) s.area *= mesh.area() / total;  // takes out what rounding left
}

}  // namespace taxel
