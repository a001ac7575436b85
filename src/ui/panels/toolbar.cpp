#include "ui/panels/toolbar.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>

#include "ui/theme.h"
#include "ui/tools/actions.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {

namespace {

void gap() {
  ImGui::SameLine(0, 1.2f * ImGui::GetFontSize());
}

void draw_modes(UiState& ui, const UiInput& input) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 0));
  if (small_choice(ui, "LAYOUT", ui.mode == Mode::layout)) perform(Action::mode_layout, ui, input);
  tooltip("Look at the layout alone (Ctrl+1)");
  ImGui::SameLine();
  if (small_choice(ui, "SIMULATE", ui.mode == Mode::simulate)) perform(Action::mode_simulate, ui, input);
  tooltip("Look at the running simulation (Ctrl+2)");
  ImGui::PopStyleVar();
}

void draw_transport(UiState& ui, const UiInput& input) {
  const Palette& colors = palette(ui.saved.dark);
  const float line = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!is_enabled(Action::play_pause, ui, input));
  if (icon_button(ui, "Reset", Icon::reset, ImVec2(2.2f * line, height), nullptr, "Back to the start (Backspace)")) {
    perform(Action::reset_simulation, ui, input);
  }
  ImGui::SameLine(0, 4);
  if (icon_button(ui, "Back", Icon::step_back, ImVec2(2.2f * line, height), nullptr, "One step back (Left)")) {
    perform(Action::step_back, ui, input);
  }
  ImGui::SameLine(0, 4);
  const bool playing = input.playing;
  if (icon_button(ui, playing ? "Pause" : "Run", playing ? Icon::pause : Icon::run, ImVec2(6.4f * line, height),
                  playing ? &colors.pause : &colors.run, playing ? "Pause (Space)" : "Run (Space)")) {
    perform(Action::play_pause, ui, input);
  }
  ImGui::SameLine(0, 4);
  if (icon_button(ui, "Step", Icon::step, ImVec2(2.2f * line, height), nullptr, "One step forward (Right)")) {
    perform(Action::step_forward, ui, input);
  }
  ImGui::EndDisabled();
}

std::string speed_name(double speed) {
  return speed >= 1 ? fmt::format("{:g} x", speed) : fmt::format("1/{:g} x", 1 / speed);
}

void draw_speed(UiState& ui, const UiInput& input) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Speed");
  ImGui::SameLine(0, 6);
  ImGui::SetNextItemWidth(5.2f * ImGui::GetFontSize());
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
  Action action;
};

void draw_overlays(UiState& ui, const UiInput& input) {
  constexpr std::array kButtons = {
      OverlayButton{"Skin", Action::toggle_transparent}, OverlayButton{"Wire", Action::toggle_wireframe},
      OverlayButton{"Contact", Action::toggle_contact},  OverlayButton{"Rays", Action::toggle_rays},
      OverlayButton{"Samples", Action::toggle_samples},  OverlayButton{"Normals", Action::toggle_normals},
      OverlayButton{"Taxels", Action::toggle_taxels},    OverlayButton{"Fields", Action::toggle_fields},
      OverlayButton{"Path", Action::toggle_path},
  };
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Show");
  ImGui::SameLine(0, 6);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(2, 0));
  for (const OverlayButton& b : kButtons) {
    const Binding& binding = binding_of(b.action);
    const std::string key = chord_name(binding.chord);
    const std::string tip = key.empty() ? binding.label : fmt::format("{} ({})", binding.label, key);
    if (toggle(ui, b.label, is_checked(b.action, ui), tip.c_str())) perform(b.action, ui, input);
    ImGui::SameLine();
  }
  ImGui::PopStyleVar();
}

}  // namespace

void draw_toolbar(UiState& ui, const UiInput& input) {
  const float height = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
  constexpr auto kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                          ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoMove;
  ImGui::SetNextWindowBgAlpha(0);  // the window is cleared to this colour already
  if (ImGui::BeginViewportSideBar("Toolbar", ImGui::GetMainViewport(), ImGuiDir_Up, height, kFlags)) {
    draw_modes(ui, input);
    gap();
    draw_transport(ui, input);
    gap();
    draw_speed(ui, input);
    gap();
    draw_overlays(ui, input);
  }
  ImGui::End();
}

}  // namespace taxel::ui
