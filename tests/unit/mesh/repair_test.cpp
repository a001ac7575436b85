// Repair of meshes: each test makes one fault in a sound mesh, and repairs it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/repair/steps.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

RepairedMesh repair(const TriMesh& mesh, const RepairRecipe& recipe = {}) {
  return *repair_mesh(std::make_shared<const TriMesh>(mesh), recipe, 0.002);
}

std::string codes(const RepairedMesh& repaired) {
  std::string text;
  for (const RepairStep& step : repaired.report.steps) text += (text.empty() ? "" : " ") + step.code;
  return text;
}

void expect_sound(const RepairedMesh& repaired, const TriMesh& loaded) {
  EXPECT_TRUE(repaired.mesh->closed());
  EXPECT_TRUE(repaired.report.closed);
  EXPECT_GT(repaired.mesh->volume(), 0);
  if (repaired.mesh.get() != &loaded && !repaired.loaded_face_of.empty()) {
    ASSERT_EQ(static_cast<int>(repaired.loaded_face_of.size()), repaired.mesh->face_count());
    for (const int face : repaired.loaded_face_of) EXPECT_LT(face, loaded.face_count());
  }
  const RepairedMeshPtr again = repair_mesh(repaired.mesh, {}, 0.002);
  EXPECT_EQ(again->mesh, repaired.mesh) << "repaired again: " << repair_summary(again->report);
}

TEST(Repair, KeepsTheObjectOfASoundMesh) {
  for (const TriMesh& mesh : {make_box(dvec3(0.01)), make_icosphere(0.01, 3), make_fingertip()}) {
    const auto loaded = std::make_shared<const TriMesh>(mesh);
    const RepairedMeshPtr repaired = repair_mesh(loaded, {}, 0.002);
    EXPECT_EQ(repaired->mesh, loaded);
    EXPECT_TRUE(repaired->loaded_face_of.empty());
    EXPECT_EQ(repaired->loaded_face(5), 5);
    EXPECT_EQ(repair_summary(repaired->report), "");
    EXPECT_EQ(repaired->report.level, RepairLevel::keep);
  }
}

/// Intersections are kept only for the unchanged mesh, because the faces of a changed mesh have other numbers.
TEST(Repair, KeepsTheIntersectionsOfAnUnchangedMeshAlone) {
  const auto sound = std::make_shared<const TriMesh>(make_fingertip());
  const RepairedMeshPtr unchanged = repair_mesh(sound, {}, 0.002);
  ASSERT_TRUE(unchanged->crossings);
  EXPECT_EQ(unchanged->crossings->pairs, 0);
  const auto open = std::make_shared<const TriMesh>(test::without_faces(*sound, {7}));
  EXPECT_FALSE(repair_mesh(open, {}, 0.002)->crossings);
}

TEST(Repair, RemovesRepeatedAndFoldedFaces) {
  const TriMesh sphere = make_icosphere(0.01, 2);
  std::vector<ivec3> faces = sphere.faces();
  const int far = static_cast<int>(sphere.vertices().size());
  std::vector<dvec3> vertices = sphere.vertices();
  vertices.push_back(1.2 * sphere.vertices()[test::slot(faces[0].x)]);
  faces.push_back(faces[3]);
  faces.emplace_back(faces[0].x, faces[0].y, far);
  faces.emplace_back(faces[0].y, faces[0].x, far);
  const TriMesh broken(vertices, faces);
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_repeated repair_folded");
  EXPECT_EQ(repaired.mesh->faces(), sphere.faces());
  EXPECT_EQ(repaired.mesh->vertices(), sphere.vertices());
  EXPECT_EQ(repaired.changes.removed_faces.size(), 3U);
  expect_sound(repaired, broken);
}

TEST(Repair, CutsAFinOff) {
  const TriMesh sphere = make_icosphere(0.01, 3);
  const TriMesh broken = test::with_fin(sphere, 0, 0.002);
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_fin");
  EXPECT_EQ(repaired.mesh->faces(), sphere.faces());
  EXPECT_EQ(repaired.report.vertices_moved, 0);
  EXPECT_NE(repair_summary(repaired.report).find("1 fin removed"), std::string::npos);
  EXPECT_NE(repair_summary(repaired.report).find("no vertex moved"), std::string::npos);
  expect_sound(repaired, broken);
}

// A globe whose meridians end at points that rounding has kept apart, on a line: triangles without area between them.
TEST(Repair, JoinsThePolesOfAGlobe) {
  constexpr int kMeridians = 40, kParallels = 20;
  std::vector<dvec3> points;
  for (int i = 0; i < kMeridians; ++i)
    for (int k = 0; k <= kParallels; ++k) {
      const double u = 2 * kPi * i / kMeridians, v = kPi * k / kParallels;
      const dvec3 p(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v));
      points.push_back({static_cast<double>(static_cast<float>(p.x + 0.75)), p.y, p.z});
    }
  std::vector<ivec3> faces;
  for (int i = 0; i < kMeridians; ++i)
    for (int k = 0; k < kParallels; ++k) {
      const int a = i * (kParallels + 1) + k, b = (i + 1) % kMeridians * (kParallels + 1) + k;
      faces.emplace_back(a, b, b + 1);
      faces.emplace_back(a, b + 1, a + 1);
    }
  PolygonSoup soup;
  soup.vertices = points;
  soup.triangles = faces;
  std::vector<std::string> notes;
  const RepairedMeshPtr repaired =
      repair_mesh(std::make_shared<const TriMesh>(weld(std::move(soup), dvec3(1), notes)), {}, 0);
  EXPECT_TRUE(repaired->mesh->closed());
  EXPECT_EQ(repaired->mesh->vertex_count(), kMeridians * (kParallels - 1) + 2);
  EXPECT_EQ(repaired->report.level, RepairLevel::exact);
}

TEST(Repair, JoinsATornRim) {
  const TriMesh sphere = make_icosphere(0.01, 3);
  const TriMesh broken = test::torn(sphere, 2e-8);
  ASSERT_FALSE(broken.closed());
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_joined");
  EXPECT_EQ(repaired.mesh->face_count(), sphere.face_count());
  EXPECT_GT(repaired.report.vertices_moved, 0);
  EXPECT_LE(repaired.report.largest_move, 4e-8);
  EXPECT_NEAR(repaired.mesh->volume(), sphere.volume(), 1e-5 * sphere.volume());
  expect_sound(repaired, broken);
}

TEST(Repair, JoinsLooseFacesAlthoughAnEdgeGetsAThirdFace) {
  const TriMesh sphere = make_icosphere(0.01, 4), with_fin = test::with_fin(sphere, 9, 1e-4);
  test::RandomStream random(3);
  std::vector<dvec3> vertices;  // three of each face's own
  std::vector<ivec3> faces;
  for (int f = 0; f < with_fin.face_count(); ++f) {
    for (int c = 0; c < 3; ++c) vertices.push_back(with_fin.vertex(f, c) + random.in_cube(1e-8));
    faces.emplace_back(3 * f, 3 * f + 1, 3 * f + 2);
  }
  const TriMesh broken(std::move(vertices), std::move(faces));
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(repaired.report.level, RepairLevel::exact);
  EXPECT_EQ(repaired.report.shells_after, 1);
  EXPECT_NEAR(repaired.mesh->volume(), sphere.volume(), 1e-5 * sphere.volume());
  expect_sound(repaired, broken);
}

// Many triangulations of a plane are equally good: rounding must not choose one.
TEST(Repair, FillsAPlaneAlikeInEveryUnit) {
  const TriMesh box = test::refined_box(0.03, 20);
  std::vector<int> top;
  for (int f = 0; f < box.face_count(); ++f)
    if (box.face_normals()[test::slot(f)].z > 0.9) top.push_back(f);
  const TriMesh open = test::without_faces(box, top);
  const auto repaired = [&](double unit) {
    std::vector<dvec3> points = open.vertices();
    for (dvec3& p : points) p = unit * (p + dvec3(0.1, 0.2, 0.3));
    return repair_mesh(std::make_shared<const TriMesh>(std::move(points), open.faces()), {}, 0.002 * unit);
  };
  const RepairedMeshPtr metres = repaired(1);
  EXPECT_TRUE(metres->mesh->closed());
  for (const double unit : {0.001, 0.0254, 0.7, 3.0, 1000.0})
    EXPECT_EQ(metres->mesh->faces(), repaired(unit)->mesh->faces()) << unit;
}

TEST(Repair, FillsAMissingFace) {
  const TriMesh sphere = make_icosphere(0.01, 3);
  const TriMesh broken = test::without_faces(sphere, {7});
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_filled");
  ASSERT_EQ(repaired.changes.filled_faces.size(), 1U);
  EXPECT_EQ(repaired.loaded_face(repaired.changes.filled_faces[0]), -1);
  EXPECT_NEAR(repaired.mesh->volume(), sphere.volume(), 1e-12 * sphere.volume());
  expect_sound(repaired, broken);
}

TEST(Repair, FillsALargeHoleOfABoxFlat) {
  const TriMesh box = test::refined_box(0.01, 8);
  std::vector<int> top;
  for (int f = 0; f < box.face_count(); ++f)
    if (box.face_normals()[test::slot(f)].z > 0.9) top.push_back(f);
  const TriMesh broken = test::without_faces(box, top);
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_filled");
  EXPECT_EQ(repaired.report.steps[0].severity, Severity::warning);  // wider than a tenth of the diagonal
  EXPECT_NEAR(repaired.mesh->volume(), 8e-6, 1e-12);
  expect_sound(repaired, broken);
}

TEST(Repair, FillsAHoleWithTheLeastAngleToItsSurroundings) {
  // A saddle: both diagonals give the same area. The faces around it decide between a ridge (0 2) and a valley (1 3).
  HoleRim rim;
  rim.corners = {{0, 0, 0.3}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0}};
  rim.may_join = [](int, int) { return true; };
  const auto normal = [&](int a, int b, int c) {
    const auto at_corner = [&](int i) { return rim.corners[test::slot(i)]; };
    return glm::normalize(glm::cross(at_corner(b) - at_corner(a), at_corner(c) - at_corner(a)));
  };
  const auto has_edge = [](const std::vector<ivec3>& triangles, int i, int j) {
    return std::all_of(triangles.begin(), triangles.end(), [&](const ivec3& t) {
      return (t.x == i || t.y == i || t.z == i) && (t.x == j || t.y == j || t.z == j);
    });
  };
  const std::vector<dvec3> ridge{normal(0, 1, 2), normal(0, 1, 2), normal(0, 2, 3), normal(0, 2, 3)};
  const std::vector<dvec3> valley{normal(0, 1, 3), normal(1, 2, 3), normal(1, 2, 3), normal(0, 1, 3)};
  // The faces are steeper than the triangles of one choice and far from those of the other, so the rim's angles decide.
  const auto beyond = [](const dvec3& from, const dvec3& to) { return glm::normalize(to + 4.0 * (to - from)); };
  for (std::size_t i = 0; i < 4; ++i) rim.normals.push_back(beyond(valley[i], ridge[i]));
  EXPECT_TRUE(has_edge(fill_by_least_angle(rim).value(), 0, 2));
  for (std::size_t i = 0; i < 4; ++i) rim.normals[i] = beyond(ridge[i], valley[i]);
  EXPECT_TRUE(has_edge(fill_by_least_angle(rim).value(), 1, 3));
}

TEST(Repair, SplitsAnEdgeAtATJunction) {
  const TriMesh broken = test::box_with_t_junction(0.01);
  ASSERT_FALSE(broken.closed());
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_split");
  EXPECT_NEAR(repaired.mesh->volume(), 8e-6, 1e-15);
  EXPECT_TRUE(repaired.changes.filled_faces.empty());
  expect_sound(repaired, broken);
}

TEST(Repair, TurnsAFaceWithoutArea) {
  const TriMesh with_gap = test::box_with_t_junction(0.01);
  const TriMesh broken(with_gap.vertices(), with_gap.faces(), {test::t_junction_face()});
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_turned");
  EXPECT_NEAR(repaired.mesh->volume(), 8e-6, 1e-15);
  expect_sound(repaired, broken);
}

TEST(Repair, TurnsFacesAndWholeBodiesOutward) {
  const TriMesh sphere = make_icosphere(0.01, 2);
  for (const std::vector<int>& turned : {std::vector<int>{4, 5, 90}, test::all_faces(sphere)}) {
    const TriMesh broken = test::with_turned_faces(sphere, turned);
    const RepairedMesh repaired = repair(broken);
    EXPECT_EQ(codes(repaired), "repair_oriented");
    EXPECT_EQ(repaired.report.steps[0].faces, static_cast<int>(turned.size()));
    EXPECT_NEAR(repaired.mesh->volume(), sphere.volume(), 1e-12 * sphere.volume());
    expect_sound(repaired, broken);
  }
}

TEST(Repair, KeepsCavitiesInwardAndTurnsThemWithTheirBody) {
  const TriMesh body = test::hollow_sphere(0.01, 0.005);
  EXPECT_EQ(codes(repair(body)), "");
  const TriMesh inside_out = test::with_turned_faces(body, test::all_faces(body));
  const RepairedMesh repaired = repair(inside_out);
  EXPECT_EQ(codes(repaired), "repair_oriented");
  EXPECT_NEAR(repaired.mesh->volume(), body.volume(), 1e-12 * body.volume());
  expect_sound(repaired, inside_out);
}

TEST(Repair, PartsCubesThatTouchAlongAnEdgeOrAtAPoint) {
  for (const dvec3& by : {dvec3(0.02, 0.02, 0), dvec3(0.02, 0.02, 0.02)}) {
    const TriMesh broken = test::welded(test::together(make_box(dvec3(0.01)), test::moved(make_box(dvec3(0.01)), by)));
    const RepairedMesh repaired = repair(broken);
    EXPECT_EQ(codes(repaired), "repair_parted");
    EXPECT_EQ(repaired.report.shells_after, 2);
    EXPECT_NEAR(repaired.mesh->volume(), 16e-6, 1e-15);
    expect_sound(repaired, broken);
  }
}

TEST(Repair, PartsARingThatTouchesItselfAlongAnEdge) {
  const TriMesh broken = test::closed_ring_of_cubes(0.01);
  ASSERT_FALSE(broken.closed());
  const RepairedMesh repaired = repair(broken);
  EXPECT_EQ(codes(repaired), "repair_parted");
  EXPECT_FALSE(repaired.changes.parted_edges.empty());
  EXPECT_NEAR(repaired.mesh->volume(), broken.volume(), 1e-15);
  expect_sound(repaired, broken);
}

TEST(Repair, UnitesBoxesThatOverlapTouchOrLieInsideEachOther) {
  struct Case {
    dvec3 half, by;
    double volume;
    int shells;
  };
  const TriMesh box = make_box(dvec3(0.01));
  // Pairs of boxes that overlap by a quarter, are stacked with faces of different size, are nested, or are apart.
  for (const Case& c :
       {Case{dvec3(0.01), dvec3(0.015, 0.003, 0.001), 16e-6 - 0.005 * 0.017 * 0.019, 1},
        Case{dvec3(0.004), dvec3(0.014, 0.002, 0), 8e-6 + 512e-9, 1}, Case{dvec3(0.004), dvec3(0.001, 0, 0), 8e-6, 1},
        Case{dvec3(0.004), dvec3(0.05, 0, 0), 8e-6 + 512e-9, 2}}) {
    const TriMesh loaded = test::together(box, test::moved(make_box(c.half), c.by));
    const RepairedMesh repaired = repair(loaded);
    EXPECT_EQ(codes(repaired), c.shells == 1 ? "repair_united" : "");
    EXPECT_NEAR(repaired.mesh->volume(), c.volume, 1e-12);
    EXPECT_EQ(repaired.mesh->shell_count(), c.shells);
    // Every face is in the plane of its original face.
    for (int f = 0; f < repaired.mesh->face_count(); ++f) {
      ASSERT_GE(repaired.loaded_face(f), 0);
      const auto from = test::slot(repaired.loaded_face(f));
      EXPECT_NEAR(glm::dot(repaired.mesh->face_normals()[test::slot(f)], loaded.face_normals()[from]), 1, 1e-12);
    }
    expect_sound(repaired, loaded);
  }
}

TEST(Repair, StacksBoxesWithEqualFaces) {
  const TriMesh box = make_box(dvec3(0.01));
  const TriMesh loaded = test::welded(test::together(box, test::moved(box, dvec3(0, 0, 0.02))));
  const RepairedMesh repaired = repair(loaded);
  EXPECT_NEAR(repaired.mesh->volume(), 16e-6, 1e-15);
  EXPECT_EQ(repaired.mesh->shell_count(), 1);
  expect_sound(repaired, loaded);
}

TEST(Repair, NamesTheKeyOfABadRecipe) {
  const TriMesh box = make_box(dvec3(0.01));
  RepairRecipe recipe;
  recipe.edge = -0.001;
  try {
    repair(box, recipe);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/mesh/repair/edge");
    EXPECT_EQ(error.message(), "must be greater than 0, is -0.001");
  }
}

TEST(Repair, ReportsThatFoldsEncloseNothing) {
  const TriMesh fold({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}, {0, 2, 1}});
  try {
    repair(fold);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.message().find("encloses nothing"), std::string::npos);
  }
}

TEST(Repair, RefusesAnOpenMeshThatIsKept) {
  RepairRecipe recipe;
  recipe.level = RepairLevel::keep;
  const TriMesh sphere = make_icosphere(0.01, 2);
  EXPECT_THROW(repair(test::without_faces(sphere, {3}), recipe), Error);
  EXPECT_EQ(codes(repair(sphere, recipe)), "");
}

TEST(Repair, ClosesEveryRealMeshAndKeepsSoundOnes) {
  struct SharedMesh {
    const char* name;
    double scale;
    const char* codes;
    int shells;
  };
  const std::filesystem::path folder = TAXEL_REAL_DATA;
  if (!std::filesystem::exists(folder / "skins")) GTEST_SKIP() << "the real meshes are absent: " << folder;
  // The Shadow fingertip is its skin and a closed cavity. It is unchanged, bit for bit.
  for (const SharedMesh& real : {SharedMesh{"meshes/shadow_f_distal_pst.stl", 0.001, "", 2},
                                 {"meshes/shadow_f_distal_bt_sp.stl", 0.001, "", 1},
                                 {"meshes/plate_8in_col.stl", 1, "", 1},
                                 {"meshes/spot/spot_triangulated.obj", 1, "", 1},
                                 {"skins/ability_thumb.glb", 1, "", 1},
                                 {"skins/allegro_tip.stl", 1, "repair_joined", 1},
                                 {"skins/digit_holder.stl", 0.001, "repair_joined", 1},
                                 {"skins/leap_pip.stl", 1, "repair_parted", 8},
                                 {"skins/dclaw_tip.obj", 1, "repair_parted repair_united", 2},
                                 {"skins/inspire_thumb.obj", 1, "repair_united", 1},
                                 {"skins/gripper_flange.stl", 0.001, "repair_joined repair_parted repair_united", 1}}) {
    SCOPED_TRACE(real.name);
    const LoadedMesh loaded = load_mesh(folder / real.name, dvec3(real.scale));
    const RepairedMeshPtr repaired = repair_mesh(loaded.mesh, {}, 0.002);
    EXPECT_EQ(codes(*repaired), real.codes);
    EXPECT_EQ(repaired->mesh == loaded.mesh, std::string(real.codes).empty());
    EXPECT_EQ(repaired->mesh->shell_count(), real.shells);
    EXPECT_LE(repaired->report.largest_move, 5e-6);
    expect_sound(*repaired, *loaded.mesh);
  }
}

/// The removed area and the area inside a union are reported separately.
TEST(Repair, ReportsEachKindOfAreaInTheSummary) {
  const TriMesh box = make_box({0.01, 0.01, 0.01});
  std::vector<dvec3> vertices = box.vertices();
  std::vector<ivec3> faces = box.faces();
  const int corners = box.vertex_count();
  for (const dvec3& v : box.vertices()) vertices.push_back(v + dvec3(0.01, 0.002, 0.003));
  for (const ivec3& f : box.faces()) faces.push_back(f + ivec3(corners));
  // A fin on an edge of the first box, away from the second.
  const ivec3 face = box.faces().front();
  vertices.push_back(box.vertex(0, 0) + dvec3(-0.002, -0.001, -0.001));
  faces.emplace_back(face.x, face.y, static_cast<int>(vertices.size()) - 1);
  const RepairedMesh repaired = repair(TriMesh(std::move(vertices), std::move(faces)));
  EXPECT_EQ(codes(repaired), "repair_fin repair_united");
  double fin = 0, inside = 0;
  for (const RepairStep& step : repaired.report.steps) (step.code == "repair_fin" ? fin : inside) = step.area;
  ASSERT_GT(fin, 0);
  ASSERT_GT(inside, 0);
  const double all = repaired.report.area_before;
  EXPECT_EQ(repair_summary(repaired.report),
            fmt::format("repaired: 1 fin removed ({:.3g} mm\u00b2, {:.2g} % of the area), {} united ({:.0f} mm\u00b2, "
                        "{:.2g} % of the area), no vertex moved",
                        1e6 * fin, 100 * fin / all,
                        repaired.report.steps.back().count == 1 ? "1 overlapping shell" : "2 overlapping shells",
                        1e6 * inside, 100 * inside / all));
}

TEST(Repair, RepairsThePapersFingertip) {
  const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / "paper" / "ubi_tip_collision.stl";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "the paper's mesh is absent: " << path;
  const LoadedMesh loaded = load_mesh(path, dvec3(0.001));
  ASSERT_FALSE(loaded.mesh->closed());
  const RepairedMesh repaired = repair(*loaded.mesh);
  EXPECT_EQ(repaired.report.faces_before, 175);
  EXPECT_EQ(repaired.report.faces_after, 172);
  EXPECT_EQ(codes(repaired), "repair_folded repair_fin");
  EXPECT_EQ(repaired.report.vertices_moved, 0);
  EXPECT_EQ(repaired.report.shells_after, 1);
  EXPECT_EQ(repair_summary(repaired.report),
            "repaired: 2 folded faces and 1 fin removed (2.63 mm\u00b2, 0.16 % of the area), no vertex moved");
  expect_sound(repaired, *loaded.mesh);
}

}  // namespace
}  // namespace taxel
