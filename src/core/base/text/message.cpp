// Messages cut to a length that is shown, and numbers in them.

#include "core/base/text/message.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/base/text/rounded.h"

namespace taxel {
namespace {

bool continues_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Returns the length of the UTF-8 character at `at`, or 0 if there is none.
std::size_t length_of_character(std::string_view text, std::size_t at) {
  for (std::size_t length = 1; length <= 4; ++length)
    if (is_utf8(text.substr(at, length))) return length;
  return 0;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n') || byte == 0x7F;
}

std::string without_bad_bytes(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = length_of_character(text, i);
    if (length == 0 || is_control(text[i]))
      shown += '?';
    else
      shown += text.substr(i, length);
    i += std::max(length, std::size_t{1});
  }
  return shown;
}

}  // namespace

std::string shown_part(std::string_view text, std::size_t most) {
  if (text.size() <= most) return without_bad_bytes(text);
  constexpr std::string_view kGap = " ... ";
  std::size_t head = (most - kGap.size()) * 2 / 3, tail = text.size() - (most - kGap.size() - head);
  while (head > 0 && continues_character(text[head])) --head;
  while (tail < text.size() && continues_character(text[tail])) ++tail;
  return without_bad_bytes(text.substr(0, head)) + std::string(kGap) + without_bad_bytes(text.substr(tail));
}

std::string shown_message(const std::exception& error) {
  const auto* const own = dynamic_cast<const Error*>(&error);
  if (own == nullptr) return shown_part(error.what(), kMostShownLine);
  return Error(own->file(), shown_part(own->where()), shown_part(own->message())).what();
}

namespace {

/// Returns the decimal place of the first significant digit: 0 for 1 to 9, -2 for 0.01 to 0.09.
int magnitude_of(double number) {
  return static_cast<int>(std::floor(std::log10(std::abs(number))));
}

}  // namespace

NumberPair number_pair(double first, double second, int digits) {
  constexpr int kDigitsOfChange = 2;
  constexpr int kMaxDigits = 15;  // digits of a double; further digits are noise
  constexpr int kTiny = -6;       // smaller magnitudes are written with an exponent
  const double largest = std::max(std::abs(first), std::abs(second)), change = std::abs(first - second);
  if (!std::isfinite(largest) || !std::isfinite(change)) return {fmt::format("{}", first), fmt::format("{}", second)};
  if (largest == 0) return {"0", "0"};
  const int magnitude = magnitude_of(largest);
  int significant = digits;
  if (change > 0) significant = std::max(significant, magnitude - magnitude_of(change) + kDigitsOfChange);
  significant = std::min(significant, kMaxDigits);
  if (magnitude < kTiny)
    return {fmt::format("{:.{}e}", first, significant - 1), fmt::format("{:.{}e}", second, significant - 1)};
  const int decimals = std::max(0, significant - 1 - magnitude);
  return {fmt::format("{:.{}f}", first, decimals), fmt::format("{:.{}f}", second, decimals)};
}

// Lengths are rounded to a nanometre and areas to a square micrometre: smaller ones are rounding errors.

std::string in_mm(double length) {
  return rounded(1e3 * length, 3, 6) + " mm";
}

std::string in_mm2(double area) {
  return rounded(1e6 * area, 3, 6) + " mm\u00b2";
}

std::string place_in_mm(const dvec3& place) {
  return fmt::format("({}, {}, {}) mm", rounded(1e3 * place.x, 5, 6), rounded(1e3 * place.y, 5, 6),
                     rounded(1e3 * place.z, 5, 6));
}

}  // namespace taxel
