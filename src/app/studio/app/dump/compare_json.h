// State dump of the comparison of a run with a second layout.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns a JSON object, or null if nothing is compared.
std::string compare_to_json(const ui::App& app);

}  // namespace taxel::studio
