#include "app/studio/app/panels.h"

#include <imgui.h>

#include <array>

#include "app/studio/app/app.h"
#include "app/studio/app/pointing/shown_scene.h"
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/app/values/simulate_features.h"
#include "app/studio/app/values/viewer.h"
#include "app/studio/app/values/window_features.h"
#include "app/studio/app/values/window_ui.h"
#include "app/studio/features/bars/bars_panel.h"
#include "app/studio/features/compare/compare_panel.h"
#include "app/studio/features/data_set/data_set_panel.h"
#include "app/studio/features/explain/explain_panel.h"
#include "app/studio/features/generate/generate_panel.h"
#include "app/studio/features/heat/heat_panel.h"
#include "app/studio/features/history/history_panel.h"
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
#include "app/studio/features/section/section_panel.h"
#include "app/studio/features/study/study_panel.h"
#include "app/studio/features/table/taxel_table_panel.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void draw_section(App& app) {
  if (begin_panel(*app.ui, kSectionTitle, &app.window->panels.section))
    section_panel(scene_input(app), app.simulate->section);
  ImGui::End();
}

void draw_messages(App& app) {
  draw_messages_panel(*app.ui, app.window->panels, app.window->messages);
}

/// The switch of a panel whose feature has none of its own.
template <bool PanelsShown::*kSwitch>
bool& shown(App& app) {
  return app.window->panels.*kSwitch;
}

constexpr std::array kPanelRows = {
    PanelSpec{kOutlinerTitle, Dock::outline,
              [](App& app) { draw_outliner(*app.ui, app.viewer->selection, *app.shown, app.window->panels); },
              "panel_outliner", shown<&PanelsShown::outliner>, "Outliner panel"},
    PanelSpec{kTaxelsTitle, Dock::taxels,
              [](App& app) {
                draw_taxel_table(*app.ui, *app.viewer, *app.shown, app.layout->table, app.layout->problems,
                                 app.window->panels);
              },
              "panel_taxels", shown<&PanelsShown::taxels>, "Taxels panel"},
    PanelSpec{kInspectorTitle, Dock::inspector,
              [](App& app) {
                draw_inspector(*app.ui, *app.viewer, *app.shown, app.layout->problems, app.layout->mesh,
                               app.layout->material, app.layout->summary, app.simulate->follow, app.simulate->path,
                               app.window->panels, app.window->messages);
              },
              "panel_inspector", shown<&PanelsShown::inspector>, "Inspector panel"},
    PanelSpec{kControlsTitle, Dock::inspector,
              [](App& app) {
                draw_controls_panel(*app.ui, *app.viewer, *app.shown, app.simulate->controls,
                                    app.window->panels.controls);
              },
              "panel_controls", shown<&PanelsShown::controls>, "Controls panel", kSimulate},
    PanelSpec{kBarsTitle, Dock::bottom,
              [](App& app) {
                draw_bars_panel(*app.ui, *app.viewer, *app.shown, app.simulate->bars, app.simulate->error_bars,
                                app.window->panels.bars);
              },
              "panel_bars", shown<&PanelsShown::bars>, "Pressure bars panel", kEverywhere, 0, true},
    PanelSpec{
        kMapTitle, Dock::bottom,
        [](App& app) { draw_map_panel(*app.ui, *app.viewer, *app.shown, app.simulate->map, app.window->panels.map); },
        "panel_map", shown<&PanelsShown::map>, "Taxel map panel", kEverywhere, 0, true},
    PanelSpec{kPlotTitle, Dock::bottom,
              [](App& app) {
                draw_plot_panel(*app.ui, *app.viewer, *app.shown, app.simulate->real, app.simulate->plot,
                                app.window->panels.plot);
              },
              "panel_plot", shown<&PanelsShown::plot>, "Plot panel", kEverywhere, ImGuiKey_F4, true},
    PanelSpec{kHeatTitle, Dock::bottom,
              [](App& app) {
                draw_heat_panel(*app.ui, *app.viewer, *app.shown, app.simulate->heat, app.window->panels.heat);
              },
              "panel_heat", shown<&PanelsShown::heat>, "Heat map panel", kSimulate, 0, true},
    PanelSpec{kSectionTitle, Dock::bottom, draw_section, "panel_section", shown<&PanelsShown::section>, "Section panel",
              kEverywhere, 0, true},
    PanelSpec{kTimelineTitle, Dock::timeline, nullptr, "panel_timeline", shown<&PanelsShown::timeline>,
              "Timeline panel", kSimulate},
    PanelSpec{kExplainTitle, Dock::inspector,
              [](App& app) {
                draw_explain_panel(*app.ui, *app.viewer, *app.shown, app.simulate->explain, app.window->panels.explain);
              },
              "panel_explain", shown<&PanelsShown::explain>, "Explain panel", kSimulate},
    PanelSpec{kRealTitle, Dock::inspector,
              [](App& app) { draw_real_panel(*app.ui, *app.viewer, app.shown->document, app.simulate->real); }},
    PanelSpec{kModelsTitle, Dock::bottom,
              [](App& app) {
                draw_models_panel(*app.ui, *app.viewer, *app.shown, app.simulate->models, app.window->panels.models);
              },
              "panel_models", shown<&PanelsShown::models>, "Models panel", kSimulate},
    PanelSpec{kCompareTitle, Dock::bottom,
              [](App& app) {
                draw_compare_panel(*app.ui, *app.viewer, *app.shown, app.simulate->compare, app.window->panels.compare);
              },
              "panel_compare", shown<&PanelsShown::compare>, "Compare panel", kSimulate, ImGuiMod_Shift | ImGuiKey_C},
    PanelSpec{kStudyTitle, Dock::floating,
              [](App& app) {
                draw_study_panel(*app.ui, app.viewer->view, *app.shown, app.simulate->study, app.window->panels.study);
              },
              "panel_study", shown<&PanelsShown::study>, "Study panel", kSimulate},
    PanelSpec{kDataSetTitle, Dock::floating,
              [](App& app) {
                draw_data_set_panel(*app.ui, app.viewer->view, *app.shown, app.simulate->data_set,
                                    app.window->panels.data_set);
              },
              "panel_data_set", shown<&PanelsShown::data_set>, "Data set panel"},
    PanelSpec{kProfilerTitle, Dock::bottom,
              [](App& app) {
                draw_profiler_panel(*app.ui, app.shown->run, app.window->panels.profiler, app.window->profile);
              },
              "panel_profiler", shown<&PanelsShown::profiler>, "Profiler panel", kEverywhere, ImGuiKey_F3},
    PanelSpec{kMessagesTitle, Dock::bottom, draw_messages, "panel_messages", messages_switch, "Messages panel"},
    PanelSpec{kHistoryTitle, Dock::inspector,
              [](App& app) { draw_history_panel(*app.ui, app.shown->document.editing, app.window->panels.history); },
              "panel_history", history_switch},
    PanelSpec{"Mesh report", Dock::floating,
              [](App& app) { draw_mesh_report(*app.ui, app.viewer->view, app.shown->document, app.window->panels); },
              "panel_mesh_report", shown<&PanelsShown::mesh_report>, "Mesh report..."},
    PanelSpec{kGenerateTitle, Dock::inspector,
              [](App& app) {
                draw_generate_panel(*app.ui, *app.viewer, *app.shown, app.layout->tool, app.layout->generate,
                                    app.window->tour, app.window->dialog);
              }},
};

}  // namespace

bool& messages_switch(App& app) {
  return shown<&PanelsShown::messages>(app);
}
bool& history_switch(App& app) {
  return shown<&PanelsShown::history>(app);
}
bool& info_switch(App& app) {
  return shown<&PanelsShown::info>(app);
}
bool& help_switch(App& app) {
  return shown<&PanelsShown::help>(app);
}

bool is_drawn(const PanelSpec& panel, const App& app) {
  const bool layout = app.viewer->mode == Mode::layout;
  if (panel.shown != nullptr && !is_open(panel.shown, app)) return false;
  if (panel.context == Context::simulate && layout) return false;
  return !panel.of_readings || !layout || app.layout->probe.on || app.shown->state(*app.viewer) != nullptr;
}

bool is_open(PanelSwitch panel, const App& app) {
  return panel(const_cast<App&>(app));  // a switch changes nothing itself
}

std::span<const PanelSpec> panels() {
  return kPanelRows;
}

}  // namespace taxel::ui
