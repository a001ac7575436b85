#include "app/studio/shell/window/input_event.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace taxel::studio {
namespace {

struct Feeder {
  ImGuiIO& io;
  bool operator()(const MouseMove& e) const { return io.AddMousePosEvent(e.x, e.y), true; }
  bool operator()(const MouseButton& e) const { return io.AddMouseButtonEvent(e.button, e.down), true; }
  bool operator()(const MouseWheel& e) const { return io.AddMouseWheelEvent(e.x, e.y), true; }
  bool operator()(const KeyPress& e) const { return io.AddKeyEvent(e.key, e.down), true; }
  bool operator()(const TextInput& e) const { return io.AddInputCharacter(e.codepoint), true; }
  bool operator()(const FocusChange& e) const { return io.AddFocusEvent(e.focused), true; }
  bool operator()(const DropFiles&) const { return false; }
  bool operator()(const ResizeWindow&) const { return false; }
  bool operator()(const CloseWindow&) const { return false; }
  bool operator()(const RenameKeys&) const { return false; }
};

bool same_name(const std::string& a, const std::string& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

struct Alias {
  const char* name;
  ImGuiKey key;
};

}  // namespace

bool feed(const InputEvent& event, ImGuiIO& io) {
  return std::visit(Feeder{io}, event);
}

bool is_deliberate(const InputEvent& event) {
  return std::holds_alternative<MouseButton>(event) || std::holds_alternative<MouseWheel>(event) ||
         std::holds_alternative<KeyPress>(event) || std::holds_alternative<TextInput>(event) ||
         std::holds_alternative<DropFiles>(event);
}

ImGuiKey key_of_name(const std::string& name) {
  constexpr std::array kAliases = {
      Alias{".", ImGuiKey_Period},   Alias{"=", ImGuiKey_Equal},        Alias{"-", ImGuiKey_Minus},
      Alias{"/", ImGuiKey_Slash},    Alias{"[", ImGuiKey_LeftBracket},  Alias{"]", ImGuiKey_RightBracket},
      Alias{"esc", ImGuiKey_Escape}, Alias{"left", ImGuiKey_LeftArrow}, Alias{"right", ImGuiKey_RightArrow},
      Alias{"up", ImGuiKey_UpArrow}, Alias{"down", ImGuiKey_DownArrow}, Alias{"return", ImGuiKey_Enter}};
  for (const Alias& alias : kAliases) {
    if (same_name(name, alias.name)) return alias.key;
  }
  for (int key = ImGuiKey_NamedKey_BEGIN; key < ImGuiKey_NamedKey_END; ++key) {
    if (same_name(name, ImGui::GetKeyName(static_cast<ImGuiKey>(key)))) return static_cast<ImGuiKey>(key);
  }
  return ImGuiKey_None;
}

namespace {

bool is_modifier(ImGuiKey key) {
  return (key & ImGuiMod_Mask_) != 0;
}

/// Returns whether modifiers are part of the meaning of an event.
bool goes_with_modifiers(const InputEvent& event) {
  const auto* key = std::get_if<KeyPress>(&event);
  if (key != nullptr) return key->down && !is_modifier(key->key);
  return std::holds_alternative<MouseWheel>(event) || std::holds_alternative<MouseButton>(event);
}

}  // namespace

void InputQueue::add(const std::vector<InputEvent>& events) {
  waiting_.insert(waiting_.end(), events.begin(), events.end());
}

std::vector<InputEvent> InputQueue::take() {
  std::vector<InputEvent> taken;
  bool meant = false;
  while (!waiting_.empty()) {
    const InputEvent& next = waiting_.front();
    if (const auto* key = std::get_if<KeyPress>(&next); key != nullptr && is_modifier(key->key)) {
      const int after = key->down ? held_ | key->key : held_ & ~static_cast<int>(key->key);
      if (after != held_ && meant) break;
      held_ = after;
    }
    if (std::holds_alternative<FocusChange>(next)) held_ = 0;  // ImGui releases all keys then
    meant = meant || goes_with_modifiers(next);
    taken.push_back(next);
    waiting_.pop_front();
  }
  return taken;
}

}  // namespace taxel::studio
