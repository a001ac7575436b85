// Neighbours of a place compared with all pairs in double precision, and cells of a grid compared with all cells.
#include "core/layout/sampling/surroundings.h"

#include <gtest/gtest.h>

#include <set>

#include "core/layout/sampling/poisson_disk.h"
#include "core/layout/sampling/surface_sample.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/instruction_sets.h"

namespace taxel {
namespace {

struct ByRank {
  ByRank(const SurfacePool& pool, const CellList& cells) {
    for (const int i : cells.points()) {
      positions.push_back(pool.positions[static_cast<std::size_t>(i)]);
      normals.push_back(pool.normals[static_cast<std::size_t>(i)]);
    }
  }
  std::vector<dvec3> positions, normals;
};

TEST(CellList, ContainsAllPointsWithinOneEdgeInItsRows) {
  const SurfacePool pool = make_surface_pool(make_box(dvec3(0.01, 0.02, 0.0003)), 3000, 4);
  const double edge = 0.0017;
  const CellList cells(pool.positions, edge);
  const ByRank sorted(pool, cells);
  for (int c = 0; c < cells.cell_count(); ++c) {
    std::set<std::uint32_t> around;
    for (const CellList::Ranks& row : cells.ranks_around(c))
      for (std::uint32_t r = row.begin; r < row.end; ++r) EXPECT_TRUE(around.insert(r).second);
    for (std::uint32_t r = cells.ranks_in(c).begin; r < cells.ranks_in(c).end; ++r)
      for (std::uint32_t other = 0; other < sorted.positions.size(); ++other) {
        if (glm::distance(sorted.positions[r], sorted.positions[other]) < edge) {
          EXPECT_EQ(around.count(other), 1U);
        }
      }
  }
}

/// Returns whether the surface bends by at most a right angle, and rises by at most 30 degrees plus this bend.
bool on_one_patch(const dvec3& normal_a, const dvec3& normal_b, const dvec3& apart, double slack) {
  const double bend = std::acos(std::clamp(glm::dot(normal_a, normal_b), -1.0, 1.0));
  const double steepest = 0.5 + 1.0 - std::cos(bend) + slack;
  const double rise = std::max(std::abs(glm::dot(normal_a, apart)), std::abs(glm::dot(normal_b, apart)));
  return bend < kPi / 2 + slack && rise <= steepest * glm::length(apart);
}

TEST(Surroundings, FindTheNearPointsOfAllPairs) {
  const double spacing = 0.0011;
  const float reach = 0.9F;
  int patches = 0, others = 0;
  for (const TriMesh& mesh : {make_box(dvec3(0.01, 0.008, 0.0003)), make_icosphere(0.004, 3)}) {
    const SurfacePool pool = make_surface_pool(mesh, 1500, 9);
    const CellList cells(pool.positions, spacing);
    const ByRank sorted(pool, cells);
    Surroundings around;
    NearPoints near;
    for (int c = 0; c < cells.cell_count(); ++c) {
      around.gather(cells, c, sorted.positions, sorted.normals, spacing);
      for (std::uint32_t r = cells.ranks_in(c).begin; r < cells.ranks_in(c).end; ++r) {
        around.find_near(around.place(sorted.positions[r], sorted.normals[r]), reach, r, near);
        std::set<int> found;
        for (std::size_t k = 0; k < static_cast<std::size_t>(near.count); ++k) {
          const auto other = static_cast<std::size_t>(near.rank[k]);
          EXPECT_TRUE(found.insert(near.rank[k]).second);
          const dvec3 apart = sorted.positions[other] - sorted.positions[r];
          EXPECT_LT(glm::distance(dvec3(near.x[k], near.y[k], near.z[k]), apart / spacing), 1e-6);
          EXPECT_NEAR(near.distance[k], glm::length(apart) / spacing, 1e-6);
          const dvec3 &a = sorted.normals[r], &b = sorted.normals[other];
          EXPECT_TRUE(near.on_patch(k) ? on_one_patch(a, b, apart, 1e-3) : !on_one_patch(a, b, apart, -1e-3));
          if (near.on_patch(k)) {
            EXPECT_NEAR(near.cosine[k], glm::dot(a, b), 1e-6);
          }
          ++(near.on_patch(k) ? patches : others);
        }
        for (std::size_t other = 0; other < sorted.positions.size(); ++other) {
          const double distance = glm::distance(sorted.positions[other], sorted.positions[r]) / spacing;
          if (std::abs(distance - double(reach)) < 1e-6) continue;
          EXPECT_EQ(found.count(static_cast<int>(other)), distance < double(reach) && other != r ? 1U : 0U);
        }
      }
    }
  }
  EXPECT_GT(patches, 1000);
  EXPECT_GT(others, 1000);
}

TEST(Surroundings, GiveTheSameBitsOnEveryInstructionSet) {
  const TriMesh mesh = make_box(dvec3(0.01, 0.008, 0.0003));
  const std::vector<SurfaceSample> usual = sample_surface(mesh, 700, 5);
  test::for_each_set([&](std::int64_t target) {
    const std::vector<SurfaceSample> found = test::on_target(target, [&] { return sample_surface(mesh, 700, 5); });
    for (std::size_t i = 0; i < usual.size(); ++i) {
      ASSERT_EQ(found[i].position, usual[i].position);
      ASSERT_EQ(found[i].area, usual[i].area);
    }
  });
}

}  // namespace
}  // namespace taxel
