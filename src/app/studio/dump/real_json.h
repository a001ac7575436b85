// Recordings of real sensors, and videos, for the state that is dumped.
#pragma once

#include <string>

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

/// {"asks", "problem", "mapping", "shown": null or {...}, "curves"}
std::string real_to_json(const ui::App& app);

}  // namespace taxel::studio
