// Messages as they are shown, and the numbers, lengths and areas in them. A message may quote a file, so it may be
// long, and its bytes need not be text.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <string_view>

#include "core/base/math.h"

namespace taxel {

/// Largest length of a place or of a sentence that is shown, and of a line with the file, the place and the sentence.
inline constexpr std::size_t kMostShown = 300, kMostShownLine = 900;

/// Returns a text as a part of a message: bytes that are no UTF-8 and control characters but line breaks as "?", and of
/// a text of more than `most` bytes the beginning and the end.
std::string shown_part(std::string_view text, std::size_t most = kMostShown);

/// Returns what() of an exception for a message. Place and sentence of an Error are shown parts, its file is whole.
std::string shown_message(const std::exception& error);

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
