// Quality of a pressure field, in sentences for the user.
#pragma once

#include <string>

#include "core/base/error.h"
#include "core/hydro/fields/pressure_field.h"

namespace taxel {

/// For `file` and JSON pointer `pointer`, in this order:
///   note    field_report             tets, stiffness and how much it varies over the skin; of a pad also layers,
///                                    error, refined faces, tents, presses, and skin served by depth pieces
///   warning field_inverted           tets turned inside out: folds, where the pressure is counted twice
///   warning field_zero_gradient      tets without a pressure that pushes
///   warning field_thicker_than_body  a pad that no place of the body has room for
///   note    field_thickness_limited  where the body is too thin for the pad, or too bent
///   note    field_bare               faces without tets, where depth pieces serve contact
///   warning field_uneven             a pad whose stiffness varies by more than 6 %
///   note    field_note               anything else that the maker of the field said
Problems field_problems(const FieldReport& report, const std::string& file, const std::string& pointer);

}  // namespace taxel
