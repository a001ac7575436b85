// The information about a scene and the displayed step, as listed by MuJoCo's viewer.
#pragma once

#include <string>
#include <vector>

#include "app/studio/frame/shown.h"

namespace taxel::ui {

struct InfoRow {
  std::string name, value;
};
/// Returns the rows of information. Rates measured in real time are left out in script mode.
[[nodiscard]] std::vector<InfoRow> scene_info(const RunView& run);

}  // namespace taxel::ui
