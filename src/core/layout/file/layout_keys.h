// The keys that each object of a layout file may have. assets/schema/layout.schema.json lists the same ones.
#pragma once

#include <span>
#include <string_view>

namespace taxel {

/// Returns the keys of the object at a JSON pointer into a layout, such as "" (the whole file), "/mesh" or "/taxels/3".
/// Empty if a layout has no object there.
std::span<const std::string_view> known_layout_keys(std::string_view pointer);

}  // namespace taxel
