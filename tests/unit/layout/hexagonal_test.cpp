// The hexagonal lattice over a skin: distances, coverage, slopes, and the painted region.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/layout/generators/pattern.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

const dvec3 kHalfBox{0.03, 0.02, 0.01};  // [m]
constexpr double kTubeRadius = 0.008, kTubeHalf = 0.012;

const MeshIndex& hexagon_box() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_box(kHalfBox)));
  return index;
}
/// A finger along z.
const MeshIndex& finger() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_capsule(kTubeRadius, kTubeHalf, 0.001)));
  return index;
}

PatternTaxels hexagonal(const patterns::Hexagonal& kind, const PlacingFrame& frame, const MeshIndex& skin,
                        const std::vector<int>& faces = {}) {
  Pattern pattern;
  pattern.shape = kind;
  PatternSource source;
  source.frame = frame;
  source.painted = !faces.empty();
  source.faces = faces;
  return make_pattern(pattern, source, skin);
}

const PlacingFrame kTop{dvec3(0, 0, kHalfBox.z), dvec3(0, 0, 1), dvec3(1, 0, 0)};
const PlacingFrame kFront{dvec3(0, -kTubeRadius, 0), dvec3(0, -1, 0), dvec3(1, 0, 0)};

TEST(Hexagonal, HasSixNeighboursAtThePitchOnAPlane) {
  const std::vector<Taxel> taxels = hexagonal({}, kTop, hexagon_box()).taxels;
  // One taxel for each pitch^2 sqrt(3)/2 of the top, up to the margins.
  const double cell = 0.004 * 0.004 * std::sqrt(3.0) / 2, area = 4 * kHalfBox.x * kHalfBox.y;
  EXPECT_NEAR(static_cast<double>(taxels.size()), area / cell, 0.06 * area / cell);
  int inner = 0;
  for (const Taxel& taxel : taxels) {
    EXPECT_NEAR(taxel.center.z, kHalfBox.z, 1e-12) << "the top alone faces the frame";
    double nearest = 1;
    int neighbours = 0;
    for (const Taxel& other : taxels) {
      if (other.id == taxel.id) continue;
      const double distance = glm::distance(other.center, taxel.center);
      nearest = std::min(nearest, distance);
      neighbours += std::abs(distance - 0.004) < 1e-9 ? 1 : 0;
    }
    EXPECT_NEAR(nearest, 0.004, 1e-9) << taxel.id;
    const bool is_inner =
        std::abs(taxel.center.x) < kHalfBox.x - 0.0041 && std::abs(taxel.center.y) < kHalfBox.y - 0.0041;
    if (is_inner) {
      EXPECT_EQ(neighbours, 6) << taxel.id;
    }
    inner += is_inner ? 1 : 0;
  }
  EXPECT_GT(inner, 50);
}

TEST(Hexagonal, PutsATaxelAtTheFrame) {
  PlacingFrame frame = kTop;
  frame.center = {0.0013, -0.0007, kHalfBox.z};
  const std::vector<Taxel> taxels = hexagonal({}, frame, hexagon_box()).taxels;
  EXPECT_TRUE(std::any_of(taxels.begin(), taxels.end(),
                          [&](const Taxel& taxel) { return glm::distance(taxel.center, frame.center) < 1e-12; }));
}

TEST(Hexagonal, LeavesOutSkinThatIsSteeperThanTheSlope) {
  for (const double slope : {30.0, 60.0}) {
    patterns::Hexagonal kind;
    kind.pitch = 0.001;
    kind.max_slope_deg = slope;
    const std::vector<Taxel> taxels = hexagonal(kind, kFront, finger()).taxels;
    double least = 1, widest = 0;
    for (const Taxel& taxel : taxels) {
      least = std::min(least, -taxel.normal.y);
      widest = std::max(widest, std::abs(taxel.center.x));
    }
    EXPECT_GE(least, std::cos(slope * kPi / 180)) << slope;
    // On a cylinder a slope s is at the distance R sin(s) from the middle.
    EXPECT_NEAR(widest, kTubeRadius * std::sin(slope * kPi / 180), 0.0006) << slope;
  }
}

TEST(Hexagonal, CoversOnlyPaintedFaces) {
  std::vector<int> faces;
  for (int face = 0; face < finger().mesh().face_count(); ++face)
    if (finger().mesh().vertex(face, 0).z > 0) faces.push_back(face);
  const std::vector<Taxel> all = hexagonal({}, kFront, finger()).taxels,
                           half = hexagonal({}, kFront, finger(), faces).taxels;
  EXPECT_LT(half.size(), 0.7 * static_cast<double>(all.size()));
  for (const Taxel& taxel : half) EXPECT_GT(taxel.center.z, -0.002) << "a face is 1 mm large";
}

TEST(Hexagonal, RefusesValuesOutOfRange) {
  const auto complaint = [](const patterns::Hexagonal& kind) {
    return test::complaint_of([&] { hexagonal(kind, kTop, hexagon_box()); });
  };
  EXPECT_EQ(complaint({{}, 0.0, 60}), "pitch: must be greater than 0, is 0");
  EXPECT_EQ(complaint({{}, 1e-6, 60}),
            "hexagonal: pitch: 1e-06 m gives more than 100000 points over a mesh of 0.06 x 0.04 m");
  EXPECT_EQ(complaint({{}, 0.004, 91}), "max_slope_deg: must be at most 90, is 91");
  EXPECT_EQ(complaint({{}, std::numeric_limits<double>::infinity(), 60}), "pitch: must be greater than 0, is inf");
}

}  // namespace
}  // namespace taxel
