// The panel of settings of the running scene, and the commands about the layouts on its geoms.
#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/scene_filter.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/host/run/host_event.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/scene/scene_layouts.h"
#include "ui/scene/scene_input.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

constexpr std::size_t kFewParts = 8;  // largest number of geoms or joints that need no filter
constexpr float kMostRows = 7;        // largest number of rows before the list scrolls

/// Returns the body that is selected for a row about it, or -1 for the world, which is never selected.
int lit_body(int body) {
  return body > 0 ? body : -1;
}

const SceneAttachment* attachment_on(const RunView& run, const std::string& geom) {
  const auto found = std::find_if(run.attached.begin(), run.attached.end(),
                                  [&](const SceneAttachment& one) { return one.geom == geom && !one.is_declared; });
  return found != run.attached.end() ? &*found : nullptr;
}

void draw_sensors(WindowUi& ui, Selection& selection, const ControlsState& controls, const RunView& run) {
  const SimScene& scene = *run.frame->scene;
  if (scene.sensors.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("None yet: choose a geom, attach a layout.");
    ImGui::PopTextWrapPos();
  }
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    if (!finds_sensor(controls.filter, scene, i)) continue;
    const std::string& geom = scene.sensor_geoms[i];
    const SceneAttachment* attached = attachment_on(run, geom);
    ImGui::AlignTextToFramePadding();
    if (selectable(ui, fmt::format("{}##sensor of{}", geom, i).c_str(), selection.sensor == static_cast<int>(i),
                   ImGuiSelectableFlags_AllowOverlap)) {
      if (selection.sensor != static_cast<int>(i))
        selection = {static_cast<int>(i), {}, lit_body(body_of_sensor(scene, static_cast<int>(i)))};
      selection.is_sensor_chosen = true;
    }
    if (attached != nullptr) tooltip(attached->layout);
    offer_sensor(ui, selection, run, static_cast<int>(i));
    ImGui::SameLine();
    if (scene.sensors[i]->taxel_count() > 0) {
      ImGui::TextDisabled("%d taxels%s", scene.sensors[i]->taxel_count(), attached != nullptr ? "" : ", declared");
    } else {
      ImGui::TextDisabled("soft, no taxels");
    }
    if (attached == nullptr) continue;
    const float width = ImGui::CalcTextSize("Detach").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, ImGui::GetContentRegionAvail().x - width));
    if (button(ui, fmt::format("Detach##{}", geom).c_str())) ui.post(DetachLayout{geom});
    ui.widgets.note_item("Detach " + geom);
  }
}

/// Returns whether the geom carries no layout yet. The geom may be soft.
bool takes_layout(const SimScene& scene, const SceneGeom& geom) {
  return geom.sensor < 0 || scene.sensors[static_cast<std::size_t>(geom.sensor)]->taxel_count() == 0;
}

void choose(std::vector<std::string>& geoms, const std::string& geom) {
  const auto found = std::find(geoms.begin(), geoms.end(), geom);
  if (found == geoms.end()) {
    geoms.push_back(geom);
  } else {
    geoms.erase(found);
  }
}

/// Draws the row of a geom. A click chooses the geom and selects its body, and a second click removes the geom from the
/// choice.
void draw_geom(WindowUi& ui, Selection& selection, ControlsState& controls, const SceneGeom& geom) {
  const bool chosen = std::find(controls.geoms.begin(), controls.geoms.end(), geom.name) != controls.geoms.end();
  if (selectable(ui, fmt::format("{}##geom", geom.shown_name()).c_str(), chosen)) {
    choose(controls.geoms, geom.name);
    selection.body = chosen ? -1 : lit_body(geom.body_index);
    controls.shown_body = selection.body;  // the row is in sight
  }
  offer_geom(ui, controls, geom);
  const std::string& detail = geom.label.empty() ? geom.body : geom.mesh_name;
  if (detail.empty() || geom.label.find(detail) != std::string::npos) return;
  ImGui::SameLine();
  ImGui::TextDisabled("%s", detail.c_str());
}

/// Draws the geoms without a sensor that the filter finds, and scrolls to those of a body that was selected elsewhere.
void draw_geoms(WindowUi& ui, Selection& selection, ControlsState& controls, const SimScene& scene) {
  const float rows = std::min(kMostRows, static_cast<float>(scene.geoms.size()));
  const bool scrolls = std::exchange(controls.shown_body, selection.body) != selection.body;
  if (ImGui::BeginChild("geoms", ImVec2(0, (rows + 0.5f) * ImGui::GetTextLineHeightWithSpacing()),
                        ImGuiChildFlags_FrameStyle)) {
    bool is_empty = true, is_scrolled = !scrolls || selection.body < 0;
    for (const SceneGeom& geom : scene.geoms) {
      if (!takes_layout(scene, geom) || geom.plane || !finds_geom(controls.filter, scene, geom)) continue;
      draw_geom(ui, selection, controls, geom);
      is_empty = false;
      if (is_scrolled || geom.body_index != selection.body) continue;
      ImGui::SetScrollHereY();
      is_scrolled = true;
    }
    if (is_empty)
      ImGui::TextDisabled("%s", controls.filter.empty() ? "Each geom has a sensor." : "No geom of that name");
  }
  ImGui::EndChild();
}

void draw_attach(WindowUi& ui, Selection& selection, const RunView& run, ControlsState& controls) {
  const SimScene& scene = *run.frame->scene;
  std::erase_if(controls.geoms, [&](const std::string& name) {
    return std::none_of(scene.geoms.begin(), scene.geoms.end(),
                        [&](const SceneGeom& geom) { return geom.name == name && takes_layout(scene, geom); });
  });
  const auto flags = scene.sensors.empty() ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
  if (!ImGui::TreeNodeEx("Attach a layout##section", flags)) {
    ui.widgets.note_item("Attach a layout");
    return;
  }
  ui.widgets.note_item("Attach a layout");
  draw_geoms(ui, selection, controls, scene);
  const std::size_t chosen = controls.geoms.size();
  ImGui::BeginDisabled(chosen == 0);
  const std::string label =
      chosen > 1 ? fmt::format("Attach a layout to {} geoms...###Attach", chosen) : "Attach a layout...###Attach";
  if (button(ui, label.c_str(), ImVec2(-1, 0))) ui.post(AttachLayout{controls.geoms, ""});
  if (button(ui, "New layout on this geom", ImVec2(-1, 0))) ui.post(NewLayoutOnGeom{controls.geoms.front()});
  tooltip("Mesh, scale and pose come from the scene; the layout is edited in LAYOUT");
  ImGui::EndDisabled();
  ImGui::TreePop();
}

void draw_save(WindowUi& ui) {
  if (button(ui, "Save scene as...", ImVec2(-1, 0))) ui.post(SaveScene{});
  tooltip("A copy with its sensors declared, as any program with MuJoCo and the plugin reads it");
}

/// Draws the section about sensors in the panel of controls.
void draw_attach_section(WindowUi& ui, Selection& selection, const RunView& run, ControlsState& controls) {
  if (!header(ui, "Sensors")) return;
  draw_sensors(ui, selection, controls, run);
  draw_attach(ui, selection, run, controls);
  draw_save(ui);
}

constexpr FieldUnit kMillimetre{"mm", -3, 3};
constexpr double kDegree = 180 / std::numbers::pi, kMillimetresPerMetre = 1000;
/// Ranges for controls without limits: of an actuator, as in MuJoCo's viewer, and of a joint, half a turn [rad] or a
/// tenth of a metre [m] to each side.
constexpr ControlRange kAnyControl{-1, 1}, kAnyAngle{-std::numbers::pi, std::numbers::pi}, kAnyLength{-0.1, 0.1};

void ask_edit_scene(WindowUi& ui, const SceneEdit& edit) {
  ui.post(EditSceneCommand{edit});
}

/// Draws the filter of the lists below.
void draw_filter(WindowUi& ui, ControlsState& controls, const SimScene& scene) {
  if (std::max({scene.geoms.size(), scene.controls.joints.size(), scene.controls.actuators.size()}) <= kFewParts)
    return;
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##scene filter", "Filter: body, mesh, joint, site", &controls.filter);
  ui.widgets.note_item("Filter the scene", true);
}

void draw_actuators(WindowUi& ui, const ControlsState& state, const SimFrame& frame) {
  const std::vector<SceneActuator>& actuators = frame.scene->controls.actuators;
  if (actuators.empty() || !header(ui, "Actuators") || !begin_properties("actuators")) return;
  for (std::size_t i = 0; i < actuators.size() && i < frame.controls.controls.size(); ++i) {
    const SceneActuator& actuator = actuators[i];
    if (!finds_actuator(state.filter, *frame.scene, actuator)) continue;
    double value = frame.controls.controls[i];
    if (property_slider(ui, actuator.name, "Actuator " + actuator.name, &value, 1, "%.4g",
                        actuator.range.value_or(kAnyControl)))
      ask_edit_scene(ui, SetControl{static_cast<int>(i), value});
  }
  end_properties();
}

/// Draws the joints. Their values are displayed while the scene runs, and can be set while it is paused.
void draw_joints(WindowUi& ui, const ControlsState& state, const RunView& run, const SimFrame& frame) {
  const std::vector<SceneJoint>& joints = frame.scene->controls.joints;
  if (joints.empty() || !header(ui, "Joints") || !begin_properties("joints")) return;
  ImGui::BeginDisabled(run.playing);
  for (std::size_t i = 0; i < joints.size() && i < frame.controls.joints.size(); ++i) {
    const SceneJoint& joint = joints[i];
    if (!finds_joint(state.filter, *frame.scene, joint.name)) continue;
    double value = frame.controls.joints[i];
    const ControlRange any = joint.hinge ? kAnyAngle : kAnyLength;
    if (property_slider(ui, joint.name, "Joint " + joint.name, &value, joint.hinge ? kDegree : kMillimetresPerMetre,
                        joint.hinge ? "%.1f\u00b0" : "%.2f mm", joint.range.value_or(any)))
      ask_edit_scene(ui, SetJoint{static_cast<int>(i), value});
  }
  ImGui::EndDisabled();
  end_properties();
}

void draw_keyframes(WindowUi& ui, const SimFrame& frame) {
  const std::vector<SceneKeyframe>& keyframes = frame.scene->controls.keyframes;
  if (keyframes.empty() || !header(ui, "Keyframes")) return;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (button(ui, fmt::format("{}##keyframe{}", keyframes[i].name, i).c_str()))
      ui.post(LoadKeyframeCommand{static_cast<int>(i)});
    tooltip("Reset to this keyframe and pause");
    ImGui::SameLine();
    ImGui::TextDisabled("%s", fmt::format("at {:.4g} s", keyframes[i].time).c_str());
  }
}

/// Draws the cameras of the scene, and the view that the user moves.
void draw_cameras(WindowUi& ui, const SimFrame& frame, int camera) {
  const std::vector<SceneCamera>& cameras = frame.scene->marks.cameras;
  if (cameras.empty() || frame.mark_poses.cameras.empty() || !header(ui, "Cameras")) return;
  if (selectable(ui, "Free view", camera < 0)) ui.post(LookThroughCamera{});
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const int index = static_cast<int>(i);
    if (selectable(ui, fmt::format("{}##camera{}", cameras[i].name, i).c_str(), camera == index))
      ui.post(LookThroughCamera{index});
  }
}

void draw_mocaps(WindowUi& ui, const RunView& run, const SimFrame& frame) {
  const std::vector<std::string>& bodies = frame.scene->controls.mocaps;
  if (bodies.empty() || !header(ui, "Mocap bodies")) return;
  if (run.runs_scenario) return caption("The scenario leads it along its path.");
  for (std::size_t i = 0; i < bodies.size() && i < frame.controls.mocaps.size(); ++i) {
    if (!begin_properties(("mocap" + bodies[i]).c_str())) continue;
    Pose X_WB = frame.controls.mocaps[i];
    begin_property((bodies[i] + " (mm)").c_str(), "Position. In the view: double-click, then Ctrl+right-drag");
    if (const auto changed = vector_field(ui, "Mocap " + bodies[i], {X_WB.p}, kMillimetre)) {
      X_WB.p[changed->axis] = changed->value;
      ask_edit_scene(ui, SetMocap{static_cast<int>(i), X_WB});
    }
    const dvec3 angles = kDegree * glm::eulerAngles(X_WB.q);
    property("Turned", fmt::format("{:.1f}, {:.1f}, {:.1f}\u00b0", angles.x, angles.y, angles.z));
    end_properties();
  }
}

void draw_equalities(WindowUi& ui, const SimFrame& frame) {
  const std::vector<SceneEquality>& equalities = frame.scene->controls.equalities;
  if (equalities.empty() || !header(ui, "Equality constraints")) return;
  for (std::size_t i = 0; i < equalities.size() && i < frame.controls.equalities.size(); ++i) {
    bool active = frame.controls.equalities[i];
    if (checkbox(ui, fmt::format("{}##equality{}", equalities[i].name, i).c_str(), &active))
      ask_edit_scene(ui, SetEquality{static_cast<int>(i), active});
    ImGui::SameLine();
    ImGui::TextDisabled("%s", equalities[i].kind.c_str());
  }
}

void draw_physics(WindowUi& ui, const Overlays& overlays, const SimScene& scene) {
  if (!header(ui, "Physics") || !begin_properties("physics")) return;
  const dvec3& g = scene.controls.gravity;
  property("Gravity", fmt::format("{:.4g}, {:.4g}, {:.4g} m/s\u00b2", g.x, g.y, g.z));
  property("Time step", fmt::format("{:.4g} ms", 1e3 * scene.timestep));
  property("Integrator", scene.controls.integrator);
  const auto count = scene.controls.bodies.size();
  const auto shown = std::count_if(scene.geoms.begin(), scene.geoms.end(),
                                   [&](const SceneGeom& geom) { return shows(overlays, geom); });
  property("Bodies, geoms", fmt::format("{}, {} drawn", count - std::min<std::size_t>(count, 1), shown));
  end_properties();
}

void draw_controls_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ControlsState& controls, int camera,
                         bool& open) {
  if (std::exchange(controls.wants_focus, false)) ImGui::SetNextWindowFocus();
  const bool visible = begin_panel(ui, kControls.title, &open);
  if (visible && (!shown.run.frame || !shown.run.frame->scene)) ImGui::TextDisabled("Nothing is simulated.");
  if (visible && shown.run.frame && shown.run.frame->scene) {
    const SimFrame& frame = *shown.run.frame;
    draw_filter(ui, controls, *frame.scene);
    if (shown.document.is_scene) draw_attach_section(ui, viewer.selection, shown.run, controls);
    const bool past = frame.recorded || shown.run.replay != 0;
    if (past) caption("A recorded step is displayed: End goes to the latest.");
    ImGui::BeginDisabled(past);
    draw_actuators(ui, controls, frame);
    draw_joints(ui, controls, shown.run, frame);
    draw_keyframes(ui, frame);
    draw_mocaps(ui, shown.run, frame);
    draw_equalities(ui, frame);
    ImGui::EndDisabled();
    draw_cameras(ui, frame, camera);
    draw_physics(ui, viewer.overlays(), *frame.scene);
  }
  ImGui::End();
}

std::vector<PanelPart> controls_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.frame && app.shown->run.frame->scene ? nullptr : "Nothing is simulated";
  };
  return {{"Actuators", "", "Sliders of the actuators of the scene", kSimulate, kWhyNot},
          {"Joints", "", "Sliders of the joints of the scene, while it is paused", kSimulate, kWhyNot},
          {"Keyframes", "", "Reset the scene to one of its keyframes", kSimulate, kWhyNot},
          {"Mocap bodies", "", "Positions of the bodies that motion capture leads", kSimulate, kWhyNot},
          {"Equality constraints", "", "Switch welds, connections and joint couplings on and off", kSimulate, kWhyNot},
          {"Cameras", "", "Look through a camera of the scene", kSimulate, kWhyNot},
          {"Physics", "", "Gravity, time step and integrator of the scene", kSimulate, kWhyNot},
          {"Sensors", "", "Sensors of the scene, and layouts attached to geoms", kSimulate, kWhyNot},
          {"Attach a layout", "", "Attach the layout of a sensor to geoms of the scene", kSimulate, kWhyNot},
          {"Save scene as...", "", "A copy of the scene that declares its sensors", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kControls{
    .title = "Controls",
    .dock = Dock::inspector,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_controls",
    .label = "Controls",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_controls_panel(*app.ui, *app.viewer, *app.shown, app.get<ControlsState>(), app.get<FollowState>().camera,
                              app.get<PanelsShown>()[kControls]);
        },
    .parts = controls_parts,
    .guide = "Drive a scene",
    .dump = dump_controls,
};

}  // namespace taxel::ui

namespace taxel::studio {
namespace {

void attach(Host& host, const std::vector<std::string>& geoms, const std::string& layout) {
  std::vector<SceneAttachment> attachments = attachments_with_edits(host.run, host.document);
  for (const std::string& geom : geoms) attachments.push_back({geom, layout});
  build_scene_again(host.run, host.document, std::move(attachments));
}

/// Removes a geom from those with the edited layout. Returns false if it is the only one, which stays.
bool remove_geom(std::optional<ui::SceneLayout>& edited, const std::string& geom) {
  if (!edited || std::find(edited->geoms.begin(), edited->geoms.end(), geom) == edited->geoms.end()) return true;
  if (edited->geoms.size() == 1) return false;
  std::erase(edited->geoms, geom);
  return true;
}

void detach(Host& host, const std::string& geom) {
  if (!remove_geom(host.document.scene_layout, geom))
    return host.report(Severity::error, fmt::format("The layout on {} is being edited: end that first with \"All "
                                                    "layouts\" in LAYOUT.",
                                                    geom));
  std::vector<SceneAttachment> attachments = attachments_with_edits(host.run, host.document);
  std::erase_if(attachments, [&](const SceneAttachment& attached) { return attached.geom == geom; });
  build_scene_again(host.run, host.document, std::move(attachments));
}

}  // namespace

void carry_out(const ui::AttachLayout& command, Host& host) {
  command.path.empty() ? ask_for_file(host.app, ui::FileTask::attach_layout, "")
                       : attach(host, command.geoms, command.path);
}

void carry_out(const ui::DetachLayout& command, Host& host) {
  detach(host, command.geom);
}

}  // namespace taxel::studio
