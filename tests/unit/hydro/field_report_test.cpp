// Reports about pressure fields: sentences, places and numbers.
#include "core/hydro/fields/pressure_field.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "fixtures/hydro_bodies.h"
#include "fixtures/pad_meshes.h"

namespace taxel {
namespace {

const Problem* find(const Problems& problems, const std::string& code) {
  for (const Problem& p : problems) {
    if (p.code == code) return &p;
  }
  return nullptr;
}

/// A box with a thin fin: only the box has room for the pad.
TEST(FieldReport, NamesThePlacesWhereTheBodyIsTooThin) {
  TriMesh block = make_l_block(0.005, 8);  // 40 mm, half of it 20 mm thick
  std::vector<dvec3> vertices = block.vertices();
  for (dvec3& v : vertices) {
    if (v.z > 0.0201) v.x *= 0.1;  // the upright half becomes a fin of 2 mm
  }
  const TriMeshPtr mesh = share({vertices, block.faces()});
  const PressureFieldPtr field = make_pad_field(mesh, 1e5, 0.003);
  const FieldReport& report = field->report();
  EXPECT_GT(report.limited.faces, 0);
  EXPECT_NEAR(report.limited.bounds.hi.z, 0.04, 1e-9);
  EXPECT_GT(report.limited.bounds.lo.z, 0.01);  // faces of the fin and the faces that touch it
  EXPECT_GT(report.limited.worst_place.z, 0.015);
  EXPECT_LT(report.least_part, 0.5);
  EXPECT_EQ(report.bare.faces, 0);
  EXPECT_NEAR(report.skin_area, mesh->area(), 1e-12);
  EXPECT_GE(report.limited.area, report.thickness_limited_fraction * mesh->area() * (1 - 1e-9));
  EXPECT_LE(report.stiffness_min, report.stiffness_mean * (1 + 1e-12));
  EXPECT_GE(report.stiffness_max, report.stiffness_mean * (1 - 1e-12));
  const Problems problems = field_problems(report, "f", "/p");
  ASSERT_NE(find(problems, "field_thickness_limited"), nullptr);
  EXPECT_EQ(find(problems, "field_thickness_limited")->severity, Severity::note);
  EXPECT_EQ(find(problems, "field_bare"), nullptr);
  EXPECT_EQ(problems.front().code, "field_report");
  EXPECT_EQ(problems.front().pointer, "/p");
}

TEST(FieldReport, GivesLayersAndErrorOfPads) {
  const auto text = [](const PressureField& field) {
    const Problems problems = field_problems(field.report(), "", "");
    return find(problems, "field_report")->message;
  };
  const PressureFieldPtr step = make_pad_field(share(make_l_block(0.001, 10)), 1e5, 0.0025);
  EXPECT_GT(step->report().two_layer_faces, 10);
  EXPECT_NE(
      text(*step).find("; two layers of prisms below " + std::to_string(step->report().two_layer_faces) + " faces, 1."),
      std::string::npos)
      << text(*step);
  EXPECT_NE(text(*make_pad_field(share(make_box(dvec3(0.02))), 1e5, 0.004)).find("; one layer of prisms, "),
            std::string::npos);
  EXPECT_EQ(text(*make_star_field(share(make_box(dvec3(0.02))), 1e5)).find("layer"), std::string::npos);
}

TEST(FieldReport, LimitsNothingInABodyWithRoomForThePad) {
  const PressureFieldPtr field = make_pad_field(share(make_icosphere(0.02, 3)), 1e5, 0.004);
  EXPECT_EQ(field->report().limited.faces, 0);
  EXPECT_EQ(field->report().least_part, 1);
  EXPECT_NEAR(field->report().stiffness_mean, 1e5 / 0.004, 0.01 * 1e5 / 0.004);
  EXPECT_EQ(field_problems(field->report(), "", "").size(), 1U);
}

/// A vertex is moved over its neighbours in their common plane. The folded faces cannot have a pad.
TEST(FieldReport, CountsFacesWithoutAPad) {
  TriMesh plate = make_cylinder(0.02, 0.005, 0.004);
  std::vector<dvec3> vertices = plate.vertices();
  int moved = -1;
  for (int v = 0; v < plate.vertex_count(); ++v) {
    const dvec3& x = vertices[static_cast<std::size_t>(v)];
    if (moved < 0 && x.z == 0.005 && std::hypot(x.x, x.y) > 0.005 && std::hypot(x.x, x.y) < 0.012) moved = v;
  }
  ASSERT_GE(moved, 0);
  vertices[static_cast<std::size_t>(moved)] += dvec3(0.006, 0.002, 0);  // in its own plane, over its neighbours
  const TriMeshPtr mesh = share({vertices, plate.faces()});
  std::vector<int> numbers;
  for (int f = 0; f < mesh->face_count(); ++f) numbers.push_back(1000 + f);
  const PressureFieldPtr field = make_pad_field(mesh, 1e5, 0.002, numbers);
  const FieldReport& report = field->report();
  EXPECT_EQ(report.inverted, 0);
  EXPECT_GT(report.bare.faces, 0);
  EXPECT_GE(report.bare.worst_face, 1000);
  EXPECT_NEAR(report.bare.worst_place.z, 0.005, 1e-9);
  const Problems problems = field_problems(report, "", "");
  ASSERT_NE(find(problems, "field_bare"), nullptr);
  EXPECT_NE(find(problems, "field_bare")->message.find(std::to_string(report.bare.faces)), std::string::npos);
  const std::string named = fmt::format("face {}, (", report.bare.worst_face);
  EXPECT_NE(find(problems, "field_bare")->message.find(named), std::string::npos);

  const std::vector<int> filled(numbers.size(), -1);  // the numbers that a repair gives to faces that fill a hole
  const Problems of_filled = field_problems(make_pad_field(mesh, 1e5, 0.002, filled)->report(), "", "");
  const std::string& message = find(of_filled, "field_bare")->message;
  EXPECT_NE(message.find("the largest is a face that the repair filled in, ("), std::string::npos) << message;
  EXPECT_TRUE(message.ends_with(", 5) mm")) << message;
}

TEST(FieldReport, WarnsOfPadsThickerThanTheBody) {
  const PressureFieldPtr field = make_pad_field(share(make_box({0.02, 0.02, 0.002})), 1e5, 0.01);
  EXPECT_EQ(field->report().inverted, 0);
  const Problems problems = field_problems(field->report(), "", "");
  ASSERT_NE(find(problems, "field_thicker_than_body"), nullptr);
  EXPECT_EQ(find(problems, "field_thicker_than_body")->severity, Severity::warning);
}

TEST(FieldReport, WarnsOfInvertedTets) {
  const PressureFieldPtr star = make_star_field(share(make_thimble(0.008, 0.015, 0.0025, 0.002)), 1e5);
  EXPECT_GT(star->report().inverted, 0);
  ASSERT_NE(find(field_problems(star->report(), "", ""), "field_inverted"), nullptr);
}

}  // namespace
}  // namespace taxel
