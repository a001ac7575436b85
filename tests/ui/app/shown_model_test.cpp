// Models of layouts that are viewed before they can be simulated.
#include "app/studio/host/document/documents.h"

#include <gtest/gtest.h>

#include "core/base/limits.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/topology/remesh.h"
#include "fixtures/pad_meshes.h"

namespace taxel::studio {
namespace {

/// Returns a box of 786 432 triangles.
TriMeshPtr large_box() {
  return std::make_shared<const TriMesh>(subdivide(make_box(dvec3(0.01)), 8, SubdivisionScheme::midpoint));
}

TEST(ShownModel, HasNoBodyForALargeMeshWithoutTaxels) {
  const TriMeshPtr mesh = large_box();
  ASSERT_GT(mesh->face_count(), kManySkinTriangles);
  Layout layout;
  layout.name = "large";
  layout.mesh.file = "box";
  layout.sampling.density = 1234;
  int compiled = 0;
  const auto compile = [&](const Layout& asked) {
    ++compiled;
    return build_sensor_model(asked, share(make_box(dvec3(0.01))), "", "box");
  };
  const ShownModel shown = shown_model(layout, mesh, compile);
  EXPECT_EQ(compiled, 0);
  EXPECT_EQ(shown.model->body, nullptr);
  EXPECT_EQ(shown.model->layout, layout);
  EXPECT_EQ(shown.model->mesh, mesh);
  EXPECT_NEAR(shown.model->sampled_area, 24e-4, 1e-12);
  EXPECT_EQ(shown.problem,
            "786432 triangles: the pressure field follows with the first taxel (1.8 GiB), or first decimate the mesh: "
            "taxel mesh --decimate");

  layout.taxels = {{0, "", dvec3(0, 0, 0.01), dvec3(0, 0, 1), 0.005, {}}};
  EXPECT_NE(shown_model(layout, mesh, compile).model->body, nullptr);
  EXPECT_EQ(compiled, 1) << "a layout with taxels is compiled, however large its mesh is";
}

TEST(ShownModel, IsCompiledForASmallMesh) {
  const TriMeshPtr mesh = share(make_box(dvec3(0.01)));
  Layout layout;
  layout.mesh.file = "box";
  const ShownModel shown =
      shown_model(layout, mesh, [&](const Layout& asked) { return build_sensor_model(asked, mesh, "", "box"); });
  EXPECT_TRUE(shown.model->body->soft());
  EXPECT_EQ(shown.problem, "");
}

}  // namespace
}  // namespace taxel::studio
