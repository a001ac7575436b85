// Height fields: their volume, shape and errors.
#include "core/mesh/make/primitives.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/rng.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {
namespace {

HeightField random_field(int rows, int columns) {
  HeightField field{rows, columns, {}, {0.3, 0.2, 0.05}, 0.01};
  const CounterRng rng(5);
  for (int i = 0; i < rows * columns; ++i) field.elevation.push_back(rng.uniform(static_cast<std::uint64_t>(i)));
  return field;
}

/// The volume is a sum of prisms: the area of each triangle times the mean of its three heights.
TEST(HeightField, IsClosedAndHasTheVolumeOfItsPrisms) {
  const HeightField field = random_field(4, 7);
  const TriMesh mesh = make_height_field(field);
  EXPECT_TRUE(mesh.closed());
  EXPECT_EQ(mesh.shell_count(), 1);
  const auto height = [&](int r, int c) {
    return field.base + field.size.z * field.elevation[static_cast<std::size_t>(r * field.columns + c)];
  };
  const double cell = 0.6 / 6 * 0.4 / 3;
  double volume = 0;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 6; ++c)
      volume += cell / 6 * (2 * height(r, c) + 2 * height(r + 1, c + 1) + height(r, c + 1) + height(r + 1, c));
  }
  EXPECT_NEAR(mesh.volume(), volume, 1e-12 * volume);
  EXPECT_EQ(mesh.bounds().lo, dvec3(-0.3, -0.2, -0.01));
  EXPECT_NEAR(mesh.bounds().hi.x, 0.3, 1e-15);
}

TEST(HeightField, RunsColumnsAlongX) {
  HeightField field{2, 3, {0, 0, 1, 0, 0, 1}, {1, 2, 0.5}, 0.1};
  const MeshIndex index(std::make_shared<const TriMesh>(make_height_field(field)));
  const auto top = [&](double x, double y) { return 3 - index.cast({{x, y, 3}, {0, 0, -1}})->t; };
  EXPECT_NEAR(top(-0.5, 1), 0, 1e-12);
  EXPECT_NEAR(top(0.5, -1), 0.25, 1e-12);
  EXPECT_NEAR(top(0.9999, 1.5), 0.5, 1e-3);
}

TEST(HeightField, RefusesBadInput) {
  const auto message = [](const HeightField& field) -> std::string {
    try {
      make_height_field(field);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  HeightField field = random_field(3, 3);
  EXPECT_EQ(message(field), "");
  field.elevation[4] = std::nan("");
  EXPECT_NE(message(field).find("elevation 4"), std::string::npos);
  field.elevation[4] = -0.2;  // down to the base
  EXPECT_NE(message(field).find("elevation 4"), std::string::npos);
  field.elevation.pop_back();
  EXPECT_NE(message(field).find("8 elevations"), std::string::npos);
  EXPECT_NE(message({1, 9, {}, dvec3(1), 1}).find("2 rows"), std::string::npos);
  HeightField flat = random_field(2, 2);
  flat.base = 0;
  EXPECT_NE(message(flat).find("positive"), std::string::npos);
}

}  // namespace
}  // namespace taxel
