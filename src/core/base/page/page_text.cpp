#include "core/base/page/page_text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/base/page/page.h"

namespace taxel {
namespace {

/// Widths of the characters from space to tilde, in thousandths of the size: Adobe's font metrics of Helvetica.
constexpr std::array<int, 95> kHelveticaWidths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,  //
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,  //
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,  //
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,  //
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr int kDigitWidth = 556;

/// Returns the number of bytes that follow the first byte of a character, or -1 if no character begins with the byte.
int following_bytes(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  return first >= 0xF0 && first < 0xF5 ? 3 : -1;
}

}  // namespace

std::u32string code_points(const std::string& text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int following = following_bytes(first);
    char32_t point = following <= 0 ? first : first & (0x3Fu >> following);
    bool valid = following >= 0 && i + static_cast<std::size_t>(following) < text.size();
    for (int k = 1; valid && k <= following; ++k) {
      const auto next = static_cast<unsigned char>(text[i + static_cast<std::size_t>(k)]);
      valid = (next & 0xC0u) == 0x80u;
      point = (point << 6u) | (next & 0x3Fu);
    }
    if (valid) i += static_cast<std::size_t>(following);
    const bool control = point < 0x20 || (point >= 0x7F && point < 0xA0);
    const bool surrogate = (point >= 0xD800 && point < 0xE000) || point == 0xFFFE || point == 0xFFFF;
    points.push_back(!valid || surrogate ? U'?' : control ? U' ' : point);
  }
  return points;
}

std::string page_number(double value) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string joined_lengths(const std::vector<double>& lengths) {
  std::string text;
  for (const double length : lengths) {
    if (!text.empty()) text += ' ';
    text += page_number(length);
  }
  return text;
}

double helvetica_width(const std::string& text) {
  int width = 0;
  for (const char32_t point : code_points(text))
    width += point >= U' ' && point <= U'~' ? kHelveticaWidths[static_cast<std::size_t>(point - U' ')] : kDigitWidth;
  return 1e-3 * width;
}

}  // namespace taxel
