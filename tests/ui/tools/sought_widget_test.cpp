// A sought widget: its panel comes to the front, its section opens, and it gets the keyboard.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "ui/tools/interface_frames.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"

namespace taxel::ui {
namespace {

/// Two panels in one place, each with a section that is far below its upper edge.
class SoughtWidgetTest : public testing::Test {
 protected:
  SoughtWidgetTest() {
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_DockingEnable;
    frames(5);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) interface.frame([&] { draw(); });
  }
  void draw() {
    constexpr int kLinesAbove = 60;
    ui.widgets.begin_frame();
    const ImGuiID dock = ImGui::DockSpaceOverViewport();
    for (const char* panel : {"First", "Second"}) {
      ImGui::SetNextWindowDockID(dock, ImGuiCond_FirstUseEver);
      if (begin_panel(ui, panel, nullptr)) {
        for (int i = 0; i < kLinesAbove; ++i) ImGui::TextUnformatted("A line");
        if (closes) ImGui::SetNextItemOpen(false);
        if (header(ui, "Section##id") && begin_properties("values")) draw_values();
      }
      ImGui::End();
    }
    closes = false;
    record_keyboard(ui, {});
  }
  void draw_values() {
    begin_property("Friction");
    if (const auto typed = number_field(ui, "Friction", {friction}, kExactNumber)) friction = *typed;
    begin_property("Centre");
    if (const auto typed = vector_field(ui, "Centre", {dvec3(1, 2, 3)}, kExactNumber)) axis = typed->axis;
    end_properties();
    if (button(ui, "Repair")) pressed = true;
  }
  void press(ImGuiKey key) {
    interface.key(key, true);
    frames(1);
    interface.key(key, false);
    frames(2);
  }
  /// Closes the sections, seeks a widget, and draws the frames that this takes.
  void seek(const SoughtWidget& widget) {
    closes = true;
    frames(2);
    ui.widgets.seek(widget);
    frames(6);
  }
  static std::string focused() { return ImGui::GetCurrentContext()->NavWindow->Name; }

  test::InterfaceFrames interface;
  Ui ui;
  double friction = 1;
  int axis = -1;
  bool pressed = false, closes = false;
};

TEST_F(SoughtWidgetTest, GetsTheTypedText) {
  seek({"First", "Section", "Friction", ""});
  EXPECT_EQ(focused(), "First");
  EXPECT_EQ(ui.fields.keyboard_panel, "First");
  EXPECT_NE(ui.widgets.find("Friction"), nullptr) << "it is scrolled into view";
  ImGui::GetIO().AddInputCharacter('7');
  press(ImGuiKey_Enter);
  EXPECT_EQ(friction, 7);
}

TEST_F(SoughtWidgetTest, IsTheFirstAxisOfAVector) {
  seek({"Second", "Section", "Centre", ""});
  EXPECT_EQ(focused(), "Second") << "the tab that was behind comes to the front, or stays there";
  ImGui::GetIO().AddInputCharacter('7');
  press(ImGuiKey_Enter);
  EXPECT_EQ(axis, 0);
}

TEST_F(SoughtWidgetTest, IsPressedBySpace) {
  seek({"First", "Section", "Repair", ""});
  press(ImGuiKey_Space);
  EXPECT_TRUE(pressed);
}

TEST_F(SoughtWidgetTest, GivesWayToTheOtherOneIfItIsNotDrawn) {
  ui.widgets.seek({"First", "Section", "Absent", "Repair"});
  frames(20);
  press(ImGuiKey_Space);
  EXPECT_TRUE(pressed);
}

TEST_F(SoughtWidgetTest, IsForgottenIfNothingDrawsIt) {
  ui.widgets.seek({"First", "Section", "Absent", ""});
  EXPECT_TRUE(ui.widgets.seeks_in("First"));
  frames(20);
  EXPECT_FALSE(ui.widgets.seeks_in("First"));
}

}  // namespace
}  // namespace taxel::ui
