// Formats numbers for display: millimetres, kilopascals, newtons.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/text/message.h"
#include "core/layout/layout.h"

namespace taxel::ui {

/// Returns a number with as many decimals, without a sign if all its digits are 0.
std::string with_decimals(double number, int decimals);
std::string in_mm(double metres, int digits = 2);        ///< "6.00 mm"
std::string in_mm(const dvec3& metres, int digits = 2);  ///< "1.00, 2.00, 3.00 mm"
std::string in_mm2(double square_metres);                ///< "94.2 mm\u00b2"; large areas in cm\u00b2
std::string duration_text(double seconds);               ///< "312 \u00b5s" or "1.24 ms", for the time of a step
std::string bytes_text(double bytes);                    ///< "12.3 kB", "4.56 MB"
std::string in_kpa(double pascals);                      ///< "12.34 kPa", as in_unit()
std::string in_newtons(double newtons);                  ///< "1.234 N"; "0 N" below 0.05 mN
/// Unit in which readings are displayed.
struct ReadingUnit {
  const char* text = "kPa";
  double scale = 1e-3;   ///< displayed units per SI unit
  bool pressure = true;  ///< true for a pressure, which shares the colour range of the contact surface
};
/// The unit of the share of a field that slips.
inline constexpr ReadingUnit kSlipUnit{"%", 100, false};
/// Returns the unit of the readings of an aggregate.
ReadingUnit shown_unit(Aggregate aggregate);
/// Returns a reading with its unit, such as "12.34 kPa". Pressures below 0.1 kPa are in pascals, such as "45.2 Pa", and
/// other small readings have three significant digits down to 0.0001 of the unit. There is no exponent and no "-0".
std::string in_unit(double reading, const ReadingUnit& unit);
/// Returns a change of a reading as in_unit(), with its sign: "+0.12 kPa", "-45 Pa", or "0 kPa" for none.
std::string change_in_unit(double change, const ReadingUnit& unit);
/// Returns two readings with their units, with enough digits to show their difference: see number_pair().
NumberPair pair_in_unit(double first, double second, const ReadingUnit& unit);
std::string number_in_unit(double reading, const ReadingUnit& unit);  ///< "12.3": short, for bars
std::string grouped(long long count);                                 ///< "12 345"
/// Returns a number of things: "1 sample", "12 345 samples".
std::string counted(std::size_t count, const char* one, const char* more);
/// Returns the double nearest to the decimal number value * 10^exponent: 0.0042 for 4.2 and -3.
double shifted_decimal(double value, int exponent);
/// Returns the number of parts of a vertical axis of this length: 4, 2 or 1. The numbers at the ends of the parts, with
/// the height of a line, do not overlap.
int tick_count(float length, float line);
bool contains_word(const std::string& text, const std::string& word);  ///< ignores upper and lower case
/// Returns the upper end of an axis from 0 for readings up to `largest`, both in SI.
double axis_top(double largest, const ReadingUnit& unit);
double nice_ceiling(double value);  ///< smallest of 1, 1.5, 2, 3, 4, 5, 6, 8 times 10^n that is >= value

}  // namespace taxel::ui
