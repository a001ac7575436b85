// Moves the camera of the demo, repeats its run, and ends both; draws its caption.
#include "app/studio/nouns/demo/demo_state.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

constexpr const char* kTouchTheFinger = "Press X and touch the finger";
constexpr const char* kShowTheJump = "Show the jumping taxel";

/// Draws a ball that touches a skin, as the probe does.
void draw_ball(const Palette& colors, float size) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float radius = 0.36f * size, y = at.y + 0.5f * ImGui::GetFrameHeight();
  const ImVec2 center(at.x + 0.5f * size, y - 0.1f * size);
  list.AddLine({at.x, center.y + radius}, {at.x + size, center.y + radius}, to_u32(colors.dim), 2);
  list.AddCircleFilled(center, radius, to_u32(colors.accent));
  list.AddCircleFilled({center.x - 0.3f * radius, center.y - 0.3f * radius}, 0.3f * radius,
                       IM_COL32(255, 255, 255, 170));
  ImGui::Dummy({size, ImGui::GetFrameHeight()});
}

/// Draws the caption at the lower edge of the view, until the mode changes or one of its buttons is pressed.
void draw_demo_caption(WindowUi& ui, const Viewer& viewer, DemoState& demo) {
  if (viewer.mode != Mode::simulate) demo.invites = false;
  if (!demo.invites || viewer.view.rect.empty()) return;
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize();
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoDocking |
                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                          ImGuiWindowFlags_NoNavInputs;
  ImGui::SetNextWindowPos({viewer.view.rect.center_x(), viewer.view.rect.y1 - 0.8f * line}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.raised);
  if (ImGui::Begin("Demo", nullptr, kFlags)) {
    draw_ball(colors, 1.4f * line);
    ImGui::SameLine();
    if (small_choice(ui, kTouchTheFinger, true)) {
      ui.post(ProbeInLayout{});
      demo.invites = false;
    }
    ImGui::SameLine();
    if (button(ui, kShowTheJump)) {
      ui.post(OpenExample{std::string(studio::kJumpingTaxel)});
      demo.invites = false;
    }
    ImGui::SameLine();
    if (button(ui, "Close")) demo.invites = false;
    tooltip("Help > Examples and Help > Tour show more");
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

constexpr double kSwayDeg = 30, kSwayPeriod = 24;  ///< largest turn to each side, and duration of a round [s]
constexpr double kFollowTime = 1.5;                ///< time constant with which the target follows the contact [s]
constexpr double kApproachTime = 3;                ///< time constant with which the camera comes closer [s]
constexpr double kCloseness = 2;                   ///< distance at the end, in diagonals of the largest sensor

double largest_diagonal(const SimFrame& frame) {
  double largest = 0;
  for (const SensorStep& sensor : frame.sensors) largest = std::max(largest, sensor.model->mesh->bounds().diagonal());
  return largest;
}

/// The part of the way to its goal that an exponential approach covers in `seconds`.
double share_of_way(double seconds, double time_constant) {
  return -std::expm1(-seconds / time_constant);
}

void move_camera(Camera& camera, const SimFrame& frame, DemoState& demo, double seconds) {
  const std::optional<dvec3> contact_W = contact_center(frame);
  if (!demo.start && !contact_W) return;
  if (!demo.start) demo.start = camera;
  demo.seconds += seconds;
  if (contact_W) camera.target += (*contact_W - camera.target) * share_of_way(seconds, kFollowTime);
  camera.azimuth_deg = demo.start->azimuth_deg + kSwayDeg * std::sin(2 * std::numbers::pi * demo.seconds / kSwayPeriod);
  const double closest = std::min(camera.distance, kCloseness * largest_diagonal(frame));
  camera.distance += (closest - camera.distance) * share_of_way(seconds, kApproachTime);
}

}  // namespace

void advance_demo(WindowUi& ui, Viewer& viewer, const RunView& run, DemoState& demo, double seconds) {
  if (!demo.runs || viewer.mode != Mode::simulate || !run.frame || !run.frame->scene) return;
  move_camera(viewer.camera(), *run.frame, demo, seconds);
  if (demo.loops || !run.frame->finished || !run.has_history()) return;
  demo.loops = true;
  ui.post(SetLoop{StepRange{run.frame->history.first, run.frame->history.last}});
  ui.post(ReplayHistory{1});
}

void end_demo(WindowUi& ui, DemoState& demo) {
  if (!demo.runs) return;
  if (demo.loops) ui.post(SetLoop{});
  const bool invites = demo.invites;
  demo = {};
  demo.invites = invites;
}

constinit const Feature kDemo{
    .update =
        [](App& app) {
          advance_demo(*app.ui, *app.viewer, app.shown->run, app.get<DemoState>(), ImGui::GetIO().DeltaTime);
        },
    .draw_card =
        [](App& app) {
          if (app.get<TourState>().step < 0) draw_demo_caption(*app.ui, *app.viewer, app.get<DemoState>());
        },
    .dump = dump_demo,
};

}  // namespace taxel::ui
