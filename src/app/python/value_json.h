// Single values of a layout by their JSON pointers.
#pragma once

#include <string>

#include "app/python/layout_handle.h"

namespace taxel::python {

/// Returns the JSON text of one value in the layout's file. Throws Error naming a pointer without a value.
std::string value_of(const LayoutHandle& layout, const std::string& pointer);

/// Returns the layout with another value, which may be a new key. Throws Error as parse_layout() does, and for the
/// first broken rule at or below the pointer, and for an unknown key.
Layout with_value(const LayoutHandle& layout, const std::string& pointer, const std::string& json_text);

}  // namespace taxel::python
