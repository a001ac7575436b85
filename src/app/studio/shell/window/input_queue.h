// Raw events on their way to ImGui, in the portions in which they can be told apart.
#pragma once

#include <deque>
#include <vector>

#include "app/studio/shell/window/input_event.h"

namespace taxel::studio {

/// A modifier that changes in the same picture as a key, a button or the wheel would count for them whatever came
/// first: Ctrl+wheel, let go quickly, would be a wheel without Ctrl. Such a change waits for the next picture.
class InputQueue {
 public:
  void add(const std::vector<InputEvent>& events);
  /// What one picture may take, in order of arrival.
  std::vector<InputEvent> take();
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

 private:
  std::deque<InputEvent> waiting_;
  int held_ = 0;  ///< modifiers that are down after what was taken
};

}  // namespace taxel::studio
