// Each edit changes exactly the named taxels. An edit with an unusable result is refused with the taxel's id.
#include <gtest/gtest.h>

#include <limits>

#include "core/document/edit.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

using test::complaint_of;

Taxel taxel_at(int id, const dvec3& center) {
  return {id, "left " + std::to_string(id), center, dvec3(0, 0, 1), 0.006, {}};
}

/// Returns a project with taxels 4, 7 and 2, in this order.
Project three() {
  Project project;
  project.layout.mesh.file = "/m.obj";
  project.layout.taxels = {taxel_at(4, {0.01, 0, 0}), taxel_at(7, {0.02, 0, 0}), taxel_at(2, {0.03, 0, 0})};
  return project;
}

std::vector<int> ids_of(const Project& project) {
  std::vector<int> ids;
  for (const Taxel& taxel : project.layout.taxels) ids.push_back(taxel.id);
  return ids;
}

const Taxel& taxel_of(const Project& project, int id) {
  return project.layout.taxels[taxel_index(project.layout, id)];
}

std::string complaint(const Edit& edit, const Project& project = three()) {
  return complaint_of([&] { apply_edit(project, edit); });
}

TaxelChange change_of(int id) {
  TaxelChange change;
  change.id = id;
  return change;
}

TaxelChange move_of(int id, const dvec3& center) {
  TaxelChange change = change_of(id);
  change.center = center;
  return change;
}

TEST(Edit, AddsAtTheEndOrBefore) {
  EXPECT_EQ(ids_of(apply_edit(three(), AddTaxels{{taxel_at(8, {}), taxel_at(5, {})}, {}})),
            (std::vector{4, 7, 2, 8, 5}));
  EXPECT_EQ(ids_of(apply_edit(three(), AddTaxels{{taxel_at(8, {}), taxel_at(5, {})}, 7})),
            (std::vector{4, 8, 5, 7, 2}));
  EXPECT_EQ(complaint(AddTaxels{{taxel_at(7, {})}, {}}), "taxel 7: is already in the layout");
  EXPECT_EQ(complaint(AddTaxels{{taxel_at(9, {})}, 3}), "taxel 3: is not in the layout");
  EXPECT_EQ(complaint(AddTaxels{{taxel_at(9, {}), taxel_at(9, {})}, {}}), "taxel 9: id: 9 is also the id of /taxels/0");
}

TEST(Edit, DeletesReferencesToADeletedTaxel) {
  Project project = three();
  project.hidden = {2, 7};
  project.mirrors = {{{}, {{4, 7}}}, {{dvec3(0), {0, 1, 0}}, {{7, 2}}}};
  project.layout.calibration.emplace().taxels = {{.id = 7, .tare = 1, .gain = {}, .curve = {}, .dead = {}},
                                                 {.id = 2, .tare = 2, .gain = {}, .curve = {}, .dead = {}}};
  project = apply_edit(project, DeleteTaxels{{4}});
  EXPECT_EQ(ids_of(project), (std::vector{7, 2}));
  ASSERT_EQ(project.mirrors.size(), 1U);
  EXPECT_EQ(project.mirrors[0].links, (std::vector<MirrorLink>{{7, 2}}));
  project = apply_edit(project, DeleteTaxels{{7}});
  EXPECT_EQ(project.hidden, std::vector{2});
  EXPECT_TRUE(project.mirrors.empty());
  ASSERT_EQ(project.layout.calibration->taxels.size(), 1U);
  EXPECT_EQ(project.layout.calibration->taxels[0].id, 2);
  EXPECT_EQ(complaint(DeleteTaxels{{4, 9}}), "taxel 9: is not in the layout");
}

TEST(Edit, MovesTheCrosstalkMatrixWithTheTaxels) {
  Project project = three();  // taxels 4, 7 and 2
  project.layout.calibration.emplace().crosstalk_matrix = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const auto matrix_after = [&](const Edit& edit) {
    return apply_edit(project, edit).layout.calibration->crosstalk_matrix;
  };
  EXPECT_EQ(matrix_after(DeleteTaxels{{7}}), (CrosstalkMatrix{{1, 3}, {7, 9}}));
  EXPECT_EQ(matrix_after(ReorderTaxels{{2, 4, 7}}), (CrosstalkMatrix{{9, 7, 8}, {3, 1, 2}, {6, 4, 5}}));
  EXPECT_EQ(matrix_after(AddTaxels{{taxel_at(8, {})}, 7}),
            (CrosstalkMatrix{{1, 0, 2, 3}, {0, 1, 0, 0}, {4, 0, 5, 6}, {7, 0, 8, 9}}));
  Calibration changed = *project.layout.calibration;
  changed.noise = 1;  // another setting is edited while there is a matrix
  EXPECT_EQ(apply_edit(project, SetCalibration{changed}).layout.calibration, changed);
}

TEST(Edit, KeepsUnknownKeysWithTheirTaxel) {
  Project project = three();
  project.layout.calibration.emplace().taxels = {{.id = 4, .tare = 1, .gain = {}, .curve = {}, .dead = {}},
                                                 {.id = 2, .tare = 2, .gain = {}, .curve = {}, .dead = {}}};
  project.layout.unknown = {{"/calibration/taxels/1/by", "2"},
                            {"/note", "0"},
                            {"/taxels/0/note", "4"},
                            {"/taxels/1/note", "7"},
                            {"/taxels/2/a~1b", "2"}};
  using Keys = std::map<std::string, std::string>;
  EXPECT_EQ(
      apply_edit(project, DeleteTaxels{{4}}).layout.unknown,
      (Keys{{"/calibration/taxels/0/by", "2"}, {"/note", "0"}, {"/taxels/0/note", "7"}, {"/taxels/1/a~1b", "2"}}));
  EXPECT_EQ(apply_edit(project, ReorderTaxels{{2, 4, 7}}).layout.unknown, (Keys{{"/calibration/taxels/1/by", "2"},
                                                                                {"/note", "0"},
                                                                                {"/taxels/0/a~1b", "2"},
                                                                                {"/taxels/1/note", "4"},
                                                                                {"/taxels/2/note", "7"}}));
  EXPECT_EQ(apply_edit(project, AddTaxels{{taxel_at(9, {})}, 7}).layout.unknown,
            (Keys{{"/calibration/taxels/1/by", "2"},
                  {"/note", "0"},
                  {"/taxels/0/note", "4"},
                  {"/taxels/2/note", "7"},
                  {"/taxels/3/a~1b", "2"}}));
}

TEST(Edit, SetsFieldsOfManyAtOnce) {
  TaxelChange all = move_of(7, {1, 2, 3});
  all.normal = dvec3(0, 2, 0);
  all.radius = 0.5;
  all.name = "tip";
  all.subtaxels = {{dvec3(1, 2, 3), dvec3(0, 1, 0), 0.1}};
  TaxelChange radius = change_of(2);
  radius.radius = 0.25;
  const Project project = apply_edit(three(), SetTaxels{{all, radius}});
  EXPECT_EQ(taxel_of(project, 7), (Taxel{7, "tip", {1, 2, 3}, {0, 2, 0}, 0.5, {{{1, 2, 3}, {0, 1, 0}, 0.1}}}));
  Taxel resized = taxel_at(2, {0.03, 0, 0});
  resized.radius = 0.25;
  EXPECT_EQ(taxel_of(project, 2), resized);
  EXPECT_EQ(taxel_of(project, 4), taxel_of(three(), 4));
}

TEST(Edit, RefusesUnusableResults) {
  TaxelChange change = change_of(7);
  change.radius = -1;
  EXPECT_EQ(complaint(SetTaxels{{change}}), "taxel 7: radius: must be greater than 0, is -1");
  EXPECT_EQ(complaint(SetTaxels{{move_of(2, {0, std::numeric_limits<double>::quiet_NaN(), 0})}}),
            "taxel 2: center: must be finite, is [0, nan, 0]");
  change = change_of(4);
  change.normal = dvec3(0);
  EXPECT_EQ(complaint(SetTaxels{{change}}), "taxel 4: normal: must be a direction, is [0, 0, 0]");
  change = change_of(4);
  change.subtaxels = {{dvec3(0), dvec3(0, 0, 1), 0.001}, {dvec3(0), dvec3(0, 0, 1), 0}};
  EXPECT_EQ(complaint(SetTaxels{{change}}), "taxel 4: subtaxels/1/radius: must be greater than 0, is 0");
  EXPECT_EQ(complaint(SetTaxels{{move_of(3, {})}}), "taxel 3: is not in the layout");
  EXPECT_EQ(complaint(SetTaxels{{move_of(2, {}), move_of(2, {})}}), "taxel 2: is listed twice");
  EXPECT_EQ(complaint(SetMaterial{{FieldKind::pad, -5, 0, 0, 0}}), "/material/modulus: must be 0 or more, is -5");
  EXPECT_EQ(complaint(SetSampling{{0}}), "/sampling/density: must be greater than 0, is 0");
  EXPECT_EQ(complaint(SetFrame{{dvec3(0, 0, 1), dvec3(0, 0, 2)}}), "/frame/pad: must not be parallel to distal");
  EXPECT_EQ(complaint(ReplaceMesh{{"", dvec3(1), ""}, {}}), "/mesh/file: must name a mesh file, is \"\"");
  Scenario scenario;
  scenario.as<scenarios::Sweep>().depth = std::numeric_limits<double>::infinity();
  EXPECT_EQ(complaint(SetScenario{scenario}), "/scenario/depth: must be finite, is inf");
  EXPECT_EQ(complaint(SetRegion{{3, -1}}), "region: faces are numbered from 0, is -1");
  EXPECT_EQ(complaint(SetHidden{{3}}), "taxel 3: is not in the layout");
}

TEST(Edit, RepairsOnePlaceOfABrokenLayout) {
  Project project = three();
  project.layout.taxels[0].radius = -1;
  project.layout.taxels[0].normal = dvec3(0);
  project.layout.taxels[1].normal = dvec3(0);
  project.layout.material.modulus = -1;
  TaxelChange change = change_of(4);
  change.radius = 0.01;
  project = apply_edit(project, SetTaxels{{change}});
  project.layout.material.friction = -1;
  Material material = project.layout.material;
  material.modulus = 1;
  project = apply_edit(project, SetMaterial{material});
  material.friction = -2;
  EXPECT_EQ(complaint(SetMaterial{material}, project), "/material/friction: must be 0 or more, is -2");
  change = move_of(7, {0, 0, 1});
  change.normal = dvec3(0, 1, 0);
  project.layout.taxels[1].subtaxels = {{dvec3(0), dvec3(0, 0, 1), 0.001}};
  project = apply_edit(project, SetTaxels{{change}});
  EXPECT_EQ(taxel_of(project, 7).normal, dvec3(0, 1, 0));
  EXPECT_EQ(taxel_of(project, 7).subtaxels[0].center, dvec3(-0.02, 0, 1)) << "no turn from a normal that is none";
}

TEST(Edit, MovesSubtaxelsWithTheirTaxel) {
  Project project = three();
  Taxel& taxel = project.layout.taxels[0];
  taxel.subtaxels = {{taxel.center + dvec3(0, 0.001, 0), dvec3(0, 0, 1), 0.001}};
  const dvec3 to(0.5, 0.25, 0.125);
  EXPECT_EQ(taxel_of(apply_edit(project, SetTaxels{{move_of(4, to)}}), 4).subtaxels[0].center, to + dvec3(0, 0.001, 0));

  // From z to -y about x: +y of the taxel becomes +z.
  TaxelChange change = move_of(4, to);
  change.normal = dvec3(0, -1, 1);
  const Taxel turned = taxel_of(apply_edit(project, SetTaxels{{change}}), 4);
  const double half = 0.001 * std::sqrt(0.5);
  EXPECT_LT(glm::distance(turned.subtaxels[0].center, to + dvec3(0, half, half)), 1e-16);
  EXPECT_LT(glm::distance(turned.subtaxels[0].normal, glm::normalize(dvec3(0, -1, 1))), 1e-15);

  // A reversed normal is a repair of the taxel, not a motion of its subtaxels.
  change.normal = dvec3(0, 0, -1);
  EXPECT_EQ(taxel_of(apply_edit(project, SetTaxels{{change}}), 4).subtaxels[0].center, to + dvec3(0, 0.001, 0));
}

TEST(Edit, RenumbersAllReferencesToATaxel) {
  Project project = three();
  project.hidden = {2, 4};
  project.mirrors = {{{}, {{4, 2}}}};
  project.layout.calibration.emplace().taxels = {{.id = 4, .tare = 1, .gain = {}, .curve = {}, .dead = {}}};
  project = apply_edit(project, RenumberTaxels{{{4, 2}, {2, 30}}});
  EXPECT_EQ(ids_of(project), (std::vector{2, 7, 30}));
  EXPECT_EQ(project.hidden, (std::vector{2, 30}));
  EXPECT_EQ(project.mirrors[0].links[0], (MirrorLink{2, 30}));
  EXPECT_EQ(project.layout.calibration->taxels[0].id, 2);
  EXPECT_EQ(complaint(RenumberTaxels{{{4, 7}}}), "taxel 7: would be there twice");
  EXPECT_EQ(complaint(RenumberTaxels{{{4, -7}}}), "taxel 4: cannot get the id -7: it must be 0 or more");
}

TEST(Edit, ReordersAllTaxels) {
  const Project project = apply_edit(three(), ReorderTaxels{{7, 2, 4}});
  EXPECT_EQ(ids_of(project), (std::vector{7, 2, 4}));
  EXPECT_EQ(project.layout.taxels[1], three().layout.taxels[2]);
  EXPECT_EQ(complaint(ReorderTaxels{{7, 2}}), "taxel 4: is missing in the new order");
  EXPECT_EQ(complaint(ReorderTaxels{{7, 2, 7}}), "taxel 7: is listed twice");
  EXPECT_EQ(complaint(ReorderTaxels{{7, 2, 5}}), "taxel 5: is not in the layout");
}

TEST(Edit, ClearsTheRegionWhenTheMeshIsReplaced) {
  Project project = apply_edit(three(), SetRegion{{5, 3, 5}});
  EXPECT_EQ(*project.layout.sampling.region, (std::vector{3, 5}));
  EXPECT_EQ(*apply_edit(project, ReplaceMesh{{"/n.obj", dvec3(1), "x"}, {1}}).layout.sampling.region, std::vector{1});
  Layout other = three().layout;
  other.taxels.pop_back();
  project.hidden = {2, 7};
  EXPECT_TRUE(apply_edit(project, ReplaceLayout{other}).layout.sampling.region->empty()) << "it brings its own";
  EXPECT_EQ(apply_edit(project, ReplaceLayout{other}).hidden, std::vector{7});
  other.taxels[1].id = 4;
  EXPECT_EQ(complaint(ReplaceLayout{other}), "/layout/taxels/1/id: 4 is also the id of another taxel");
}

TEST(Edit, SetsTheRepairOfTheMesh) {
  const Project before = three();
  const Edit edit = SetRepair{{RepairLevel::exact, 1e-5, {}, {}, {}, {}}};
  const Project after = apply_edit(before, edit);
  EXPECT_EQ(after.layout.mesh.repair.level, RepairLevel::exact);
  EXPECT_EQ(after.layout.mesh.repair.join, 1e-5);
  EXPECT_EQ(after.layout.mesh.file, before.layout.mesh.file);
  EXPECT_EQ(edit_name(edit), "Change the repair of the mesh");
  RepairRecipe wrong;
  wrong.edge = -3e-4;
  EXPECT_THROW(apply_edit(before, SetRepair{wrong}), Error);
}

TEST(Edit, ReplacesTheProjectButKeepsTheView) {
  Project project = three(), other = three();
  project.view = View{};
  other.layout.taxels.pop_back();
  other.view = View{dvec3(1), 0, 0, 1, 40};
  const Project edited = apply_edit(project, ReplaceProject{other});
  EXPECT_EQ(edited.layout, other.layout);
  EXPECT_EQ(edited.view, project.view);
  other.hidden = {99};
  EXPECT_EQ(complaint(ReplaceProject{other}), "/hidden/0: there is no taxel 99");
}

TEST(Edit, HasANameForTheHistory) {
  TaxelChange moved = move_of(3, {}), turned = change_of(3), resized = change_of(5), renamed = change_of(3);
  turned.normal = dvec3(1);
  resized.radius = 1;
  renamed.name = "x";
  EXPECT_EQ(edit_name(SetTaxels{{moved}}), "Move taxel 3");
  EXPECT_EQ(edit_name(SetTaxels{{turned}}), "Turn taxel 3");
  EXPECT_EQ(edit_name(SetTaxels{{renamed}}), "Rename taxel 3");
  EXPECT_EQ(edit_name(SetTaxels{{resized, renamed}}), "Change 2 taxels");
  EXPECT_EQ(edit_name(DeleteTaxels{{1, 2, 3}}), "Delete 3 taxels");
  EXPECT_EQ(edit_name(AddTaxels{{taxel_at(12, {})}, {}}), "Add taxel 12");
  EXPECT_EQ(edit_name(SetMaterial{}), "Change the material");
}

TEST(Edit, MakesTheIdsOfForeignLayoutsUnique) {
  Layout layout = three().layout;
  layout.taxels[1].id = 4;
  layout.taxels[2].id = -2;
  const std::vector<std::string> notes = make_ids_unique(layout);
  EXPECT_EQ(notes, (std::vector<std::string>{"/taxels/1: the id 4 is that of another taxel, this taxel is 5 now",
                                             "/taxels/2: the id -2 is negative, this taxel is 6 now"}));
  EXPECT_EQ(layout.taxels[1].id, 5);
  EXPECT_TRUE(make_ids_unique(layout).empty());
  layout.taxels[0].id = std::numeric_limits<int>::max();
  EXPECT_EQ(complaint_of([&] { unused_ids(layout, 1); }), "taxels: no id is left after the largest");
}

TEST(Edit, KeepsFreeIdsOfPastedTaxels) {
  const std::vector<Taxel> pasted = {taxel_at(7, {}), taxel_at(20, {}), taxel_at(20, {}), taxel_at(-1, {}),
                                     taxel_at(0, {})};
  std::vector<int> ids;
  for (const Taxel& taxel : with_unused_ids(pasted, three().layout)) ids.push_back(taxel.id);
  EXPECT_EQ(ids, (std::vector{21, 20, 22, 23, 0}));
  EXPECT_EQ(ids_of(apply_edit(three(), AddTaxels{with_unused_ids(pasted, three().layout), {}})).size(), 8U);
}

}  // namespace
}  // namespace taxel
