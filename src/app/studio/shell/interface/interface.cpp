#include "app/studio/shell/interface/interface.h"

#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/pointer_event.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/fields/fields.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/present/present.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/profiler/profiler_state.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/nouns/view/view_panel.h"
#include "app/studio/nouns/view/view_state.h"
#include "app/studio/shell/interface/carry_out.h"
#include "app/studio/shell/interface/dock_layout.h"
#include "app/studio/shell/menus/menus.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {
namespace {

/// Draws the features over the scene, and their hints, a line each, which labels avoid. Returns the number of lines.
int draw_on_view(const App& app, CoveredBoxes& covered) {
  std::vector<ViewHint> hints;
  for (const Feature* row : features()) {
    if (row->draw_on_view != nullptr && app.viewer->mode == Mode::layout) row->draw_on_view(app);
    if (row->hint != nullptr) row->hint(app, hints);
  }
  const Palette& colors = palette(app.ui->dark);
  covered.skip();
  int line = 0;
  for (const ViewHint& hint : hints) {
    if (hint.text.empty()) continue;
    draw_view_line(*app.ui, app.viewer->view, *ImGui::GetWindowDrawList(), line++, hint.text,
                   hint.is_problem ? colors.error : colors.text);
    covered.add();
  }
  return line;
}

LegendScales legend_scales(const Viewer& viewer, const Shown& shown) {
  return {viewer.range, reading_range(viewer, shown), unit_of_readings(viewer, shown), shares_range(viewer, shown)};
}

/// Returns whether the legend of colours is drawn. The small view of ANALYSE may be too narrow: the legend would cover
/// the contact.
bool has_pressure_legend(const Viewer& viewer, const Shown& shown) {
  constexpr float kLeastWidth = 30;  // heights of text
  const bool has_room = viewer.mode != Mode::analyse || viewer.view.rect.width() > kLeastWidth * ImGui::GetFontSize();
  return has_room && shows_pressure(viewer, shown);
}

/// Places the buttons of the legend and carries out their clicks.
void handle_legend(App& app, const LegendScales& scales) {
  const LegendClicks clicks = place_legend_buttons(*app.ui, scales, legend_place(app.viewer->view, scales));
  if (clicks.surface) carry_out_if_enabled(ToggleRangeLock{}, app);
  if (clicks.readings) carry_out_if_enabled(ToggleReadingRangeLock{}, app);
  if (clicks.link) carry_out_if_enabled(LinkRanges{}, app);
}

/// Returns the part of the view for legends in the lower right corner. It ends at the legend of colours if there is
/// little room below that legend.
ViewPlace place_beside(const ViewPlace& view, const LegendPlace& legend) {
  constexpr float kRoomBelow = 14;  // heights of text
  const float line = ImGui::GetFontSize();
  ViewPlace place = view;
  if (view.rect.y1 - (legend.corner.y + legend.height) < kRoomBelow * line)
    place.rect.x1 = legend.corner.x - legend.width + 0.3f * line;
  return place;
}

/// Draws the legends in the lower right corner, one above the other.
void draw_low_legends(App& app, const ViewPlace& place) {
  float bottom = place.rect.y1 - 0.7f * ImGui::GetFontSize();
  if (app.viewer->overlays().filtered_polygons && shows_pressure(*app.viewer, *app.shown))
    bottom = draw_filtered_legend(*app.ui, place, *app.shown->state(*app.viewer)) - 0.5f * ImGui::GetFontSize();
  if (const SensorModelPtr model = app.shown->model(*app.viewer))
    draw_field_legends(*app.ui, place, app.get<ViewShown>().numbers, *model, bottom);
}

/// Returns the box of the gizmo of the axes.
Rect gizmo_box(const ViewPlace& place, double scale) {
  const dvec2 center = scale * gizmo_center(dvec2(place.width, place.height) / scale);
  const auto reach = static_cast<float>(scale * (kGizmoReach + kGizmoBallRadius));
  const float x = place.rect.x0 + static_cast<float>(center.x), y = place.rect.y0 + static_cast<float>(center.y);
  return {x - reach, y - reach, x + reach, y + reach};
}

/// Draws the caption, the legend and the labels over the scene while it is presented.
void draw_over_presented(App& app, LegendScales scales) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  CoveredBoxes covered(list, app.viewer->view);
  PresentState& present = app.get<PresentState>();
  draw_presentation_caption(*app.ui, *app.viewer, *app.shown, present);
  covered.add();
  scales.has_buttons = false;
  // Readings are in the bars, which have an axis of their own, unless the user colours the skin by them.
  scales.linked = scales.linked || !app.viewer->overlays().readings_on_skin;
  ViewPlace above = app.viewer->view;
  if (!present.bars.empty()) above.rect.y1 = present.bars.y0;
  if (shows_pressure(*app.viewer, *app.shown)) draw_pressure_legend(*app.ui, scales, legend_place(above, scales));
  covered.add();
  covered.add(present.bars);
  place_labels(app.viewer->view, app.get<ViewShown>(), covered.boxes());
  draw_labels(*app.ui, app.viewer->view, app.get<ViewShown>(), list);
  draw_hover_tooltip(*app.viewer, *app.shown);
}

/// Draws the texts and legends over the scene, and then the labels where they do not cover any of these. Returns the
/// first line below the heading that is free.
int draw_over_scene(App& app, const LegendScales& scales) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  CoveredBoxes covered(list, app.viewer->view);
  const bool has_legend = has_pressure_legend(*app.viewer, *app.shown);
  const LegendPlace legend = legend_place(app.viewer->view, scales);
  if (app.shown->document.model || app.shown->run.frame)
    draw_heading(*app.ui, *app.viewer, *app.shown, has_legend ? legend.width : 0, list);
  covered.add();
  if (has_legend) draw_pressure_legend(*app.ui, scales, legend);
  covered.add();
  draw_low_legends(app, has_legend ? place_beside(app.viewer->view, legend) : app.viewer->view);
  covered.add();
  if (const SensorModelPtr model = app.shown->model(*app.viewer)) {
    draw_repair_legend(*app.ui, *app.viewer, app.get<MeshState>(), *model,
                       legend.corner.y + (has_legend ? legend.height + ImGui::GetFontSize() : 0));
  }
  covered.add();
  draw_border(*app.ui, *app.viewer, list);
  draw_hover_tooltip(*app.viewer, *app.shown);
  const int hints = draw_on_view(app, covered);
  int row = draw_view_name(*app.ui, *app.viewer, list, hints);
  row = draw_scene_overlay(*app.ui, *app.viewer, app.shown->run, app.get<FollowState>(), app.get<ViewShown>(), row);
  covered.add();
  if (!app.get<PanelsShown>()[kInfo] || !shows_run(app.viewer->mode))  // the card with information is there
    draw_mark_legend(
        *app.ui, app.viewer->view,
        mark_rows(app.get<ViewShown>().input, app.get<ViewShown>().numbers, unit_of_readings(*app.viewer, *app.shown)),
        view_line_top(app.viewer->view, row) + 0.2f * ImGui::GetFontSize(), rects_to_see(*app.viewer, *app.shown),
        app.get<ViewShown>().folds_legend);
  covered.add();
  covered.add(app.viewer->view.tools);
  covered.add(gizmo_box(app.viewer->view, app.ui->pixel_scale));
  place_labels(app.viewer->view, app.get<ViewShown>(), covered.boxes());
  draw_labels(*app.ui, app.viewer->view, app.get<ViewShown>(), list);
  return row;
}

}  // namespace

void draw_view(App& app, SceneRenderer& renderer) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const bool visible =
      begin_panel(*app.ui, kViewTitle, nullptr, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  int free_row = 0;
  const ImVec2 size = ImGui::GetContentRegionAvail();
  const int width = static_cast<int>(size.x), height = static_cast<int>(size.y);
  if (visible && width > 0 && height > 0) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    app.viewer->view.rect = {corner.x, corner.y, corner.x + static_cast<float>(width),
                             corner.y + static_cast<float>(height)};
    constexpr auto kButtons =
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle;
    const LegendScales scales = legend_scales(*app.viewer, *app.shown);
    const bool is_presenting = app.get<WindowParts>().is_presenting;
    if (!is_presenting && has_pressure_legend(*app.viewer, *app.shown)) handle_legend(app, scales);
    ImGui::SetCursorScreenPos(corner);
    ImGui::InvisibleButton("##view", size, kButtons);
    app.ui->widgets.note_item("View");
    handle_view_mouse(app);
    render_if_changed(*app.viewer, app.get<ProfileState>(), app.get<ViewShown>(), scene_input(app), renderer, width,
                      height);
    const ImTextureRef texture(static_cast<ImTextureID>(renderer.texture()));
    const Rect& r = app.viewer->view.rect;  // rows of GL textures run upward
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCallback(ImGui::GetPlatformIO().DrawCallback_SetSamplerNearest, nullptr);  // pixel by pixel
    list.AddImage(texture, {r.x0, r.y0}, {r.x1, r.y1}, {0, 1}, {1, 0});
    list.AddCallback(ImGui::GetPlatformIO().DrawCallback_SetSamplerLinear, nullptr);
    is_presenting ? draw_over_presented(app, scales) : void(free_row = draw_over_scene(app, scales));
  }
  ImGui::End();
  if (app.get<WindowParts>().is_presenting) return;
  if (visible) draw_info_card(*app.ui, *app.viewer, app.shown->run, app.get<PanelsShown>(), free_row);
  const bool shows_study = is_drawn(kStudy, app) && app.get<StudyState>().shown.curves;
  if (!app.shown->document.model && !app.shown->run.frame && !app.shown->document.loading.active && !shows_study)
    draw_start_card(*app.ui, app.viewer->view, app.get<FilesState>().examples, app.get<FileDialog>(),
                    app.get<FilesState>().recent, !app.get<TourState>().seen);
  draw_probe_panel(*app.ui, *app.viewer, *app.shown, app.get<ProbeState>());
}

namespace {

bool is_valid(Context context, Mode mode) {
  return context == kEverywhere || (context == kLayout) == (mode == Mode::layout);
}

}  // namespace

void handle_view_mouse(App& app) {
  const PointerEvent event = read_pointer(app.viewer->view);
  app.viewer->hovered.reset();
  for (const Feature* row : features()) {
    const ToolSpec& tool = row->tool;
    if (tool.pointer != nullptr && is_valid(tool.context, app.viewer->mode) && tool.pointer(app, event)) return;
  }
}

namespace {

/// Calls a member of all rows that have it.
template <auto Feature::*kCall>
void of_each_feature(App& app) {
  for (const Feature* row : features())
    if (row->*kCall != nullptr) (row->*kCall)(app);
}

/// The tabs of ANALYSE and those of the column in a compact window stay: they fit into a narrow column without buttons
/// to close them. Panels that open by their own state have a button of their own.
void fix_tabs(App& app) {
  app.ui->fixed.clear();
  if (!has_narrow_tabs(app)) return;
  const bool analyses = app.viewer->mode == Mode::analyse;
  const auto is_in_column = [](Dock dock) {
    return dock == Dock::outline || dock == Dock::taxels || dock == Dock::inspector;
  };
  for (const Feature* row : features())
    if (analyses ? row->analyse.tab > 0 : (row->open || row->opens == Opens::never) && is_in_column(row->dock))
      app.ui->fixed.push_back(row->title);
}

void draw_panels(App& app, SceneRenderer& renderer) {
  const Arrangement& arrangement = app.get<Arrangement>();
  if (has_room(arrangement, kViewTitle, Dock::inspector)) {
    draw_view(app, renderer);
  } else {
    app.viewer->view.rect = {};
  }
  for (const Feature* row : features())
    if (is_drawn(*row, app) && has_room(arrangement, row->title, dock_in(app.viewer->mode, *row))) row->draw(app);
}

}  // namespace

namespace {

void draw_bars_at_top(App& app) {
  draw_menu_bar(app);
  draw_toolbar(app);
}

/// Takes the keyboard from the menus, which are not drawn.
void close_menus(App& app) {
  app.get<MenuKeys>() = {};
  app.ui->fields.in_menus = false;
}

void leave_out_tool_strip(App& app) {
  app.viewer->view.strip = 0;
  app.viewer->view.tools = {};
}

}  // namespace

void draw_interface(App& app, SceneRenderer& renderer) {
  app.ui->widgets.begin_frame();
  fix_tabs(app);
  of_each_feature<&Feature::begin_frame>(app);
  handle_keys(app);
  const bool is_presenting = app.get<WindowParts>().is_presenting;
  is_presenting ? close_menus(app) : draw_bars_at_top(app);
  of_each_feature<&Feature::draw_bar>(app);
  draw_dock_space(app);
  of_each_feature<&Feature::update>(app);
  draw_panels(app, renderer);
  draw_guide_buttons(app);
  of_each_feature<&Feature::end_panels>(app);
  app.get<WindowParts>().is_presenting ? leave_out_tool_strip(app) : draw_tool_strip(app);
  draw_palette(app);
  of_each_feature<&Feature::draw_card>(app);
  record_keyboard(*app.ui, app.viewer->selection.taxels);
}

void rest_demo_camera(App& app) {
  DemoState& demo = app.get<DemoState>();
  demo.leads = demo.leads && !demo.start;
}

void follow_opened_document(App& app) {
  DemoState& demo = app.get<DemoState>();
  if (demo.begun) end_demo(*app.ui, app.shown->run, demo);
  demo.invites = demo.runs;
}

void explain_largest_step(App& app) {
  show_largest_change(*app.ui, app.get<RunAhead>());
}

void forget_document(App& app) {
  app.ui->fields.refused.reset();
  app.viewer->selection = {};
  app.viewer->clip.reset();
  app.states.forget_document();
}

}  // namespace taxel::ui
