#include "app/studio/shell/window/glfw_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace taxel::studio {

namespace {

struct KeyPair {
  int glfw;
  ImGuiKey imgui;
};

constexpr std::array kKeys = {
    KeyPair{GLFW_KEY_TAB, ImGuiKey_Tab},
    KeyPair{GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    KeyPair{GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    KeyPair{GLFW_KEY_UP, ImGuiKey_UpArrow},
    KeyPair{GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    KeyPair{GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
    KeyPair{GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
    KeyPair{GLFW_KEY_HOME, ImGuiKey_Home},
    KeyPair{GLFW_KEY_END, ImGuiKey_End},
    KeyPair{GLFW_KEY_INSERT, ImGuiKey_Insert},
    KeyPair{GLFW_KEY_DELETE, ImGuiKey_Delete},
    KeyPair{GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    KeyPair{GLFW_KEY_SPACE, ImGuiKey_Space},
    KeyPair{GLFW_KEY_ENTER, ImGuiKey_Enter},
    KeyPair{GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    KeyPair{GLFW_KEY_APOSTROPHE, ImGuiKey_Apostrophe},
    KeyPair{GLFW_KEY_COMMA, ImGuiKey_Comma},
    KeyPair{GLFW_KEY_MINUS, ImGuiKey_Minus},
    KeyPair{GLFW_KEY_PERIOD, ImGuiKey_Period},
    KeyPair{GLFW_KEY_SLASH, ImGuiKey_Slash},
    KeyPair{GLFW_KEY_SEMICOLON, ImGuiKey_Semicolon},
    KeyPair{GLFW_KEY_EQUAL, ImGuiKey_Equal},
    KeyPair{GLFW_KEY_LEFT_BRACKET, ImGuiKey_LeftBracket},
    KeyPair{GLFW_KEY_BACKSLASH, ImGuiKey_Backslash},
    KeyPair{GLFW_KEY_RIGHT_BRACKET, ImGuiKey_RightBracket},
    KeyPair{GLFW_KEY_GRAVE_ACCENT, ImGuiKey_GraveAccent},
    KeyPair{GLFW_KEY_WORLD_1, ImGuiKey_Oem102},
    KeyPair{GLFW_KEY_CAPS_LOCK, ImGuiKey_CapsLock},
    KeyPair{GLFW_KEY_PRINT_SCREEN, ImGuiKey_PrintScreen},
    KeyPair{GLFW_KEY_PAUSE, ImGuiKey_Pause},
    KeyPair{GLFW_KEY_KP_DECIMAL, ImGuiKey_KeypadDecimal},
    KeyPair{GLFW_KEY_KP_DIVIDE, ImGuiKey_KeypadDivide},
    KeyPair{GLFW_KEY_KP_MULTIPLY, ImGuiKey_KeypadMultiply},
    KeyPair{GLFW_KEY_KP_SUBTRACT, ImGuiKey_KeypadSubtract},
    KeyPair{GLFW_KEY_KP_ADD, ImGuiKey_KeypadAdd},
    KeyPair{GLFW_KEY_KP_ENTER, ImGuiKey_KeypadEnter},
    KeyPair{GLFW_KEY_KP_EQUAL, ImGuiKey_KeypadEqual},
    KeyPair{GLFW_KEY_LEFT_SHIFT, ImGuiKey_LeftShift},
    KeyPair{GLFW_KEY_LEFT_CONTROL, ImGuiKey_LeftCtrl},
    KeyPair{GLFW_KEY_LEFT_ALT, ImGuiKey_LeftAlt},
    KeyPair{GLFW_KEY_LEFT_SUPER, ImGuiKey_LeftSuper},
    KeyPair{GLFW_KEY_RIGHT_SHIFT, ImGuiKey_RightShift},
    KeyPair{GLFW_KEY_RIGHT_CONTROL, ImGuiKey_RightCtrl},
    KeyPair{GLFW_KEY_RIGHT_ALT, ImGuiKey_RightAlt},
    KeyPair{GLFW_KEY_RIGHT_SUPER, ImGuiKey_RightSuper},
    KeyPair{GLFW_KEY_MENU, ImGuiKey_Menu},
};

/// Ranges that both number in the same order.
ImGuiKey in_range(int key, int first, int last, ImGuiKey imgui_first) {
  return key >= first && key <= last ? static_cast<ImGuiKey>(imgui_first + (key - first)) : ImGuiKey_None;
}

}  // namespace

ImGuiKey imgui_key(int key) {
  for (const ImGuiKey found :
       {in_range(key, GLFW_KEY_A, GLFW_KEY_Z, ImGuiKey_A), in_range(key, GLFW_KEY_0, GLFW_KEY_9, ImGuiKey_0),
        in_range(key, GLFW_KEY_F1, GLFW_KEY_F12, ImGuiKey_F1),
        in_range(key, GLFW_KEY_KP_0, GLFW_KEY_KP_9, ImGuiKey_Keypad0)}) {
    if (found != ImGuiKey_None) return found;
  }
  const auto pair = std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyPair& k) { return k.glfw == key; });
  return pair == kKeys.end() ? ImGuiKey_None : pair->imgui;
}

}  // namespace taxel::studio
