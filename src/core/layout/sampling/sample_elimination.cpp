#include "core/layout/sampling/sample_elimination.h"

#include "core/base/index.h"
#include "core/base/parallel.h"
#include "core/base/per_thread.h"
#include "core/layout/sampling/surroundings.h"

namespace taxel {
namespace {

/// Points by weight, the heaviest first, ties by the lower point. Weights may only fall: so does the heaviest, and
/// points wait in buckets of a range of weights each, unsorted, until it is the turn of theirs. A bucket learns only
/// then which of its points have become lighter.
class CrowdQueue {
 public:
  explicit CrowdQueue(std::vector<double> weights)
      : weights_(std::move(weights)), first_(weights_.size() + 1, kNone), next_(weights_.size()) {
    const double heaviest = *std::max_element(weights_.begin(), weights_.end());
    if (heaviest > 0.0) per_weight_ = static_cast<double>(weights_.size()) / heaviest;
    bucket_ = first_.size();
    for (std::size_t i = weights_.size(); i-- > 0;) wait(static_cast<int>(i));
  }
  [[nodiscard]] std::size_t size() const { return weights_.size() - gone_; }
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
    next_[at(point)] = kGone;
    ++gone_;
    return point;
  }
  /// Also of a point that is gone.
  void reduce(int point, double by) { weights_[at(point)] -= by; }
  [[nodiscard]] bool holds(int point) const { return next_[at(point)] != kGone; }

 private:
  static constexpr int kNone = -1, kGone = -2;
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
  std::size_t bucket_ = 0, gone_ = 0;
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

}  // namespace taxel
