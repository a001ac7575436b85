// The diagnosis for given numbers, on both sides of each limit.
#include "core/sensor/explain/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/sensor/error_bars.h"

namespace taxel {
namespace {

/// Returns a reading that rises from 100 by `noise` + `field` + `contact` Pa. A change above 5 Pa is a jump.
VerdictInput risen(double noise, double field, double contact) {
  VerdictInput in;
  in.limits = {.jump = 0.05, .equal_force = 0.02, .largest = 100};
  in.sampled = {100, 100 + noise + field + contact};
  in.exact = Readings{100, 100 + field + contact};
  // The readings under uniform stiffness have the mean of the exact readings, so their scale is 1.
  const double sum = 200 + field + contact;
  in.even = Readings{0.5 * (sum - contact), 0.5 * (sum + contact)};
  in.force = {2, 3};
  return in;
}

TEST(Verdict, DividesTheChangeIntoItsParts) {
  const Verdict v = decide(risen(3, 20, -1));
  EXPECT_NEAR(v.noise, 3, 1e-12);
  EXPECT_NEAR(v.field, 20, 1e-12);
  EXPECT_NEAR(v.contact, -1, 1e-12);
  EXPECT_NEAR(v.limit, 5, 1e-12);
  EXPECT_EQ(v.change, 22);
}

TEST(Verdict, ScalesUniformReadingsToTheMeanOfTheExactOnes) {
  VerdictInput in = risen(0, 20, 10);
  const Verdict before = decide(in);
  in.even->before *= 7, in.even->now *= 7;
  EXPECT_NEAR(decide(in).field, before.field, 1e-12);
  EXPECT_NEAR(decide(in).contact, 10, 1e-12);
}

TEST(Verdict, IsAJumpOnlyAboveTheLimit) {
  EXPECT_EQ(decide(risen(4.999, 0, 0)).cause, Cause::none);
  EXPECT_EQ(decide(risen(5, 0, 0)).cause, Cause::none) << "a jump is more than the limit";
  EXPECT_EQ(decide(risen(5.001, 0, 0)).cause, Cause::sampling_noise);
  EXPECT_EQ(decide(risen(-5.001, 0, 0)).cause, Cause::sampling_noise) << "a fall is as much of a jump";
  EXPECT_EQ(decide(risen(-4.999, 0, 0)).cause, Cause::none);
}

std::string text_of(const VerdictInput& in) {
  return verdict_text(decide(in), in);
}

TEST(Verdict, SaysThatAStepBelowTheLimitIsPartlyNoise) {
  const VerdictInput in = risen(2, 0, 2.5);
  Verdict v = decide(in);
  const std::string found =
      "Below the limit of a jump, 5 %, but partly noise: the reading rose by 4.5 % of the taxel's largest, the exact "
      "integral of the same contact rose by 2.5 %. 44 % of the step is noise of the samples";
  EXPECT_EQ(verdict_text(v, in), found + ".") << "no model with more samples could be built";
  v.needed = SamplesNeeded{800, 16, 3, true};
  EXPECT_EQ(verdict_text(v, in), found + ": with 16 times as many samples it would be 3 %.");
  v.needed->cures = false;
  EXPECT_EQ(verdict_text(v, in), found + ": even with 16 times as many samples it would be 3 %.");
  EXPECT_TRUE(text_of(risen(0.5, 0, 4)).starts_with("No jump: ")) << "a ninth of it is noise";
  EXPECT_EQ(text_of(risen(0, 0, 0)), "No jump: the reading did not change in this step.");
  EXPECT_TRUE(text_of(risen(0.5, 0, 0.4)).starts_with("No jump: ")) << "a small step";
  EXPECT_TRUE(text_of(risen(-1, 0, 4)).starts_with("No jump: ")) << "the noise makes it smaller";
}

TEST(Verdict, GivesFractionsOfTheSensorIfTheTaxelHardlyReads) {
  VerdictInput in = risen(10, 0, 0);
  in.limits.sensor_largest = 2000;
  EXPECT_NE(text_of(in).find("rose by 10 % of the taxel's largest"), std::string::npos) << "a twentieth of it";
  in.limits.sensor_largest = 10000;
  EXPECT_NE(text_of(in).find("rose by 0.1 % of the sensor's largest"), std::string::npos) << text_of(in);
  EXPECT_NE(text_of(in).find("The taxel hardly reads: its largest reading is 1 % of the sensor's."), std::string::npos);
}

TEST(Verdict, NamesTheLargestStepOfTheRunAndItsRemedy) {
  const VerdictInput in = risen(10, 0, 0);
  Verdict v = decide(in);
  v.worst = WorstChange{0.25, -15, SamplesNeeded{800, 16, 4, true}, {}};
  EXPECT_TRUE(
      verdict_text(v, in).ends_with(" The largest step of the taxel in the run is another one, 15 % at 0.25 s: "
                                    "with 16 times as many samples it would be 4 %."));
  v.worst->needed->cures = false;
  EXPECT_TRUE(
      verdict_text(v, in).ends_with("even with 16 times as many samples it would be 4 %, not safely below the "
                                    "limit."));
}

TEST(Verdict, NamesTheLargestPartInTheDirectionOfTheChange) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(decide(risen(sign * 10.1, sign * 10, 0)).cause, Cause::sampling_noise) << sign;
    EXPECT_EQ(decide(risen(sign * 9.9, sign * 10, 0)).cause, Cause::star_field) << sign;
    EXPECT_EQ(decide(risen(0, sign * 10.1, sign * 10)).cause, Cause::star_field) << sign;
    EXPECT_EQ(decide(risen(0, sign * 9.9, sign * 10)).cause, Cause::contact) << sign;
    EXPECT_EQ(decide(risen(sign * 10.1, 0, sign * 10)).cause, Cause::sampling_noise) << sign;
    EXPECT_EQ(decide(risen(sign * 9.9, 0, sign * 10)).cause, Cause::contact) << sign;
    EXPECT_EQ(decide(risen(-sign * 20, 0, sign * 30)).cause, Cause::contact) << "noise in the other direction";
  }
}

TEST(Verdict, IsInvertedTetsFromHalfOfTheFieldsPart) {
  for (const double sign : {1.0, -1.0}) {
    VerdictInput in = risen(0, sign * 20, 0);
    const auto with = [&](double part) {
      in.exact_inverted = Readings{40, 40 + sign * part};
      in.even_inverted = Readings{40, 40};
      return decide(in).cause;
    };
    EXPECT_EQ(with(9.99), Cause::star_field) << sign;
    EXPECT_EQ(with(10.01), Cause::inverted_tets) << sign;
    EXPECT_EQ(with(-15), Cause::star_field) << "against the direction of the change";
    in.even_inverted.reset();
    EXPECT_EQ(decide(in).cause, Cause::star_field) << "unknown";
  }
}

TEST(Verdict, ScalesTheInvertedPartOfUniformReadings) {
  VerdictInput in = risen(0, 20, 0);
  in.even->before *= 0.5, in.even->now *= 0.5;  // the scale of these readings is 2
  in.exact_inverted = Readings{40, 60};
  in.even_inverted = Readings{20, 24.9};
  EXPECT_EQ(decide(in).cause, Cause::inverted_tets) << "20 - 2 x 4.9 is more than half of 20";
  in.even_inverted = Readings{20, 25.1};
  EXPECT_EQ(decide(in).cause, Cause::star_field);
}

TEST(Verdict, IsAConeIfTheAngleLimitMakesTheLargestPart) {
  for (const double sign : {1.0, -1.0}) {
    VerdictInput in = risen(0, 0, sign * 20);
    const auto without_limit = [&](double change) {  // the mean is that of the exact readings, so the scale is 1
      in.uncut = Readings{100 + sign * (10 - change / 2), 100 + sign * (10 + change / 2)};
      return decide(in);
    };
    EXPECT_EQ(without_limit(9.99).cause, Cause::cone) << sign;
    EXPECT_EQ(without_limit(10.01).cause, Cause::contact) << sign;
    const Verdict v = without_limit(4);
    EXPECT_NEAR(v.cone, sign * 16, 1e-12);
    EXPECT_NEAR(v.contact, sign * 4, 1e-12);
    EXPECT_NEAR(v.field, 0, 1e-12);
    in.uncut->before *= 3, in.uncut->now *= 3;
    EXPECT_NEAR(decide(in).cone, v.cone, 1e-12) << "scaled to the mean of the exact readings";
    in.uncut.reset();
    EXPECT_EQ(decide(in).cause, Cause::contact) << "unknown";
  }
}

TEST(Verdict, SaysWhetherAWiderAngleHelps) {
  VerdictInput in = risen(0, 0, 20);
  in.uncut = Readings{109, 111};
  Verdict v = decide(in);
  EXPECT_EQ(
      verdict_text(v, in),
      "Cone: the reading rose by 20 % of the taxel's largest, the exact integral of the same contact rose by 20 %, "
      "and without the limit of the angle rose by 2 %. The contact crossed the edge at which the limit cuts the "
      "field of the taxel.");
  v.wider = AngleTried{75, 3, true};
  EXPECT_NE(verdict_text(v, in).find("With a limit of 75 degrees it would be 3 % instead of 20 %, below the limit."),
            std::string::npos);
  v.wider = AngleTried{180, 8, false};
  EXPECT_NE(verdict_text(v, in).find("Even with a limit of 180 degrees it would be 8 % instead of 20 %, not safely"),
            std::string::npos);
}

TEST(Verdict, IsMeshEdgesIfTheirNormalsMakeTheLargestPart) {
  for (const double sign : {1.0, -1.0}) {
    VerdictInput in = risen(0, 0, sign * 20);
    const auto changes_by = [&](double change) {  // the mean is that of the exact readings, so the scale is 1
      return Readings{100 + sign * (10 - change / 2), 100 + sign * (10 + change / 2)};
    };
    in.smooth = changes_by(9.99);
    EXPECT_EQ(decide(in).cause, Cause::mesh_edges) << sign;
    in.smooth = changes_by(10.01);
    EXPECT_EQ(decide(in).cause, Cause::contact) << sign;
    in.smooth = changes_by(12), in.uncut = changes_by(3);
    const Verdict v = decide(in);
    EXPECT_NEAR(v.edges, sign * 8, 1e-12);
    EXPECT_NEAR(v.cone, sign * 9, 1e-12) << "the part of the limit that interpolated normals leave";
    EXPECT_NEAR(v.contact, sign * 3, 1e-12);
    EXPECT_EQ(v.cause, Cause::cone);
    in.smooth->before *= 3, in.smooth->now *= 3;
    EXPECT_NEAR(decide(in).edges, v.edges, 1e-12) << "scaled to the mean of the exact readings";
  }
}

TEST(Verdict, NamesCrossedEdgesAndTheSettingThatHelps) {
  VerdictInput in = risen(0, 0, 20);
  in.smooth = Readings{109, 111};
  Verdict v = decide(in);
  v.crossed = {{{3, 9}, 60, 0.0012, 0.5}};
  EXPECT_EQ(
      verdict_text(v, in),
      "Mesh edges: the reading rose by 20 % of the taxel's largest, the exact integral of the same contact rose "
      "by 20 %, and with normals interpolated over the faces it rose by 2 %. The contact crossed an edge of the "
      "mesh under the taxel: that between the faces 3 and 9, bent by 60 degrees, 1.2 mm from the taxel's centre.");
  SettingTried setting;
  setting.text = "exact readings", setting.change = 19;
  v.tried = {setting};
  EXPECT_NE(verdict_text(v, in).find(" None of 1 other settings of the layout that were tried helps."),
            std::string::npos);
  setting.text = "a roll-off of 10 degrees over interpolated normals", setting.change = 4, setting.cures = true;
  v.tried.push_back(setting);
  EXPECT_NE(verdict_text(v, in).find(" With a roll-off of 10 degrees over interpolated normals it would be 4 % instead "
                                     "of 20 %, below the limit."),
            std::string::npos);
}

TEST(Verdict, CallsAForceEqualUpToItsPartOfTheLargerOne) {
  VerdictInput in = risen(0, 0, 30);
  const auto cause = [&](double before, double now) {
    in.force = {before, now};
    const Verdict v = decide(in);
    EXPECT_EQ(v.force_stays, v.cause == Cause::redistribution) << before << " to " << now;
    return v.cause;
  };
  EXPECT_EQ(cause(100, 98), Cause::redistribution) << "2 % of the larger, which is the one before";
  EXPECT_EQ(cause(100, 97.99), Cause::contact);
  EXPECT_EQ(cause(98, 100), Cause::redistribution) << "2 % of the larger, which is the one now";
  EXPECT_EQ(cause(97.99, 100), Cause::contact);
  EXPECT_EQ(cause(0, 0), Cause::redistribution);
}

TEST(SampleGap, IsTheDifferenceLessTheErrorOfTheExactReading) {
  EXPECT_EQ(gap_of(10, 7, 0.5), 2.5) << "samples read more";
  EXPECT_EQ(gap_of(7, 10, 0.5), 2.5) << "samples read less";
  EXPECT_EQ(gap_of(7, 7.5, 0.5), 0) << "as large as the error";
  EXPECT_EQ(gap_of(7, 7.4, 0.5), 0) << "smaller than the error";
}

}  // namespace
}  // namespace taxel
