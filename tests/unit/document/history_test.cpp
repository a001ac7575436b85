// Steps, gestures, the saved state, and the limits of the history. Tests in tests/property show that undo and redo give
// the same bytes for any edits.
#include "core/document/history.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/document/project.h"

namespace taxel {
namespace {

Project one_taxel() {
  Project project;
  project.layout.mesh.file = "/m.obj";
  project.layout.taxels = {{3, "", dvec3(0.1 + 0.2, 0, 0), dvec3(0, 0, 1), 0.006, {}}};
  return project;
}

SetTaxels move(const dvec3& center) {
  TaxelChange change;
  change.id = 3;
  change.center = center;
  return {{change}};
}

TEST(History, NamesItsSteps) {
  History history(one_taxel());
  EXPECT_EQ(history.undo_name(), "Undo");
  history.apply(move({1, 0, 0}));
  history.apply(DeleteTaxels{{3}});
  EXPECT_EQ(history.undo_name(), "Undo Delete taxel 3");
  history.undo();
  EXPECT_EQ(history.undo_name(), "Undo Move taxel 3");
  EXPECT_EQ(history.redo_name(), "Redo Delete taxel 3");
  history.undo();
  history.undo();
  EXPECT_EQ(history.undo_depth(), 0U);
  EXPECT_EQ(history.redo_depth(), 2U);
}

TEST(History, DiscardsUndoneStepsByAnEdit) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}));
  history.undo();
  history.apply(move({2, 0, 0}));
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo_depth(), 1U);
}

TEST(History, AddsNoStepIfNothingChanges) {
  History history(one_taxel());
  EXPECT_FALSE(history.apply(move(one_taxel().layout.taxels[0].center)));
  EXPECT_FALSE(history.can_undo());
  EXPECT_FALSE(history.dirty());
}

TEST(History, IsUnchangedByARefusedEdit) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}));
  history.undo();
  const ProjectPtr before = history.project();
  EXPECT_THROW(history.apply(DeleteTaxels{{4}}), Error);
  EXPECT_EQ(history.project(), before);
  EXPECT_TRUE(history.can_redo());
}

TEST(History, MergesAGestureIntoOneStep) {
  History history(one_taxel());
  const std::string start = project_to_json(*history.project());
  for (int frame = 1; frame <= 10; ++frame) history.apply(move({frame, 0, 0}), {.number = 1});
  EXPECT_EQ(history.undo_depth(), 1U);
  EXPECT_EQ(history.project()->layout.taxels[0].center, dvec3(10, 0, 0));
  for (int frame = 1; frame <= 10; ++frame) history.apply(move({0, frame, 0}), {.number = 2});
  EXPECT_EQ(history.undo_depth(), 2U);
  history.undo();
  EXPECT_EQ(history.project()->layout.taxels[0].center, dvec3(10, 0, 0));
  history.undo();
  EXPECT_EQ(project_to_json(*history.project()), start);
}

TEST(History, EndsAGestureByUndoAndOnRequest) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}), {.number = 1});
  history.end_gesture();
  history.apply(move({2, 0, 0}), {.number = 1});
  EXPECT_EQ(history.undo_depth(), 2U);
  history.undo();
  history.redo();
  history.apply(move({3, 0, 0}), {.number = 1});
  EXPECT_EQ(history.undo_depth(), 3U);
}

TEST(History, RestoresTheProjectAndUndoneStepsByCancel) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}));
  history.apply(move({2, 0, 0}));
  history.undo();
  const ProjectPtr before = history.project();
  const std::uint64_t revision = history.revision();
  history.apply(move({5, 0, 0}), {.number = 4});
  history.apply(move({6, 0, 0}), {.number = 4});
  EXPECT_FALSE(history.can_redo());
  history.cancel(3);
  EXPECT_EQ(history.project()->layout.taxels[0].center, dvec3(6, 0, 0)) << "another gesture";
  history.cancel(4);
  EXPECT_EQ(history.project(), before);
  EXPECT_EQ(history.revision(), revision);
  history.redo();
  EXPECT_EQ(history.project()->layout.taxels[0].center, dvec3(2, 0, 0));
}

TEST(History, AddsNoStepForADragThatEndsWhereItBegan) {
  History history(one_taxel());
  const ProjectPtr before = history.project();
  history.apply(move({1, 0, 0}), {.number = 1});
  EXPECT_TRUE(history.apply(move(before->layout.taxels[0].center), {.number = 1}));
  EXPECT_EQ(history.project(), before);
  EXPECT_FALSE(history.dirty());
  history.apply(move({2, 0, 0}), {.number = 1});
  EXPECT_EQ(history.undo_depth(), 1U);
}

TEST(History, IgnoresTheWayOfAGestureFromTheStart) {
  Project project = one_taxel();
  project.layout.taxels[0].subtaxels = {{dvec3(0.1, 0.7, 0), dvec3(0, 0, 1), 0.001}};
  const auto drag = [&](const std::vector<dvec3>& normals, bool from_start) {
    History history(project);
    for (const dvec3& normal : normals) {
      SetTaxels edit = move({0.3, 0.1, 0.7});
      edit.changes[0].normal = normal;
      history.apply(edit, {.number = 1, .from_start = from_start});
    }
    EXPECT_EQ(history.undo_depth(), 1U);
    return *history.project();
  };
  const std::vector<dvec3> around = {{1, 0, 1}, {0, 1, 1}, {0.3, 0.2, 1}};
  EXPECT_EQ(drag(around, true), drag({around.back()}, true));
  EXPECT_FALSE(drag(around, false) == drag({around.back()}, false)) << "subtaxels were carried around a curve";
}

TEST(History, ListsItsStepsByName) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}));
  history.apply(DeleteTaxels{{3}});
  history.undo();
  const std::vector<HistoryStep> steps = history.steps();
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].name, "");
  EXPECT_EQ(steps[1].name, "Move taxel 3");
  EXPECT_EQ(steps[2].name, "Delete taxel 3");
  EXPECT_EQ(history.undo_depth(), 1U);
  EXPECT_EQ(steps[1].revision, history.revision());
  history.apply(move({2, 0, 0}), {.number = 1});
  history.apply(move({3, 0, 0}), {.number = 1});
  EXPECT_EQ(history.steps().size(), 3U) << "a gesture is one step, and the undone one is gone";
  EXPECT_EQ(history.steps()[2].name, "Move taxel 3");
}

TEST(History, GoesToAnyStepAndBack) {
  History history(one_taxel());
  std::vector<ProjectPtr> projects{history.project()};
  for (int i = 1; i <= 5; ++i) {
    history.apply(move({i, 0, 0}));
    projects.push_back(history.project());
  }
  const std::vector<HistoryStep> steps = history.steps();
  for (const std::size_t to : {0U, 4U, 2U, 5U, 1U, 1U}) {
    history.go_to(steps[to].revision);
    EXPECT_EQ(history.project(), projects[to]);
    EXPECT_EQ(history.undo_depth(), to);
    EXPECT_EQ(history.redo_depth(), 5 - to);
    EXPECT_EQ(history.steps(), steps) << "nothing is lost";
  }
  history.go_to(4711);
  EXPECT_EQ(history.undo_depth(), 1U) << "no such step";
  history.apply(move({9, 0, 0}));
  history.go_to(steps[5].revision);
  EXPECT_EQ(history.undo_depth(), 2U) << "that step was dropped by the edit";
}

TEST(History, EndsAGestureByGoingToAStep) {
  History history(one_taxel());
  history.apply(move({1, 0, 0}), {.number = 1});
  const std::uint64_t first = history.steps()[0].revision, second = history.revision();
  history.go_to(first);
  history.go_to(second);
  history.apply(move({2, 0, 0}), {.number = 1});
  EXPECT_EQ(history.undo_depth(), 2U);
}

TEST(History, TracksTheSavedRevision) {
  History history(one_taxel());
  EXPECT_FALSE(history.dirty());
  history.apply(move({1, 0, 0}));
  EXPECT_TRUE(history.dirty());
  const std::uint64_t written = history.revision();
  history.apply(move({2, 0, 0}));
  history.mark_saved(written);
  EXPECT_TRUE(history.dirty());
  history.undo();
  EXPECT_FALSE(history.dirty());
  history.redo();
  history.mark_saved();
  EXPECT_FALSE(history.dirty());
  history.mark_unsaved();
  EXPECT_TRUE(history.dirty());
}

TEST(History, KeepsAThousandSteps) {
  History history(one_taxel());
  for (int i = 1; i <= 1234; ++i) history.apply(move({i, 0, 0}));
  EXPECT_EQ(history.undo_depth(), 1000U);
  for (int i = 0; i < 2000; ++i) history.undo();
  EXPECT_EQ(history.project()->layout.taxels[0].center, dvec3(234, 0, 0));
}

/// Returns 100 taxels with names that are too long for the small-string optimisation.
Project hundred_taxels() {
  Project project = one_taxel();
  for (int id = 100; id < 200; ++id)
    project.layout.taxels.push_back({id, std::string(1000, 'x'), dvec3(id), dvec3(0, 0, 1), 0.006, {}});
  return project;
}

TEST(History, IsLimitedInBytes) {
  const std::size_t each = bytes_of(hundred_taxels());
  EXPECT_GT(each, 100U * (1000U + sizeof(Taxel)));
  EXPECT_LT(each, 100U * (1000U + 2 * sizeof(Taxel)));
  History history(hundred_taxels(), {.steps = 1000, .bytes = 10 * each + each / 2});
  for (int i = 1; i <= 50; ++i) {
    history.apply(move({i, 0, 0}));
    EXPECT_LE(history.bytes(), 11 * each);
  }
  EXPECT_EQ(history.undo_depth(), 9U) << "ten projects, with the present one";

  History small(hundred_taxels(), {.steps = 1000, .bytes = 1});
  small.apply(move({1, 0, 0}));
  small.apply(move({2, 0, 0}));
  EXPECT_EQ(small.undo_depth(), 1U) << "one step back is always possible";
}

TEST(History, CountsASharedRegionOnce) {
  std::vector<int> faces(100'000);
  for (int i = 0; i < 100'000; ++i) faces[static_cast<std::size_t>(i)] = i;
  History history(one_taxel());
  history.apply(SetRegion{faces});
  const std::size_t one = history.bytes();
  EXPECT_GT(one, 100'000U * sizeof(int));
  for (int i = 1; i <= 100; ++i) history.apply(move({i, 0, 0}));
  EXPECT_LT(history.bytes(), one + 100 * 2 * bytes_of(one_taxel()));
  EXPECT_EQ(history.project()->layout.sampling.region.identity(), [&] {
    history.undo();
    return history.project()->layout.sampling.region.identity();
  }());
  faces.pop_back();
  history.apply(SetRegion{faces});
  EXPECT_GT(history.bytes(), one + 99'999 * sizeof(int));
}

TEST(History, CountsStepsThatAGestureDiscards) {
  const std::size_t each = bytes_of(hundred_taxels());
  History history(hundred_taxels(), {.steps = 1000, .bytes = 6 * each});
  for (int i = 1; i <= 4; ++i) history.apply(move({i, 0, 0}));
  for (int i = 1; i <= 4; ++i) history.undo();
  history.apply(move({9, 0, 0}), {.number = 1});
  EXPECT_GE(history.bytes(), 6 * each - each / 2) << "start, gesture and the four that Esc brings back";
  EXPECT_EQ(history.undo_depth(), 1U);
}

}  // namespace
}  // namespace taxel
