// Input events, which GLFW's callbacks, the script player and tests all produce, and their queue for ImGui.
#pragma once

#include <imgui.h>

#include <deque>
#include <string>
#include <variant>
#include <vector>

namespace taxel::studio {

// Pixels are relative to the window's top left corner. Modifiers are keys of their own (ImGuiMod_Ctrl, ...).
struct MouseMove {
  float x = 0, y = 0;
};
/// A mouse button: 0 is left, 1 is right, 2 is middle.
struct MouseButton {
  int button = 0;
  bool down = false;
};
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
struct RenameKeys {};  ///< change of Window::key_names()

using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, KeyPress, TextInput, FocusChange, DropFiles,
                                ResizeWindow, CloseWindow, RenameKeys>;

/// Adds the event to ImGui's queue. Returns false for events that ImGui does not handle (drop, resize, close, names).
bool feed(const InputEvent& event, ImGuiIO& io);

/// Whether the user acts on purpose: a key, a button, the wheel or files, but not a resting hand that moves the
/// pointer.
[[nodiscard]] bool is_deliberate(const InputEvent& event);

/// Returns ImGui's key for a name as in scripts ("o", "Space", "Left", ".", "F1", any case), or ImGuiKey_None if the
/// name is unknown.
ImGuiKey key_of_name(const std::string& name);

/// Queue of raw events for ImGui, released in portions in which ImGui can distinguish them. ImGui applies modifiers to
/// all keys, buttons and wheel turns of a frame, whatever their order: Ctrl+wheel with a quick release of Ctrl would be
/// a wheel turn without Ctrl. A modifier that changes after such an event therefore waits for the next frame.
class InputQueue {
 public:
  void add(const std::vector<InputEvent>& events);
  /// Removes and returns the events for one frame, in order of arrival.
  std::vector<InputEvent> take();
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::deque<InputEvent> waiting_;
  int held_ = 0;  ///< modifiers that are down after the events that were taken
};

}  // namespace taxel::studio
