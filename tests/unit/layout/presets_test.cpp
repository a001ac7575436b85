// The layouts of the project: the files equal the output of the functions that make them.
#include "core/layout/sensor_presets.h"

#include <gtest/gtest.h>

#include <map>

#include "core/base/files.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(TAXEL_SOURCE_DIR) / "assets";

TEST(Presets, EqualTheGeneratedFingertip) {
  const LoadedMesh loaded = load_mesh(kAssets / "meshes/fingertip.obj");
  const std::string made = layout_to_json(fingertip_layout(MeshIndex(loaded.mesh), loaded.sha256));
  const std::filesystem::path copy = std::filesystem::path(TAXEL_BINARY_DIR) / "fingertip.taxels.json";
  write_file_atomically(copy, made);
  EXPECT_TRUE(read_file(kAssets / "layouts/fingertip.taxels.json") == made) << "differs from " << copy;
}

TEST(Presets, HaveNoProblemsOnTheFingertip) {
  const std::filesystem::path file = kAssets / "layouts/fingertip.taxels.json";
  const Layout layout = read_layout(file);
  const LoadedMesh loaded = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  EXPECT_EQ(check_layout_values(layout, "f").size(), 0U);
  for (const Problem& p : check_layout_on_mesh(layout, MeshIndex(loaded.mesh), loaded.sha256, "f"))
    ADD_FAILURE() << p.pointer << ": " << p.message;
}

TEST(Presets, AreMirrorSymmetricAndOnTheSkinOfTheFingertip) {
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

TEST(SensorPresets, HaveNoProblemsOnTheirMeshes) {
  for (const std::string& name : sensor_preset_names()) {
    const SensorPreset preset = make_sensor_preset(name);
    EXPECT_EQ(preset.name, name);
    EXPECT_FALSE(preset.source.empty()) << name;
    EXPECT_FALSE(preset.unverified.empty()) << name;
    const std::string& sha256 = preset.layout.mesh.sha256;
    EXPECT_EQ(sha256, sha256_hex(write_obj(*preset.mesh))) << name;
    Problems problems = check_layout_values(preset.layout, name);
    for (const Problem& p : check_layout_on_mesh(preset.layout, MeshIndex(preset.mesh), sha256, name))
      problems.push_back(p);
    for (const Problem& p : check_layout_mesh(*as_loaded(preset.mesh), name)) problems.push_back(p);
    for (const Problem& p : problems) ADD_FAILURE() << name << p.pointer << ": " << p.message;
    EXPECT_EQ(layout_to_json(make_sensor_preset(name).layout), layout_to_json(preset.layout)) << name;
  }
  EXPECT_THROW(make_sensor_preset("biotack"), Error);
}

/// Numbers of taxels, and distances between neighbours that the sources state.
TEST(SensorPresets, AgreeWithTheirSources) {
  const std::map<std::string, std::size_t> taxels{{"fingertip", 12}, {"icub", 12},      {"biotac", 19},
                                                  {"xela-4x4", 16},  {"xela-4x6", 24},  {"xela-curved", 30},
                                                  {"myrmex", 256},   {"barometers", 4}, {"dense", 26U * 27U}};
  EXPECT_EQ(taxels.size(), sensor_preset_names().size());
  for (const auto& [name, count] : taxels) EXPECT_EQ(make_sensor_preset(name).layout.taxels.size(), count) << name;
  const std::map<std::string, double> pitches{
      {"xela-4x4", 4.7e-3}, {"xela-4x6", 4.7e-3}, {"myrmex", 5e-3}, {"barometers", 6e-3}};
  for (const auto& [name, pitch] : pitches) {
    const std::vector<Taxel> row = make_sensor_preset(name).layout.taxels;
    EXPECT_NEAR(glm::distance(row[0].center, row[1].center), pitch, 1e-12) << name;
  }
  const Layout biotac = make_sensor_preset("biotac").layout;
  EXPECT_NEAR(biotac.taxels[16].center.z, -7e-3, 2e-5) << "E17 lies under the axis";
  EXPECT_NEAR(biotac.taxels[16].center.x, -2.8e-3, 2e-4);
  for (std::size_t e = 0; e < 6; ++e)  // E1 to E6 and E11 to E16 are mirror images, but the facets are not
    EXPECT_LT(glm::distance(biotac.taxels[e].center, dvec3(1, -1, 1) * biotac.taxels[e + 10].center), 2e-4) << e;
  const Layout icub = make_sensor_preset("icub").layout;
  EXPECT_NEAR(glm::distance(icub.taxels[11].center, dvec3(-20.9e-3, 0, 0)), 0.0, 1e-5) << "the tip";
  EXPECT_NEAR(glm::distance(icub.taxels[1].center, dvec3(-10.3e-3, 4.4e-3, 0)), 0.0, 5e-5);
}

}  // namespace
}  // namespace taxel
