#include "core/layout/sampling/sample_spread.h"

#include <array>
#include <functional>

#include "core/base/parallel.h"
#include "core/base/per_thread.h"
#include "core/layout/sampling/convex_polygon.h"
#include "core/layout/sampling/empty_circle.h"
#include "core/layout/sampling/surroundings.h"

namespace taxel {
namespace {

constexpr float kSpreadReach = 2.5F;  // in spacings: how far a sample looks for its neighbours
constexpr float kBehind = 1.5F;       // and for those round an edge or beyond a wall
constexpr double kWide = 0.75;        // a cell that reaches farther than this many spacings lies at a gap; the densest
                                      // packing has 0.577
constexpr float kClose = 0.86F;       // how near to others a sample may come where it closes a gap

float squared_length(const vec2& v) {
  return glm::dot(v, v);
}

/// Moves samples on one surface, sweep by sweep. Lengths in single precision are in spacings.
class Spreader {
 public:
  Spreader(const SurfaceGraph& surface, double spacing, std::vector<SurfaceSample>& samples,
           const IsAllowed& is_allowed)
      : surface_(surface), spacing_(spacing), samples_(samples), is_allowed_(is_allowed), scratch_([this] {
          return Scratch(surface_);
        }) {}

  /// Moves each sample in turn to the largest hole next to it.
  void spread(int sweep, const std::function<void(double)>& report) {
    visit_samples(report, [&](std::uint32_t rank, Scratch& mine) { move_to_hole(rank, sweep, mine); });
  }
  void close_gaps(const std::function<void(double)>& report) {
    visit_samples(report, [&](std::uint32_t rank, Scratch& mine) { move_to_centroid(rank, mine); });
  }

 private:
  /// Surroundings of one sample: all near samples, and the samples that can be reached along the surface, laid out in a
  /// plane, each at its distance. Each thread has one object, which keeps its memory.
  struct Scratch {
    explicit Scratch(const SurfaceGraph& surface) : chart(surface) {}
    Surroundings around;
    NearPoints near, close;
    HoleFinder flat;
    ConvexPolygon cell;
    dvec3 axis_u{0}, axis_v{0};
    SurfaceChart chart;
  };

  /// Cells of one colour are at least kSpreadReach spacings apart, so that no sample of one looks at a sample of
  /// another, and they can be worked on at the same time with the same result in any order.
  template <class Visit>
  void visit_samples(const std::function<void(double)>& report, const Visit& visit) {
    const CellList cells = sort_samples();
    std::array<std::vector<int>, 8> by_colour;
    for (int c = 0; c < cells.cell_count(); ++c) by_colour[static_cast<std::size_t>(cells.colour(c))].push_back(c);
    double done = 0;
    for (const std::vector<int>& colour : by_colour) {
      report(done++ / static_cast<double>(by_colour.size()));
      parallel_chunks(static_cast<int>(colour.size()), 8, [&](int begin, int end) {
        Scratch& mine = scratch_.local();
        for (int c = begin; c < end; ++c) {
          const int cell = colour[static_cast<std::size_t>(c)];
          mine.around.gather(cells, cell, positions_, normals_, spacing_);
          for (std::uint32_t r = cells.ranks_in(cell).begin; r < cells.ranks_in(cell).end; ++r) {
            mine.around.find_near(mine.around.place(positions_[r], normals_[r]), kSpreadReach, r, mine.near);
            lay_out(r, mine);
            visit(r, mine);
          }
        }
      });
    }
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      SurfaceSample& s = samples_[static_cast<std::size_t>(cells.points()[r])];
      s.position = positions_[r], s.normal = normals_[r], s.face = faces_[r];
    }
  }
  CellList sort_samples() {
    positions_.clear();
    for (const SurfaceSample& s : samples_) positions_.push_back(s.position);
    CellList cells(positions_, double(kSpreadReach) * spacing_);
    normals_.resize(samples_.size());
    faces_.resize(samples_.size());
    for (std::size_t r = 0; r < samples_.size(); ++r) {
      const SurfaceSample& s = samples_[static_cast<std::size_t>(cells.points()[r])];
      positions_[r] = s.position, normals_[r] = s.normal, faces_[r] = s.face;
    }
    return cells;
  }
  [[nodiscard]] SurfaceStep place_of(int rank) const {
    return {faces_[static_cast<std::size_t>(rank)], positions_[static_cast<std::size_t>(rank)]};
  }

  /// Neighbours at their distances: in the directions of the tangent plane, or where the surface bends by more than 60
  /// degrees in those of the unfolded surface.
  void lay_out(std::uint32_t rank, Scratch& mine) const {
    const float gentle = 0.5F;
    const NearPoints& near = mine.near;
    mine.axis_u = any_perpendicular(normals_[rank]);
    mine.axis_v = glm::cross(normals_[rank], mine.axis_u);
    mine.flat.clear();
    const glm::vec3 u(mine.axis_u), v(mine.axis_v);
    const auto in_tangent_plane = [&](std::size_t k) {
      const glm::vec3 apart(near.x[k], near.y[k], near.z[k]);
      return stretched({glm::dot(u, apart), glm::dot(v, apart)}, near.distance[k]);
    };
    const auto is_behind = [&](std::size_t k) { return !(near.cosine[k] > gentle) && near.distance[k] < kBehind; };
    bool any_behind = false;
    const auto count = static_cast<std::size_t>(near.count);
    for (std::size_t k = 0; k < count; ++k) {
      if (is_behind(k))
        any_behind = true;
      else if (near.on_patch(k))
        mine.flat.add(in_tangent_plane(k));
    }
    if (!any_behind) return;
    mine.chart.unfold(place_of(static_cast<int>(rank)), mine.axis_u, mine.axis_v, double(kBehind) * spacing_);
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_behind(k)) continue;
      dvec2 unfolded;
      if (mine.chart.find(place_of(near.rank[k]), unfolded)) {
        const vec2 flat(unfolded / spacing_);
        mine.flat.add(near.on_patch(k) ? stretched(flat, near.distance[k]) : flat);
      } else if (near.on_patch(k)) {
        mine.flat.add(in_tangent_plane(k));
      }
    }
  }
  /// Moves a sample along the surface in the direction of `flat`, by the length of `flat`.
  static vec2 stretched(const vec2& flat, float length) {
    const float own = squared_length(flat);
    return own > 0.0F ? flat * (length / std::sqrt(own)) : flat;
  }

  /// The best of four climbs: from the sample itself and from three places around it, turned from sweep to sweep.
  [[nodiscard]] static vec2 best_hole(const HoleFinder& others, int sweep) {
    const float sine = 0.8660254F;  // sine of 60 degrees; a constant, because computed sines differ between machines
    const std::array<vec2, 3> starts{vec2(1, 0), vec2(-0.5F, sine), vec2(-0.5F, -sine)};
    const float start_radius = sweep % 2 == 0 ? 0.8F : -0.8F, farthest = 1.5F;
    Hole best = others.climb(vec2(0), 1.0F);
    for (const vec2& start : starts) {
      const Hole hole = others.climb(start_radius * start, 1.0F);
      const float wins = 1.0F + 1e-4F;  // a tie is no reason to jump
      if (hole.clearance > best.clearance * wins && squared_length(hole.center) < farthest * farthest) best = hole;
    }
    return best.center;
  }

  void move_to_hole(std::uint32_t rank, int sweep, Scratch& mine) {
    const std::size_t triangle = 3;  // a hole has three sides
    if (mine.flat.size() < triangle) return;
    move(rank, dvec2(best_hole(mine.flat, sweep)), std::sqrt(mine.flat.clearance(vec2(0))), mine);
  }

  /// To the centroid of the own Voronoi cell, as Lloyd (1982) does with all points.
  void move_to_centroid(std::uint32_t rank, Scratch& mine) {
    const double half = 2.0;  // half of the side of a square that contains all but the widest cells
    const std::array<dvec2, 4> square{dvec2(-half, -half), dvec2(half, -half), dvec2(half, half), dvec2(-half, half)};
    mine.cell.assign(square);
    for (std::size_t k = 0; k < mine.flat.size() && !mine.cell.empty(); ++k) {
      const dvec2 other(mine.flat.point(k));
      mine.cell.cut(other, -0.5 * glm::dot(other, other));
    }
    if (mine.cell.empty() || !(mine.cell.squared_reach() > kWide * kWide)) return;
    move(rank, mine.cell.centroid(), std::min(kClose, std::sqrt(mine.flat.clearance(vec2(0)))), mine);
  }

  /// Moves a sample by `flat` on the surface, or by a part of it, if all other samples are at least `limit` from its
  /// new place.
  void move(std::uint32_t rank, const dvec2& flat, float limit, Scratch& mine) {
    const dvec3 way = spacing_ * (flat.x * mine.axis_u + flat.y * mine.axis_v);
    for (const double part : {1.0, 0.5, 0.25}) {  // a shorter move may succeed where the surface bends away
      const SurfaceStep step = surface_.walk(place_of(static_cast<int>(rank)), part * way);
      const dvec3& normal = surface_.mesh().face_normals()[static_cast<std::size_t>(step.face)];
      if (is_allowed_ && !is_allowed_(step.position)) continue;
      const NearPlace there = mine.around.place(step.position, normal);
      if (!clear(step, normal, there, rank, limit, mine)) continue;
      positions_[rank] = step.position, normals_[rank] = normal, faces_[rank] = step.face;
      mine.around.move(rank, there);
      return;
    }
  }

  /// Returns true if all other samples are at least `limit` from `step`.
  bool clear(const SurfaceStep& step, const dvec3& normal, const NearPlace& there, std::uint32_t rank, float limit,
             Scratch& mine) const {
    NearPoints& close = mine.close;
    mine.around.find_near(there, limit, rank, close);
    const auto count = static_cast<std::size_t>(close.count);
    for (std::size_t k = 0; k < count; ++k)
      if (close.on_patch(k)) return false;
    if (count == 0) return true;
    const dvec3 u = any_perpendicular(normal);
    const double reach = double(limit) * spacing_;
    mine.chart.unfold(step, u, glm::cross(normal, u), reach);
    dvec2 flat;
    for (std::size_t k = 0; k < count; ++k)
      if (mine.chart.find(place_of(close.rank[k]), flat) && glm::dot(flat, flat) <= reach * reach) return false;
    return true;
  }

  const SurfaceGraph& surface_;
  double spacing_;
  std::vector<SurfaceSample>& samples_;
  const IsAllowed& is_allowed_;
  std::vector<dvec3> positions_, normals_;  // values of the samples, by rank in the cells of the sweep
  std::vector<int> faces_;
  PerThread<Scratch> scratch_;
};

}  // namespace

void spread_samples(const SurfaceGraph& surface, double spacing, int sweeps, std::vector<SurfaceSample>& samples,
                    Progress* progress, const IsAllowed& is_allowed) {
  Spreader spreader(surface, spacing, samples, is_allowed);
  for (int sweep = 0; sweep <= sweeps; ++sweep) {
    const auto report = [&](double part) {
      if (progress) progress->check((sweep + part) / (sweeps + 1));
    };
    if (sweep < sweeps)
      spreader.spread(sweep, report);
    else
      spreader.close_gaps(report);
  }
}

}  // namespace taxel
