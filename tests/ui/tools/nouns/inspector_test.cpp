// The inspector: problems of the edited layout by taxel, and figures of the compiled layout.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A ball with taxels 1 and 2.
struct InspectedBall : test::ToolScene {
  InspectedBall() : ToolScene({dvec3(1, 0, 0), dvec3(0, 1, 0)}) {}
  /// The problems of the project as it is now, which is newer than the model.
  [[nodiscard]] LayoutProblems problems() {
    publish();
    return layout_problems(app.shown->document.editing.project, app.shown->document.model, false, "");
  }
};

/// Problems of taxels 4 and 7, and one of the settings.
LayoutProblems three_problems() {
  LayoutProblems problems;
  for (const Severity severity : {Severity::note, Severity::error, Severity::warning})
    problems.list.push_back({"", "", severity, "", "", ""});
  problems.of_taxel[4] = {0, 2};
  problems.of_taxel[7] = {1};
  return problems;
}

TEST(LayoutProblems, AreEmptyForAGoodLayout) {
  EXPECT_TRUE(InspectedBall().problems().list.empty());
}

TEST(LayoutProblems, AreListedWithTheirTaxel) {
  InspectedBall ball;
  ball.project.layout.taxels[1].radius = -0.001;
  const LayoutProblems problems = ball.problems();
  EXPECT_TRUE(problems.of(1).empty());
  ASSERT_FALSE(problems.of(2).empty());
  EXPECT_EQ(problems.worst(2), Severity::error);
  EXPECT_TRUE(problems.list[problems.of(2).front()].pointer.starts_with("/taxels/1"));
}

TEST(LayoutProblems, BelongToNoTaxelIfTheyAreOfSettings) {
  InspectedBall ball;
  ball.project.layout.sampling.density = -1;
  const LayoutProblems problems = ball.problems();
  ASSERT_FALSE(problems.of_settings.empty());
  EXPECT_TRUE(problems.list[problems.of_settings.front()].pointer.starts_with("/sampling"));
  EXPECT_TRUE(problems.of_taxel.empty());
}

TEST(LayoutProblems, AllowALayoutWithoutTaxels) {
  InspectedBall ball;
  ball.project.layout.taxels.clear();
  EXPECT_TRUE(ball.problems().list.empty());
}

TEST(LayoutProblems, ReportEmptyFieldsOfPolishedSamplesOnly) {
  InspectedBall ball;
  SensorModel model = *ball.app.shown->document.model;
  model.problems = {{"", "/taxels/0", Severity::warning, kFieldWithoutSamples, "no samples", ""},
                    {"", "/taxels/1", Severity::warning, "another", "not about samples", ""}};
  const auto count = [&](SampleQuality quality, bool compiled) {
    model.quality = quality;
    const auto shared = std::make_shared<const SensorModel>(model);
    return layout_problems(ball.app.shown->document.editing.project, shared, compiled, "").of(1).size();
  };
  EXPECT_EQ(count(SampleQuality::polished, true), 1U);
  EXPECT_EQ(count(SampleQuality::preview, true), 0U);
  EXPECT_EQ(count(SampleQuality::polished, false), 0U) << "the model is older than the project";
}

TEST(WorstProblem, IsTheMostSevereOfATaxel) {
  const LayoutProblems problems = three_problems();
  EXPECT_EQ(problems.worst(4), Severity::warning);
  EXPECT_EQ(problems.worst(7), Severity::error);
  EXPECT_EQ(problems.worst(1), Severity::note) << "without problems";
}

TEST(DisplayedProblems, FollowTheSelection) {
  Selection selection;
  EXPECT_EQ(displayed_problems(selection, three_problems()), (std::vector<std::size_t>{0, 1, 2}));
  selection.taxels = {7, 4};
  EXPECT_EQ(displayed_problems(selection, three_problems()), (std::vector<std::size_t>{1, 0, 2}));
  selection.taxels = {5};
  EXPECT_TRUE(displayed_problems(selection, three_problems()).empty());
}

TEST(ModelSummary, CountsTheSamplesOfOneTaxel) {
  const test::ToolScene ball({dvec3(1, 0, 0)});
  const SensorModelPtr model = ball.app.shown->document.model;
  const ModelSummary summary = summarize(model);
  const int samples = static_cast<int>(model->fields.entries.size());
  EXPECT_EQ(summary.samples_of_taxel, (std::vector<int>{samples}));
  EXPECT_EQ(summary.used_samples, samples);
  EXPECT_EQ(summary.shared_samples, 0);
  double area = 0;
  for (const auto& entry : model->fields.entries) area += model->samples[static_cast<std::size_t>(entry.sample)].area;
  EXPECT_NEAR(summary.used_area, area, 1e-12);
}

TEST(ModelSummary, CountsSharedSamplesOnce) {
  const test::ToolScene ball({dvec3(1, 0, 0), dvec3(1, 0.01, 0), dvec3(-1, 0, 0)});
  const ModelSummary summary = summarize(ball.app.shown->document.model);
  const std::vector<int>& samples = summary.samples_of_taxel;
  EXPECT_GT(summary.shared_samples, 0) << "the fields of taxels 1 and 2 overlap";
  EXPECT_EQ(summary.used_samples, samples[0] + samples[1] + samples[2] - summary.shared_samples);
}

TEST(ModelSummary, MeasuresTheSkin) {
  const test::ToolScene ball({dvec3(1, 0, 0)});
  const ModelSummary summary = summarize(ball.app.shown->document.model);
  const double sphere = 4 * glm::pi<double>() * test::kBallRadius * test::kBallRadius;
  EXPECT_NEAR(summary.skin_area, sphere, 0.01 * sphere);
  EXPECT_NEAR(summary.distance_to_skin.at(0), 0, 1e-12);
  EXPECT_LT(summary.angle_to_skin_deg.at(0), 5);
}

TEST(ModelSummary, MeasuresTheDistanceOfATaxelAboveTheSkin) {
  test::ToolScene ball({dvec3(1, 0, 0)});
  SensorModel model = *ball.app.shown->document.model;
  model.layout.taxels[0].center = {test::kBallRadius + 0.003, 0, 0};
  model.layout.taxels[0].normal = {-1, 0, 0};
  const ModelSummary summary = summarize(std::make_shared<const SensorModel>(model));
  EXPECT_NEAR(summary.distance_to_skin.at(0), 0.003, 1e-9);
  EXPECT_GT(summary.angle_to_skin_deg.at(0), 175) << "the normal points inward";
}

TEST(ModelSummary, IsEmptyWithoutAModel) {
  EXPECT_EQ(summarize(nullptr).used_samples, 0);
  EXPECT_TRUE(summarize(nullptr).samples_of_taxel.empty());
}

}  // namespace
}  // namespace taxel::ui
