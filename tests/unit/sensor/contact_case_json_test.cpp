// Contact case files: values, and the places of errors.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/sensor/contact_case/contact_case.h"

namespace taxel {
namespace {

const std::string kExample = R"({ "format": "contact-case", "version": 1,
  "a": { "shape": { "type": "sphere", "size": [0.05] }, "resolution": 0.005,
         "material": { "field": "medial_axis", "modulus": 5.0e4, "dissipation": 2, "friction": 0.25 },
         "pos": [0, 0, 0.0475], "quat": [1, 0, 0, 0], "linear_velocity": [1, 2, 3], "angular_velocity": [4, 5, 6] },
  "b": { "shape": { "type": "plane" } } })";

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kExample;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string complaint(const std::string& text) {
  try {
    parse_contact_case(text, "case.json");
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(ContactCase, ReadsTheExampleOfTheManual) {
  const ContactCase c = parse_contact_case(kExample, "case.json");
  ASSERT_TRUE(c.a.shape && c.b.shape);
  EXPECT_EQ(c.a.shape->type, ShapeType::sphere);
  EXPECT_EQ(c.a.shape->size.x, 0.05);
  EXPECT_EQ(c.a.shape->resolution, 0.005);
  EXPECT_EQ(c.a.material, (Material{FieldKind::medial_axis, 5e4, 0, 2, 0.25}));
  EXPECT_EQ(c.a.X_WB.p, dvec3(0, 0, 0.0475));
  EXPECT_EQ(c.a.V_WB.linear, dvec3(1, 2, 3));
  EXPECT_EQ(c.a.V_WB.angular, dvec3(4, 5, 6));
  EXPECT_EQ(c.b.shape->type, ShapeType::plane);
  EXPECT_FALSE(c.b.material.compliant());
  EXPECT_EQ(c.b.material.friction, 0.5);
  EXPECT_EQ(c.b.X_WB.q, dquat(1, 0, 0, 0));
}

TEST(ContactCase, UsesMedialAxisForPrimitivesAndPadForMeshes) {
  const ContactCase c = parse_contact_case(R"({"format": "contact-case", "version": 1,
    "a": {"shape": {"type": "box", "size": [1, 2, 3]}, "material": {"modulus": 1}},
    "b": {"shape": {"type": "mesh", "file": "m.obj", "scale": [1, 1, -2]}, "material": {"modulus": 1, "thickness": 0.002}}})",
                                           "folder/case.json");
  EXPECT_EQ(c.a.material.field, FieldKind::medial_axis);
  EXPECT_EQ(c.b.material.field, FieldKind::pad);
  EXPECT_EQ(c.b.material.thickness, 0.002);
  EXPECT_EQ(c.b.shape->scale, dvec3(1, 1, -2));
  EXPECT_EQ(beside_case(c, c.b.shape->file), "folder/m.obj");
  EXPECT_EQ(beside_case(c, "/m.obj"), "/m.obj");
}

TEST(ContactCase, KeepsTheBitsOfUnitQuaternions) {
  const auto quat = [](const std::string& numbers) {
    return parse_contact_case(replaced("[1, 0, 0, 0]", numbers)).a.X_WB.q;
  };
  // Quaternions from simulations have squared lengths such as 1 + 6e-14.
  EXPECT_EQ(quat("[0.6, 0.80000000000004, 1e-17, 0]"), dquat(0.6, 0.80000000000004, 1e-17, 0));
  EXPECT_EQ(quat("[2, 0, 0, 0]"), dquat(1, 0, 0, 0));
  EXPECT_NEAR(glm::length(quat("[1, 1, 1, 0.5]")), 1.0, 1e-15);
}

TEST(ContactCase, NamesThePlaceOfAnError) {
  EXPECT_EQ(complaint("{").substr(0, 42), "case.json: line 1, column 2: is not JSON: ");
  EXPECT_EQ(complaint("[]"), "case.json: must be an object, is []");
  EXPECT_EQ(complaint(replaced("\"version\": 1", "\"version\": 7")),
            "case.json: /version: 7 is unknown, this program reads version 1");
  EXPECT_EQ(complaint(replaced("contact-case", "layout")),
            "case.json: /format: must be \"contact-case\", is \"layout\"");
  EXPECT_EQ(complaint(replaced("[0.05]", "[-0.05]")), "case.json: /a/shape/size/0: must be greater than 0, is -0.05");
  EXPECT_EQ(complaint(replaced("[0.05]", "[1e300]")), "case.json: /a/shape/size/0: must be at most 1e+06 m, is 1e+300");
  EXPECT_EQ(complaint(replaced("0.0475]", "-2e6]")), "case.json: /a/pos/2: must be at most 1e+06 m, is -2000000");
  EXPECT_EQ(complaint(replaced("5.0e4", "1e16")), "case.json: /a/material/modulus: must be at most 1e+15 Pa, is 1e+16");
  EXPECT_EQ(complaint(replaced("0.005", "1e7")), "case.json: /a/resolution: must be at most 1e+06 m, is 10000000");
  EXPECT_EQ(complaint(replaced("[0.05]", "[1, 2]")),
            "case.json: /a/shape/size: must be an array of 1 numbers, is [1,2]");
  EXPECT_EQ(complaint(replaced("[0, 0, 0.0475]", "[0, 0, \"x\"]")), "case.json: /a/pos/2: must be a number, is \"x\"");
  EXPECT_EQ(complaint(replaced("[1, 0, 0, 0]", "[0, 0, 0, 0]")), "case.json: /a/quat: must not be zero");
  EXPECT_EQ(complaint(replaced("5.0e4", "-5")), "case.json: /a/material/modulus: must not be negative, is -5");
  EXPECT_EQ(complaint(replaced("\"friction\"", "\"fricton\"")),
            "case.json: /a/material/fricton: unknown key; did you mean \"friction\"?");
  EXPECT_EQ(complaint(replaced("\"plane\"", "\"torus\"")),
            "case.json: /b/shape/type: must be one of \"plane\", \"sphere\", \"capsule\", \"ellipsoid\", \"cylinder\", "
            "\"box\", \"mesh\", \"tets\", \"hfield\", is \"torus\"");
  EXPECT_EQ(complaint(replaced("medial_axis", "axis")),
            "case.json: /a/material/field: must be one of \"pad\", \"medial_axis\", \"star\", \"tets\", is \"axis\"");
  EXPECT_EQ(complaint(replaced("\"plane\"", "\"mesh\"")), "case.json: /b/shape/file: is missing");
  EXPECT_EQ(complaint(replaced("0.005", "0")), "case.json: /a/resolution: must be greater than 0, is 0");
  EXPECT_EQ(complaint(replaced("0.0475", "1e999")),
            "case.json: line 4, column 24: is not JSON: the number 1e999 is too large");
  EXPECT_EQ(complaint(replaced("\"b\"", "\"a\"")), "case.json: has the key \"a\" twice in one object");
  EXPECT_EQ(complaint(replaced("\"b\"", "\"c\"")), "case.json: /c: unknown key");
}

TEST(ContactCase, UsesShapeAndMaterialOfALayout) {
  const std::string head = R"({"format": "contact-case", "version": 1, "b": {"shape": {"type": "plane"}}, "a": )";
  const ContactCase c = parse_contact_case(head + R"({"layout": "finger.taxels.json", "pos": [1, 0, 0]}})");
  EXPECT_EQ(c.a.layout, "finger.taxels.json");
  EXPECT_FALSE(c.a.shape);
  EXPECT_EQ(complaint(head + R"({"layout": "f.json", "material": {}}})"),
            "case.json: /a/material: a layout brings its own shape and material");
}

}  // namespace
}  // namespace taxel
