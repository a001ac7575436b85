// The layout of a Python object: an immutable value that an edit replaces, so that arrays of the old value stay valid.
#pragma once

#include <memory>
#include <string>

#include "core/layout/layout.h"

namespace taxel::python {

/// A function that releases Python's lock takes a LayoutHandle by value, because another thread may edit the Python
/// object meanwhile.
struct LayoutHandle {
  std::shared_ptr<const Layout> value;
  std::string file;  ///< file of the layout, or empty; its folder is that of a relative mesh file
};

/// Returns the layout with an absolute path of its mesh.
Layout with_absolute_mesh(const LayoutHandle& layout);

}  // namespace taxel::python
