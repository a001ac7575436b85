// State dump of the views of the displayed step: tractions, skin colours, taxel map, other models.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns a JSON object with "tractions", "skin", "map" and "models".
std::string live_to_json(const ui::App& app);

}  // namespace taxel::studio
