// The verdict on contacts whose artifact is known by construction: two of each kind, and six that no rule was made on.
#include <gtest/gtest.h>

#include <cstdlib>

#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

using test::LabelledCase;

/// One sensor, one ball.
LabelledCase with_ball(const Layout& layout, const TriMeshPtr& mesh, double ball) {
  LabelledCase c;
  c.model = test::preview_model(layout, mesh);
  c.other = test::rigid_ball(ball);
  return c;
}

// Few samples of equal weight, a pad, steps of a tenth of a millimetre.
LabelledCase few_samples(double density, std::uint64_t seed) {
  const TriMeshPtr mesh = test::finger_mesh();
  Layout layout = test::layout_of(FieldKind::pad, density, SampleWeights::equal, seed);
  test::add_row(layout, mesh);
  LabelledCase c = with_ball(layout, mesh, 0.0015);
  c.path = test::along_finger(0.0015, 0.0004, -0.008, 0.0001, 160);
  return c;
}

// Two taps beside one taxel that are alike but for the distance to the centroid, which is the stiffness of a star.
LabelledCase egg(double ball, double off) {
  const TriMeshPtr mesh = test::egg_mesh();
  const dvec3 at(0.0055, 0, 0.0112);
  Layout layout = test::layout_of(FieldKind::star, 5e6);
  test::add_taxel(layout, mesh, at, 0.006);
  LabelledCase c = with_ball(layout, mesh, ball);
  c.path = test::two_taps(mesh, layout.taxels[0].center, off * glm::normalize(dvec3(-0.3, 0, 1)), ball, 0.001);
  return c;
}

// On the inner side of a torus all tets of a star are inside out, its centroid lies in the hole.
LabelledCase inside_of_torus(double radius, double tube, double angle, double ball) {
  const auto mesh = std::make_shared<const TriMesh>(test::round_ring(radius, tube));
  const double a = angle * kPi / 180;
  Layout layout = test::layout_of(FieldKind::star, 3e6);
  test::add_taxel(layout, mesh, dvec3(radius + tube * std::cos(a), 0, tube * std::sin(a)), 0.005);
  LabelledCase c = with_ball(layout, mesh, ball);
  c.path = test::two_taps(mesh, layout.taxels[0].center, 0.001 * dvec3(-std::sin(a), 0, std::cos(a)), ball, 0.001);
  return c;
}

// A ball led along a finger with a pad: the force stays, taxel after taxel feels it.
LabelledCase led_along(double ball, double step) {
  const TriMeshPtr mesh = test::finger_mesh();
  Layout layout = test::layout_of(FieldKind::pad, 5e6);
  test::add_row(layout, mesh);
  LabelledCase c = with_ball(layout, mesh, ball);
  c.path = test::along_finger(ball, 0.001, -0.008, step, static_cast<int>(0.016 / step));
  return c;
}

// The edge of a box comes over the finger and covers more and more of it.
LabelledCase edge_comes(const dquat& turn, const dvec3& from, const dvec3& step) {
  const TriMeshPtr mesh = test::finger_mesh();
  Layout layout = test::layout_of(FieldKind::pad, 5e6);
  test::add_row(layout, mesh);
  LabelledCase c;
  c.model = test::preview_model(layout, mesh);
  c.other = test::rigid_box(dvec3(0.010));
  c.path = test::led(turn, from, step, 16);
  return c;
}

// Many samples, steps of two hundredths of a millimetre.
LabelledCase smooth(FieldKind field) {
  const TriMeshPtr mesh = test::finger_mesh();
  Layout layout = test::layout_of(field, 5e6);
  test::add_row(layout, mesh);
  LabelledCase c = with_ball(layout, mesh, 0.004);
  c.path = test::along_finger(0.004, 0.001, 0.0, 0.00002, 40);
  return c;
}

struct Labelled {
  Cause label;
  const char* what;
  std::function<LabelledCase()> make;
};

/// How many get their label; all are told where TAXEL_SHOW_VERDICTS is set.
int count_right(const std::vector<Labelled>& cases) {
  int right = 0;
  for (const Labelled& c : cases) {
    const Explanation e = c.make().explain_largest_jump();
    const Verdict& v = e.change->verdict;
    EXPECT_NEAR(v.noise + v.field + v.contact, v.change, 1e-9 * std::abs(v.change) + 1e-12) << c.what;
    right += v.cause == c.label ? 1 : 0;
    if (v.cause != c.label || std::getenv("TAXEL_SHOW_VERDICTS") != nullptr)
      fmt::print("{} is {}, found {}: {}\n", c.what, to_word(c.label), to_word(v.cause), v.text);
  }
  return right;
}

TEST(Verdict, IsRightOnLabelledContacts) {
  const dquat straight(1, 0, 0, 0), turned = glm::angleAxis(kPi / 4, dvec3(0, 1, 0));
  const std::vector<Labelled> cases{
      {Cause::sampling_noise, "1e6 samples a square metre", [] { return few_samples(1e6, 1); }},
      {Cause::sampling_noise, "5e5 samples a square metre", [] { return few_samples(5e5, 2); }},
      {Cause::star_field, "a small ball on an egg", [] { return egg(0.003, 0.002); }},
      {Cause::star_field, "a larger ball on an egg", [] { return egg(0.006, 0.0015); }},
      {Cause::inverted_tets, "inside of a torus", [] { return inside_of_torus(0.014, 0.006, 128, 0.003); }},
      {Cause::inverted_tets, "inside of a thin torus", [] { return inside_of_torus(0.018, 0.005, 140, 0.004); }},
      {Cause::redistribution, "a ball along a finger", [] { return led_along(0.004, 0.0005); }},
      {Cause::redistribution, "a small ball along a finger", [] { return led_along(0.0025, 0.0004); }},
      {Cause::contact, "an edge across a finger",
       [&] { return edge_comes(straight, dvec3(0.016, 0, -0.018), dvec3(0, 0, 0.0006)); }},
      {Cause::contact, "an edge pressed into a finger",
       [&] { return edge_comes(turned, dvec3(0.007 + 0.01 * std::sqrt(2.0), 0, 0), dvec3(-0.00012, 0, 0)); }},
      {Cause::none, "slow, on a pad", [] { return smooth(FieldKind::pad); }},
      {Cause::none, "slow, on a star", [] { return smooth(FieldKind::star); }}};
  EXPECT_GE(count_right(cases), 11);
}

// Made when the rule was final, on other meshes, aggregates and ways.
TEST(Verdict, OnContactsThatNoRuleWasMadeOn) {
  const auto noise = [] {
    const TriMeshPtr mesh = test::egg_mesh();
    Layout layout = test::layout_of(FieldKind::pad, 8e5, SampleWeights::equal, 5);
    layout.readout.aggregate = Aggregate::mean;
    test::add_taxel(layout, mesh, dvec3(0.007, 0, 0), 0.003);
    LabelledCase c = with_ball(layout, mesh, 0.0015);
    c.path = test::led({1, 0, 0, 0}, dvec3(0.007 + 0.0015 - 0.0004, 0, -0.001), dvec3(0, 0, 0.0001), 21);
    return c;
  };
  const auto star = [] {
    const auto mesh = std::make_shared<const TriMesh>(make_fingertip());
    Layout layout = test::layout_of(FieldKind::star, 5e6);
    test::add_taxel(layout, mesh, dvec3(0, -0.02, 0.04), 0.006);
    LabelledCase c = with_ball(layout, mesh, 0.004);
    const Taxel& taxel = layout.taxels[0];
    const dvec3 up = glm::normalize(dvec3(0, 0, 1) - taxel.normal.z * taxel.normal);
    c.path = test::two_taps(mesh, taxel.center, 0.002 * up, 0.004, 0.001);
    return c;
  };
  const auto inverted = [] {
    const TriMeshPtr mesh = test::hook_mesh();
    Layout layout = test::layout_of(FieldKind::star, 3e6);
    const double turn = 0.9, inside = 0.018 - 0.006;
    test::add_taxel(layout, mesh, dvec3(inside * std::cos(turn) - 0.018, 0, inside * std::sin(turn)), 0.005);
    LabelledCase c = with_ball(layout, mesh, 0.003);
    c.path = test::two_taps(mesh, layout.taxels[0].center, 0.0015 * dvec3(-std::sin(turn), 0, std::cos(turn)), 0.003,
                            0.0008);
    return c;
  };
  const auto redistribution = [] {
    const TriMeshPtr mesh = test::egg_mesh();
    Layout layout = test::layout_of(FieldKind::pad, 5e6);
    for (const double z : {-0.004, 0.0, 0.004, 0.008}) test::add_taxel(layout, mesh, dvec3(0.007, 0, z), 0.0035);
    LabelledCase c = with_ball(layout, mesh, 0.003);
    c.path = test::equal_taps(c, mesh, {dvec3(0.007, 0, 0.001), dvec3(0.007, 0, 0.0022), dvec3(0.007, 0, 0.0034)},
                              0.003, 0.15);
    return c;
  };
  const auto edge = [] {
    const TriMeshPtr mesh = test::egg_mesh();
    Layout layout = test::layout_of(FieldKind::pad, 5e6);
    for (const double z : {-0.004, 0.0, 0.004}) test::add_taxel(layout, mesh, dvec3(0.007, 0, z), 0.004);
    LabelledCase c;
    c.model = test::preview_model(layout, mesh);
    c.other = test::rigid_box(dvec3(0.008));
    const dquat turn = glm::angleAxis(kPi / 5, dvec3(0, 0, 1));
    c.path = test::led(turn, dvec3(0.0165, 0, -0.016), dvec3(0, 0, 0.0008), 14);
    return c;
  };
  const auto nothing = [] {
    LabelledCase c = inside_of_torus(0.014, 0.006, 100, 0.003);
    const Pose from = c.path[0], to = c.path[1];
    c.path.clear();
    for (int i = 0; i <= 20; ++i) c.path.push_back({from.q, from.p + (0.05 * i) * (to.p - from.p)});
    return c;
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
