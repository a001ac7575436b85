// Texts over the 3-D view about the scene, and its information as a card (F2).
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/view/view_state.h"
#include "core/base/text/rounded.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_parts.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

void add_solver(const SimFrame& frame, std::vector<InfoRow>& rows) {
  const StepFacts& facts = frame.facts;
  const SceneMarks& marks = frame.scene->marks;
  const auto number = [](std::int32_t count) { return static_cast<std::size_t>(std::max(count, 0)); };
  const std::string islands = facts.islands > 0 ? " in " + counted(number(facts.islands), "island", "islands") : "";
  rows.push_back({"Contacts", fmt::format("{} of MuJoCo, {}{}", grouped(facts.contacts),
                                          counted(number(facts.constraints), "constraint", "constraints"), islands)});
  rows.push_back(
      {"Solver", fmt::format("{}, {}", marks.solver, counted(number(facts.iterations), "iteration", "iterations"))});
  rows.push_back({"Energy", facts.energy
                                ? fmt::format("potential {} J, kinetic {} J", rounded(facts.energy->potential, 4, 6),
                                              rounded(facts.energy->kinetic, 4, 6))
                                : "off: <flag energy=\"enable\"/>"});
  const double used = static_cast<double>(facts.arena),
               all = static_cast<double>(std::max<std::uint64_t>(marks.arena, 1));
  rows.push_back({"Memory", fmt::format("{} of {}, {:.1f} %", bytes_text(used), bytes_text(all), 100 * used / all)});
}

void add_sensors(const SimFrame& frame, std::vector<InfoRow>& rows) {
  if (frame.sensors.empty()) return;
  std::size_t polygons = 0, rays = 0, hits = 0;
  for (const SensorStep& sensor : frame.sensors) {
    for (const ContactSurface& surface : sensor.surfaces) polygons += surface.polygons.size();
    rays += sensor.hits.size();
    hits += static_cast<std::size_t>(
        std::count_if(sensor.hits.begin(), sensor.hits.end(), [](const RayHit& hit) { return hit.hit(); }));
  }
  rows.push_back(
      {"Sensors", fmt::format("{}: {}, {} of {} hit", frame.sensors.size(), counted(polygons, "polygon", "polygons"),
                              grouped(static_cast<long long>(hits)), counted(rays, "ray", "rays"))});
}

std::string size_text(const SimFrame& frame) {
  const SimScene& scene = *frame.scene;
  std::string text = counted(scene.geoms.size(), "geom", "geoms");
  if (frame.mark_poses.bodies.empty()) return text;  // a saved step has no poses
  const auto dofs = static_cast<std::size_t>(scene.marks.dofs);
  return fmt::format("{}, {}, {}", counted(frame.mark_poses.bodies.size() - 1, "body", "bodies"), text,
                     counted(dofs, "DOF", "DOFs"));
}

}  // namespace

std::vector<InfoRow> scene_info(const RunView& run) {
  std::vector<InfoRow> rows;
  if (!run.frame || !run.frame->scene) return rows;
  const SimFrame& frame = *run.frame;
  rows.push_back(
      {"Time", fmt::format("{:.4f} s, step {} of {:.4g} ms", frame.time, frame.step, 1e3 * frame.scene->timestep)});
  const Performance& p = run.performance;
  if (p.is_real_time && p.step_seconds > 0) {
    const std::string speed = run.playing ? fmt::format(", {:.2f} x real time", p.simulation_speed) : "";
    rows.push_back({"Pace", duration_text(p.step_seconds) + " a step" + speed});
  }
  rows.push_back({"Size", size_text(frame)});
  if (!frame.mark_poses.bodies.empty()) add_solver(frame, rows);
  add_sensors(frame, rows);
  rows.push_back({"History", fmt::format("{}, {}", counted(frame.history.steps, "step", "steps"),
                                         bytes_text(static_cast<double>(frame.history.bytes)))});
  return rows;
}

namespace {

constexpr float kWideView = 36;  // width with room for two texts next to each other, in heights of text
constexpr float kBackground = 0.88f;

/// Returns the name of a kind, such as "sites", with a note if the scene has none of the kind.
std::string kind_text(const char* kind, bool none) {
  return none ? fmt::format("{} (none)", kind) : kind;
}

std::string frames_text(const Overlays& overlays, const ViewShown& view) {
  const FramesShown frames = overlays.frames;
  return frames == FramesShown::none ? "" : "Frames: " + kind_text(to_word(frames), shown_frames(view.input).empty());
}

std::string labels_text(const Overlays& overlays, const ViewShown& view) {
  const LabelsShown labels = overlays.labels;
  return labels == LabelsShown::none ? ""
                                     : "Labels: " + kind_text(to_word(labels), labelled_places(view.input).empty());
}

std::string body_text(const Selection& selection, const RunView& run) {
  const std::vector<SceneBody>& bodies = run.frame->scene->controls.bodies;
  const auto body = static_cast<std::size_t>(selection.body);
  return selection.body >= 0 && body < bodies.size() ? "Body: " + bodies[body].name : "";
}

/// Returns the height of a row whose value wraps at `width`.
float height_of(const InfoRow& row, float width) {
  return ImGui::CalcTextSize(row.value.c_str(), nullptr, false, width).y + ImGui::GetStyle().ItemSpacing.y;
}

}  // namespace

int draw_scene_overlay(const WindowUi& ui, const Viewer& viewer, const RunView& run, const FollowState& follow,
                       const ViewShown& view, int row) {
  if (!shows_run(viewer.mode) || !run.frame || !run.frame->scene) return row;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& colors = palette(ui.dark);
  std::string frames = frames_text(viewer.overlays(), view), labels = labels_text(viewer.overlays(), view);
  if (viewer.view.rect.width() > kWideView * ImGui::GetFontSize() && !frames.empty() && !labels.empty())
    frames += "   " + std::exchange(labels, "");
  for (const std::string& text : {follow_text(viewer, run, follow), body_text(viewer.selection, run), frames, labels})
    if (!text.empty()) draw_view_line(ui, viewer.view, list, row++, text, colors.text);
  return row;
}

void draw_info_card(WindowUi& ui, const Viewer& viewer, const RunView& run, const PanelsShown& panels, int row) {
  if (!panels[kInfo] || !shows_run(viewer.mode)) return;
  const std::vector<InfoRow> rows = scene_info(run);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, margin = 0.6f * line;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0.25f * line});
  float name = 0, value = 0, height = 2 * pad;
  for (const InfoRow& r : rows) {
    name = std::max(name, ImGui::CalcTextSize(r.name.c_str()).x);
    value = std::max(value, ImGui::CalcTextSize(r.value.c_str()).x);
  }
  name += line;
  value = std::min(value + 1, viewer.view.rect.width() - name - 2 * (pad + margin) - ImGui::GetStyle().ScrollbarSize);
  for (const InfoRow& r : rows) height += height_of(r, value);
  const float top = view_line_top(viewer.view, row) + 0.2f * line, room = viewer.view.rect.y1 - margin - top;
  const bool scrolls = height > room;
  ImGui::SetNextWindowPos({viewer.view.rect.x0 + viewer.view.strip + margin, top});
  ImGui::SetNextWindowSize(
      {name + value + 2 * pad + (scrolls ? ImGui::GetStyle().ScrollbarSize : 0), std::min(height, room)});
  ImGui::SetNextWindowBgAlpha(kBackground);
  constexpr auto kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
  if (ImGui::Begin("Info", nullptr, scrolls ? kFlags : kFlags | ImGuiWindowFlags_NoInputs)) {
    ui.widgets.note_item("Info");
    for (const InfoRow& r : rows) {
      ImGui::TextDisabled("%s", r.name.c_str());
      ImGui::SameLine(pad + name);
      ImGui::PushTextWrapPos(pad + name + value);
      ImGui::TextUnformatted(r.value.c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

constinit const Feature kInfo{
    .opens = Opens::by_user,
    .key = "info",
    .dump = dump_view,
};

}  // namespace taxel::ui
