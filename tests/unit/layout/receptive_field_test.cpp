// Receptive fields compared with their definition, sample by sample.
#include "core/layout/field/receptive_field.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

#include "core/base/rng.h"
#include "core/layout/field/point_grid.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "unit/mesh/geodesic_oracle.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

MeshIndex indexed(const TriMesh& mesh) {
  return MeshIndex(std::make_shared<TriMesh>(mesh));
}
MeshIndex sphere() {
  return indexed(make_icosphere(0.01, 3));
}
std::vector<SurfaceSample> sphere_samples() {
  return sample_surface(make_icosphere(0.01, 3), 3000, 7);
}

/// Returns taxels of many sizes on a sphere of 10 mm, some with subtaxels, some empty.
Layout sphere_layout() {
  Layout layout;
  const CounterRng rng(11);
  for (std::uint64_t k = 0; k < 60; ++k) {
    const double z = 2.0 * rng.uniform(10 * k) - 1.0, a = 2.0 * kPi * rng.uniform(10 * k + 1),
                 r = std::sqrt(1.0 - z * z);
    const dvec3 n(r * std::cos(a), r * std::sin(a), z);
    const dvec3 tilt(rng.uniform(10 * k + 2), rng.uniform(10 * k + 3), rng.uniform(10 * k + 4));
    Taxel taxel{static_cast<int>(k), "", 0.0101 * n, 3.0 * n + tilt, 0.0005 + 0.012 * rng.uniform(10 * k + 5), {}};
    if (k % 3 == 0)
      taxel.subtaxels = {{taxel.center, n, 0.002}, {taxel.center + 0.001 * tilt, n, 0.003}, {-taxel.center, n, 0.003}};
    layout.taxels.push_back(taxel);
  }
  return layout;
}

/// Returns the field by its definition: every disc against every sample. The nearest disc that contains the sample
/// determines the weight.
std::map<int, std::pair<double, double>> field_of(const Layout& layout, const Taxel& taxel,
                                                  const std::vector<SurfaceSample>& samples) {
  std::vector<Subtaxel> discs = taxel.subtaxels;
  if (discs.empty()) discs = {{taxel.center, taxel.normal, taxel.radius}};
  std::map<int, std::pair<double, double>> field;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (const Subtaxel& disc : discs) {
      const double d = glm::length(samples[i].position - disc.center);
      const double cosine = glm::dot(samples[i].normal, disc.normal) / glm::length(disc.normal);
      if (d > disc.radius ||
          std::acos(std::clamp(cosine, -1.0, 1.0)) >= layout.receptive_field.max_angle_deg * kPi / 180.0)
        continue;
      const auto [found, fresh] = field.emplace(i, std::pair(d, std::pow(disc.radius - d, 2)));
      if (!fresh && d < found->second.first) found->second = {d, std::pow(disc.radius - d, 2)};
    }
  }
  return field;
}

TEST(ReceptiveField, EqualsTheDefinition) {
  const std::vector<SurfaceSample> samples = sphere_samples();
  for (const double angle : {45.0, 20.0, 120.0}) {
    Layout layout = sphere_layout();
    layout.receptive_field.max_angle_deg = angle;
    const ReceptiveFields fields = make_receptive_fields(layout, samples, sphere());
    ASSERT_EQ(fields.taxel_count(), 60);
    ASSERT_EQ(fields.first.back(), static_cast<int>(fields.entries.size()));
    int shared = 0, empty = 0;
    for (std::size_t k = 0; k < layout.taxels.size(); ++k) {
      const auto expected = field_of(layout, layout.taxels[k], samples);
      ASSERT_EQ(fields.first[k + 1] - fields.first[k], static_cast<int>(expected.size())) << k;
      int e = fields.first[k];
      for (const auto& [sample, values] : expected) {
        const ReceptiveFields::Entry& entry = fields.entries[static_cast<std::size_t>(e++)];
        EXPECT_EQ(entry.sample, sample);
        EXPECT_NEAR(entry.distance, values.first, 1e-17);
        EXPECT_NEAR(entry.weight, values.second, 1e-12 * 1e-4);
      }
      shared += static_cast<int>(expected.size());
      empty += expected.empty();
    }
    EXPECT_GT(shared, 3000) << "overlap is exercised";
    EXPECT_LT(empty, 40);
  }
}

TEST(ReceptiveField, ExcludesAnglesOfExactlyTheLimit) {
  Layout layout;
  layout.taxels = {{0, "", dvec3(0), dvec3(0, 0, 1), 1.0, {}}};
  layout.receptive_field.max_angle_deg = 90.0;
  const std::vector<SurfaceSample> samples = {{dvec3(0), dvec3(0, 1, 0), 0, 1.0},
                                              {dvec3(0.5, 0, 0), dvec3(0, 1, 1e-3), 0, 1.0},
                                              {dvec3(1, 0, 0), dvec3(0, 0, 1), 0, 1.0},
                                              {dvec3(std::nextafter(1.0, 2.0), 0, 0), dvec3(0, 0, 1), 0, 1.0}};
  const ReceptiveFields fields = make_receptive_fields(layout, samples, sphere());
  ASSERT_EQ(fields.entries.size(), 2U);
  EXPECT_EQ(fields.entries[0].sample, 1);
  EXPECT_DOUBLE_EQ(fields.entries[0].weight, 0.25);
  EXPECT_EQ(fields.entries[1].sample, 2);
  EXPECT_EQ(fields.entries[1].weight, 0.0);
}

TEST(ReceptiveField, MultipliesVoronoiWeightsByAreaOverMeanArea) {
  const std::vector<SurfaceSample> samples = sphere_samples();
  Layout layout = sphere_layout();
  const ReceptiveFields equal = make_receptive_fields(layout, samples, sphere());
  layout.sampling.weights = SampleWeights::voronoi;
  const ReceptiveFields voronoi = make_receptive_fields(layout, samples, sphere());
  double total = 0.0;
  for (const SurfaceSample& s : samples) total += s.area;
  ASSERT_EQ(equal.entries.size(), voronoi.entries.size());
  for (std::size_t e = 0; e < equal.entries.size(); ++e) {
    const double area = samples[static_cast<std::size_t>(equal.entries[e].sample)].area;
    EXPECT_NEAR(voronoi.entries[e].weight, equal.entries[e].weight * area / (total / 3000.0), 1e-18);
  }
}

TEST(ReceptiveField, EqualsExhaustiveUnfoldingIfGeodesic) {
  std::vector<dvec3> vertices = test::bumpy_sphere(1).vertices();
  for (dvec3& v : vertices) v *= 0.01;
  const TriMesh mesh(vertices, test::bumpy_sphere(1).faces());
  const MeshIndex skin = indexed(mesh);
  const std::vector<SurfaceSample> samples = sample_surface(mesh, 120, 3);
  const auto weights_of = [&](int face, const dvec3& p) {
    const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
    const dvec3 n = glm::cross(b - a, c - a);
    const double v = glm::dot(glm::cross(p - a, c - a), n), w = glm::dot(glm::cross(b - a, p - a), n);
    return dvec3(glm::dot(n, n) - v - w, v, w) / glm::dot(n, n);
  };
  std::vector<test::OnSurface> targets;
  for (const SurfaceSample& s : samples) targets.push_back({s.face, weights_of(s.face, s.position)});
  test::GeodesicOracle oracle(mesh, 0.05L);

  Layout layout = sphere_layout();
  layout.receptive_field = {Metric::geodesic, 70.0};
  layout.taxels.resize(6);
  const ReceptiveFields fields = make_receptive_fields(layout, samples, skin);
  int entries = 0, around = 0;
  for (std::size_t k = 0; k < layout.taxels.size(); ++k) {
    const Taxel& taxel = layout.taxels[k];
    std::vector<Subtaxel> discs = taxel.subtaxels;
    if (discs.empty()) discs = {{taxel.center, taxel.normal, taxel.radius}};
    std::map<int, std::pair<double, double>> expected;
    for (const Subtaxel& disc : discs) {
      const SurfacePoint from = skin.closest_point(disc.center);
      const auto d = oracle.distances({from.face, from.barycentric}, targets);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto distance = static_cast<double>(d[i]);
        const double cosine = glm::dot(samples[i].normal, disc.normal) / glm::length(disc.normal);
        around += glm::distance(samples[i].position, from.position) <= disc.radius && distance > disc.radius;
        if (distance > disc.radius || std::acos(std::clamp(cosine, -1.0, 1.0)) >= 70.0 * kPi / 180.0) continue;
        const auto [found, fresh] = expected.emplace(i, std::pair(distance, std::pow(disc.radius - distance, 2)));
        if (!fresh && distance < found->second.first) found->second = {distance, std::pow(disc.radius - distance, 2)};
      }
    }
    ASSERT_EQ(fields.first[k + 1] - fields.first[k], static_cast<int>(expected.size())) << k;
    int e = fields.first[k];
    for (const auto& [sample, values] : expected) {
      const ReceptiveFields::Entry& entry = fields.entries[static_cast<std::size_t>(e++)];
      EXPECT_EQ(entry.sample, sample);
      EXPECT_NEAR(entry.distance, values.first, 1e-9 * values.first + 1e-17);
      EXPECT_NEAR(entry.weight, values.second, 1e-10 * 1e-4);
      ++entries;
    }
  }
  EXPECT_GT(entries, 40);
  EXPECT_GT(around, 5) << "where the straight way is shorter than the radius and the path is not";
}

/// The two walls of a plate that is 0.6 mm thin, far from its rim.
TEST(ReceptiveField, NeverReachesTheOppositeWallIfGeodesic) {
  const TriMesh plate = make_box(dvec3(0.010, 0.010, 0.0003));
  const std::vector<SurfaceSample> samples = sample_surface(plate, 4000, 1);
  Layout layout;
  layout.taxels = {{0, "", dvec3(0.001, 0, 0.0004), dvec3(0.1, 0, 1), 0.005, {}}};
  const auto below = [&](Metric metric, double max_angle_deg) {
    layout.receptive_field = {metric, max_angle_deg};
    const ReceptiveFields fields = make_receptive_fields(layout, samples, indexed(plate));
    EXPECT_GT(fields.entries.size(), 300U);
    return std::count_if(fields.entries.begin(), fields.entries.end(), [&](const ReceptiveFields::Entry& e) {
      return samples[static_cast<std::size_t>(e.sample)].position.z < 0.0;
    });
  };
  EXPECT_GT(below(Metric::euclidean, 180.0), 300);
  EXPECT_EQ(below(Metric::euclidean, 45.0), 0) << "the angle alone keeps the opposite wall out of a flat plate";
  EXPECT_EQ(below(Metric::geodesic, 180.0), 0);
  EXPECT_EQ(below(Metric::geodesic, 45.0), 0);
}

TEST(ReceptiveField, HasTheSameBytesForAnyTaxelOrderAndThreadCount) {
  const std::vector<SurfaceSample> samples = sphere_samples();
  for (const Metric metric : {Metric::euclidean, Metric::geodesic}) {
    Layout layout = sphere_layout();
    layout.receptive_field.metric = metric;
    const auto rows = [&] {
      const ReceptiveFields fields = make_receptive_fields(layout, samples, sphere());
      std::map<int, std::vector<std::tuple<int, double, double>>> by_id;
      for (std::size_t k = 0; k < layout.taxels.size(); ++k)
        for (int e = fields.first[k]; e < fields.first[k + 1]; ++e) {
          const ReceptiveFields::Entry& entry = fields.entries[static_cast<std::size_t>(e)];
          by_id[layout.taxels[k].id].emplace_back(entry.sample, entry.distance, entry.weight);
        }
      return by_id;
    };
    const auto expected = rows();
    EXPECT_GT(expected.size(), 20U);
    for (const std::size_t threads : {1U, 2U, 8U}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      EXPECT_EQ(rows(), expected);
      std::rotate(layout.taxels.begin(), layout.taxels.begin() + 17, layout.taxels.end());
    }
    std::reverse(layout.taxels.begin(), layout.taxels.end());
    EXPECT_EQ(rows(), expected);
  }
}

TEST(ReceptiveField, IsEmptyWithoutTaxelsOrSamples) {
  EXPECT_EQ(make_receptive_fields(Layout{}, sphere_samples(), sphere()).taxel_count(), 0);
  EXPECT_TRUE(make_receptive_fields(sphere_layout(), {}, sphere()).entries.empty());
}

TEST(PointGrid, VisitsEveryPointOfABallOnce) {
  const CounterRng rng(5);
  std::vector<dvec3> points;
  for (std::uint64_t i = 0; i < 2000; ++i)
    points.emplace_back(rng.uniform(3 * i), rng.uniform(3 * i + 1), 1e-3 * rng.uniform(3 * i + 2));
  for (const double cell : {0.004, 0.1, 7.0}) {
    const PointGrid grid(points, cell);
    for (std::uint64_t q = 0; q < 40; ++q) {
      const dvec3 center = points[q] + dvec3(0.01, -0.02, 0);
      const double radius = 0.3 * rng.uniform(9000 + q);
      std::map<int, int> visits;
      grid.visit_near(center, radius, [&](int i) { ++visits[i]; });
      for (const auto& [i, times] : visits) EXPECT_EQ(times, 1);
      for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_TRUE(glm::distance(points[i], center) > radius || visits.contains(static_cast<int>(i)));
    }
  }
}

}  // namespace
}  // namespace taxel
