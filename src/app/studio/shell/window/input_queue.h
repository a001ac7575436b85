// Queue of raw events for ImGui, released in portions in which ImGui can distinguish them.
#pragma once

#include <deque>
#include <vector>

#include "app/studio/shell/window/input_event.h"

namespace taxel::studio {

/// Queue of raw events. ImGui applies modifiers to all keys, buttons and wheel turns of a frame, whatever their order:
/// Ctrl+wheel with a quick release of Ctrl would be a wheel turn without Ctrl. A modifier that changes after such an
/// event therefore waits for the next frame.
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
