#include "app/studio/frame/sensor_chooser.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>

#include "app/studio/frame/scene_filter.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

/// Draws the row of a sensor. Returns whether it was clicked.
bool draw_choice(WindowUi& ui, const SensorShown& sensor, bool selected) {
  const std::string count = fmt::format("{} taxel{}", sensor.taxels().size(), sensor.taxels().size() == 1 ? "" : "s");
  const float gap = ImGui::GetFontSize(), width = ImGui::CalcTextSize(count.c_str()).x;
  const std::string name = shortened(sensor.name, ImGui::GetContentRegionAvail().x - width - gap, 1);
  const bool clicked = ImGui::Selectable(fmt::format("{}##choice {}", name, sensor.index).c_str(), selected);
  ui.widgets.note_item("Choose " + sensor.name);
  ImGui::SameLine(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - width);
  ImGui::TextDisabled("%s", count.c_str());
  return clicked;
}

}  // namespace

std::vector<std::size_t> matching_sensors(const std::vector<SensorShown>& sensors, const std::string& filter) {
  std::vector<std::size_t> matching;
  for (std::size_t s = 0; s < sensors.size(); ++s)
    if (finds(filter, {sensors[s].name}) ||
        finds_sensor(filter, *sensors[s].scene, static_cast<std::size_t>(sensors[s].index)))
      matching.push_back(s);
  return matching;
}

void draw_sensor_chooser(WindowUi& ui, SensorChooser& chooser, Selection& selection,
                         const std::vector<SensorShown>& sensors, float width) {
  constexpr float kRows = 9, kWidth = 16;  // of the list, in heights of text
  const auto selected = std::find_if(sensors.begin(), sensors.end(),
                                     [&](const SensorShown& sensor) { return sensor.index == selection.sensor; });
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##sensor", selected == sensors.end() ? "Sensor" : selected->name.c_str());
  ui.widgets.note_item("Chosen sensor", true);
  if (!open) return tooltip("The selected sensor: choose one by its name");
  if (ImGui::IsWindowAppearing()) {
    chooser.filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  const float line = ImGui::GetFontSize();
  ImGui::SetNextItemWidth(kWidth * line);
  const bool entered =
      ImGui::InputTextWithHint("##filter", "Filter: sensor", &chooser.filter, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note_item("Filter sensors", true);
  const std::vector<std::size_t> matching = matching_sensors(sensors, chooser.filter);
  std::optional<std::size_t> chosen;
  if (entered && !matching.empty()) chosen = matching.front();
  if (ImGui::BeginChild("##sensors", {kWidth * line, kRows * ImGui::GetTextLineHeightWithSpacing()})) {
    for (const std::size_t s : matching)
      if (draw_choice(ui, sensors[s], sensors[s].index == selection.sensor)) chosen = s;
    if (matching.empty()) ImGui::TextDisabled("No sensor has this name.");
  }
  ImGui::EndChild();
  if (chosen) {
    if (sensors[*chosen].index != selection.sensor) selection = {sensors[*chosen].index, {}, selection.body};
    selection.is_sensor_chosen = true;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndCombo();
}

}  // namespace taxel::ui
