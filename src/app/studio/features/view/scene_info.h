// What there is to know of a scene and of the step that is shown, as MuJoCo's viewer lists it.
#pragma once

#include <string>
#include <vector>

#include "app/studio/app/values/shown.h"

namespace taxel::ui {

struct InfoRow {
  std::string name, value;
};
/// Rates of the clock are left out where pictures follow a script.
[[nodiscard]] std::vector<InfoRow> scene_info(const RunView& run);

}  // namespace taxel::ui
