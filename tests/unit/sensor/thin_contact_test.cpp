// Thin bodies in a skin: readings, forces and the explanation are those of the face that pushes into the skin.
#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"
#include "core/sensor/explain/explanation.h"
#include "unit/sensor/labelled_case.h"

namespace taxel {
namespace {

constexpr double kTop = 0.004, kPad = 0.002, kModulus = 5e4, kDepth = 0.001, kSide = 0.006;  // [m, Pa]
constexpr double kCard = 1e-4, kThick = 5e-3;                                                // thickness [m]

/// Returns a plate of rigid material in a flat pad with one taxel that is smaller than the plate.
test::LabelledCase card_in_pad(double thickness, FaceRule faces, Aggregate how = Aggregate::mean) {
  Layout layout;
  layout.mesh.file = "pad";
  layout.material.modulus = kModulus;
  layout.material.thickness = kPad;
  layout.material.field = FieldKind::pad;
  layout.material.faces = faces;
  layout.sampling.density = 2e6;
  layout.readout.aggregate = how;
  layout.taxels = {{0, "", dvec3(0, 0, kTop), dvec3(0, 0, 1), 0.002, {}}};
  test::LabelledCase c;
  c.model = test::preview_model(layout, std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.010, kTop))));
  Shape plate;
  plate.type = ShapeType::box;
  plate.size = {0.5 * kSide, 0.5 * kSide, 0.5 * thickness};
  c.other = make_body(plate, {}, "plate");
  return c;
}

SensorStep pressed(const test::LabelledCase& c, double thickness, double tilt = 0) {
  Pose pose{glm::angleAxis(tilt, dvec3(1, 0, 0)), dvec3(0)};
  pose.p = dvec3(0, 0, kTop - kDepth + 0.5 * thickness);
  return c.sense(pose);
}

TEST(CardInAPad, IsReadAndFeltLikeAThickPlate) {
  const double pressure = kModulus * kDepth / kPad, force = pressure * kSide * kSide;
  for (const double thickness : {kThick, kCard, 1e-5}) {
    const SensorStep step = pressed(card_in_pad(thickness, FaceRule::along_gradient), thickness);
    EXPECT_NEAR(step.readings[0], pressure, 1e-9 * pressure) << thickness;
    EXPECT_NEAR(glm::length(step.force_W), force, 1e-9 * force) << thickness;
  }
  const SensorStep all = pressed(card_in_pad(kCard, FaceRule::all), kCard);
  EXPECT_NEAR(glm::length(all.force_W), force * kCard / kDepth, 1e-6 * force) << "the difference of two pressures";
}

TEST(CardInAPad, IsExplainedByItsBackFace) {
  const test::LabelledCase card = card_in_pad(kCard, FaceRule::along_gradient);
  const Explanation of_card = Explainer().explain(0, pressed(card, kCard), nullptr, card.limits);
  EXPECT_EQ(of_card.samples_at_back_faces, static_cast<int>(of_card.samples.size()));
  EXPECT_NE(back_faces_text(of_card).find("Back face left out"), std::string::npos);
  const test::LabelledCase plate = card_in_pad(kThick, FaceRule::along_gradient);
  const Explanation of_plate = Explainer().explain(0, pressed(plate, kThick), nullptr, plate.limits);
  EXPECT_EQ(of_plate.samples_at_back_faces, 0);
  EXPECT_EQ(back_faces_text(of_plate), "");
}

// A plate that is turned by 70 degrees has back faces that count in part.
TEST(CardInAPad, HasTaxelsWhoseForcesAddUp) {
  for (const double tilt : {0.0, 0.3, 70 * kPi / 180}) {
    const test::LabelledCase c = card_in_pad(kCard, FaceRule::along_gradient, Aggregate::force);
    const Explanation e = Explainer().explain(0, pressed(c, kCard, tilt), nullptr, c.limits);
    EXPECT_GT(e.budget.covered, 0) << tilt;
    EXPECT_NEAR(e.budget.covered + e.budget.uncovered, e.budget.pressed, 1e-10 * e.budget.pressed) << tilt;
  }
}

}  // namespace
}  // namespace taxel
