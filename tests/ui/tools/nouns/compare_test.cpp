// Decisions of the comparison of two layouts: which result may be shown, the numbers of both layouts, and their curves.
#include <gtest/gtest.h>

#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

using RowsOfTest = ComparedStepList;

ComparedStepPtr row(std::uint64_t step, std::vector<double> a, std::vector<double> b, bool after_gap = false) {
  ComparedStep made{step, 1e-3 * static_cast<double>(step), 1e-4 * static_cast<double>(step), {}, after_gap};
  made.readings.models = {{ReadingModel::reading, std::move(a), ""}, {ReadingModel::second, std::move(b), ""}};
  return std::make_shared<const ComparedStep>(std::move(made));
}

/// Two taxels of A and one of B over four rows; before the last row rows are missing.
RowsOfTest four_rows() {
  return {row(0, {0, 0}, {0}), row(1, {10, 0.1}, {30}), row(2, {13, 0.2}, {10}), row(9, {90, 0.1}, {11}, true)};
}

TEST(CompareSide, HasThePeakTheLargestJumpAndTheRespondingTaxels) {
  std::array<CompareSide, 2> sides;
  for (std::size_t s = 0; s < 2; ++s) extend_side(sides[s], four_rows(), s, true);
  EXPECT_EQ(sides[0].summary.peak.value, 90);
  EXPECT_EQ(sides[0].summary.peak.taxel, 0);
  EXPECT_DOUBLE_EQ(sides[0].summary.peak.x, 9e-4);
  EXPECT_EQ(sides[0].summary.jump.value, 10) << "the change over the gap is no jump";
  EXPECT_DOUBLE_EQ(sides[0].summary.jump.x, 1e-4);
  EXPECT_EQ(sides[0].summary.responding, 1) << "0.2 is below 5 % of 90";
  EXPECT_EQ(sides[1].summary.peak.value, 30);
  EXPECT_EQ(sides[1].summary.jump.value, 30);
  EXPECT_EQ(sides[1].summary.responding, 1);
  EXPECT_EQ(sides[0].curves.x.size(), 4U);
  EXPECT_DOUBLE_EQ(sides[0].curves.x.back(), 0.9) << "travel in mm";
}

TEST(CompareSide, IsTheSameIfRowsArriveOneByOne) {
  const RowsOfTest rows = four_rows();
  CompareSide whole, parts;
  extend_side(whole, rows, 0, false);
  for (std::size_t n = 1; n <= rows.size(); ++n) extend_side(parts, std::span(rows).first(n), 0, false);
  EXPECT_EQ(parts.summary.peaks, whole.summary.peaks);
  EXPECT_EQ(parts.summary.jump.value, whole.summary.jump.value);
  EXPECT_EQ(parts.curves.readings, whole.curves.readings);
}

TEST(CompareRows, AreWrittenAsATableOfBothLayouts) {
  const std::array columns{ModelColumns{ReadingModel::reading, "A/taxel_", {3, 5}},
                           ModelColumns{ReadingModel::second, "B/taxel_", {8}}};
  EXPECT_EQ(readings_to_csv(RowsOfTest{row(1, {10, 0.1}, {30})}, columns),
            "time,travel,A/taxel_3,A/taxel_5,B/taxel_8\n0.001,0.0001,10,0.1,30\n");
}

TEST(CompareRows, HaveAMeanDistance) {
  EXPECT_EQ(row_distance({}, true), 0);
  EXPECT_DOUBLE_EQ(row_distance(RowsOfTest{row(1, {}, {}), row(3, {}, {}), row(4, {}, {})}, true), 1.5e-4);
}

/// A run of a ball with two taxels, compared with one taxel on the same ball.
struct ComparedBall : ::testing::Test {
  test::ToolScene scene{{dvec3(1, 0, 0), dvec3(1, 0.5, 0)}};
  test::ToolScene other{{dvec3(0, 1, 0)}};
  std::shared_ptr<ComparedLayouts> compared = std::make_shared<ComparedLayouts>();
  CompareState state;

  ComparedBall() {
    const auto frame = std::make_shared<SimFrame>();
    const auto sim_scene = std::make_shared<SimScene>();
    sim_scene->sensors = {scene.app.shown->document.model};
    frame->scene = sim_scene;
    frame->sensors.resize(1);
    scene.app.shown->run.frame = frame;
    scene.app.viewer->mode = Mode::simulate;
    begin_comparison(state, "/there/second.taxels.json");
    compared->request = *state.request;
    compared->model = scene.app.shown->document.model;
    compared->b = other.app.shown->document.model;
    compared->taxels_of_b = std::make_shared<const std::vector<Taxel>>(compared->b->layout.taxels);
    compared->steps = four_rows();
    state.compared = compared;
  }
  [[nodiscard]] bool is_displayed(bool open = true) const {
    return displayed_comparison(*scene.app.viewer, *scene.app.shown, state, open) != nullptr;
  }
};

TEST_F(ComparedBall, IsDisplayedOnlyForItsRequestItsSensorAndItsLayout) {
  EXPECT_TRUE(is_displayed());
  EXPECT_FALSE(is_displayed(false)) << "the panel is closed";
  scene.app.viewer->mode = Mode::layout;
  EXPECT_FALSE(is_displayed());
  scene.app.viewer->mode = Mode::simulate;
  state.request->contact = SecondContact::own;
  EXPECT_FALSE(is_displayed()) << "another contact was requested";
  state.request->contact = SecondContact::recorded;
  reread_second(state);
  EXPECT_FALSE(is_displayed()) << "the file has changed";
  compared->request = *state.request;
  EXPECT_TRUE(is_displayed());
  compared->model = other.app.shown->document.model;
  EXPECT_FALSE(is_displayed()) << "the layout of the run has changed";
  compared->model = scene.app.shown->document.model;
  end_comparison(state);
  EXPECT_FALSE(is_displayed());
}

TEST_F(ComparedBall, DrawsAllFieldsOfFewTaxelsAndTheRespondingOnesOfMany) {
  std::vector<Taxel> many(100, compared->b->layout.taxels[0]);
  for (std::size_t k = 0; k < many.size(); ++k) many[k].id = static_cast<int>(k);
  std::vector<double> readings(many.size());
  readings[7] = 100, readings[40] = 6, readings[41] = 4;
  compared->displayed = row(3, {}, readings);
  scene.app.get<PanelsShown>()[kCompare] = true;
  scene.app.get<CompareState>() = state;
  EXPECT_EQ(scene_input(scene.app).ghosts->size(), 1U);
  compared->taxels_of_b = std::make_shared<const std::vector<Taxel>>(many);
  const auto drawn = scene_input(scene.app).ghosts;
  ASSERT_EQ(drawn->size(), 2U) << "4 is below 5 % of 100";
  EXPECT_EQ(drawn->at(0).id, 7);
  EXPECT_EQ(drawn->at(1).id, 40);
}

TEST_F(ComparedBall, TakesNewRowsAndStartsAgainForOtherRows) {
  take_rows(state, *compared, false);
  EXPECT_EQ(state.sides[0].trace.rows.size(), 4U);
  compared->steps.push_back(row(10, {91, 0}, {12}));
  take_rows(state, *compared, false);
  EXPECT_EQ(state.sides[0].trace.rows.size(), 5U);
  EXPECT_EQ(state.sides[0].summary.peak.value, 91);
  compared->steps = {row(0, {1, 2}, {3})};
  take_rows(state, *compared, false);
  EXPECT_EQ(state.sides[0].trace.rows.size(), 1U);
  EXPECT_EQ(state.sides[0].summary.peak.value, 2) << "nothing is left of the earlier rows";
  take_rows(state, *compared, true);
  EXPECT_TRUE(state.sides[0].curves.by_travel);
}

TEST_F(ComparedBall, ChoosesRespondingTaxelsAndNamesLayoutAndTaxel) {
  take_rows(state, *compared, false);
  Selection selection;
  const auto labels = [&](std::size_t side, bool responding_only) {
    std::string text;
    for (const ChosenCurve& curve : choose_side(*compared, side, state.sides[side].summary, selection, responding_only))
      text += curve.label + (curve.dashed ? "-" : "") + ";";
    return text;
  };
  EXPECT_EQ(labels(0, true), "A 1;");
  EXPECT_EQ(labels(0, false), "A 1;A 2;");
  EXPECT_EQ(labels(1, true), "B 1-;");
  selection.set(2);
  EXPECT_EQ(labels(0, true), "A 1;A 2;");
  EXPECT_EQ(side_taxel(*compared, {1, 1}), "B (second.taxels.json), taxel 1");
}

TEST_F(ComparedBall, FindsTheCurveUnderThePointer) {
  take_rows(state, *compared, false);
  for (std::size_t s = 0; s < 2; ++s)
    state.shown.curves[s] = choose_side(*compared, s, state.sides[s].summary, {}, false);
  // Values are plotted in kPa over seconds. At 1 ms A has 0.01, B has 0.03.
  EXPECT_EQ(nearest_curve(state, *compared, {0.001, 0.011, 0.005}), (TaxelKey{0, 1}));
  EXPECT_EQ(nearest_curve(state, *compared, {0.001, 0.028, 0.005}), (TaxelKey{1, 1}));
  EXPECT_EQ(nearest_curve(state, *compared, {0.001, 0.020, 0.005}), std::nullopt);
  state.drawn[1] = false;
  EXPECT_EQ(nearest_curve(state, *compared, {0.001, 0.028, 0.005}), std::nullopt) << "B is not drawn";
}

TEST_F(ComparedBall, IsRelativeIfTheUnitsDiffer) {
  EXPECT_FALSE(is_relative(*compared, state));
  auto force = std::make_shared<SensorModel>(*compared->b);
  force->layout.readout.aggregate = Aggregate::force;
  compared->b = force;
  EXPECT_TRUE(is_relative(*compared, state));
  take_rows(state, *compared, false);
  EXPECT_DOUBLE_EQ(side_scale(*compared, 1, state.sides[1].summary, true), 1.0 / 30);
}

TEST_F(ComparedBall, NamesTheEqualPartsOfTheContact) {
  EXPECT_NE(held_equal(*compared).find("pressure field and contact surfaces."), std::string::npos);
  compared->equal_contact = false;
  EXPECT_NE(held_equal(*compared).find("of B are not used"), std::string::npos) << held_equal(*compared);
  compared->reads_recorded = false;
  EXPECT_NE(held_equal(*compared).find("Not equal: the pressure field"), std::string::npos) << held_equal(*compared);
}

TEST_F(ComparedBall, SaysWhichRowsAreMissing) {
  Trace trace;
  trace.rows.push_back({0, 0, {}});
  EXPECT_NE(missing_rows(*compared, trace, false).find("before 0.009 s"), std::string::npos)
      << missing_rows(*compared, trace, false);
  compared->steps.erase(compared->steps.begin());
  EXPECT_NE(missing_rows(*compared, trace, true).find("begin at 0.10 mm"), std::string::npos)
      << missing_rows(*compared, trace, true);
  compared->steps = {row(0, {1, 2}, {3})};
  EXPECT_EQ(missing_rows(*compared, trace, true), "");
}

}  // namespace
}  // namespace taxel::ui
