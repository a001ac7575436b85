// The whole state of the window: a plain value. The rows of the nouns pass its parts to their panels and tools.
#pragma once

#include "app/studio/frame/states.h"

namespace taxel::ui {

struct WindowUi;
struct Viewer;
struct Shown;

/// The rooms of the window. SIMULATE and ANALYSE both display the run, with one camera and the same overlays.
enum class Mode { layout, simulate, analyse };

[[nodiscard]] constexpr bool shows_run(Mode mode) {
  return mode != Mode::layout;
}

/// Returns the name of a mode, as its button has it.
[[nodiscard]] constexpr const char* name_of(Mode mode) {
  constexpr const char* kNames[] = {"LAYOUT", "SIMULATE", "ANALYSE"};
  return kNames[static_cast<int>(mode)];
}

/// A file that uses a part includes the part's header, so that a change of one part compiles only its users again.
struct App {
  Indirect<WindowUi> ui;    ///< window_ui.h
  Indirect<Viewer> viewer;  ///< viewer.h
  Indirect<Shown> shown;    ///< shown.h
  States states;            ///< states of the features

  /// Returns the state of a feature, as States does.
  template <class T>
  [[nodiscard]] T& get() {
    return states.get<T>();
  }
  template <class T>
  [[nodiscard]] const T& get() const {
    return states.get<T>();
  }
};

}  // namespace taxel::ui
