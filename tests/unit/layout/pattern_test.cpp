// Patterns of taxels: their places, and the messages for values out of range.
#include "core/layout/generators/pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/layout/sensor_presets.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

const dvec3 kHalf{0.03, 0.02, 0.01};

/// A box whose top is the sensor: 60 x 40 x 20 mm.
const MeshIndex& box_skin() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_box(kHalf)));
  return index;
}
/// A finger along z of radius 8 mm.
const MeshIndex& capsule() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_capsule(0.008, 0.012, 0.001)));
  return index;
}

PatternSource on_top() {
  PatternSource source;
  source.frame = {dvec3(0.002, -0.001, kHalf.z), dvec3(0, 0, 1), dvec3(1, 0, 0)};
  source.sensor = {dvec3(0, 0, 1), dvec3(0, -1, 0)};
  return source;
}

std::string complaint(const Pattern& pattern, const PatternSource& source = on_top()) {
  return test::complaint_of([&] { make_pattern(pattern, source, box_skin()); });
}

/// A pattern of the default values of a kind.
template <class Kind>
Pattern pattern_of(const Kind& kind = {}) {
  Pattern pattern;
  pattern.shape = kind;
  return pattern;
}

TEST(Pattern, CentresAGridAtTheFrameAndRotatesWithIt) {
  patterns::Grid grid;
  grid.rows = 2;
  grid.columns = 3;
  grid.row_pitch = 0.004;
  grid.column_pitch = 0.006;
  Pattern pattern = pattern_of(grid);
  pattern.turn_deg = 90;
  const PatternTaxels made = make_pattern(pattern, on_top(), box_skin());
  ASSERT_EQ(made.taxels.size(), 6U);
  EXPECT_EQ(made.left_out, 0);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      const Taxel& taxel = made.taxels[static_cast<std::size_t>(3 * row + column)];
      // Turned by 90 degrees, columns run along +y and rows along -x.
      const dvec3 expected =
          on_top().frame.center + dvec3(-(row - 0.5) * grid.row_pitch, (column - 1) * grid.column_pitch, 0);
      EXPECT_LT(glm::distance(taxel.center, expected), 1e-12) << row << " " << column;
      EXPECT_EQ(taxel.radius, pattern.radius);
    }
  }
}

TEST(Pattern, OmitsOrRefusesPointsThatMissTheSkin) {
  patterns::Grid grid;
  grid.rows = 1;
  grid.columns = 21;  // 100 mm, over a box of 60
  grid.column_pitch = 0.005;
  Pattern pattern = pattern_of(grid);
  const PatternTaxels made = make_pattern(pattern, on_top(), box_skin());
  EXPECT_EQ(made.taxels.size() + static_cast<std::size_t>(made.left_out), 21U);
  for (const Taxel& taxel : made.taxels) EXPECT_LE(std::abs(taxel.center.x), kHalf.x);
  EXPECT_EQ(made.taxels.size(), 12U) << "x = 2 mm + 5 mm k within 30 mm: k = -6 ... 5";
  pattern.leave_out = false;
  EXPECT_NE(complaint(pattern).find("misses the mesh"), std::string::npos);
  std::get<patterns::Grid>(pattern.shape).projected = false;  // a plane needs no skin below
  EXPECT_EQ(make_pattern(pattern, on_top(), box_skin()).taxels.size(), 21U);
  Pattern beside;
  PatternSource away = on_top();
  away.frame.center.x = 1.0;
  EXPECT_EQ(complaint(beside, away), "curved grid: no point of the pattern lies over the skin");
}

TEST(Pattern, IgnoresObstaclesInFrontOfTheSkin) {
  // A fork of two plates: the frame lies on the lower one, below the upper one.
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (const double z : {0.0, 0.01}) {
    const TriMesh plate = make_box(dvec3(0.02, 0.02, 0.001));
    const int first = static_cast<int>(vertices.size());
    for (const dvec3& p : plate.vertices()) vertices.push_back(p + dvec3(0, 0, z));
    for (const ivec3& f : plate.faces()) faces.push_back(f + first);
  }
  const MeshIndex fork(std::make_shared<TriMesh>(std::move(vertices), std::move(faces)));
  PatternSource source = on_top();
  source.frame.center = {0, 0, 0.001};
  for (const Pattern& pattern : {pattern_of<patterns::Grid>(), pattern_of<patterns::Spiral>()}) {
    const std::vector<Taxel> taxels = make_pattern(pattern, source, fork).taxels;
    EXPECT_FALSE(taxels.empty());
    for (const Taxel& taxel : taxels) EXPECT_NEAR(taxel.center.z, 0.001, 1e-12);
  }
}

TEST(Pattern, PlacesARingAtTheHeightOfTheFrame) {
  PatternSource source = on_top();
  source.frame = {dvec3(0, -0.008, 0.004), dvec3(0, -1, 0), dvec3(1, 0, 0)};
  patterns::Ring eight;
  eight.count = 8;
  const PatternTaxels ring = make_pattern(pattern_of(eight), source, capsule());
  ASSERT_EQ(ring.taxels.size(), 8U);
  EXPECT_LT(glm::distance(ring.taxels[0].center, source.frame.center), 2e-4) << "the first one is at the frame";
  for (const Taxel& taxel : ring.taxels) {
    EXPECT_NEAR(taxel.center.z, 0.004, 1e-9);
    EXPECT_NEAR(std::hypot(taxel.center.x, taxel.center.y), 0.008, 2e-4);
  }
  patterns::Helix rising;
  rising.count = 8;
  rising.rise = 0.01;
  const PatternTaxels helix = make_pattern(pattern_of(rising), source, capsule());
  EXPECT_NEAR(helix.taxels.front().center.z, -0.001, 1e-9);
  EXPECT_NEAR(helix.taxels.back().center.z, 0.009, 1e-9);
}

TEST(Pattern, KeepsASpreadInThePaintedFaces) {
  PatternSource source = on_top();
  patterns::Spread ten;
  ten.count = 10;
  const Pattern pattern = pattern_of(ten);
  source.painted = true;
  EXPECT_EQ(complaint(pattern, source), "faces: none of the painted faces is on the skin: paint it again");
  for (int face = 0; face < box_skin().mesh().face_count(); ++face)
    if (box_skin().mesh().face_normals()[static_cast<std::size_t>(face)].z > 0.5) source.faces.push_back(face);
  const PatternTaxels made = make_pattern(pattern, source, box_skin());
  ASSERT_EQ(made.taxels.size(), 10U);
  EXPECT_GT(made.least_distance, 0.008);
  for (const Taxel& taxel : made.taxels) EXPECT_NEAR(taxel.center.z, kHalf.z, 1e-12);
}

TEST(Pattern, PlacesATableInItsUnitOnTheSkin) {
  PatternSource source = on_top();
  Pattern pattern = pattern_of<patterns::Table>();
  auto& table = std::get<patterns::Table>(pattern.shape);
  EXPECT_EQ(complaint(pattern, source), "choose a CSV file with columns x, y and z");
  source.table_file = "points.csv";
  source.table = "x,y,z\n1,2,11\n-3,4,10.5\n";
  const PatternTaxels made = make_pattern(pattern, source, box_skin());
  ASSERT_EQ(made.taxels.size(), 2U);
  EXPECT_LT(glm::distance(made.taxels[1].center, dvec3(-0.003, 0.004, kHalf.z)), 1e-12);
  EXPECT_EQ(made.taxels[1].radius, pattern.radius);
  table.unit = TableUnit::m;
  EXPECT_NE(complaint(pattern, source).find("is the unit another one?"), std::string::npos);
  table.unit = TableUnit::mm;
  table.onto_skin = false;
  EXPECT_EQ(complaint(pattern, source), "points.csv: has no normals: bring its taxels onto the skin");
  source.table = "x,y,z\n1,2,here\n";
  EXPECT_EQ(complaint(pattern, source), "points.csv: line 2, column Z: must be a number, is \"here\"");
}

TEST(Pattern, PlacesDotsOfAnImageOnTheSkin) {
  PatternSource source = on_top();
  Pattern pattern = pattern_of<patterns::Image>();
  EXPECT_EQ(complaint(pattern, source), "choose a PNG or JPEG picture with dots");
  GreyImage image{20, 10, std::vector<std::uint8_t>(200, 255)};
  for (const int pixel : {2 * 20 + 3, 2 * 20 + 4, 3 * 20 + 3, 3 * 20 + 4})
    image.grey[static_cast<std::size_t>(pixel)] = 0;
  source.image = std::make_shared<const GreyImage>(image);
  std::get<patterns::Image>(pattern.shape).width = 0.02;  // a millimetre a pixel
  const PatternTaxels made = make_pattern(pattern, source, box_skin());
  ASSERT_EQ(made.taxels.size(), 1U);
  // Centre at pixel (4, 3), of a picture whose middle is (10, 5): 6 to the left, 2 up.
  EXPECT_LT(glm::distance(made.taxels[0].center, source.frame.center + dvec3(-0.006, 0.002, 0)), 1e-12);
}

TEST(Pattern, PlacesPresetsOnAnySkin) {
  PatternSource source = on_top();
  Pattern pattern = pattern_of<patterns::Preset>();
  std::string& chosen = std::get<patterns::Preset>(pattern.shape).name;
  for (const std::string& name : sensor_preset_names()) {
    chosen = name;
    const SensorPreset preset = make_sensor_preset(name);
    const PatternTaxels made = make_pattern(pattern, source, box_skin());
    EXPECT_EQ(made.taxels.size() + static_cast<std::size_t>(made.left_out), preset.layout.taxels.size()) << name;
    for (const Taxel& taxel : made.taxels)
      EXPECT_LT(box_skin().closest_point(taxel.center).distance, 1e-9) << name << " " << taxel.id;
  }
  // On its own mesh a sensor that goes round lies where it lies.
  const SensorPreset biotac = make_sensor_preset("biotac");
  source.sensor = biotac.layout.frame;
  chosen = "biotac";
  const PatternTaxels same = make_pattern(pattern, source, MeshIndex(biotac.mesh));
  for (std::size_t i = 0; i < same.taxels.size(); ++i)
    EXPECT_LT(glm::distance(same.taxels[i].center, biotac.layout.taxels[i].center), 1e-6) << i;
}

TEST(Pattern, ErrorNamesTheKeyTheRuleAndTheValueInSi) {
  Pattern p;
  p.radius = 0;
  EXPECT_EQ(complaint(p), "radius: must be greater than 0, is 0");
  p.radius = -0.004;
  EXPECT_EQ(complaint(p), "radius: must be greater than 0, is -0.004");
  patterns::Grid grid;
  grid.rows = 0;
  EXPECT_EQ(complaint(pattern_of(grid)), "rows: must be 1 to 100000, is 0");
  grid.rows = grid.columns = 1000;
  EXPECT_EQ(complaint(pattern_of(grid)), "grid: rows: 1000 x 1000 columns are more than 100000 taxels");
  grid = {};
  grid.row_pitch = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint(pattern_of(grid)), "row_pitch: must be greater than 0, is inf");
  patterns::Spread spread;
  spread.count = 100'001;
  EXPECT_EQ(complaint(pattern_of(spread)), "count: must be 1 to 100000, is 100001");
  patterns::Helix helix;
  helix.count = 1;
  EXPECT_EQ(complaint(pattern_of(helix)), "count: must be 2 to 100000, is 1");
  helix.count = 4;
  helix.turns = 0;
  EXPECT_EQ(complaint(pattern_of(helix)), "turns: must not be 0");
  patterns::Preset preset;
  preset.name = "glove";
  EXPECT_NE(complaint(pattern_of(preset)).find("glove is unknown"), std::string::npos);
  p = {};
  p.turn_deg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(complaint(p), "turn_deg: must be a number");
}

TEST(Pattern, KindsShareTheValuesOfTheirCommonKeys) {
  patterns::Ring ring;
  ring.count = 8;
  ring.axis = PatternAxis::y;
  PatternShape helix = patterns::Helix(), spiral = patterns::Spiral(), grid = patterns::Grid();
  for (PatternShape* other : {&helix, &spiral, &grid}) copy_shared_values(ring, *other);
  EXPECT_EQ(std::get<patterns::Helix>(helix).count, 8);
  EXPECT_EQ(std::get<patterns::Helix>(helix).axis, PatternAxis::y);
  EXPECT_EQ(std::get<patterns::Helix>(helix).turns, patterns::Helix().turns);
  EXPECT_EQ(std::get<patterns::Spiral>(spiral).count, 8);
  EXPECT_EQ(grid, PatternShape(patterns::Grid()));
}

TEST(Pattern, RunsRowsAcrossTheSensor) {
  const SensorFrame finger{dvec3(0, 0, 1), dvec3(0, -1, 0)};
  EXPECT_LT(glm::distance(row_direction(finger, {0, -1, 0}), dvec3(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::distance(row_direction(finger, {1, 0, 0}), dvec3(0, 0, 1)), 1e-12) << "its side: along it";
  const dvec3 slanted = glm::normalize(dvec3(1, -1, 0.5));
  EXPECT_NEAR(glm::dot(row_direction(finger, slanted), slanted), 0, 1e-12);
}

}  // namespace
}  // namespace taxel
