// State dump of the current tool, fields, taxel table, problems and Generate panel.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns {"tool": ..., "refused": ..., "keyboard": ..., "table": ..., "problems": ..., "generate": ..., ...}.
std::string editing_to_json(const ui::App& app);

}  // namespace taxel::studio
