#include "core/layout/sample_elimination.h"

#include "core/base/parallel.h"
#include "core/layout/point_grid.h"

namespace taxel {
namespace {

/// A max-heap of points by weight whose weights may fall; ties go to the lower point.
class CrowdHeap {
 public:
  explicit CrowdHeap(std::vector<double> weights) : weight_(std::move(weights)) {
    const std::size_t n = weight_.size();
    heap_.resize(n);
    place_.resize(n);
    for (std::size_t i = 0; i < n; ++i) heap_[i] = place_[i] = static_cast<int>(i);
    for (std::size_t i = n / 2; i-- > 0;) sink(i);
  }
  [[nodiscard]] bool holds(int point) const { return place_[index(point)] >= 0; }
  [[nodiscard]] std::size_t size() const { return heap_.size(); }
  int pop() {
    const int top = heap_.front();
    place_[index(top)] = -1;
    const int last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      put(0, last);
      sink(0);
    }
    return top;
  }
  void reduce(int point, double by) {
    weight_[index(point)] -= by;
    sink(index(place_[index(point)]));
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] bool above(int a, int b) const {
    const double wa = weight_[index(a)], wb = weight_[index(b)];
    return wa != wb ? wa > wb : a < b;
  }
  void put(std::size_t at, int point) {
    heap_[at] = point;
    place_[index(point)] = static_cast<int>(at);
  }
  void sink(std::size_t at) {
    const int point = heap_[at];
    for (;;) {
      std::size_t child = 2 * at + 1;
      if (child >= heap_.size()) break;
      if (child + 1 < heap_.size() && above(heap_[child + 1], heap_[child])) ++child;
      if (!above(heap_[child], point)) break;
      put(at, heap_[child]);
      at = child;
    }
    put(at, point);
  }
  std::vector<double> weight_;
  std::vector<int> heap_, place_;
};

/// Neighbours of every pool point with the crowding each pair causes; row i is [first[i], first[i + 1]).
struct CrowdGraph {
  struct Link {
    int other;
    float crowding;
  };
  std::vector<std::size_t> first;
  std::vector<Link> links;
};

constexpr int kChunk = 1024;

/// Crowding of Yuksel's equation 3, (1 - d / 2 r_max)^alpha with alpha = 8; distances below 2 r_min count as 2 r_min
/// (equation 5, beta = 0.65, gamma = 1.5). r_max is the radius of the densest packing of `count` discs.
CrowdGraph link_neighbours(const SurfacePool& pool, int count, double area) {
  const double r_max = std::sqrt(area / (2.0 * std::sqrt(3.0) * count));
  const double kept = static_cast<double>(count) / pool.size();
  const double r_min = r_max * (1.0 - kept * std::sqrt(kept)) * 0.65;
  const PointGrid grid(pool.positions, 2.0 * r_max);

  const int chunks = (pool.size() + kChunk - 1) / kChunk;
  std::vector<std::vector<CrowdGraph::Link>> links(static_cast<std::size_t>(chunks));
  CrowdGraph graph;
  graph.first.assign(static_cast<std::size_t>(pool.size()) + 1, 0);
  parallel_chunks(pool.size(), kChunk, [&](int begin, int end) {
    std::vector<CrowdGraph::Link>& mine = links[static_cast<std::size_t>(begin / kChunk)];
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      const std::size_t before = mine.size();
      grid.visit_near(pool.positions[i], 2.0 * r_max, [&](int other) {
        const auto j = static_cast<std::size_t>(other);
        const dvec3 apart = pool.positions[i] - pool.positions[j];
        const double d2 = glm::dot(apart, apart);
        if (j == i || d2 >= 4.0 * r_max * r_max || !same_wall(pool.normals[i], pool.normals[j])) return;
        const double free = 1.0 - std::max(std::sqrt(d2), 2.0 * r_min) / (2.0 * r_max);
        const double free2 = free * free, free4 = free2 * free2;
        mine.push_back({other, static_cast<float>(free4 * free4)});
      });
      graph.first[i + 1] = mine.size() - before;
    }
  });
  for (std::size_t i = 0; i + 1 < graph.first.size(); ++i) graph.first[i + 1] += graph.first[i];
  graph.links.reserve(graph.first.back());
  for (const auto& part : links) graph.links.insert(graph.links.end(), part.begin(), part.end());
  return graph;
}

}  // namespace

std::vector<int> eliminate_samples(const SurfacePool& pool, int count, double area, Progress* progress) {
  const CrowdGraph graph = link_neighbours(pool, count, area);
  std::vector<double> weights(static_cast<std::size_t>(pool.size()), 0.0);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t l = graph.first[i]; l < graph.first[i + 1]; ++l) weights[i] += double(graph.links[l].crowding);

  CrowdHeap heap(std::move(weights));
  const std::size_t surplus = heap.size() - static_cast<std::size_t>(count), report = 1 << 14;
  for (std::size_t n = 0; n < surplus; ++n) {
    if (progress && n % report == 0) progress->check(static_cast<double>(n) / static_cast<double>(surplus));
    const auto gone = static_cast<std::size_t>(heap.pop());
    for (std::size_t l = graph.first[gone]; l < graph.first[gone + 1]; ++l)
      if (heap.holds(graph.links[l].other)) heap.reduce(graph.links[l].other, double(graph.links[l].crowding));
  }

  std::vector<int> kept;
  kept.reserve(heap.size());
  for (int i = 0; i < pool.size(); ++i)
    if (heap.holds(i)) kept.push_back(i);
  return kept;
}

}  // namespace taxel
