// The requests of the Explain and the Models panel, and the results that belong to them.
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/models/models_state.h"
#include "ui/tools/tool_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace taxel::ui {
namespace {

/// A simulated ball with two taxels, the second of which reads more. Step 7 is displayed.
struct SimulatedBall {
  test::ToolScene ball{{dvec3(1, 0, 0), dvec3(1, 0.5, 0)}};
  App& app = ball.app;
  bool open = true;

  SimulatedBall() {
    app.viewer->mode = Mode::simulate;
    const auto scene = std::make_shared<SimScene>();
    scene->sensors = {app.shown->document.model};
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = scene;
    frame->step = 7;
    frame->sensors.resize(1);
    frame->sensors[0].model = app.shown->document.model;
    frame->sensors[0].readings = {100, 200};
    app.shown->run.frame = frame;
  }
  [[nodiscard]] std::optional<ExplainRequest> request() const { return explain_request(*app.viewer, *app.shown, open); }
  [[nodiscard]] const Explanation* explanation() const {
    return shown_explanation(*app.viewer, *app.shown, app.get<ExplainState>(), open);
  }
  /// An explanation of a taxel in a step.
  static ExplainedPtr explained(int taxel, std::uint64_t step) {
    ExplainedStep found;
    found.request = {0, taxel};
    found.step = step;
    return std::make_shared<const ExplainedStep>(found);
  }
};

TEST(ExplainRequest, NamesTheActiveTaxelOfTheSelectedSensor) {
  SimulatedBall scene;
  scene.app.viewer->selection.taxels = {2, 1};
  EXPECT_EQ(scene.request(), (ExplainRequest{0, 1}));
}

TEST(ExplainRequest, NeedsAnOpenPanelATaxelAndARun) {
  SimulatedBall scene;
  EXPECT_FALSE(scene.request()) << "no taxel is selected";
  scene.app.viewer->selection.set(1);
  scene.open = false;
  EXPECT_FALSE(scene.request());
  scene.open = true;
  scene.app.viewer->mode = Mode::layout;
  EXPECT_FALSE(scene.request());
  scene.app.viewer->mode = Mode::simulate;
  scene.app.shown->run.frame.reset();
  EXPECT_FALSE(scene.request());
}

TEST(ExplainReading, OpensThePanelWithTheLargestReading) {
  SimulatedBall scene;
  scene.open = false;
  explain_reading(*scene.app.viewer, *scene.app.shown, scene.app.get<ExplainState>(), scene.open);
  EXPECT_TRUE(scene.open && scene.app.get<ExplainState>().wants_focus);
  EXPECT_EQ(scene.app.viewer->selection.taxels, std::vector<int>{2});
}

TEST(ExplainReading, KeepsTheSelectedTaxel) {
  SimulatedBall scene;
  scene.app.viewer->selection.set(1);
  explain_reading(*scene.app.viewer, *scene.app.shown, scene.app.get<ExplainState>(), scene.open);
  EXPECT_EQ(scene.app.viewer->selection.taxels, std::vector<int>{1});
}

TEST(Explanation, BelongsToTheDisplayedStepAndTaxel) {
  SimulatedBall scene;
  scene.app.viewer->selection.set(1);
  EXPECT_EQ(scene.explanation(), nullptr) << "there is none yet";
  scene.app.get<ExplainState>().explained = SimulatedBall::explained(1, 7);
  EXPECT_EQ(scene.explanation(), &scene.app.get<ExplainState>().explained->explanation);
  scene.app.get<ExplainState>().explained = SimulatedBall::explained(1, 6);
  EXPECT_EQ(scene.explanation(), nullptr) << "of another step";
  scene.app.get<ExplainState>().explained = SimulatedBall::explained(2, 7);
  EXPECT_EQ(scene.explanation(), nullptr) << "of another taxel";
}

TEST(InspectPolygon, SelectsAPolygonOfTheDisplayedStep) {
  SimulatedBall scene;
  scene.open = false;
  inspect_polygon(scene.app.shown->run, scene.app.get<ExplainState>(), scene.open, {1, 3});
  EXPECT_EQ(scene.app.get<ExplainState>().polygon, (PolygonNumber{1, 3}));
  EXPECT_EQ(scene.app.get<ExplainState>().step, 7U);
  EXPECT_TRUE(scene.open);
}

TEST(ModelsRequest, NeedsAnOpenPanelAndARun) {
  SimulatedBall scene;
  EXPECT_TRUE(models_request(*scene.app.viewer, *scene.app.shown, true));
  EXPECT_FALSE(models_request(*scene.app.viewer, *scene.app.shown, false));
  scene.app.viewer->selection.sensor = 1;
  EXPECT_FALSE(models_request(*scene.app.viewer, *scene.app.shown, true)) << "there is one sensor";
}

TEST(ModelsComparison, BelongsToTheModelOfTheSelectedSensor) {
  SimulatedBall scene;
  ComparedSteps compared;
  compared.model = scene.app.shown->document.model;
  scene.app.get<ModelsState>().compared = std::make_shared<const ComparedSteps>(compared);
  EXPECT_NE(shown_comparison(*scene.app.viewer, *scene.app.shown, scene.app.get<ModelsState>(), true), nullptr);
  compared.sensor = 1;
  scene.app.get<ModelsState>().compared = std::make_shared<const ComparedSteps>(compared);
  EXPECT_EQ(shown_comparison(*scene.app.viewer, *scene.app.shown, scene.app.get<ModelsState>(), true), nullptr);
}

ComparedStepPtr read_step(const ModelReading& reading) {
  ComparedStep step;
  step.readings.models = {reading};
  return std::make_shared<const ComparedStep>(std::move(step));
}

TEST(ModelsComparison, DrawsTheActiveTaxelOrTheLargestReading) {
  SimulatedBall scene;
  ComparedSteps compared;
  compared.model = scene.app.shown->document.model;
  EXPECT_EQ(compared_taxel(scene.app.viewer->selection, compared), -1) << "no step was compared";
  compared.steps = {read_step({ReadingModel::reading, {1, 2}, ""})};
  EXPECT_EQ(compared_taxel(scene.app.viewer->selection, compared), 1);
  scene.app.viewer->selection.set(1);
  EXPECT_EQ(compared_taxel(scene.app.viewer->selection, compared), 0);
}

TEST(ModelsCurve, HasGapsInStepsWithoutValues) {
  const ComparedStepList steps{read_step({}), read_step({ReadingModel::exact, {3, 4}, ""})};
  const std::vector<double> curve = model_curve(steps, ReadingModel::exact, 1);
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_TRUE(std::isnan(curve[0]));
  EXPECT_EQ(curve[1], 4);
}

}  // namespace
}  // namespace taxel::ui
