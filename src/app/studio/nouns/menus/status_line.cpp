// The status line at the bottom of the window: rates, force, counts, messages.
#include "app/studio/nouns/menus/menus_state.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/messages/messages.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

void item(WindowUi& ui, Flow& flow, const char* name, const std::string& value) {
  flow.next(ImGui::CalcTextSize(name).x + 5 + ImGui::CalcTextSize(value.c_str()).x);
  ImGui::BeginGroup();
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(0, 5);
  ImGui::TextUnformatted(value.c_str());
  ImGui::EndGroup();
  ui.widgets.note_item(fmt::format("{} {}", name, value));
}

/// Draws the rates. Rates measured in real time are left out in script mode, so that frames are reproducible.
void draw_rates(WindowUi& ui, const Shown& shown, Flow& flow) {
  const Performance& p = shown.run.performance;
  if (p.is_real_time && p.is_resting) {
    flow.next(ImGui::CalcTextSize("idle").x);
    ImGui::TextDisabled("idle");
    ui.widgets.note_item("idle");
    tooltip("Nothing moves: the window is drawn again when something happens");
  } else if (p.is_real_time) {
    item(ui, flow, "fps", fmt::format("{:.0f}", p.fps));
  } else {
    item(ui, flow, "picture", "every 20 ms");
    tooltip("A script plays: from picture to picture 20 ms pass, however long the computer takes");
  }
  if (const std::string pace = pace_text(shown); !pace.empty()) item(ui, flow, "simulation", pace);
  if (p.is_real_time && p.step_seconds > 0) item(ui, flow, "step", duration_text(p.step_seconds));
}

/// Draws the force on the sensor and its polygons.
void draw_force(WindowUi& ui, Flow& flow, double force, std::size_t polygons) {
  item(ui, flow, "force", fmt::format("{:.3f} N", force));
  item(ui, flow, "polygons", grouped(static_cast<long long>(polygons)));
}

/// Draws the contact that the view displays: the probe's in LAYOUT, otherwise the simulation's.
void draw_contact(WindowUi& ui, const Viewer& viewer, const Shown& shown, Flow& flow) {
  if (viewer.mode == Mode::layout) {
    const PressedProbePtr& probe = shown.document.probe;
    if (probe && probe->problem.empty()) draw_force(ui, flow, probe->force, static_cast<std::size_t>(probe->polygons));
    return;
  }
  if (!shown.run.frame) return;
  item(ui, flow, "time", fmt::format("{:.3f} s", shown.run.frame->time));
  if (shown.run.runs_scenario) item(ui, flow, "travel", in_mm(shown.run.frame->travel, 1));
  const SensorStep* sensor = shown.sensor(viewer);
  if (sensor == nullptr) return;
  std::size_t polygons = 0;
  for (const ContactSurface& surface : sensor->surfaces) polygons += surface.polygons.size();
  draw_force(ui, flow, glm::length(sensor->force_W), polygons);
}

void draw_recording(WindowUi& ui, const RunView& run, Flow& flow) {
  if (!run.frame || !run.frame->recording.on) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
  item(ui, flow, "recording", fmt::format("{:.3f} s", run.frame->recording.seconds));
  ImGui::PopStyleColor();
}

/// Draws a note while the samples of a preview are displayed, with the progress of the polishing.
void draw_samples(WindowUi& ui, const DocumentView& document, Flow& flow) {
  const bool preview = document.model && document.model->quality == SampleQuality::preview;
  if (!preview && !document.polishing.active) return;
  std::string text = "Preview samples";
  if (document.polishing.active) text = "Polishing samples";
  if (document.polishing.fraction > 0) text += fmt::format(" {:.0f} %", 100 * document.polishing.fraction);
  flow.next(ImGui::CalcTextSize((text + "Cancel").c_str()).x + 5 + 2 * ImGui::GetStyle().FramePadding.x);
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).warning);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note_item(text);
  tooltip(document.polishing.holds_run
              ? "The run starts when its samples are polished: from then on its readings do not change"
              : "Readings are of quickly made samples, which are less even, until they are polished");
  ImGui::SameLine(0, 5);
  if (document.polishing.active) {
    if (ImGui::SmallButton("Cancel##polishing")) ui.post(CancelLoading{});
    ui.widgets.note_item("Cancel polishing");
    tooltip("Keep the preview's samples, and run with them");
  } else {
    if (ImGui::SmallButton("Polish")) ui.post(PolishSamples{});
    ui.widgets.note_item("Polish");
    tooltip("Spread the samples as evenly as possible");
  }
}

struct Counter {
  std::string text;
  ImVec4 color;
  [[nodiscard]] float width() const { return ImGui::CalcTextSize(text.c_str()).x; }
};

/// Returns the counters of messages. A counter above zero has the colour of its severity.
std::array<Counter, 3> message_counters(const WindowUi& ui, const Messages& messages) {
  const Palette& colors = palette(ui.dark);
  const auto counter = [&](const char* name, Severity severity) {
    const auto count =
        std::count_if(messages.begin(), messages.end(), [&](const Message& m) { return m.severity == severity; });
    return Counter{fmt::format("{} {}", name, count), count > 0 ? severity_color(colors, severity) : colors.dim};
  };
  return {counter("errors", Severity::error), counter("warnings", Severity::warning), counter("notes", Severity::note)};
}

/// Draws the counters of messages at the right end. A click opens the list of messages.
void draw_message_counter(WindowUi& ui, const Messages& messages, Flow& flow) {
  const std::array<Counter, 3> counters = message_counters(ui, messages);
  const float gap = ImGui::GetFontSize(), padding = ImGui::GetStyle().FramePadding.x;
  float width = 2 * padding + gap * static_cast<float>(counters.size() - 1);
  for (const Counter& counter : counters) width += counter.width();
  flow.last(width);
  ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
  if (ImGui::Button("##messages", {width, ImGui::GetTextLineHeight()})) ui.post(TogglePanel{&kMessages});
  ImGui::PopStyleColor();
  ui.widgets.note_item("Message counter");
  tooltip("Show all messages");
  at.x += padding;
  for (const Counter& counter : counters) {
    ImGui::GetWindowDrawList()->AddText(at, ImGui::GetColorU32(counter.color), counter.text.c_str());
    at.x += counter.width() + gap;
  }
}

void draw_status_line(WindowUi& ui, const Viewer& viewer, const Shown& shown, Arrangement& arrangement,
                      const Messages& messages) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 3));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).background);
  const auto rows = static_cast<float>(arrangement.status_rows);
  const float height = rows * ImGui::GetTextLineHeight() + (rows - 1) * ImGui::GetStyle().ItemSpacing.y + 9;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  if (ImGui::BeginViewportSideBar("Status", ImGui::GetMainViewport(), ImGuiDir_Down, height, kFlags)) {
    Flow flow(1.3f * ImGui::GetFontSize());
    draw_rates(ui, shown, flow);
    draw_samples(ui, shown.document, flow);
    draw_contact(ui, viewer, shown, flow);
    draw_recording(ui, shown.run, flow);
    draw_message_counter(ui, messages, flow);
    arrangement.status_rows = flow.rows();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace

std::string pace_text(const Shown& shown) {
  if (!shown.run.frame || !shown.run.frame->scene) return "";
  if (shown.document.polishing.holds_run) return "starts when polished";
  if (shown.run.frame->finished) return "ended";
  if (!shown.run.playing) return "paused";
  return shown.run.performance.is_real_time ? fmt::format("{:.2f} x real time", shown.run.performance.simulation_speed)
                                            : "";
}

constinit const Feature kStatusLine{
    .draw_bar =
        [](App& app) {
          if (app.get<WindowParts>().is_presenting) return;
          draw_status_line(*app.ui, *app.viewer, *app.shown, app.get<Arrangement>(), app.get<Messages>());
        },
};

}  // namespace taxel::ui
