// Bvh: the structure of the tree, and its traversals compared with a list of boxes.
#include "core/mesh/query/bvh.h"

#include <gtest/gtest.h>

#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool contains(const Aabb& outer, const Aabb& inner) {
  return inner.empty() ||
         (glm::all(glm::lessThanEqual(outer.lo, inner.lo)) && glm::all(glm::lessThanEqual(inner.hi, outer.hi)));
}

/// Expects each primitive in exactly one leaf, each node reached once, children inside their parents, bounded depth.
void expect_sound(const Bvh& bvh, const std::vector<Aabb>& boxes, int max_leaf) {
  std::vector<int> seen(boxes.size(), 0), reached(bvh.nodes().size(), 0);
  struct Visit {
    int node, depth;
  };
  std::vector<Visit> stack;
  if (!bvh.empty()) stack.push_back({0, 0});
  while (!stack.empty()) {
    const Visit visit = stack.back();
    stack.pop_back();
    ++reached[static_cast<std::size_t>(visit.node)];
    ASSERT_LT(visit.depth, Bvh::kMaxDepth - 1);
    const Bvh::Node& node = bvh.nodes()[static_cast<std::size_t>(visit.node)];
    if (node.leaf()) {
      EXPECT_LE(node.count, max_leaf);
      for (int i = node.first; i < node.first + node.count; ++i) {
        const int item = bvh.items()[static_cast<std::size_t>(i)];
        ++seen[static_cast<std::size_t>(item)];
        EXPECT_TRUE(contains(node.box, boxes[static_cast<std::size_t>(item)]));
      }
      continue;
    }
    for (int child = node.first; child < node.first + 2; ++child) {
      EXPECT_TRUE(contains(node.box, bvh.nodes()[static_cast<std::size_t>(child)].box));
      stack.push_back({child, visit.depth + 1});
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(boxes.size()));
  EXPECT_EQ(std::count(reached.begin(), reached.end(), 1), static_cast<std::ptrdiff_t>(bvh.nodes().size()));
}

std::vector<Aabb> random_boxes(std::uint64_t seed, int count) {
  test::RandomStream random(seed);
  std::vector<Aabb> boxes(static_cast<std::size_t>(count));
  for (Aabb& box : boxes) {
    const dvec3 p = random.in_cube(1);
    box.include(p);
    if (random.below(3) != 0) box.include(p + std::pow(10.0, random.uniform(-6, -0.5)) * random.direction());
  }
  return boxes;
}

TEST(Bvh, HoldsEveryPrimitiveOnce) {
  for (const int count : {1, 2, 3, 4, 5, 17, 1000, 20001}) {  // the last is more than choose a split
    for (const int max_leaf : {1, 4}) {
      const std::vector<Aabb> boxes = random_boxes(static_cast<std::uint64_t>(count), count);
      expect_sound(Bvh(boxes, max_leaf), boxes, max_leaf);
    }
  }
  EXPECT_TRUE(Bvh(std::vector<Aabb>{}).empty());
}

TEST(Bvh, HasFullLeavesForFewQueries) {
  const std::vector<Aabb> boxes = random_boxes(5, 3000);
  Bvh quick;
  quick.build(boxes, 4, Bvh::Effort::few_queries);
  expect_sound(quick, boxes, 4);
  for (const Bvh::Node& node : quick.nodes()) {
    if (node.leaf()) continue;
    std::size_t below = 0;  // primitives of both children, if these are leaves
    for (int child = node.first; child < node.first + 2; ++child) {
      const Bvh::Node& part = quick.nodes()[static_cast<std::size_t>(child)];
      below += part.leaf() ? static_cast<std::size_t>(part.count) : 5;
    }
    EXPECT_GT(below, 4U);
  }
  EXPECT_LT(quick.nodes().size(), Bvh(boxes, 4).nodes().size());
}

TEST(Bvh, AcceptsBoxesWithoutPosition) {
  std::vector<Aabb> boxes = random_boxes(7, 50);
  boxes[3] = {dvec3(-kInf), dvec3(kInf)};
  boxes[4] = {dvec3(0, -kInf, 0), dvec3(1, kInf, 1)};
  boxes[5] = Aabb{};
  boxes[6] = {dvec3(1e308), dvec3(1.5e308)};
  boxes[7] = {dvec3(-1.5e308), dvec3(-1e308)};
  expect_sound(Bvh(boxes, 2), boxes, 2);
  // A box of NaN cannot be compared, but it must be in some leaf.
  boxes[8] = {dvec3(kNan), dvec3(kNan)};
  const Bvh bvh(boxes, 2);
  EXPECT_EQ(std::count(bvh.items().begin(), bvh.items().end(), 8), 1);
}

TEST(Bvh, SplitsEqualBoxes) {
  const std::vector<Aabb> boxes(1000, Aabb{dvec3(1), dvec3(2)});
  expect_sound(Bvh(boxes, 4), boxes, 4);
}

TEST(Bvh, KeepsItsDepthBoundedForNestedClusters) {
  // Each box is a thousandth of the previous one: every binned split separates one box.
  std::vector<Aabb> boxes;
  for (int i = 0; i < 100; ++i) {
    const double size = std::pow(10.0, -3.0 * i);
    boxes.push_back({dvec3(0.5 * size), dvec3(size)});
  }
  expect_sound(Bvh(boxes, 1), boxes, 1);
}

TEST(Bvh, IsDeterministicAndKeepsItsMemory) {
  const std::vector<Aabb> boxes = random_boxes(11, 500), fewer = random_boxes(12, 300);
  const Bvh once(boxes);
  Bvh again(boxes);
  const void* nodes = again.nodes().data();
  const void* items = again.items().data();
  again.build(fewer);
  again.build(boxes);
  EXPECT_EQ(again.nodes().data(), nodes);
  EXPECT_EQ(again.items().data(), items);
  EXPECT_EQ(once.items(), again.items());
  ASSERT_EQ(once.nodes().size(), again.nodes().size());
  for (std::size_t i = 0; i < once.nodes().size(); ++i) {
    EXPECT_EQ(once.nodes()[i].first, again.nodes()[i].first);
    EXPECT_EQ(once.nodes()[i].box.lo, again.nodes()[i].box.lo);
  }
}

TEST(Bvh, VisitsExactlyTheOverlappingBoxes) {
  const std::vector<Aabb> boxes = random_boxes(21, 800);
  const Bvh bvh(boxes);
  test::RandomStream random(22);
  std::size_t tested = 0, total = 0;
  for (int i = 0; i < 200; ++i) {
    Aabb query;
    query.include(random.in_cube(1));
    query.include(query.lo + 0.2 * random.direction());
    std::vector<int> found, expected;
    bvh.visit([&](const Aabb& box) { return box.overlaps(query); },
              [&](int item) {
                ++tested;
                if (boxes[static_cast<std::size_t>(item)].overlaps(query)) found.push_back(item);
              });
    for (int b = 0; b < 800; ++b) {
      if (boxes[static_cast<std::size_t>(b)].overlaps(query)) expected.push_back(b);
    }
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    total += 800;
  }
  EXPECT_LT(tested, total / 8);  // a tree is much faster than a list
}

/// Returns the first box along a ray by the same slab test, without a tree.
std::pair<double, int> brute_force(const std::vector<Aabb>& boxes, const Ray& ray) {
  std::pair<double, int> best{ray.t_max, -1};
  const SlabTest slabs(ray);
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    const double t = slabs.entry(boxes[static_cast<std::size_t>(i)], best.first);
    if (t < SlabTest::kMiss && (t < best.first || best.second < 0)) best = {t, i};
  }
  return best;
}

TEST(Bvh, CastsToTheFirstBoxWithTiesToTheLowestNumber) {
  std::vector<Aabb> boxes = random_boxes(31, 400);
  for (std::size_t i = 0; i < 100; ++i) boxes.push_back(boxes[i]);  // ties everywhere
  const Bvh bvh(boxes);
  test::RandomStream random(32);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Ray ray{random.in_cube(1.5), random.direction(), random.below(2) == 0 ? kInf : random.uniform(0, 2)};
    if (random.below(4) == 0) ray.direction = {0, random.below(2) == 0 ? 1 : -1, 0};
    if (random.below(4) == 0) ray.origin = boxes[static_cast<std::size_t>(random.below(500))].lo;  // on slab planes
    const SlabTest slabs(ray);
    int best = -1;
    const double t = bvh.cast(ray, [&](int item, double t_max) {
      const double entry = slabs.entry(boxes[static_cast<std::size_t>(item)], t_max);
      if (entry == SlabTest::kMiss || (entry == t_max && best >= 0 && item > best)) return t_max;
      best = item;
      return entry;
    });
    const auto [expected_t, expected] = brute_force(boxes, ray);
    EXPECT_EQ(best, expected);
    EXPECT_EQ(t, expected_t);
    hits += expected >= 0 ? 1 : 0;
  }
  EXPECT_GT(hits, 400);
}

TEST(SlabTest, IsCorrectForAxisParallelRaysOnAndOffTheFaces) {
  const Aabb box{dvec3(0), dvec3(1, 2, 3)};
  const auto entry = [&](const dvec3& origin, const dvec3& direction) {
    return SlabTest(Ray{origin, direction}).entry(box, 100.0);
  };
  EXPECT_EQ(entry({0.5, -1, 1}, {0, 1, 0}), 1.0);
  EXPECT_EQ(entry({0, -1, 1}, {0, 1, 0}), 1.0);     // in the plane of a face
  EXPECT_EQ(entry({1, -1, 3}, {0, 1, 0}), 1.0);     // along an edge
  EXPECT_EQ(entry({0, -1, 1}, {-0.0, 1, 0}), 1.0);  // the other zero
  EXPECT_EQ(entry({1, -1, 1}, {-0.0, 1, -0.0}), 1.0);
  EXPECT_EQ(entry({1.001, -1, 1}, {0, 1, 0}), SlabTest::kMiss);
  EXPECT_EQ(entry({-0.001, -1, 1}, {-0.0, 1, 0}), SlabTest::kMiss);
  EXPECT_EQ(entry({0.5, 1, 1}, {0, 0, -1}), 0.0);  // from inside
  EXPECT_EQ(entry({0.5, 5, 1}, {0, 1, 0}), SlabTest::kMiss);
  EXPECT_EQ(SlabTest(Ray{{0.5, -1, 1}, {0, 1, 0}}).entry(box, 1.0), 1.0);  // touching at t_max is a hit
  EXPECT_EQ(SlabTest(Ray{{0.5, -1, 1}, {0, 1, 0}}).entry(box, 0.999), SlabTest::kMiss);
}

}  // namespace
}  // namespace taxel
