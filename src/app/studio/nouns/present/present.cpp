// Begins and ends the presentation, and draws its caption and its bars over the view.
#include "app/studio/nouns/present/present.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/window_state.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "app/studio/nouns/bars/taxel_cells.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/view/view_panel.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

namespace {

/// Number of lines of text that are as high as the window. A projected slide has about as many.
constexpr float kLines = 30;
/// Proportions of a window whose height decides; a window that is higher counts as if it were lower.
constexpr float kAspect = 4.0f / 3;
/// Smallest enlargement of the type.
constexpr float kLeastEnlargement = 1.2f;
constexpr float kBarsHeight = 7.5f, kMostBars = 0.3f;  // in heights of text; fraction of the view's height

/// Returns the name of the scene for an audience: that of its file as words, "hand grasps ball" of
/// hand_grasps_ball.xml.
std::string presented_name(const Viewer& viewer, const Shown& shown) {
  std::string name = displayed_name(viewer, shown);
  if (!shown.document.is_scene || !shown.shows_scene(viewer)) return name;
  name = std::filesystem::path(name).stem().string();
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Returns the time of the displayed step and the force on the sensor, or the force on the probe.
std::string presented_numbers(const Viewer& viewer, const Shown& shown) {
  const std::string force = force_text(viewer, shown, 2);
  if (!shown.shows_scene(viewer) || !shown.run.frame) return force;
  const std::string time = fmt::format("{:.2f} s", shown.run.frame->time);
  return force.empty() ? time : time + "   " + force;
}

/// Draws the readings as bars, or as cells if there are many, at the lower edge of the view.
void draw_presented_bars(WindowUi& ui, Viewer& viewer, const Shown& shown, BarsShown& bars, Rect& box) {
  box = {};
  bars = {};
  const bool probed = viewer.mode == Mode::layout && !shown.shows_scene(viewer) && shown.state(viewer) != nullptr;
  if (viewer.mode == Mode::layout && !probed) return;
  const std::vector<BarGroup> groups = bar_groups(viewer, shown, probed);
  if (groups.empty() || groups.front().values.empty()) return;
  const float line = ImGui::GetFontSize(), margin = 0.6f * line;
  const Rect& view = viewer.view.rect;
  const float height = std::min(kBarsHeight * line, kMostBars * view.height());
  box = {view.x0 + margin, view.y1 - margin - height, view.x1 - margin, view.y1 - margin};
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNavInputs;
  ImGui::SetNextWindowPos({box.x0, box.y0});
  ImGui::SetNextWindowSize({box.width(), box.height()});
  ImGui::SetNextWindowBgAlpha(0.94f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.5f * line, 0.3f * line));
  if (ImGui::Begin("Presented readings", nullptr, kFlags)) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool fits = fits_as_bars(groups, room.x, static_cast<float>(ui.pixel_scale));
    const auto clicked = fits ? draw_pressure_bars(ui, viewer, bars, groups, room, true)
                              : draw_taxel_cells(ui, viewer, bars, groups, room);
    if (clicked) click_taxel_of(viewer.selection, {clicked->sensor, clicked->id}, ImGui::GetIO().KeyShift);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

bool is_presenting(const App& app) {
  return app.get<WindowParts>().is_presenting;
}

/// Frames from the end of the presentation to the return of the panels. The bars at the edges come first, so that the
/// panels find the room that they had; otherwise they would share the difference.
constexpr int kFramesToRestore = 2;

void restore_panels(App& app) {
  PresentState& state = app.get<PresentState>();
  if (state.frames_to_restore > 0 && --state.frames_to_restore == 0)
    app.get<Arrangement>().maximised = std::exchange(state.was_maximised, "");
}

bool has_something(const App& app) {
  return app.shown->document.model != nullptr || app.shown->run.frame != nullptr;
}

std::vector<Binding> presentation_rows() {
  return {{.command = TogglePresentation{},
           .chord = ImGuiKey_F9,
           .label = "Present",
           .enabled = has_something,
           .checked = is_presenting,
           .menu = "View",
           .needs = "Nothing is open"}};
}

}  // namespace

float presentation_scale(float width, float height, float scale) {
  return std::max(kLeastEnlargement * scale, std::min(height, width / kAspect) / (kLines * kTextHeight));
}

namespace {

void look_at_contact(App& app) {
  const Aabb contact_W = contact_box(*app.viewer, *app.shown);
  if (contact_W.empty() || !has_untouched_camera(app)) return;
  PresentedCamera& camera = app.get<PresentState>().camera.emplace();
  camera = {app.viewer->mode, app.viewer->camera(), app.viewer->camera()};
  camera.at_contact.frame(contact_W);
  app.viewer->camera() = camera.at_contact;
}

void look_as_before(App& app) {
  const std::optional<PresentedCamera> camera = std::exchange(app.get<PresentState>().camera, std::nullopt);
  if (!camera) return;
  Camera& present = app.viewer->cameras[camera->mode == Mode::layout ? 0 : 1];
  if (present == camera->at_contact) present = camera->before;
}

}  // namespace

void carry_out(const TogglePresentation&, App& app) {
  bool& presents = app.get<WindowParts>().is_presenting;
  PresentState& state = app.get<PresentState>();
  presents = !presents;
  state.caption = state.bars = {};
  presents ? look_at_contact(app) : look_as_before(app);
  if (!presents) {
    state.frames_to_restore = kFramesToRestore;
  } else if (std::exchange(state.frames_to_restore, 0) == 0) {
    state.was_maximised = std::exchange(app.get<Arrangement>().maximised, std::string(kViewTitle));
  }
}

void show_all_parts(App& app) {
  PresentState& state = app.get<PresentState>();
  if (is_presenting(app)) carry_out(TogglePresentation{}, app);
  app.get<WindowParts>().has_few = false;
  (state.frames_to_restore > 0 ? state.was_maximised : app.get<Arrangement>().maximised).clear();
}

void draw_presentation_caption(WindowUi& ui, const Viewer& viewer, const Shown& shown, PresentState& state) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), pad = 0.4f * line, legend = 7 * line;
  const Rect& view = viewer.view.rect;
  const std::string numbers = presented_numbers(viewer, shown);
  const float number_width = numbers.empty() ? 0 : ImGui::CalcTextSize(numbers.c_str()).x + line;
  const float room = view.width() - legend - number_width - 2 * line - 2 * pad;
  const std::string name = shortened(presented_name(viewer, shown), room, 1);
  const float name_width = ImGui::CalcTextSize(name.c_str()).x;
  const ImVec2 at(view.x0 + 0.6f * line, view.y0 + 0.6f * line);
  state.caption = {at.x, at.y, at.x + name_width + number_width + 2 * pad, at.y + line + 2 * pad};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {state.caption.x1, state.caption.y1}, to_u32(colors.panel, 0.8f), 0.2f * line);
  list.AddText({at.x + pad, at.y + pad}, to_u32(colors.text), name.c_str());
  list.AddText({at.x + pad + name_width + line, at.y + pad}, to_u32(colors.dim), numbers.c_str());
  ui.widgets.note("Presentation", name + "   " + numbers, state.caption);
}

constinit const Feature kPresent{
    .begin_frame = restore_panels,
    .draw_card =
        [](App& app) {
          if (is_presenting(app))
            draw_presented_bars(*app.ui, *app.viewer, *app.shown, app.get<BarsShown>(), app.get<PresentState>().bars);
        },
    .tool = {"presentation", kEverywhere, nullptr, 0, is_presenting,
             [](App& app) { carry_out(TogglePresentation{}, app); }},
    .commands = presentation_rows,
    .dump = dump_presentation,
};

}  // namespace taxel::ui
