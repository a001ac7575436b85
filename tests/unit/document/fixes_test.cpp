// Repairs of a layout: each fixes its problem, introduces no other problem, and describes its change.
#include "core/document/fixes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/document/edit.h"
#include "core/layout/check/layout_check.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Returns the upper face of a box of 20 x 16 x 10 mm.
const MeshIndex& box() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.008, 0.005))));
  return index;
}
Project good() {
  Project project;
  project.layout.mesh = {"/box.obj", dvec3(1), "cafe"};
  project.layout.taxels = {{3, "a", dvec3(0.004, 0, 0.005), dvec3(0, 0, 1), 0.003, {}},
                           {8, "b", dvec3(-0.004, 0, 0.005), dvec3(0, 0, 1), 0.003, {}},
                           {1, "c", dvec3(0, 0, 0.005), dvec3(0, 0, 1), 0.003, {}}};
  return project;
}

Problems problems_of(const Project& project) {
  Problems problems = check_layout_values(project.layout, "f");
  const Problems on_mesh = check_layout_on_mesh(project.layout, box(), "cafe", "f");
  problems.insert(problems.end(), on_mesh.begin(), on_mesh.end());
  return problems;
}

struct Case {
  const char* code;
  const char* words;
  void (*spoil)(Project&);
};

const Case kCases[] = {
    {"center_off_surface", "Move taxel 3 to the surface, by 2 mm",
     [](Project& p) { p.layout.taxels[0].center.z += 0.002; }},
    {"normal_points_inward", "Give taxel 8 the normal of the surface",
     [](Project& p) { p.layout.taxels[1].normal = dvec3(0, 0, -1); }},
    {"normal_off_surface", "Give taxel 8 the normal of the surface",
     [](Project& p) { p.layout.taxels[1].normal = dvec3(3, 0, 1); }},
    {"zero_normal", "Give taxel 1 the normal of the surface", [](Project& p) { p.layout.taxels[2].normal = dvec3(0); }},
    {"not_finite", "Give taxel 1 the normal of the surface",
     [](Project& p) { p.layout.taxels[2].normal = dvec3(kNaN); }},
    {"field_empty", "Put taxel 3 on the surface, with its normal",
     [](Project& p) { p.layout.taxels[0].center.z += 0.004; }},
    {"radius_not_positive", "Set the radius of taxel 3 to 3 mm, the median of the taxels",
     [](Project& p) { p.layout.taxels[0].radius = 0; }},
    {"radius_not_positive", "Set the radius of taxel 3 to 2 mm, without the sign",
     [](Project& p) { p.layout.taxels[0].radius = -0.002; }},
    {"radius_exceeds_body", "Set the radius of taxel 3 to 2 mm, as if it was in millimetres",
     [](Project& p) { p.layout.taxels[0].radius = 2; }},
    {"duplicate_place", "Delete taxel 8", [](Project& p) { p.layout.taxels[1].center = p.layout.taxels[0].center; }},
    {"subtaxel_larger", "Set the radius of subtaxel 1 of taxel 3 to 3 mm, the taxel's own",
     [](Project& p) {
       const Subtaxel s{p.layout.taxels[0].center, dvec3(0, 0, 1), 0.001};
       p.layout.taxels[0].subtaxels = {s, s};
       p.layout.taxels[0].subtaxels[1].radius = 0.004;
     }},
    {"normal_points_inward", "Give subtaxel 0 of taxel 3 the normal of the surface",
     [](Project& p) {
       p.layout.taxels[0].subtaxels = {{p.layout.taxels[0].center, dvec3(0, 0, -1), 0.001}};
     }},
    {"center_off_surface", "Move subtaxel 0 of taxel 3 to the surface, by 0.5 mm",
     [](Project& p) {
       p.layout.taxels[0].subtaxels = {{p.layout.taxels[0].center + dvec3(0, 0, 0.0005), dvec3(0, 0, 1), 0.001}};
     }},
    {"density_not_positive", "Set the density to 1e+07 per square metre",
     [](Project& p) { p.layout.sampling.density = -1; }},
    {"density_too_high", "Set the density to 7.3e+09 per square metre",
     [](Project& p) { p.layout.sampling.density = 1e12; }},
    {"density_too_low", "Set the density to 1e+07 per square metre", [](Project& p) { p.layout.sampling.density = 1; }},
    {"modulus_negative", "Set the modulus to 5", [](Project& p) { p.layout.material.modulus = -5; }},
    {"friction_negative", "Set the friction to 0.5", [](Project& p) { p.layout.material.friction = kNaN; }},
    {"stiffness_negative", "Set the tangential stiffness to 100000000",
     [](Project& p) { p.layout.material.tangential_stiffness = -1e8; }},
    {"stiffness_of_rigid", "Set the tangential stiffness to 0: friction is regularised",
     [](Project& p) {
       p.layout.material.modulus = 0;
       p.layout.material.tangential_stiffness = 1e8;
     }},
    {"bristles_out_of_range", "Set the number of bristles to 20000",
     [](Project& p) { p.layout.material.bristles = 30000; }},
    {"not_available", "Use the field \"pad\"", [](Project& p) { p.layout.material.field = FieldKind::tets; }},
    {"angle_out_of_range", "Set the largest angle to 45 degrees",
     [](Project& p) { p.layout.receptive_field.max_angle_deg = 0; }},
    {"falloff_out_of_range", "Set the roll-off to 0 degrees",
     [](Project& p) { p.layout.receptive_field.angle_falloff_deg = 46; }},
    {"method_not_available", "Set the method to \"samples\"",
     [](Project& p) {
       p.layout.readout.aggregate = Aggregate::max;
       p.layout.readout.method = ReadingMethod::exact;
     }},
    {"method_needs_surface_rays", "Set the rays to the surface's normals",
     [](Project& p) {
       p.layout.readout.method = ReadingMethod::exact;
       p.layout.readout.ray = RayDirection::taxel_normal;
     }},
    {"depth_negative", "Set the largest depth to 0.004 m", [](Project& p) { p.layout.readout.max_depth = -0.004; }},
    {"ray_unused", "Set the rays to the surface's normals",
     [](Project& p) {
       p.layout.readout.aggregate = Aggregate::force;
       p.layout.readout.ray = RayDirection::taxel_normal;
     }},
    {"frame_parallel", "Turn pad to [0, 0, 1], at right angles to distal",
     [](Project& p) {
       p.layout.frame = {dvec3(2, 0, 0), dvec3(-1, 0, 0)};
     }},
    {"frame_skew", "Turn pad to [0, -1, 0], at right angles to distal",
     [](Project& p) {
       p.layout.frame = {dvec3(0, 0, 2), dvec3(0, -1, 0.5)};
     }},
    {"mesh_changed", "Take the mesh as it is now; the painted region is cleared",
     [](Project& p) {
       p.layout.mesh.sha256 = "beef";
       p.layout.sampling.region = std::vector<int>{1, 2};
     }},
    {"scale_zero", "Set the scale to 1", [](Project& p) { p.layout.mesh.scale.y = 0; }},
    {"repair_out_of_range", "Set it to its default", [](Project& p) { p.layout.mesh.repair.edge = -3e-4; }},
    {"calibration_unused", "Remove the calibration of taxel 99, which is not there",
     [](Project& p) {
       TaxelCalibration here, unused;
       here.id = 3;
       unused.id = 99;
       p.layout.calibration.emplace().taxels = {here, unused};
     }},
};

TEST(Fixes, RepairTheReportedProblemAlone) {
  EXPECT_TRUE(problems_of(good()).empty());
  for (const Case& c : kCases) {
    Project project = good();
    c.spoil(project);
    const Problems before = problems_of(project);
    const auto found =
        std::find_if(before.begin(), before.end(), [&](const Problem& p) { return p.code == std::string(c.code); });
    ASSERT_NE(found, before.end()) << c.code;
    const std::optional<Fix> fix = fix_for(*found, project, &box(), "cafe");
    ASSERT_TRUE(fix) << c.code;
    EXPECT_EQ(fix->words, c.words);
    const Problems after = problems_of(apply_edit(project, fix->edit));
    for (const Problem& p : after) {
      EXPECT_FALSE(p.code == found->code && p.pointer == found->pointer) << c.code << ": " << p.message;
      EXPECT_TRUE(std::any_of(before.begin(), before.end(), [&](const Problem& old) { return old.code == p.code; }))
          << c.code << " brought in " << p.code << " at " << p.pointer;
    }
    EXPECT_LT(after.size(), before.size()) << c.code;
  }
}

TEST(Fixes, RepairAMeshThatTheRecipeKeeps) {
  Project project = good();
  const Problem open{"f", "/mesh/file", Severity::error, "mesh_open", "must be a closed mesh to be soft", ""};
  EXPECT_FALSE(fix_for(open, project, &box())) << "it is repaired already, as far as that goes";
  project.layout.mesh.repair = {RepairLevel::keep, {}, {}, 2e-4, {}, {}};
  const std::optional<Fix> fix = fix_for(open, project, &box());
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->words, "Repair the mesh");
  const Project repaired = apply_edit(project, fix->edit);
  EXPECT_EQ(repaired.layout.mesh.repair.level, RepairLevel::automatic);
  EXPECT_EQ(repaired.layout.mesh.repair.edge, 2e-4) << "the rest of the recipe stays";
}

TEST(Fixes, RepairAWholeLayoutOneAfterAnother) {
  Project project = good();
  for (const Case& c : kCases)
    if (std::string(c.code) != "duplicate_place") c.spoil(project);
  std::size_t rounds = 0;
  for (; rounds < 100; ++rounds) {
    bool mended = false;
    for (const Problem& problem : problems_of(project)) {
      const std::optional<Fix> fix = fix_for(problem, project, &box(), "cafe");
      if (!fix) continue;
      project = apply_edit(project, fix->edit);
      mended = true;
      break;
    }
    if (!mended) break;
  }
  EXPECT_LT(rounds, 100U);
  EXPECT_EQ(problems_of(project).size(), 0U) << problems_of(project).front().message;
}

TEST(Fixes, MoveATaxelFromFarAwayAndLeaveOneBeyondAllSkins) {
  for (const double distance : {1.0, 1e5, 1e7, 1e160, 1e308}) {
    SCOPED_TRACE(distance);
    Project project = good();
    project.layout.taxels[0].center = {0, 0, distance};
    project.layout.taxels[0].normal = dvec3(0);
    for (int round = 0; round < 3; ++round)
      for (const Problem& problem : problems_of(project))
        if (const std::optional<Fix> fix = fix_for(problem, project, &box())) project = apply_edit(project, fix->edit);
    const Taxel& taxel = project.layout.taxels[0];
    EXPECT_NEAR(std::abs(taxel.normal.x) + std::abs(taxel.normal.y) + std::abs(taxel.normal.z), 1, 1e-12);
    const double expected = distance < 1e6 ? 0.005 : distance;  // beyond, no repair is offered and the value stays
    EXPECT_NEAR(taxel.center.z, expected, 1e-12 * expected);
  }
}

TEST(Fixes, LeaveDecisionsToTheUser) {
  Project project = good();
  project.layout.taxels[0].subtaxels = {{dvec3(0, 0, -0.005), dvec3(0, 0, -1), 0.001}};
  Problems problems = problems_of(project);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].code, "subtaxel_outside");
  EXPECT_FALSE(fix_for(problems[0], project, &box()));
  project = good();
  project.layout.taxels[0].center.x = kNaN;
  problems = check_layout_values(project.layout, "f");
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_FALSE(fix_for(problems[0], project, &box()));
  project.layout.taxels[0] = {3, "a", dvec3(0.004, 0, 0.02), dvec3(0, 0, 1), 0.003, {}};
  problems = problems_of(project);
  EXPECT_FALSE(fix_for(problems[0], project, nullptr)) << "no mesh, no surface";
  EXPECT_FALSE(fix_for({"f", "/taxels/77/center", Severity::error, "center_off_surface", "", ""}, project, &box()));
  EXPECT_FALSE(fix_for({"f", "/taxels/x", Severity::error, "center_off_surface", "", ""}, project, &box()));
  EXPECT_FALSE(fix_for({"f", "", Severity::error, "of another version", "", ""}, project, &box()));
}

TEST(Fixes, ReadCentresInMillimetres) {
  Project project = good();
  for (Taxel& taxel : project.layout.taxels) taxel.center *= 1000.0;
  project.layout.taxels[1].radius *= 1000.0;
  project.layout.taxels[1].subtaxels = {{project.layout.taxels[1].center, dvec3(0, 0, 1), 0.001}};
  const Problems problems = check_layout_on_mesh(project.layout, box(), "cafe", "f");
  ASSERT_EQ(problems.size(), 1U);
  const auto fix = fix_for(problems[0], project, &box());
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->words, "Read the centres in mm");
  project = apply_edit(project, fix->edit);
  EXPECT_TRUE(problems_of(project).empty()) << problems_of(project).front().message;
  EXPECT_DOUBLE_EQ(project.layout.taxels[0].center.x, 0.004);
  EXPECT_DOUBLE_EQ(project.layout.taxels[1].radius, 0.003) << "a radius of 3 m is in mm too";
}

TEST(Fixes, ReadAMeshInMillimetres) {
  const MeshIndex large(std::make_shared<TriMesh>(make_box(dvec3(10, 8, 5))));
  const Problems problems = check_layout_mesh(*as_loaded(large.mesh_ptr()), "f");
  ASSERT_EQ(problems.size(), 1U);
  const std::optional<Fix> fix = fix_for(problems[0], good(), &large);
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->words, "Read the mesh in mm");
  EXPECT_EQ(apply_edit(good(), fix->edit).layout.mesh.scale, dvec3(0.001));
}

TEST(Fixes, EnlargeAFieldWithoutSamples) {
  Project project = good();
  project.layout.taxels[0].radius = 1e-6;
  const Problem problem{"f", "/taxels/0", Severity::warning, "field_without_samples", "", ""};
  const std::optional<Fix> fix = fix_for(problem, project, &box());
  ASSERT_TRUE(fix);
  EXPECT_EQ(fix->words, "Set the radius of taxel 3 to 0.9487 mm, three times the distance of the samples");
  project = apply_edit(project, fix->edit);
  EXPECT_FALSE(fix_for(problem, project, &box())) << "it is as large already";
}

TEST(Fixes, ProjectTaxelsWithTheirSubtaxels) {
  const dvec3 off(0.001, 0.002, 0.0065);
  Taxel taxel{3, "a", off, dvec3(1, 0, 0), 0.003, {{dvec3(0.012, 0, 0), dvec3(1), 0.001}}};
  const TaxelChange change = projected(taxel, box());
  EXPECT_EQ(*change.center, dvec3(0.001, 0.002, 0.005));
  EXPECT_LT(glm::distance((*change.subtaxels)[0].center, dvec3(0.010, 0, 0)), 1e-17);
  EXPECT_GT(change.normal->z, 0.6);
  taxel.center.x = kNaN;
  EXPECT_FALSE(projected(taxel, box()).center);
}

TEST(Fixes, DoNotMoveTheTwin) {
  Project project = good();
  project.layout.taxels[1].center = dvec3(-0.0041, 0.001, 0.005);
  project.mirrors = {{{}, {{3, 8}}}};
  project.layout.taxels[0].center.z += 0.002;
  project.layout.taxels[1].radius = -1;
  const Problems problems = problems_of(project);
  for (const Problem& problem : problems) project = apply_edit(project, fix_for(problem, project, &box())->edit);
  EXPECT_EQ(project.layout.taxels[1].center, dvec3(-0.0041, 0.001, 0.005));
  EXPECT_EQ(project.layout.taxels[0].radius, project.layout.taxels[1].radius) << "radii stay the same";
}

}  // namespace
}  // namespace taxel
