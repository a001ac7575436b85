// Taxels on a mesh that was replaced under them.
#include "core/document/fixes.h"

#include <gtest/gtest.h>

#include "core/document/edit.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

/// Returns taxels on a sphere of 10 mm that differ only in direction, three millimetres apart.
Layout on_sphere() {
  Layout layout;
  const std::vector<dvec3> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  for (std::size_t i = 0; i < directions.size(); ++i)
    layout.taxels.push_back({static_cast<int>(i) + 4, "", 0.010 * directions[i], directions[i], 0.002, {}});
  layout.taxels[1].subtaxels = {{dvec3(0, 0.010, 0), dvec3(0, 1, 0), 0.001}};
  return layout;
}

TEST(MovedSurface, MeasuresDistancesToTheNewSurface) {
  Layout layout = on_sphere();
  layout.taxels[2].center *= 0.9;  // 9 mm from the centre
  const MeshIndex larger(std::make_shared<TriMesh>(make_icosphere(0.012, 5)));
  const SurfaceDistances distances = distances_to(larger, layout);
  EXPECT_EQ(distances.taxels, 3);
  EXPECT_NEAR(distances.mean, (2 + 2 + 3) * 1e-3 / 3, 1e-5);
  EXPECT_NEAR(distances.largest, 3e-3, 1e-5);
  EXPECT_EQ(distances.farthest, 6);
  EXPECT_EQ(distances_text({3, 2.3333e-3, 3e-3, 6}),
            "3 taxels lie 2.33 mm from its surface on average, taxel 6 the farthest with 3 mm");
  EXPECT_EQ(distances_text({}), "");
}

TEST(MovedSurface, ProjectsTaxelsOntoIt) {
  Project project;
  project.layout = on_sphere();
  const MeshIndex larger(std::make_shared<TriMesh>(make_icosphere(0.012, 5)));
  const Project moved = apply_edit(project, projected_onto(larger, project.layout));
  EXPECT_LT(distances_to(larger, moved.layout).largest, 1e-12);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(glm::length(moved.layout.taxels[i].center), 0.012, 1e-5);
    EXPECT_GT(glm::dot(moved.layout.taxels[i].normal, glm::normalize(project.layout.taxels[i].center)), 0.999);
    EXPECT_EQ(moved.layout.taxels[i].radius, 0.002);
  }
  EXPECT_NEAR(moved.layout.taxels[1].subtaxels[0].center.y, 0.012, 1e-5);
}

}  // namespace
}  // namespace taxel
