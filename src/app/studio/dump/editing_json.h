// The tool in use, fields, table, problems and the Generate panel, as the state of the window tells them.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// {"tool": ..., "refused": ..., "keyboard": ..., "table": ..., "problems": ..., "generate": ..., ...}
std::string editing_to_json(const ui::App& app);

}  // namespace taxel::studio
