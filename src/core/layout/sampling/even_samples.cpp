// Elimination of crowded points, and sweeps that move samples to the holes next to them.
//
// Elimination (Yuksel 2015). Each point crowds its neighbours by (1 - d/(2 r))^8. The most crowded point goes, and its
// neighbours become less crowded. Weights only fall, so points wait in buckets by weight, unsorted, and only the bucket
// whose turn it is becomes a heap. The links of n points are found cell by cell, in O(n).
//
// Spreading (Schloemer, Heck, Deussen 2011). A sample climbs from itself and from three places around it to the centre
// of the largest empty circle among its neighbours, laid out in its tangent plane, and moves there along the surface if
// its nearest neighbour is then farther. This leaves a few gaps; a last sweep moves samples with wide Voronoi cells to
// the centroids of these cells (Lloyd 1982).
//
// Distances are straight on one patch and unfolded around edges and walls (surface_walk.cpp). Cells of one colour are
// so far apart that their samples do not see each other, so the colours are worked on in turn, each by all threads,
// with the same bytes for any number of threads. Pitfall: a flat layout is only nearly right on a curved surface, so
// each move is checked at the place where it ends, and shortened if it fails.
#include "core/layout/sampling/even_samples.h"

#include <array>
#include <functional>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/layout/sampling/empty_circle.h"
#include "core/layout/sampling/surroundings.h"
#include "core/layout/sampling/voronoi_area.h"

namespace taxel {
namespace {

/// Points by weight, the heaviest first, ties by the lower point. Weights may only fall. A bucket finds out which of
/// its points have become lighter when its turn comes.
class CrowdQueue {
 public:
  explicit CrowdQueue(std::vector<double> weights)
      : weights_(std::move(weights)), first_(weights_.size() + 1, kNone), next_(weights_.size()) {
    const double heaviest = *std::max_element(weights_.begin(), weights_.end());
    if (heaviest > 0.0) per_weight_ = static_cast<double>(weights_.size()) / heaviest;
    bucket_ = first_.size();
    for (std::size_t i = weights_.size(); i-- > 0;) wait(static_cast<int>(i));
  }
  [[nodiscard]] std::size_t size() const { return weights_.size() - removed_; }
  /// There is one.
  int pop() {
    for (;; std::pop_heap(ready_.begin(), ready_.end()), ready_.pop_back()) {
      while (ready_.empty()) open_bucket();
      const Item top = ready_.front();
      const double weight = weights_[at(top.point)];
      if (weight == top.weight) break;
      if (bucket_of(weight) < bucket_) {
        wait(top.point);
      } else {
        ready_.push_back({weight, top.point});
        std::push_heap(ready_.begin(), ready_.end());
      }
    }
    const int point = ready_.front().point;
    std::pop_heap(ready_.begin(), ready_.end());
    ready_.pop_back();
    next_[at(point)] = kRemoved;
    ++removed_;
    return point;
  }
  /// Also of a point that is gone.
  void reduce(int point, double by) { weights_[at(point)] -= by; }
  [[nodiscard]] bool holds(int point) const { return next_[at(point)] != kRemoved; }

 private:
  static constexpr int kNone = -1, kRemoved = -2;
  struct Item {
    double weight;
    int point;
    bool operator<(const Item& b) const { return weight != b.weight ? weight < b.weight : point > b.point; }
  };
  [[nodiscard]] std::size_t bucket_of(double weight) const {
    return static_cast<std::size_t>(std::max(0.0, weight * per_weight_));
  }
  void wait(int point) {
    int& first = first_[bucket_of(weights_[at(point)])];
    next_[at(point)] = first;
    first = point;
  }
  void open_bucket() {
    for (int point = first_[--bucket_], next = 0; point != kNone; point = next) {
      next = next_[at(point)];
      const double weight = weights_[at(point)];
      if (bucket_of(weight) < bucket_)
        wait(point);
      else
        ready_.push_back({weight, point});
    }
    std::make_heap(ready_.begin(), ready_.end());
  }

  std::vector<double> weights_;
  std::vector<int> first_, next_;  // lists of the points in each bucket
  double per_weight_ = 0;          // buckets
  std::size_t bucket_ = 0, removed_ = 0;
  std::vector<Item> ready_;  // heap of the items of the last bucket
};

struct CrowdLink {
  int other;
  float crowding;
};

/// Neighbours of every point with the crowding each pair causes, by rank.
struct CrowdGraph {
  std::vector<std::vector<CrowdLink>> parts;  // links of each chunk of cells
  std::vector<std::span<const CrowdLink>> of_point;
};

/// Crowding of Yuksel's equation 3, (1 - d / 2 r_max)^alpha with alpha = 8; distances below 2 r_min count as 2 r_min
/// (equation 5, beta = 0.65, gamma = 1.5). r_max is the radius of the densest packing of `count` discs; here 2 r_max,
/// the spacing, is the unit of length.
class CrowdLinker {
 public:
  CrowdLinker(const SurfaceGraph& surface, const SurfacePool& pool, int count, double spacing)
      : surface_(surface), reach_(spacing), cells_(pool.positions, reach_) {
    const double kept = static_cast<double>(count) / pool.size();
    least_ = static_cast<float>((1.0 - kept * std::sqrt(kept)) * 0.65);
    for (const int i : cells_.points()) {
      positions_.push_back(pool.positions[at(i)]);
      normals_.push_back(pool.normals[at(i)]);
      faces_.push_back(pool.faces[at(i)]);
    }
  }
  /// Pool points by rank.
  [[nodiscard]] const std::vector<int>& points() const { return cells_.points(); }

  [[nodiscard]] CrowdGraph link() const {
    const int chunk = 64;
    CrowdGraph graph;
    graph.of_point.resize(positions_.size());
    graph.parts.resize(at((cells_.cell_count() + chunk - 1) / chunk));
    PerThread<Scratch> scratch([&] { return Scratch(surface_); });
    parallel_chunks(cells_.cell_count(), chunk, [&](int begin, int end) {
      Scratch& mine = scratch.local();
      std::vector<CrowdLink>& links = graph.parts[at(begin / chunk)];
      const CellList::Ranks all{cells_.ranks_in(begin).begin, cells_.ranks_in(end - 1).end};
      std::vector<std::size_t> rows;
      for (int cell = begin; cell < end; ++cell) {
        mine.around.gather(cells_, cell, positions_, normals_, reach_);
        for (std::uint32_t r = cells_.ranks_in(cell).begin; r < cells_.ranks_in(cell).end; ++r) {
          rows.push_back(links.size());
          link_point(r, mine, links);
        }
      }
      rows.push_back(links.size());
      for (std::uint32_t r = all.begin; r < all.end; ++r) {  // now that the links stay where they are
        const std::size_t row = r - all.begin;
        graph.of_point[r] = std::span(links).subspan(rows[row], rows[row + 1] - rows[row]);
      }
    });
    return graph;
  }

 private:
  struct Scratch {
    explicit Scratch(const SurfaceGraph& surface) : chart(surface) {}
    Surroundings around;
    NearPoints near;
    SurfaceChart chart;
  };

  void link_point(std::uint32_t point, Scratch& mine, std::vector<CrowdLink>& links) const {
    mine.around.find_near(mine.around.place(positions_[point], normals_[point]), 1.0F, point, mine.near);
    bool all_on_patch = true;
    for (std::size_t k = 0; k < at(mine.near.count); ++k) {
      if (mine.near.on_patch(k))
        links.push_back({mine.near.rank[k], crowding(mine.near.distance[k])});
      else
        all_on_patch = false;
    }
    if (!all_on_patch) link_behind(point, mine, links);
  }

  /// Adds the links to points around an edge or beyond a wall, with distances along the surface.
  void link_behind(std::uint32_t point, Scratch& mine, std::vector<CrowdLink>& links) const {
    const dvec3 u = any_perpendicular(normals_[point]);
    mine.chart.unfold({faces_[point], positions_[point]}, u, glm::cross(normals_[point], u), reach_);
    for (std::size_t k = 0; k < at(mine.near.count); ++k) {
      const std::size_t other = at(mine.near.rank[k]);
      dvec2 flat;
      if (mine.near.on_patch(k) || !mine.chart.find({faces_[other], positions_[other]}, flat)) continue;
      const double distance = glm::length(flat) / reach_;
      if (distance < 1.0) links.push_back({mine.near.rank[k], crowding(static_cast<float>(distance))});
    }
  }

  [[nodiscard]] float crowding(float distance) const {
    const float free = 1.0F - std::max(distance, least_);
    const float free2 = free * free, free4 = free2 * free2;
    return free4 * free4;
  }

  const SurfaceGraph& surface_;
  double reach_;
  float least_ = 0;
  CellList cells_;
  std::vector<dvec3> positions_, normals_;  // indexed by rank
  std::vector<int> faces_;
};

}  // namespace

std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count, double spacing,
                                   Progress* progress) {
  const CrowdLinker linker(surface, pool, count, spacing);
  const CrowdGraph graph = linker.link();
  std::vector<double> weights(at(pool.size()), 0.0);
  for (const auto& links : graph.of_point)  // weight that each sample adds to its neighbours
    for (const CrowdLink& link : links) weights[at(link.other)] += double(link.crowding);

  CrowdQueue queue(std::move(weights));
  const std::size_t surplus = queue.size() - at(count), report = 1 << 14;
  for (std::size_t n = 0; n < surplus; ++n) {
    if (progress && n % report == 0) progress->check(static_cast<double>(n) / static_cast<double>(surplus));
    for (const CrowdLink& link : graph.of_point[at(queue.pop())]) queue.reduce(link.other, double(link.crowding));
  }
  std::vector<int> kept;
  kept.reserve(queue.size());
  for (std::size_t rank = 0; rank < linker.points().size(); ++rank)
    if (queue.holds(static_cast<int>(rank))) kept.push_back(linker.points()[rank]);
  std::sort(kept.begin(), kept.end());
  return kept;
}

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

  /// Visits all samples, colour by colour. Cells of one colour are at least kSpreadReach spacings apart.
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
      const NearPlace target = mine.around.place(step.position, normal);
      if (!clear(step, normal, target, rank, limit, mine)) continue;
      positions_[rank] = step.position, normals_[rank] = normal, faces_[rank] = step.face;
      mine.around.move(rank, target);
      return;
    }
  }

  /// Returns true if all other samples are at least `limit` from `step`.
  bool clear(const SurfaceStep& step, const dvec3& normal, const NearPlace& target, std::uint32_t rank, float limit,
             Scratch& mine) const {
    NearPoints& close = mine.close;
    mine.around.find_near(target, limit, rank, close);
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
