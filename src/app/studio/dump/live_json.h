// What the views of the step shown say: tractions, the skin's colours, the map of taxels, other models.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// A JSON object with "tractions", "skin", "map" and "models".
std::string live_to_json(const ui::App& app);

}  // namespace taxel::studio
