#include "app/studio/features/menus/toolbar.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>

#include "app/studio/app/perform.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/flow.h"

namespace taxel::ui {

namespace {

float button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void draw_modes(UiState& ui, const UiInput& input, Flow& flow) {
  constexpr float kGap = 2;
  flow.next(button_width("LAYOUT") + kGap + button_width("SIMULATE"));
  if (small_choice(ui, "LAYOUT", ui.mode == Mode::layout)) perform(SetMode{Mode::layout}, ui, input);
  tooltip("Edit layout (Ctrl+1)");
  ImGui::SameLine(0, kGap);
  if (small_choice(ui, "SIMULATE", ui.mode == Mode::simulate)) perform(SetMode{Mode::simulate}, ui, input);
  tooltip("Run simulation (Ctrl+2)");
}

void draw_transport(UiState& ui, const UiInput& input, Flow& flow) {
  const Palette& colors = palette(ui.dark);
  const float line = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const float small = 2.2f * line, large = 6.4f * line, gap = 4;
  flow.next(4 * (small + gap) + large);
  ImGui::BeginDisabled(!is_enabled(binding_of(PlayOrPause{}), ui, input));
  if (icon_button(ui, "Reset", Icon::reset, ImVec2(small, height), nullptr, "Back to the start (Backspace)")) {
    perform(ResetSimulation{}, ui, input);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(ui, "Back", Icon::step_back, ImVec2(small, height), nullptr, "One step back (Left)")) {
    perform(StepBack{}, ui, input);
  }
  ImGui::SameLine(0, gap);
  const bool playing = input.playing;
  if (icon_button(ui, playing ? "Pause" : "Run", playing ? Icon::pause : Icon::run, ImVec2(large, height),
                  playing ? &colors.pause : &colors.run, playing ? "Pause (Space)" : "Run (Space)")) {
    perform(PlayOrPause{}, ui, input);
  }
  ImGui::SameLine(0, gap);
  if (icon_button(ui, "Step", Icon::step, ImVec2(small, height), nullptr, "One step forward (Right)")) {
    perform(StepOnce{}, ui, input);
  }
  ImGui::SameLine(0, gap);
  const bool records = input.frame && input.frame->recording.on;
  if (icon_button(ui, records ? "Stop recording" : "Record", Icon::record, ImVec2(small, height),
                  records ? &colors.error : nullptr,
                  records ? "Write what was recorded (Ctrl+R)" : "Record every step from now on (Ctrl+R)")) {
    perform(ToggleRecording{}, ui, input);
  }
  ImGui::EndDisabled();
}

std::string speed_name(double speed) {
  return speed >= 1 ? fmt::format("{:g} x", speed) : fmt::format("1/{:g} x", 1 / speed);
}

void draw_speed(UiState& ui, const UiInput& input, Flow& flow) {
  const float width = 5.2f * ImGui::GetFontSize(), gap = 6;
  flow.next(ImGui::CalcTextSize("Speed").x + gap + width);
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Speed");
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo("##speed", speed_name(input.speed).c_str());
  if (!open) {
    ui.widgets.note_item("Speed");
    tooltip("Multiples of real time (- slower, = faster)");
    return;
  }
  for (const double speed : std::array{0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    if (selectable(ui, speed_name(speed).c_str(), speed == input.speed)) ui.ask(SetSpeed{speed});
  }
  ImGui::EndCombo();
}

struct OverlayButton {
  const char* label;
  bool Overlays::*overlay;
};

void draw_overlays(UiState& ui, const UiInput& input, Flow& flow) {
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
    const std::string key = chord_name(binding.chord);
    const std::string tip = key.empty() ? binding.label : fmt::format("{} ({})", binding.label, key);
    flow.next(button_width(b.label), gap);
    gap = kGap;
    if (toggle(ui, b.label, is_checked(binding, ui, input), tip.c_str())) perform(binding, ui, input);
  }
}

}  // namespace

void draw_toolbar(UiState& ui, const UiInput& input) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto rows = static_cast<float>(ui.toolbar_rows);
  const float height = rows * ImGui::GetFrameHeight() + (rows - 1) * style.ItemSpacing.y + 2 * style.WindowPadding.y;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  if (ImGui::BeginViewportSideBar("Toolbar", ImGui::GetMainViewport(), ImGuiDir_Up, height, kFlags)) {
    Flow flow(1.2f * ImGui::GetFontSize());
    draw_modes(ui, input, flow);
    draw_transport(ui, input, flow);
    draw_speed(ui, input, flow);
    draw_overlays(ui, input, flow);
    ui.toolbar_rows = flow.rows();
  }
  ImGui::End();
}

}  // namespace taxel::ui
