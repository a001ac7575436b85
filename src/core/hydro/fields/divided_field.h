// A field whose pressures are a function of those of another field, linear between some pressures: the tets of the
// other field, divided at these pressures.
#pragma once

#include <span>
#include <vector>

#include "core/hydro/fields/pressure_field.h"

namespace taxel {

/// A point of a function of pressures [Pa].
struct PressurePoint {
  double from = 0, to = 0;
};

struct DividedField {
  PressureFieldPtr field;
  std::vector<int> parents;  ///< for each tet, the tet of the other field that contains it
};

/// Returns the field with the pressures f(p) of `field`, f linear between `points`: two or more, ascending, the first
/// one (0, 0). Beyond the last one its slope continues. Each tet that contains one of the pressures is divided there,
/// so the new field is linear in each tet and continuous.
DividedField divide_field(const PressureField& field, std::span<const PressurePoint> points);

}  // namespace taxel
