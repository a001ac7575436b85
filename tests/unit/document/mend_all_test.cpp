// All repairs at once: one edit makes all automatic repairs, and the remaining problems are reported.
#include <gtest/gtest.h>

#include "core/document/edit.h"
#include "core/document/fixes.h"
#include "core/document/history.h"
#include "core/layout/check/layout_check.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/repair/repaired_mesh.h"

namespace taxel {
namespace {

const MeshIndex& box() {
  static const MeshIndex index(std::make_shared<TriMesh>(make_box(dvec3(0.010, 0.008, 0.005))));
  return index;
}

/// Returns taxels in rows on the upper face of a box of 20 x 16 x 10 mm. The discs of neighbours overlap by less than
/// 80 %.
Project with_taxels(int count) {
  const double step = count <= 4 ? 0.004 : 0.0006, radius = count <= 4 ? 0.003 : 0.0008;
  Project project;
  project.layout.mesh = {"/box.obj", dvec3(1), ""};
  for (int i = 0; i < count; ++i)
    project.layout.taxels.push_back(
        {i, "", dvec3(-0.009 + step * (i % 30), -0.007 + 0.0003 * (i / 30), 0.005), dvec3(0, 0, 1), radius, {}});
  return project;
}

/// Returns place and code of the remaining problems.
std::vector<std::string> left(const Mending& mending) {
  std::vector<std::string> all;
  for (const Problem& problem : mending.left) all.push_back(problem.pointer + " " + problem.code);
  return all;
}
const std::vector<std::string> kNone;

Mending mend(const Project& project) {
  const RepairedMeshPtr repaired = as_loaded(box().mesh_ptr());
  return mend_all(project, {box().mesh(), *repaired, box()});
}

TEST(MendAll, ChangesNothingIfNothingIsWrong) {
  const Mending mending = mend(with_taxels(3));
  EXPECT_FALSE(mending.edit);
  EXPECT_EQ(mending.mended, 0);
  EXPECT_EQ(left(mending), kNone);
}

TEST(MendAll, RepairsAllProblemsOfATaxel) {
  Project project = with_taxels(3);
  Taxel& taxel = project.layout.taxels[1];
  taxel.center.z += 0.002;
  taxel.normal = dvec3(0, 0, -1);
  taxel.subtaxels = {{taxel.center, dvec3(0, 0, -1), 0.001}, {taxel.center, dvec3(0, 0, -1), 0.004}};
  project.layout.taxels[2].radius = -0.002;
  project.layout.material.friction = -0.5;
  const Mending mending = mend(project);
  ASSERT_TRUE(mending.edit);
  const Project mended = apply_edit(project, *mending.edit);
  EXPECT_EQ(left(mend(mended)), kNone);
  EXPECT_FALSE(mend(mended).edit);
  EXPECT_EQ(left(mending), kNone);
  EXPECT_EQ(mended.layout.taxels[2].radius, 0.002);
  EXPECT_EQ(mended.layout.material.friction, 0.5);
  EXPECT_EQ(mended.layout.taxels[0], project.layout.taxels[0]) << "correct taxels are unchanged";
}

TEST(MendAll, IsOneStepOfTheHistory) {
  Project project = with_taxels(4);
  for (Taxel& taxel : project.layout.taxels) taxel.normal = dvec3(0, 0, -1);
  History history(project);
  history.apply(*mend(project).edit);
  EXPECT_EQ(history.undo_depth(), 1U);
  EXPECT_EQ(history.undo_name(), "Undo Fix all problems");
  history.undo();
  EXPECT_EQ(*history.project(), project);
}

TEST(MendAll, LeavesProblemsThatNeedADecision) {
  Project project = with_taxels(2);
  Taxel& taxel = project.layout.taxels[0];
  taxel.subtaxels = {{taxel.center + dvec3(0.005, 0, 0), dvec3(0, 0, 1), 0.001}};
  project.layout.taxels[1].normal = dvec3(0, 0, -1);
  const Mending mending = mend(project);
  ASSERT_TRUE(mending.edit);
  EXPECT_EQ(mending.mended, 2) << "the normal points inward, and so the field is empty";
  EXPECT_EQ(left(mending), std::vector<std::string>{"/taxels/0/subtaxels/0/center subtaxel_outside"});
}

TEST(MendAll, RepairsAMeshThatTheRecipeKeeps) {
  const TriMesh whole = make_box(dvec3(0.010, 0.008, 0.005));
  const auto open = std::make_shared<const TriMesh>(whole.vertices(),
                                                    std::vector<ivec3>(whole.faces().begin(), whole.faces().end() - 1));
  Project project = with_taxels(2);
  project.layout.mesh.repair.level = RepairLevel::keep;
  project.layout.taxels[1].radius = -0.003;
  const RepairedMeshPtr kept = as_loaded(open);
  const MeshIndex skin(open);
  const Mending mending = mend_all(project, {*open, *kept, skin});
  ASSERT_TRUE(mending.edit);
  EXPECT_EQ(mending.mended, 2);
  EXPECT_EQ(left(mending), kNone);
  const Project mended = apply_edit(project, *mending.edit);
  EXPECT_EQ(mended.layout.mesh.repair, RepairRecipe{});
  EXPECT_EQ(mended.layout.taxels[1].radius, 0.003);
}

TEST(MendAll, NeedsFewEditsForThousandsOfTaxels) {
  Project project = with_taxels(1500);
  for (Taxel& taxel : project.layout.taxels) {
    taxel.normal = dvec3(0, 0, -1);
    taxel.center.z += 0.001;
  }
  const Mending mending = mend(project);
  ASSERT_TRUE(mending.edit);
  EXPECT_LE(std::get<ApplyAll>(*mending.edit).edits->edits.size(), 8U);
  EXPECT_EQ(left(mending), kNone);
  EXPECT_EQ(mending.mended, 3 * 1500) << "off the surface, inward, an empty field";
}

TEST(ApplyAll, IsAllOrNothing) {
  const Project project = with_taxels(2);
  const ApplyAll edit{"Both", std::make_shared<const EditList>(EditList{{DeleteTaxels{{0}}, DeleteTaxels{{7}}}})};
  History history(project);
  EXPECT_THROW(history.apply(edit), Error);
  EXPECT_EQ(*history.project(), project);
}

}  // namespace
}  // namespace taxel
