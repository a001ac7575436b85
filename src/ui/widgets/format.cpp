#include "ui/widgets/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/base/text/rounded.h"
#include "core/layout/words.h"

namespace taxel::ui {

std::string with_decimals(double number, int decimals) {
  const std::string text = fmt::format("{:.{}f}", number, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string in_mm(double metres, int digits) {
  return with_decimals(1e3 * metres, digits) + " mm";
}

std::string in_mm(const dvec3& p, int digits) {
  return fmt::format("{}, {}, {} mm", with_decimals(1e3 * p.x, digits), with_decimals(1e3 * p.y, digits),
                     with_decimals(1e3 * p.z, digits));
}

std::string in_mm2(double square_metres) {
  constexpr double kLarge = 0.01;  // [m^2]
  if (square_metres >= kLarge) return fmt::format("{:.4g} cm\u00b2", 1e4 * square_metres);
  return fmt::format("{:.{}f} mm\u00b2", 1e6 * square_metres, square_metres < 1e-4 ? 2 : 0);
}

std::string duration_text(double seconds) {
  constexpr double kMillisecond = 1e-3;  // [s]
  if (seconds < 0.9995 * kMillisecond) return fmt::format("{:.0f} \u00b5s", 1e6 * seconds);
  return fmt::format("{:.2f} ms", 1e3 * seconds);
}

std::string bytes_text(double bytes) {
  if (bytes < 1e3) return fmt::format("{:.0f} bytes", bytes);
  const bool giga = bytes >= 1e9, mega = bytes >= 1e6;
  return fmt::format("{:.3g} {}", bytes * (giga ? 1e-9 : mega ? 1e-6 : 1e-3), giga ? "GB" : mega ? "MB" : "kB");
}

std::string in_kpa(double pascals) {
  return in_unit(pascals, ReadingUnit{});
}

ReadingUnit shown_unit(Aggregate aggregate) {
  const std::string_view unit = reading_unit(aggregate);
  if (unit == "N") return {"N", 1.0, false};
  if (unit == "Pa m^2") return {"kPa mm\u00b2", 1e3, false};
  return {};
}

namespace {

/// Pressures below this many kilopascals are shown in pascals.
constexpr double kFewKilopascals = 0.1;

/// Returns whether a reading is shown in pascals: a small pressure, which does not round to 0 Pa.
bool is_in_pascals(double reading, const ReadingUnit& unit) {
  const double shown = std::abs(unit.scale * reading);
  return unit.pressure && shown < kFewKilopascals && std::abs(reading) >= 0.005;
}

/// Returns the number of decimals that a unit has a use for: 0.1 mN, or a tenth of a percent.
int decimals_of(const ReadingUnit& unit) {
  return std::string_view(unit.text) == kSlipUnit.text ? 1 : 4;
}

}  // namespace

std::string in_unit(double reading, const ReadingUnit& unit) {
  constexpr int kDigits = 3, kDecimalsOfPascals = 2;
  if (is_in_pascals(reading, unit)) return rounded(reading, kDigits, kDecimalsOfPascals) + " Pa";
  const double shown = unit.scale * reading;
  const int most = decimals_of(unit), least = std::min(most, unit.pressure ? 2 : 3);
  int decimals = least;
  if (std::abs(shown) >= 0.5 * std::pow(10.0, -most))
    decimals = std::clamp(kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(shown)))), least, most);
  return fmt::format("{} {}", with_decimals(shown, decimals), unit.text);
}

std::string change_in_unit(double change, const ReadingUnit& unit) {
  constexpr int kDigits = 3, kDecimalsOfPascals = 2;
  if (is_in_pascals(change, unit)) return rounded_change(change, kDigits, kDecimalsOfPascals) + " Pa";
  return fmt::format("{} {}", rounded_change(unit.scale * change, kDigits, decimals_of(unit)), unit.text);
}

std::string in_newtons(double newtons) {
  return rounded(newtons, 4, 4) + " N";
}

NumberPair pair_in_unit(double first, double second, const ReadingUnit& unit) {
  constexpr int kDigits = 3;
  constexpr double kNothing = 1e-6;  // in the displayed unit: smaller readings are rounding errors
  if (std::max(std::abs(first), std::abs(second)) * unit.scale < kNothing)
    return {fmt::format("0 {}", unit.text), fmt::format("0 {}", unit.text)};
  const NumberPair numbers = number_pair(unit.scale * first, unit.scale * second, kDigits);
  return {fmt::format("{} {}", numbers.first, unit.text), fmt::format("{} {}", numbers.second, unit.text)};
}

std::string number_in_unit(double reading, const ReadingUnit& unit) {
  const double shown = unit.scale * reading;
  return with_decimals(shown, std::abs(shown) < 9.995 ? 2 : std::abs(shown) < 99.95 ? 1 : 0);
}

std::string grouped(long long count) {
  std::string digits = std::to_string(count);
  for (auto i = static_cast<int>(digits.size()) - 3; i > (digits.front() == '-' ? 1 : 0); i -= 3) {
    digits.insert(static_cast<std::size_t>(i), 1, ' ');
  }
  return digits;
}

std::string counted(std::size_t count, const char* one, const char* more) {
  return fmt::format("{} {}", grouped(static_cast<long long>(count)), count == 1 ? one : more);
}

double shifted_decimal(double value, int exponent) {
  std::array<char, 64> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific);
  const std::string_view digits(text.data(), static_cast<std::size_t>(written.ptr - text.data()));
  const std::size_t e = digits.find('e');
  if (e == std::string_view::npos) return value;  // the value is not finite
  const std::string shifted =
      fmt::format("{}e{}", digits.substr(0, e), std::stoi(std::string(digits.substr(e + 1))) + exponent);
  double result = 0;
  std::from_chars(shifted.data(), shifted.data() + shifted.size(), result);
  return result;
}

bool contains_word(const std::string& text, const std::string& word) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

double axis_top(double largest, const ReadingUnit& unit) {
  return largest > 0 ? nice_ceiling(largest) : 1.0 / unit.scale;
}

double nice_ceiling(double value) {
  if (!(value > 0)) return 0;
  constexpr std::array kSteps{1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0};
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : kSteps) {
    if (step * decade >= value) return step * decade;
  }
  return 10.0 * decade;
}

int tick_count(float length, float line) {
  constexpr float kRoom = 1.15f;  // room for each number, in heights of a line
  for (const int ticks : {4, 2})
    if (length >= static_cast<float>(ticks) * kRoom * line) return ticks;
  return 1;
}

}  // namespace taxel::ui
