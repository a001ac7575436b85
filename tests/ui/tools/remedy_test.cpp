// The remedies of the Explain panel: which edit removes which jump, and when the run begins again.
#include <gtest/gtest.h>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/tools/tool_scene.h"

namespace taxel::ui {
namespace {

/// A jump of 100 with a limit of 50, of which `noise` is noise and `field` comes from the field.
Explanation jump_by(Cause cause, double noise, double field) {
  Explanation e;
  e.change.emplace();
  Verdict& v = e.change->verdict;
  v.cause = cause;
  v.change = 100;
  v.limit = 50;
  v.noise = noise;
  v.field = field;
  v.contact = v.change - noise - field;
  return e;
}

TEST(Remedy, RaisesTheDensityByTheFactorOfTheSentence) {
  Layout layout;
  layout.sampling.density = 2.5e5;
  Explanation e = jump_by(Cause::sampling_noise, 90, 0);
  e.change->verdict.needed = SamplesNeeded{1600, 4, 20, true};
  const std::optional<Remedy> remedy = remedy_of(e, layout);
  ASSERT_TRUE(remedy);
  EXPECT_EQ(std::get<SetSampling>(remedy->edit).sampling.density, 1e6);
  EXPECT_EQ(remedy->text, "4 times as many samples, 1 instead of 0.25 per mm\xc2\xb2");
  layout.taxels = {{7, "", dvec3(0), dvec3(0, 0, 1), 0.004, {}, 1e6}};
  const SetTaxels own = std::get<SetTaxels>(remedy_of(e, layout)->edit);
  ASSERT_EQ(own.changes.size(), 1U);
  EXPECT_EQ(own.changes[0].id, 7);
  EXPECT_EQ(*own.changes[0].density, 4e6) << "a taxel with its own density";
}

TEST(Remedy, CuresTheLargestStepOfTheRunToo) {
  Layout layout;
  layout.sampling.density = 2.5e5;
  Explanation e = jump_by(Cause::sampling_noise, 90, 0);
  Verdict& v = e.change->verdict;
  v.needed = SamplesNeeded{1600, 4, 20, true};
  v.worst = WorstChange{0.3, 200, SamplesNeeded{6400, 16, 30, true}, {}};
  EXPECT_EQ(std::get<SetSampling>(remedy_of(e, layout)->edit).sampling.density, 4e6) << "sixteen times, as it says";
  EXPECT_NE(remedy_of(e, layout)->text.find("(also enough for the largest step of the run)"), std::string::npos);
  v.worst->needed = SamplesNeeded{1600, 4, 30, true};
  EXPECT_EQ(std::get<SetSampling>(remedy_of(e, layout)->edit).sampling.density, 1e6) << "the same number is enough";
}

TEST(Remedy, IsNotOfferedIfMoreSamplesDoNotHelp) {
  Explanation e = jump_by(Cause::sampling_noise, 90, 0);
  EXPECT_FALSE(remedy_of(e, Layout())) << "no number of samples was tried";
  e.change->verdict.needed = SamplesNeeded{1600, 64, 60, false};
  EXPECT_FALSE(remedy_of(e, Layout()));
}

TEST(Remedy, ReplacesAStarFieldByAPadIfTheRestIsBelowTheLimit) {
  Layout layout;
  layout.material.field = FieldKind::star;
  const std::optional<Remedy> remedy = remedy_of(jump_by(Cause::star_field, 0, 70), layout);
  ASSERT_TRUE(remedy);
  EXPECT_EQ(std::get<SetMaterial>(remedy->edit).material.field, FieldKind::pad);
  EXPECT_FALSE(remedy_of(jump_by(Cause::star_field, 0, 52), layout)) << "48 of 100 remain, 90 % of the limit are 45";
  layout.material.field = FieldKind::pad;
  EXPECT_FALSE(remedy_of(jump_by(Cause::inverted_tets, 0, 70), layout)) << "it is a pad already";
}

TEST(Remedy, WidensTheFieldsToTheAngleThatCures) {
  Layout layout;
  Explanation e = jump_by(Cause::cone, 0, 0);
  EXPECT_FALSE(remedy_of(e, layout)) << "no angle was tried";
  e.change->verdict.wider = AngleTried{180, 60, false};
  EXPECT_FALSE(remedy_of(e, layout));
  e.change->verdict.wider = AngleTried{75, 20, true};
  const std::optional<Remedy> remedy = remedy_of(e, layout);
  ASSERT_TRUE(remedy);
  EXPECT_EQ(std::get<SetReceptiveField>(remedy->edit).rule.max_angle_deg, 75);
  EXPECT_EQ(remedy->text, "fields up to 75\xc2\xb0 from the normal of the taxel, instead of 45\xc2\xb0");
}

/// Returns a setting that leaves `change` of a jump of 100 with a limit of 50.
SettingTried tried(const Layout& layout, const std::string& text, double change, double radius = 1) {
  return {text, layout.receptive_field, layout.readout, radius, change, change <= 45};
}

TEST(Remedy, AppliesTheFirstSettingThatRemovesAJumpAtMeshEdges) {
  Layout layout;
  layout.taxels = {{7, "", dvec3(0), dvec3(0, 0, 1), 0.004, {}}};
  Explanation e = jump_by(Cause::mesh_edges, 0, 0);
  e.id = 7;
  std::vector<SettingTried>& settings = e.change->verdict.tried;
  EXPECT_FALSE(remedy_of(e, layout)) << "nothing was tried";
  settings.push_back(tried(layout, "interpolated normals", 70));
  settings.back().field.normals = FieldNormals::interpolated;
  EXPECT_FALSE(remedy_of(e, layout)) << "70 of 100 remain";

  settings.push_back(tried(layout, "a radius of 6 mm", 20, 1.5));
  const std::optional<Remedy> wider = remedy_of(e, layout);
  ASSERT_TRUE(wider);
  EXPECT_EQ(wider->text, "a radius of 6 mm");
  const SetTaxels edit = std::get<SetTaxels>(wider->edit);
  ASSERT_EQ(edit.changes.size(), 1U);
  EXPECT_EQ(edit.changes[0].id, 7);
  EXPECT_DOUBLE_EQ(*edit.changes[0].radius, 0.006);

  settings.back() = tried(layout, "rays along the taxel's normal", 20);
  settings.back().readout.ray = RayDirection::taxel_normal;
  EXPECT_EQ(std::get<SetReadout>(remedy_of(e, layout)->edit).readout.ray, RayDirection::taxel_normal);

  settings.front().change = 30;
  settings.front().cures = true;
  EXPECT_EQ(std::get<SetReceptiveField>(remedy_of(e, layout)->edit).rule.normals, FieldNormals::interpolated)
      << "the first one that cures";
}

TEST(Remedy, IsNotOfferedForJumpsOfTheContact) {
  EXPECT_FALSE(remedy_of(jump_by(Cause::contact, 0, 0), Layout()));
  EXPECT_FALSE(remedy_of(jump_by(Cause::redistribution, 0, 0), Layout()));
  EXPECT_FALSE(remedy_of(Explanation(), Layout())) << "there is no step before";
}

/// A document that the simulation reads by.
struct SimulatedDocument {
  test::ToolScene ball{{dvec3(1, 0, 0)}};
  App& app = ball.app;

  SimulatedDocument() { simulate(app.shown->document.model); }
  void simulate(const SensorModelPtr& model) {
    const auto scene = std::make_shared<SimScene>();
    scene->sensors = {model};
    const auto frame = std::make_shared<SimFrame>();
    frame->scene = frame->simulated = scene;
    app.shown->run.frame = frame;
    app.shown->run.simulates_document = true;
  }
  /// Returns the numbers of posted resets and requests of steps.
  std::pair<int, int> posted() const {
    int resets = 0, requests = 0;
    for (const Command& command : app.ui->commands) {
      resets += command.is<ResetSimulation>() ? 1 : 0;
      requests += command.is<StepAhead>() ? 1 : 0;
    }
    return {resets, requests};
  }
  bool advance() { return advance_run_ahead(*app.ui, *app.shown, app.get<RunAhead>()); }
  /// Displays the newest of `steps` steps of run number `runs`, all of which are recorded.
  void record(std::uint64_t runs, std::uint64_t steps) {
    const auto frame = std::make_shared<SimFrame>(*app.shown->run.frame);
    const auto lanes = std::make_shared<HistoryLanes>();
    for (std::uint64_t step = 0; step <= steps; ++step) lanes->steps.push_back({step, 0, 0, 0});
    frame->runs = runs;
    frame->step = frame->history.last = steps;
    frame->history.lanes = lanes;
    app.shown->run.frame = frame;
  }
};

TEST(Remedy, MakesTheSameRunWhenTheSimulationReadsByTheEditedLayout) {
  SimulatedDocument scene;
  App& app = scene.app;
  scene.record(1, 250);
  apply_remedy(*app.ui, *app.shown, app.get<RunAhead>(), {"", SetSampling{}});
  ASSERT_EQ(app.ui->commands.size(), 1U);
  EXPECT_TRUE(app.ui->commands[0].is<EditProject>());
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(scene.posted(), std::pair(0, 0)) << "the simulation still reads by the old layout";
  scene.simulate(std::make_shared<SensorModel>(*app.shown->document.model));
  scene.record(1, 250);
  app.shown->document.editing.compiled = false;
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(scene.posted(), std::pair(0, 0)) << "a newer layout is being compiled";
  app.shown->document.editing.compiled = true;
  EXPECT_FALSE(scene.advance());
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(scene.posted(), std::pair(1, 0)) << "once";
  scene.record(2, 0);
  EXPECT_FALSE(scene.advance());
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(scene.posted(), std::pair(1, 1)) << "further steps only after these";
  scene.record(2, 200);
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(scene.ball.asked<StepAhead>()->steps, 50) << "up to the step that was the newest";
  scene.record(2, 250);
  EXPECT_TRUE(scene.advance());
}

TEST(Remedy, EndsTheRunWhenTheUserPlays) {
  SimulatedDocument scene;
  App& app = scene.app;
  scene.record(1, 250);
  apply_remedy(*app.ui, *app.shown, app.get<RunAhead>(), {"", SetSampling{}});
  scene.simulate(std::make_shared<SensorModel>(*app.shown->document.model));
  scene.record(1, 250);
  EXPECT_FALSE(scene.advance());
  scene.record(2, 10);
  app.shown->run.playing = true;
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(app.get<RunAhead>().phase, RunAhead::Phase::none);
}

TEST(Remedy, GivesUpIfTheLayoutCannotBeSimulated) {
  SimulatedDocument scene;
  App& app = scene.app;
  apply_remedy(*app.ui, *app.shown, app.get<RunAhead>(), {"", SetSampling{}});
  app.shown->document.editing.problem = "too many samples";
  EXPECT_FALSE(scene.advance());
  EXPECT_EQ(app.get<RunAhead>().phase, RunAhead::Phase::none);
}

TEST(Remedy, SaysThatALayoutOfASceneCannotBeChanged) {
  SimulatedDocument scene;
  EXPECT_EQ(remedy_blocked(*scene.app.shown), "");
  scene.app.shown->run.simulates_document = false;
  EXPECT_NE(remedy_blocked(*scene.app.shown).find("belongs to the scene"), std::string::npos);
}

}  // namespace
}  // namespace taxel::ui
