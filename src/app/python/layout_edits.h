// Edits of a layout from Python. Each one applies the rules of apply_edit(), and changes nothing if a rule is broken.
#pragma once

#include <nanobind/nanobind.h>

#include <string>
#include <vector>

#include "app/python/layout_handle.h"

namespace taxel::python {

// All functions throw Error for a broken rule, and TypeError or ValueError for an array of another kind or shape.

void set_name(LayoutHandle& layout, const std::string& name);
void set_names(LayoutHandle& layout, const std::vector<std::string>& names);
void set_centers(LayoutHandle& layout, nanobind::handle centers);
void set_normals(LayoutHandle& layout, nanobind::handle normals);
void set_radii(LayoutHandle& layout, nanobind::handle radii);

/// Adds the methods that edit taxels.
void add_edits(nanobind::class_<LayoutHandle>& type);

}  // namespace taxel::python
