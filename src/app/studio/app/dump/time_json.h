// The past of the simulation in the state that scripts look at.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// As JSON text; "null": there is none.
std::string steps_to_json(const ui::App& app);
std::string timeline_to_json(const ui::App& app);

}  // namespace taxel::studio
