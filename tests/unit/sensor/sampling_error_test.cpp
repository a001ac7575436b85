// Error bars of sampled readings: compared with a hundred times the samples, and where they are known.
#include "core/sensor/error_bars.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/intersect.h"
#include "core/layout/words.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

/// Returns an egg with seven taxels around its tip, of which only the tip is sampled.
Layout egg_layout(const TriMeshPtr& egg, Aggregate how) {
  Layout layout;
  layout.mesh.file = "egg";
  layout.readout.aggregate = how;
  const double top = egg->bounds().hi.z;
  for (int k = 0; k < 7; ++k) {
    const double angle = k * kPi / 3;
    const dvec3 sideways = k == 6 ? dvec3(0) : 0.003 * dvec3(std::cos(angle), std::sin(angle), 0);
    const SurfacePoint on = MeshIndex(egg).closest_point(dvec3(0, 0, top) + sideways);
    layout.taxels.push_back({k, "", on.position, egg->face_normals()[at(on.face)], 0.0035, {}});
  }
  std::vector<int> tip;
  for (int f = 0; f < egg->face_count(); ++f)
    if (egg->vertex(f, 0).z > top - 0.010) tip.push_back(f);
  layout.sampling.region = tip;
  return layout;
}

/// Returns the contact surfaces of random presses of a ball and a box onto the tip, in turns.
std::vector<ContactSurface> presses_on(const SensorModel& model, int count) {
  std::vector<ContactSurface> presses;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const HydroBodyPtr ball = test::rigid_ball(0.006), box = make_body({ShapeType::box, dvec3(0.01)}, {}, "box");
  const double top = model.mesh->bounds().hi.z;
  IntersectWorkspace workspace;
  for (int i = 0; i < count; ++i) {
    Pose X_MB;
    X_MB.q = glm::normalize(dquat(1, 0.2 * unit(random), 0.2 * unit(random), unit(random)));
    const double half = i % 2 == 0 ? 0.006 : 0.01;
    X_MB.p = dvec3(0.003 * unit(random), 0.003 * unit(random), top + half - 0.0006 - 0.0003 * unit(random));
    intersect(*model.body, i % 2 == 0 ? *ball : *box, Pose{}, X_MB, presses.emplace_back(), workspace);
  }
  return presses;
}

/// The share of errors that the bars contain, and the median of bar / error.
struct Coverage {
  int all = 0, within = 0;
  std::vector<double> ratios;
  void count(const SensorModelPtr& few_samples, const SensorModel& many_samples, int presses) {
    SamplingError bars(few_samples);
    SensorReading few, many;
    for (const ContactSurface& surface : presses_on(*few_samples, presses)) {
      const ContactSurface* list[] = {&surface};
      read_sensor(*few_samples, list, few);
      read_sensor(many_samples, list, many);
      bars.measure(list, few.hits.all(), few.values);
      for (std::size_t k = 0; k < few.values.size(); ++k) {
        const double error = std::abs(few.values[k] - many.values[k]);
        if (error == 0) continue;
        ++all;
        if (error <= bars.bars()[k]) ++within;
        ratios.push_back(bars.bars()[k] / error);
      }
    }
  }
  [[nodiscard]] double share() const { return static_cast<double>(within) / all; }
  [[nodiscard]] double median_ratio() {
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
    return ratios[ratios.size() / 2];
  }
};

/// Random presses, and the densities at which they are read [1/m^2].
struct PressPlan {
  int presses = 0;
  std::vector<double> densities;
};
void PrintTo(const PressPlan& plan, std::ostream* out) {
  *out << plan.presses << " presses at " << plan.densities.size() << " densities";
}

/// The parameter is the number of presses and densities.
class PressedEgg : public testing::TestWithParam<PressPlan> {};
INSTANTIATE_TEST_SUITE_P(Few, PressedEgg, testing::Values(PressPlan{40, {1e6}}));
INSTANTIATE_TEST_SUITE_P(Many, PressedEgg, testing::Values(PressPlan{200, {4e5, 1e6, 2.5e6, 1e7}}));

// The errors of random presses against a hundred times the samples, for five layouts, two of them with pressure laws.
TEST_P(PressedEgg, HasBarsThatContainTheErrorAgainstManySamples) {
  const TriMeshPtr egg = test::egg_mesh();
  for (int number = 0; number < 5; ++number) {
    Layout layout = egg_layout(egg, number == 1 ? Aggregate::mean : Aggregate::weighted_mean);
    if (number == 3) layout.material.law = {LawKind::stiffening, 0.78, {}};
    if (number == 4) layout.material.law = {LawKind::table, 0, {{0.15, 0.12}, {0.35, 0.4}, {0.6, 0.9}, {1, 2.2}}};
    if (number == 2) layout.receptive_field = {Metric::geodesic, 40, 10, FieldNormals::interpolated};
    for (const double density : GetParam().densities) {
      layout.sampling.density = density;
      const SensorModelPtr few = build_sensor_model(layout, egg, "", "few");
      layout.sampling.density = 100 * density;
      Coverage coverage;
      coverage.count(few, *build_sensor_model(layout, egg, "", "many"), GetParam().presses);
      EXPECT_GT(coverage.all, 5 * GetParam().presses);
      EXPECT_GE(coverage.share(), 0.95) << number << " " << density;
      EXPECT_LT(coverage.median_ratio(), 2.0) << number << " " << density;
      EXPECT_GT(coverage.median_ratio(), 1.0) << number << " " << density;
    }
  }
}

/// A taxel on a plate whose rays get pressures by hand: p and 3 p in turns, and every third ray misses.
struct HandMadeHits {
  static constexpr double kPressure = 1e4;
  SensorModelPtr model;
  std::vector<RayHit> hits;
  std::vector<double> c, p;  ///< coefficient and pressure of each sample that counts in the reading

  HandMadeHits(Aggregate how, Misses misses) {
    Layout layout;
    layout.mesh.file = "plate";
    layout.sampling.density = 1e6;
    layout.readout.aggregate = how;
    layout.readout.misses = misses;
    layout.taxels = {{0, "", dvec3(0, 0, 0.002), dvec3(0, 0, 1), 0.004, {}}};
    model = build_sensor_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, 0.002))), "", "plate");
    hits.resize(model->rays.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const bool is_hit = i % 3 != 2;
      if (is_hit) hits[i] = {0, 0, 0.001, i % 3 == 0 ? kPressure : 3 * kPressure};
      if (!is_hit && misses == Misses::omit) continue;
      c.push_back(how == Aggregate::mean ? 1.0 : model->readout_table.uses[i].weight);
      p.push_back(hits[i].pressure);
    }
  }
  [[nodiscard]] double sum(const std::function<double(double, double)>& term) const {
    double sum = 0;
    for (std::size_t i = 0; i < c.size(); ++i) sum += term(c[i], p[i]);
    return sum;
  }
};

// The contact is empty, so the exact reading is 0 and the bar of a reading r is 1.1 r + 5e-4 r + 0.04 s. The standard
// error s of a mean r = sum c p / sum c is sqrt(sum c^2 (p - r)^2) / sum c. For the plain mean of n/3 samples with p,
// n/3 with 3 p and n/3 misses this is r = 4 p / 3 and s = sqrt(14 / 9) p / sqrt(n); without the misses r = 2 p and
// s = p / sqrt(2 n / 3). The standard error of a sum r of n terms c p is sqrt(sum (c p)^2 - r^2 / n).
TEST(SamplingError, AddsAPartOfTheStandardErrorToTheBar) {
  for (const Aggregate how : {Aggregate::mean, Aggregate::weighted_mean, Aggregate::weighted_sum}) {
    for (const Misses misses : {Misses::zero, Misses::omit}) {
      const HandMadeHits made(how, misses);
      ASSERT_EQ(made.model->readout_table.uses.size(), made.hits.size()) << "one use of each ray";
      const double all = made.sum([](double c, double) { return c; });
      const double products = made.sum([](double c, double p) { return c * p; });
      const bool is_sum = how == Aggregate::weighted_sum;
      const double r = is_sum ? products : products / all, n = static_cast<double>(made.hits.size());
      const double squares =
          made.sum([&](double c, double p) { return is_sum ? c * c * p * p : c * c * (p - r) * (p - r); });
      const double s = is_sum ? std::sqrt(squares - r * r / n) : std::sqrt(squares) / all;
      SamplingError errors(made.model);
      errors.measure({}, made.hits, std::vector<double>{r});
      EXPECT_NEAR(errors.bars().at(0), 1.1005 * r + 0.04 * s, 1e-9 * r) << to_word(how);
      if (how != Aggregate::mean) continue;
      const double by_hand = HandMadeHits::kPressure * std::sqrt(misses == Misses::omit ? 1.5 / n : 14.0 / 9 / n);
      EXPECT_NEAR(s, by_hand, 0.02 * by_hand) << "a remainder of the division by three";
      EXPECT_NEAR(r, HandMadeHits::kPressure * (misses == Misses::omit ? 2.0 : 4.0 / 3), 0.02 * r);
    }
  }
}

/// Expects that the bars contain the adaptive integral on the skin (field_integral.h) of one press.
void expect_bars(const SensorModelPtr& model, SamplingError& bars, const ContactSurface& surface) {
  const ContactSurface* list[] = {&surface};
  SensorReading reading;
  read_sensor(*model, list, reading);
  bars.measure(list, reading.hits.all(), reading.values);
  const double peak = *std::max_element(reading.values.begin(), reading.values.end());
  EXPECT_GT(peak, 0);
  for (int k = 0; k < model->taxel_count(); ++k) {
    const ExactReading exact = exact_reading(*model, k, list);
    if (!exact.value) continue;
    const std::string which = fmt::format("{} {}", to_word(model->layout.readout.aggregate), k);
    EXPECT_NEAR(bars.exact()[at(k)], *exact.value, 2e-3 * peak + exact.error) << which;
    EXPECT_GE(bars.bars()[at(k)], std::abs(reading.values[at(k)] - *exact.value) - 2e-3 * peak) << which;
  }
}

TEST(SamplingError, IsMeasuredAgainstTheExactReadingOfEachAggregate) {
  const TriMeshPtr egg = test::egg_mesh();
  for (const auto& how : kAggregates) {
    if (how.value == Aggregate::force) continue;
    for (const Misses misses : {Misses::zero, Misses::omit}) {
      Layout layout = egg_layout(egg, how.value);
      layout.readout.misses = misses;
      layout.sampling.density = 1e6;
      const SensorModelPtr model = build_sensor_model(layout, egg, "", "egg");
      SamplingError bars(model);
      for (const ContactSurface& surface : presses_on(*model, 2)) expect_bars(model, bars, surface);
      SensorReading nothing;
      read_sensor(*model, {}, nothing);
      bars.measure({}, nothing.hits.all(), nothing.values);
      EXPECT_EQ(bars.bars(), std::vector<double>(7, 0.0)) << how.text;
    }
  }
}

TEST(SamplingError, RefusesReadingsThatTakeNoSamples) {
  const TriMeshPtr egg = test::egg_mesh();
  Layout layout = egg_layout(egg, Aggregate::mean);
  layout.sampling.density = 1e5;
  const auto refusal = [&] {
    try {
      SamplingError bars(build_sensor_model(layout, egg, "", "egg"));
    } catch (const Error& e) {
      return e.message();
    }
    return std::string();
  };
  EXPECT_EQ(refusal(), "");
  layout.readout.ray = RayDirection::taxel_normal;
  EXPECT_NE(refusal().find("surface_normal"), std::string::npos);
  layout.readout.ray = RayDirection::surface_normal;
  layout.readout.method = ReadingMethod::exact;
  EXPECT_NE(refusal().find("no samples are taken"), std::string::npos);
  layout.readout.aggregate = Aggregate::force;
  EXPECT_NE(refusal().find("no samples are taken"), std::string::npos);
}

}  // namespace
}  // namespace taxel
