#include "app/studio/shell/window/input_queue.h"

namespace taxel::studio {

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
