// Numbers as people read them: millimetres, kilopascals, newtons.
#pragma once

#include <string>

#include "core/base/text/number_text.h"
#include "core/layout/layout.h"

namespace taxel::ui {

std::string in_mm(double metres, int digits = 2);        ///< "6.00 mm"
std::string in_mm(const dvec3& metres, int digits = 2);  ///< "1.00, 2.00, 3.00 mm"
std::string in_mm2(double square_metres);                ///< "94.2 mm\u00b2"; large areas in cm\u00b2
std::string duration_text(double seconds);               ///< "312 \u00b5s", "1.24 ms": of a step
std::string bytes_text(double bytes);                    ///< "12.3 kB", "4.56 MB"
std::string in_kpa(double pascals);                      ///< "12.34 kPa"; four significant digits at most
/// How readings are shown.
struct ReadingUnit {
  const char* text = "kPa";
  double scale = 1e-3;   ///< per SI unit
  bool pressure = true;  ///< shares the range of the contact surface's colours
};
ReadingUnit shown_unit(Aggregate aggregate);
/// "12.34 kPa". Small readings get three significant digits, down to a ten-millionth of the unit.
std::string in_unit(double reading, const ReadingUnit& unit);
/// Two readings that are compared, each with its unit, with enough digits to see that they differ: see number_pair().
NumberPair pair_in_unit(double first, double second, const ReadingUnit& unit);
std::string number_in_unit(double reading, const ReadingUnit& unit);  ///< "12.3": short, for bars
std::string grouped(long long count);                                 ///< "12 345"
/// value * 10^exponent as one would write it: 4.2 by -3 is the number that is nearest to 0.0042.
double shifted_decimal(double value, int exponent);
/// Parts of an upright axis of this length whose ends have room for numbers as high as a line: 4, 2 or 1.
int tick_count(float length, float line);
bool contains_word(const std::string& text, const std::string& word);  ///< in any case
/// The top of an axis from 0 for readings up to `largest`, both in SI.
double axis_top(double largest, const ReadingUnit& unit);
double nice_ceiling(double value);  ///< least of 1, 1.5, 2, 3, 4, 5, 6, 8 times 10^n that is >= value

}  // namespace taxel::ui
