// The status line at the bottom of the window: rates, force, counts, messages.
#include "app/studio/nouns/menus/menus_state.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
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

/// Importance of a part of the line: the least important parts are left out if not all fit into one row.
enum class StatusRank { recording, samples, pace, force, time, travel, counters, polygons, step, rate };

/// A part of the line. Its room is that of its widest usual text, so that parts do not come and go with their digits.
struct StatusPart {
  StatusRank rank = StatusRank::rate;
  float room = 0;  ///< [pixels]
  std::function<void()> draw;
};

float status_width(const std::string& text) {
  return ImGui::CalcTextSize(text.c_str()).x;
}

constexpr float kNameGap = 5;  // between the name of a value and the value [pixels]

/// Returns a name with a value, which is as wide as `usual` at most, or wider for once.
StatusPart status_item(WindowUi& ui, StatusRank rank, const char* name, const std::string& value, const char* usual) {
  const float room = status_width(name) + kNameGap + std::max(status_width(value), status_width(usual));
  return {rank, room, [&ui, name, value] {
            ImGui::BeginGroup();
            ImGui::TextDisabled("%s", name);
            ImGui::SameLine(0, kNameGap);
            ImGui::TextUnformatted(value.c_str());
            ImGui::EndGroup();
            ui.widgets.note_item(fmt::format("{} {}", name, value));
          }};
}

/// Adds the rates. Rates measured in real time are left out in script mode, so that frames are reproducible.
void add_rates(WindowUi& ui, const Shown& shown, std::vector<StatusPart>& parts) {
  const Performance& p = shown.run.performance;
  if (p.is_real_time && p.is_resting) {
    parts.push_back({StatusRank::rate, status_width("idle"), [&ui] {
                       ImGui::TextDisabled("idle");
                       ui.widgets.note_item("idle");
                       tooltip("Nothing moves: the window is drawn again when something happens");
                     }});
  } else if (p.is_real_time) {
    parts.push_back(status_item(ui, StatusRank::rate, "fps", fmt::format("{:.0f}", p.fps), "000"));
  } else {
    StatusPart picture = status_item(ui, StatusRank::rate, "picture", "every 20 ms", "");
    parts.push_back({picture.rank, picture.room, [draw = picture.draw] {
                       draw();
                       tooltip("A script plays: from picture to picture 20 ms pass, however long the computer takes");
                     }});
  }
  if (const std::string pace = pace_text(shown); !pace.empty())
    parts.push_back(status_item(ui, StatusRank::pace, "simulation", pace, ""));
  if (p.is_real_time && p.step_seconds > 0)
    parts.push_back(status_item(ui, StatusRank::step, "step", duration_text(p.step_seconds), "0.00 ms"));
}

/// Adds the force on the sensor and its polygons.
void add_force(WindowUi& ui, const std::string& force, std::size_t polygons, std::vector<StatusPart>& parts) {
  parts.push_back(status_item(ui, StatusRank::force, "force", force, "00.000 N"));
  parts.push_back(
      status_item(ui, StatusRank::polygons, "polygons", grouped(static_cast<long long>(polygons)), "0 000"));
}

/// Adds the contact that the view displays: the probe's in LAYOUT, otherwise the simulation's.
void add_contact(WindowUi& ui, const Viewer& viewer, const Shown& shown, std::vector<StatusPart>& parts) {
  if (viewer.mode == Mode::layout) {
    const PressedProbePtr& probe = shown.document.probe;
    if (probe && probe->problem.empty())
      add_force(ui, fmt::format("{:.3f} N", probe->force), static_cast<std::size_t>(probe->polygons), parts);
    return;
  }
  if (!shown.run.frame) return;
  parts.push_back(
      status_item(ui, StatusRank::time, "time", fmt::format("{:.3f} s", shown.run.frame->time), "00.000 s"));
  if (shown.run.runs_scenario)
    parts.push_back(status_item(ui, StatusRank::travel, "travel", in_mm(shown.run.frame->travel, 1), "000.0 mm"));
  const SensorStep* sensor = shown.sensor(viewer);
  if (sensor == nullptr) return;
  std::size_t polygons = 0;
  for (const ContactSurface& surface : sensor->surfaces) polygons += surface.polygons.size();
  add_force(ui, force_text(viewer, shown, 3), polygons, parts);
}

void add_recording(WindowUi& ui, const RunView& run, std::vector<StatusPart>& parts) {
  if (!run.frame || !run.frame->recording.on) return;
  StatusPart part = status_item(ui, StatusRank::recording, "recording",
                                fmt::format("{:.3f} s", run.frame->recording.seconds), "00.000 s");
  part.draw = [&ui, draw = std::move(part.draw)] {
    ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).error);
    draw();
    ImGui::PopStyleColor();
  };
  parts.push_back(std::move(part));
}

/// Draws a note about the samples of a preview, with the button that ends or begins the polishing.
void draw_samples(WindowUi& ui, const DocumentView& document, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette(ui.dark).warning);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ui.widgets.note_item(text);
  tooltip(document.polishing.holds_run
              ? "The run starts when its samples are polished: from then on its readings do not change"
              : "Readings are of quickly made samples, which are less even, until they are polished");
  ImGui::SameLine(0, kNameGap);
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

/// Adds a note while the samples of a preview are displayed, with the progress of the polishing.
void add_samples(WindowUi& ui, const DocumentView& document, std::vector<StatusPart>& parts) {
  const bool preview = document.model && document.model->quality == SampleQuality::preview;
  if (!preview && !document.polishing.active) return;
  std::string text = "Preview samples";
  if (document.polishing.active) text = "Polishing samples";
  const float room = status_width(text + " 100 %Cancel") + kNameGap + 2 * ImGui::GetStyle().FramePadding.x;
  if (document.polishing.fraction > 0) text += fmt::format(" {:.0f} %", 100 * document.polishing.fraction);
  parts.push_back({StatusRank::samples, room, [&ui, &document, text] { draw_samples(ui, document, text); }});
}

struct Counter {
  std::string text;
  ImVec4 color;
  [[nodiscard]] float width() const { return ImGui::CalcTextSize(text.c_str()).x; }
};

/// Returns the counters of messages, or only those above zero if `brief`. A counter above zero has the colour of its
/// severity.
std::vector<Counter> message_counters(const WindowUi& ui, const Messages& messages, bool brief) {
  const Palette& colors = palette(ui.dark);
  std::vector<Counter> counters;
  const auto add = [&](const char* name, Severity severity) {
    const auto count =
        std::count_if(messages.begin(), messages.end(), [&](const Message& m) { return m.severity == severity; });
    if (brief && count == 0) return;
    counters.push_back({fmt::format("{} {}", name, count), count > 0 ? severity_color(colors, severity) : colors.dim});
  };
  add("errors", Severity::error);
  add("warnings", Severity::warning);
  add("notes", Severity::note);
  if (counters.empty()) counters.push_back({"no messages", colors.dim});
  return counters;
}

float counters_width(const std::vector<Counter>& counters) {
  float width = 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetFontSize() * static_cast<float>(counters.size() - 1);
  for (const Counter& counter : counters) width += counter.width();
  return width;
}

/// Draws the counters of messages at the right end. A click opens the list of messages.
void draw_message_counter(WindowUi& ui, const std::vector<Counter>& counters, Flow& flow) {
  const float gap = ImGui::GetFontSize(), padding = ImGui::GetStyle().FramePadding.x, width = counters_width(counters);
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

/// Leaves out the least important parts until the others fit next to the counters. Returns the counters, which are
/// brief if the more important parts need their room.
std::vector<Counter> fit_into_row(const WindowUi& ui, const Messages& messages, float row, float gap,
                                  std::vector<StatusPart>& parts) {
  std::vector<Counter> counters = message_counters(ui, messages, false);
  const auto fits = [&] {
    float room = counters_width(counters);
    for (const StatusPart& part : parts) room += part.room + gap;
    return room <= row;
  };
  bool brief = false;
  while (!fits()) {
    const auto least = std::ranges::max_element(parts, {}, &StatusPart::rank);
    if (!brief && (least == parts.end() || least->rank < StatusRank::counters)) {
      counters = message_counters(ui, messages, true);
      brief = true;
    } else if (least != parts.end()) {
      parts.erase(least);
    } else {
      break;
    }
  }
  return counters;
}

void draw_status_line(WindowUi& ui, const Viewer& viewer, const Shown& shown, const Messages& messages) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10, 3));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(ui.dark).background);
  const float height = ImGui::GetTextLineHeight() + 9;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  if (ImGui::BeginViewportSideBar("Status", ImGui::GetMainViewport(), ImGuiDir_Down, height, kFlags)) {
    std::vector<StatusPart> parts;
    add_rates(ui, shown, parts);
    add_samples(ui, shown.document, parts);
    add_contact(ui, viewer, shown, parts);
    add_recording(ui, shown.run, parts);
    const float gap = 1.3f * ImGui::GetFontSize();
    const std::vector<Counter> counters = fit_into_row(ui, messages, ImGui::GetContentRegionAvail().x, gap, parts);
    Flow flow(gap);
    for (const StatusPart& part : parts) {
      flow.next(part.room);
      part.draw();
    }
    draw_message_counter(ui, counters, flow);
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
          draw_status_line(*app.ui, *app.viewer, *app.shown, app.get<Messages>());
        },
};

}  // namespace taxel::ui
