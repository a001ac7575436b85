// The probe and its reading, the measure and the clip plane, as the state of the window tells them.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// {"probe": ..., "measure": ..., "clip": ...}; null: there is none.
std::string tools_to_json(const ui::App& app);

}  // namespace taxel::studio
