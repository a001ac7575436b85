// Moves the camera of the demo, repeats its contact, and ends both; draws its caption.
#include "app/studio/nouns/demo/demo_state.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_state.h"
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
  if (!shows_run(viewer.mode)) demo.invites = false;
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

/// Direction from which the demo looks [deg]: at the side of the leaning finger, and down on the contact, which is
/// nearly level.
constexpr double kDemoAzimuthDeg = -122, kDemoElevationDeg = 50;
/// Field of view of the demo's camera [deg]. With a wider one, the eye of a view this close would be inside the finger.
constexpr double kDemoFovDeg = 20;
constexpr double kSwayDeg = 24, kSwayPeriod = 24;  ///< largest turn to each side, and duration of a round [s]
constexpr double kFollowTime = 0.2;                ///< time constant with which the target follows the contact [s]
/// Distance of the camera in a square view, in diagonals of the largest sensor. The contact at its largest, 15 mm^2 of
/// a finger of 38 mm, then covers 4.5 % of a view of any proportions.
constexpr double kCloseness = 1.48;
constexpr double kReachOfDemo = 0.0055;    ///< least distance from the edge at both ends of the sweep [m]
constexpr double kLoopMargin = 0.001;      ///< travel before and after the contact that the loop plays [m]
constexpr double kLoopSpeed = 0.25;        ///< speed of the loop, in multiples of real time
constexpr double kLongestInterval = 0.25;  ///< a run that is at rest for longer has ended [s]

double largest_diagonal(const SimFrame& frame) {
  double largest = 0;
  for (const SensorStep& sensor : frame.sensors) largest = std::max(largest, sensor.model->mesh->bounds().diagonal());
  return largest;
}

/// Returns the lowest point of all sensors [m], world, which is nearest to the object of a scenario.
dvec3 lowest_point(const SimFrame& frame) {
  dvec3 lowest_W(0, 0, std::numeric_limits<double>::infinity());
  for (const SensorStep& sensor : frame.sensors)
    for (const dvec3& p_M : sensor.model->mesh->vertices())
      if (const dvec3 p_W = sensor.X_WM * p_M; p_W.z < lowest_W.z) lowest_W = p_W;
  return lowest_W;
}

/// The part of the way to its goal that an exponential approach covers in `seconds`.
double share_of_way(double seconds, double time_constant) {
  return -std::expm1(-seconds / time_constant);
}

void move_camera(Viewer& viewer, const SimFrame& frame, DemoState& demo, double seconds) {
  if (frame.sensors.empty() || viewer.view.rect.empty()) return;
  Camera& camera = viewer.camera();
  const std::optional<dvec3> contact_W = contact_center(frame);
  if (!demo.start) {
    camera.target = contact_W.value_or(lowest_point(frame));
    camera.azimuth_deg = kDemoAzimuthDeg;
    camera.elevation_deg = kDemoElevationDeg;
    camera.fov_deg = kDemoFovDeg;
    demo.start = camera;
  }
  demo.seconds += seconds;
  const auto aspect = static_cast<double>(viewer.view.rect.width() / viewer.view.rect.height());
  camera.distance = kCloseness / std::sqrt(aspect) * largest_diagonal(frame);
  if (contact_W) camera.target += (*contact_W - camera.target) * share_of_way(seconds, kFollowTime);
  camera.azimuth_deg = demo.start->azimuth_deg + kSwayDeg * std::sin(2 * std::numbers::pi * demo.seconds / kSwayPeriod);
}

bool touches(const HistoryLanes& lanes, std::size_t row) {
  for (std::size_t sensor = 0; sensor < lanes.sensor_count; ++sensor)
    if (lanes.sensor(row, sensor).area > 0) return true;
  return false;
}

/// Returns whether the user, or a breakpoint, has stopped the demo. A run that has just ended was not stopped.
bool is_stopped(const RunView& run, DemoState& demo, double seconds) {
  demo.replays = demo.replays || (demo.loops && run.replay != 0);
  if (demo.loops) return demo.replays && run.replay == 0;
  demo.begun = demo.begun || run.playing;
  demo.rests = run.playing || !demo.begun || run.frame->finished ? 0 : demo.rests + seconds;
  return demo.rests > kLongestInterval;
}

}  // namespace

Scenario demo_scenario() {
  Scenario scenario;
  auto& sweep = scenario.as<scenarios::Sweep>();
  sweep.before = sweep.past = kReachOfDemo;
  return scenario;
}

StepRange contact_steps(const HistoryState& history) {
  const HistoryLanes& lanes = *history.lanes;
  const std::size_t rows = lanes.rows();
  std::size_t first = 0;
  while (first < rows && !touches(lanes, first)) ++first;
  if (first == rows) return {history.first, history.last};
  std::size_t last = rows - 1;
  while (!touches(lanes, last)) --last;
  const double begin = lanes.steps[first].travel - kLoopMargin, end = lanes.steps[last].travel + kLoopMargin;
  while (first > 0 && lanes.steps[first - 1].travel >= begin) --first;
  while (last + 1 < rows && lanes.steps[last + 1].travel <= end) ++last;
  return {lanes.steps[first].step, lanes.steps[last].step};
}

void advance_demo(WindowUi& ui, Viewer& viewer, const RunView& run, DemoState& demo, double seconds) {
  if (!demo.runs || !run.frame || !run.frame->scene) return;
  if (!shows_run(viewer.mode) || is_stopped(run, demo, seconds)) return end_demo(ui, run, demo);
  if (demo.leads) move_camera(viewer, *run.frame, demo, seconds);
  if (demo.loops || !run.frame->finished || !run.has_history()) return;
  demo.loops = true;
  const StepRange contact = contact_steps(run.frame->history);
  ui.post(SetLoop{contact});
  ui.post(ScrubTo{contact.first});
  if (run.speed == 1) ui.post(SetSpeed{kLoopSpeed});
  ui.post(ReplayHistory{1});
}

void end_demo(WindowUi& ui, const RunView& run, DemoState& demo) {
  if (!demo.runs) return;
  if (demo.loops) ui.post(SetLoop{});
  if (demo.loops && run.speed == kLoopSpeed) ui.post(SetSpeed{1});
  const bool invites = demo.invites;
  demo = {};
  demo.invites = invites;
}

constinit const Feature kDemo{
    .update =
        [](App& app) {
          DemoState& demo = app.get<DemoState>();
          if (is_modal_open()) return;  // the run rests behind the dialog
          advance_demo(*app.ui, *app.viewer, app.shown->run, demo, ImGui::GetIO().DeltaTime);
          if (!demo.runs || !demo.invites) app.get<WindowParts>().has_few = false;
        },
    .draw_card =
        [](App& app) {
          if (app.get<TourState>().step < 0 && !app.get<WindowParts>().is_presenting)
            draw_demo_caption(*app.ui, *app.viewer, app.get<DemoState>());
        },
    .dump = dump_demo,
};

}  // namespace taxel::ui
