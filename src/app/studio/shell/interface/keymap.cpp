// The keymap: its rows, menu by menu, the gestures of the mouse, and the names of chords.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/keymap.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/host/examples.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/real/real_commands.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "app/studio/nouns/select/select.h"
#include "app/studio/nouns/table/table_state.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/video/video_commands.h"
#include "app/studio/nouns/video/video_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/nouns/view/view_state.h"

namespace taxel::ui {
namespace {

constexpr std::array kGestures = {
    Gesture{kEverywhere, "Left-drag", "Orbit"},
    Gesture{kEverywhere, "Right-drag", "Pan (Shift: keep the height)"},
    Gesture{kEverywhere, "Wheel, middle-drag", "Zoom; the wheel at the pointer"},
    Gesture{kEverywhere, "Shift+wheel", "Move the clip plane"},
    Gesture{kEverywhere, "Right double-click", "Centre on the point"},
    Gesture{kEverywhere, "Click", "Select a taxel (view, table, bars, legend)"},
    Gesture{kEverywhere, "Shift+click", "Add a taxel to the selection, or take it out"},
    Gesture{kSimulate, "Click on the contact surface", "Inspect the polygon (Explain panel)"},
    Gesture{kLayout, "Ctrl+click", "Add a taxel on the surface"},
    Gesture{kLayout, "Drag a selected taxel", "Slide it along the surface"},
    Gesture{kLayout, "Ctrl+wheel", "Change the radius by 2 %"},
    Gesture{kLayout, "Double-click a cell", "Type in the table of taxels (Tab: next cell)"},
    Gesture{kLayout, "Drag a row", "Reorder taxels"},
    Gesture{kLayout, "Brush: left-drag", "Paint the region (Shift or Ctrl: erase; wheel: radius)"},
    Gesture{kLayout, "Generate: click, drag", "Put the pattern there (Ctrl+wheel: turn it)"},
    Gesture{kLayout, "Wheel, drag on the probe", "Press it deeper; put down: slide it along the surface"},
    Gesture{kSimulate, "Double-click", "Select a body"},
    Gesture{kSimulate, "Ctrl+left-drag", "Turn the selected body (Shift: about level axes)"},
    Gesture{kSimulate, "Ctrl+right-drag", "Pull the selected body (Shift: keep the height)"},
    Gesture{kSimulate, "Ctrl+Alt+left-drag", "The same, without the right button"},
    Gesture{kSimulate, "Ctrl+right double-click", "Track the body: the camera goes along (Esc frees it)"},
    Gesture{kGesture, "0-9 . -", "Exact value, in mm or degrees (Backspace)"},
    Gesture{kGesture, "Shift", "A tenth of the pace"},
    Gesture{kGesture, "Ctrl", "Snap"},
    Gesture{kGesture, "Click, right click", "Accept, cancel"},
    Gesture{kEverywhere, "Drag in the timeline", "Show a recorded step"},
    Gesture{kEverywhere, "Shift+drag in the timeline", "Loop over these steps (Shift+click: no more)"},
    Gesture{kEverywhere, "Click in a plot", "Show the step at that place"},
    Gesture{kWidget, "Enter", "Apply the value of a field, as leaving the field does"},
    Gesture{kWidget, "Esc", "Leave a field as it was, close a menu, leave a panel"},
    Gesture{kWidget, "Tab, Shift+Tab", "Next and previous field of the panel"},
    Gesture{kEverywhere, "Alt or F10", "Keyboard to the menus (arrows, letters, Enter, Esc)"},
    Gesture{kEverywhere, "Alt+F, Alt+E, ...", "Open the menu with this letter"},
    Gesture{kWidget, "Space, arrows, Ctrl+Tab", "Press, choose; next panel, once the keyboard is in one"},
    Gesture{kEverywhere, "Drop a file", "Open a project, layout, mesh, MuJoCo scene, saved step or study"},
};

const char* key_name(int key) {
  switch (key) {
    case ImGuiKey_Equal:
      return "=";
    case ImGuiKey_Minus:
      return "-";
    case ImGuiKey_Slash:
      return "/";
    case ImGuiKey_LeftBracket:
      return "[";
    case ImGuiKey_RightBracket:
      return "]";
    case ImGuiKey_Period:
      return ".";
    case ImGuiKey_RightArrow:
      return "Right";
    case ImGuiKey_LeftArrow:
      return "Left";
    case ImGuiKey_UpArrow:
      return "Up";
    case ImGuiKey_DownArrow:
      return "Down";
    case ImGuiKey_Escape:
      return "Esc";
    default:
      return ImGui::GetKeyName(static_cast<ImGuiKey>(key));
  }
}

}  // namespace

std::span<const Gesture> gestures() {
  return kGestures;
}

std::string chord_name(int chord, const KeyNames& names) {
  if (chord == 0) return {};
  std::string text;
  if ((chord & ImGuiMod_Ctrl) != 0) text += "Ctrl+";
  if ((chord & ImGuiMod_Alt) != 0) text += "Alt+";
  if ((chord & ImGuiMod_Shift) != 0) text += "Shift+";
  const int key = chord & ~ImGuiMod_Mask_;
  const auto named = names.find(key);
  return text + (named != names.end() ? named->second : key_name(key));
}

std::string chord_names(const Binding& binding, const KeyNames& names) {
  const std::string first = chord_name(binding.chord, names), also = chord_name(binding.also, names);
  return also.empty() ? first : first + ", " + also;
}

const char* to_string(Context context) {
  switch (context) {
    case Context::everywhere:
      return "everywhere";
    case Context::layout:
      return "LAYOUT";
    case Context::simulate:
      return "SIMULATE";
    case Context::gesture:
      return "gesture";
    case Context::widget:
      return "field";
  }
  return "";
}

std::string bindings_as_text() {
  std::string text = fmt::format("{:<30} {:<12} {}\n", "KEY", "WHERE", "WHAT");
  for (const Binding& b : bindings()) {
    if (b.chord != 0) text += fmt::format("{:<30} {:<12} {}\n", chord_names(b), to_string(b.context), b.label);
  }
  for (const Gesture& g : kGestures) {
    text += fmt::format("{:<30} {:<12} {}\n", g.gesture, to_string(g.context), g.label);
  }
  return text;
}

namespace {

using Rows = std::vector<Binding>;

constexpr int kCtrl = ImGuiMod_Ctrl, kShift = ImGuiMod_Shift, kAlt = ImGuiMod_Alt;

constexpr auto has_file = [](const App& app) { return !app.shown->document.file.empty(); };
constexpr auto has_project = [](const App& app) { return app.shown->document.editing.project != nullptr; };
constexpr auto can_save_as = [](const App& app) {
  return app.shown->document.editing.project != nullptr || app.shown->document.is_scene;
};
/// A run without taxels is enabled too: its message says that taxels are missing.
constexpr auto has_document = [](const App& app) {
  return app.shown->document.model != nullptr || app.shown->run.frame != nullptr;
};
constexpr auto has_run = [](const App& app) {
  return app.shown->run.frame != nullptr || (app.shown->document.model && app.shown->document.model->taxel_count() > 0);
};
constexpr auto has_sensors = [](const App& app) {
  return app.shown->run.frame != nullptr && !app.shown->run.frame->sensors.empty();
};
constexpr auto has_history = [](const App& app) { return app.shown->run.has_history(); };
constexpr auto has_recorded_sensors = [](const App& app) { return app.shown->run.has_history() && has_sensors(app); };
constexpr auto has_plot = [](const App& app) {
  return has_sensors(app) && app.shown->run.frame->trace && !app.shown->run.frame->trace->rows.empty();
};
constexpr auto has_comparison = [](const App& app) { return has_comparison_table(app); };
constexpr auto can_make_video = [](const App& app) {
  return app.shown->run.has_history() && !app.get<VideoState>().progress.active;
};
/// A film without recorded steps is enabled too: its message says that the run is missing.
constexpr auto can_make_film = [](const App& app) { return !app.get<VideoState>().progress.active; };
constexpr auto can_undo = [](const App& app) { return app.shown->document.editing.undo_depth > 0; };
constexpr auto can_redo = [](const App& app) { return app.shown->document.editing.redo_depth > 0; };

bool has_taxels(const App& app) {
  const Layout* layout = app.shown->layout(*app.viewer);
  return layout != nullptr && !layout->taxels.empty();
}

constexpr auto can_edit_layout = [](const App& app) { return can_edit(*app.viewer, *app.shown); };
constexpr auto can_edit_taxels = [](const App& app) {
  return can_edit(*app.viewer, *app.shown) && !app.shown->document.editing.project->layout.taxels.empty();
};
constexpr auto can_edit_selected = [](const App& app) {
  return can_edit(*app.viewer, *app.shown) && !app.viewer->selection.empty();
};
constexpr auto has_hidden = [](const App& app) {
  return can_edit(*app.viewer, *app.shown) && !app.shown->document.editing.project->hidden.empty();
};
constexpr auto has_selection = [](const App& app) { return !app.viewer->selection.empty(); };
constexpr auto has_scene_box = [](const App& app) { return !scene_box(*app.viewer, *app.shown).empty(); };
constexpr auto has_selection_box = [](const App& app) { return !selection_box(*app.viewer, *app.shown).empty(); };
constexpr auto is_simulated = [](const App& app) {
  return shows_run(app.viewer->mode) && app.shown->run.frame && app.shown->run.frame->scene;
};
constexpr auto is_orthographic = [](const App& app) { return app.viewer->camera().orthographic; };
constexpr auto has_clip_plane = [](const App& app) { return app.viewer->clip.has_value(); };
constexpr auto may_measure = [](const App& app) { return can_measure(*app.viewer, app.shown->document); };
constexpr auto may_probe = [](const App& app) { return can_probe(*app.viewer, app.shown->document); };
constexpr auto why_no_probe = [](const App& app) -> const char* {
  return app.shown->document.is_scene ? "No probe: no layout of this scene is edited. Select a sensor and edit its "
                                        "layout, or open a mesh or a layout."
                                      : "No probe: there is no sensor to press it on. Open a mesh or a layout.";
};
constexpr auto has_model = [](const App& app) { return app.shown->document.model != nullptr; };
constexpr auto has_selected_way_point = [](const App& app) {
  return has_way_point(*app.viewer, *app.shown, app.get<PathState>());
};
constexpr auto may_record_path = [](const App& app) { return can_record_path(*app.viewer, *app.shown); };
constexpr auto may_select_parent = [](const App& app) { return can_select_parent(*app.viewer, app.shown->run); };
constexpr auto has_scene_cameras = [](const App& app) { return has_cameras(*app.viewer, app.shown->run); };
constexpr auto is_probing = [](const App& app) { return app.get<ProbeState>().on; };
constexpr auto is_measuring = [](const App& app) { return app.get<MeasureState>().on; };
constexpr auto is_recording_path = [](const App& app) { return app.get<PathState>().recording.has_value(); };
constexpr auto is_in_layout = [](const App& app) { return app.viewer->mode == Mode::layout; };
constexpr auto is_in_analyse = [](const App& app) { return app.viewer->mode == Mode::analyse; };
constexpr auto is_in_simulate = [](const App& app) { return app.viewer->mode == Mode::simulate; };
constexpr auto has_frames = [](const App& app) { return app.viewer->overlays().frames != FramesShown::none; };
constexpr auto has_labels = [](const App& app) { return app.viewer->overlays().labels != LabelsShown::none; };
constexpr auto is_range_locked = [](const App& app) { return !app.viewer->range.automatic; };
constexpr auto is_reading_range_locked = [](const App& app) {
  return !reading_range(*app.viewer, *app.shown).automatic;
};
constexpr auto may_lock_readings = [](const App& app) { return !shares_range(*app.viewer, *app.shown); };
constexpr auto may_link_ranges = [](const App& app) { return reads_pressures(*app.viewer, *app.shown); };
constexpr auto has_linked_ranges = [](const App& app) { return shares_range(*app.viewer, *app.shown); };
constexpr auto is_full_screen = [](const App& app) { return app.get<WindowState>().full_screen; };
constexpr auto is_maximised = [](const App& app) { return !app.get<Arrangement>().maximised.empty(); };
constexpr auto has_desktop_dialog = [](const App& app) {
  return app.get<FileDialog>().desktop == DesktopChooser::found;
};
constexpr auto uses_desktop_dialog = [](const App& app) { return uses_desktop(app.get<FileDialog>()); };
constexpr auto why_no_desktop_dialog = [](const App& app) { return why_no_desktop(app.get<FileDialog>()); };
constexpr auto is_light = [](const App& app) { return !app.get<Appearance>().dark; };

/// Appends rows of a menu; a line separates them from earlier rows of that menu.
void append(Rows& rows, const char* menu, Rows block) {
  const bool first = std::none_of(rows.begin(), rows.end(), [&](const Binding& row) {
    return row.menu != nullptr && menu != nullptr && std::string_view(row.menu) == menu;
  });
  for (Binding& row : block) row.menu = menu;
  block.front().separated = menu != nullptr && !first;
  rows.insert(rows.end(), std::make_move_iterator(block.begin()), std::make_move_iterator(block.end()));
}

// Columns of each row: command, context, chord, label, enabled, checked, repeats, second chord; append() sets the next
// two; the reason why the row is disabled.

constexpr const char *kFileMenu = "File", *kExportMenu = "File/Export", *kEditMenu = "Edit",
                     *kTransformMenu = "Edit/Transform", *kOrderMenu = "Edit/Name and order",
                     *kHideMenu = "Edit/Show and hide", *kSelectMenu = "Edit/Selection", *kModeMenu = "Mode",
                     *kSimulationMenu = "Simulation", *kStepsMenu = "Simulation/Recorded steps", *kViewMenu = "View",
                     *kCameraMenu = "View/Camera", *kSceneMenu = "View/Frames and labels", *kGroupsMenu = "View/Groups",
                     *kWindowMenu = "View/Window", *kPanelsMenu = "Panels", *kExamplesMenu = "Help/Examples",
                     *kHelpMenu = "Help";

void append_file_rows(Rows& rows) {
  append(rows, kFileMenu,
         {{NewLayout{}, kEverywhere, kCtrl | ImGuiKey_N, "New"},
          {ShowOpenDialog{}, kEverywhere, kCtrl | ImGuiKey_O, "Open..."},
          {ReadRealRecording{}, kEverywhere, 0, "Import real recording...", has_recorded_sensors},
          {ReloadFile{}, kEverywhere, kCtrl | ImGuiKey_L, "Reload", has_file},
          {CloseDocument{}, kEverywhere, 0, "Close", has_document}});
  append(rows, kFileMenu,
         {{SaveProject{}, kEverywhere, kCtrl | ImGuiKey_S, "Save", has_project},
          {SaveAs{}, kEverywhere, kCtrl | kShift | ImGuiKey_S, "Save as...", can_save_as},
          {ToggleDesktopDialog{}, kEverywhere, 0, "Use the desktop's file dialog", has_desktop_dialog,
           uses_desktop_dialog, false, 0, nullptr, false, why_no_desktop_dialog}});
  append(rows, kExportMenu,
         {{ExportFile{FileTask::export_layout}, kEverywhere, kCtrl | ImGuiKey_E, "Export layout...", has_project},
          {ExportFile{FileTask::export_taxels}, kEverywhere, 0, "Export taxels (CSV)...", has_project},
          {ExportFile{FileTask::export_samples}, kEverywhere, 0, "Export samples (CSV)...", has_project},
          {ExportFile{FileTask::export_sheet}, kEverywhere, 0, "Export sheet to print (HTML)...", has_project},
          {ExportFile{FileTask::export_picture}, kEverywhere, 0, "Export picture (PNG)...", has_document},
          {ExportFile{FileTask::export_plot}, kEverywhere, 0, "Export plot (SVG, PDF)...", has_plot},
          {ExportFile{FileTask::export_comparison}, kEverywhere, 0, "Export comparison (CSV)...", has_comparison},
          {ExportFile{FileTask::export_frame}, kEverywhere, 0, "Save this step...", has_sensors},
          {ExportFile{FileTask::export_recording}, kEverywhere, kCtrl | kShift | ImGuiKey_E, "Export recording...",
           has_recorded_sensors},
          {ExportFile{FileTask::export_video}, kEverywhere, 0, "Export video...", can_make_video},
          {MakeFilm{}, kEverywhere, kCtrl | kShift | ImGuiKey_P, "Make a film around the contact", can_make_film}});
  append(rows, kFileMenu, {{TakeScreenshot{}, kEverywhere, kCtrl | ImGuiKey_P, "Save screenshot"}});
  append(rows, kFileMenu, {{Quit{}, kEverywhere, kCtrl | ImGuiKey_Q, "Quit"}});
}

void append_edit_rows(Rows& rows) {
  append(rows, kEditMenu,
         {{UndoStep{}, kEverywhere, kCtrl | ImGuiKey_Z, "Undo", can_undo, nullptr, true},
          {RedoStep{}, kEverywhere, kCtrl | kShift | ImGuiKey_Z, "Redo", can_redo, nullptr, true, kCtrl | ImGuiKey_Y},
          {TogglePanel{&kHistory}, kEverywhere, kCtrl | kAlt | ImGuiKey_Z, "Undo history"}});
  append(rows, kEditMenu,
         {{CopyTaxels{}, kLayout, kCtrl | ImGuiKey_C, "Copy taxels", can_edit_selected},
          {PasteTaxels{}, kLayout, kCtrl | ImGuiKey_V, "Paste taxels", can_edit_layout},
          {BeginGesture{Tool::move, true}, kLayout, kShift | ImGuiKey_D, "Duplicate", can_edit_selected},
          {DeleteSelected{}, kLayout, ImGuiKey_Delete, "Delete", can_edit_selected}});
  append(rows, kEditMenu,
         {{ToggleTool{Tool::place}, kLayout, kShift | ImGuiKey_A, "Place taxels", can_edit_layout},
          {ToggleGenerate{}, kLayout, kCtrl | ImGuiKey_G, "Generate taxels...", can_edit_layout},
          {ToggleTool{Tool::brush}, kLayout, ImGuiKey_Q, "Paint the region", can_edit_layout},
          {ToggleProbe{}, kLayout, ImGuiKey_X, "Press a probe", may_probe, is_probing, false, 0, nullptr, false,
           why_no_probe},
          {ProbeInLayout{}, kSimulate, ImGuiKey_X, "Press a probe, in LAYOUT", has_model, nullptr, false, 0, nullptr,
           false, why_no_probe},
          {ToggleMeasure{}, kLayout, ImGuiKey_M, "Measure", may_measure, is_measuring}});
  append(rows, kTransformMenu,
         {{BeginGesture{Tool::move}, kLayout, ImGuiKey_G, "Move", can_edit_selected},
          {BeginGesture{Tool::turn}, kLayout, ImGuiKey_R, "Turn normals", can_edit_selected},
          {BeginGesture{Tool::resize}, kLayout, ImGuiKey_F, "Change radius", can_edit_selected},
          {BeginGesture{Tool::way_point}, kSimulate, ImGuiKey_G, "Move the way point", has_selected_way_point},
          {ProjectSelectedBack{}, kLayout, kShift | ImGuiKey_N, "Project back to the mesh", can_edit_selected},
          {MirrorSelected{}, kLayout, kCtrl | ImGuiKey_M, "Mirror, linked", can_edit_selected}});
  append(
      rows, kOrderMenu,
      {{RenameSelected{}, kLayout, ImGuiKey_Enter, "Rename in the table", can_edit_selected, nullptr, false,
        ImGuiKey_KeypadEnter},
       {MoveInOrder{true}, kLayout, kAlt | ImGuiKey_UpArrow, "Earlier in the order", can_edit_selected, nullptr, true},
       {MoveInOrder{false}, kLayout, kAlt | ImGuiKey_DownArrow, "Later in the order", can_edit_selected, nullptr,
        true}});
  append(rows, kHideMenu,
         {{HideSelected{}, kLayout, ImGuiKey_H, "Hide", can_edit_selected},
          {EditProject{SetHidden{}, {}}, kLayout, kAlt | ImGuiKey_H, "Show all", has_hidden},
          {ShowOnlySelected{}, kLayout, ImGuiKey_Slash, "Show only these", can_edit_selected}});
  append(rows, kSelectMenu,
         {{ToggleTool{Tool::box}, kLayout, ImGuiKey_B, "Select in a box", can_edit_taxels},
          {ToggleTool{Tool::lasso}, kLayout, kShift | ImGuiKey_B, "Select in a lasso", can_edit_taxels},
          {SelectAll{}, kLayout, ImGuiKey_A, "Select all", has_taxels},
          {SelectNone{}, kLayout, kAlt | ImGuiKey_A, "Select none", has_selection},
          {InvertSelection{}, kLayout, kCtrl | ImGuiKey_I, "Invert selection", has_taxels}});
}

void append_simulation_rows(Rows& rows) {
  append(rows, kModeMenu,
         {{SetMode{Mode::layout}, kEverywhere, kCtrl | ImGuiKey_1, "LAYOUT", has_document, is_in_layout},
          {SetMode{Mode::simulate}, kEverywhere, kCtrl | ImGuiKey_2, "SIMULATE", has_document, is_in_simulate},
          {SetMode{Mode::analyse}, kEverywhere, kCtrl | ImGuiKey_3, "ANALYSE", has_document, is_in_analyse}});
  Rows questions;
  for (const Feature* row : features())
    if (row->analyse.question != nullptr)
      questions.push_back({ShowAnswer{row}, kEverywhere, 0, row->analyse.question, has_document});
  std::ranges::stable_sort(questions, {},
                           [](const Binding& row) { return row.command.get_if<ShowAnswer>()->panel->analyse.tab; });
  append(rows, kModeMenu, std::move(questions));
  append(rows, kSimulationMenu,
         {{PlayOrPause{}, kEverywhere, ImGuiKey_Space, "Run / Pause", has_document},
          {StepOnce{}, kEverywhere, ImGuiKey_RightArrow, "Step forward", has_run, nullptr, true},
          {StepBack{}, kEverywhere, ImGuiKey_LeftArrow, "Step back", has_history, nullptr, true},
          {ToggleBreakOnJump{}, kSimulate, kShift | ImGuiKey_B, "Pause when a taxel jumps", has_history},
          {ExplainReading{}, kSimulate, ImGuiKey_E, "Explain the reading", has_history},
          {CompareLayout{}, kSimulate, 0, "Compare with a layout...", has_sensors},
          {CompareLayout{"", true}, kSimulate, 0, "Compare with the paper's released model", has_sensors},
          {ToggleRecording{}, kSimulate, kCtrl | ImGuiKey_R, "Record", has_history},
          {ToggleRecordPath{}, kSimulate, 0, "Record a path", may_record_path, is_recording_path},
          {ResetSimulation{}, kSimulate, ImGuiKey_Backspace, "Reset", has_run},
          {SelectParentBody{}, kSimulate, ImGuiKey_PageUp, "Select the parent body", may_select_parent}});
  append(rows, kStepsMenu,
         {{GoToEvent{1}, kEverywhere, kShift | ImGuiKey_RightArrow, "Next event", has_history, nullptr, true},
          {GoToEvent{-1}, kEverywhere, kShift | ImGuiKey_LeftArrow, "Previous event", has_history, nullptr, true},
          {GoToNewestStep{}, kEverywhere, ImGuiKey_End, "Latest step", has_history},
          {TogglePlayBackwards{}, kEverywhere, kShift | ImGuiKey_Space, "Play backwards", has_history},
          {ToggleLoop{}, kEverywhere, 0, "Loop", has_history}});
  append(rows, kSimulationMenu,
         {{ChangeSpeed{false}, kEverywhere, ImGuiKey_Minus, "Slower"},
          {ChangeSpeed{true}, kEverywhere, ImGuiKey_Equal, "Faster"}});
}

void append_view_rows(Rows& rows) {
  append(rows, kViewMenu,
         {{FrameCamera{false}, kEverywhere, ImGuiKey_Home, "Frame all", has_scene_box},
          {FrameCamera{true}, kEverywhere, ImGuiKey_Period, "Frame selection or contact", has_selection_box}});
  append(rows, kCameraMenu,
         {{AlignCamera{}, kEverywhere, kCtrl | ImGuiKey_A, "Align camera", has_scene_box},
          {ToggleOrthographic{}, kEverywhere, kAlt | ImGuiKey_5, "Orthographic view", has_scene_box, is_orthographic,
           false, ImGuiKey_Keypad5},
          {StepCamera{1}, kSimulate, ImGuiKey_RightBracket, "Next camera of the scene", has_scene_cameras},
          {StepCamera{-1}, kSimulate, ImGuiKey_LeftBracket, "Previous camera of the scene", has_scene_cameras}});
  append(rows, kCameraMenu,
         {{TakeStandardView{3}, kEverywhere, kAlt | ImGuiKey_1, "Front view", has_scene_box, nullptr, false,
           ImGuiKey_Keypad1},
          {TakeStandardView{2}, kEverywhere, kAlt | kShift | ImGuiKey_1, "Back view", has_scene_box, nullptr, false,
           kCtrl | ImGuiKey_Keypad1},
          {TakeStandardView{0}, kEverywhere, kAlt | ImGuiKey_3, "Right view", has_scene_box, nullptr, false,
           ImGuiKey_Keypad3},
          {TakeStandardView{1}, kEverywhere, kAlt | kShift | ImGuiKey_3, "Left view", has_scene_box, nullptr, false,
           kCtrl | ImGuiKey_Keypad3},
          {TakeStandardView{4}, kEverywhere, kAlt | ImGuiKey_7, "Top view", has_scene_box, nullptr, false,
           ImGuiKey_Keypad7},
          {TakeStandardView{5}, kEverywhere, kAlt | kShift | ImGuiKey_7, "Bottom view", has_scene_box, nullptr, false,
           kCtrl | ImGuiKey_Keypad7}});
  for (const OverlaySpec& overlay : overlays())
    rows.push_back({.command = ToggleOverlay{overlay.on},
                    .context = overlay.context,
                    .chord = overlay.chord,
                    .label = overlay.label,
                    .menu = overlay.menu});
  append(rows, kSceneMenu,
         {{CycleFrames{}, kSimulate, ImGuiKey_F6, "Frames (bodies, geoms, sites, world)", is_simulated, has_frames},
          {CycleLabels{}, kSimulate, ImGuiKey_F7, "Labels (bodies, joints, geoms, sites, cameras)", is_simulated,
           has_labels},
          {TogglePanel{&kInfo}, kSimulate, ImGuiKey_F2, "Info", is_simulated}});
  Rows block;
  constexpr std::array kGeomLabels = {"Geoms of group 0", "Geoms of group 1", "Geoms of group 2",
                                      "Geoms of group 3", "Geoms of group 4", "Geoms of group 5"};
  constexpr std::array kSiteLabels = {"Sites of group 0", "Sites of group 1", "Sites of group 2",
                                      "Sites of group 3", "Sites of group 4", "Sites of group 5"};
  for (std::size_t i = 0; i < kGeomLabels.size(); ++i)
    block.push_back(
        {ToggleGroup{&Overlays::geom_groups, i}, kSimulate, ImGuiKey_0 + static_cast<int>(i), kGeomLabels[i]});
  append(rows, kGroupsMenu, std::exchange(block, {}));
  for (std::size_t i = 0; i < kSiteLabels.size(); ++i)
    block.push_back({ToggleGroup{&Overlays::site_groups, i}, kSimulate, kShift | (ImGuiKey_0 + static_cast<int>(i)),
                     kSiteLabels[i]});
  append(rows, kGroupsMenu, std::exchange(block, {}));
  append(rows, kViewMenu,
         {{ToggleClipPlane{}, kEverywhere, 0, "Clip plane", has_scene_box, has_clip_plane},
          {FlipClipPlane{}, kEverywhere, 0, "Flip the clip plane", has_clip_plane}});
  append(
      rows, kViewMenu,
      {{ToggleRangeLock{}, kEverywhere, 0, "Lock pressure range", nullptr, is_range_locked},
       {ToggleReadingRangeLock{}, kEverywhere, 0, "Lock range of readings", may_lock_readings, is_reading_range_locked},
       {LinkRanges{}, kEverywhere, 0, "One range for surface and readings", may_link_ranges, has_linked_ranges}});
}

void append_window_rows(Rows& rows) {
  Rows block;
  for (const Feature* row : features())
    if (row->label != nullptr) block.push_back({TogglePanel{row}, row->context, row->chord, row->label});
  append(rows, kPanelsMenu, std::exchange(block, {}));
  append(rows, kWindowMenu,
         {{ToggleFullScreen{}, kEverywhere, ImGuiKey_F11, "Full screen", nullptr, is_full_screen, false, ImGuiKey_F5},
          {MaximisePanel{}, kEverywhere, kCtrl | ImGuiKey_Space, "Maximise the panel under the mouse", nullptr,
           is_maximised},
          {ResetArrangement{}, kEverywhere, 0, "Reset arrangement"}});
  append(rows, kWindowMenu,
         {{ToggleTheme{}, kEverywhere, 0, "Light theme", nullptr, is_light},
          {ScaleInterface{1}, kEverywhere, kCtrl | ImGuiKey_Equal, "Larger interface"},
          {ScaleInterface{-1}, kEverywhere, kCtrl | ImGuiKey_Minus, "Smaller interface"},
          {ScaleInterface{0}, kEverywhere, kCtrl | ImGuiKey_0, "Normal size"}});
  for (const studio::Example& example : studio::examples())
    block.push_back({OpenExample{example.name}, kEverywhere, 0, example.label.c_str()});
  append(rows, kExamplesMenu, std::exchange(block, {}));
  append(rows, kExamplesMenu, {{OpenExamples{}, kEverywhere, 0, "Files of the examples..."}});
  append(rows, kHelpMenu,
         {{OpenPalette{}, kEverywhere, kCtrl | ImGuiKey_K, "Find a command..."},
          {TogglePanel{&kGuide}, kEverywhere, 0, "User guide"},
          {ShowGuideOfPanel{}, kEverywhere, kShift | ImGuiKey_Slash, "Guide to the panel under the mouse"},
          {TogglePanel{&kHelp}, kEverywhere, ImGuiKey_F1, "Keys and mouse"}});
  append(rows, kHelpMenu, {{TogglePanel{&kAbout}, kEverywhere, 0, "About Taxel Studio"}});
  append(rows, nullptr,
         {{ConstrainGesture{0}, kGesture, ImGuiKey_X, "Along or about X"},
          {ConstrainGesture{1}, kGesture, ImGuiKey_Y, "Along or about Y"},
          {ConstrainGesture{2}, kGesture, ImGuiKey_Z, "Along or about Z"},
          {AcceptGesture{}, kGesture, ImGuiKey_Enter, "Accept", nullptr, nullptr, false, ImGuiKey_KeypadEnter},
          {CancelTool{}, kGesture, ImGuiKey_Escape, "Cancel: all as it was"},
          {EnterPanel{kInspector.title}, kEverywhere, ImGuiKey_Tab, "Focus the inspector"},
          {EnterPanel{kTaxelTable.title}, kEverywhere, kShift | ImGuiKey_Tab, "Focus the taxel table"},
          {Escape{}, kEverywhere, ImGuiKey_Escape, "Cancel, then clear the selection, then free the camera"}});
}

/// Adds the rows of the nouns, each after the last row of its menu.
void add_rows_of_nouns(Rows& rows) {
  for (const Feature* noun : features()) {
    if (noun->commands == nullptr) continue;
    for (Binding& added : noun->commands()) {
      const std::string_view menu = added.menu != nullptr ? added.menu : "";
      const auto last = std::find_if(rows.rbegin(), rows.rend(), [&](const Binding& row) {
        return !menu.empty() && row.menu != nullptr && row.menu == menu;
      });
      rows.insert(last == rows.rend() ? rows.end() : last.base(), std::move(added));
    }
  }
}

/// A test, and the condition that it tests as a sentence for the user.
struct Need {
  Binding::Test test;
  const char* words;
};

/// Sets the conditions of the rows whose tests are those of this file.
void set_needs(Rows& rows) {
  const std::array kNeeds = {
      Need{has_file, "No file is open"},
      Need{has_project, "No layout is open"},
      Need{can_save_as, "Nothing is open that can be saved"},
      Need{has_document, "Nothing is open"},
      Need{has_run, "Nothing is simulated: the layout has no taxels"},
      Need{has_sensors, "No sensor is simulated"},
      Need{has_history, "No step is recorded yet: run the simulation"},
      Need{has_recorded_sensors, "No step of a sensor is recorded yet"},
      Need{has_plot, "There is no curve yet: run the simulation"},
      Need{has_comparison, "Compare with a second layout first"},
      Need{can_make_video, "No step is recorded yet, or a video is being made"},
      Need{can_make_film, "A video is being made"},
      Need{can_undo, "There is no edit to undo"},
      Need{can_redo, "There is no edit to redo"},
      Need{has_taxels, "The layout has no taxels"},
      Need{can_edit_layout, "No layout is being edited"},
      Need{can_edit_taxels, "The edited layout has no taxels"},
      Need{can_edit_selected, "Select a taxel first"},
      Need{has_hidden, "No taxel is hidden"},
      Need{has_selection, "Nothing is selected"},
      Need{has_scene_box, "The view is empty"},
      Need{has_selection_box, "Select a taxel or a sensor first"},
      Need{is_simulated, "Nothing is simulated"},
      Need{has_clip_plane, "There is no clip plane"},
      Need{may_measure, "There is no mesh to measure on"},
      Need{may_probe, "There is no compiled layout to press"},
      Need{has_model, "No layout is open"},
      Need{has_selected_way_point, "Select a way point of the path first"},
      Need{may_record_path, "There is no tool whose path could be recorded"},
      Need{may_select_parent, "Select a body with a parent first"},
      Need{has_scene_cameras, "The scene has no cameras"},
      Need{may_lock_readings, "Readings share the range of the surface"},
      Need{may_link_ranges, "Readings are no pressures"},
  };
  for (Binding& row : rows)
    for (const Need& need : kNeeds)
      if (row.enabled != nullptr && row.enabled == need.test) row.needs = need.words;
}

Rows all_rows() {
  Rows rows;
  append_file_rows(rows);
  append_edit_rows(rows);
  append_simulation_rows(rows);
  append_view_rows(rows);
  append_window_rows(rows);
  set_needs(rows);
  add_rows_of_nouns(rows);
  return rows;
}

}  // namespace

const Binding& binding_of(const Command& command) {
  return *std::find_if(bindings().begin(), bindings().end(),
                       [&](const Binding& row) { return row.command == command; });
}

std::span<const Binding> bindings() {
  static const Rows rows = all_rows();
  return rows;
}

}  // namespace taxel::ui
