#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/studio/app/dump/settings.h"
#include "app/studio/app/overlays.h"
#include "app/studio/app/panels.h"
#include "app/studio/app/values/app_parts.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/user_folders.h"
#include "core/base/text/shown_message.h"

namespace taxel::ui {

namespace {

/// A word that is not among them leaves the value as it is.
template <class Words, class Value>
void read_word(const nlohmann::ordered_json& json, const Words& words, Value& value) {
  const auto found = std::find(words.begin(), words.end(), json.get<std::string>());
  if (found != words.end()) value = static_cast<Value>(found - words.begin());
}

/// Calls visit(key, value&) for everything that the view draws on request.
template <class Drawn, class Visit>
void visit_overlays(Drawn& drawn, const Visit& visit) {
  for (const OverlaySpec& overlay : overlays()) visit(overlay.key, drawn.*overlay.on);
  visit("geom_groups", drawn.geom_groups);
  visit("site_groups", drawn.site_groups);
  visit("frames", drawn.frames);
  visit("labels", drawn.labels);
}

}  // namespace

void to_json(nlohmann::ordered_json& json, FramesShown shown) {
  json = to_word(shown);
}
void from_json(const nlohmann::ordered_json& json, FramesShown& shown) {
  read_word(json, kFramesWords, shown);
}
void to_json(nlohmann::ordered_json& json, LabelsShown shown) {
  json = to_word(shown);
}
void from_json(const nlohmann::ordered_json& json, LabelsShown& shown) {
  read_word(json, kLabelsWords, shown);
}
void to_json(nlohmann::ordered_json& json, const Overlays& drawn) {
  json = nlohmann::ordered_json::object();
  visit_overlays(drawn, [&](const char* key, const auto& value) { json[key] = value; });
}
/// Overlays that are missing stay as they are.
void from_json(const nlohmann::ordered_json& json, Overlays& drawn) {
  visit_overlays(drawn, [&](const char* key, auto& value) {
    if (json.contains(key)) json.at(key).get_to(value);
  });
}

}  // namespace taxel::ui

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRecent = 8;

/// Calls visit(key, value&) for everything that is kept: reading and writing walk the same list.
template <class Saved, class Visit>
void visit_settings(Saved& s, const Visit& visit) {
  visit("dark", s.dark);
  visit("scale", s.scale);
  visit("plot_relative", s.plot.relative);
  visit("plot_responding_only", s.plot.responding_only);
  visit("plot_all_sensors", s.plot.all_sensors);
  ui::visit_overlays(s.overlays, visit);
  visit("simulate", s.run_overlays);
  for (const ui::PanelSpec& panel : ui::panels())
    if (panel.shown != nullptr) visit(panel.key, s.panels.at(panel.key));
  visit("info", s.panels.at("info"));
  visit("timeline_unfolded", s.timeline_unfolded);
  visit("tour_seen", s.tour_seen);
  visit("window_place", s.window_place);
  visit("window_maximized", s.window_maximized);
  visit("recent", s.recent);
  visit("ranges_linked", s.ranges_linked);
  visit("desktop_dialog", s.desktop_dialog);
}

}  // namespace

std::filesystem::path settings_folder() {
  return os::config_folder() / "taxelstudio";
}

std::filesystem::path state_folder() {
  return os::state_folder() / "taxelstudio";
}

namespace {

/// Returns whether each panel with a key is open, and "info", by key.
std::map<std::string, bool> open_panels(const ui::App& app) {
  std::map<std::string, bool> open{{"info", ui::is_open(ui::info_switch, app)}};
  for (const ui::PanelSpec& panel : ui::panels())
    if (panel.shown != nullptr) open[panel.key] = ui::is_open(panel.shown, app);
  return open;
}

}  // namespace

std::map<std::string, bool> panels_at_first() {
  return open_panels({});
}

SavedState saved_state(const ui::App& app) {
  const ui::WindowFeatures& window = *app.window;
  const auto& [layout, run] = app.viewer->mode_overlays;
  const ui::WindowPlace& place = window.place;
  return {window.appearance.dark,
          window.appearance.scale,
          layout,
          run,
          open_panels(app),
          app.simulate->plot.options,
          window.tour.seen,
          app.simulate->timeline.unfolded,
          {place.x, place.y, place.width, place.height},
          place.maximized,
          window.recent,
          app.viewer->readings.linked,
          window.dialog.prefers_desktop};
}

void apply_saved(const SavedState& saved, ui::App& app) {
  app.window->appearance = {saved.dark, saved.scale};
  app.viewer->mode_overlays = {saved.overlays, saved.run_overlays};
  for (const ui::PanelSpec& panel : ui::panels())
    if (panel.shown != nullptr) panel.shown(app) = saved.panels.at(panel.key);
  ui::info_switch(app) = saved.panels.at("info");
  app.simulate->plot.options = saved.plot;
  const std::array<int, 4>& at = saved.window_place;
  app.window->place = {at[0], at[1], at[2], at[3], saved.window_maximized};
  app.window->tour.seen = saved.tour_seen;
  app.simulate->timeline.unfolded = saved.timeline_unfolded;
  app.window->recent = saved.recent;
  app.viewer->readings.linked = saved.ranges_linked;
  app.window->dialog.prefers_desktop = saved.desktop_dialog;
}

ReadSettings read_settings(const std::filesystem::path& file) {
  ReadSettings read;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return read;
  try {
    read = parse_settings(read_file(file));
  } catch (const Error& error) {
    read.problem = shown_message(error);
    return read;
  }
  if (!read.problem.empty()) read.problem = file.string() + ": " + read.problem;
  return read;
}

namespace {

/// Copies changes by the user to SIMULATE, for files of versions in which both modes drew the same.
void take_over_changes(SavedState& saved) {
  const ui::Overlays usual;
  ui::Overlays& run = saved.run_overlays;
  for (const ui::OverlaySpec& overlay : ui::overlays())
    if (saved.overlays.*overlay.on != usual.*overlay.on) run.*overlay.on = saved.overlays.*overlay.on;
  run.geom_groups = saved.overlays.geom_groups;
  run.site_groups = saved.overlays.site_groups;
  run.frames = saved.overlays.frames;
  run.labels = saved.overlays.labels;
}

}  // namespace

ReadSettings parse_settings(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return {{}, json.is_discarded() ? "is not JSON" : "must be an object of settings"};
  ReadSettings read;
  visit_settings(read.saved, [&](const char* key, auto& value) {
    if (!json.contains(key)) return;
    try {
      auto kept = value;
      json.at(key).get_to(kept);
      value = std::move(kept);
    } catch (const Json::exception&) {
      read.problem += fmt::format("{}/{}: has a value that it cannot have", read.problem.empty() ? "" : ", ", key);
    }
  });
  if (!json.contains("simulate")) take_over_changes(read.saved);
  return read;
}

std::string settings_text(const SavedState& saved) {
  Json json = Json::object();
  visit_settings(saved, [&](const char* key, const auto& value) { json[key] = value; });
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_settings(const std::filesystem::path& file, const SavedState& saved) {
  make_folder(file.parent_path());
  write_file_atomically(file, settings_text(saved));
}

void remember_recent(std::vector<std::string>& recent, const std::string& file) {
  std::erase(recent, file);
  recent.insert(recent.begin(), file);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

}  // namespace taxel::studio
