#include "core/base/pressure_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace taxel {
namespace {

LawPoint point_before(const std::vector<LawPoint>& table, std::size_t i) {
  return i > 0 ? table[i - 1] : LawPoint{};
}
double slope_of(const std::vector<LawPoint>& table, std::size_t i) {
  const LawPoint a = point_before(table, i), b = table[i];
  return (b.pressure - a.pressure) / (b.strain - a.strain);
}
/// Returns the index of the point at the end of the piece that holds a value of a coordinate, or the last index.
std::size_t piece_end(const std::vector<LawPoint>& table, double LawPoint::*coordinate, double value) {
  const auto after = std::upper_bound(table.begin(), table.end(), value,
                                      [&](double v, const LawPoint& point) { return v < point.*coordinate; });
  return after == table.end() ? table.size() - 1 : static_cast<std::size_t>(after - table.begin());
}

/// Returns the integral of e/(1 - k e) from 0 to e <= 1. For a small k e the closed form cancels, so its series is
/// summed: e^2 sum (k e)^n/(n + 2).
double stiffening_energy(double k, double e) {
  const double x = k * e;
  if (x > 0.1) return (-std::log1p(-x) - x) / (k * k);
  double sum = 0, power = 1;
  for (int n = 0; n < 20; ++n, power *= x) sum += power / (n + 2);
  return e * e * sum;
}

/// Returns strains that divide a stiffening law into pieces of even relative error: their density is the square root of
/// p''/p, whose integral is that of 1/((1 - k e) sqrt(e)), 2 atanh(sqrt(k e))/sqrt(k).
std::vector<double> even_strains(double k, int pieces) {
  const double root = std::sqrt(k), all = std::atanh(root);
  std::vector<double> strains;
  for (int i = 1; i < pieces; ++i) {
    const double t = std::tanh(all * i / pieces) / root;
    strains.push_back(t * t);
  }
  return strains;
}

/// Returns the inner points of a table or, if there are more than `most`, those that divide it into pieces of even
/// relative error: the bends of a table are lumps of p'', and the density is as above.
std::vector<double> bends_of(const std::vector<LawPoint>& table, std::size_t most) {
  const std::size_t inner = table.size() - 1;
  std::vector<double> strains, sum{0};
  for (std::size_t i = 0; i < inner; ++i) {
    const double reach = 0.5 * (table[i + 1].strain - point_before(table, i).strain);
    sum.push_back(sum.back() +
                  std::sqrt(std::abs(slope_of(table, i + 1) - slope_of(table, i)) * reach / table[i].pressure));
  }
  constexpr double kStraight = 1e-4;  // a sum below this is of rounding errors
  if (inner > most && sum.back() < kStraight) return {};
  const double step = sum.back() / static_cast<double>(most + 1);
  double next = step;
  for (std::size_t i = 0; i < inner; ++i) {
    const double middle = 0.5 * (sum[i] + sum[i + 1]);
    if (inner > most && middle < next) continue;
    strains.push_back(table[i].strain);
    next = step * (std::floor(middle / step) + 1);
  }
  return strains;
}

}  // namespace

bool PressureLaw::is_linear() const {
  return kind == LawKind::linear || (kind == LawKind::stiffening && k == 0);
}

double PressureLaw::pressure(double strain) const {
  if (!(strain > 0)) return 0;
  if (is_linear()) return strain;
  if (kind == LawKind::table) {
    const std::size_t i = piece_end(table, &LawPoint::strain, strain);
    return point_before(table, i).pressure + slope_of(table, i) * (strain - point_before(table, i).strain);
  }
  const double inside = std::min(strain, 1.0), left = 1 - k * inside;
  return inside / left + (strain - inside) / (left * left);
}

double PressureLaw::strain(double pressure) const {
  if (!(pressure > 0)) return 0;
  if (is_linear()) return pressure;
  if (kind == LawKind::table) {
    const std::size_t i = piece_end(table, &LawPoint::pressure, pressure);
    return point_before(table, i).strain + (pressure - point_before(table, i).pressure) / slope_of(table, i);
  }
  const double full = 1 / (1 - k), inside = std::min(pressure, full);
  return inside / (1 + k * inside) + (pressure - inside) / (full * full);
}

double PressureLaw::gradient(double strain) const {
  if (is_linear()) return 1;
  if (kind == LawKind::table) return slope_of(table, piece_end(table, &LawPoint::strain, std::max(0.0, strain)));
  const double left = 1 - k * std::clamp(strain, 0.0, 1.0);
  return 1 / (left * left);
}

double PressureLaw::energy(double strain) const {
  if (!(strain > 0)) return 0;
  if (is_linear()) return 0.5 * strain * strain;
  if (kind == LawKind::table) {
    const std::size_t end = piece_end(table, &LawPoint::strain, strain);
    double sum = 0;
    for (std::size_t i = 0; i <= end; ++i) {
      const LawPoint a = point_before(table, i);
      const double to = i == end ? strain : table[i].strain;
      sum += 0.5 * (to - a.strain) * (a.pressure + pressure(to));
    }
    return sum;
  }
  const double inside = std::min(strain, 1.0);
  return stiffening_energy(k, inside) + 0.5 * (strain - inside) * (pressure(inside) + pressure(strain));
}

PressureLaw::Slopes PressureLaw::slopes() const {
  if (kind != LawKind::table) return {1, gradient(1)};
  Slopes slopes{slope_of(table, 0), slope_of(table, 0)};
  for (std::size_t i = 1; i < table.size(); ++i) {
    slopes.least = std::min(slopes.least, slope_of(table, i));
    slopes.most = std::max(slopes.most, slope_of(table, i));
  }
  return slopes;
}

std::vector<double> numbers_of(const PressureLaw& law) {
  std::vector<double> numbers{static_cast<double>(law.kind), law.k};
  for (const LawPoint& point : law.table) numbers.insert(numbers.end(), {point.strain, point.pressure});
  return numbers;
}

PressureLaw law_of(const std::vector<double>& numbers) {
  PressureLaw law;
  const double kinds = static_cast<double>(LawKind::table);
  if (numbers.size() < 2 || numbers.size() % 2 != 0 || !(numbers[0] >= 0 && numbers[0] <= kinds))
    throw Error("is none that is known");
  law.kind = static_cast<LawKind>(static_cast<int>(numbers[0]));
  law.k = numbers[1];
  for (std::size_t i = 2; i < numbers.size(); i += 2) law.table.push_back({numbers[i], numbers[i + 1]});
  if (const std::string problem = law_problem(law); !problem.empty()) throw Error("pressure law: " + problem);
  return law;
}

std::string to_text(const PressureLaw& law) {
  if (law.is_linear()) return "p = E e";
  if (law.kind == LawKind::stiffening) return fmt::format("p = E e/(1 - {:g} e)", law.k);
  return fmt::format("a table of {} points, p = {:g} E at full strain", law.table.size(), law.pressure(1));
}

std::string law_problem(const PressureLaw& law, std::string* place) {
  const auto at = [&](const std::string& pointer, std::string message) {
    if (place != nullptr) *place = pointer;
    return message;
  };
  if (law.kind == LawKind::stiffening && !(law.k >= 0 && law.k < 1))
    return at("/stiffening",
              fmt::format("must be at least 0 and less than 1, because the pressure E e/(1 - k e) is infinite at "
                          "the strain 1/k, is {}",
                          law.k));
  if (law.kind != LawKind::table) return "";
  if (law.table.size() < 2)
    return at("/table",
              fmt::format("must have 2 rows or more, has {}: a line is the law \"linear\"", law.table.size()));
  LawPoint before;
  for (std::size_t i = 0; i < law.table.size(); ++i) {
    const LawPoint& p = law.table[i];
    const std::string row = fmt::format("/table/{}", i);
    if (!std::isfinite(p.strain) || !std::isfinite(p.pressure)) return at(row, "must be finite");
    if (!(p.strain > before.strain))
      return at(row + "/0",
                fmt::format("must be greater than {}, the strain of the row before, is {}", before.strain, p.strain));
    if (!(p.pressure > before.pressure))
      return at(row + "/1", fmt::format("must be greater than {}, the pressure of the row before, is {}: a pressure "
                                        "that falls has no stable contact",
                                        before.pressure, p.pressure));
    before = p;
  }
  return "";
}

std::vector<double> law_levels(const PressureLaw& law, int most) {
  if (law.is_linear() || most < 1) return {};
  return law.kind == LawKind::stiffening ? even_strains(law.k, most + 1)
                                         : bends_of(law.table, static_cast<std::size_t>(most));
}

}  // namespace taxel
