// Remedies for jumps that the method caused: each remedy has the predicted effect when it is applied.
#include "core/sensor/explain/counterfactual.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "fixtures/labelled_touches.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

/// A ball that moves along a finger with few samples, in twelve steps of 0.1 mm.
struct NoisyCase {
  Layout layout;
  TriMeshPtr mesh = test::finger_mesh();
  test::LabelledCase touch;

  explicit NoisyCase(unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    layout =
        test::layout_of(FieldKind::pad, std::exp(between(std::log(3e5), std::log(3e6))), SampleWeights::equal, seed);
    layout.readout.aggregate = seed % 2 == 0 ? Aggregate::weighted_mean : Aggregate::mean;
    test::add_row(layout, mesh);
    const double ball = between(0.001, 0.0025);
    touch.other = test::rigid_ball(ball);
    touch.path = test::along_finger(ball, between(0.0003, 0.0006), between(-0.011, 0.009), 0.0001, 12);
    touch.limits.jump = between(0.02, 0.1);
    touch.model = test::preview_model(layout, mesh);
  }
  /// Returns the change of the explained reading for a sensor built from `changed`.
  [[nodiscard]] double change_with(const Layout& changed, const Explanation& e) const {
    test::LabelledCase other = touch;
    other.model = test::preview_model(changed, mesh);
    const auto reading = [&](double time) {
      const auto step = static_cast<std::size_t>(std::lround(1000 * time));
      return other.sense(touch.path[step]).readings[static_cast<std::size_t>(e.taxel)];
    };
    return reading(e.time) - reading(e.change->time_before);
  }
};

void carry_out(const NoisyCase& noisy, const Explanation& e) {
  const Verdict& v = e.change->verdict;
  if (v.needed) {
    Layout layout = noisy.layout;
    layout.sampling.density *= v.needed->factor;
    const double change = noisy.change_with(layout, e);
    EXPECT_EQ(change, v.needed->change) << v.text;
    if (v.needed->cures) {
      EXPECT_LT(std::abs(change), v.limit) << v.text;
    }
    EXPECT_EQ(v.text.find("Even with ") == std::string::npos, v.needed->cures) << v.text;
  }
  ASSERT_TRUE(v.voronoi_change);
  Layout layout = noisy.layout;
  layout.sampling.weights = SampleWeights::voronoi;
  const double change = noisy.change_with(layout, e);
  EXPECT_NEAR(change, *v.voronoi_change, 1e-9 * std::abs(v.change)) << v.text;
  const bool recommended = v.text.find("With Voronoi weights") != std::string::npos;
  EXPECT_EQ(recommended, std::abs(change) < 0.9 * std::abs(v.change)) << v.text;
}

/// The parameter is the number of cases.
class RandomAdvice : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Few, RandomAdvice, testing::Values(12));
INSTANTIATE_TEST_SUITE_P(Many, RandomAdvice, testing::Values(200));

TEST_P(RandomAdvice, HasThePredictedEffect) {
  const int cases = GetParam();
  int noise = 0, cured = 0, helped = 0;
  for (unsigned seed = 1; noise < cases; ++seed) {
    ASSERT_LT(seed, 4U * static_cast<unsigned>(cases)) << "too few jumps by sampling noise";
    const NoisyCase noisy(seed);
    const Explanation e = noisy.touch.explain_largest_jump();
    if (e.change->verdict.cause != Cause::sampling_noise) continue;
    ++noise;
    SCOPED_TRACE(seed);
    carry_out(noisy, e);
    const Verdict& v = e.change->verdict;
    cured += v.needed && v.needed->cures ? 1 : 0;
    helped += std::abs(*v.voronoi_change) < std::abs(v.change) ? 1 : 0;
    if (std::getenv("TAXEL_SHOW_VERDICTS") != nullptr) fmt::print("{}: {}\n", seed, v.text);
  }
  EXPECT_GT(cured, cases / 2) << "most noise is cured by some number of samples";
  EXPECT_LT(helped, cases) << "the cases include some in which Voronoi weights do not help";
  RecordProperty("cured", cured);
  RecordProperty("helped", helped);
}

TEST(Advice, IsTriedOnNoiseBelowTheLimitToo) {
  int tried = 0;
  for (unsigned seed = 1; tried < 2; ++seed) {
    ASSERT_LT(seed, 20U) << "too few steps that are partly noise";
    NoisyCase noisy(seed);
    noisy.touch.limits.jump = 0.4;
    const Explanation e = noisy.touch.explain_largest_jump();
    const Verdict& v = e.change->verdict;
    if (!v.needed || v.cause != Cause::none) continue;
    ++tried;
    Layout layout = noisy.layout;
    layout.sampling.density *= v.needed->factor;
    EXPECT_EQ(noisy.change_with(layout, e), v.needed->change) << v.text;
    EXPECT_EQ(v.needed->cures, std::abs(v.needed->change) <= std::abs(v.change) - 0.5 * std::abs(v.noise)) << v.text;
    EXPECT_NE(v.text.find("times as many samples it would be"), std::string::npos) << v.text;
  }
}

TEST(Advice, FindsTheAngleThatCures) {
  const test::Touch touch = test::taps_around_cone(45, 0.002);
  for (const double jump : {0.1, 0.3, 0.6}) {
    test::LabelledCase c = test::sensed(touch);
    c.limits.jump = jump;
    const Verdict v = c.explain_largest_jump().change->verdict;
    ASSERT_EQ(v.cause, Cause::cone);
    ASSERT_TRUE(v.wider);
    EXPECT_EQ(v.wider->cures, jump > 0.1) << "half of the drop of the weight, 13 %, remains without any limit";
    double last = 0;
    for (const double angle : kTriedAngles) {
      test::Touch wider = touch;
      wider.layout.receptive_field.max_angle_deg = angle;
      const test::LabelledCase other = test::sensed(wider);
      last = other.sense(c.path[1]).readings[0] - other.sense(c.path[0]).readings[0];
      if (angle == v.wider->angle_deg) break;
      EXPECT_GT(std::abs(last), kCureMargin * v.limit) << angle << " would have been enough for " << jump;
    }
    EXPECT_EQ(last, v.wider->change);
  }
}

TEST(Advice, GivesBothChangesInPercentOfTheSameReading) {
  Verdict v;
  v.cause = Cause::sampling_noise;
  v.change = 0.106, v.limit = 0.1;
  v.needed = SamplesNeeded{1704, 4, -0.031, true};
  v.voronoi_change = 0.125;
  VerdictInput in;
  in.limits = {.jump = 0.1, .equal_force = 0.02, .largest = 1};
  const std::string text = verdict_text(v, in);
  EXPECT_NE(text.find("With 1704 samples, 4 times as many, it would be 3.1 % instead of 10.6 %, below the limit."),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("Voronoi weights do not help: with them on the same samples, it would be 12.5 % instead of 10.6 %."),
      std::string::npos)
      << text;
  v.needed = SamplesNeeded{27264, 64, 0.099, false};
  v.voronoi_change = -0.02;
  const std::string other = verdict_text(v, in);
  EXPECT_NE(
      other.find("Even with 27264 samples, 64 times as many, it would be 9.9 % instead of 10.6 %, not safely below"),
      std::string::npos)
      << other;
  EXPECT_NE(other.find("With Voronoi weights of the same samples, it would be 2 % instead of 10.6 %."),
            std::string::npos)
      << other;
}

}  // namespace
}  // namespace taxel
