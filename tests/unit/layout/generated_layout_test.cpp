// Layouts that patterns make without a window: values from texts, conditions on faces, directions, and messages.
#include "core/layout/generators/generated_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;

const fs::path kFinger = fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj";

TEST(PatternTexts, ListEveryFieldOfEveryKindOnce) {
  const std::vector<PatternFieldHelp> fields = pattern_fields();
  for (const PatternShape& shape : each_alternative<PatternShape>()) {
    Pattern pattern;
    pattern.shape = shape;
    visit_fields(pattern, [&](const FieldSpec& field, const auto& /*value*/) {
      EXPECT_EQ(std::count_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == field.key; }), 1)
          << field.key;
    });
  }
  EXPECT_EQ(pattern_words().size(), std::variant_size_v<PatternShape>);
}

TEST(PatternTexts, SetNumbersWithUnitsWordsAndSwitches) {
  const Pattern grid = pattern_of_texts("grid", {{"rows", "5"}, {"row_pitch", "2 mm"}, {"projected", "false"}});
  EXPECT_EQ(std::get<patterns::Grid>(grid.shape).rows, 5);
  EXPECT_DOUBLE_EQ(std::get<patterns::Grid>(grid.shape).row_pitch, 0.002);
  EXPECT_FALSE(std::get<patterns::Grid>(grid.shape).projected);
  const Pattern ring = pattern_of_texts("ring", {{"axis", "X"}, {"turn_deg", "30"}});
  EXPECT_EQ(std::get<patterns::Ring>(ring.shape).axis, PatternAxis::x);
  EXPECT_EQ(ring.turn_deg, 30);
}

TEST(PatternTexts, SetTheRadiusByThePitchUnlessItIsGiven) {
  EXPECT_DOUBLE_EQ(pattern_of_texts("hexagonal", {{"pitch", "5mm"}}).radius, 0.004);
  EXPECT_DOUBLE_EQ(pattern_of_texts("hexagonal", {{"pitch", "5mm"}, {"radius", "3mm"}}).radius, 0.003);
  EXPECT_DOUBLE_EQ(pattern_of_texts("grid", {{"row_pitch", "5mm"}, {"column_pitch", "3mm"}}).radius, 0.0024);
  EXPECT_DOUBLE_EQ(pattern_of_texts("spread", {}).radius, Pattern().radius);
}

TEST(PatternTexts, RefuseUnknownKindsKeysAndValues) {
  const auto complaint = [](const char* kind, const PatternTexts& values) {
    return complaint_of([&] { (void)pattern_of_texts(kind, values); });
  };
  EXPECT_EQ(
      complaint("hexagon", {}),
      "pattern: must be one of grid, hexagonal, ring, helix, spiral, spread, table, image, preset, is \"hexagon\"; "
      "did you mean \"hexagonal\"?");
  EXPECT_EQ(complaint("hexagonal", {{"rise", "1 mm"}}),
            "rise: is no value of the pattern hexagonal, which has pitch, max_slope_deg, turn_deg, radius");
  EXPECT_EQ(complaint("ring", {{"axis", "w"}}), "axis: must be one of \"distal\", \"X\", \"Y\", \"Z\", is \"w\"");
  EXPECT_EQ(complaint("ring", {{"count", "2.5"}}), "count: must be a whole number, is \"2.5\"");
  EXPECT_EQ(complaint("grid", {{"projected", "yes"}}), "projected: must be true or false, is \"yes\"");
  EXPECT_NE(complaint("hexagonal", {{"pitch", "4 N"}}).find("pitch: \"4 N\": "), std::string::npos);
}

TEST(FaceConditions, SelectFacesByPlaceAndNormal) {
  const TriMesh box = make_box({0.03, 0.02, 0.01});
  EXPECT_EQ(faces_where("nz > 0.5", box).size(), 2U);
  EXPECT_EQ(faces_where("nz > 0.5, x < 0", box).size(), 1U);
  const std::vector<int> sides = faces_where("z > -9.9 mm, z < 9.9mm", box);
  EXPECT_EQ(sides.size(), 8U);
  EXPECT_TRUE(std::is_sorted(sides.begin(), sides.end()));
}

TEST(FaceConditions, RefuseUnreadableTextsAndEmptyRegions) {
  const TriMesh box = make_box({0.03, 0.02, 0.01});
  const auto complaint = [&](const char* text) { return complaint_of([&] { (void)faces_where(text, box); }); };
  EXPECT_EQ(complaint("z = 3"), "region: \"z = 3\" has no < or >; write it as in \"z > 5 mm, ny < -0.3\"");
  EXPECT_EQ(complaint("h > 3"),
            "region: \"h > 3\": the variable must be x, y, z (place) or nx, ny, nz (normal), is \"h\"");
  EXPECT_NE(complaint("z > 3 kg").find("region: \"z > 3 kg\": "), std::string::npos);
  EXPECT_EQ(complaint("z > 5"), "region: no face of the mesh satisfies \"z > 5\"");
}

TEST(GenerateLayout, CoversThePadOfTheFingertip) {
  const GeneratedLayout made = generate_layout(kFinger, {.values = {{"pitch", "4mm"}}});
  const Layout& layout = made.layout;
  EXPECT_GT(layout.taxels.size(), 15U);
  EXPECT_EQ(layout.frame.pad, dvec3(0, -1, 0)) << "guessed";
  EXPECT_EQ(layout.frame.distal, dvec3(0, 0, 1));
  EXPECT_EQ(made.notes.size(), 2U) << "the unit and the directions are guesses";
  const MeshIndex skin(load_mesh(kFinger).mesh);
  for (const Taxel& taxel : layout.taxels) {
    EXPECT_LT(taxel.normal.y, -0.49) << "a slope of up to 60 degrees";
    EXPECT_LT(skin.closest_point(taxel.center).distance, 1e-6);
  }
  EXPECT_GT(layout.material.modulus, 0);
}

TEST(GenerateLayout, TakesDirectionsRegionAndScaleOfTheRequest) {
  GenerateRequest request{.values = {{"pitch", "3mm"}}, .region = "z > 15 mm"};
  request.pad = dvec3(2, 0, 0);
  request.distal = dvec3(0.1, 0, 1);
  request.scale = dvec3(1);
  const GeneratedLayout made = generate_layout(kFinger, request);
  EXPECT_TRUE(made.notes.empty());
  EXPECT_EQ(made.layout.frame.pad, dvec3(1, 0, 0));
  EXPECT_LT(glm::distance(made.layout.frame.distal, dvec3(0, 0, 1)), 1e-12) << "at right angles to pad";
  EXPECT_FALSE(made.layout.sampling.region->empty());
  for (const Taxel& taxel : made.layout.taxels) {
    EXPECT_GT(taxel.normal.x, 0.49);
    EXPECT_GT(taxel.center.z, 0.014);
  }
}

TEST(GenerateLayout, NamesMeshAndOptionInErrors) {
  const std::string file = kFinger.string();
  const auto complaint = [&](const GenerateRequest& request) {
    return complaint_of([&] { (void)generate_layout(kFinger, request); });
  };
  GenerateRequest parallel;
  parallel.pad = dvec3(0, 0, 1);
  parallel.distal = dvec3(0, 0, -2);
  EXPECT_EQ(complaint(parallel), file + ": distal: must not be parallel to pad");
  GenerateRequest far;
  far.at = dvec3(1, 0, 0);
  EXPECT_NE(complaint(far).find(file + ": at: is 0.99"), std::string::npos) << complaint(far);
  EXPECT_EQ(complaint({.kind = "ring", .region = "z > 0"}), "region: does not limit the pattern ring");
  EXPECT_EQ(complaint({.values = {{"pitch", "-1"}}}), file + ": pitch: must be greater than 0, is -1");
  EXPECT_EQ(complaint_of([] { (void)generate_layout("gone.obj", {}); }).find("gone.obj: "), 0U);
}

TEST(GenerateLayout, AsksForThePadOfAShapeWithoutATip) {
  const fs::path plate = fs::path(testing::TempDir()) / "generate_plate.obj";
  save_mesh(plate, make_box({0.02, 0.02, 0.002}));
  EXPECT_EQ(complaint_of([&] { (void)generate_layout(plate, {}); }),
            plate.string() + ": pad: the touching side cannot be guessed from the shape: give it with --pad X,Y,Z");
  GenerateRequest request;
  request.pad = dvec3(0, 0, 1);
  EXPECT_GT(generate_layout(plate, request).layout.taxels.size(), 80U);
}

}  // namespace
}  // namespace taxel
