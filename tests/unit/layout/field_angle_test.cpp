// The factor of weights by the angle between the normals of skin and disc, with face normals and interpolated ones.
#include <gtest/gtest.h>

#include <map>

#include "core/base/math.h"
#include "core/base/rng.h"
#include "core/layout/field/receptive_field.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

double cosine(double degrees) {
  return std::cos(degrees * kPi / 180.0);
}

MeshIndex ball(int level) {
  return MeshIndex(std::make_shared<TriMesh>(make_icosphere(0.01, level)));
}

/// Returns a layout with one taxel at the top of a ball of 10 mm, whose field reaches around the ball.
Layout one_taxel(const ReceptiveFieldRule& rule) {
  Layout layout;
  layout.receptive_field = rule;
  layout.taxels = {{0, "", dvec3(0, 0, 0.01), dvec3(0, 0, 1), 0.03, {}}};
  return layout;
}

/// Returns taxels all over the ball, a third of them with subtaxels.
Layout many_taxels(const ReceptiveFieldRule& rule) {
  Layout layout;
  layout.receptive_field = rule;
  const CounterRng rng(3);
  for (std::uint64_t k = 0; k < 40; ++k) {
    const double z = 2.0 * rng.uniform(3 * k) - 1.0, a = 2.0 * kPi * rng.uniform(3 * k + 1), s = std::sqrt(1 - z * z);
    const dvec3 n(s * std::cos(a), s * std::sin(a), z);
    Taxel taxel{static_cast<int>(k), "", 0.01 * n, n + dvec3(0.2, 0, 0), 0.002 + 0.01 * rng.uniform(3 * k + 2), {}};
    if (k % 3 == 0) taxel.subtaxels = {{taxel.center, n, 0.006}, {0.01 * dvec3(n.y, n.z, n.x), n, 0.008}};
    layout.taxels.push_back(taxel);
  }
  return layout;
}

TEST(FieldAngle, FollowsTheSmoothstepOfTheCosine) {
  ReceptiveFieldRule rule;
  rule.max_angle_deg = 45;
  rule.angle_falloff_deg = 15;
  const FieldAngle angle(rule);
  for (double degrees = 0; degrees <= 30; degrees += 0.5) EXPECT_EQ(angle.factor(cosine(degrees)), 1.0) << degrees;
  for (double degrees = 45; degrees <= 180; degrees += 0.5) EXPECT_EQ(angle.factor(cosine(degrees)), 0.0) << degrees;
  for (double degrees = 30.25; degrees < 45; degrees += 0.25) {
    const double t = (cosine(degrees) - cosine(45)) / (cosine(30) - cosine(45));
    EXPECT_NEAR(angle.factor(cosine(degrees)), t * t * (3 - 2 * t), 1e-15) << degrees;
    EXPECT_LT(angle.factor(cosine(degrees)), angle.factor(cosine(degrees - 0.25))) << degrees;
  }
  EXPECT_NEAR(angle.factor(0.5 * (cosine(30) + cosine(45))), 0.5, 1e-15) << "the middle of the cosines";
}

TEST(FieldAngle, CutsStrictlyWithoutARollOff) {
  for (const double limit : {20.0, 45.0, 90.0, 180.0}) {
    ReceptiveFieldRule rule;
    rule.max_angle_deg = limit;
    const FieldAngle angle(rule);
    EXPECT_EQ(angle.factor(cosine(limit)), 0.0);
    EXPECT_EQ(angle.factor(std::nextafter(cosine(limit), 2.0)), 1.0);
    EXPECT_EQ(angle.factor(1.0), 1.0);
    EXPECT_EQ(angle.factor(-1.0), 0.0);
  }
}

TEST(FieldAngle, RollsOffOverTheWholeConeAtMost) {
  ReceptiveFieldRule rule;
  rule.max_angle_deg = rule.angle_falloff_deg = 60;
  const FieldAngle angle(rule);
  EXPECT_EQ(angle.factor(1.0), 1.0);
  EXPECT_NEAR(angle.factor(0.75), 0.5, 1e-15);
  EXPECT_LT(angle.factor(std::nextafter(cosine(60), 1.0)), 1e-30);
}

TEST(FieldAngle, MultipliesTheWeightsOfSamples) {
  const MeshIndex skin = ball(3);
  const std::vector<SurfaceSample> samples = sample_surface(skin.mesh(), 3000, 7);
  for (const FieldNormals normals : {FieldNormals::face, FieldNormals::interpolated}) {
    const ReceptiveFieldRule rule{Metric::euclidean, 45, 20, normals};
    const Layout layout = one_taxel(rule);
    const ReceptiveFields fields = make_receptive_fields(layout, samples, skin);
    std::map<int, double> weights;
    for (const ReceptiveFields::Entry& e : fields.entries) weights[e.sample] = e.weight;
    int between = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const SurfaceSample& s = samples[i];
      const double z = field_normal(normals, skin.mesh(), s.face, s.position).z;
      const double t = std::clamp((z - cosine(45)) / (cosine(25) - cosine(45)), 0.0, 1.0), c = t * t * (3 - 2 * t);
      const double w = std::pow(0.03 - glm::distance(s.position, layout.taxels[0].center), 2) * c;
      EXPECT_EQ(weights.contains(static_cast<int>(i)), c > 0);
      EXPECT_NEAR(c > 0 ? weights[static_cast<int>(i)] : 0.0, w, 1e-15);
      between += c > 0 && c < 1;
    }
    EXPECT_GT(between, 200);
  }
}

TEST(FieldAngle, KeepsTheBitsOfTheHardCut) {
  const MeshIndex skin = ball(3);
  const std::vector<SurfaceSample> samples = sample_surface(skin.mesh(), 2000, 5);
  const Layout layout = many_taxels({});
  const ReceptiveFields fields = make_receptive_fields(layout, samples, skin);
  const double least = min_cosine(layout.receptive_field);
  std::size_t e = 0;
  for (const Taxel& taxel : layout.taxels) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity(), weight = 0;
      for (const FieldDisc& disc : discs_of(taxel)) {
        const double d = glm::distance(disc.center, samples[i].position);
        if (!(d <= disc.radius) || !(glm::dot(samples[i].normal, disc.normal) > least) || !(d < nearest)) continue;
        nearest = d;
        weight = (disc.radius - d) * (disc.radius - d);
      }
      if (!std::isfinite(nearest)) continue;
      ASSERT_LT(e, fields.entries.size());
      EXPECT_EQ(fields.entries[e].sample, static_cast<int>(i));
      EXPECT_EQ(fields.entries[e].weight, weight);
      ++e;
    }
  }
  EXPECT_EQ(e, fields.entries.size());
  EXPECT_GT(e, 2000U);
}

TEST(FieldAngle, GivesSamplesTheWeightsOfPoints) {
  const MeshIndex skin = ball(3);
  const std::vector<SurfaceSample> samples = sample_surface(skin.mesh(), 1500, 5);
  for (const ReceptiveFieldRule& rule : {ReceptiveFieldRule{}, ReceptiveFieldRule{Metric::euclidean, 45, 15},
                                         ReceptiveFieldRule{Metric::euclidean, 45, 15, FieldNormals::interpolated},
                                         ReceptiveFieldRule{Metric::geodesic, 45, 15, FieldNormals::interpolated}}) {
    const Layout layout = many_taxels(rule);
    const ReceptiveFields fields = make_receptive_fields(layout, samples, skin);
    const FieldWeights points(layout, skin);
    std::map<std::pair<int, int>, double> expected;
    for (int k = 0; k < fields.taxel_count(); ++k)
      for (int e = fields.first[at(k)]; e < fields.first[at(k) + 1]; ++e)
        expected[{fields.entries[at(e)].sample, k}] = fields.entries[at(e)].weight;
    std::size_t found = 0;
    FieldWeights::AtPoint here;
    std::vector<int> discs;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      points.near(samples[i].position, 1e-6, discs);
      points.at(samples[i].face, samples[i].position, discs, here);
      double cover = 0;
      for (const FieldWeights::Weight& w : here.weights) {
        ASSERT_TRUE(expected.contains({static_cast<int>(i), w.taxel}));
        EXPECT_NEAR((expected[{static_cast<int>(i), w.taxel}]), w.value, 1e-12 * 1e-4);
        if (w.value > 0) cover = std::max(cover, w.facing);
        ++found;
      }
      EXPECT_EQ(here.cover, cover);
      if (rule.angle_falloff_deg == 0 && !here.weights.empty()) {
        EXPECT_EQ(here.cover, 1.0);
      }
    }
    EXPECT_EQ(found, expected.size());
  }
}

/// Returns the largest difference of the weights on both sides of any edge, relative to the largest weight of all.
double largest_step(const ReceptiveFieldRule& rule) {
  const MeshIndex skin = ball(2);
  const TriMesh& mesh = skin.mesh();
  const FieldWeights points(one_taxel(rule), skin);
  const std::vector<int> disc{0};
  FieldWeights::AtPoint here;
  std::map<std::pair<int, int>, double> first;  // weight at the middle of an edge, from its first face
  double step = 0;
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int a = mesh.faces()[at(f)][c], b = mesh.faces()[at(f)][(c + 1) % 3];
      points.at(f, 0.5 * (mesh.vertex(f, c) + mesh.vertex(f, (c + 1) % 3)), disc, here);
      const double weight = here.weights.empty() ? 0.0 : here.weights.front().value / (0.03 * 0.03);
      const auto [entry, fresh] = first.emplace(std::minmax(a, b), weight);
      if (!fresh) step = std::max(step, std::abs(entry->second - weight));
    }
  }
  return step;
}

TEST(FieldAngle, IsContinuousAcrossFacesWithInterpolatedNormalsAndARollOff) {
  EXPECT_GT(largest_step({}), 0.3) << "a face is in the field or not";
  EXPECT_GT(largest_step({Metric::euclidean, 45, 15}), 0.05) << "neighbouring faces have different normals";
  EXPECT_LT(largest_step({Metric::euclidean, 45, 15, FieldNormals::interpolated}), 1e-12);
}

TEST(FieldAngle, InterpolatesTheNormalsOfASphere) {
  const MeshIndex skin = ball(4);
  for (const SurfaceSample& s : sample_surface(skin.mesh(), 500, 3)) {
    const dvec3 n = skin_normal(skin.mesh(), s.face, s.position);
    EXPECT_NEAR(glm::length(n), 1, 1e-14);
    EXPECT_GT(glm::dot(n, glm::normalize(s.position)), std::cos(0.01));
  }
}

}  // namespace
}  // namespace taxel
