// State dump of recordings of real sensors.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// Returns {"asks", "problem", "mapping", "shown": null or {...}, "curves", ...}.
std::string real_to_json(const ui::App& app);

}  // namespace taxel::studio
