// Settings: each value is kept from one start to the next, including values that are added later.
#include "app/studio/app/dump/settings.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <span>

#include "app/studio/app/values/app_parts.h"
#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

using ui::Overlays;
using ui::PanelsShown;
using ui::PlotOptions;

SavedState written_and_read(const SavedState& saved) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "settings.json";
  write_settings(file, saved);
  return read_settings(file).saved;
}

/// Returns the bytes of a struct that consists of bools.
template <class Struct>
std::span<bool> switches(Struct& values) {
  static_assert(sizeof(bool) == 1 && std::is_trivially_copyable_v<Struct>);
  return {reinterpret_cast<bool*>(&values), sizeof(Struct)};
}

/// Number of bools at the beginning of Overlays. Bytes without a meaning may follow.
constexpr std::size_t kSwitches = offsetof(Overlays, site_groups) + sizeof(GroupsShown);

/// Returns all values as text, so that two states are compared as a whole. A new member of SavedState makes this
/// function fail to compile: add the member to this list and to the tests below.
std::string all_values(SavedState saved) {
  auto& [dark, scale, overlays, run_overlays, panels, plot, tour_seen, unfolded, place, maximized, recent,
         ranges_linked, desktop_dialog] = saved;
  std::string text = fmt::format("{} {} {} {} {} {} ", dark, scale, tour_seen, unfolded, ranges_linked, desktop_dialog);
  for (Overlays* drawn : {&overlays, &run_overlays}) {
    text += fmt::format("{} {} ", static_cast<int>(drawn->frames), static_cast<int>(drawn->labels));
    for (const bool on : switches(*drawn).first(kSwitches)) text += on ? '1' : '0';
  }
  for (const auto& [key, on] : panels) text += on ? '1' : '0';
  for (const bool on : switches(plot)) text += on ? '1' : '0';
  for (const std::string& file : recent) text += " " + file;
  return text + fmt::format(" {} {} {} {} {}", place[0], place[1], place[2], place[3], maximized);
}

void expect_kept(const SavedState& saved, const std::string& what) {
  ASSERT_NE(all_values(saved), all_values(SavedState{})) << what << " differs from its default";
  EXPECT_EQ(all_values(written_and_read(saved)), all_values(saved)) << what;
}

TEST(Settings, KeepEachOverlay) {
  static_assert(sizeof(Overlays) == offsetof(Overlays, labels) + sizeof(ui::LabelsShown), "labels are the last member");
  for (Overlays SavedState::*drawn : {&SavedState::overlays, &SavedState::run_overlays}) {
    for (std::size_t i = 0; i < kSwitches; ++i) {
      SavedState saved;
      bool& value = switches(saved.*drawn)[i];
      value = !value;
      expect_kept(saved, fmt::format("overlay {}", i));
    }
    for (std::size_t i = 1; i < ui::kFramesWords.size(); ++i) {
      SavedState saved;
      (saved.*drawn).frames = static_cast<ui::FramesShown>(i);
      expect_kept(saved, "frames");
    }
    for (std::size_t i = 1; i < ui::kLabelsWords.size(); ++i) {
      SavedState saved;
      (saved.*drawn).labels = static_cast<ui::LabelsShown>(i);
      expect_kept(saved, "labels");
    }
  }
}

/// A file of a version in which both modes drew the same holds every value, changed or not.
TEST(Settings, KeepChangesOfBothModesFromOlderFiles) {
  const SavedState changed =
      parse_settings(R"({"samples": true, "rays": false, "taxels": false, "frames": "geoms"})").saved;
  EXPECT_TRUE(changed.overlays.samples);
  EXPECT_FALSE(changed.run_overlays.samples) << "the old default is no change";
  EXPECT_FALSE(changed.run_overlays.rays);
  EXPECT_FALSE(changed.run_overlays.taxels);
  EXPECT_FALSE(changed.run_overlays.all_taxels);
  EXPECT_EQ(changed.run_overlays.frames, ui::FramesShown::geoms);
  const SavedState own = parse_settings(R"({"rays": false, "simulate": {"samples": true}})").saved;
  EXPECT_TRUE(own.run_overlays.samples);
  EXPECT_TRUE(own.run_overlays.rays) << "each mode has its own";
  EXPECT_NE(parse_settings(R"({"simulate": {"samples": 3}})").problem, "");
}

TEST(Settings, KeepEachPanelButHelp) {
  for (std::size_t i = 0; i < sizeof(PanelsShown); ++i) {
    ui::App app, read;
    bool& value = switches(app.window->panels)[i];
    value = !value;
    const SavedState saved = saved_state(app);
    if (i == offsetof(PanelsShown, help)) {
      apply_saved(written_and_read(saved), read);
      EXPECT_FALSE(read.window->panels.help) << "help closes with the window";
    } else {
      expect_kept(saved, fmt::format("panel {}", i));
      apply_saved(saved, read);
      EXPECT_EQ(switches(read.window->panels)[i], value) << i;
    }
  }
}

TEST(Settings, KeepAllOtherValues) {
  for (std::size_t i = 0; i < sizeof(PlotOptions); ++i) {
    SavedState saved;
    bool& value = switches(saved.plot)[i];
    value = !value;
    expect_kept(saved, fmt::format("plot option {}", i));
  }
  SavedState saved;
  saved.dark = !saved.dark;
  expect_kept(saved, "dark");
  saved = {};
  saved.scale = 1.375f;
  expect_kept(saved, "scale");
  saved = {};
  saved.tour_seen = !saved.tour_seen;
  expect_kept(saved, "tour_seen");
  saved = {};
  saved.ranges_linked = !saved.ranges_linked;
  expect_kept(saved, "ranges_linked");
  saved = {};
  saved.desktop_dialog = !saved.desktop_dialog;
  expect_kept(saved, "desktop_dialog");
  saved = {};
  saved.timeline_unfolded = !saved.timeline_unfolded;
  expect_kept(saved, "timeline_unfolded");
  saved = {};
  saved.window_place = {-20, 30, 900, 700};
  expect_kept(saved, "window_place");
  saved = {};
  saved.window_maximized = true;
  expect_kept(saved, "window_maximized");
  saved = {};
  saved.recent = {"/b", "/a"};
  expect_kept(saved, "recent");
}

TEST(WindowPlace, IsKeptIfAScreenShowsIt) {
  using ui::visible_place, ui::WindowPlace;
  const std::vector<WindowPlace> screens{{0, 0, 1400, 900}, {1400, 0, 1920, 1080}};
  EXPECT_EQ(visible_place({100, 50, 900, 700}, screens), (WindowPlace{100, 50, 900, 700}));
  EXPECT_EQ(visible_place({1500, 50, 1000, 700, true}, screens), (WindowPlace{1500, 50, 1000, 700, true}));
  EXPECT_EQ(visible_place({-300, -40, 900, 700}, screens), (WindowPlace{0, 0, 900, 700})) << "moved inside";
  EXPECT_EQ(visible_place({0, 0, 4000, 3000}, std::span(screens).first(1)), (WindowPlace{0, 0, 1400, 900}));
  EXPECT_EQ(visible_place({5000, 50, 900, 700}, screens), WindowPlace{}) << "its screen is gone";
  EXPECT_EQ(visible_place({0, 0, 0, 0}, screens), WindowPlace{}) << "never kept";
  EXPECT_EQ(visible_place({2147483647, 2147483647, 2147483647, 2147483647}, screens), WindowPlace{});
  EXPECT_EQ(visible_place({100, 50, 900, 700}, {}), WindowPlace{});
}

TEST(Settings, RememberEightRecentFilesNewestFirst) {
  SavedState saved;
  for (int i = 1; i <= 9; ++i) remember_recent(saved.recent, fmt::format("/{}", i));
  EXPECT_EQ(saved.recent, (std::vector<std::string>{"/9", "/8", "/7", "/6", "/5", "/4", "/3", "/2"}));
  remember_recent(saved.recent, "/5");
  EXPECT_EQ(saved.recent, (std::vector<std::string>{"/5", "/9", "/8", "/7", "/6", "/4", "/3", "/2"})) << "once";
}

TEST(Settings, AreDefaultsWithAMessageIfTheFileIsUnreadable) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "settings.json";
  EXPECT_EQ(all_values(read_settings(file).saved), all_values({})) << "no file";
  EXPECT_EQ(read_settings(file).problem, "") << "no file";
  const std::vector<std::pair<const char*, const char*>> cases{
      {"", "is not JSON"},
      {"{", "is not JSON"},
      {"[]", "must be an object of settings"},
      {R"({"dark": 3})", "/dark: has a value that it cannot have"},
      {R"({"geom_groups": [false, 1]})", "/geom_groups: has a value that it cannot have"}};
  for (const auto& [text, problem] : cases) {
    std::ofstream(file) << text;
    EXPECT_EQ(all_values(read_settings(file).saved), all_values({})) << text;
    EXPECT_EQ(read_settings(file).problem, file.string() + ": " + problem);
  }
  SavedState light;
  light.dark = false;
  std::ofstream(file) << R"({"dark": false, "geom_groups": "all", "scale": "2"})";
  EXPECT_EQ(all_values(read_settings(file).saved), all_values(light)) << "readable values are kept";
  EXPECT_EQ(read_settings(file).problem, file.string() +
                                             ": /scale: has a value that it cannot have, /geom_groups: has a "
                                             "value that it cannot have");
  std::ofstream(file) << R"({"dark": false, "frames": "no such word", "unknown": 7})";
  EXPECT_EQ(all_values(read_settings(file).saved), all_values(light)) << "as a later version may write it";
  EXPECT_EQ(read_settings(file).problem, "");
}

}  // namespace
}  // namespace taxel::studio
