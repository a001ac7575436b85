// Any edits, undone and redone, give the same bytes, and every edit leaves a valid project.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <map>

#include "core/base/error.h"
#include "core/document/edit.h"
#include "core/document/history.h"
#include "core/document/project.h"
#include "random_edit.h"

namespace rc {
template <>
struct Arbitrary<taxel::EditSeed> {
  static Gen<taxel::EditSeed> arbitrary() {
    return gen::build<taxel::EditSeed>(gen::set(&taxel::EditSeed::kind, gen::inRange(0U, 20U)),
                                       gen::set(&taxel::EditSeed::seed, gen::inRange<std::uint64_t>(0, 1000)));
  }
};
}  // namespace rc

namespace taxel {

void showValue(const EditSeed& seed, std::ostream& out) {
  out << "{" << seed.kind << ", " << seed.seed << "}";
}

namespace {

/// Sets a fixed seed, so that every run tests the same cases. An existing RC_PARAMS overrides the seed.
const int kSeeded = ::setenv("RC_PARAMS", "seed=6 max_size=50", 0);

/// Returns a layout with unknown keys, hidden taxels and a link, which edits must preserve.
Project start() {
  Project project;
  project.layout.mesh.file = "/meshes/finger.obj";
  for (int id = 0; id < 5; ++id)
    project.layout.taxels.push_back({10 - id, "", dvec3(id + 1, id, 1) * 1e-3, dvec3(0, 0, 1), 0.004, {}});
  project.layout.unknown = {{"/taxels/2/note", "\"eight\""}, {"/made", "1"}};
  project.mirrors = {{{dvec3(0), {1, 0, 0}}, {{10, 9}}}};
  project.hidden = {8};
  return project;
}

/// Number of edits that were applied (true) and of edits that were refused with an Error (false).
std::map<bool, int> outcomes;

bool try_apply(History& history, const EditSeed& seed) {
  const std::string before = project_to_json(*history.project());
  try {
    const bool changed = history.apply(RandomEdit(*history.project(), seed).make());
    ++outcomes[true];
    return changed;
  } catch (const Error&) {
    ++outcomes[false];
    RC_ASSERT(project_to_json(*history.project()) == before);
    return false;
  }
}

TEST(Edits, GiveTheSameBytesAfterUndoAndRedo) {
  outcomes.clear();
  EXPECT_TRUE(rc::check("k edits, k undos, k redos", [](const std::vector<EditSeed>& seeds) {
    History history(start());
    std::vector<std::string> texts{project_to_json(*history.project())};
    for (const EditSeed& seed : seeds)
      if (try_apply(history, seed)) texts.push_back(project_to_json(*history.project()));
    RC_ASSERT(history.undo_depth() + 1 == texts.size());
    for (std::size_t k = texts.size(); k-- > 0; history.undo())
      RC_ASSERT(project_to_json(*history.project()) == texts[k]);
    RC_ASSERT(!history.can_undo());
    RC_ASSERT(!history.dirty());
    for (std::size_t k = 0; k < texts.size(); ++k, history.redo())
      RC_ASSERT(project_to_json(*history.project()) == texts[k]);
    RC_ASSERT(!history.can_redo());
  }));
  EXPECT_GT(outcomes[true], 4 * outcomes[false]) << "most edits are possible ones";
}

TEST(Edits, LeaveAProjectThatCanBeWrittenAndRead) {
  EXPECT_TRUE(rc::check("valid, and round through the file", [](const std::vector<EditSeed>& seeds) {
    History history(start());
    for (const EditSeed& seed : seeds) try_apply(history, seed);
    const Project& project = *history.project();
    check_project(project);
    RC_ASSERT(parse_project(project_to_json(project)) == project);
  }));
}

TEST(Edits, MergeIntoOneStepDuringAGesture) {
  EXPECT_TRUE(rc::check("one step, and Esc restores",
                        [](const std::vector<EditSeed>& before, const std::vector<EditSeed>& gesture) {
                          History history(start());
                          for (const EditSeed& seed : before) try_apply(history, seed);
                          const std::string text = project_to_json(*history.project());
                          const std::size_t depth = history.undo_depth();
                          for (const EditSeed& seed : gesture) {
                            try {
                              history.apply(RandomEdit(*history.project(), seed).make(), {.number = 7});
                            } catch (const Error&) {
                            }
                          }
                          RC_ASSERT(history.undo_depth() <= depth + 1);
                          History canceled = history;
                          canceled.cancel(7);
                          RC_ASSERT(project_to_json(*canceled.project()) == text);
                          if (history.undo_depth() > depth) history.undo();
                          RC_ASSERT(project_to_json(*history.project()) == text);
                        }));
}

/// A twin must be the exact mirror image of the moved taxel, for links of any length.
TEST(Edits, KeepTwinsAsMirrorImages) {
  int linked = 0;
  EXPECT_TRUE(rc::check("images", [&](const std::vector<EditSeed>& seeds, std::uint64_t number) {
    History history(start());
    for (const EditSeed& seed : seeds) try_apply(history, seed);
    const Project& project = *history.project();
    if (project.mirrors.empty() || project.mirrors.back().links.empty()) return;
    ++linked;
    const Mirror& mirror = project.mirrors[number % project.mirrors.size()];
    const MirrorLink link = mirror.links[number % mirror.links.size()];
    const dvec3 place = dvec3(1, 2, 3) * 1e-3 + 1e-6 * static_cast<double>(number % 1000);
    SetTaxels move;
    move.changes.resize(1);
    move.changes[0].id = link.image;
    move.changes[0].center = place;
    move.changes[0].radius = 0.0123;
    const Project moved = apply_edit(project, move);
    const Taxel image = mirror_images({*find_taxel(moved.layout, link.image)}, mirror.plane).front();
    const Taxel& twin = *find_taxel(moved.layout, link.taxel);
    RC_ASSERT(twin.center == image.center);
    RC_ASSERT(twin.radius == 0.0123);
    RC_ASSERT(twin.normal == find_taxel(project.layout, link.taxel)->normal);
    RC_ASSERT(twin.name == find_taxel(project.layout, link.taxel)->name);
  }));
  EXPECT_GT(linked, 50) << "most cases have links";
}

}  // namespace
}  // namespace taxel
