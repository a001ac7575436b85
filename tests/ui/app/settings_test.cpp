// Settings: each value is kept from one start to the next, including values that are added later.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/shell/state/settings.h"
#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

using ui::Overlays;

/// Returns the settings that a window has which begins with a file of the settings of `app`.
std::string kept(ui::App& app) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "settings.json";
  write_settings(file, app);
  ui::App next;
  EXPECT_EQ(read_settings(file, next), "");
  return settings_text(next);
}

std::string usual() {
  ui::App app;
  return settings_text(app);
}

void expect_kept(ui::App& app, const std::string& what) {
  ASSERT_NE(settings_text(app), usual()) << what << " differs from its default";
  EXPECT_EQ(kept(app), settings_text(app)) << what;
}

/// Changes a value to another one.
struct Change {
  void operator()(bool* value) const { *value = !*value; }
  void operator()(float* value) const { *value += 0.375f; }
  void operator()(std::vector<std::string>* value) const { *value = {"/b", "/a"}; }
  void operator()(ui::WindowPlace* value) const { *value = {-20, 30, 900, 700, value->maximized}; }
  void operator()(Overlays* value) const { value->samples = !value->samples; }
  void operator()(GroupsShown* value) const { value->back() = !value->back(); }
  void operator()(ui::FramesShown* value) const { *value = ui::FramesShown::geoms; }
  void operator()(ui::LabelsShown* value) const { *value = ui::LabelsShown::geoms; }
};

TEST(Settings, KeepEachValue) {
  ui::App any;
  const std::size_t count = ui::saved_values(any).size();
  for (std::size_t i = 0; i < count; ++i) {
    ui::App app;
    const ui::SavedValue value = ui::saved_values(app)[i];
    std::visit(Change{}, value.value);
    expect_kept(app, value.key);
  }
}

TEST(Settings, HaveTheKeysOfTheFeatures) {
  ui::App app;
  std::set<std::string> keys;
  for (const ui::SavedValue& value : ui::saved_values(app)) EXPECT_TRUE(keys.insert(value.key).second) << value.key;
  for (const char* key : {"dark",
                          "scale",
                          "plot_relative",
                          "plot_responding_only",
                          "plot_all_sensors",
                          "samples",
                          "geom_groups",
                          "site_groups",
                          "frames",
                          "labels",
                          "simulate",
                          "panel_outliner",
                          "panel_heat",
                          "info",
                          "timeline_unfolded",
                          "tour_seen",
                          "window_place",
                          "window_maximized",
                          "recent",
                          "ranges_linked",
                          "desktop_dialog"})
    EXPECT_TRUE(keys.count(key)) << key;
}

/// Returns the bytes of Overlays that are switches. Bytes without a meaning may follow.
std::span<bool> switches(Overlays& values) {
  static_assert(sizeof(bool) == 1 && std::is_trivially_copyable_v<Overlays>);
  return {reinterpret_cast<bool*>(&values), offsetof(Overlays, site_groups) + sizeof(GroupsShown)};
}

TEST(Settings, KeepEachOverlay) {
  static_assert(sizeof(Overlays) == offsetof(Overlays, labels) + sizeof(ui::LabelsShown), "labels are the last member");
  Overlays any;
  for (std::size_t mode = 0; mode < 2; ++mode) {
    for (std::size_t i = 0; i < switches(any).size(); ++i) {
      ui::App app;
      bool& value = switches(app.viewer->mode_overlays.at(mode))[i];
      if (&value == &app.viewer->mode_overlays[0].sensor_transparent) continue;
      value = !value;
      expect_kept(app, fmt::format("overlay {}", i));
    }
    for (std::size_t i = 0; i < ui::kFramesWords.size(); ++i) {
      ui::App app;
      app.viewer->mode_overlays.at(mode).frames = static_cast<ui::FramesShown>(i);
      EXPECT_EQ(kept(app), settings_text(app)) << ui::kFramesWords.at(i);
    }
    for (std::size_t i = 0; i < ui::kLabelsWords.size(); ++i) {
      ui::App app;
      app.viewer->mode_overlays.at(mode).labels = static_cast<ui::LabelsShown>(i);
      EXPECT_EQ(kept(app), settings_text(app)) << ui::kLabelsWords.at(i);
    }
  }
}

TEST(Settings, BeginInLayoutWithAnOpaqueSkin) {
  ui::App seen, next;
  EXPECT_FALSE(seen.viewer->mode_overlays[0].sensor_transparent);
  seen.viewer->mode_overlays[0].sensor_transparent = true;
  seen.viewer->mode_overlays[1].sensor_transparent = false;
  apply_settings(settings_text(seen), next);
  EXPECT_FALSE(next.viewer->mode_overlays[0].sensor_transparent) << "X-ray ends with the program";
  EXPECT_FALSE(next.viewer->mode_overlays[1].sensor_transparent) << "SIMULATE keeps it";
  apply_settings(R"({"sensor_transparent": true})", next);
  EXPECT_FALSE(next.viewer->mode_overlays[0].sensor_transparent) << "nor is it read from older files";
}

/// A file of a version in which both modes drew the same holds every value, changed or not.
TEST(Settings, KeepChangesOfBothModesFromOlderFiles) {
  ui::App changed;
  apply_settings(R"({"samples": true, "rays": false, "taxels": false, "frames": "geoms"})", changed);
  const auto& [layout, run] = changed.viewer->mode_overlays;
  EXPECT_TRUE(layout.samples);
  EXPECT_FALSE(run.samples) << "the old default is no change";
  EXPECT_FALSE(run.rays);
  EXPECT_FALSE(run.taxels);
  EXPECT_FALSE(run.all_taxels);
  EXPECT_EQ(run.frames, ui::FramesShown::geoms);
  ui::App own;
  apply_settings(R"({"rays": false, "simulate": {"samples": true}})", own);
  EXPECT_TRUE(own.viewer->mode_overlays[1].samples);
  EXPECT_TRUE(own.viewer->mode_overlays[1].rays) << "each mode has its own";
  EXPECT_NE(apply_settings(R"({"simulate": {"samples": 3}})", own), "");
}

TEST(Settings, KeepEachPanelThatTheUserOpens) {
  for (const ui::Feature* row : ui::features()) {
    ui::App app, read;
    bool& open = app.get<ui::PanelsShown>()[*row];
    open = !open;
    apply_settings(settings_text(app), read);
    EXPECT_EQ(read.get<ui::PanelsShown>()[*row], row->opens == ui::Opens::by_user ? open : row->open) << row->title;
  }
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
  std::vector<std::string> recent;
  for (int i = 1; i <= 9; ++i) ui::remember_recent(recent, fmt::format("/{}", i));
  EXPECT_EQ(recent, (std::vector<std::string>{"/9", "/8", "/7", "/6", "/5", "/4", "/3", "/2"}));
  ui::remember_recent(recent, "/5");
  EXPECT_EQ(recent, (std::vector<std::string>{"/5", "/9", "/8", "/7", "/6", "/4", "/3", "/2"})) << "once";
}

struct Read {
  std::string settings, problem;
};

Read read_by_a_new_window(const std::filesystem::path& file) {
  ui::App app;
  const std::string problem = read_settings(file, app);
  return {settings_text(app), problem};
}

TEST(Settings, AreDefaultsWithAMessageIfTheFileIsUnreadable) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "settings.json";
  EXPECT_EQ(read_by_a_new_window(file).settings, usual()) << "no file";
  EXPECT_EQ(read_by_a_new_window(file).problem, "") << "no file";
  const std::vector<std::pair<const char*, const char*>> cases{
      {"", "is not JSON"},
      {"{", "is not JSON"},
      {"[]", "must be an object of settings"},
      {R"({"dark": 3})", "/dark: has a value that it cannot have"},
      {R"({"geom_groups": [false, 1]})", "/geom_groups: has a value that it cannot have"}};
  for (const auto& [text, problem] : cases) {
    std::ofstream(file) << text;
    EXPECT_EQ(read_by_a_new_window(file).settings, usual()) << text;
    EXPECT_EQ(read_by_a_new_window(file).problem, file.string() + ": " + problem);
  }
  ui::App light;
  light.get<ui::Appearance>().dark = false;
  std::ofstream(file) << R"({"dark": false, "geom_groups": "all", "scale": "2"})";
  EXPECT_EQ(read_by_a_new_window(file).settings, settings_text(light)) << "readable values are kept";
  EXPECT_EQ(read_by_a_new_window(file).problem, file.string() +
                                                    ": /scale: has a value that it cannot have, /geom_groups: has a "
                                                    "value that it cannot have");
  std::ofstream(file) << R"({"dark": false, "frames": "no such word", "unknown": 7})";
  EXPECT_EQ(read_by_a_new_window(file).settings, settings_text(light)) << "as a later version may write it";
  EXPECT_EQ(read_by_a_new_window(file).problem, "");
}

}  // namespace
}  // namespace taxel::studio
