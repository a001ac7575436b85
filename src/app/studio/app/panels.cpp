#include "app/studio/app/panels.h"

#include <imgui.h>

#include <array>

#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/features/bars/bars_panel.h"
#include "app/studio/features/explain/explain_panel.h"
#include "app/studio/features/generate/generate_panel.h"
#include "app/studio/features/inspector/inspector_panel.h"
#include "app/studio/features/inspector/outliner_panel.h"
#include "app/studio/features/map/map_panel.h"
#include "app/studio/features/mesh/mesh_section.h"
#include "app/studio/features/messages/messages.h"
#include "app/studio/features/models/models_panel.h"
#include "app/studio/features/plot/plot_panel.h"
#include "app/studio/features/profiler/profiler_panel.h"
#include "app/studio/features/real/real_panel.h"
#include "app/studio/features/scene/controls_panel.h"
#include "app/studio/features/study/study_panel.h"
#include "app/studio/features/table/taxel_table_panel.h"
#include "app/studio/features/timeline/timeline_panel.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void draw_section(UiState& ui, const UiInput& input) {
  if (begin_panel(ui, kSectionTitle, &ui.saved.panels.section)) section_panel(scene_input(ui, input), ui.section);
  ImGui::End();
}

void draw_messages(UiState& ui, const UiInput&) {
  draw_messages_panel(ui);
}

constexpr std::array kPanelRows = {
    PanelSpec{kOutlinerTitle, Dock::upper_left, draw_outliner, "panel_outliner", &PanelsShown::outliner,
              "Outliner panel"},
    PanelSpec{kTaxelsTitle, Dock::left, draw_taxel_table, "panel_taxels", &PanelsShown::taxels, "Taxels panel"},
    PanelSpec{kInspectorTitle, Dock::right, draw_inspector, "panel_inspector", &PanelsShown::inspector,
              "Inspector panel"},
    PanelSpec{kControlsTitle, Dock::right, draw_controls_panel, "panel_controls", &PanelsShown::controls,
              "Controls panel", kSimulate},
    PanelSpec{kBarsTitle, Dock::bottom_left, draw_bars_panel, "panel_bars", &PanelsShown::bars, "Pressure bars panel"},
    PanelSpec{kMapTitle, Dock::bottom_left, draw_map_panel, "panel_map", &PanelsShown::map, "Taxel map panel"},
    PanelSpec{kPlotTitle, Dock::bottom, draw_plot_panel, "panel_plot", &PanelsShown::plot, "Plot panel", kEverywhere,
              ImGuiKey_F4},
    PanelSpec{kSectionTitle, Dock::bottom_right, draw_section, "panel_section", &PanelsShown::section, "Section panel"},
    PanelSpec{kTimelineTitle, Dock::lowest, draw_timeline_panel, "panel_timeline", &PanelsShown::timeline,
              "Timeline panel", kSimulate},
    PanelSpec{kExplainTitle, Dock::right, draw_explain_panel, "panel_explain", &PanelsShown::explain, "Explain panel",
              kSimulate},
    PanelSpec{kRealTitle, Dock::right, draw_real_panel},
    PanelSpec{kModelsTitle, Dock::lowest, draw_models_panel, "panel_models", &PanelsShown::models, "Models panel",
              kSimulate},
    PanelSpec{kStudyTitle, Dock::floating, draw_study_panel, "panel_study", &PanelsShown::study, "Study panel",
              kSimulate},
    PanelSpec{kProfilerTitle, Dock::lowest, draw_profiler_panel, "panel_profiler", &PanelsShown::profiler,
              "Profiler panel", kEverywhere, ImGuiKey_F3},
    PanelSpec{kMessagesTitle, Dock::bottom_left, draw_messages, "panel_messages", &PanelsShown::messages,
              "Messages panel"},
    PanelSpec{"Mesh report", Dock::floating, draw_mesh_report, "panel_mesh_report", &PanelsShown::mesh_report,
              "Mesh report..."},
    PanelSpec{kGenerateTitle, Dock::right, draw_generate_panel},
};

}  // namespace

std::span<const PanelSpec> panels() {
  return kPanelRows;
}

}  // namespace taxel::ui
