#include "core/layout/sample_spread.h"

#include <array>
#include <numeric>
#include <tuple>

#include "core/base/parallel.h"
#include "core/layout/point_grid.h"
#include "core/layout/sample_elimination.h"

namespace taxel {
namespace {

constexpr double kReach = 2.5;  // in spacings: how far a sample looks for its neighbours

double squared(const dvec2& v) {
  return glm::dot(v, v);
}

/// The state of one climb: the points that are all equally near to `at`, at most three.
class Climb {
 public:
  Climb(const std::vector<dvec2>& others, const dvec2& start) : others_(others), at_(start) {
    std::size_t nearest = 0;
    for (std::size_t j = 1; j < others.size(); ++j)
      if (squared(at_ - others[j]) < squared(at_ - others[nearest])) nearest = j;
    active_[count_++] = nearest;
  }
  [[nodiscard]] const dvec2& at() const { return at_; }

  /// One straight stretch, until one more point is as near. False at the top or where `reach` is used up.
  bool advance(double reach) {
    dvec2 up;
    if (!uphill(up)) return false;
    // |x + t u - q|^2 = |x + t u - a|^2 is linear in t: the first q to become as near as the active point a.
    const dvec2& a = others_[active_[0]];
    double step = reach;
    std::size_t met = others_.size();
    for (std::size_t j = 0; j < others_.size(); ++j) {
      const double closing = 2.0 * glm::dot(up, others_[j] - a);
      if (closing <= 0.0 || std::find(active_.begin(), active_.begin() + count_, j) != active_.begin() + count_)
        continue;
      const double t = std::max(0.0, (squared(at_ - others_[j]) - squared(at_ - a)) / closing);
      if (t < step) step = t, met = j;
    }
    at_ += step * up;
    if (met == others_.size()) return false;
    active_[count_++] = met;
    return true;
  }

 private:
  /// The unit direction in which all active distances grow: away from one, along the bisector of two; of three the pair
  /// whose bisector leads away from the third. False where there is none: the top.
  bool uphill(dvec2& up) {
    if (count_ == 1) {
      const dvec2 away = at_ - others_[active_[0]];
      const double length = glm::length(away);
      up = length > 0.0 ? away / length : dvec2(1, 0);
      return true;
    }
    if (count_ == 2) return along_bisector(active_[0], active_[1], up);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = active_[(k + 1) % 3], q = active_[(k + 2) % 3], left = active_[k];
      if (!along_bisector(p, q, up) || !(glm::dot(up, others_[p] - others_[left]) > 0.0)) continue;
      active_ = {p, q, left};
      count_ = 2;
      return true;
    }
    return false;
  }
  bool along_bisector(std::size_t p, std::size_t q, dvec2& up) const {
    const dvec2 edge = others_[q] - others_[p];
    const double length = glm::length(edge);
    if (!(length > 0.0)) return false;
    up = dvec2(-edge.y, edge.x) / length;
    if (glm::dot(up, at_ - others_[p]) < 0.0) up = -up;
    return true;
  }

  const std::vector<dvec2>& others_;
  dvec2 at_;
  std::array<std::size_t, 4> active_{};
  std::ptrdiff_t count_ = 0;
};

/// What is around one sample: numbers of all samples near, and those on its wall laid out in its tangent plane, each at
/// its true distance.
struct Neighbourhood {
  std::vector<int> near;
  std::vector<dvec2> flat;
  dvec3 axis_u{0}, axis_v{0};
  double nearest = 0;
};

double distance_to(const std::vector<SurfaceSample>& samples, const std::vector<int>& near, const dvec3& position,
                   const dvec3& normal) {
  double least = std::numeric_limits<double>::infinity();
  for (const int j : near) {
    const SurfaceSample& other = samples[static_cast<std::size_t>(j)];
    if (same_wall(other.normal, normal)) least = std::min(least, glm::distance(other.position, position));
  }
  return least;
}

void lay_out(const std::vector<SurfaceSample>& samples, const SurfaceSample& sample, Neighbourhood& around) {
  around.axis_u = any_perpendicular(sample.normal);
  around.axis_v = glm::cross(sample.normal, around.axis_u);
  around.flat.clear();
  around.nearest = std::numeric_limits<double>::infinity();
  for (const int j : around.near) {
    const SurfaceSample& other = samples[static_cast<std::size_t>(j)];
    if (!same_wall(other.normal, sample.normal)) continue;
    const dvec3 apart = other.position - sample.position;
    const dvec2 flat(glm::dot(apart, around.axis_u), glm::dot(apart, around.axis_v));
    const double length = glm::length(flat), distance = glm::length(apart);
    around.flat.push_back(length > 0.0 ? flat * (distance / length) : flat);
    around.nearest = std::min(around.nearest, distance);
  }
}

/// The best of four climbs: from the sample itself and from three places around it, turned from sweep to sweep.
dvec2 best_hole(const Neighbourhood& around, double spacing, int sweep) {
  const double sine = 0.86602540378443865;  // of 60 degrees; a table, because sines differ between machines
  const std::array<dvec2, 3> starts{dvec2(1, 0), dvec2(-0.5, sine), dvec2(-0.5, -sine)};
  const double start_radius = 0.8 * spacing, farthest = 1.5 * spacing;
  const auto clearance = [&](const dvec2& x) {
    double least = std::numeric_limits<double>::infinity();
    for (const dvec2& q : around.flat) least = std::min(least, squared(x - q));
    return least;
  };
  dvec2 best = climb_to_hole(around.flat, dvec2(0), spacing);
  double best_clearance = clearance(best);
  for (const dvec2& start : starts) {
    const double turned = sweep % 2 == 0 ? start_radius : -start_radius;
    const dvec2 hole = climb_to_hole(around.flat, turned * start, spacing);
    const double wins = 1.0 + 1e-4;  // a tie is no reason to jump
    const double found = clearance(hole);
    if (found > best_clearance * wins && glm::length(hole) < farthest) best_clearance = found, best = hole;
  }
  return best;
}

void move_sample(const MeshIndex& surface, double spacing, int sweep, std::vector<SurfaceSample>& samples, int number,
                 Neighbourhood& around) {
  const std::size_t triangle = 3;  // a hole has three sides
  SurfaceSample& sample = samples[static_cast<std::size_t>(number)];
  lay_out(samples, sample, around);
  if (around.flat.size() < triangle) return;
  const dvec2 hole = best_hole(around, spacing, sweep);
  for (const double part : {1.0, 0.5, 0.25}) {  // a shorter move may succeed where the surface bends away
    const dvec3 aim = sample.position + part * (hole.x * around.axis_u + hole.y * around.axis_v);
    const SurfacePoint on = surface.closest_point(aim);
    const dvec3 normal = surface.mesh().face_normals()[static_cast<std::size_t>(on.face)];
    if (!same_wall(normal, sample.normal)) continue;
    if (!(distance_to(samples, around.near, on.position, normal) > around.nearest)) continue;
    sample.position = on.position;
    sample.normal = normal;
    sample.face = on.face;
    return;
  }
}

/// Samples by coloured cells: cells of one colour are at least kReach spacings apart, so that no sample of one looks at
/// a sample of another, and they can be worked on at the same time with the same result in any order.
struct ColouredCells {
  std::vector<int> samples;     ///< cell by cell
  std::vector<int> first{0};    ///< cell c holds samples [first[c], first[c + 1])
  std::array<int, 9> colour{};  ///< colour k holds cells [colour[k], colour[k + 1])
};

ColouredCells colour_cells(const std::vector<dvec3>& positions, const Aabb& bounds, double cell) {
  using Key = std::tuple<int, double, double, double>;
  std::vector<Key> keys(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const dvec3 c = glm::floor((positions[i] - bounds.lo) / cell);
    const dvec3 odd = c - 2.0 * glm::floor(0.5 * c);
    keys[i] = {static_cast<int>(odd.x) + 2 * static_cast<int>(odd.y) + 4 * static_cast<int>(odd.z), c.z, c.y, c.x};
  }
  ColouredCells cells;
  cells.samples.resize(positions.size());
  std::iota(cells.samples.begin(), cells.samples.end(), 0);
  const auto key = [&](int i) -> const Key& { return keys[static_cast<std::size_t>(i)]; };
  std::sort(cells.samples.begin(), cells.samples.end(),
            [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  const auto count = static_cast<int>(cells.samples.size());
  for (int i = 0; i < count; ++i) {
    const int colour = std::get<0>(key(cells.samples[static_cast<std::size_t>(i)]));
    const bool last = i + 1 == count || key(cells.samples[static_cast<std::size_t>(i) + 1]) !=
                                            key(cells.samples[static_cast<std::size_t>(i)]);
    if (!last) continue;
    cells.first.push_back(i + 1);
    for (auto k = static_cast<std::size_t>(colour) + 1; k < cells.colour.size(); ++k)
      cells.colour[k] = static_cast<int>(cells.first.size()) - 1;
  }
  return cells;
}

void sweep_once(const MeshIndex& surface, double spacing, int sweep, std::vector<SurfaceSample>& samples) {
  std::vector<dvec3> before;
  before.reserve(samples.size());
  for (const SurfaceSample& s : samples) before.push_back(s.position);
  const double reach = kReach * spacing;
  const PointGrid grid(before, reach);
  const ColouredCells cells = colour_cells(before, surface.mesh().bounds(), reach);

  for (std::size_t colour = 0; colour + 1 < cells.colour.size(); ++colour) {
    const int first_cell = cells.colour[colour];
    parallel_chunks(cells.colour[colour + 1] - first_cell, 8, [&](int begin, int end) {
      Neighbourhood around;
      const auto from = static_cast<std::size_t>(cells.first[static_cast<std::size_t>(first_cell + begin)]);
      const auto to = static_cast<std::size_t>(cells.first[static_cast<std::size_t>(first_cell + end)]);
      for (std::size_t i = from; i < to; ++i) {
        const int number = cells.samples[i];
        const dvec3& center = before[static_cast<std::size_t>(number)];
        around.near.clear();
        grid.visit_near(center, reach, [&](int j) {
          const dvec3 apart = before[static_cast<std::size_t>(j)] - center;
          if (j != number && glm::dot(apart, apart) < reach * reach) around.near.push_back(j);
        });
        move_sample(surface, spacing, sweep, samples, number, around);
      }
    });
  }
}

}  // namespace

dvec2 climb_to_hole(const std::vector<dvec2>& others, const dvec2& start, double reach) {
  const int stretches = 8;  // a climb takes three or four
  Climb climb(others, start);
  for (int i = 0; i < stretches; ++i)
    if (!climb.advance(reach) || glm::distance(climb.at(), start) > reach) break;
  return climb.at();
}

void spread_samples(const MeshIndex& surface, double spacing, int sweeps, std::vector<SurfaceSample>& samples,
                    Progress* progress) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (progress) progress->check(static_cast<double>(sweep) / sweeps);
    sweep_once(surface, spacing, sweep, samples);
  }
}

}  // namespace taxel
