// The layouts that the project brings along: the files are what the makers make.
#include "core/layout/presets.h"

#include <gtest/gtest.h>

#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/layout/layout_check.h"
#include "core/layout/layout_json.h"
#include "core/mesh/mesh_io.h"

namespace taxel {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(TAXEL_SOURCE_DIR) / "assets";

TEST(Presets, FingertipFileIsWhatTheMakerMakes) {
  const LoadedMesh loaded = load_mesh(kAssets / "meshes/fingertip.obj");
  const std::string made = layout_to_json(fingertip_layout(MeshIndex(loaded.mesh), loaded.sha256));
  const std::filesystem::path copy = std::filesystem::path(TAXEL_BINARY_DIR) / "fingertip.taxels.json";
  write_file_atomically(copy, made);
  EXPECT_TRUE(read_file(kAssets / "layouts/fingertip.taxels.json") == made) << "differs from " << copy;
}

TEST(Presets, FingertipHasNoProblems) {
  const std::filesystem::path file = kAssets / "layouts/fingertip.taxels.json";
  const Layout layout = read_layout(file);
  const LoadedMesh loaded = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  EXPECT_EQ(check_layout_values(layout, "f").size(), 0U);
  for (const Problem& p : check_layout_on_mesh(layout, MeshIndex(loaded.mesh), loaded.sha256, "f"))
    ADD_FAILURE() << p.pointer << ": " << p.message;
}

TEST(Presets, FingertipIsMirrorSymmetricAndLiesOnTheSkin) {
  const LoadedMesh loaded = load_mesh(kAssets / "meshes/fingertip.obj");
  const MeshIndex skin(loaded.mesh);
  const Layout layout = fingertip_layout(skin);
  ASSERT_EQ(layout.taxels.size(), 12U);
  for (std::size_t k = 0; k < 6; ++k) {
    const Taxel &right = layout.taxels[k], &left = layout.taxels[k + 6];
    EXPECT_EQ(left.center, dvec3(-1, 1, 1) * right.center);
    EXPECT_EQ(left.normal, dvec3(-1, 1, 1) * right.normal);
    EXPECT_GT(right.center.x, 0.0);
    EXPECT_EQ(left.id, right.id + 6);
    EXPECT_EQ(left.name.substr(5), right.name.substr(6));
    const double rounding = 1e-7;
    EXPECT_LT(skin.closest_point(right.center).distance, rounding);
    const double on_other_side = 2e-5;  // facets need not be mirror images
    EXPECT_LT(skin.closest_point(left.center).distance, on_other_side);
  }
}

}  // namespace
}  // namespace taxel
