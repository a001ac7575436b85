// Converts GLFW's key numbers to ImGui's: by the place of a key on a US keyboard, and by its label, so that a shortcut
// is at the key with its letter or sign, wherever a layout has that key.
#pragma once

#include <imgui.h>

#include <map>
#include <string>
#include <string_view>

#include "app/studio/frame/keymap.h"

namespace taxel::studio {

ImGuiKey imgui_key(int glfw_key);  ///< ImGuiKey_None if ImGui does not know the key

/// GLFW's key to the character that the key types without Shift, in UTF-8. Keys without a character are absent.
using KeyLabels = std::map<int, std::string>;

/// Calls visit(key) for each of GLFW's keys that type a character, except space and the number pad.
template <class Visit>
void visit_labelled_keys(const Visit& visit) {
  for (const char key : std::string_view("',-./0123456789;=ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]`\xa1"))
    visit(static_cast<int>(static_cast<unsigned char>(key)));
}

/// Meanings and names of the keys of one layout.
struct KeyMeanings {
  std::map<int, ImGuiKey> keys;  ///< GLFW's key to ImGui's, one to one
  ui::KeyNames names;
};

/// Gives each key a meaning. Without a Latin letter among the labels (Russian, Greek), all keys have the meanings of a
/// US keyboard. Otherwise:
/// 1. Letters are at the keys with their labels.
/// 2. So are digits. A digit that needs Shift (French) is at its key in the row of digits, which also shows the digit.
/// 3. Signs are at the keys with their labels.
/// 4. Each other key keeps its meaning on a US keyboard. If another key has that meaning by its label, the key takes
///    over the meaning of that other key: keys are exchanged, as Y and Z are on a German keyboard.
/// A key whose label differs from its meaning has its label as name, unless the meaning is a digit in its row.
[[nodiscard]] KeyMeanings meanings_of(const KeyLabels& labels);

/// Converts GLFW's keys to ImGui's by the labels of the present layout.
class Keyboard {
 public:
  Keyboard() : meanings_(meanings_of({})) {}

  /// Sets the present layout. Returns whether the names of keys have changed.
  bool set_labels(KeyLabels labels);
  /// Returns ImGui's key for a pressed key, or ImGuiKey_None if ImGui does not know the key.
  ImGuiKey press(int glfw_key);
  /// Returns the key that press() returned for this key, even if the layout has changed since.
  ImGuiKey release(int glfw_key);
  [[nodiscard]] const ui::KeyNames& names() const { return meanings_.names; }

 private:
  [[nodiscard]] ImGuiKey meaning(int glfw_key) const;

  KeyLabels labels_;
  KeyMeanings meanings_;
  std::map<int, ImGuiKey> pressed_;  ///< GLFW's keys that are down
};

}  // namespace taxel::studio
