// Decisions of the panel of data sets: the order of the list, the filter, the request for rows, and the replay.
#include <gtest/gtest.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/data_set/data_set_state.h"

namespace taxel::ui {
namespace {

/// A set of three episodes of two layouts and a job that failed. The depth is changed in two of them.
OpenDataSetPtr made_set() {
  OpenDataSet set;
  set.folder = "/data";
  set.layouts = {{"Fine", Aggregate::mean, {1, 2}}, {"Coarse", Aggregate::mean, {1}}};
  set.parameters = {{"/scenario/depth", "Depth (mm)", -3}, {"/scenario/object", "object", 0}};
  const auto add = [&](std::size_t layout, const char* scenario, double peak, std::vector<ParameterValue> values) {
    EpisodeRow row;
    row.episode = static_cast<std::int64_t>(set.rows.size());
    row.layout = layout;
    row.scenario = scenario;
    row.peak = peak;
    row.seed = 100 - *row.episode;
    row.values = std::move(values);
    set.rows.push_back(row);
  };
  add(0, "press", 20, {{"10", 10}, {"\"ball.obj\"", {}}});
  add(1, "slide", 30, {{"9", 9}, {}});
  add(0, "press", 10, {{}, {}});
  EpisodeRow failed;
  failed.error = "The simulation became unstable";
  failed.values = {{"8", 8}, {}};
  set.rows.push_back(failed);
  set.failed = 1;
  return std::make_shared<const OpenDataSet>(set);
}

DataSetState made_state() {
  DataSetState state;
  show_data_set(state, made_set(), nullptr);
  update_episode_list(state);
  return state;
}

std::vector<std::size_t> listed(DataSetState& state, EpisodeColumnId column, std::size_t parameter, bool descending) {
  state.order = {column, parameter, descending, ""};
  update_episode_list(state);
  return state.list.rows;
}

using Rows = std::vector<std::size_t>;

TEST(EpisodeList, IsSortedByNumbersAndTextsWithMissingValuesLast) {
  DataSetState state = made_state();
  EXPECT_EQ(state.list.rows, (Rows{0, 1, 2, 3}));
  EXPECT_EQ(listed(state, EpisodeColumnId::peak, 0, false), (Rows{2, 0, 1, 3}));
  EXPECT_EQ(listed(state, EpisodeColumnId::peak, 0, true), (Rows{1, 0, 2, 3})) << "the failed job has no peak";
  EXPECT_EQ(listed(state, EpisodeColumnId::layout, 0, false), (Rows{1, 0, 2, 3}));
  EXPECT_EQ(listed(state, EpisodeColumnId::seed, 0, false), (Rows{2, 1, 0, 3}));
  EXPECT_EQ(listed(state, EpisodeColumnId::parameter, 0, false), (Rows{3, 1, 0, 2})) << "8 < 9 < 10";
  EXPECT_EQ(listed(state, EpisodeColumnId::parameter, 0, true), (Rows{0, 1, 3, 2}));
  EXPECT_EQ(listed(state, EpisodeColumnId::parameter, 1, true), (Rows{0, 1, 2, 3}));
}

TEST(EpisodeList, HasTheRowsWithAllWordsOfTheFilter) {
  const OpenDataSetPtr set = made_set();
  const auto passing = [&](const std::string& filter) {
    Rows rows;
    for (std::size_t i = 0; i < set->rows.size(); ++i)
      if (passes_filter(*set, set->rows[i], filter)) rows.push_back(i);
    return rows;
  };
  EXPECT_EQ(passing(""), (Rows{0, 1, 2, 3}));
  EXPECT_EQ(passing("PRESS"), (Rows{0, 2}));
  EXPECT_EQ(passing("press ball"), (Rows{0}));
  EXPECT_EQ(passing("coarse"), (Rows{1}));
  EXPECT_EQ(passing("failed"), (Rows{3}));
  EXPECT_EQ(passing("unstable"), (Rows{3}));
  EXPECT_EQ(passing("twist"), (Rows{}));
}

TEST(EpisodeList, KeepsTheSetIfAnotherCannotBeRead) {
  DataSetState state = made_state();
  state.chosen = 2;
  OpenDataSet broken;
  broken.folder = "/other";
  broken.problem = "/other/meta/info.json: no such file";
  show_data_set(state, std::make_shared<const OpenDataSet>(broken), nullptr);
  EXPECT_EQ(state.set->folder, "/data");
  EXPECT_EQ(state.chosen, 2U);
  show_data_set(state, made_set(), nullptr);
  EXPECT_EQ(state.chosen, 0U) << "the first episode of the new set";
}

TEST(EpisodeList, RequestsTheRowsOfAnEpisodeButNotOfAFailedJob) {
  DataSetState state = made_state();
  state.chosen = 2;
  ASSERT_TRUE(episode_request(state));
  EXPECT_EQ(episode_request(state)->choice, (studio::EpisodeChoice{"/data", 2}));
  state.chosen = 3;
  EXPECT_FALSE(episode_request(state));
  state.chosen.reset();
  EXPECT_FALSE(episode_request(state));
  EXPECT_FALSE(episode_request(DataSetState{}));
}

/// A run of two rows that repeats an episode.
struct ReplayedRun {
  ReplayedRun() {
    auto episode = std::make_shared<studio::ReplayedEpisode>();
    episode->from = {"/data", 5};
    episode->program = "taxel 9";
    episode->bits = 64;
    episode->rows = {
        2,
        {{kTimestamp, 1, false, {0.1, 0.2}}, {kTravel, 1, false, {0, 0.001}}, {kTactile, 1, true, {5000, 6000}}},
        {}};
    state.replayed = episode;
    auto model = std::make_shared<SensorModel>();
    model->layout.taxels.push_back({7, "", {}, {}, 0.001, {}});
    shown.document.model = model;
    shown.run.simulates_document = shown.run.runs_scenario = true;
    show({{0.1, 0, {5000}}}, false);
  }
  void show(std::vector<TraceRow> rows, bool is_finished) {
    auto frame = std::make_shared<SimFrame>();
    frame->trace = std::make_shared<const Trace>(Trace{std::move(rows), 1});
    frame->finished = is_finished;
    shown.run.frame = frame;
    follow_replay(shown, state);
  }
  [[nodiscard]] std::string text() const { return replay_text(shown, state); }

  Shown shown;
  DataSetState state;
};

TEST(Replay, IsEqualOnceAllRowsAreEqual) {
  ReplayedRun run;
  EXPECT_EQ(run.text(), "Replay of episode 5: 1 of 2 rows, all equal so far.");
  run.show({{0.1, 0, {5000}}, {0.2, 0.001, {6000}}}, true);
  EXPECT_EQ(replay_verdict(run.shown, run.state), ReplayVerdict::equal);
  EXPECT_EQ(run.text(),
            "The replay equals episode 5 bit for bit: readings, times and travels of 2 rows. Largest difference 0.");
}

TEST(Replay, SaysTheLargestDifferenceWithItsUnitAndPlace) {
  ReplayedRun run;
  run.show({{0.1, 0, {5000}}, {0.2, 0.001, {6001.5}}}, true);
  EXPECT_EQ(replay_verdict(run.shown, run.state), ReplayVerdict::different);
  EXPECT_EQ(run.text(),
            "The replay differs from episode 5 in 1 of 2 rows; the largest difference of a reading is 0.0015 kPa "
            "(taxel 7 at 0.2 s). The data set was written by taxel 9; other versions may give other bits.");
}

TEST(Replay, DiffersIfItHasFewerRows) {
  ReplayedRun run;
  run.show({{0.1, 0, {5000}}}, true);
  EXPECT_EQ(replay_verdict(run.shown, run.state), ReplayVerdict::different);
  EXPECT_NE(run.text().find("it has 1 rows, the episode has 2"), std::string::npos) << run.text();
}

TEST(Replay, IsNotComparedAfterAnEditOrInAnotherScenario) {
  ReplayedRun run;
  run.shown.document.editing.undo_depth = 1;
  const ReplayCheck before = run.state.check;
  run.show({{0.1, 0, {5000}}, {0.2, 0.001, {9999}}}, true);
  EXPECT_EQ(run.state.check, before);
  EXPECT_EQ(replay_verdict(run.shown, run.state), ReplayVerdict::edited);
  EXPECT_NE(run.text().find("the document was edited"), std::string::npos);
  run.shown.document.editing.undo_depth = 0;
  run.shown.run.scenario.timestep = 0.002;
  follow_replay(run.shown, run.state);
  EXPECT_EQ(run.state.check, before);
  EXPECT_EQ(run.text(), "");
  run.state.replayed.reset();
  follow_replay(run.shown, run.state);
  EXPECT_EQ(run.state.check, ReplayCheck{});
}

}  // namespace
}  // namespace taxel::ui
