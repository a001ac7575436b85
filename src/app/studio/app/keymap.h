// One table of what can be done: it drives menus, key handlers, F1 help and --list-bindings.
#pragma once

#include <span>
#include <string>

namespace taxel::ui {

/// Where a key counts. /// A gesture that runs comes first, then the focused widget, then the mode.
enum class Context { everywhere, layout, simulate, gesture, widget };

enum class Action {
  open_file,
  open_sweep,
  reload_file,
  close_document,
  screenshot,
  quit,
  play_pause,
  step_forward,
  step_back,
  next_event,
  previous_event,
  newest_step,
  play_backwards,
  loop_range,
  break_on_jump,
  explain,
  record,
  record_path,
  toggle_ghost,
  reset_simulation,
  slower,
  faster,
  save,
  save_as,
  export_layout,
  export_taxels,
  export_samples,
  export_sheet,
  export_picture,
  export_frame,
  export_recording,
  export_video,
  import_recording,
  undo,
  redo,
  copy,
  paste,
  duplicate,
  delete_taxels,
  place,
  move,
  turn,
  resize,
  move_way_point,
  project_back,
  rename_taxel,
  move_up,
  move_down,
  mirror,
  probe,
  measure,
  box_select,
  lasso_select,
  brush,
  generate,
  hide,
  show_all,
  isolate,
  gesture_x,
  gesture_y,
  gesture_z,
  gesture_accept,
  gesture_cancel,
  select_all,
  select_none,
  invert_selection,
  mode_layout,
  mode_simulate,
  frame_all,
  frame_selection,
  align_camera,
  next_camera,
  previous_camera,
  select_parent,
  escape,
  walk_panels,
  walk_panels_back,
  toggle_transparent,
  toggle_wireframe,
  toggle_rays,
  toggle_all_rays,
  toggle_contact,
  toggle_contact_edges,
  toggle_tractions,
  toggle_skin,
  toggle_filtered,
  toggle_samples,
  toggle_normals,
  toggle_taxels,
  toggle_labels,
  toggle_fields,
  toggle_fields_filled,
  toggle_fields_compared,
  toggle_coverage,
  toggle_normal_angles,
  toggle_path,
  toggle_grid,
  toggle_constraints,
  toggle_group_0,
  toggle_group_1,
  toggle_group_2,
  toggle_group_3,
  toggle_group_4,
  toggle_group_5,
  toggle_site_group_0,
  toggle_site_group_1,
  toggle_site_group_2,
  toggle_site_group_3,
  toggle_site_group_4,
  toggle_site_group_5,
  cycle_frames,
  cycle_labels,
  toggle_info,
  toggle_clip,
  flip_clip,
  lock_range,
  toggle_outliner,
  toggle_taxel_table,
  toggle_inspector,
  toggle_controls,
  toggle_bars,
  toggle_plots,
  toggle_timeline,
  toggle_explain,
  toggle_map,
  toggle_models,
  toggle_study,
  toggle_section,
  toggle_messages,
  toggle_mesh_report,
  toggle_profiler,
  full_screen,
  reset_arrangement,
  toggle_theme,
  scale_up,
  scale_down,
  scale_reset,
  help,
  palette,
  tour,
};

struct Binding {
  Action action;
  Context context;
  int chord;     ///< ImGuiKeyChord; 0: menu only
  bool repeats;  ///< while the key is held
  const char* label;
  const char* menu;  ///< the menu it stands in, or "Menu/Submenu"; null: none
  bool separated;    ///< a line stands above it in the menu
  int also = 0;      ///< a second chord
};
std::span<const Binding> bindings();
const Binding& binding_of(Action action);

/// What the mouse does in the 3-D view, for the help.
struct Gesture {
  Context context;
  const char* gesture;
  const char* label;
};
std::span<const Gesture> gestures();

/// "Ctrl+Shift+S"; empty for 0. Needs no ImGui context.
std::string chord_name(int chord);
std::string chord_names(const Binding& binding);  ///< both of them: "Ctrl+Y, Ctrl+Shift+Z"
const char* to_string(Context context);

/// The whole table as aligned text: what --list-bindings prints.
std::string bindings_as_text();

}  // namespace taxel::ui
