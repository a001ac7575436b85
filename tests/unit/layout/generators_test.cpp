// Generators of taxels: closed forms, laws, and the parameter that an error names.
#include <gtest/gtest.h>

#include <numeric>

#include "core/base/rng.h"
#include "core/layout/generators/arrays.h"
#include "core/layout/generators/geodesic_spread.h"
#include "core/layout/generators/mirror.h"
#include "core/layout/generators/place.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

const double kInfinity = std::numeric_limits<double>::infinity();

MeshIndex index_of(TriMesh mesh) {
  return MeshIndex(std::make_shared<TriMesh>(std::move(mesh)));
}

template <class Make>
void expect_error(const std::string& start, const Make& make) {
  try {
    make();
    ADD_FAILURE() << "no error: " << start;
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).substr(0, start.size()), start) << e.what();
  }
}

Grid tilted_grid() {
  Grid grid;
  grid.rows = 4;
  grid.columns = 6;
  grid.row_pitch = 0.003;
  grid.column_pitch = 0.0047;
  grid.center = {0.01, -0.02, 0.03};
  grid.along_row = {1, 2, 2};
  grid.normal = {2, 1, -2};
  return grid;
}

TEST(PlanarGrid, HasExactPitches) {
  const Grid grid = tilted_grid();
  const std::vector<Taxel> taxels = planar_grid(grid);
  ASSERT_EQ(taxels.size(), 24U);
  dvec3 middle(0);
  for (int i = 0; i < 24; ++i) {
    const Taxel& a = taxels[static_cast<std::size_t>(i)];
    EXPECT_EQ(a.id, i);
    middle += a.center / 24.0;
    EXPECT_NEAR(glm::dot(a.center - grid.center, dvec3(2, 1, -2) / 3.0), 0.0, 1e-16);
    EXPECT_NEAR(glm::distance(a.normal, dvec3(2, 1, -2) / 3.0), 0.0, 1e-15);
    for (int j = 0; j < 24; ++j) {
      const double rows = 0.003 * (i / 6 - j / 6), columns = 0.0047 * (i % 6 - j % 6);
      EXPECT_NEAR(glm::distance(a.center, taxels[static_cast<std::size_t>(j)].center), std::hypot(rows, columns),
                  1e-16);
    }
  }
  EXPECT_NEAR(glm::distance(middle, grid.center), 0.0, 1e-16);
  EXPECT_NEAR(glm::distance(taxels[1].center - taxels[0].center, 0.0047 * dvec3(1, 2, 2) / 3.0), 0.0, 1e-16);
}

TEST(PlanarGrid, NamesTheParameterInErrors) {
  const auto with = [](auto change) {
    Grid grid = tilted_grid();
    change(grid);
    return [grid] { planar_grid(grid); };
  };
  expect_error("grid: rows: must be at least 1, is 0", with([](Grid& g) { g.rows = 0; }));
  expect_error("grid: rows: 50000 x 3 columns are more", with([](Grid& g) { g.rows = 50000, g.columns = 3; }));
  expect_error("grid: columns: must be at least 1", with([](Grid& g) { g.columns = -2; }));
  expect_error("grid: row_pitch: must be finite and greater than 0", with([](Grid& g) { g.row_pitch = 0; }));
  expect_error("grid: column_pitch: ", with([](Grid& g) { g.column_pitch = std::nan(""); }));
  expect_error("grid: radius: ", with([](Grid& g) { g.radius = kInfinity; }));
  expect_error("grid: center: must be finite", with([](Grid& g) { g.center.y = kInfinity; }));
  expect_error("grid: normal: must be a direction", with([](Grid& g) { g.normal = dvec3(0); }));
  expect_error("grid: along_row: must not be parallel", with([](Grid& g) { g.along_row = -g.normal; }));
}

/// A grid over a sphere: every taxel is on the sphere, below its point of the plane, with its normal along the radius.
TEST(CurvedGrid, KeepsThePitchSeenAlongTheProjection) {
  const double r = 0.02;
  const MeshIndex sphere = index_of(make_icosphere(r, 5));
  Grid grid;
  grid.rows = grid.columns = 5;
  grid.row_pitch = grid.column_pitch = 0.004;
  grid.center = {0, 0, 0.05};
  const std::vector<Taxel> flat = planar_grid(grid), curved = curved_grid(grid, {0, 0, -3}, sphere);
  ASSERT_EQ(curved.size(), 25U);
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_NEAR(curved[i].center.x, flat[i].center.x, 1e-15);
    EXPECT_NEAR(curved[i].center.y, flat[i].center.y, 1e-15);
    EXPECT_GT(curved[i].center.z, 0.0) << "the side that faces the plane";
    EXPECT_NEAR(glm::length(curved[i].center), r, 1e-5);
    EXPECT_LT(sphere.closest_point(curved[i].center).distance, 1e-15);
    EXPECT_GT(glm::dot(curved[i].normal, glm::normalize(curved[i].center)), 1 - 1e-5);
    EXPECT_NEAR(glm::length(curved[i].normal), 1.0, 1e-14);
    EXPECT_EQ(curved[i].id, flat[i].id);
    EXPECT_EQ(curved[i].name, flat[i].name);
  }
  grid.column_pitch = 0.011;  // the outermost columns miss the sphere
  expect_error("curved grid: row 0 column 0: the ray from [", [&] { curved_grid(grid, {0, 0, -1}, sphere); });
  grid.column_pitch = 0.004;
  grid.center.z = 0.0;
  expect_error("curved grid: row 0 column 0: the ray from [", [&] { curved_grid(grid, {0, 0, -1}, sphere); });
  expect_error("curved grid: direction: ", [&] { curved_grid(grid, dvec3(0), sphere); });
}

TEST(Ring, IsEquidistantIfTheSectionIsRound) {
  const double r = 0.01;
  const MeshIndex sphere = index_of(make_icosphere(r, 6));
  AroundAxis around;
  around.count = 7;
  around.axis = {0, 0, 2};
  around.first = {0, 1, 5};
  const std::vector<Taxel> taxels = ring(around, 0.004, sphere);
  ASSERT_EQ(taxels.size(), 7U);
  const double section = std::sqrt(r * r - 0.004 * 0.004), chord = 2.0 * section * std::sin(kPi / 7);
  EXPECT_NEAR(glm::distance(taxels[0].center, dvec3(0, section, 0.004)), 0.0, 1e-5);
  EXPECT_LT(taxels[1].center.x, 0.0) << "counter-clockwise about the axis";
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(taxels[i].center.z, 0.004, 1e-15);
    EXPECT_NEAR(glm::distance(taxels[i].center, taxels[(i + 1) % 7].center), chord, 1e-3 * chord);
    EXPECT_GT(glm::dot(taxels[i].normal, taxels[i].center), 0.999 * r);
  }
  expect_error("ring: taxel 0: the ray", [&] { ring(around, 0.011, sphere); });
  expect_error("ring: height: must be finite", [&] { ring(around, kInfinity, sphere); });
  around.origin = {0.03, 0, 0};  // next to the sphere: some rays miss, some hit it beyond the axis
  expect_error("ring: taxel ", [&] { ring(around, 0.0, sphere); });
  around.first = around.axis;
  expect_error("ring: first: must not be parallel", [&] { ring(around, 0.0, sphere); });
  around.count = 0;
  expect_error("ring: count: must be at least 1, is 0", [&] { ring(around, 0.0, sphere); });
}

TEST(Helix, ClimbsInEqualSteps) {
  const double r = 0.01;
  const MeshIndex cylinder = index_of(make_cylinder(r, 0.03, 0.0005));
  AroundAxis around;
  around.count = 25;
  const std::vector<Taxel> taxels = helix(around, -0.02, 0.02, 2.5, cylinder);
  ASSERT_EQ(taxels.size(), 25U);
  for (std::size_t i = 0; i < 25; ++i) {
    const double t = static_cast<double>(i) / 24, angle = 2 * kPi * 2.5 * t;
    const dvec3 expected(r * std::cos(angle), r * std::sin(angle), -0.02 + 0.04 * t);
    EXPECT_NEAR(glm::distance(taxels[i].center, expected), 0.0, 1e-5);
  }
  around.count = 1;
  expect_error("helix: count: must be at least 2", [&] { helix(around, 0, 0.01, 1, cylinder); });
  around.count = 2;
  expect_error("helix: turns: must not be 0", [&] { helix(around, 0, 0.01, 0, cylinder); });
}

/// On a plane: the radii of Vogel's spiral. No two taxels are closer than the known minimum distance, that of the first
/// and the fourth taxel or of a pair further out (1.5 disc radii / sqrt(N) and more).
TEST(Sunflower, GivesEachTaxelTheSameArea) {
  const MeshIndex box = index_of(make_box({0.03, 0.03, 0.001}));
  Spiral spiral;
  spiral.count = 100;
  spiral.center = {0.002, 0.001, 0.05};
  spiral.disc_radius = 0.02;
  const std::vector<Taxel> taxels = sunflower(spiral, box);
  ASSERT_EQ(taxels.size(), 100U);
  double least = kInfinity;
  for (std::size_t k = 0; k < 100; ++k) {
    const dvec3 from_axis = taxels[k].center - dvec3(0.002, 0.001, 0.001);
    EXPECT_NEAR(from_axis.z, 0.0, 1e-15);
    EXPECT_NEAR(glm::dot(from_axis, from_axis), 0.02 * 0.02 * (static_cast<double>(k) + 0.5) / 100, 1e-15);
    for (std::size_t j = 0; j < k; ++j) least = std::min(least, glm::distance(taxels[k].center, taxels[j].center));
  }
  EXPECT_GT(least, 1.4 * 0.02 / std::sqrt(100.0));
  spiral.disc_radius = 0.05;
  expect_error("spiral: taxel ", [&] { sunflower(spiral, box); });
  spiral.disc_radius = 0;
  expect_error("spiral: disc_radius: ", [&] { sunflower(spiral, box); });
}

double least_path(const std::vector<Taxel>& taxels, const MeshIndex& skin) {
  GeodesicDistance paths(std::make_shared<UnfoldedMesh>(skin.mesh_ptr()));
  double least = kInfinity;
  for (const Taxel& from : taxels) {
    paths.propagate(skin.closest_point(from.center).face, from.center, kInfinity);
    for (const Taxel& to : taxels)
      if (to.id != from.id) least = std::min(least, paths.to(skin.closest_point(to.center).face, to.center));
  }
  return least;
}

/// Six points of a sphere are at most pi/2 apart (octahedron), twelve at most 1.1071 (icosahedron: Fejes Toth 1943).
/// Half of that is guaranteed for the candidates; the candidates cover slightly less than the sphere.
TEST(GeodesicSpread, IsWithinAFactorOfTwoOfTheBestAndBetterThanRandom) {
  const double r = 0.01;
  const MeshIndex sphere = index_of(make_icosphere(r, 3));
  for (const auto& [count, best] : {std::pair{6, kPi / 2}, std::pair{12, 1.1071}}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      Spread spread;
      spread.count = count;
      spread.seed = seed;
      const SpreadTaxels result = geodesic_spread(spread, sphere);
      ASSERT_EQ(result.taxels.size(), static_cast<std::size_t>(count));
      EXPECT_GE(result.least_distance, 0.5 * 0.97 * best * r);
      EXPECT_LE(result.least_distance, 1.01 * best * r);
      EXPECT_NEAR(result.least_distance, least_path(result.taxels, sphere), 1e-9 * r) << "the one that is reported";
      std::vector<Taxel> random(static_cast<std::size_t>(count));
      const CounterRng rng(seed);
      for (std::size_t i = 0; i < random.size(); ++i) {
        const double z = 2 * rng.uniform(2 * i) - 1, a = 2 * kPi * rng.uniform(2 * i + 1), s = std::sqrt(1 - z * z);
        const SurfacePoint at = sphere.closest_point(r * dvec3(s * std::cos(a), s * std::sin(a), z));
        random[i] = taxel_on(sphere.mesh(), at, static_cast<int>(i), 0.001);
      }
      EXPECT_GT(result.least_distance, 1.2 * least_path(random, sphere)) << "seed " << seed;
    }
  }
}

/// Paths run along the skin: taxels on both sides of a thin plate are far apart, although they are near in space.
TEST(GeodesicSpread, MeasuresAlongTheSkin) {
  const MeshIndex plate = index_of(make_box({0.02, 0.02, 0.0001}));
  Spread spread;
  spread.count = 40;
  const SpreadTaxels result = geodesic_spread(spread, plate);
  double nearest = kInfinity;
  for (std::size_t i = 0; i < 40; ++i)
    for (std::size_t j = 0; j < i; ++j)
      nearest = std::min(nearest, glm::distance(result.taxels[i].center, result.taxels[j].center));
  EXPECT_LT(nearest, 0.8 * result.least_distance) << "some stand back to back";
  EXPECT_NEAR(result.least_distance, least_path(result.taxels, plate), 1e-12);
}

TEST(GeodesicSpread, StaysInItsRegionAndIsDeterministic) {
  const MeshIndex finger = index_of(make_fingertip());
  Spread spread;
  spread.count = 30;
  for (int f = 0; f < finger.mesh().face_count(); ++f)
    if (finger.mesh().face_normals()[static_cast<std::size_t>(f)].y < -0.5) spread.faces.push_back(f);
  const SpreadTaxels once = geodesic_spread(spread, finger);
  for (const Taxel& taxel : once.taxels) {
    const int face = finger.closest_point(taxel.center).face;
    EXPECT_LT(finger.mesh().face_normals()[static_cast<std::size_t>(face)].y, -0.49);
  }
  std::reverse(spread.faces.begin(), spread.faces.end());
  EXPECT_EQ(geodesic_spread(spread, finger).taxels, once.taxels) << "the region is a set";
  spread.count = 12;
  const std::vector<Taxel> fewer = [&] {
    Spread same = spread;
    same.candidates = 2000;  // also the value for 30 taxels
    return geodesic_spread(same, finger).taxels;
  }();
  EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), once.taxels.begin())) << "the first 12 of 30 are those of 12";
  spread.seed = 43;
  EXPECT_NE(geodesic_spread(spread, finger).taxels, fewer);
}

TEST(GeodesicSpread, NamesTheParameterInErrors) {
  const MeshIndex box = index_of(make_box(dvec3(0.01)));
  const auto with = [&](auto change) {
    Spread spread;
    change(spread);
    return [spread, &box] { geodesic_spread(spread, box); };
  };
  expect_error("geodesic spread: count: must be at least 1, is 0", with([](Spread& s) { s.count = 0; }));
  expect_error("geodesic spread: count: 11 taxels are more than the 10 candidate points",
               with([](Spread& s) { s.count = 11, s.candidates = 10; }));
  expect_error("geodesic spread: candidates: ", with([](Spread& s) { s.candidates = -1; }));
  expect_error("geodesic spread: radius: ", with([](Spread& s) { s.radius = -1; }));
  expect_error("geodesic spread: faces: 12 is not a face", with([](Spread& s) { s.faces = {0, 12}; }));
  expect_error("geodesic spread: faces: -1 is not a face", with([](Spread& s) { s.faces = {0, -1}; }));
  expect_error("geodesic spread: faces: 3 is listed twice", with([](Spread& s) { s.faces = {3, 1, 3}; }));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(geodesic_spread({}, box, &progress), Cancelled);
}

std::vector<Taxel> half_layout() {
  std::vector<Taxel> taxels(4);
  const double x[] = {0.003, -0.004, 0.0, 0.001};
  for (std::size_t i = 0; i < 4; ++i) {
    taxels[i].id = static_cast<int>(3 * i + 2);
    taxels[i].center = {x[i], 0.001 * static_cast<double>(i), 0.002};
    taxels[i].normal = glm::normalize(dvec3(x[i], 0.001, 0.002));
  }
  taxels[0].name = "left low";
  taxels[1].name = "the right one";
  taxels[3].name = "tip";
  taxels[3].subtaxels = {{{0.002, 0, 0}, {1, 0, 0}, 0.001}};
  return taxels;
}

TEST(Mirror, RestoresTheOriginalWhenAppliedTwice) {
  const std::vector<Taxel> taxels = half_layout();
  EXPECT_EQ(mirror_images(mirror_images(taxels, {}), {}), taxels) << "bit by bit in a plane of coordinates";
  const MirrorPlane tilted{{0.001, 0.002, -0.003}, {3, -1, 2}};
  const std::vector<Taxel> images = mirror_images(taxels, tilted), back = mirror_images(images, tilted);
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    EXPECT_NEAR(glm::distance(back[i].center, taxels[i].center), 0.0, 1e-17);
    EXPECT_NEAR(glm::distance(back[i].normal, taxels[i].normal), 0.0, 1e-15);
    const dvec3 middle = 0.5 * (images[i].center + taxels[i].center), across = images[i].center - taxels[i].center;
    EXPECT_NEAR(glm::dot(middle - tilted.point, tilted.normal), 0.0, 1e-16) << "the plane halves the way";
    EXPECT_NEAR(glm::length(glm::cross(across, tilted.normal)), 0.0, 1e-16);
  }
}

TEST(Mirror, FindsTheTwinsOfALayout) {
  Layout layout;
  layout.frame = {{0, 0, 1}, {0, -1, 0}};
  const auto add = [&](double x, double z) { layout.taxels.push_back({0, "", {x, 0, z}, {0, -1, 0}, 0.004, {}}); };
  add(0.005, 0.01), add(0.005, 0.02), add(0, 0.03), add(-0.005, 0.01), add(-0.0035, 0.02);
  EXPECT_EQ(mirror_twins(layout, std::vector<std::size_t>{0, 1, 2, 3, 4}), (std::vector{3, 4, -1, 0, 1}))
      << "one in the middle is its own image; one is 1.5 mm off, less than half of a radius";
  EXPECT_EQ(mirror_twins(layout, std::vector<std::size_t>{1, 3, 0}), (std::vector{-1, 2, 1})) << "places in the list";
  layout.taxels[4].center.x = -0.001;
  EXPECT_EQ(mirror_twins(layout, std::vector<std::size_t>{1, 4}), (std::vector{-1, -1})) << "more than 2 mm off";
  layout.frame.pad = layout.frame.distal;
  EXPECT_EQ(mirror_twins(layout, std::vector<std::size_t>{0, 3}), (std::vector{-1, -1})) << "no plane";
}

TEST(Mirror, AddsMissingTaxels) {
  const std::vector<Taxel> taxels = half_layout(), all = with_mirror_images(taxels, {});
  ASSERT_EQ(all.size(), 7U) << "the third lies on the plane";
  EXPECT_TRUE(std::equal(taxels.begin(), taxels.end(), all.begin()));
  const int ids[] = {12, 13, 14};
  const char* const names[] = {"right low", "the left one", "tip mirrored"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Taxel& original = taxels[i < 2 ? i : 3];
    EXPECT_EQ(all[4 + i].id, ids[i]);
    EXPECT_EQ(all[4 + i].name, names[i]);
    EXPECT_EQ(all[4 + i].center, dvec3(-1, 1, 1) * original.center);
    EXPECT_EQ(all[4 + i].normal, dvec3(-1, 1, 1) * original.normal);
  }
  EXPECT_EQ(all[6].subtaxels[0].center, dvec3(-0.002, 0, 0));
  EXPECT_EQ(with_mirror_images(all, {}), all) << "doing it twice changes nothing";
  expect_error("mirror: normal: ", [&] { with_mirror_images(taxels, {dvec3(0), dvec3(0)}); });
  expect_error("mirror: point: ", [&] { mirror_images(taxels, {dvec3(kInfinity), dvec3(1)}); });
  expect_error("mirror: tolerance: ", [&] { with_mirror_images(taxels, {}, -1); });
  std::vector<Taxel> full = taxels;
  full[0].id = std::numeric_limits<int>::max();
  expect_error("mirror: id: ", [&] { with_mirror_images(full, {}); });
}

}  // namespace
}  // namespace taxel
