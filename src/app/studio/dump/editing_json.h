// The tool in use, fields, table, problems and the Generate panel, as the state of the window tells them.
#pragma once

#include <string>

#include "app/studio/app/app.h"

namespace taxel::studio {

/// {"tool": ..., "refused": ..., "keyboard": ..., "table": ..., "problems": ..., "generate": ..., ...}
std::string editing_to_json(const ui::App& app);

}  // namespace taxel::studio
