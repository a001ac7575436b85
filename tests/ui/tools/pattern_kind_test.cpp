// The Generate panel's pattern: its kind, and the messages for values out of range.
#include <gtest/gtest.h>

#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/generate/pattern_job.h"
#include "core/mesh/make/primitives.h"

namespace taxel::ui {
namespace {

std::string problem_of(const Pattern& pattern) {
  const MeshIndex skin(std::make_shared<TriMesh>(make_box(dvec3(0.01))));
  try {
    make_pattern(pattern, {}, skin);
  } catch (const PatternFieldError& error) {
    return studio::displayed_problem(error);
  }
  return "";
}

TEST(ChangeKind, KeepsSharedValuesOverAKindWithoutThem) {
  GenerateState g;
  change_kind<patterns::Ring>(g);
  std::get<patterns::Ring>(g.pattern.shape).count = 7;
  change_kind<patterns::Grid>(g);
  change_kind<patterns::Spiral>(g);
  EXPECT_EQ(std::get<patterns::Spiral>(g.pattern.shape).count, 7);
}

TEST(ChangeKind, RestoresTheLastValuesOfTheKind) {
  GenerateState g;
  std::get<patterns::Grid>(g.pattern.shape).rows = 9;
  change_kind<patterns::Image>(g);
  EXPECT_TRUE(has_frame(g.pattern));
  change_kind<patterns::Table>(g);
  EXPECT_FALSE(has_frame(g.pattern));
  change_kind<patterns::Grid>(g);
  EXPECT_EQ(std::get<patterns::Grid>(g.pattern.shape).rows, 9);
}

TEST(DisplayedProblem, NamesTheLabelAndMillimetres) {
  Pattern p;
  p.radius = -0.004;
  EXPECT_EQ(problem_of(p), "Radius: must be greater than 0, is -4 mm");
  p = {};
  std::get<patterns::Grid>(p.shape).row_pitch = 0;
  EXPECT_EQ(problem_of(p), "Row pitch: must be greater than 0, is 0 mm");
}

TEST(DisplayedProblem, NamesWholeNumbersAndRulesWithoutAValue) {
  patterns::Helix helix;
  helix.count = 1;
  Pattern p;
  p.shape = helix;
  EXPECT_EQ(problem_of(p), "Taxels: must be 2 to 100000, is 1");
  helix.count = 2'000'000'000;
  p.shape = helix;
  EXPECT_EQ(problem_of(p), "Taxels: must be 2 to 100000, is 2000000000");
  helix.count = 4;
  helix.turns = 0;
  p.shape = helix;
  EXPECT_EQ(problem_of(p), "Turns: must not be 0");
}

}  // namespace
}  // namespace taxel::ui
