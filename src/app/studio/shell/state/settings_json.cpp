// The settings file.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/shell/state/settings.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/file.h"
#include "core/base/text/message.h"

namespace taxel::ui {

namespace {

constexpr std::string_view kXRayKey = "sensor_transparent";

/// A word that is not among them leaves the value as it is.
template <class Words, class Value>
void read_word(const nlohmann::ordered_json& json, const Words& words, Value& value) {
  const auto found = std::find(words.begin(), words.end(), json.get<std::string>());
  if (found != words.end()) value = static_cast<Value>(found - words.begin());
}

/// Returns everything that the view draws on request.
std::vector<SavedValue> saved_overlays(Overlays& drawn) {
  std::vector<SavedValue> values;
  for (const OverlaySpec& overlay : overlays()) values.push_back({overlay.key, &(drawn.*overlay.on)});
  values.push_back({"geom_groups", &drawn.geom_groups});
  values.push_back({"site_groups", &drawn.site_groups});
  values.push_back({"frames", &drawn.frames});
  values.push_back({"labels", &drawn.labels});
  return values;
}

/// Returns the overlays of LAYOUT that the settings file keeps: all but X-ray, for every start begins with an opaque
/// skin.
std::vector<SavedValue> saved_overlays_of_layout(Overlays& drawn) {
  std::vector<SavedValue> values = saved_overlays(drawn);
  std::erase_if(values, [](const SavedValue& saved) { return saved.key == kXRayKey; });
  return values;
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
void to_json(nlohmann::ordered_json& json, const WindowPlace& place) {
  json = {place.x, place.y, place.width, place.height};
}
void from_json(const nlohmann::ordered_json& json, WindowPlace& place) {
  const auto at = json.get<std::array<int, 4>>();
  place = {at[0], at[1], at[2], at[3], place.maximized};
}
void to_json(nlohmann::ordered_json& json, Overlays drawn) {
  json = nlohmann::ordered_json::object();
  for (const SavedValue& saved : saved_overlays(drawn))
    std::visit([&](const auto* value) { json[saved.key] = *value; }, saved.value);
}
/// Overlays that are missing stay as they are.
void from_json(const nlohmann::ordered_json& json, Overlays& drawn) {
  for (const SavedValue& saved : saved_overlays(drawn))
    if (json.contains(saved.key)) std::visit([&](auto* value) { json.at(saved.key).get_to(*value); }, saved.value);
}

std::vector<SavedValue> saved_values(App& app) {
  WindowPlace& place = app.get<WindowState>().place;
  std::vector<SavedValue> values{{"dark", &app.get<Appearance>().dark}, {"scale", &app.get<Appearance>().scale}};
  for (SavedValue& overlay : saved_overlays_of_layout(app.viewer->mode_overlays[0]))
    values.push_back(std::move(overlay));
  values.push_back({"simulate", &app.viewer->mode_overlays[1]});
  values.push_back({"ranges_linked", &app.viewer->readings.linked});
  values.push_back({"window_place", &place});
  values.push_back({"window_maximized", &place.maximized});
  for (const Feature* row : features()) {
    if (row->opens == Opens::by_user) {
      values.push_back({row->key, &app.get<PanelsShown>().in(false, *row)});
      values.push_back({std::string("analyse_") + row->key, &app.get<PanelsShown>().in(true, *row)});
    }
    if (row->saved == nullptr) continue;
    for (SavedValue& value : row->saved(app)) values.push_back(std::move(value));
  }
  return values;
}

}  // namespace taxel::ui

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

/// Copies changes by the user to SIMULATE, for files of versions in which both modes drew the same.
void take_over_changes(const Json& json, ui::App& app) {
  const ui::Overlays usual;
  auto& [layout, run] = app.viewer->mode_overlays;
  for (const ui::OverlaySpec& overlay : ui::overlays())
    if (overlay.key != ui::kXRayKey && json.contains(overlay.key) && layout.*overlay.on != usual.*overlay.on)
      run.*overlay.on = layout.*overlay.on;
  run.geom_groups = layout.geom_groups;
  run.site_groups = layout.site_groups;
  run.frames = layout.frames;
  run.labels = layout.labels;
}

}  // namespace

std::filesystem::path settings_folder() {
  return os::config_folder() / "taxelstudio";
}

std::filesystem::path state_folder() {
  return os::state_folder() / "taxelstudio";
}

std::string read_settings(const std::filesystem::path& file, ui::App& app) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return "";
  try {
    const std::string problem = apply_settings(read_file(file), app);
    return problem.empty() ? "" : file.string() + ": " + problem;
  } catch (const Error& error) {
    return shown_message(error);
  }
}

std::string apply_settings(const std::string& text, ui::App& app) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return json.is_discarded() ? "is not JSON" : "must be an object of settings";
  std::string problem;
  for (const ui::SavedValue& saved : ui::saved_values(app)) {
    if (!json.contains(saved.key)) continue;
    try {
      std::visit(
          [&](auto* value) {
            auto kept = *value;
            json.at(saved.key).get_to(kept);
            *value = std::move(kept);
          },
          saved.value);
    } catch (const Json::exception&) {
      problem += fmt::format("{}/{}: has a value that it cannot have", problem.empty() ? "" : ", ", saved.key);
    }
  }
  if (!json.contains("simulate")) take_over_changes(json, app);
  return problem;
}

std::string settings_text(ui::App& app) {
  Json json = Json::object();
  for (const ui::SavedValue& saved : ui::saved_values(app))
    std::visit([&](const auto* value) { json[saved.key] = *value; }, saved.value);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_settings(const std::filesystem::path& file, ui::App& app) {
  make_folder(file.parent_path());
  write_file_atomically(file, settings_text(app));
}

}  // namespace taxel::studio
