// The one door for input: GLFW's callbacks, the script player and tests all speak these events.
#pragma once

#include <imgui.h>

#include <string>
#include <variant>
#include <vector>

namespace taxel::studio {

// Pixels from the window's top left corner. Modifiers are keys of their own (ImGuiMod_Ctrl, ...).
struct MouseMove {
  float x = 0, y = 0;
};
struct MouseButton {
  int button = 0;
  bool down = false;
};  ///< 0 left, 1 right, 2 middle
struct MouseWheel {
  float x = 0, y = 0;
};
struct KeyPress {
  ImGuiKey key = ImGuiKey_None;
  bool down = false;
};
struct TextInput {
  unsigned codepoint = 0;
};
struct FocusChange {
  bool focused = false;
};
struct DropFiles {
  std::vector<std::string> paths;
};
struct ResizeWindow {
  int width = 0, height = 0;
};
struct CloseWindow {};

using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, KeyPress, TextInput, FocusChange, DropFiles,
                                ResizeWindow, CloseWindow>;

/// Hands the event to ImGui's queue. False for events that are not ImGui's business (drop, resize, close).
bool feed(const InputEvent& event, ImGuiIO& io);

/// ImGui's key of a name as scripts write it ("o", "Space", "Left", ".", "F1", any case); None: unknown.
ImGuiKey key_of_name(const std::string& name);

}  // namespace taxel::studio
