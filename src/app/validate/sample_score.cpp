#include "app/validate/sample_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace taxel {
namespace {

/// The samples, sorted by one coordinate.
class Line {
 public:
  Line(std::span<const SurfacePlace> samples, int axis) : axis_(axis), order_(samples.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return samples[a].position[axis] < samples[b].position[axis]; });
    for (const std::size_t i : order_) sorted_.push_back(samples[i]);
  }
  struct Nearest {
    std::size_t sample = 0;
    double distance = std::numeric_limits<double>::infinity();
  };
  /// Returns the nearest sample on the same wall, without the sample at index `except` in sorted().
  [[nodiscard]] Nearest nearest(const SurfacePlace& place, std::size_t except) const {
    const double x = place.position[axis_];
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), x,
                                     [&](const SurfacePlace& s, double v) { return s.position[axis_] < v; });
    const auto middle = static_cast<std::size_t>(at - sorted_.begin());
    Nearest best;
    const auto look = [&](std::size_t i) {
      if (std::abs(sorted_[i].position[axis_] - x) >= best.distance) return false;
      const double d = glm::distance(sorted_[i].position, place.position);
      if (i != except && d < best.distance && glm::dot(sorted_[i].normal, place.normal) > -1e-9) best = {i, d};
      return true;
    };
    for (std::size_t i = middle; i < sorted_.size() && look(i); ++i) {
    }
    for (std::size_t i = middle; i-- > 0 && look(i);) {
    }
    return best;
  }
  [[nodiscard]] const std::vector<SurfacePlace>& sorted() const { return sorted_; }
  /// Returns the number of the sample sorted()[place].
  [[nodiscard]] std::size_t sample(std::size_t place) const { return order_[place]; }

 private:
  int axis_;
  std::vector<std::size_t> order_;
  std::vector<SurfacePlace> sorted_;
};

/// Calls visit(point, area) for the centroids of k^2 congruent parts of a face.
template <class Visit>
void visit_lattice(const TriMesh& mesh, int face, int k, const Visit& visit) {
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  const double area = mesh.face_areas()[static_cast<std::size_t>(face)] / (double(k) * k);
  for (int i = 0; i < k; ++i)
    for (int j = 0; i + j < k; ++j)
      for (const double corner : {1.0 / 3, 2.0 / 3}) {
        if (corner > 0.5 && i + j + 1 >= k) continue;
        visit(a + (b - a) * ((i + corner) / k) + (c - a) * ((j + corner) / k), area);
      }
}

}  // namespace

SampleScore score_samples(const TriMesh& mesh, std::span<const SurfacePlace> samples, int per_sample) {
  const auto n = static_cast<double>(samples.size());
  const double densest = std::sqrt(2.0 * mesh.area() / (std::sqrt(3.0) * n));
  const dvec3 extent = mesh.bounds().extent();
  const Line line(samples, extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2);

  SampleScore score;
  score.rho.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    score.rho[line.sample(i)] = line.nearest(line.sorted()[i], i).distance / densest;
  std::vector<double> rho = score.rho;
  std::sort(rho.begin(), rho.end());
  score.rho_min = rho.front();
  score.rho_5_percent = rho[rho.size() / 20];
  for (const double r : rho) score.rho_mean += r / n;

  score.area.assign(samples.size(), 0.0);
  const double radius = densest / std::sqrt(3.0);  // circumradius of a triangle of the densest packing
  for (int f = 0; f < mesh.face_count(); ++f) {
    const double wanted = mesh.face_areas()[static_cast<std::size_t>(f)] / mesh.area() * n * per_sample;
    const int k = std::max(1, static_cast<int>(std::ceil(std::sqrt(wanted))));
    visit_lattice(mesh, f, k, [&](const dvec3& point, double area) {
      const auto owner = line.nearest({point, mesh.face_normals()[static_cast<std::size_t>(f)]}, samples.size());
      if (!std::isfinite(owner.distance)) return;
      score.area[line.sample(owner.sample)] += area * n / mesh.area();
      score.gap = std::max(score.gap, owner.distance / radius);
    });
  }
  double squares = 0.0;
  for (const double area : score.area) squares += (area - 1.0) * (area - 1.0);
  score.area_cv = std::sqrt(squares / n);
  return score;
}

}  // namespace taxel
