#include "app/studio/shell/menus/tool_strip.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain.h"
#include "app/studio/nouns/explain/explain_tool.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/measure/measure_tool.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/probe/probe_tool.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/shell/interface/perform.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

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
  if (button(*app.ui, tool.label, size)) perform(binding, app);
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
  const bool has_document = app.shown->document.model || app.shown->run.frame;
  if (view.rect.empty() || !has_document) return;
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
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  view.strip = width + 6 + 0.4f * line;
}

}  // namespace taxel::ui
