// The window about the program: its version, its purpose and its licence.
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/guide/guide_state.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "ui/widgets/controls.h"

namespace taxel::ui {
namespace {

void draw_about(WindowUi& ui, const Shown& shown, PanelsShown& panels) {
  if (!panels[kAbout]) return;
  constexpr float kWidth = 30;
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize({kWidth * ImGui::GetFontSize(), 0}, ImGuiCond_Appearing);
  constexpr auto kFlags = ImGuiWindowFlags_NoDocking | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                          ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin(kAbout.title, &panels[kAbout], kFlags)) {
    ui.widgets.note_item(kAbout.title);
    ImGui::TextWrapped("%s", shown.versions.c_str());
    ImGui::Spacing();
    ImGui::PushTextWrapPos(kWidth * ImGui::GetFontSize());
    ImGui::TextUnformatted(
        "Tactile skins of any shape for MuJoCo: design the layout of taxels on a mesh, simulate soft contact, and read "
        "the taxels in the window, on the command line, in Python and in any program with MuJoCo.");
    ImGui::Spacing();
    ImGui::TextUnformatted("Licence: Apache 2.0.");
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    if (button(ui, "Close##about") || is_left_by_escape(ui)) panels[kAbout] = false;
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kAbout{
    .title = "About Taxel Studio",
    .opens = Opens::for_once,
    .draw_card = [](App& app) { draw_about(*app.ui, *app.shown, app.get<PanelsShown>()); },
    .tool = {"about", kEverywhere, nullptr, 5, [](const App& app) { return app.get<PanelsShown>()[kAbout]; },
             [](App& app) { app.get<PanelsShown>()[kAbout] = false; }},
};

}  // namespace taxel::ui
