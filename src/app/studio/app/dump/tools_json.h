// State dump of the probe and its reading, the measuring tool, and the clip plane.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns {"probe": ..., "measure": ..., "clip": ..., ...}, with null for a tool that is off.
std::string tools_to_json(const ui::App& app);

}  // namespace taxel::studio
