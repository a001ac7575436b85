// The diagnosis of contacts with an artifact that is known by construction: two of each kind, and six that were not
// used to make the rules.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "fixtures/labelled_touches.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

using test::LabelledCase;
using test::sensed;
using test::Touch;

struct Labelled {
  Cause label;
  const char* what;
  std::function<LabelledCase()> make;
};

/// Returns the number of correct diagnoses. Prints all diagnoses if TAXEL_SHOW_VERDICTS is set.
int count_right(const std::vector<Labelled>& cases) {
  int right = 0;
  for (const Labelled& c : cases) {
    const Explanation e = c.make().explain_largest_jump();
    const Verdict& v = e.change->verdict;
    EXPECT_NEAR(v.noise + v.field + v.cone + v.edges + v.contact, v.change, 1e-9 * std::abs(v.change) + 1e-12)
        << c.what;
    right += v.cause == c.label ? 1 : 0;
    if (v.cause != c.label || std::getenv("TAXEL_SHOW_VERDICTS") != nullptr)
      fmt::print("{} is {}, found {}: {}\n", c.what, to_word(c.label), to_word(v.cause), v.text);
  }
  return right;
}

TEST(Verdict, IsRightOnLabelledContacts) {
  const dquat straight(1, 0, 0, 0), turned = glm::angleAxis(kPi / 4, dvec3(0, 1, 0));
  const std::vector<Labelled> cases{
      {Cause::sampling_noise, "1e6 samples a square metre", [] { return sensed(test::few_samples(1e6, 1)); }},
      {Cause::sampling_noise, "5e5 samples a square metre", [] { return sensed(test::few_samples(5e5, 2)); }},
      {Cause::star_field, "a small ball on an egg", [] { return sensed(test::taps_on_egg(0.003, 0.002)); }},
      {Cause::star_field, "a larger ball on an egg", [] { return sensed(test::taps_on_egg(0.006, 0.0015)); }},
      {Cause::inverted_tets, "inside of a torus", [] { return sensed(test::taps_on_torus(0.014, 0.006, 128, 0.003)); }},
      {Cause::inverted_tets, "inside of a thin torus",
       [] { return sensed(test::taps_on_torus(0.018, 0.005, 140, 0.004)); }},
      {Cause::redistribution, "a ball along a finger", [] { return sensed(test::led_along(0.004, 0.0005)); }},
      {Cause::redistribution, "a small ball along a finger", [] { return sensed(test::led_along(0.0025, 0.0004)); }},
      {Cause::contact, "an edge across a finger",
       [&] { return sensed(test::edge_comes(straight, dvec3(0.016, 0, -0.018), dvec3(0, 0, 0.0006))); }},
      {Cause::contact, "an edge pressed into a finger",
       [&] {
         return sensed(test::edge_comes(turned, dvec3(0.007 + 0.01 * std::sqrt(2.0), 0, 0), dvec3(-0.00012, 0, 0)));
       }},
      {Cause::cone, "taps around the edge of a cone", [] { return sensed(test::taps_around_cone(45, 0.002)); }},
      {Cause::cone, "taps of a larger ball around a wider cone",
       [] { return sensed(test::taps_around_cone(70, 0.003)); }},
      {Cause::mesh_edges, "a ball over the edge of a roof", [] { return sensed(test::over_roof(60, 0.001)); }},
      {Cause::none, "slow, on a pad", [] { return sensed(test::smooth(FieldKind::pad)); }},
      {Cause::none, "slow, on a star", [] { return sensed(test::smooth(FieldKind::star)); }}};
  EXPECT_GE(count_right(cases), 14);
}

// Cases with other meshes, aggregates and motions, made after the rule was final.
TEST(Verdict, IsRightOnContactsThatWereNotUsedForTheRules) {
  const auto noise = [] {
    Touch touch{test::layout_of(FieldKind::pad, 8e5, SampleWeights::equal, 5), test::egg_mesh(),
                test::ball_shape(0.0015),
                test::led({1, 0, 0, 0}, dvec3(0.007 + 0.0015 - 0.0004, 0, -0.001), dvec3(0, 0, 0.0001), 21)};
    touch.layout.readout.aggregate = Aggregate::mean;
    test::add_taxel(touch.layout, touch.mesh, dvec3(0.007, 0, 0), 0.003);
    return sensed(touch);
  };
  const auto star = [] { return sensed(test::taps_on_fingertip(0.004, 0.002)); };
  const auto inverted = [] { return sensed(test::taps_in_hook(0.9, 0.003, 0.0015)); };
  const auto redistribution = [] {
    Touch touch{test::layout_of(FieldKind::pad, 5e6), test::egg_mesh(), test::ball_shape(0.003), {}};
    for (const double z : {-0.004, 0.0, 0.004, 0.008})
      test::add_taxel(touch.layout, touch.mesh, dvec3(0.007, 0, z), 0.0035);
    LabelledCase c = sensed(touch);
    c.path = test::equal_taps(c, touch.mesh, {dvec3(0.007, 0, 0.001), dvec3(0.007, 0, 0.0022), dvec3(0.007, 0, 0.0034)},
                              0.003, 0.15);
    return c;
  };
  const auto edge = [] { return sensed(test::edge_comes_over_egg(kPi / 5)); };
  const auto nothing = [] {
    Touch touch = test::taps_on_torus(0.014, 0.006, 100, 0.003);
    const Pose from = touch.path[0], to = touch.path[1];
    touch.path = test::led(from.q, from.p, 0.05 * (to.p - from.p), 21);
    return sensed(touch);
  };
  const std::vector<Labelled> cases{{Cause::sampling_noise, "few samples, mean, on an egg", noise},
                                    {Cause::star_field, "a fingertip", star},
                                    {Cause::inverted_tets, "inside of a hook", inverted},
                                    {Cause::redistribution, "equal taps on an egg", redistribution},
                                    {Cause::contact, "an edge along an egg", edge},
                                    {Cause::none, "slow, over the top of a torus, on a star", nothing}};
  EXPECT_GE(count_right(cases), 5);
}

}  // namespace
}  // namespace taxel
