// Single steps of a repair on meshes of a few faces, with results that are known on paper.
#include <gtest/gtest.h>

#include "core/mesh/repair/repair.h"
#include "core/mesh/repair/steps.h"
#include "unit/mesh/broken_mesh.h"

namespace taxel {
namespace {

/// Returns whether both triangles have the corners i and j.
bool have_edge_in_common(const std::vector<ivec3>& triangles, int i, int j) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const ivec3& t) {
    return (t.x == i || t.y == i || t.z == i) && (t.x == j || t.y == j || t.z == j);
  });
}

// The rim is a saddle with the corners 0 and 2 high. Its triangles 012 and 023 meet in a ridge, 013 and 123 in a
// valley, and their normals are (+-0.3, +-0.3, 1). All faces around the hole are level but one, which leans by 1 to the
// side of the ridge or of the valley: 1 - cos of its angle to the triangle there is 0.11, to the other one 0.50, and
// all other angles, also that of the inner edge, are at most 0.31. So this one face decides, at each of the four edges.
TEST(RepairSteps, FillAHoleByTheAngleAtEachEdgeOfItsRim) {
  // Normals of the triangles at the edge from each corner to the next one.
  const std::vector<dvec3> ridge{{0.3, -0.3, 1}, {0.3, -0.3, 1}, {-0.3, 0.3, 1}, {-0.3, 0.3, 1}};
  const std::vector<dvec3> valley{{0.3, 0.3, 1}, {-0.3, -0.3, 1}, {-0.3, -0.3, 1}, {0.3, 0.3, 1}};
  for (std::size_t edge = 0; edge < 4; ++edge) {
    for (const bool to_ridge : {true, false}) {
      const dvec3 &wanted = to_ridge ? ridge[edge] : valley[edge], &other = to_ridge ? valley[edge] : ridge[edge];
      HoleRim rim;
      rim.corners = {{0, 0, 0.3}, {1, 0, 0}, {1, 1, 0.3}, {0, 1, 0}};
      rim.normals.assign(4, dvec3(0, 0, 1));
      rim.normals[edge] = glm::normalize(wanted + 0.7 / 0.6 * (wanted - other));
      rim.may_join = [](int, int) { return true; };
      const std::vector<ivec3> triangles = fill_by_least_angle(rim).value();
      ASSERT_EQ(triangles.size(), 2U);
      EXPECT_EQ(have_edge_in_common(triangles, 0, 2), to_ridge) << edge;
      EXPECT_EQ(have_edge_in_common(triangles, 1, 3), !to_ridge) << edge;
    }
  }
}

// A tetrahedron without its base, an equilateral triangle of 3 mm: its corners are 3/sqrt(3) mm from its middle, so the
// hole is 6/sqrt(3) mm wide. A hole that is wider than the limit is a warning.
TEST(RepairSteps, WarnOfAHoleThatIsWiderThanTheLimit) {
  const double side = 0.003, width = 2 * side / std::sqrt(3.0), height = side * std::sqrt(0.75);
  const TriMesh open({{0, 0, 0}, {side, 0, 0}, {side / 2, height, 0}, {side / 2, height / 3, 0.001}},
                     {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  for (const double part : {0.99, 1.01}) {
    Draft draft = make_draft(open);
    RepairLimits limits;
    limits.fill = part * width;
    const RepairStep step = fill_holes(draft, limits);
    EXPECT_EQ(step.count, 1);
    EXPECT_EQ(step.faces, 1);
    EXPECT_NEAR(step.length, width, 1e-12);
    EXPECT_NEAR(step.area, 0.5 * side * height, 1e-15);
    EXPECT_EQ(step.severity, part < 1 ? Severity::warning : Severity::note) << part;
    EXPECT_TRUE(TriMesh(draft.points, draft.faces).closed());
  }
}

/// Two triangles on both sides of an edge of 1 m along x, each with points of its own. The second one has its points
/// `from` the first end of the edge and `before` the second end.
Draft torn_edge(double from, double before) {
  return make_draft(TriMesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {1 - before, 0, 0}, {from, 0, 0}, {0.5, -1, 0}},
                            {{0, 1, 2}, {3, 4, 5}}));
}

// Points within 1e-5 of the diagonal from an end of the edge are at the end: there is no T-junction. Without this rule
// the edge would be split into a face without area. A point that is farther from the ends splits the edge.
TEST(RepairSteps, SplitNoEdgeAtPointsAtItsEnds) {
  RepairLimits limits;
  limits.diagonal = 1;
  struct Case {
    double from, before;
    int splits;
  };
  for (const Case& c : {Case{0, 0, 0},
                        {5e-6, 5e-6, 0},
                        {5e-6, 0, 0},
                        {0, 5e-6, 0},
                        {2e-5, 5e-6, 1},
                        {5e-6, 2e-5, 1},
                        {0.25, 0.25, 2}}) {
    Draft draft = torn_edge(c.from, c.before);
    const std::vector<ivec3> before = draft.faces;
    const RepairStep step = split_junctions(draft, limits);
    EXPECT_EQ(step.count, c.splits) << c.from << " " << c.before;
    EXPECT_EQ(draft.face_count(), 2 + c.splits) << c.from << " " << c.before;
    EXPECT_EQ(draft.faces == before, c.splits == 0);
    if (c.splits < 2) continue;
    // The points at 1/4 and 3/4 of the edge divide the face of 1/2 m^2 into 1/4, 1/2 and 1/4 of its area.
    EXPECT_NEAR(draft.area(0), 0.125, 1e-15);
    EXPECT_NEAR(draft.area(2), 0.25, 1e-15);
    EXPECT_NEAR(draft.area(3), 0.125, 1e-15);
  }
}

// Faces outside without a normal make all angles equal, so that the area decides: 1.156 with the diagonal that cuts off
// the high corner, 1.166 with the other one.
TEST(RepairSteps, FillAHoleWithTheLeastAreaIfAnglesAreEqual) {
  HoleRim rim;
  rim.normals.assign(4, dvec3(0));
  rim.may_join = [](int, int) { return true; };
  rim.corners = {{0, 0, 0}, {1, 0, 0.6}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_TRUE(have_edge_in_common(fill_by_least_angle(rim).value(), 0, 2));
  rim.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.6}, {0, 1, 0}};
  EXPECT_TRUE(have_edge_in_common(fill_by_least_angle(rim).value(), 1, 3));
}

// An L of three unit squares. Ears at its reflex corner would cover area outside of it.
TEST(RepairSteps, CutEarsOnlyAtConvexCorners) {
  HoleRim rim;
  rim.corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  rim.normals.assign(6, dvec3(0, 0, 1));
  rim.may_join = [](int, int) { return true; };
  for (std::size_t turn = 0; turn < 6; ++turn) {
    const std::vector<ivec3> triangles = fill_by_ears(rim).value();
    ASSERT_EQ(triangles.size(), 4U);
    double area = 0;
    for (const ivec3& t : triangles) {
      const auto corner = [&](int i) { return rim.corners[at(i)]; };
      const double z = glm::cross(corner(t.y) - corner(t.x), corner(t.z) - corner(t.x)).z;
      EXPECT_GT(z, 0) << "counter-clockwise as the rim";
      area += 0.5 * z;
    }
    EXPECT_NEAR(area, 3, 1e-12);
    std::rotate(rim.corners.begin(), rim.corners.begin() + 1, rim.corners.end());
  }
}

// Of a flat octahedron, two faces at one edge of its equator and two faces at the opposite edge remain: two surfaces,
// each with a hole between the poles and two corners of the equator, which an edge joins already. The first hole is
// filled across the edge between the poles. In the second one this edge would have four faces, which is no manifold, so
// that it gets a fan of four faces around its middle.
TEST(RepairSteps, FillTwoHolesWithoutAnEdgeInCommon) {
  const double h = 0.1;
  // North, south, east, front, west, back.
  const TriMesh open({{0, 0, h}, {0, 0, -h}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                     {{0, 3, 4}, {0, 5, 2}, {1, 4, 3}, {1, 2, 5}});
  Draft draft = make_draft(open);
  RepairLimits limits;
  limits.fill = 10;
  const RepairStep step = fill_holes(draft, limits);
  EXPECT_EQ(step.count, 2);
  EXPECT_EQ(step.faces, 2 + 4);
  const EdgeTopology edges = draft.edges();
  EXPECT_TRUE(edges.edges_of(EdgeKind::nonmanifold).empty());
  EXPECT_TRUE(edges.edges_of(EdgeKind::boundary).empty());
  EXPECT_EQ(edges.edge_between(0, 1).size(), 2U);
}

/// A tetrahedron with fins on its first edge, each a triangle of this height on the edge of 1 m.
Draft finned(const std::vector<double>& heights) {
  std::vector<dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<ivec3> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const double height : heights) {
    faces.emplace_back(0, 1, static_cast<int>(points.size()));
    points.emplace_back(0.5, -height, -0.1 * static_cast<double>(points.size()) * height);
  }
  return make_draft(TriMesh(std::move(points), std::move(faces)));
}

// Fins go as long as they make up at most 2 % of the loaded area, the smallest first. Of two fins on one edge the large
// one stays if only the small one is allowed.
TEST(RepairSteps, RemoveTheSmallestFinsWithinTheirLimit) {
  const double small = finned({0.1}).area(4), large = finned({0.3, 0.1}).area(4);
  RepairLimits limits;
  for (const double part : {0.99, 1.01}) {
    limits.loaded_area = part * small / 0.02;
    Draft draft = finned({0.1});
    EXPECT_EQ(remove_fins(draft, limits).count, part < 1 ? 0 : 1) << part;
    EXPECT_EQ(draft.face_count(), part < 1 ? 5 : 4);
  }
  limits.loaded_area = 0.5 * (small + large) / 0.02;
  Draft draft = finned({0.3, 0.1});
  const RepairStep step = remove_fins(draft, limits);
  EXPECT_EQ(step.count, 1);
  EXPECT_EQ(draft.face_count(), 5);
  EXPECT_NEAR(draft.area(4), large, 1e-15) << "the large fin stays";
}

// The third triangle's first point is as far from point 0 as from point 3, and its second one is on point 1. Only if it
// joins the point with the lowest number, the edge 0 1 gets two faces.
TEST(RepairSteps, JoinAPointToTheFirstOfEquallyNearPoints) {
  constexpr double kJoin = 1e-3, kAway = 0.9e-3;
  Draft draft = make_draft(TriMesh(
      {{-kAway, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {kAway, 0, 0}, {1, -1, 0}, {2, 0, 0}, {0, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      {{0, 1, 2}, {3, 4, 5}, {7, 6, 8}}));
  RepairLimits limits;
  limits.join = kJoin;
  const RepairStep step = join_rims(draft, limits);
  EXPECT_EQ(step.count, 2);
  EXPECT_NEAR(step.length, kAway, 1e-15);
  ASSERT_EQ(draft.face_count(), 3);
  EXPECT_EQ(draft.faces[2], ivec3(1, 0, 8));
  EXPECT_EQ(draft.faces[1], ivec3(3, 4, 5));
}

// Two triangles share the edge 0 1, and a third one has the same edge with points of its own. Joined, the edge would
// have three faces, so nothing is joined.
TEST(RepairSteps, JoinNoRimsIntoAnEdgeOfThreeFaces) {
  Draft draft = make_draft(TriMesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1e-6}, {1, 0, 1e-6}, {0, 0, 1}},
                                   {{0, 1, 2}, {1, 0, 3}, {4, 5, 6}}));
  RepairLimits limits;
  limits.join = 1e-3;
  const std::vector<ivec3> before = draft.faces;
  EXPECT_EQ(join_rims(draft, limits).count, 0);
  EXPECT_EQ(draft.faces, before);
}

// Three triangles touch an edge of 1 m at 0.2, 0.5 and 0.8 m. In any order of their numbers, and for an edge in either
// direction, the face at the edge is split into a fan in the order of their places, whose parts are 0.1, 0.15, 0.15 and
// 0.1 m^2.
TEST(RepairSteps, SplitAnEdgeInTheOrderOfItsPoints) {
  std::vector<double> places{0.2, 0.5, 0.8};
  RepairLimits limits;
  limits.diagonal = 1;
  do {
    for (const ivec3& split : {ivec3(0, 1, 2), ivec3(1, 0, 2)}) {
      std::vector<dvec3> points{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}};
      std::vector<ivec3> faces{split};
      for (const double x : places) {
        const int first = static_cast<int>(points.size());
        points.insert(points.end(), {{x, 0, 0}, {x - 0.05, -0.1, 0}, {x + 0.05, -0.1, 0}});
        faces.emplace_back(first, first + 1, first + 2);
      }
      Draft draft = make_draft(TriMesh(std::move(points), std::move(faces)));
      EXPECT_EQ(split_junctions(draft, limits).count, 3);
      ASSERT_EQ(draft.face_count(), 7);
      const std::vector<double> areas{draft.area(0), draft.area(4), draft.area(5), draft.area(6)};
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(areas[i], i % 3 == 0 ? 0.1 : 0.15, 1e-15) << i;
      for (const int f : {0, 4, 5, 6}) EXPECT_EQ(draft.loaded[at(f)], 0);
    }
  } while (std::next_permutation(places.begin(), places.end()));
}

// A square of two triangles floats inside a box. It is 4 % of the area, more than debris, and goes as a wall that
// encloses nothing, instead of becoming a sheet with a thickness.
TEST(RepairRun, RemovesAWallInsideASolid) {
  const TriMesh box = make_box(dvec3(0.01));
  std::vector<dvec3> points = box.vertices();
  std::vector<ivec3> faces = box.faces();
  const int first = box.vertex_count();
  const double a = 0.005;
  points.insert(points.end(), {{-a, -a, 0}, {a, -a, 0}, {a, a, 0}, {-a, a, 0}});
  faces.insert(faces.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
  const RepairedMeshPtr repaired =
      repair_mesh(std::make_shared<const TriMesh>(std::move(points), std::move(faces)), {}, 0.002);
  EXPECT_EQ(repaired->mesh->face_count(), box.face_count());
  EXPECT_NEAR(repaired->mesh->volume(), 8e-6, 1e-15);
  EXPECT_EQ(repaired->report.level, RepairLevel::exact) << repair_summary(repaired->report);
  EXPECT_NEAR(repaired->report.area_removed, 1e-4, 1e-12);
  EXPECT_EQ(repaired->changes.removed_faces, (std::vector<int>{12, 13}));
}

// Two cubes of 20 mm overlap in a box of 5 x 17 x 19 mm. The surface of this box, 1006 mm^2, goes inside, and most of
// its faces are parts of faces that remain.
TEST(RepairRun, ReportsTheAreaThatAUnionPutsInside) {
  const TriMesh box = make_box(dvec3(0.01));
  const TriMesh both = test::together(box, test::moved(box, {0.015, 0.003, 0.001}));
  const RepairedMeshPtr repaired = repair_mesh(std::make_shared<const TriMesh>(both), {}, 0.002);
  const double inside = 2 * (0.005 * 0.017 + 0.005 * 0.019 + 0.017 * 0.019);
  ASSERT_EQ(repaired->report.steps.size(), 1U);
  EXPECT_NEAR(repaired->report.steps[0].area, inside, 1e-9);
  EXPECT_NEAR(repaired->report.area_removed, inside, 1e-9);
}

TEST(RepairReport, WarnsOfMoreThanAHundredthOfTheArea) {
  RepairReport report;
  report.area_before = 1;
  for (const double area : {0.0099, 0.0101}) {
    RepairStep step = start_step("repair_filled");
    step.count = 1;
    step.area = area;
    finish_step(step, report);
    EXPECT_EQ(step.severity, area < 0.01 ? Severity::note : Severity::warning) << area;
  }
}

TEST(RepairSteps, TakeThreeCrossingsOrAThousandthOfTheFacesForFew) {
  EXPECT_EQ(few_pairs(100), 3);
  EXPECT_EQ(few_pairs(3999), 3);
  EXPECT_EQ(few_pairs(4000), 4);
  EXPECT_EQ(few_pairs(200000), 200);
}

/// Parts of two thin plates that cut through each other: their union has edges that no hole filling closes.
TEST(RepairRun, GivesAnOpenUnionOfARigidBodyTwoSides) {
  const TriMesh plates({{-1.00000002, -1.49999999, -0.491521781},
                        {0.999999993, -1.5, -0.491521765},
                        {0.999999997, 0.500000018, -0.491521782},
                        {-0.999999996, -1.5, -0.50847824},
                        {1.00000001, -1.50000001, -0.508478239},
                        {-0.999999991, -0.999999995, -0.507635526},
                        {0.999999999, 1, -0.507635535},
                        {1.00000001, -0.999999993, -0.507635529},
                        {0.999999996, -0.999999997, -0.492364469},
                        {-1, -0.999999998, -0.492364473}},
                       {{0, 1, 2}, {3, 4, 1}, {3, 1, 0}, {5, 6, 7}, {5, 7, 8}, {5, 8, 9}});
  RepairRecipe recipe;
  recipe.level = RepairLevel::exact;
  const auto loaded = std::make_shared<const TriMesh>(plates);
  EXPECT_THROW(repair_mesh(loaded, recipe, 0.1), Error);
  recipe.has_two_sided_sheets = true;
  const RepairedMeshPtr repaired = repair_mesh(loaded, recipe, 0.1);
  EXPECT_TRUE(repaired->report.has_sheets);
  EXPECT_GT(repaired->mesh->face_count(), plates.face_count());
}

}  // namespace
}  // namespace taxel
