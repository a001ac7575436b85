// A value that the settings file keeps from one start to the next.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/studio/frame/window_state.h"
#include "ui/scene/scene_input.h"

namespace taxel::ui {

struct App;

struct SavedValue {
  std::string key;  ///< in the settings file
  std::variant<bool*, float*, std::vector<std::string>*, WindowPlace*, Overlays*, GroupsShown*, FramesShown*,
               LabelsShown*>
      value;
};

/// Returns all values of a window that are kept: those of the features too. They are valid as long as `app` is.
std::vector<SavedValue> saved_values(App& app);

}  // namespace taxel::ui
