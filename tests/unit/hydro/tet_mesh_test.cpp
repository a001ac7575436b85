// Pressure fields on given tet meshes, and errors for broken meshes.
#include "core/hydro/fields/tet_mesh.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/hydro/fields/pressure_field.h"
#include "fixtures/field_checks.h"
#include "fixtures/hydro_bodies.h"
#include "fixtures/vtk_files.h"

namespace taxel {
namespace {

TetMesh tets_of(const PressureField& field) {
  TetMesh mesh{field.vertices(), {}, {}};
  for (const Tet& tet : field.tets()) mesh.tets.push_back(tet.vertices);
  return mesh;
}

std::string refusal(const std::string& text) {
  try {
    read_vtk_tets(text, "f.vtk");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

const std::string kHead = "# vtk DataFile Version 3.0\nsome title\nASCII\nDATASET UNSTRUCTURED_GRID\n";
const std::string kPoints = "POINTS 4 double\n0 0 0 1 0 0\n0 1 0\n0 0 1\n";

TEST(TetField, EqualsTheMedialAxisFieldOfABox) {
  const PressureFieldPtr box = make_box_field({0.01, 0.02, 0.03}, 1e5);
  const PressureFieldPtr same = make_tet_field(tets_of(*box), 1e5, 0);
  EXPECT_EQ(same->report().inverted, 0);
  for (std::size_t v = 0; v < box->vertices().size(); ++v)
    EXPECT_NEAR(same->vertex_pressure()[v], box->vertex_pressure()[v], 1e-9);
  const PressureFieldPtr thin = make_tet_field(tets_of(*box), 1e5, 0.02);  // H is given, and E is not reached
  EXPECT_NEAR(thin->max_pressure(), 0.5e5, 1e-6);
  expect_sound(*same);
}

TEST(TetField, ReorientsTetsOfAnyOrder) {
  TetMesh mesh = tets_of(*make_box_field(dvec3(0.01), 1e5));
  int odd = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    ivec4& tet = mesh.tets[t];
    if (t % 2 == 0) std::swap(tet[0], tet[1]);
    odd += t % 2 == 0 ? 1 : 0;
    for (std::size_t turn = 0; turn < t % 3; ++turn) tet = {tet[0], tet[2], tet[3], tet[1]};
    if (t % 5 > 2) tet = {tet[1], tet[0], tet[3], tet[2]};
    if (t % 7 > 3) tet = {tet[2], tet[3], tet[0], tet[1]};
  }
  const PressureFieldPtr field = make_tet_field(mesh, 1e5, 0);
  EXPECT_EQ(field->report().inverted, odd);
  EXPECT_NEAR(field_volume(*field), 8e-6, 1e-18);
  const TriMesh boundary = boundary_of(mesh);
  EXPECT_TRUE(boundary.closed());
  EXPECT_NEAR(boundary.volume(), 8e-6, 1e-18);
}

TEST(TetField, NamesBadInput) {
  const auto message = [](const TetMesh& mesh, double modulus) -> std::string {
    try {
      make_tet_field(mesh, modulus, 0);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  const TetMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}, {}};
  // All vertices are on the boundary, so there is no pressure anywhere.
  EXPECT_NE(message(one, 1).find("inside"), std::string::npos);
  EXPECT_NE(message(one, 0).find("modulus"), std::string::npos);
  TetMesh bad = one;
  bad.tets[0][2] = 7;
  EXPECT_NE(message(bad, 1).find("tet 0 has no vertex 7"), std::string::npos);
  bad.tets[0] = {0, 1, 1, 3};
  EXPECT_NE(message(bad, 1).find("no volume"), std::string::npos);
  bad = one;
  bad.vertices.insert(bad.vertices.end(), {{0.3, 0.3, 2}, {0.3, 0.3, 3}});
  bad.tets = {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}};
  EXPECT_NE(message(bad, 1).find("share one face"), std::string::npos);
}

TEST(TetField, MakesABody) {
  Material soft = soft_material(1e5);
  soft.field = FieldKind::tets;
  Shape shape{ShapeType::tets, dvec3(0), nullptr, 0};
  shape.tets = std::make_shared<const TetMesh>(tets_of(*make_box_field(dvec3(0.01), 1e5)));
  const HydroBodyPtr body = make_body(shape, soft, "t"), plane = make_simple_body(ShapeType::plane, dvec3(0));
  // A4 with L1 = L2 = 2 H
  const double x = 0.002, force = 1e5 / 0.01 * (x * 4e-4 - x * x * 0.04 + 4 * x * x * x / 3);
  EXPECT_NEAR(touch(*body, *plane, at_height(0.01 - x), {}).wrench.force.z, force, 1e-10 * force);
  EXPECT_NEAR(std::get<RigidMesh>(make_body(shape, {}, "t")->geometry).index->mesh().volume(), 8e-6, 1e-18);
}

TEST(VtkTets, AreTheSameAfterARoundTrip) {
  const PressureFieldPtr field = make_capsule_field(0.01, 0.02, 1e5, 0.004);
  const TetMesh back = read_vtk_tets(vtk_text(*field), "f.vtk");
  EXPECT_EQ(back.vertices, field->vertices());
  EXPECT_EQ(back.pressure, field->vertex_pressure());
  ASSERT_EQ(back.tets.size(), field->tets().size());
  const PressureFieldPtr again = make_tet_field(back, 1e5, 0);
  for (std::size_t t = 0; t < back.tets.size(); ++t) {
    EXPECT_EQ(again->tets()[t].vertices, field->tets()[t].vertices);
    EXPECT_EQ(again->tets()[t].gradient, field->tets()[t].gradient);
  }
}

TEST(VtkTets, AreReadFromFilesOfOtherPrograms) {
  const TetMesh mesh = read_vtk_tets(kHead + kPoints +
                                         "\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 4\nVECTORS v float\n"
                                         "1 2 3 4 5 6 7 8 9 10 11 12\nSCALARS Pressure float\nLOOKUP_TABLE default\n"
                                         "0 0.5 1 2\n",
                                     "f.vtk", dvec3(0.001));
  EXPECT_EQ(mesh.vertices[3], dvec3(0, 0, 0.001));
  EXPECT_EQ(mesh.pressure, (std::vector<double>{0, 0.5, 1, 2}));
}

TEST(VtkTets, AreReadInEachFormWithPressuresAfterOtherAttributes) {
  const std::vector<dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<double> pressures{0, 0.5, 1e5, 2};
  for (const bool binary : {false, true}) {
    for (const bool offsets : {false, true}) {
      std::string bytes = test::vtk_bytes(points, {{10, {0, 1, 2, 3}}}, {binary, offsets, "double"});
      const auto append = [&](const std::string& head, const std::vector<double>& numbers, const char* type) {
        bytes += head;
        for (const double x : numbers) test::append_vtk_number(bytes, x, type, binary);
        bytes += '\n';
      };
      append("CELL_DATA 1\nSCALARS pressure float\nLOOKUP_TABLE default\n", {7}, "float");
      append("POINT_DATA 4\nTEXTURE_COORDINATES t 1 short\n", {1, 2, 3, 4}, "short");
      append("FIELD FieldData 2\nv 3 4 double\n", std::vector<double>(12, 3), "double");
      bytes += "METADATA\nINFORMATION 0\n\n";
      append("pressure 1 4 double\n", pressures, "double");
      EXPECT_EQ(read_vtk_tets(bytes, "f.vtk").pressure, pressures) << binary << offsets;
      EXPECT_EQ(read_vtk_tets(bytes, "f.vtk").tets, (std::vector<ivec4>{{0, 1, 2, 3}}));
    }
  }
}

TEST(VtkTets, AreRefusedByLineIfTheFileIsBad) {
  EXPECT_EQ(refusal(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"), "");
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(refusal(text), "f.vtk: line " + message);
  };
  expect("solid x\n", "1: is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
  expect("# vtk DataFile Version 3.0\nt\nBINAR\n", "3: must say ASCII or BINARY in its third line");
  expect(kHead + "POINTS 2 double\n0 0 nan 1 1 1\n", "6: nan is not finite");
  expect(kHead + "POINTS 2 double\n0 0 0 1 1\n", "6: is cut off within its points");
  expect(kHead + "POINTS -2 double\n", "5: -2 points cannot be");
  expect(kHead + kPoints + "CELLS 1 5\n4 0 1 2 4\n", "10: cell 0: no point 4 (there are 4)");
  expect(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10\n", "11: 2 cell types for 1 cells");
  expect(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n256\n",
         "12: cell 0 is of type 256, which is not known");
  expect(kHead + kPoints, "8: has no CELLS");
  expect(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\n", "10: has no CELL_TYPES");
  expect(kHead + kPoints + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\nPOINT_DATA 3\n",
         "13: data of 3 points, but there are 4");
}

TEST(VtkTets, AreRefusedWithTheRemedyIfTheFileHasNone) {
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(refusal(text), "f.vtk: " + message);
  };
  const std::string surface =
      "is a surface, a body of tets needs an UNSTRUCTURED_GRID of tets: fill the surface with tets (Gmsh, TetGen), or "
      "give it as a shape of type \"mesh\"";
  expect("# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n" + kPoints + "POLYGONS 1 4\n3 0 1 2\n", surface);
  expect(kHead + kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n", surface);
  expect(kHead + kPoints + "CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n10 5\n",
         "cell 1: is of type 5 (triangle), a tet is of type 10: save the tets without other cells");
  expect(kHead + kPoints + "CELLS 1 9\n8 0 1 2 3 0 1 2 3\nCELL_TYPES 1\n12\n",
         "cell 0: is of type 12 (hexahedron), a tet is of type 10: cut the cells into tets (Tetrahedralize in "
         "ParaView)");
  expect(kHead + kPoints + "CELLS 1 11\n10 0 1 2 3 0 1 2 3 0 1\nCELL_TYPES 1\n24\n",
         "cell 0: is of type 24 (quadratic tet), a tet is of type 10: save the tets with straight edges, of first "
         "order");
  expect(kHead + kPoints + "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n10\n", "cell 0: has 3 corners, a tet has 4");
}

}  // namespace
}  // namespace taxel
