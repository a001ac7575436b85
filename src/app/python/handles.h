// The contents of Python objects: a layout, an immutable value that an edit replaces, so that arrays of the old value
// stay valid, and a compiled model.
#pragma once

#include <memory>
#include <string>

#include "core/layout/layout.h"
#include "core/sensor/sensor_model.h"

namespace taxel::python {

/// A function that releases Python's lock takes a LayoutHandle by value, because another thread may edit the Python
/// object meanwhile.
struct LayoutHandle {
  std::shared_ptr<const Layout> value;
  std::string file;  ///< file of the layout, or empty; its folder is that of a relative mesh file
};

/// Returns the layout with an absolute path of its mesh.
Layout with_absolute_mesh(const LayoutHandle& layout);

/// Returns the JSON text of one value in the layout's file. Throws Error naming a pointer without a value.
std::string value_of(const LayoutHandle& layout, const std::string& pointer);

/// Returns the layout with another value, which may be a new key. Throws Error as parse_layout() does, and for the
/// first broken rule at or below the pointer, and for an unknown key.
Layout with_value(const LayoutHandle& layout, const std::string& pointer, const std::string& json_text);

struct SensorModelHandle {
  SensorModelPtr model;
  std::string file;  ///< file of the layout, or empty
};

/// Compiles a layout in another thread, while this thread handles Python's signals without holding Python's lock in
/// between. Throws Error, or the Python exception of a signal, such as KeyboardInterrupt.
SensorModelPtr build_interruptibly(LayoutHandle layout, SampleQuality quality);

}  // namespace taxel::python
