// Checks that the lengths of a layout of another program are those of a sensor in metres. Files seldom name their unit.
#pragma once

#include <string>

#include "core/layout/file/imported_layout.h"
#include "core/mesh/query/closest_point.h"

namespace taxel {

/// Multiplies all lengths by `unit` [m]. Throws Error naming `file` if the file names its unit.
void apply_unit(ImportedLayout& imported, double unit, const std::string& file);

/// Throws Error naming `file` and the unit that would help if the taxels are more than 1 m apart, are more than 10 m
/// from the origin or have a radius of more than 1 m, or if a normal has neither length 1 nor 0.
void check_lengths(const ImportedLayout& imported, const std::string& file);

/// Throws Error naming `file` and the unit that would help unless the skin is 1 mm to 1 m large and half of the taxels
/// are within a quarter of that size from its surface.
void check_near_skin(const ImportedLayout& imported, const MeshIndex& skin, const std::string& file);

}  // namespace taxel
