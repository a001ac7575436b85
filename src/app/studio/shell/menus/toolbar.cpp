#include "app/studio/shell/menus/toolbar.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>

#include "app/studio/frame/app.h"
#include "app/studio/frame/arrangement.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/nouns/view/view_commands.h"
#include "app/studio/shell/interface/perform.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/flow.h"

namespace taxel::ui {

namespace {

constexpr ImVec2 kPadding{10, 4};

float button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void draw_modes(App& app, Flow& flow) {
  constexpr float kGap = 2;
  flow.next(button_width("LAYOUT") + kGap + button_width("SIMULATE"));
  if (small_choice(*app.ui, "LAYOUT", app.viewer->mode == Mode::layout)) perform(SetMode{Mode::layout}, app);
  tooltip("Edit layout (Ctrl+1)");
  ImGui::SameLine(0, kGap);
  if (small_choice(*app.ui, "SIMULATE", app.viewer->mode == Mode::simulate)) perform(SetMode{Mode::simulate}, app);
  tooltip("Run simulation (Ctrl+2)");
}

void draw_transport(App& app, Flow& flow) {
  const Palette& colors = palette(app.ui->dark);
  const float line = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const float small = 2.2f * line, large = 6.4f * line, gap = 4;
  flow.next(4 * (small + gap) + large);
  ImGui::BeginDisabled(!is_enabled(binding_of(PlayOrPause{}), app));
  if (icon_button(*app.ui, "Reset", Icon::reset, ImVec2(small, height), nullptr, "Back to the start (Backspace)")) {
    perform(ResetSimulation{}, app);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(*app.ui, "Back", Icon::step_back, ImVec2(small, height), nullptr, "One step back (Left)")) {
    perform(StepBack{}, app);
  }
  ImGui::SameLine(0, gap);
  const bool playing = app.shown->run.playing;
  if (icon_button(*app.ui, playing ? "Pause" : "Run", playing ? Icon::pause : Icon::run, ImVec2(large, height),
                  playing ? &colors.pause : &colors.run, playing ? "Pause (Space)" : "Run (Space)")) {
    perform(PlayOrPause{}, app);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(*app.ui, "Step", Icon::step, ImVec2(small, height), nullptr, "One step forward (Right)")) {
    perform(StepOnce{}, app);
  }
  ImGui::SameLine(0, gap);
  const bool records = app.shown->run.frame && app.shown->run.frame->recording.on;
  if (icon_button(*app.ui, records ? "Stop recording" : "Record", Icon::record, ImVec2(small, height),
                  records ? &colors.error : nullptr,
                  records ? "Write the recording (Ctrl+R)" : "Record every step from now on (Ctrl+R)")) {
    perform(ToggleRecording{}, app);
  }
  ImGui::EndDisabled();
}

std::string speed_name(double speed) {
  return speed >= 1 ? fmt::format("{:g} x", speed) : fmt::format("1/{:g} x", 1 / speed);
}

void draw_speed(App& app, Flow& flow) {
  const float width = 5.2f * ImGui::GetFontSize(), gap = 6;
  flow.next(ImGui::CalcTextSize("Speed").x + gap + width);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Speed");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##speed", speed_name(app.shown->run.speed).c_str());
  if (!open) {
    app.ui->widgets.note_item("Speed");
    const auto key = [&](bool faster) { return chord_name(binding_of(ChangeSpeed{faster}).chord, app.ui->key_names); };
    tooltip(fmt::format("Multiples of real time ({} slower, {} faster)", key(false), key(true)));
    return;
  }
  for (const double speed : std::array{0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    if (selectable(*app.ui, speed_name(speed).c_str(), speed == app.shown->run.speed)) app.ui->post(SetSpeed{speed});
  }
  ImGui::EndCombo();
}

struct OverlayButton {
  const char* label;
  bool Overlays::*overlay;
};

void draw_overlays(App& app, Flow& flow) {
  constexpr std::array kButtons = {
      OverlayButton{"Skin", &Overlays::sensor_transparent},
      OverlayButton{"Wire", &Overlays::wireframe},
      OverlayButton{"Contact", &Overlays::contact_surface},
      OverlayButton{"Rays", &Overlays::rays},
      OverlayButton{"Samples", &Overlays::samples},
      OverlayButton{"Normals", &Overlays::sample_normals},
      OverlayButton{"Taxels", &Overlays::taxels},
      OverlayButton{"Fields", &Overlays::receptive_fields},
      OverlayButton{"Path", &Overlays::path},
  };
  constexpr float kGap = 2;
  flow.next(ImGui::CalcTextSize("Show").x + 6 + button_width(kButtons.front().label));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Show");
  float gap = 6;
  for (const OverlayButton& b : kButtons) {
    const Binding& binding = binding_of(ToggleOverlay{b.overlay});
    const std::string key = chord_name(binding.chord, app.ui->key_names);
    const std::string tip = key.empty() ? binding.label : fmt::format("{} ({})", binding.label, key);
    flow.next(button_width(b.label), gap);
    gap = kGap;
    if (toggle(*app.ui, b.label, is_checked(binding, app), tip.c_str())) perform(binding, app);
  }
}

}  // namespace

void draw_toolbar(App& app) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto rows = static_cast<float>(app.get<Arrangement>().toolbar_rows);
  const float height = rows * ImGui::GetFrameHeight() + (rows - 1) * style.ItemSpacing.y + 2 * kPadding.y;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, kPadding);
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  if (ImGui::BeginViewportSideBar("Toolbar", ImGui::GetMainViewport(), ImGuiDir_Up, height, kFlags)) {
    Flow flow(1.2f * ImGui::GetFontSize());
    draw_modes(app, flow);
    draw_transport(app, flow);
    draw_speed(app, flow);
    draw_overlays(app, flow);
    app.get<Arrangement>().toolbar_rows = flow.rows();
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace taxel::ui
