#include "core/layout/sampling/sample_elimination.h"

#include <tbb/enumerable_thread_specific.h>

#include "core/base/parallel.h"
#include "core/layout/sampling/cell_list.h"

namespace taxel {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// A max-heap of points by weight whose weights may fall; ties go to the lower point.
class CrowdHeap {
 public:
  explicit CrowdHeap(const std::vector<double>& weights) : heap_(weights.size()), place_(weights.size()) {
    for (std::size_t i = 0; i < weights.size(); ++i) heap_[i] = {weights[i], place_[i] = static_cast<int>(i)};
    for (std::size_t i = weights.size() / 2; i-- > 0;) sink(i, heap_[i]);
  }
  [[nodiscard]] bool holds(int point) const { return place_[index(point)] >= 0; }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  int pop() {
    const int top = heap_.front().point;
    place_[index(top)] = -1;
    const Item last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sink(0, last);
    return top;
  }
  void reduce(int point, double by) {
    const std::size_t at = index(place_[index(point)]);
    sink(at, {heap_[at].weight - by, point});
  }

 private:
  struct Item {
    double weight;
    int point;
    [[nodiscard]] bool above(const Item& b) const { return weight != b.weight ? weight > b.weight : point < b.point; }
  };
  void put(std::size_t at, const Item& item) {
    heap_[at] = item;
    place_[index(item.point)] = static_cast<int>(at);
  }
  void sink(std::size_t at, const Item item) {
    for (;;) {
      std::size_t child = 2 * at + 1;
      if (child >= heap_.size()) break;
      if (child + 1 < heap_.size() && heap_[child + 1].above(heap_[child])) ++child;
      if (!heap_[child].above(item)) break;
      put(at, heap_[child]);
      at = child;
    }
    put(at, item);
  }
  std::vector<Item> heap_;
  std::vector<int> place_;  // of each point in the heap, -1: gone
};

struct CrowdLink {
  int other;
  float crowding;
};

/// Neighbours of every pool point with the crowding each pair causes; row i is links[first[i]] to links[last[i]].
struct CrowdGraph {
  std::vector<std::vector<CrowdLink>> parts;  // by chunk of cells
  std::vector<std::span<const CrowdLink>> of_point;
};

/// Crowding of Yuksel's equation 3, (1 - d / 2 r_max)^alpha with alpha = 8; distances below 2 r_min count as 2 r_min
/// (equation 5, beta = 0.65, gamma = 1.5). r_max is the radius of the densest packing of `count` discs.
class CrowdLinker {
 public:
  CrowdLinker(const SurfaceGraph& surface, const SurfacePool& pool, int count)
      : surface_(surface),
        pool_(pool),
        reach_(2.0 * std::sqrt(surface.mesh().area() / (2.0 * std::sqrt(3.0) * count))) {
    const double kept = static_cast<double>(count) / pool.size();
    least_ = reach_ * (1.0 - kept * std::sqrt(kept)) * 0.65;
  }

  [[nodiscard]] CrowdGraph link() const {
    const int chunk = 64;
    const CellList cells(pool_.positions, reach_);
    CrowdGraph graph;
    graph.of_point.resize(pool_.positions.size());
    graph.parts.resize(index((cells.cell_count() + chunk - 1) / chunk));
    tbb::enumerable_thread_specific<Scratch> scratch([&] { return Scratch(surface_); });
    parallel_chunks(cells.cell_count(), chunk, [&](int begin, int end) {
      Scratch& mine = scratch.local();
      std::vector<CrowdLink>& links = graph.parts[index(begin / chunk)];
      std::vector<std::pair<int, std::size_t>> rows;
      for (int cell = begin; cell < end; ++cell) {
        mine.gather(cells, cell, pool_);
        for (const int point : cells.points_in(cell)) {
          rows.emplace_back(point, links.size());
          link_point(point, mine, links);
        }
      }
      for (std::size_t r = 0; r < rows.size(); ++r) {  // now that the links stay where they are
        const std::size_t last = r + 1 < rows.size() ? rows[r + 1].second : links.size();
        graph.of_point[index(rows[r].first)] = std::span(links).subspan(rows[r].second, last - rows[r].second);
      }
    });
    return graph;
  }

 private:
  struct Scratch {
    explicit Scratch(const SurfaceGraph& surface) : chart(surface) {}
    void gather(const CellList& cells, int cell, const SurfacePool& pool) {
      cells.gather(cell, near);
      x.clear(), y.clear(), z.clear();
      for (const int i : near) {
        const dvec3& p = pool.positions[index(i)];
        x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
      }
      squared.resize(near.size());
    }
    std::vector<int> near, behind;
    std::vector<double> x, y, z, squared;  // of `near`, and their squared distances from one point
    SurfaceChart chart;
  };

  void link_point(int point, Scratch& mine, std::vector<CrowdLink>& links) const {
    const dvec3 &here = pool_.positions[index(point)], &normal = pool_.normals[index(point)];
    for (std::size_t k = 0; k < mine.near.size(); ++k) {
      const double dx = mine.x[k] - here.x, dy = mine.y[k] - here.y, dz = mine.z[k] - here.z;
      mine.squared[k] = dx * dx + dy * dy + dz * dz;
    }
    mine.behind.clear();
    for (std::size_t k = 0; k < mine.near.size(); ++k) {
      const int other = mine.near[k];
      if (!(mine.squared[k] < reach_ * reach_) || other == point) continue;
      if (on_one_patch(normal, pool_.normals[index(other)], pool_.positions[index(other)] - here))
        links.push_back({other, crowding(std::sqrt(mine.squared[k]))});
      else
        mine.behind.push_back(other);
    }
    if (!mine.behind.empty()) link_behind(point, mine, links);
  }

  /// Those round an edge or beyond a wall, by the way along the surface.
  void link_behind(int point, Scratch& mine, std::vector<CrowdLink>& links) const {
    const dvec3& normal = pool_.normals[index(point)];
    const dvec3 u = any_perpendicular(normal);
    mine.chart.unfold({pool_.faces[index(point)], pool_.positions[index(point)]}, u, glm::cross(normal, u), reach_);
    for (const int other : mine.behind) {
      dvec2 flat;
      if (!mine.chart.find({pool_.faces[index(other)], pool_.positions[index(other)]}, flat)) continue;
      const double distance = glm::length(flat);
      if (distance < reach_) links.push_back({other, crowding(distance)});
    }
  }

  [[nodiscard]] float crowding(double distance) const {
    const double free = 1.0 - std::max(distance, least_) / reach_;
    const double free2 = free * free, free4 = free2 * free2;
    return static_cast<float>(free4 * free4);
  }

  const SurfaceGraph& surface_;
  const SurfacePool& pool_;
  double reach_, least_;
};

}  // namespace

std::vector<int> eliminate_samples(const SurfaceGraph& surface, const SurfacePool& pool, int count,
                                   Progress* progress) {
  const CrowdGraph graph = CrowdLinker(surface, pool, count).link();
  std::vector<double> weights(index(pool.size()), 0.0);
  for (const auto& links : graph.of_point)  // what each causes to others, which is what its going will take from them
    for (const CrowdLink& link : links) weights[index(link.other)] += double(link.crowding);

  CrowdHeap heap(weights);
  const std::size_t surplus = heap.size() - index(count), report = 1 << 14;
  for (std::size_t n = 0; n < surplus; ++n) {
    if (progress && n % report == 0) progress->check(static_cast<double>(n) / static_cast<double>(surplus));
    for (const CrowdLink& link : graph.of_point[index(heap.pop())])
      if (heap.holds(link.other)) heap.reduce(link.other, double(link.crowding));
  }

  std::vector<int> kept;
  kept.reserve(heap.size());
  for (int i = 0; i < pool.size(); ++i)
    if (heap.holds(i)) kept.push_back(i);
  return kept;
}

}  // namespace taxel
