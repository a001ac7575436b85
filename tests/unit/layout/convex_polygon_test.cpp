// Half-planes clip a polygon: areas and centroids that are easy to compute by hand.
#include "core/layout/sampling/voronoi_area.h"

#include <gtest/gtest.h>

#include <array>

namespace taxel {
namespace {

ConvexPolygon square() {
  ConvexPolygon polygon;
  polygon.assign(std::array{dvec2(0, 0), dvec2(2, 0), dvec2(2, 2), dvec2(0, 2)});
  return polygon;
}

TEST(ConvexPolygon, HasAreaAndCentroid) {
  const ConvexPolygon polygon = square();
  EXPECT_DOUBLE_EQ(polygon.area(), 4.0);
  EXPECT_DOUBLE_EQ(polygon.centroid().x, 1.0);
  EXPECT_DOUBLE_EQ(polygon.centroid().y, 1.0);
  EXPECT_DOUBLE_EQ(polygon.squared_reach(), 8.0);
}

TEST(ConvexPolygon, LosesACorner) {
  ConvexPolygon polygon = square();
  polygon.cut(dvec2(1, 1), -3.0);  // keeps x + y <= 3 and removes a triangle of area 1/2 and centroid (5/3, 5/3)
  EXPECT_DOUBLE_EQ(polygon.area(), 3.5);
  EXPECT_NEAR(polygon.centroid().x, (4.0 - 0.5 * 5.0 / 3.0) / 3.5, 1e-15);
  EXPECT_NEAR(polygon.centroid().y, polygon.centroid().x, 1e-15);
  EXPECT_DOUBLE_EQ(polygon.squared_reach(), 5.0);
}

TEST(ConvexPolygon, IsEmptyOrWholeBeyondTheLine) {
  ConvexPolygon polygon = square();
  polygon.cut(dvec2(1, 0), -2.0);
  EXPECT_DOUBLE_EQ(polygon.area(), 4.0);
  polygon.cut(dvec2(1, 0), 0.5);
  EXPECT_TRUE(polygon.empty());
}

}  // namespace
}  // namespace taxel
