#include "core/layout/sampling/sample_spread.h"

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <functional>

#include "core/base/parallel.h"
#include "core/layout/sampling/cell_list.h"
#include "core/layout/sampling/empty_circle.h"
#include "core/layout/sampling/sample_elimination.h"

namespace taxel {
namespace {

constexpr double kReach = 2.5;   // in spacings: how far a sample looks for its neighbours
constexpr double kBehind = 1.5;  // and for those round an edge or beyond a wall

double squared(const dvec2& v) {
  return glm::dot(v, v);
}

/// Moves samples on one surface, sweep by sweep.
class Spreader {
 public:
  Spreader(const SurfaceGraph& surface, double spacing, std::vector<SurfaceSample>& samples)
      : surface_(surface), spacing_(spacing), samples_(samples), scratch_([this] { return Scratch(surface_); }) {}

  /// Cells of one colour are at least kReach spacings apart, so that no sample of one looks at a sample of another, and
  /// they can be worked on at the same time with the same result in any order.
  void sweep(int number, const std::function<void(double)>& report) {
    before_.clear();
    for (const SurfaceSample& s : samples_) before_.push_back(s.position);
    const CellList cells(before_, kReach * spacing_);
    std::array<std::vector<int>, 8> by_colour;
    for (int c = 0; c < cells.cell_count(); ++c) by_colour[static_cast<std::size_t>(cells.colour(c))].push_back(c);
    double done = 0;
    for (const std::vector<int>& colour : by_colour) {
      report(done++ / static_cast<double>(by_colour.size()));
      parallel_chunks(static_cast<int>(colour.size()), 8, [&](int begin, int end) {
        Scratch& mine = scratch_.local();
        for (int c = begin; c < end; ++c) {
          const int cell = colour[static_cast<std::size_t>(c)];
          cells.gather(cell, mine.around_cell);
          for (const int sample : cells.points_in(cell)) {
            find_near(sample, mine);
            move(sample, number, mine);
          }
        }
      });
    }
  }

 private:
  /// What is around one sample: numbers of all samples near, and those that the surface leads to laid out in a plane,
  /// each at its distance. One per thread: it keeps its memory.
  struct Scratch {
    explicit Scratch(const SurfaceGraph& surface) : chart(surface) {}
    std::vector<int> around_cell, near, behind;
    HoleFinder flat;
    dvec3 axis_u{0}, axis_v{0};
    double nearest = 0;
    SurfaceChart chart;
  };
  [[nodiscard]] const SurfaceSample& sample(int i) const { return samples_[static_cast<std::size_t>(i)]; }

  void find_near(int number, Scratch& mine) const {
    const double reach = kReach * spacing_;
    const dvec3& center = sample(number).position;
    mine.near.clear();
    for (const int j : mine.around_cell) {
      const dvec3 apart = sample(j).position - center;
      if (glm::dot(apart, apart) < reach * reach && j != number) mine.near.push_back(j);
    }
  }

  /// Neighbours at their distances: in the directions of the tangent plane, or where the surface bends by more than 60
  /// degrees in those of the unfolded surface.
  void lay_out(const SurfaceSample& self, Scratch& mine) const {
    const double gentle = 0.5, far = kBehind * spacing_;
    mine.axis_u = any_perpendicular(self.normal);
    mine.axis_v = glm::cross(self.normal, mine.axis_u);
    mine.flat.clear();
    mine.behind.clear();
    for (const int j : mine.near) {
      const dvec3 apart = sample(j).position - self.position;
      const bool patch = on_one_patch(self.normal, sample(j).normal, apart);
      if (!(patch && glm::dot(self.normal, sample(j).normal) > gentle) && glm::dot(apart, apart) < far * far)
        mine.behind.push_back(j);
      else if (patch)
        mine.flat.add(stretched(in_tangent_plane(apart, mine), apart));
    }
    if (mine.behind.empty()) return;
    mine.chart.unfold({self.face, self.position}, mine.axis_u, mine.axis_v, far);
    for (const int j : mine.behind) {
      const dvec3 apart = sample(j).position - self.position;
      const bool patch = on_one_patch(self.normal, sample(j).normal, apart);
      dvec2 flat;
      if (mine.chart.find({sample(j).face, sample(j).position}, flat))
        mine.flat.add(patch ? stretched(flat, apart) : flat);
      else if (patch)
        mine.flat.add(stretched(in_tangent_plane(apart, mine), apart));
    }
  }
  static dvec2 in_tangent_plane(const dvec3& v, const Scratch& mine) {
    return {glm::dot(v, mine.axis_u), glm::dot(v, mine.axis_v)};
  }
  /// In the direction of `flat`, as long as `apart`.
  static dvec2 stretched(const dvec2& flat, const dvec3& apart) {
    const double length = squared(flat);
    return length > 0.0 ? flat * std::sqrt(glm::dot(apart, apart) / length) : flat;
  }

  /// The best of four climbs: from the sample itself and from three places around it, turned from sweep to sweep.
  [[nodiscard]] dvec2 best_hole(HoleFinder& others, int sweep) const {
    const double sine = 0.86602540378443865;  // of 60 degrees; a table, because sines differ between machines
    const std::array<dvec2, 3> starts{dvec2(1, 0), dvec2(-0.5, sine), dvec2(-0.5, -sine)};
    const double start_radius = (sweep % 2 == 0 ? 0.8 : -0.8) * spacing_, farthest = 1.5 * spacing_;
    Hole best = others.climb(dvec2(0), spacing_);
    for (const dvec2& start : starts) {
      const Hole hole = others.climb(start_radius * start, spacing_);
      const double wins = 1.0 + 1e-4;  // a tie is no reason to jump
      if (hole.clearance > best.clearance * wins && squared(hole.center) < farthest * farthest) best = hole;
    }
    return best.center;
  }

  void move(int number, int sweep, Scratch& mine) {
    const std::size_t triangle = 3;  // a hole has three sides
    SurfaceSample& self = samples_[static_cast<std::size_t>(number)];
    lay_out(self, mine);
    if (mine.flat.size() < triangle) return;
    const double nearest = mine.flat.clearance(dvec2(0));
    const dvec2 hole = best_hole(mine.flat, sweep);
    const dvec3 way = hole.x * mine.axis_u + hole.y * mine.axis_v;
    for (const double part : {1.0, 0.5, 0.25}) {  // a shorter move may succeed where the surface bends away
      const SurfaceStep step = surface_.walk({self.face, self.position}, part * way);
      const dvec3& normal = surface_.mesh().face_normals()[static_cast<std::size_t>(step.face)];
      if (!clear(step, normal, nearest, mine)) continue;
      self.position = step.position;
      self.normal = normal;
      self.face = step.face;
      return;
    }
  }

  /// Whether all near samples are farther than the square root of `limit` from `step`.
  bool clear(const SurfaceStep& step, const dvec3& normal, double limit, Scratch& mine) const {
    mine.behind.clear();
    for (const int j : mine.near) {
      const dvec3 apart = sample(j).position - step.position;
      if (glm::dot(apart, apart) > limit) continue;
      if (on_one_patch(normal, sample(j).normal, apart)) return false;
      mine.behind.push_back(j);
    }
    if (mine.behind.empty()) return true;
    const dvec3 u = any_perpendicular(normal);
    mine.chart.unfold(step, u, glm::cross(normal, u), std::sqrt(limit));
    dvec2 flat;
    for (const int j : mine.behind)
      if (mine.chart.find({sample(j).face, sample(j).position}, flat) && squared(flat) <= limit) return false;
    return true;
  }

  const SurfaceGraph& surface_;
  double spacing_;
  std::vector<SurfaceSample>& samples_;
  std::vector<dvec3> before_;  // positions at the start of the sweep
  tbb::enumerable_thread_specific<Scratch> scratch_;
};

}  // namespace

void spread_samples(const SurfaceGraph& surface, double spacing, int sweeps, std::vector<SurfaceSample>& samples,
                    Progress* progress) {
  Spreader spreader(surface, spacing, samples);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    spreader.sweep(sweep, [&](double part) {
      if (progress) progress->check((sweep + part) / sweeps);
    });
  }
}

}  // namespace taxel
