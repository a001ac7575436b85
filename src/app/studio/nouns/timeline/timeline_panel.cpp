// The timeline at the bottom of the window: its buttons, its line or its tracks, and the conditions that pause a run.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensor_chooser.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/timeline/timeline.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kPercent{"", -2, 1};

constexpr float kThresholdField = 3.1f, kLeastLanes = 7.5f, kLeastLine = 8;  // in heights of text
constexpr float kLanes = 0.2f;                                               // fraction of the window's height
constexpr ImVec2 kTimelinePadding{10, 4}, kButtonPadding{6, 2};

float film_button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// Returns the width of the playback buttons in one row.
float film_width() {
  float width = 4 * ImGui::GetFontSize() + 3;
  for (const char* label : {"< Event", "Event >", "Latest", "Loop", "Tracks"}) width += 3 + film_button_width(label);
  return width;
}

void draw_film(WindowUi& ui, const RunView& run, Timeline& timeline) {
  const float line = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const auto text_button = [&](const char* label, const auto& command, const char* tip) {
    ImGui::SameLine(0, 3);
    if (button(ui, label)) ui.post(command);
    tooltip(tip);
  };
  const bool back = run.replay < 0;
  const bool forth = run.replay > 0;
  if (icon_button(ui, "Backwards", back ? Icon::pause : Icon::backwards, {2 * line, height}, nullptr,
                  "Play recorded steps backwards (Shift+Space)"))
    ui.post(TogglePlayBackwards{});
  ImGui::SameLine(0, 3);
  if (icon_button(ui, "Replay", forth ? Icon::pause : Icon::run, {2 * line, height}, nullptr,
                  "Play recorded steps; Run (Space) simulates on from the step that is shown"))
    ui.post(ReplayHistory{forth ? 0 : 1});
  text_button("< Event", GoToEvent{-1}, "Previous event (Shift+Left)");
  text_button("Event >", GoToEvent{1}, "Next event (Shift+Right)");
  text_button("Latest", GoToNewestStep{}, "Go to the latest step (End)");
  ImGui::SameLine(0, 3);
  if (toggle(ui, "Loop", run.loop.has_value(), "Round and round: all steps, or those marked with Shift+drag"))
    ui.post(ToggleLoop{});
  ImGui::SameLine(0, 3);
  if (toggle(ui, "Tracks", timeline.unfolded,
             timeline.unfolded ? "Fold the timeline to one line"
                               : "Unfold the timeline: tracks of force, area and jumps, and when to pause"))
    timeline.unfolded = !timeline.unfolded;
}

/// Draws the line of play, and the time and the step that are displayed.
void draw_line(WindowUi& ui, const Selection& selection, const RunView& run, Timeline& timeline, Flow& flow) {
  const SimFrame& frame = *run.frame;
  const float line = ImGui::GetFontSize();
  const bool breaks =
      frame.breakpoints.on_jump || frame.breakpoints.at_equal_force || frame.breakpoints.on_disagreement;
  const std::string last = grouped(static_cast<long long>(frame.history.last));
  const std::string step = frame.recorded
                               ? fmt::format("step {} of {}", grouped(static_cast<long long>(frame.step)), last)
                               : fmt::format("step {}", last);
  const std::string text = fmt::format("{:.3f} s   {}{}", frame.time, step, breaks ? "   breaks" : "");
  // Room for the text of a recorded step is reserved, so that the line does not change its length.
  const std::string longest =
      fmt::format("{:.3f} s   step {} of {}{}", frame.time, last, last, breaks ? "   breaks" : "");
  const float width = ImGui::CalcTextSize(longest.c_str()).x + 9;
  flow.next(kLeastLine * line + width);
  const float room = ImGui::GetContentRegionAvail().x - width;
  draw_timeline_slider(ui, selection, run, timeline, {std::max(2 * line, room), ImGui::GetFrameHeight()});
  ImGui::SameLine(0, 9);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text.c_str());
  ui.widgets.note_item("Displayed step");
  if (breaks) tooltip("The run pauses where the conditions say that stand under Tracks");
}

/// A toggle with a threshold. draw_threshold() returns the new fraction if the user entered one.
struct Threshold {
  const char *label, *tip, *field, *field_tip;
  [[nodiscard]] float width() const {
    return film_button_width(label) + kThresholdField * ImGui::GetFontSize() + 6 + ImGui::CalcTextSize("%").x;
  }
};
std::optional<double> draw_threshold(WindowUi& ui, const Threshold& what, bool& on, double part) {
  if (toggle(ui, what.label, on, what.tip)) on = !on;
  ImGui::SameLine(0, 3);
  const std::optional<double> entered =
      number_field(ui, what.field, {part}, kPercent, kThresholdField * ImGui::GetFontSize());
  tooltip(what.field_tip);
  ImGui::SameLine(0, 3);
  ImGui::TextDisabled("%%");
  return entered;
}

void draw_breakpoints(WindowUi& ui, const RunView& run, Flow& flow) {
  const Breakpoints& now = run.frame->breakpoints;
  Breakpoints wanted = now;
  constexpr Threshold kJumps{"jump >", "Pause when a taxel jumps by more than this (Shift+B)", "Jump",
                             "A jump: from one step to the next, as part of the taxel's largest reading so far"};
  flow.next(ImGui::CalcTextSize("Break on").x + 5 + kJumps.width(), 1.1f * ImGui::GetFontSize());
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Break on");
  ImGui::SameLine(0, 5);
  if (const auto part = draw_threshold(ui, kJumps, wanted.on_jump, now.jump); part && *part > 0) wanted.jump = *part;
  constexpr Threshold kEqual{"at constant force", "Pause when a taxel jumps while the force stays", "Force change",
                             "The force stays where it changes by no more than this part of itself"};
  flow.next(kEqual.width());
  if (const auto part = draw_threshold(ui, kEqual, wanted.at_equal_force, now.equal_force); part && *part >= 0)
    wanted.equal_force = *part;
  constexpr Threshold kOff{"vs. exact integral",
                           "Pause when samples and surface disagree: a taxel reads something else than the exact\n"
                           "integral over its field. Working that out in every step slows the simulation down",
                           "Sampling error", "As part of the taxel's largest reading so far"};
  flow.next(kOff.width());
  if (const auto part = draw_threshold(ui, kOff, wanted.on_disagreement, now.disagreement); part && *part > 0)
    wanted.disagreement = *part;
  flow.next(film_button_width("of sensor"));
  if (toggle(ui, "of sensor", now.of_sensor,
             "Measure jumps against the largest reading of all taxels of the sensor,\n"
             "not against each taxel's own"))
    wanted.of_sensor = !now.of_sensor;
  if (!(wanted == now)) ui.post(BreakpointsCommand{wanted});
}

/// Draws the number of retained steps and the memory that they use.
void draw_memory(WindowUi& ui, const RunView& run, Flow& flow) {
  const HistoryState& history = run.frame->history;
  const std::string last = grouped(static_cast<long long>(history.last));
  const std::string kept = fmt::format("   {:.0f} MB, {} of", 1e-6 * static_cast<double>(history.bytes),
                                       grouped(static_cast<long long>(history.steps)));
  const auto past = [&](const std::string& step) { return fmt::format("step {} of {}{}", step, last, kept); };
  const std::string text =
      run.frame->recorded ? past(grouped(static_cast<long long>(run.frame->step))) : "step " + last + kept;
  const float field = 4.4f * ImGui::GetFontSize();
  const auto width = [&](const std::string& words) { return ImGui::CalcTextSize(words.c_str()).x + field + 6; };
  // Room for the text of a recorded step is reserved, so that the tracks do not move.
  flow.last(width(text), width(past(last)));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text.c_str());
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("Steps are kept as they were computed.\nRecording one takes %s of %s.",
                      duration_text(history.step_seconds).c_str(), duration_text(run.frame->step_seconds).c_str());
  ImGui::SameLine(0, 6);
  const std::optional<double> steps =
      number_field(ui, "Kept steps", {static_cast<double>(history.limits.steps)}, {"", 0, 0}, field);
  if (steps && *steps >= 1 && *steps <= 1e7) {
    StepHistoryLimits limits = history.limits;
    limits.steps = static_cast<std::size_t>(*steps);
    ui.post(StepHistoryLimitsCommand{limits});
  }
  tooltip("Maximum number of recorded steps");
}

/// Draws the choice of the sensor whose tracks are displayed, if there are several.
void draw_tracks_sensor(WindowUi& ui, Selection& selection, const RunView& run, SensorChooser& chooser, Flow& flow) {
  const std::vector<SensorShown> sensors = sensors_shown(run);
  if (sensors.size() < 2) return;
  const float width = 10 * ImGui::GetFontSize();
  flow.next(width);
  draw_sensor_chooser(ui, chooser, selection, sensors, width);
}

void draw_timeline(WindowUi& ui, Viewer& viewer, const Shown& shown, Timeline& timeline, SensorChooser& chooser,
                   int& rows, bool open) {
  timeline.lanes = {};
  if (!open || !shows_run(viewer.mode) || !shown.run.frame) return;
  const bool recorded = shown.run.frame->history.lanes && shown.run.frame->history.lanes->rows() > 0;
  const bool has_steps = recorded && shown.sensor(viewer) != nullptr;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, kTimelinePadding);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, kButtonPadding);
  ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float line = ImGui::GetFontSize(), spacing = ImGui::GetStyle().ItemSpacing.y;
  const float buttons = static_cast<float>(rows) * (ImGui::GetFrameHeight() + spacing) - spacing;
  const float lanes = std::round(std::max(kLanes * viewport->Size.y, kLeastLanes * line));
  const bool unfolded = timeline.unfolded && has_steps;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  if (ImGui::BeginViewportSideBar(kTimeline.title, viewport, ImGuiDir_Down,
                                  buttons + 2 * kTimelinePadding.y + (unfolded ? lanes + spacing : 0), kFlags)) {
    Flow flow(9);
    if (has_steps) {
      flow.next(film_width());
      draw_film(ui, shown.run, timeline);
    } else {
      ImGui::TextDisabled("No sensor is simulated.");
    }
    if (has_steps && !unfolded) draw_line(ui, viewer.selection, shown.run, timeline, flow);
    if (unfolded) {
      draw_tracks_sensor(ui, viewer.selection, shown.run, chooser, flow);
      draw_breakpoints(ui, shown.run, flow);
      draw_memory(ui, shown.run, flow);
      draw_timeline_lanes(ui, viewer.selection, shown.run, timeline, {ImGui::GetContentRegionAvail().x, lanes});
    }
    rows = std::max(1, flow.rows());
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

/// Returns the parts of the unfolded timeline.
std::vector<PanelPart> timeline_parts() {
  constexpr std::pair<const char*, const char*> kParts[] = {
      {"Tracks", "Unfold the timeline: tracks of force, area and jumps, and when to pause"},
      {"jump >", "Pause the run when a taxel jumps by more than a fraction"},
      {"Jump", "Fraction of the taxel's largest reading that is a jump"},
      {"at constant force", "Pause when a taxel jumps while the force stays"},
      {"Force change", "The force stays if it changes by no more than this fraction"},
      {"vs. exact integral", "Pause when samples and surface disagree"},
      {"Sampling error", "Difference from the exact integral at which the run pauses"},
      {"of sensor", "Measure jumps against the largest reading of all taxels of the sensor"},
      {"Kept steps", "Largest number of recorded steps in memory"}};
  std::vector<PanelPart> parts;
  for (const auto& [label, help] : kParts) {
    const auto why = [](const App& app) -> const char* {
      return app.shown->run.has_history() ? nullptr : "No step is recorded yet";
    };
    PanelPart part{label, "", help, kSimulate, why};
    if (label != kParts[0].first) part.prepare = [](App& app) { app.get<Timeline>().unfolded = true; };
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

constinit const Feature kTimeline{
    .title = "Timeline",
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_timeline",
    .label = "Timeline",
    .context = kSimulate,
    .parts = timeline_parts,
    .guide = "Go back in time",
    .draw_bar =
        [](App& app) {
          draw_timeline(*app.ui, *app.viewer, *app.shown, app.get<Timeline>(), app.get<SensorChooser>(),
                        app.get<Arrangement>().timeline_rows,
                        app.get<PanelsShown>()[kTimeline] && !is_left_out(kTimeline, app));
        },
    .dump = dump_timeline,
    .saved =
        [](App& app) {
          return std::vector<SavedValue>{{"timeline_unfolded", &app.get<Timeline>().unfolded}};
        },
};

}  // namespace taxel::ui
