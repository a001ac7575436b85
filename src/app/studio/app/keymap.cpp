#include "app/studio/app/keymap.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

namespace taxel::ui {

namespace {

constexpr int kCtrl = ImGuiMod_Ctrl, kShift = ImGuiMod_Shift, kAlt = ImGuiMod_Alt;
constexpr auto kEverywhere = Context::everywhere;
constexpr auto kLayout = Context::layout, kGesture = Context::gesture, kWidget = Context::widget;
constexpr auto kSimulate = Context::simulate;

// Columns: action, context, chord, repeats, label, menu, separated. Order within a menu is the order here.
constexpr std::array kBindings = {
    Binding{Action::open_file, kEverywhere, kCtrl | ImGuiKey_O, false, "Open...", "File", false},
    Binding{Action::open_sweep, kEverywhere, 0, false, "Open fingertip sweep", "File", false},
    Binding{Action::reload_file, kEverywhere, kCtrl | ImGuiKey_L, false, "Reload", "File", false},
    Binding{Action::close_document, kEverywhere, 0, false, "Close", "File", false},
    Binding{Action::save, kEverywhere, kCtrl | ImGuiKey_S, false, "Save", "File", true},
    Binding{Action::save_as, kEverywhere, kCtrl | kShift | ImGuiKey_S, false, "Save as...", "File", false},
    Binding{Action::export_layout, kEverywhere, kCtrl | ImGuiKey_E, false, "Export layout...", "File", false},
    Binding{Action::export_taxels, kEverywhere, 0, false, "Export taxels (CSV)...", "File", false},
    Binding{Action::export_samples, kEverywhere, 0, false, "Export samples (CSV)...", "File", false},
    Binding{Action::export_sheet, kEverywhere, 0, false, "Export sheet to print (HTML)...", "File", false},
    Binding{Action::export_picture, kEverywhere, 0, false, "Export picture (PNG)...", "File", false},
    Binding{Action::export_frame, kEverywhere, 0, false, "Save this step...", "File", false},
    Binding{Action::export_recording, kEverywhere, kCtrl | kShift | ImGuiKey_E, false, "Export recording...", "File",
            false},
    Binding{Action::export_video, kEverywhere, 0, false, "Export video...", "File", false},
    Binding{Action::import_recording, kEverywhere, 0, false, "Import real recording...", "File", false},
    Binding{Action::screenshot, kEverywhere, kCtrl | ImGuiKey_P, false, "Save screenshot", "File", true},
    Binding{Action::quit, kEverywhere, kCtrl | ImGuiKey_Q, false, "Quit", "File", true},

    Binding{Action::undo, kEverywhere, kCtrl | ImGuiKey_Z, true, "Undo", "Edit", false},
    Binding{Action::redo, kEverywhere, kCtrl | kShift | ImGuiKey_Z, true, "Redo", "Edit", false, kCtrl | ImGuiKey_Y},
    Binding{Action::copy, kLayout, kCtrl | ImGuiKey_C, false, "Copy taxels", "Edit", true},
    Binding{Action::paste, kLayout, kCtrl | ImGuiKey_V, false, "Paste taxels", "Edit", false},
    Binding{Action::duplicate, kLayout, kShift | ImGuiKey_D, false, "Duplicate", "Edit", false},
    Binding{Action::delete_taxels, kLayout, ImGuiKey_Delete, false, "Delete", "Edit", false},
    Binding{Action::place, kLayout, kShift | ImGuiKey_A, false, "Place taxels", "Edit", true},
    Binding{Action::generate, kLayout, kCtrl | ImGuiKey_G, false, "Generate taxels...", "Edit", false},
    Binding{Action::brush, kLayout, ImGuiKey_Q, false, "Paint the region", "Edit", false},
    Binding{Action::move, kLayout, ImGuiKey_G, false, "Move", "Edit", false},
    Binding{Action::turn, kLayout, ImGuiKey_R, false, "Turn normals", "Edit", false},
    Binding{Action::resize, kLayout, ImGuiKey_F, false, "Change radius", "Edit", false},
    Binding{Action::move_way_point, kSimulate, ImGuiKey_G, false, "Move the way point", "Edit", false},
    Binding{Action::project_back, kLayout, kShift | ImGuiKey_N, false, "Project back to the mesh", "Edit", false},
    Binding{Action::mirror, kLayout, kCtrl | ImGuiKey_M, false, "Mirror, linked", "Edit", false},
    Binding{Action::probe, kLayout, ImGuiKey_X, false, "Press a probe", "Edit", false},
    Binding{Action::measure, kLayout, ImGuiKey_M, false, "Measure", "Edit", false},
    Binding{Action::rename_taxel, kLayout, ImGuiKey_Enter, false, "Rename in the table", "Edit", true,
            ImGuiKey_KeypadEnter},
    Binding{Action::move_up, kLayout, kAlt | ImGuiKey_UpArrow, true, "Earlier in the order", "Edit", false},
    Binding{Action::move_down, kLayout, kAlt | ImGuiKey_DownArrow, true, "Later in the order", "Edit", false},
    Binding{Action::hide, kLayout, ImGuiKey_H, false, "Hide", "Edit", true},
    Binding{Action::show_all, kLayout, kAlt | ImGuiKey_H, false, "Show all", "Edit", false},
    Binding{Action::isolate, kLayout, ImGuiKey_Slash, false, "Show only these", "Edit", false},
    Binding{Action::box_select, kLayout, ImGuiKey_B, false, "Select in a box", "Edit", true},
    Binding{Action::lasso_select, kLayout, kShift | ImGuiKey_B, false, "Select in a lasso", "Edit", false},
    Binding{Action::select_all, kLayout, ImGuiKey_A, false, "Select all", "Edit", false},
    Binding{Action::select_none, kLayout, kAlt | ImGuiKey_A, false, "Select none", "Edit", false},
    Binding{Action::invert_selection, kLayout, kCtrl | ImGuiKey_I, false, "Invert selection", "Edit", false},

    Binding{Action::mode_layout, kEverywhere, kCtrl | ImGuiKey_1, false, "Layout mode", "Mode", false},
    Binding{Action::mode_simulate, kEverywhere, kCtrl | ImGuiKey_2, false, "Simulate mode", "Mode", false},

    Binding{Action::play_pause, kEverywhere, ImGuiKey_Space, false, "Run / Pause", "Simulation", false},
    Binding{Action::step_forward, kEverywhere, ImGuiKey_RightArrow, true, "Step forward", "Simulation", false},
    Binding{Action::step_back, kEverywhere, ImGuiKey_LeftArrow, true, "Step back", "Simulation", false},
    Binding{Action::next_event, kEverywhere, kShift | ImGuiKey_RightArrow, true, "Next event", "Simulation", false},
    Binding{Action::previous_event, kEverywhere, kShift | ImGuiKey_LeftArrow, true, "Previous event", "Simulation",
            false},
    Binding{Action::newest_step, kEverywhere, ImGuiKey_End, false, "Newest step", "Simulation", false},
    Binding{Action::play_backwards, kEverywhere, kShift | ImGuiKey_Space, false, "Play backwards", "Simulation", false},
    Binding{Action::loop_range, kEverywhere, 0, false, "Loop", "Simulation", false},
    Binding{Action::break_on_jump, kSimulate, kShift | ImGuiKey_B, false, "Pause when a taxel jumps", "Simulation",
            false},
    Binding{Action::explain, kSimulate, ImGuiKey_E, false, "Explain the reading", "Simulation", false},
    Binding{Action::record, kSimulate, kCtrl | ImGuiKey_R, false, "Record", "Simulation", false},
    Binding{Action::record_path, kSimulate, 0, false, "Record a path", "Simulation", false},
    Binding{Action::reset_simulation, kSimulate, ImGuiKey_Backspace, false, "Reset", "Simulation", false},
    Binding{Action::select_parent, kSimulate, ImGuiKey_PageUp, false, "Select the parent body", "Simulation", false},
    Binding{Action::slower, kEverywhere, ImGuiKey_Minus, false, "Slower", "Simulation", true},
    Binding{Action::faster, kEverywhere, ImGuiKey_Equal, false, "Faster", "Simulation", false},

    Binding{Action::frame_all, kEverywhere, ImGuiKey_Home, false, "Frame all", "View", false},
    Binding{Action::frame_selection, kEverywhere, ImGuiKey_Period, false, "Frame selection", "View", false},
    Binding{Action::align_camera, kEverywhere, kCtrl | ImGuiKey_A, false, "Align camera", "View/Camera", false},
    Binding{Action::next_camera, kSimulate, ImGuiKey_RightBracket, false, "Next camera of the scene", "View/Camera",
            false},
    Binding{Action::previous_camera, kSimulate, ImGuiKey_LeftBracket, false, "Previous camera of the scene",
            "View/Camera", false},
    Binding{Action::cycle_frames, kSimulate, ImGuiKey_F6, false, "Frames (bodies, geoms, sites, world)", "View", true},
    Binding{Action::cycle_labels, kSimulate, ImGuiKey_F7, false, "Labels (bodies, joints, geoms, sites, cameras)",
            "View", false},
    Binding{Action::toggle_info, kSimulate, ImGuiKey_F2, false, "Info", "View", false},
    Binding{Action::toggle_transparent, kEverywhere, ImGuiKey_T, false, "Transparent sensor", "View", true},
    Binding{Action::toggle_wireframe, kEverywhere, ImGuiKey_W, false, "Wireframe", "View", false},
    Binding{Action::toggle_rays, kEverywhere, ImGuiKey_Y, false, "Rays", "View", false},
    Binding{Action::toggle_all_rays, kEverywhere, 0, false, "Rays of all taxels", "View", false},
    Binding{Action::toggle_contact, kEverywhere, ImGuiKey_C, false, "Contact surface", "View", false},
    Binding{Action::toggle_contact_edges, kEverywhere, 0, false, "Contact edges", "View", false},
    Binding{Action::toggle_tractions, kEverywhere, ImGuiKey_V, false, "Traction arrows", "View", false},
    Binding{Action::toggle_skin, kEverywhere, ImGuiKey_S, false, "Readings on the skin", "View", false},
    Binding{Action::toggle_ghost, kSimulate, 0, false, "Ghost of the step before", "View", false},
    Binding{Action::toggle_filtered, kEverywhere, 0, false, "Filtered polygons", "View", false},
    Binding{Action::toggle_samples, kEverywhere, ImGuiKey_P, false, "Samples", "View", false},
    Binding{Action::toggle_normals, kEverywhere, ImGuiKey_N, false, "Sample normals", "View", false},
    Binding{Action::toggle_taxels, kEverywhere, 0, false, "Taxels", "View", false},
    Binding{Action::toggle_labels, kEverywhere, 0, false, "Taxel labels", "View", false},
    Binding{Action::toggle_fields, kEverywhere, 0, false, "Receptive fields", "View", false},
    Binding{Action::toggle_fields_filled, kEverywhere, 0, false, "Fields filled", "View", false},
    Binding{Action::toggle_fields_compared, kEverywhere, 0, false, "Fields, straight against geodesic", "View", false},
    Binding{Action::toggle_coverage, kEverywhere, 0, false, "Coverage and overlap", "View", false},
    Binding{Action::toggle_normal_angles, kEverywhere, 0, false, "Taxel normals against the skin's", "View", false},
    Binding{Action::toggle_path, kEverywhere, 0, false, "Path", "View", false},
    Binding{Action::toggle_grid, kEverywhere, 0, false, "Ground grid", "View", false},
    Binding{Action::toggle_constraints, kEverywhere, 0, false, "Welds and connections", "View", false},
    Binding{Action::toggle_group_0, kSimulate, ImGuiKey_0, false, "Geoms of group 0", "View/Groups", false},
    Binding{Action::toggle_group_1, kSimulate, ImGuiKey_1, false, "Geoms of group 1", "View/Groups", false},
    Binding{Action::toggle_group_2, kSimulate, ImGuiKey_2, false, "Geoms of group 2", "View/Groups", false},
    Binding{Action::toggle_group_3, kSimulate, ImGuiKey_3, false, "Geoms of group 3", "View/Groups", false},
    Binding{Action::toggle_group_4, kSimulate, ImGuiKey_4, false, "Geoms of group 4", "View/Groups", false},
    Binding{Action::toggle_group_5, kSimulate, ImGuiKey_5, false, "Geoms of group 5", "View/Groups", false},
    Binding{Action::toggle_site_group_0, kSimulate, kShift | ImGuiKey_0, false, "Sites of group 0", "View/Groups",
            true},
    Binding{Action::toggle_site_group_1, kSimulate, kShift | ImGuiKey_1, false, "Sites of group 1", "View/Groups",
            false},
    Binding{Action::toggle_site_group_2, kSimulate, kShift | ImGuiKey_2, false, "Sites of group 2", "View/Groups",
            false},
    Binding{Action::toggle_site_group_3, kSimulate, kShift | ImGuiKey_3, false, "Sites of group 3", "View/Groups",
            false},
    Binding{Action::toggle_site_group_4, kSimulate, kShift | ImGuiKey_4, false, "Sites of group 4", "View/Groups",
            false},
    Binding{Action::toggle_site_group_5, kSimulate, kShift | ImGuiKey_5, false, "Sites of group 5", "View/Groups",
            false},
    Binding{Action::toggle_clip, kEverywhere, 0, false, "Clip plane", "View", true},
    Binding{Action::flip_clip, kEverywhere, 0, false, "Flip the clip plane", "View", false},
    Binding{Action::lock_range, kEverywhere, 0, false, "Lock pressure range", "View", true},

    Binding{Action::toggle_outliner, kEverywhere, 0, false, "Outliner panel", "Panels", false},
    Binding{Action::toggle_taxel_table, kEverywhere, 0, false, "Taxels panel", "Panels", false},
    Binding{Action::toggle_inspector, kEverywhere, 0, false, "Inspector panel", "Panels", false},
    Binding{Action::toggle_controls, kSimulate, 0, false, "Controls panel", "Panels", false},
    Binding{Action::toggle_bars, kEverywhere, 0, false, "Pressure bars panel", "Panels", false},
    Binding{Action::toggle_plots, kEverywhere, ImGuiKey_F4, false, "Plot panel", "Panels", false},
    Binding{Action::toggle_timeline, kSimulate, 0, false, "Timeline panel", "Panels", false},
    Binding{Action::toggle_explain, kSimulate, 0, false, "Explain panel", "Panels", false},
    Binding{Action::toggle_map, kEverywhere, 0, false, "Taxel map panel", "Panels", false},
    Binding{Action::toggle_models, kSimulate, 0, false, "Models panel", "Panels", false},
    Binding{Action::toggle_study, kSimulate, 0, false, "Study panel", "Panels", false},
    Binding{Action::toggle_section, kEverywhere, 0, false, "Section panel", "Panels", false},
    Binding{Action::toggle_messages, kEverywhere, 0, false, "Messages panel", "Panels", false},
    Binding{Action::toggle_profiler, kEverywhere, ImGuiKey_F3, false, "Profiler panel", "Panels", false},
    Binding{Action::toggle_mesh_report, kEverywhere, 0, false, "Mesh report...", "Panels", false},
    Binding{Action::full_screen, kEverywhere, ImGuiKey_F11, false, "Full screen", "Panels", true, ImGuiKey_F5},
    Binding{Action::reset_arrangement, kEverywhere, 0, false, "Reset arrangement", "Panels", false},
    Binding{Action::toggle_theme, kEverywhere, 0, false, "Light theme", "Panels", true},
    Binding{Action::scale_up, kEverywhere, kCtrl | ImGuiKey_Equal, false, "Larger interface", "Panels", false},
    Binding{Action::scale_down, kEverywhere, kCtrl | ImGuiKey_Minus, false, "Smaller interface", "Panels", false},
    Binding{Action::scale_reset, kEverywhere, kCtrl | ImGuiKey_0, false, "Normal size", "Panels", false},

    Binding{Action::palette, kEverywhere, kCtrl | ImGuiKey_K, false, "Find a command...", "Help", false},
    Binding{Action::help, kEverywhere, ImGuiKey_F1, false, "Keys and mouse", "Help", false},
    Binding{Action::tour, kEverywhere, 0, false, "Tour", "Help", false},
    Binding{Action::gesture_x, kGesture, ImGuiKey_X, false, "Along or about X", nullptr, false},
    Binding{Action::gesture_y, kGesture, ImGuiKey_Y, false, "Along or about Y", nullptr, false},
    Binding{Action::gesture_z, kGesture, ImGuiKey_Z, false, "Along or about Z", nullptr, false},
    Binding{Action::gesture_accept, kGesture, ImGuiKey_Enter, false, "Accept", nullptr, false, ImGuiKey_KeypadEnter},
    Binding{Action::gesture_cancel, kGesture, ImGuiKey_Escape, false, "Cancel: all as it was", nullptr, false},
    Binding{Action::walk_panels, kEverywhere, ImGuiKey_Tab, false, "Into the inspector, by keyboard", nullptr, false},
    Binding{Action::walk_panels_back, kEverywhere, kShift | ImGuiKey_Tab, false, "Into the taxel table, by keyboard",
            nullptr, false},
    Binding{Action::escape, kEverywhere, ImGuiKey_Escape, false,
            "Cancel, then clear the selection, then free the camera", nullptr, false},
};

constexpr std::array kGestures = {
    Gesture{kEverywhere, "Left-drag", "Orbit"},
    Gesture{kEverywhere, "Right-drag", "Pan (Shift: keep the height)"},
    Gesture{kEverywhere, "Wheel, middle-drag", "Zoom"},
    Gesture{kEverywhere, "Shift+wheel", "Move the clip plane"},
    Gesture{kEverywhere, "Right double-click", "Centre on the point"},
    Gesture{kEverywhere, "Click", "Select a taxel (view, table, bars, legend)"},
    Gesture{kEverywhere, "Shift+click", "Add a taxel to the selection, or take it out"},
    Gesture{kSimulate, "Click on the contact surface", "Inspect the polygon (Explain panel)"},
    Gesture{kLayout, "Ctrl+click", "Add a taxel on the surface"},
    Gesture{kLayout, "Drag a selected taxel", "Slide it along the surface"},
    Gesture{kLayout, "Ctrl+wheel", "Change the radius by 2 %"},
    Gesture{kLayout, "Double-click a cell", "Type in the table of taxels (Tab: next cell)"},
    Gesture{kLayout, "Drag a row", "Put taxels elsewhere in the order"},
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
    Gesture{kEverywhere, "Drag in the timeline", "Show a step of the past"},
    Gesture{kEverywhere, "Shift+drag in the timeline", "Loop over these steps (Shift+click: no more)"},
    Gesture{kEverywhere, "Click in a plot", "Show the step at that place"},
    Gesture{kWidget, "Enter", "Take over what a field says, also by leaving it"},
    Gesture{kWidget, "Esc", "Leave a field as it was, close a menu, leave a panel"},
    Gesture{kWidget, "Tab, Shift+Tab", "Next and previous field of the panel"},
    Gesture{kWidget, "Space, arrows, Ctrl+Tab", "Press, choose; next panel, once the keyboard is in one"},
    Gesture{kEverywhere, "Drop a file", "Open a project, layout, mesh, MuJoCo scene or saved step"},
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

std::span<const Binding> bindings() {
  return kBindings;
}

const Binding& binding_of(Action action) {
  return *std::find_if(kBindings.begin(), kBindings.end(), [&](const Binding& b) { return b.action == action; });
}

std::span<const Gesture> gestures() {
  return kGestures;
}

std::string chord_name(int chord) {
  if (chord == 0) return {};
  std::string text;
  if ((chord & ImGuiMod_Ctrl) != 0) text += "Ctrl+";
  if ((chord & ImGuiMod_Alt) != 0) text += "Alt+";
  if ((chord & ImGuiMod_Shift) != 0) text += "Shift+";
  return text + key_name(chord & ~ImGuiMod_Mask_);
}

std::string chord_names(const Binding& binding) {
  const std::string also = chord_name(binding.also);
  return also.empty() ? chord_name(binding.chord) : chord_name(binding.chord) + ", " + also;
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
  for (const Binding& b : kBindings) {
    if (b.chord != 0) text += fmt::format("{:<30} {:<12} {}\n", chord_names(b), to_string(b.context), b.label);
  }
  for (const Gesture& g : kGestures) {
    text += fmt::format("{:<30} {:<12} {}\n", g.gesture, to_string(g.context), g.label);
  }
  return text;
}

}  // namespace taxel::ui
