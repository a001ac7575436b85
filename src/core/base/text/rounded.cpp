#include "core/base/text/rounded.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taxel {

std::string rounded(double number, int digits, int decimals) {
  if (!std::isfinite(number)) return fmt::format("{}", number);
  const int magnitude = number == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(number))));
  std::string text = fmt::format("{:.{}f}", number, std::clamp(digits - 1 - magnitude, 0, std::max(0, decimals)));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string rounded_change(double change, int digits, int decimals) {
  const std::string text = rounded(change, digits, decimals);
  return change > 0 && text != "0" ? "+" + text : text;
}

}  // namespace taxel
