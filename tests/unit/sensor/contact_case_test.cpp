// The evaluation of a contact case: frames, velocities, and the body that the force acts on.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/hydro/intersect.h"
#include "core/sensor/contact_case/contact_case.h"

namespace taxel {
namespace {

CaseBody body_at(const Pose& X, const Twist& V) {
  CaseBody body;
  body.X_WB = X;
  body.V_WB = V;
  return body;
}

TEST(RelativeTwist, IsZeroForARigidPair) {
  // Both bodies are parts of one rigid body that rotates about the world's origin and translates.
  const dvec3 omega(1, -2, 0.5), v(0.3, 0.1, -0.2);
  const Pose X_a{glm::normalize(dquat(0.3, 0.5, -0.2, 0.7)), dvec3(0.1, -0.4, 2)};
  const Pose X_b{glm::normalize(dquat(0.9, 0, 0.2, 0.1)), dvec3(-1, 0.7, 0.2)};
  const Twist V = relative_twist(body_at(X_a, {v + glm::cross(omega, X_a.p), omega}),
                                 body_at(X_b, {v + glm::cross(omega, X_b.p), omega}));
  EXPECT_LT(glm::length(V.linear), 1e-15);
  EXPECT_LT(glm::length(V.angular), 1e-15);
}

TEST(RelativeTwist, IsInTheFrameOfA) {
  const Pose X_a{glm::angleAxis(kPi / 2, dvec3(0, 0, 1)), dvec3(0)};  // a's x axis is the world's y axis
  const Twist V =
      relative_twist(body_at(X_a, {dvec3(0, 2, 0), dvec3(0, 0, 3)}), body_at({}, {dvec3(0, 0.5, 0), dvec3(0)}));
  EXPECT_NEAR(glm::distance(V.linear, dvec3(1.5, 0, 0)), 0, 1e-15);
  EXPECT_NEAR(glm::distance(V.angular, dvec3(0, 0, 3)), 0, 1e-15);
}

ContactResult result_of(const ContactCase& c) {
  const MadeBody a = make_case_body(c, c.a, "a"), b = make_case_body(c, c.b, "b");
  ContactResult result;
  IntersectWorkspace workspace;
  evaluate_contact(c, *a.body, *b.body, result, workspace);
  return result;
}

ContactCase ball_on_plane() {
  return parse_contact_case(R"({"format": "contact-case", "version": 1,
    "a": {"shape": {"type": "sphere", "size": [0.05]}, "material": {"modulus": 5e4, "dissipation": 2}, "pos": [0.01, -0.02, 0.0475]},
    "b": {"shape": {"type": "plane"}}})");
}

TEST(EvaluateContact, DoesNotDependOnTheWorldFrame) {
  ContactCase c = ball_on_plane();
  c.a.V_WB = {dvec3(0.1, 0.05, -0.2), dvec3(3, 1, -2)};
  const ContactResult here = result_of(c);
  const Pose X{glm::normalize(dquat(0.2, -0.6, 0.4, 0.3)), dvec3(3, -1, 2)};
  for (CaseBody* body : {&c.a, &c.b}) {
    body->X_WB = X * body->X_WB;
    body->V_WB = {X.rotate(body->V_WB.linear), X.rotate(body->V_WB.angular)};
  }
  const ContactResult moved_result = result_of(c);
  const double size = glm::length(here.wrench_W.force);
  ASSERT_GT(size, 0.1);
  EXPECT_LT(glm::distance(moved_result.wrench_W.force, X.rotate(here.wrench_W.force)), 1e-10 * size);
  EXPECT_LT(glm::distance(moved_result.wrench_W.torque, X.rotate(here.wrench_W.torque)), 1e-10 * size * 0.05);
  EXPECT_LT(glm::distance(moved_result.centroid_W, X * here.centroid_W), 1e-12);
}

TEST(EvaluateContact, FindsTheCentroidOnTheLineOfTheForce) {
  ContactCase c = ball_on_plane();
  c.a.X_WB.q = glm::normalize(dquat(0.3, 0.5, -0.2, 0.7));
  const ContactResult result = result_of(c);
  const dvec3 torque = glm::cross(result.centroid_W - c.a.X_WB.p, result.wrench_W.force);
  EXPECT_LT(glm::distance(torque, result.wrench_W.torque), 1e-12 * glm::length(result.wrench_W.force));
}

TEST(EvaluateContact, IsEmptyForBodiesApart) {
  ContactCase c = ball_on_plane();
  c.a.X_WB.p.z = 0.06;
  const ContactResult result = result_of(c);
  EXPECT_TRUE(result.surface.empty());
  EXPECT_EQ(result.wrench_W.force, dvec3(0));
  EXPECT_FALSE(std::signbit(result.wrench_W.force.z));  // prints as 0, not as -0
  EXPECT_EQ(result.centroid_W, c.a.X_WB.p);
}

TEST(MakeCaseBody, NamesTheInvalidBody) {
  ContactCase c = ball_on_plane();
  c.file = "case.json";
  c.b.shape.reset();
  try {
    make_case_body(c, c.b, "b");
    FAIL() << "made a body out of nothing";
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "case.json: /b: needs a shape or a layout");
  }
}

}  // namespace
}  // namespace taxel
