// The toolbar below the menus, and the strip of tools at the left edge of the 3-D view.
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/carry_out.h"
#include "app/studio/shell/menus/menus.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr ImVec2 kPadding{10, 4};

float button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

struct ModeButton {
  Mode mode;
  const char* tip;
};

void draw_modes(App& app, Flow& flow) {
  constexpr float kGap = 2;
  constexpr std::array kModes = {ModeButton{Mode::layout, "Edit the layout"},
                                 ModeButton{Mode::simulate, "Run the simulation"},
                                 ModeButton{Mode::analyse, "Study the recorded run: curves, models, layouts, jumps"}};
  float width = 0;
  for (const ModeButton& each : kModes) width += button_width(name_of(each.mode)) + kGap;
  flow.next(width);
  for (const ModeButton& each : kModes) {
    if (each.mode != Mode::layout) ImGui::SameLine(0, kGap);
    const Binding& row = binding_of(SetMode{each.mode});
    if (small_choice(*app.ui, name_of(each.mode), app.viewer->mode == each.mode)) carry_out_if_enabled(row, app);
    tooltip(fmt::format("{} ({})", each.tip, chord_name(row.chord, app.ui->key_names)));
  }
}

void draw_transport(App& app, Flow& flow) {
  const Palette& colors = palette(app.ui->dark);
  const float line = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const float small = 2.2f * line, large = 6.4f * line, gap = 4;
  flow.next(4 * (small + gap) + large);
  ImGui::BeginDisabled(!is_enabled(binding_of(PlayOrPause{}), app));
  if (icon_button(*app.ui, "Reset", Icon::reset, ImVec2(small, height), nullptr, "Back to the start (Backspace)")) {
    carry_out_if_enabled(ResetSimulation{}, app);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(*app.ui, "Back", Icon::step_back, ImVec2(small, height), nullptr, "One step back (Left)")) {
    carry_out_if_enabled(StepBack{}, app);
  }
  ImGui::SameLine(0, gap);
  const bool playing = app.shown->run.playing;
  if (icon_button(*app.ui, playing ? "Pause" : "Run", playing ? Icon::pause : Icon::run, ImVec2(large, height),
                  playing ? &colors.pause : &colors.run, playing ? "Pause (Space)" : "Run (Space)")) {
    carry_out_if_enabled(PlayOrPause{}, app);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(*app.ui, "Step", Icon::step, ImVec2(small, height), nullptr, "One step forward (Right)")) {
    carry_out_if_enabled(StepOnce{}, app);
  }
  ImGui::SameLine(0, gap);
  const bool records = app.shown->run.frame && app.shown->run.frame->recording.on;
  if (icon_button(*app.ui, records ? "Stop recording" : "Record", Icon::record, ImVec2(small, height),
                  records ? &colors.error : nullptr,
                  records ? "Write the recording (Ctrl+R)" : "Record every step from now on (Ctrl+R)")) {
    carry_out_if_enabled(ToggleRecording{}, app);
  }
  ImGui::EndDisabled();
}

std::string speed_name(double speed) {
  return speed >= 1 ? fmt::format("{:g} x", speed) : fmt::format("1/{:g} x", 1 / speed);
}

void draw_speed(App& app, Flow& flow) {
  const float width = 5.2f * ImGui::GetFontSize(), gap = 6;
  flow.next(ImGui::CalcTextSize("Speed").x + gap + width);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Speed");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##speed", speed_name(app.shown->run.speed).c_str());
  if (!open) {
    app.ui->widgets.note_item("Speed");
    const auto key = [&](bool faster) { return chord_name(binding_of(ChangeSpeed{faster}).chord, app.ui->key_names); };
    tooltip(fmt::format("Multiples of real time ({} slower, {} faster)", key(false), key(true)));
    return;
  }
  for (const double speed : std::array{0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    if (selectable(*app.ui, speed_name(speed).c_str(), speed == app.shown->run.speed)) app.ui->post(SetSpeed{speed});
  }
  ImGui::EndCombo();
}

/// Where a button of an overlay is displayed.
enum class OverlayPlace {
  everywhere,
  workshop,  ///< not in the demo
  contact,   ///< only with a contact: in SIMULATE, and with a probe
  run        ///< only in SIMULATE
};

struct OverlayButton {
  const char* label;
  bool Overlays::*overlay;
  OverlayPlace place;
};

bool is_displayed(OverlayPlace place, const App& app) {
  if (place == OverlayPlace::everywhere) return true;
  if (app.get<WindowParts>().has_few) return false;
  if (place == OverlayPlace::workshop || app.viewer->mode == Mode::simulate) return true;
  return place == OverlayPlace::contact && app.shown->document.probe != nullptr;
}

void draw_overlays(App& app, Flow& flow) {
  constexpr std::array kButtons = {
      OverlayButton{"X-ray", &Overlays::sensor_transparent, OverlayPlace::everywhere},
      OverlayButton{"Wire", &Overlays::wireframe, OverlayPlace::workshop},
      OverlayButton{"Contact", &Overlays::contact_surface, OverlayPlace::contact},
      OverlayButton{"Rays", &Overlays::rays, OverlayPlace::contact},
      OverlayButton{"Samples", &Overlays::samples, OverlayPlace::workshop},
      OverlayButton{"Normals", &Overlays::sample_normals, OverlayPlace::workshop},
      OverlayButton{"Taxels", &Overlays::taxels, OverlayPlace::workshop},
      OverlayButton{"Fields", &Overlays::receptive_fields, OverlayPlace::workshop},
      OverlayButton{"Path", &Overlays::path, OverlayPlace::run},
  };
  constexpr float kGap = 2;
  flow.next(ImGui::CalcTextSize("Show").x + 6 + button_width(kButtons.front().label));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Show");
  float gap = 6;
  for (const OverlayButton& b : kButtons) {
    if (!is_displayed(b.place, app)) continue;
    const Binding& binding = binding_of(ToggleOverlay{b.overlay});
    const std::string key = chord_name(binding.chord, app.ui->key_names);
    const std::string tip = key.empty() ? binding.label : fmt::format("{} ({})", binding.label, key);
    flow.next(button_width(b.label), gap);
    gap = kGap;
    if (toggle(*app.ui, b.label, is_checked(binding, app), tip.c_str())) carry_out_if_enabled(binding, app);
  }
}

/// Returns the number of problems of a severity in the edited layout.
std::size_t problems_of(const App& app, Severity severity) {
  const LayoutProblems& problems = app.get<LayoutProblems>();
  if (problems.project != app.shown->document.editing.project) return 0;
  return static_cast<std::size_t>(std::count_if(problems.list.begin(), problems.list.end(),
                                                [&](const Problem& p) { return p.severity == severity; }));
}

/// Draws the button that exports the layout, with the number of its errors, or else of its warnings.
void draw_export(App& app, Flow& flow) {
  if (app.viewer->mode != Mode::layout || !app.shown->document.editing.project) return;
  const Palette& colors = palette(app.ui->dark);
  const std::size_t errors = problems_of(app, Severity::error), warnings = problems_of(app, Severity::warning);
  std::string label = "Export layout";
  if (errors > 0) {
    label += fmt::format(" ({})", counted(errors, "error", "errors"));
  } else if (warnings > 0) {
    label += fmt::format(" ({})", counted(warnings, "warning", "warnings"));
  }
  flow.next(button_width(label.c_str()));
  ImGui::PushStyleColor(ImGuiCol_Text, errors > 0 ? colors.error : warnings > 0 ? colors.warning : colors.text);
  if (button(*app.ui, label.c_str())) carry_out_if_enabled(ExportFile{FileTask::export_layout}, app);
  ImGui::PopStyleColor();
  tooltip("Write the layout for `taxel`, the plugin and Python (Ctrl+E). The inspector lists its problems.");
}

}  // namespace

void draw_toolbar(App& app) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto rows = static_cast<float>(app.get<Arrangement>().toolbar_rows);
  const float height = rows * ImGui::GetFrameHeight() + (rows - 1) * style.ItemSpacing.y + 2 * kPadding.y;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, kPadding);
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  if (ImGui::BeginViewportSideBar("Toolbar", ImGui::GetMainViewport(), ImGuiDir_Up, height, kFlags)) {
    Flow flow(1.2f * ImGui::GetFontSize());
    draw_modes(app, flow);
    if (shows_run(app.viewer->mode)) {
      draw_transport(app, flow);
      draw_speed(app, flow);
    }
    if (app.viewer->mode != Mode::analyse) draw_overlays(app, flow);  // the plot needs the row more
    draw_export(app, flow);
    app.get<Arrangement>().toolbar_rows = flow.rows();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

namespace {

/// A button of the strip.
struct StripTool {
  const char* label;
  const char* tip;              ///< use of the tool
  const char* needs;            ///< condition under which it can be used
  const Binding& (*binding)();  ///< its row of the keymap
  bool (*is_active)(const App& app);
};

template <auto kMake>
const Binding& row() {
  static const Binding* const found = &binding_of(kMake());
  return *found;
}

bool is_selecting(const App& app) {
  return app.get<ToolState>().tool == Tool::none && !app.get<ProbeState>().on && !app.get<MeasureState>().on &&
         !app.get<GenerateState>().open;
}

constexpr std::array kLayoutTools = {
    StripTool{"Select", "Click taxels to select them, drag a selected one along the skin", "an open layout",
              row<[] { return Escape{}; }>, is_selecting},
    StripTool{"Place", "Click on the skin to place taxels", "an open layout",
              row<[] { return ToggleTool{Tool::place}; }>,
              [](const App& app) { return app.get<ToolState>().tool == Tool::place; }},
    StripTool{"Paint", "Paint the region of the skin that has samples", "an open layout",
              row<[] { return ToggleTool{Tool::brush}; }>,
              [](const App& app) { return app.get<ToolState>().tool == Tool::brush; }},
    StripTool{"Probe", "Press a ball, a box or a cylinder into the skin and read the taxels", "an open mesh",
              row<[] { return ToggleProbe{}; }>, [](const App& app) { return app.get<ProbeState>().on; }},
    StripTool{"Measure", "Measure distances, straight and along the skin", "an open mesh",
              row<[] { return ToggleMeasure{}; }>, [](const App& app) { return app.get<MeasureState>().on; }},
    StripTool{"Generate", "Make many taxels at once: grids, rings, spreads, known sensors", "an open layout",
              row<[] { return ToggleGenerate{}; }>, [](const App& app) { return app.get<GenerateState>().open; }},
};

constexpr std::array kSimulateTools = {
    StripTool{"Probe", "Press a ball, a box or a cylinder into the skin and read the taxels", "an open mesh",
              row<[] { return ProbeInLayout{}; }>, [](const App&) { return false; }},
    StripTool{"Explain", "Show which samples and polygons a reading comes from", "a recorded step",
              row<[] { return ExplainReading{}; }>, [](const App& app) { return app.get<PanelsShown>()[kExplain]; }},
    StripTool{"Record", "Write every step to a recording", "a run", row<[] { return ToggleRecording{}; }>,
              [](const App& app) { return app.shown->run.frame && app.shown->run.frame->recording.on; }},
    StripTool{"Video", "Make a video of the recorded steps", "recorded steps, and no video that is being made",
              row<[] { return ExportFile{FileTask::export_video}; }>,
              [](const App& app) { return app.get<VideoState>().progress.active; }},
};

void draw_button(App& app, const StripTool& tool, const ImVec2& size) {
  const Palette& colors = palette(app.ui->dark);
  const Binding& binding = tool.binding();
  const bool active = tool.is_active(app), enabled = is_enabled(binding, app);
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleColor(ImGuiCol_Button, active ? colors.accent : colors.panel);
  ImGui::PushStyleColor(ImGuiCol_Text, active ? ImVec4(1, 1, 1, 1) : colors.text);
  if (button(*app.ui, tool.label, size)) carry_out_if_enabled(binding, app);
  ImGui::PopStyleColor(2);
  ImGui::EndDisabled();
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const std::string key = binding.chord == 0 ? "" : fmt::format(" ({})", chord_name(binding.chord, app.ui->key_names));
  const std::string missing = enabled ? "" : fmt::format("\nNeeds {}.", tool.needs);
  ImGui::SetTooltip("%s%s%s", tool.tip, key.c_str(), missing.c_str());
}

}  // namespace

void draw_tool_strip(App& app) {
  ViewPlace& view = app.viewer->view;
  view.strip = 0;
  view.tools = {};
  const bool has_document = app.shown->document.model || app.shown->run.frame;
  if (view.rect.empty() || !has_document) return;
  if (app.viewer->mode == Mode::analyse) return;  // the view is small, and is looked at
  const bool layout = app.viewer->mode == Mode::layout;
  const std::span<const StripTool> tools =
      layout ? std::span<const StripTool>(kLayoutTools) : std::span<const StripTool>(kSimulateTools);
  const float line = ImGui::GetFontSize(), margin = 0.8f * line;
  float width = 0;
  for (const StripTool& tool : tools) width = std::max(width, ImGui::CalcTextSize(tool.label).x + line);
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNavInputs |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::SetNextWindowPos({view.rect.x0 + margin, view.rect.y0 + 2.9f * line});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(3, 3));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 2));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette(app.ui->dark).raised);
  if (ImGui::Begin("Tools", nullptr, kFlags))
    for (const StripTool& tool : tools) draw_button(app, tool, {width, 0});
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  view.tools = {at.x, at.y, at.x + size.x, at.y + size.y};
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  view.strip = width + 6 + 0.4f * line;
}

}  // namespace taxel::ui
