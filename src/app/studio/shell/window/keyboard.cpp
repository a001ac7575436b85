#include "app/studio/shell/window/keyboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

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

namespace {

/// GLFW's number of the key next to the left Shift, which US keyboards do not have.
constexpr int kExtraKey = 0xa1;

// GLFW numbers the other keys by the capital letter or the sign that they have on a US keyboard.
bool is_letter(int key) {
  return key >= 'A' && key <= 'Z';
}
bool is_digit(int key) {
  return key >= '0' && key <= '9';
}
bool is_sign(int key) {
  return !is_letter(key) && !is_digit(key);
}

/// Returns the key that has a label on a US keyboard, or 0 if no key has it there.
int us_key(const std::string& label) {
  constexpr unsigned char kLast = 0x7f;
  if (label.size() != 1 || static_cast<unsigned char>(label[0]) > kLast) return 0;
  const int capital = std::toupper(static_cast<unsigned char>(label[0]));
  int found = 0;
  visit_labelled_keys([&](int key) { found = key == capital ? key : found; });
  return found;
}

/// Gives keys the meanings that keys have on a US keyboard. The first gift of a meaning, or to a key, is final.
class Assignment {
 public:
  explicit Assignment(const KeyLabels& labels) : labels_(labels) {}

  [[nodiscard]] const std::map<int, int>& meanings() const { return meanings_; }
  [[nodiscard]] std::string label(int key) const {
    const auto found = labels_.find(key);
    return found != labels_.end() ? found->second : std::string();
  }
  /// Follows labels that satisfy a condition. Of two keys with one label, the key at the place of a US keyboard has
  /// precedence.
  void follow_labels(bool (*condition)(int)) {
    visit_labelled_keys([&](int key) {
      if (us_key(label(key)) == key && condition(key)) give(key, key);
    });
    visit_labelled_keys([&](int key) {
      const int labelled = us_key(label(key));
      if (labelled != 0 && condition(labelled)) give(key, labelled);
    });
  }
  void keep_places(bool (*condition)(int)) {
    visit_labelled_keys([&](int key) {
      if (condition(key)) give(key, key);
    });
  }
  /// Gives each other key its meaning on a US keyboard, or the first free one along the keys that took it over.
  void exchange_others() {
    visit_labelled_keys([&](int key) {
      if (meanings_.contains(key)) return;
      int meaning = key;
      while (owners_.contains(meaning)) meaning = owners_.at(meaning);
      give(key, meaning);
    });
  }

 private:
  void give(int key, int meaning) {
    if (meanings_.contains(key) || owners_.contains(meaning)) return;
    meanings_[key] = meaning;
    owners_[meaning] = key;
  }

  const KeyLabels& labels_;
  std::map<int, int> meanings_, owners_;
};

ui::KeyNames names_of(const Assignment& assignment) {
  ui::KeyNames names;
  for (const auto& [key, meaning] : assignment.meanings()) {
    const std::string label = assignment.label(key);
    const bool has_us_name = us_key(label) == meaning || (is_digit(meaning) && key == meaning) || meaning == kExtraKey;
    if (!label.empty() && !has_us_name) names[imgui_key(meaning)] = label;
  }
  return names;
}

}  // namespace

KeyMeanings meanings_of(const KeyLabels& labels) {
  Assignment assignment(labels);
  const bool is_latin =
      std::any_of(labels.begin(), labels.end(), [](const auto& label) { return is_letter(us_key(label.second)); });
  if (is_latin) {
    assignment.follow_labels(is_letter);
    assignment.follow_labels(is_digit);
    assignment.keep_places(is_digit);
    assignment.follow_labels(is_sign);
  }
  assignment.exchange_others();
  KeyMeanings result;
  for (const auto& [key, meaning] : assignment.meanings()) result.keys[key] = imgui_key(meaning);
  if (!is_latin) return result;
  result.names = names_of(assignment);
  // Turkish keyboards have two letters I, and the capital of the one with a dot keeps the dot.
  if (std::any_of(labels.begin(), labels.end(), [](const auto& label) { return label.second == "ı"; }))
    result.names[ImGuiKey_I] = "İ";
  return result;
}

bool Keyboard::set_labels(KeyLabels labels) {
  if (labels == labels_) return false;
  labels_ = std::move(labels);
  KeyMeanings former = std::exchange(meanings_, meanings_of(labels_));
  return former.names != meanings_.names;
}

ImGuiKey Keyboard::meaning(int glfw_key) const {
  const auto found = meanings_.keys.find(glfw_key);
  return found != meanings_.keys.end() ? found->second : imgui_key(glfw_key);
}

ImGuiKey Keyboard::press(int glfw_key) {
  return pressed_[glfw_key] = meaning(glfw_key);
}

ImGuiKey Keyboard::release(int glfw_key) {
  const auto pressed = pressed_.find(glfw_key);
  if (pressed == pressed_.end()) return meaning(glfw_key);
  const ImGuiKey key = pressed->second;
  pressed_.erase(pressed);
  return key;
}

}  // namespace taxel::studio
