// Numbers, lengths and areas as messages write them.
#pragma once

#include <string>

#include "core/base/math.h"

namespace taxel {

/// The two numbers of a change or of a comparison, as texts.
struct NumberPair {
  std::string first, second;
};

/// Writes both numbers with as many decimals as the larger one needs for `digits` significant digits, and with more if
/// the two would look alike otherwise: their difference always shows two digits. Equal numbers give equal texts.
NumberPair number_pair(double first, double second, int digits);

std::string in_mm(double length);             ///< text of a length given in metres: "0.03 mm"
std::string in_mm2(double area);              ///< text of an area given in square metres: "2.63 mm\u00b2"
std::string place_in_mm(const dvec3& place);  ///< text of a point given in metres: "(1.5, 0, -20) mm"

}  // namespace taxel
