#include "core/run/mcap/ros_names.h"

#include <algorithm>

#include "core/base/text/json_text.h"

namespace taxel {
namespace {

bool is_ascii_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
bool is_ascii_digit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

std::string RosNames::add(std::string_view name) {
  std::string base;
  for (const char c : name) {
    if (is_ascii_letter(c) || is_ascii_digit(c))
      base += c;
    else if (!base.empty() && base.back() != '_')
      base += '_';
  }
  while (base.ends_with('_')) base.pop_back();
  if (base.empty()) base = "geom";
  if (is_ascii_digit(base.front())) base = "geom_" + base;
  std::string chosen = base;
  for (int number = 2; !taken_.insert(chosen).second; ++number) chosen = base + "_" + std::to_string(number);
  return chosen;
}

std::string utf8_or_marks(std::string_view text) {
  std::string valid(text);
  if (is_utf8(text)) return valid;
  std::ranges::replace_if(
      valid, [](char c) { return (static_cast<unsigned char>(c) & 0x80U) != 0; }, '?');
  return valid;
}

}  // namespace taxel
