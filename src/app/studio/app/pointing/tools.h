// The tools of the 3-D view: one row each. A frame's pointer goes through the rows in order; Esc cancels one of them.
#pragma once

#include <span>

#include "app/studio/app/keymap.h"
#include "app/studio/app/pointing/pointer_event.h"

namespace taxel::ui {

struct ToolSpec {
  const char* key;
  Context context = kEverywhere;  ///< mode in which the tool gets the pointer
  /// Handles the pointer. Returns whether the event is consumed: later rows do not get it. Null if the tool has no use
  /// for the pointer.
  bool (*pointer)(App& app, const PointerEvent& event) = nullptr;
  int cancel_order = 0;                      ///< Esc cancels the active row with the lowest number
  bool (*active)(const App& app) = nullptr;  ///< whether Esc can cancel the tool now
  void (*cancel)(App& app) = nullptr;        ///< function that ends the tool, or null
};

/// All rows, in the order in which they get the pointer.
std::span<const ToolSpec> tools();

/// Cancels the active row that comes first by `cancel_order`.
void cancel_innermost(App& app);

/// Reads the pointer over the view's item and gives it to the rows, until one consumes it.
void handle_view_mouse(App& app);

}  // namespace taxel::ui
