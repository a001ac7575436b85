// Input events from GLFW and from scripts.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <string>

#include "app/studio/shell/window/input_event.h"
#include "app/studio/shell/window/keyboard.h"
#include "ui/tools/interface_frames.h"

namespace taxel::studio {
namespace {

TEST(GlfwKeys, HaveTheNamesPrintedOnTheKeys) {
  const ui::test::InterfaceFrames interface;
  for (int key = 'A'; key <= 'Z'; ++key) EXPECT_EQ(imgui_key(key), key_of_name(std::string(1, static_cast<char>(key))));
  for (int key = '0'; key <= '9'; ++key) EXPECT_EQ(imgui_key(key), key_of_name(std::string(1, static_cast<char>(key))));
  for (const char mark : std::string(".=-/[]")) EXPECT_EQ(imgui_key(mark), key_of_name(std::string(1, mark))) << mark;
  for (int i = 0; i < 12; ++i) EXPECT_EQ(imgui_key(GLFW_KEY_F1 + i), key_of_name("F" + std::to_string(i + 1)));
  const std::pair<int, const char*> named[] = {{GLFW_KEY_LEFT, "Left"},
                                               {GLFW_KEY_RIGHT, "Right"},
                                               {GLFW_KEY_UP, "Up"},
                                               {GLFW_KEY_DOWN, "Down"},
                                               {GLFW_KEY_HOME, "Home"},
                                               {GLFW_KEY_END, "End"},
                                               {GLFW_KEY_PAGE_UP, "PageUp"},
                                               {GLFW_KEY_PAGE_DOWN, "PageDown"},
                                               {GLFW_KEY_TAB, "Tab"},
                                               {GLFW_KEY_ENTER, "Enter"},
                                               {GLFW_KEY_KP_ENTER, "KeypadEnter"},
                                               {GLFW_KEY_BACKSPACE, "Backspace"},
                                               {GLFW_KEY_DELETE, "Delete"},
                                               {GLFW_KEY_SPACE, "Space"},
                                               {GLFW_KEY_ESCAPE, "Escape"}};
  for (const auto& [key, name] : named) EXPECT_EQ(imgui_key(key), key_of_name(name)) << name;
  EXPECT_EQ(imgui_key(GLFW_KEY_UNKNOWN), ImGuiKey_None);
}

TEST(InputEvents, ReachTheInterfaceUnchanged) {
  ui::test::InterfaceFrames interface;
  ImGuiIO& io = ImGui::GetIO();
  EXPECT_TRUE(feed(MouseMove{120, 45}, io));
  EXPECT_TRUE(feed(MouseButton{1, true}, io));
  EXPECT_TRUE(feed(MouseWheel{0.5f, -2}, io));
  EXPECT_TRUE(feed(KeyPress{ImGuiKey_G, true}, io));
  EXPECT_TRUE(feed(TextInput{'x'}, io));
  interface.frame([&] {
    EXPECT_EQ(io.MousePos.x, 120);
    EXPECT_EQ(io.MousePos.y, 45);
    EXPECT_TRUE(ImGui::IsMouseDown(ImGuiMouseButton_Right));
    EXPECT_FALSE(ImGui::IsMouseDown(ImGuiMouseButton_Left));
    EXPECT_EQ(io.MouseWheelH, 0.5f);
    EXPECT_EQ(io.MouseWheel, -2);
    EXPECT_TRUE(ImGui::IsKeyDown(ImGuiKey_G));
    ASSERT_EQ(io.InputQueueCharacters.Size, 1);
    EXPECT_EQ(io.InputQueueCharacters[0], 'x');
  });
  EXPECT_FALSE(feed(CloseWindow{}, io));
  EXPECT_FALSE(feed(ResizeWindow{100, 100}, io));
  EXPECT_FALSE(feed(DropFiles{{"a"}}, io));
}

}  // namespace
}  // namespace taxel::studio
