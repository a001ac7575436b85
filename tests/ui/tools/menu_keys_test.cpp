// The menu bar under the keyboard: Alt, F10, letters, arrows, Enter and Esc, without a window.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/menus/menus_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/shell/menus/menus.h"
#include "ui/tools/running.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {
namespace {

/// The menu bar and the table of keys, above a simulation that runs.
class MenuKeysTest : public testing::Test {
 protected:
  MenuKeysTest() {
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    frame();
    frame();
  }
  void frame() {
    run.interface.frame([&] {
      app.ui->widgets.begin_frame();
      handle_keys(app);
      draw_menu_bar(app);
      if (ImGui::Begin("Panel")) {
        ImGui::InputText("field", field.data(), field.size());
        focused = ImGui::IsWindowFocused();
      }
      ImGui::End();
      record_keyboard(*app.ui, {});
    });
  }
  /// Presses a key, lets it go, and lets Dear ImGui settle.
  void press(ImGuiKey key, ImGuiKey modifier = ImGuiKey_None) {
    if (modifier != ImGuiKey_None) run.interface.key(modifier, true);
    run.interface.key(key, true);
    frame();
    run.interface.key(key, false);
    if (modifier != ImGuiKey_None) run.interface.key(modifier, false);
    for (int i = 0; i < 4; ++i) frame();
  }
  void click(double x, double y) {
    run.interface.move(x, y);
    frame();
    run.interface.button(true);
    frame();
    run.interface.button(false);
    for (int i = 0; i < 4; ++i) frame();
  }
  /// Returns whether an entry is in view.
  [[nodiscard]] bool is_listed(const char* label) const { return app.ui->widgets.find(label) != nullptr; }
  [[nodiscard]] std::string menu() const { return open_menu(app); }
  [[nodiscard]] bool on() const { return app.get<MenuKeys>().on; }

  test::Running run;
  App& app = run.scene.app;
  std::array<char, 16> field{};
  bool focused = false;
};

TEST_F(MenuKeysTest, MarksTheFirstMenuByAltOrF10) {
  for (const ImGuiKey key : {ImGuiKey_LeftAlt, ImGuiKey_F10}) {
    press(key);
    EXPECT_TRUE(on());
    EXPECT_EQ(app.get<MenuKeys>().menu, 0);
    EXPECT_EQ(menu(), "") << "the first key only marks the title";
    press(key);
    EXPECT_FALSE(on()) << "the same key leaves the menus";
  }
}

TEST_F(MenuKeysTest, WalksThroughTheBarAndBack) {
  press(ImGuiKey_F10);
  press(ImGuiKey_RightArrow);
  press(ImGuiKey_DownArrow);
  EXPECT_EQ(menu(), "Edit");
  press(ImGuiKey_RightArrow);
  EXPECT_EQ(menu(), "Mode");
  press(ImGuiKey_LeftArrow);
  press(ImGuiKey_LeftArrow);
  EXPECT_EQ(menu(), "File");
  press(ImGuiKey_LeftArrow);
  EXPECT_EQ(menu(), "Help") << "the bar goes round";
  press(ImGuiKey_Escape);
  EXPECT_EQ(menu(), "");
  EXPECT_TRUE(on()) << "the title stays marked";
  press(ImGuiKey_Home);
  press(ImGuiKey_Enter);
  EXPECT_EQ(menu(), "File");
  press(ImGuiKey_Escape);
  press(ImGuiKey_End);
  press(ImGuiKey_Space);
  EXPECT_EQ(menu(), "Help");
  press(ImGuiKey_Escape);
  press(ImGuiKey_Escape);
  EXPECT_FALSE(on());
}

TEST_F(MenuKeysTest, OpensAMenuByItsLetter) {
  press(ImGuiKey_LeftAlt);
  press(ImGuiKey_V);
  EXPECT_EQ(menu(), "View");
  press(ImGuiKey_LeftAlt);
  EXPECT_FALSE(on());
  EXPECT_EQ(menu(), "");
  press(ImGuiKey_S, ImGuiMod_Alt);
  EXPECT_EQ(menu(), "Simulation") << "at once, with Alt down";
}

TEST_F(MenuKeysTest, LeavesChordsWithAltToTheirCommands) {
  app.viewer->mode = Mode::layout;
  press(ImGuiKey_H, ImGuiMod_Alt);
  EXPECT_EQ(menu(), "") << "Alt+H displays all taxels";
  press(ImGuiKey_H);
  EXPECT_EQ(menu(), "");
}

TEST_F(MenuKeysTest, CarriesOutAnEntryByEnter) {
  press(ImGuiKey_F10);
  press(ImGuiKey_M);
  press(ImGuiKey_RightArrow);
  ASSERT_EQ(menu(), "Simulation");
  press(ImGuiKey_Enter);
  EXPECT_NE(run.scene.asked<PlayOrPause>(), nullptr) << "the first entry is marked when the menu opens";
  EXPECT_FALSE(on());
  EXPECT_EQ(menu(), "");
}

TEST_F(MenuKeysTest, WalksIntoSubmenusAndBack) {
  press(ImGuiKey_F10);
  press(ImGuiKey_F);
  for (int i = 0; i < 40 && !is_listed("Export layout..."); ++i) {
    press(ImGuiKey_DownArrow);
    if (!app.get<MenuKeys>().on_submenu) continue;
    press(ImGuiKey_RightArrow);
    ASSERT_EQ(menu(), "File") << "Right opens the submenu of the marked entry";
    if (!is_listed("Export layout...")) press(ImGuiKey_LeftArrow);
  }
  ASSERT_TRUE(is_listed("Export layout..."));
  press(ImGuiKey_LeftArrow);
  EXPECT_FALSE(is_listed("Export layout..."));
  EXPECT_EQ(menu(), "File");
  press(ImGuiKey_RightArrow);
  EXPECT_TRUE(is_listed("Export layout..."));
  press(ImGuiKey_Escape);
  EXPECT_FALSE(is_listed("Export layout..."));
  EXPECT_EQ(menu(), "File") << "Esc closes the submenu alone";
  press(ImGuiKey_RightArrow);
  press(ImGuiKey_RightArrow);
  EXPECT_EQ(menu(), "Edit") << "Right goes on where the entry has no submenu";
}

TEST_F(MenuKeysTest, KeepsTheKeysOfTheWindowFromTheirCommands) {
  press(ImGuiKey_F10);
  app.ui->commands.clear();
  for (const ImGuiKey key : {ImGuiKey_LeftArrow, ImGuiKey_RightArrow, ImGuiKey_Home, ImGuiKey_End, ImGuiKey_L})
    press(key);
  press(ImGuiKey_DownArrow);
  for (const ImGuiKey key : {ImGuiKey_DownArrow, ImGuiKey_RightArrow, ImGuiKey_Home, ImGuiKey_End, ImGuiKey_L})
    press(key);
  press(ImGuiKey_Escape);
  press(ImGuiKey_Escape);
  EXPECT_FALSE(on());
  EXPECT_TRUE(app.ui->commands.empty()) << app.ui->commands.size();
  press(ImGuiKey_LeftArrow);
  EXPECT_NE(run.scene.asked<StepBack>(), nullptr) << "they act again";
}

TEST_F(MenuKeysTest, LeavesTheKeyboardToFieldsAndGestures) {
  app.get<ToolState>().tool = Tool::move;
  press(ImGuiKey_F10);
  press(ImGuiKey_LeftAlt);
  EXPECT_FALSE(on()) << "a gesture runs";
  app.get<ToolState>() = {};
  app.ui->fields.had_keys = true;
  run.interface.key(ImGuiKey_F10, true);
  run.interface.frame([&] { draw_menu_bar(app); });
  EXPECT_FALSE(on()) << "somebody types";
}

TEST_F(MenuKeysTest, TakesAltOnlyAlone) {
  for (const ImGuiKey other : {ImGuiKey_UpArrow, ImGuiKey_MouseLeft, ImGuiKey_MouseWheelY, ImGuiKey_Q}) {
    run.interface.key(ImGuiKey_LeftAlt, true);
    frame();
    if (other == ImGuiKey_MouseLeft) {
      run.interface.button(true);
    } else if (other == ImGuiKey_MouseWheelY) {
      ImGui::GetIO().AddMouseWheelEvent(0, 1);
    } else {
      run.interface.key(other, true);
    }
    frame();
    if (other == ImGuiKey_MouseLeft) {
      run.interface.button(false);
    } else if (other != ImGuiKey_MouseWheelY) {
      run.interface.key(other, false);
    }
    frame();
    run.interface.key(ImGuiKey_LeftAlt, false);
    frame();
    EXPECT_FALSE(on()) << ImGui::GetKeyName(other);
  }
  press(ImGuiKey_RightAlt);
  EXPECT_FALSE(on()) << "the right Alt writes characters";
}

TEST_F(MenuKeysTest, GivesTheKeyboardBackToItsWindow) {
  ImGui::SetWindowFocus("Panel");
  frame();
  frame();
  ASSERT_TRUE(focused);
  press(ImGuiKey_F10);
  EXPECT_FALSE(focused);
  press(ImGuiKey_Escape);
  EXPECT_TRUE(focused);
  press(ImGuiKey_F10);
  press(ImGuiKey_E);
  press(ImGuiKey_F10);
  EXPECT_TRUE(focused);
}

TEST_F(MenuKeysTest, EndsByAClickElsewhere) {
  press(ImGuiKey_F10);
  click(700, 500);
  EXPECT_FALSE(on());
  press(ImGuiKey_F10);
  press(ImGuiKey_F);
  click(700, 500);
  EXPECT_FALSE(on());
  EXPECT_EQ(menu(), "");
}

}  // namespace
}  // namespace taxel::ui
