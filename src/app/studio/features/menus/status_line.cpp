#include "app/studio/features/menus/status_line.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/studio/app/perform.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/flow.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

void item(UiState& ui, Flow& flow, const char* name, const std::string& value) {
  flow.next(ImGui::CalcTextSize(name).x + 5 + ImGui::CalcTextSize(value.c_str()).x);
  ImGui::BeginGroup();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(0, 5);
  ImGui::TextUnformatted(value.c_str());
  ImGui::EndGroup();
  ui.widgets.note_item(fmt::format("{} {}", name, value));
}

/// Rates of the clock stay out of pictures that follow a script: those are the same every time.
void draw_rates(UiState& ui, const UiInput& input, Flow& flow) {
  const Performance& p = input.performance;
  if (p.by_clock) {
    item(ui, flow, "fps", fmt::format("{:.0f}", p.fps));
  } else {
    item(ui, flow, "pictures", "frame by frame");
  }
  if (const std::string pace = pace_text(input); !pace.empty()) item(ui, flow, "simulation", pace);
  if (p.by_clock && p.step_seconds > 0) item(ui, flow, "step", duration_text(p.step_seconds));
}

void draw_contact(UiState& ui, const UiInput& input, Flow& flow) {
  if (!input.frame) return;
  item(ui, flow, "time", fmt::format("{:.3f} s", input.frame->time));
  if (input.runs_scenario) item(ui, flow, "travel", in_mm(input.frame->travel, 1));
  const SensorStep* sensor = input.sensor(ui);
  if (sensor == nullptr) return;
  std::size_t polygons = 0;
  for (const ContactSurface& surface : sensor->surfaces) polygons += surface.polygons.size();
  item(ui, flow, "force", fmt::format("{:.3f} N", glm::length(sensor->force_W)));
  item(ui, flow, "polygons", grouped(static_cast<long long>(polygons)));
}

void draw_recording(UiState& ui, const UiInput& input, Flow& flow) {
  if (!input.frame || !input.frame->recording.on) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
  item(ui, flow, "recording", fmt::format("{:.3f} s", input.frame->recording.seconds));
  ImGui::PopStyleColor();
}

/// Tells while a preview's samples are shown, and what happens to them.
void draw_samples(UiState& ui, const UiInput& input, Flow& flow) {
  const bool preview = input.model && input.model->quality == SampleQuality::preview;
  if (!preview && !input.polishing.active) return;
  std::string text = "Preview samples";
  if (input.polishing.active) text = "Polishing samples";
  if (input.polishing.fraction > 0) text += fmt::format(" {:.0f} %", 100 * input.polishing.fraction);
  flow.next(ImGui::CalcTextSize((text + "Cancel").c_str()).x + 5 + 2 * ImGui::GetStyle().FramePadding.x);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).warning);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note_item(text);
  tooltip(input.polishing.holds_run
              ? "The run starts when its samples are polished: from then on its readings do not change"
              : "Readings are of quickly made samples, which are less even, until they are polished");
  ImGui::SameLine(0, 5);
  if (input.polishing.active) {
    if (ImGui::SmallButton("Cancel##polishing")) ui.ask(CancelLoading{});
    ui.widgets.note_item("Cancel polishing");
    tooltip("Keep the preview's samples, and run with them");
  } else {
    if (ImGui::SmallButton("Polish")) ui.ask(PolishSamples{});
    ui.widgets.note_item("Polish");
    tooltip("Spread the samples as evenly as possible");
  }
}

struct Counter {
  std::string text;
  ImVec4 color;
  [[nodiscard]] float width() const { return ImGui::CalcTextSize(text.c_str()).x; }
};

/// Each in its own colour once there is one.
std::array<Counter, 3> message_counters(const UiState& ui) {
  const Palette& colors = palette(ui.dark);
  const auto counter = [&](const char* name, Severity severity) {
    const auto count =
        std::count_if(ui.messages.begin(), ui.messages.end(), [&](const Message& m) { return m.severity == severity; });
    return Counter{fmt::format("{} {}", name, count), count > 0 ? severity_color(colors, severity) : colors.dim};
  };
  return {counter("errors", Severity::error), counter("warnings", Severity::warning), counter("notes", Severity::note)};
}

/// Counters at the right end; a click opens the list.
void draw_message_counter(UiState& ui, const UiInput& input, Flow& flow) {
  const std::array<Counter, 3> counters = message_counters(ui);
  const float gap = ImGui::GetFontSize(), padding = ImGui::GetStyle().FramePadding.x;
  float width = 2 * padding + gap * static_cast<float>(counters.size() - 1);
  for (const Counter& counter : counters) width += counter.width();
  flow.last(width);
  ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  if (ImGui::Button("##messages", {width, ImGui::GetTextLineHeight()}))
    perform(TogglePanel{&PanelsShown::messages}, ui, input);
  ImGui::PopStyleColor();
  ui.widgets.note_item("Message counter");
  tooltip("Show all messages");
  at.x += padding;
  for (const Counter& counter : counters) {
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(counter.color), counter.text.c_str());
    at.x += counter.width() + gap;
  }
}

}  // namespace

std::string pace_text(const UiInput& input) {
  if (!input.frame || !input.frame->scene) return "";
  if (input.polishing.holds_run) return "starts when polished";
  if (input.frame->finished) return "ended";
  if (!input.playing) return "paused";
  return input.performance.by_clock ? fmt::format("{:.2f} x real time", input.performance.simulation_speed) : "";
}

void draw_status_line(UiState& ui, const UiInput& input) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 3));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).background);
  const auto rows = static_cast<float>(ui.status_rows);
  const float height = rows * ImGui::GetTextLineHeight() + (rows - 1) * ImGui::GetStyle().ItemSpacing.y + 9;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  if (ImGui::BeginViewportSideBar("Status", ImGui::GetMainViewport(), ImGuiDir_Down, height, kFlags)) {
    Flow flow(1.3f * ImGui::GetFontSize());
    draw_rates(ui, input, flow);
    draw_samples(ui, input, flow);
    draw_contact(ui, input, flow);
    draw_recording(ui, input, flow);
    draw_message_counter(ui, input, flow);
    ui.status_rows = flow.rows();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace taxel::ui
