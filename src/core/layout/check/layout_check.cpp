// Rules of a layout that need only its values: settings, taxels, keys and calibration.

#include "core/layout/check/layout_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/math.h"
#include "core/base/text/words.h"
#include "core/layout/field/overlap.h"
#include "core/layout/file/layout_keys.h"
#include "core/layout/layout.h"
#include "core/layout/layout_fields.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/layout/words.h"

namespace taxel {
namespace {

/// Collects problems of one file.
class Check {
 public:
  explicit Check(std::string file) : file_(std::move(file)) {}
  void error(const std::string& pointer, const char* code, const std::string& message, const std::string& fix = "") {
    problems.push_back({file_, pointer, Severity::error, code, message, fix});
  }
  void warning(const std::string& pointer, const char* code, const std::string& message, const std::string& fix = "") {
    problems.push_back({file_, pointer, Severity::warning, code, message, fix});
  }
  void note(const std::string& pointer, const char* code, const std::string& message) {
    problems.push_back({file_, pointer, Severity::note, code, message, ""});
  }
  bool positive(const std::string& pointer, double v, const char* code, const std::string& fix = "") {
    if (v > 0.0 && std::isfinite(v)) return true;
    error(pointer, code, fmt::format("must be {}, is {}", std::isfinite(v) ? "greater than 0" : "finite", v), fix);
    return false;
  }
  bool not_negative(const std::string& pointer, double v, const char* code) {
    if (v >= 0.0 && std::isfinite(v)) return true;
    error(pointer, code, fmt::format("must be {}, is {}", std::isfinite(v) ? "0 or more" : "finite", v));
    return false;
  }
  /// Checks a length, which is at most as large as the largest coordinate.
  bool length(const std::string& pointer, double v) {
    if (!(v > kFarthest)) return true;
    error(pointer, "too_far", fmt::format("must be at most {:g} m, is {}", kFarthest, v), "in metres: 6 mm is 0.006");
    return false;
  }
  bool finite(const std::string& pointer, const dvec3& v) {
    if (is_finite(v)) return true;
    error(pointer, "not_finite", fmt::format("must be finite, is [{}, {}, {}]", v.x, v.y, v.z));
    return false;
  }
  bool direction(const std::string& pointer, const dvec3& v) {
    if (!finite(pointer, v)) return false;
    const double length = glm::length(v);
    if (length > 0.0 && std::isfinite(length)) return true;
    error(pointer, "zero_normal", fmt::format("must be a direction, is [{}, {}, {}]", v.x, v.y, v.z));
    return false;
  }
  Problems problems;

 private:
  std::string file_;
};

/// Checks the rules of layout.calibration, which must be set.
void check_calibration(const Layout& layout, Check& check);

/// One calibration's place in its file, and the taxel whose own it is.
struct Place {
  std::string pointer, whose;
  Check& check;

  [[nodiscard]] std::string at(const std::string& key) const { return pointer + "/" + key; }
  void error(const std::string& key, const char* code, const std::string& message, const std::string& fix = "") const {
    check.error(at(key), code, message + whose, fix);
  }
  bool finite(const std::string& key, double v) const {
    if (!std::isfinite(v)) error(key, "not_finite", fmt::format("must be finite, is {}", v));
    return std::isfinite(v);
  }
  void positive(const std::string& key, double v, const char* code, const std::string& fix = "") const {
    if (finite(key, v) && !(v > 0.0)) error(key, code, fmt::format("must be greater than 0, is {}", v), fix);
  }
  void not_negative(const std::string& key, double v, const char* code) const {
    if (finite(key, v) && v < 0.0) error(key, code, fmt::format("must be 0 or more, is {}", v));
  }
  void fraction(const std::string& key, double v) const {
    if (!(v >= 0.0 && v <= 1.0)) error(key, "fraction_out_of_range", fmt::format("must be from 0 to 1, is {}", v));
  }
  void gain_or_curve(const std::optional<double>& gain, const Curve& curve) const;
};

void Place::gain_or_curve(const std::optional<double>& gain, const Curve& curve) const {
  if (gain && finite("gain", *gain) && *gain == 0.0)
    error("gain", "gain_zero", "must not be 0, is 0", "a taxel that reports nothing is \"dead\"");
  if (curve.empty()) return;
  if (gain) error("curve", "gain_and_curve", "is not allowed together with a gain", "keep one of the two");
  if (curve.size() < 2) error("curve", "curve_too_short", "must have 2 points or more, has 1");
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const bool good = finite(fmt::format("curve/{}/0", i), curve[i].reading);
    finite(fmt::format("curve/{}/1", i), curve[i].value);
    if (good && i > 0 && curve[i].reading <= curve[i - 1].reading)
      error(fmt::format("curve/{}/0", i), "curve_not_ascending",
            fmt::format("must be greater than {} before it, is {}", curve[i - 1].reading, curve[i].reading),
            "list the points by ascending reading");
  }
}

void check_range(const Calibration& calibration, const Place& place) {
  if (calibration.range) {
    const ValueRange& range = *calibration.range;
    const bool low = place.finite("range/0", range.low), high = place.finite("range/1", range.high);
    if (low && high && !(range.low < range.high))
      place.error("range", "range_empty", fmt::format("must ascend, is [{}, {}]", range.low, range.high));
  }
  if (!calibration.quantisation) return;
  const Quantisation& q = *calibration.quantisation;
  if (q.step.has_value() == q.bits.has_value())
    place.error("quantisation", "step_or_bits",
                fmt::format("must hold step or bits, holds {}", q.step ? "both" : "none"));
  if (q.step) place.positive("quantisation/step", *q.step, "step_not_positive");
  const int most = 32;
  if (q.bits && (*q.bits < 1 || *q.bits > most))
    place.error("quantisation/bits", "bits_out_of_range", fmt::format("must be from 1 to {}, is {}", most, *q.bits));
  if (q.bits && !calibration.range)
    place.error("quantisation/bits", "bits_without_range", "needs a range", "bits divide the range");
}

/// Returns the smallest slope of c_1 x + c_2 x^2 + c_3 x^3 + c_4 x^4 for 0 <= x <= `up_to`: at an end, or at a root of
/// its second derivative.
double smallest_slope(const std::vector<double>& polynomial, double up_to) {
  std::array<double, kMostPowers> c{};
  std::copy_n(polynomial.begin(), std::min(polynomial.size(), c.size()), c.begin());
  const auto slope = [&](double x) { return c[0] + x * (2 * c[1] + x * (3 * c[2] + x * 4 * c[3])); };
  double least = std::min(slope(0), slope(up_to));
  const auto consider = [&](double x) {
    if (x > 0 && x < up_to) least = std::min(least, slope(x));
  };
  const double root = std::sqrt(36 * c[2] * c[2] - 96 * c[1] * c[3]);  // of 2 c_2 + 6 c_3 x + 12 c_4 x^2
  consider(-c[1] / (3 * c[2]));                                        // without c_4
  consider((-6 * c[2] - root) / (24 * c[3]));
  consider((-6 * c[2] + root) / (24 * c[3]));
  return least;
}

void check_polynomial(const Response& response, const Place& place) {
  bool good = true;
  if (response.polynomial.size() > kMostPowers)
    place.error("response/polynomial", "polynomial_too_long",
                fmt::format("must have at most {} factors, has {}", kMostPowers, response.polynomial.size()),
                "points may have any shape that ascends");
  for (std::size_t i = 0; i < response.polynomial.size(); ++i)
    good = place.finite(fmt::format("response/polynomial/{}", i), response.polynomial[i]) && good;
  place.positive("response/up_to", response.up_to, "up_to_not_positive", "the largest reading, in its unit");
  if (!good || !(response.up_to > 0.0) || !std::isfinite(response.up_to)) return;
  const double slope = smallest_slope(response.polynomial, response.up_to);
  if (!(slope > 0.0))
    place.error("response/polynomial", "response_not_ascending",
                fmt::format("must ascend from 0 to {}, has a slope of {}", response.up_to, slope),
                "lower \"up_to\", or list points");
}

void check_response(const Response& response, const Place& place) {
  const Curve& points = response.points;
  if (response.polynomial.empty() == points.empty())
    place.error("response", "polynomial_or_points",
                fmt::format("must hold polynomial or points, holds {}", points.empty() ? "none" : "both"));
  if (!response.polynomial.empty()) check_polynomial(response, place);
  if (response.polynomial.empty() && response.up_to != 0.0)
    place.error("response/up_to", "up_to_without_polynomial", "is only for a polynomial", "leave it out");
  if (points.size() == 1) place.error("response/points", "curve_too_short", "must have 2 points or more, has 1");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = [&](int column) { return fmt::format("response/points/{}/{}", i, column); };
    const bool good = place.finite(at(0), points[i].reading), good_value = place.finite(at(1), points[i].value);
    if (good && i > 0 && points[i].reading <= points[i - 1].reading)
      place.error(at(0), "curve_not_ascending",
                  fmt::format("must be greater than {} before it, is {}", points[i - 1].reading, points[i].reading),
                  "list the points by ascending reading");
    if (good_value && i > 0 && points[i].value < points[i - 1].value)
      place.error(at(1), "response_not_ascending",
                  fmt::format("must be {} or more, as before it, is {}", points[i - 1].value, points[i].value),
                  "a larger reading has a larger response");
  }
}

void check_relaxation(const std::vector<RelaxationArm>& arms, const Place& place) {
  double sum = 0;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    place.fraction(fmt::format("relaxation/{}/amplitude", i), arms[i].amplitude);
    place.positive(fmt::format("relaxation/{}/time", i), arms[i].time, "time_not_positive", "in seconds");
    sum += arms[i].amplitude;
  }
  const double rounding = 1e-12;  // of a sum of decimal fractions that is 1
  if (sum > 1.0 + rounding)
    place.error("relaxation", "relaxation_too_large", fmt::format("must have amplitudes of sum 1 or less, has {}", sum),
                "an amplitude is the fraction that is lost");
}

void check_hysteresis(const Hysteresis& hysteresis, const Place& place) {
  place.not_negative("hysteresis/width", hysteresis.width, "width_negative");
  place.fraction("hysteresis/fraction", hysteresis.fraction);
  double sum = hysteresis.fraction;
  for (std::size_t i = 0; i < hysteresis.plays.size(); ++i) {
    place.not_negative(fmt::format("hysteresis/plays/{}/width", i), hysteresis.plays[i].width, "width_negative");
    place.fraction(fmt::format("hysteresis/plays/{}/fraction", i), hysteresis.plays[i].fraction);
    sum += hysteresis.plays[i].fraction;
  }
  const double rounding = 1e-12;  // of a sum of decimal fractions that is 1
  if (!hysteresis.plays.empty() && sum > 1.0 + rounding)
    place.error("hysteresis", "hysteresis_too_large", fmt::format("must have fractions of sum 1 or less, has {}", sum),
                "lower \"fraction\", which is 1 if it is missing");
}

void check_low_pass(const LowPass& filter, const Place& place) {
  if (filter.time.has_value() == filter.cutoff.has_value())
    place.error("low_pass", "time_or_cutoff",
                fmt::format("must hold time or cutoff, holds {}", filter.time ? "both" : "none"));
  if (filter.time) place.positive("low_pass/time", *filter.time, "time_not_positive", "in seconds");
  if (filter.cutoff) place.positive("low_pass/cutoff", *filter.cutoff, "cutoff_not_positive", "in hertz");
}

void check_crosstalk_matrix(const CrosstalkMatrix& matrix, std::size_t taxels, const Place& place) {
  const std::string fix = "one row and one column for each taxel, in the layout's order";
  if (matrix.size() != taxels)
    place.error("crosstalk_matrix", "matrix_size", fmt::format("must have {} rows, has {}", taxels, matrix.size()),
                fix);
  for (std::size_t k = 0; k < matrix.size(); ++k) {
    if (matrix[k].size() != taxels)
      place.error(fmt::format("crosstalk_matrix/{}", k), "matrix_size",
                  fmt::format("must have {} numbers, has {}", taxels, matrix[k].size()), fix);
    for (std::size_t j = 0; j < matrix[k].size(); ++j)
      place.finite(fmt::format("crosstalk_matrix/{}/{}", k, j), matrix[k][j]);
  }
}

void check_taxels(const Layout& layout, Check& check) {
  std::set<int> ids;
  for (const Taxel& taxel : layout.taxels) ids.insert(taxel.id);
  std::map<int, std::size_t> first_with;
  const std::vector<TaxelCalibration>& taxels = layout.calibration->taxels;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const TaxelCalibration& taxel = taxels[i];
    const Place place{fmt::format("/calibration/taxels/{}", i), fmt::format(" (taxel {})", taxel.id), check};
    const auto [found, fresh] = first_with.emplace(taxel.id, i);
    if (!fresh)
      check.error(place.at("id"), "duplicate_id",
                  fmt::format("{} is also the id of /calibration/taxels/{}", taxel.id, found->second),
                  "give each taxel one calibration");
    else if (taxel.id < 0)
      check.error(place.at("id"), "id_negative", fmt::format("must be 0 or more, is {}", taxel.id));
    else if (!ids.contains(taxel.id))
      check.warning(place.at("id"), "calibration_unused", fmt::format("no taxel has the id {}", taxel.id),
                    "name one of the layout's taxels");
    if (taxel.tare) place.finite("tare", *taxel.tare);
    place.gain_or_curve(taxel.gain, taxel.curve);
    if (taxel.dead) place.finite("dead", *taxel.dead);
  }
}

void check_calibration(const Layout& layout, Check& check) {
  const Calibration& calibration = layout.calibration.value();
  const Place place{"/calibration", "", check};
  if (calibration.response) check_response(*calibration.response, place);
  check_relaxation(calibration.relaxation, place);
  if (calibration.hysteresis) check_hysteresis(*calibration.hysteresis, place);
  if (calibration.low_pass) check_low_pass(*calibration.low_pass, place);
  if (!calibration.crosstalk_matrix.empty())
    check_crosstalk_matrix(calibration.crosstalk_matrix, layout.taxels.size(), place);
  if (calibration.crosstalk && !calibration.crosstalk_matrix.empty())
    place.error("crosstalk_matrix", "crosstalk_twice", "is not allowed together with crosstalk", "keep one of the two");
  if (calibration.crosstalk) {
    place.fraction("crosstalk/fraction", calibration.crosstalk->fraction);
    place.positive("crosstalk/reach", calibration.crosstalk->reach, "reach_not_positive", "in metres: 6 mm is 0.006");
  }
  if (calibration.tare) place.finite("tare", calibration.tare->value);
  place.not_negative("tare_deviation", calibration.tare_deviation, "deviation_negative");
  place.gain_or_curve(calibration.gain, calibration.curve);
  place.not_negative("gain_deviation", calibration.gain_deviation, "deviation_negative");
  place.not_negative("noise", calibration.noise, "deviation_negative");
  check_range(calibration, place);
  if (calibration.rate) place.positive("rate", *calibration.rate, "rate_not_positive", "in values per second");
  place.not_negative("latency", calibration.latency, "latency_negative");
  if (calibration.dead) {
    place.fraction("dead/fraction", calibration.dead->fraction);
    place.finite("dead/value", calibration.dead->value);
  }
  check_taxels(layout, check);
}

/// Checks the numbers of the settings S by the ranges of their rows.
template <LayoutSettings S>
void check_ranges(const S& settings, const std::string& pointer, Check& check) {
  const auto check_number = [&](const LayoutField& field, double value) {
    const std::string place = fmt::format("{}/{}", pointer, field.spec.key);
    bool is_good = true;
    if (field.spec.range == FieldRange::positive) is_good = check.positive(place, value, field.code, field.fix);
    if (field.spec.range == FieldRange::not_negative) is_good = check.not_negative(place, value, field.code);
    if (is_good && field.spec.quantity == FieldQuantity::length) check.length(place, value);
  };
  for_each_field<S>([&](const LayoutField& field, auto member) {
    using T = std::remove_cvref_t<decltype(settings.*member)>;
    if constexpr (std::is_same_v<T, double>) check_number(field, settings.*member);
    if constexpr (std::is_same_v<T, std::optional<double>>)
      if (settings.*member) check_number(field, *(settings.*member));
  });
}

void check_receptive_field(const ReceptiveFieldRule& rule, Check& check) {
  const double angle = rule.max_angle_deg, falloff = rule.angle_falloff_deg;
  const bool valid = angle > 0.0 && angle <= 180.0;
  if (!valid)
    check.error("/receptive_field/max_angle_deg", "angle_out_of_range",
                fmt::format("must be greater than 0 and at most 180 degrees, is {}", angle), "the paper uses 45");
  if (!(falloff >= 0.0 && falloff <= (valid ? angle : 180.0)))
    check.error("/receptive_field/angle_falloff_deg", "falloff_out_of_range",
                valid ? fmt::format("must be 0 or more and at most max_angle_deg, {} degrees, is {}", angle, falloff)
                      : fmt::format("must be 0 or more and at most max_angle_deg, is {}", falloff),
                "0 cuts the field at max_angle_deg, as the paper does");
}

void check_readout(const Readout& readout, Check& check) {
  check_ranges(readout, "/readout", check);
  const bool along_taxel = readout.ray == RayDirection::taxel_normal;
  if (readout.method == ReadingMethod::exact && !has_exact_method(readout.aggregate))
    check.error("/readout/method", "method_not_available",
                fmt::format("\"exact\" is not available for the aggregate \"{}\"", to_word(readout.aggregate)),
                "use \"weighted_mean\", \"mean\" or \"force\", or the method \"samples\"");
  else if (readout.method == ReadingMethod::exact && readout.aggregate != Aggregate::force && along_taxel)
    check.error("/readout/method", "method_needs_surface_rays",
                "\"exact\" needs rays along the surface normal, /readout/ray is \"taxel_normal\"",
                "set /readout/ray to \"surface_normal\", or use the method \"samples\"");
  if (readout.aggregate == Aggregate::force && along_taxel)
    check.warning("/readout/ray", "ray_unused",
                  "does not count for the aggregate \"force\", which reaches the skin along its own normals");
}

void check_settings(const Layout& layout, Check& check) {
  if (layout.mesh.file.empty()) check.error("/mesh/file", "mesh_file_empty", "must name a mesh file, is \"\"");
  for (int axis = 0; axis < 3; ++axis) {
    const double s = layout.mesh.scale[axis];
    if (s == 0.0 || !std::isfinite(s))
      check.error(fmt::format("/mesh/scale/{}", axis), "scale_zero", fmt::format("must be finite and not 0, is {}", s),
                  "1 for a mesh in metres, 0.001 for millimetres");
  }
  check_ranges(layout.mesh.repair, "/mesh/repair", check);
  const bool distal = check.direction("/frame/distal", layout.frame.distal);
  const bool pad = check.direction("/frame/pad", layout.frame.pad);
  if (distal && pad) {
    const double angle = angle_deg(layout.frame.distal, layout.frame.pad);
    const double parallel = 1.0, skew = 5.0;  // degrees
    if (angle < parallel || angle > 180.0 - parallel)
      check.error("/frame/pad", "frame_parallel", "must not be parallel to distal");
    else if (std::abs(angle - 90.0) > skew)
      check.warning("/frame/pad", "frame_skew",
                    fmt::format("should be at right angles to distal, is at {:.1f} degrees", angle));
  }
  check_ranges(layout.sampling, "/sampling", check);
  const std::vector<int>& region = *layout.sampling.region;
  if (std::adjacent_find(region.begin(), region.end(), std::greater_equal<>()) != region.end() ||
      (!region.empty() && region.front() < 0))
    check.error("/sampling/region", "region_not_ascending", "must be faces of the mesh, 0 or more and ascending");

  check_receptive_field(layout.receptive_field, check);
  check_readout(layout.readout, check);
}

void check_material(const Material& material, Check& check) {
  check_ranges(material, "/material", check);
  if (std::isfinite(material.modulus) && material.modulus > kMaxModulus)
    check.error("/material/modulus", "modulus_too_large",
                fmt::format("must be at most {:g} Pa, is {}", kMaxModulus, material.modulus),
                "in pascals: silicone has 1e5 to 1e6");
  std::string place;
  if (const std::string problem = law_problem(material.law, &place); !problem.empty())
    check.error("/material/law" + place, "law_invalid", problem, "use the law \"linear\"");
  const bool sticks = std::isfinite(material.tangential_stiffness) && material.tangential_stiffness > 0;
  if (sticks && material.modulus == 0)
    check.error("/material/tangential_stiffness", "stiffness_of_rigid",
                "needs a soft body, because bristles are on its skin, but the modulus is 0",
                "give a modulus above 0, or a tangential stiffness of 0");
  if (material.bristles < 1 || material.bristles > kMostBristles)
    check.error("/material/bristles", "bristles_out_of_range",
                fmt::format("must be a whole number from 1 to {}, is {}", kMostBristles, material.bristles));
  if (material.field != FieldKind::pad && material.field != FieldKind::star)
    check.error("/material/field", "not_available",
                fmt::format("\"{}\" is not available for a layout's mesh", to_word(material.field)),
                "use \"pad\" or \"star\"");
}

/// Values that taxels and subtaxels have in common. Returns whether the disc can be placed on a mesh.
template <class T>
bool check_disc(const std::string& pointer, const T& disc, Check& check) {
  const dvec3& c = disc.center;
  bool center = check.finite(pointer + "/center", c);
  if (center && std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) > kFarthest) {
    check.error(
        pointer + "/center", "too_far",
        fmt::format("must be within {:g} m of the mesh's origin, is [{:g}, {:g}, {:g}]", kFarthest, c.x, c.y, c.z),
        "in metres: 6 mm is 0.006");
    center = false;
  }
  const bool normal = check.direction(pointer + "/normal", disc.normal);
  const bool radius =
      check.positive(pointer + "/radius", disc.radius, "radius_not_positive", "in metres: 6 mm is 0.006") &&
      check.length(pointer + "/radius", disc.radius);
  return center && normal && radius;
}

void check_taxel(const Taxel& taxel, std::size_t index, Check& check) {
  const std::string pointer = fmt::format("/taxels/{}", index);
  if (taxel.id < 0) check.error(pointer + "/id", "id_negative", fmt::format("must be 0 or more, is {}", taxel.id));
  const bool valid = check_disc(pointer, taxel, check);
  for (std::size_t i = 0; i < taxel.subtaxels.size(); ++i) {
    const std::string sub = fmt::format("{}/subtaxels/{}", pointer, i);
    if (!check_disc(sub, taxel.subtaxels[i], check) || !valid) continue;
    const double radius = taxel.subtaxels[i].radius, away = glm::distance(taxel.subtaxels[i].center, taxel.center);
    if (radius > taxel.radius)
      check.warning(sub + "/radius", "subtaxel_larger",
                    fmt::format("should be at most the taxel's radius {}, is {}", taxel.radius, radius));
    if (away > taxel.radius)
      check.warning(
          sub + "/center", "subtaxel_outside",
          fmt::format("should lie within the taxel's radius {} of its centre, is {:.3g} m away", taxel.radius, away),
          "move it, or make it a taxel of its own");
  }
}

/// Lists the keys that no reader consumes: they are kept in the file and have no effect. A key that is probably
/// misspelt is a warning, because the value that it was meant for has its default.
void check_unknown_keys(const Layout& layout, Check& check) {
  constexpr std::size_t kMaxListed = 50;
  std::size_t listed = 0;
  for (const auto& [pointer, value] : layout.unknown) {
    if (listed++ == kMaxListed) break;
    const std::size_t key = pointer.rfind('/');
    const std::string_view meant =
        nearest_word(std::string_view(pointer).substr(key + 1), known_layout_keys(pointer.substr(0, key)));
    if (meant.empty())
      check.note(pointer, "unknown_key", "is an unknown key: it is kept and has no effect");
    else
      check.warning(pointer, "unknown_key", "is an unknown key: it is kept and has no effect",
                    fmt::format("did you mean \"{}\"?", meant));
  }
  if (layout.unknown.size() > kMaxListed)
    check.warning("", "unknown_key", fmt::format("has {} more unknown keys", layout.unknown.size() - kMaxListed));
}

/// Checks the densities of taxels. Those of the layout and of all fields together must not give too many samples.
void check_densities(const Layout& layout, Check& check) {
  const double usual = layout.sampling.density;
  double samples = 0;
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) {
    const Taxel& taxel = layout.taxels[i];
    const std::string pointer = fmt::format("/taxels/{}/density", i);
    if (!check.not_negative(pointer, taxel.density, "density_negative") || taxel.density == 0) continue;
    if (taxel.density <= usual) {
      check.warning(pointer, "density_unused",
                    fmt::format("has no effect: must be above /sampling/density, {}, is {}", usual, taxel.density),
                    "leave it out, or raise it");
      continue;
    }
    const bool has_field = taxel.radius > 0 && std::isfinite(taxel.radius);
    const double area = has_field ? std::numbers::pi * taxel.radius * taxel.radius : 0;
    samples += taxel.density * area;
    if (!(samples <= kMaxSamples)) {
      check.error(pointer, "density_too_high",
                  fmt::format("{} per square metre gives {:.4g} samples in the fields up to this one, the limit is {}",
                              taxel.density, samples, kMaxSamples),
                  fmt::format("at most {:.3g}", kMaxSamples / area));
      return;
    }
  }
}

void check_ids(const std::vector<Taxel>& taxels, Check& check) {
  std::map<int, std::size_t> first_with;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    const auto [found, fresh] = first_with.emplace(taxels[i].id, i);
    if (!fresh)
      check.error(fmt::format("/taxels/{}/id", i), "duplicate_id",
                  fmt::format("{} is also the id of /taxels/{}", taxels[i].id, found->second),
                  "give every taxel its own id");
  }
}

/// Two centres nearer than a millionth of the radius: the same place written twice. Sorted by x, so that only
/// neighbours in x are compared.
void check_places(const std::vector<Taxel>& taxels, Check& check) {
  const double same = 1e-6;
  std::vector<std::size_t> order(taxels.size());
  std::iota(order.begin(), order.end(), 0U);
  std::erase_if(order, [&](std::size_t i) { return !is_finite(taxels[i].center) || !(taxels[i].radius > 0.0); });
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(taxels[a].center.x, a) < std::pair(taxels[b].center.x, b);
  });
  const std::size_t none = taxels.size();
  std::vector<std::size_t> twin_of(taxels.size(), none);  // a taxel with a lower number at the same place
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Taxel& a = taxels[order[i]];
    const std::size_t twin = twin_of[order[i]];
    // A taxel at exactly the place of its twin, and not larger, has no other neighbours than the twin: many taxels in
    // one place cost one pass.
    if (twin != none && taxels[twin].center == a.center && taxels[twin].radius >= a.radius) continue;
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const Taxel& b = taxels[order[j]];
      if (b.center.x - a.center.x > same * a.radius) break;
      if (glm::distance(a.center, b.center) > same * a.radius) continue;
      std::size_t& earlier = twin_of[std::max(order[i], order[j])];
      if (earlier == none) earlier = std::min(order[i], order[j]);
    }
  }
  for (std::size_t i = 0; i < twin_of.size(); ++i)
    if (twin_of[i] != none)
      check.warning(fmt::format("/taxels/{}/center", i), "duplicate_place",
                    fmt::format("is the same place as /taxels/{}", twin_of[i]), "move or delete one of the two");
}

/// One warning for all: an array may be dense on purpose.
void check_overlaps(const std::vector<Taxel>& taxels, Check& check) {
  const std::vector<OverlappingTaxels> pairs = overlapping_taxels(taxels);
  if (pairs.empty()) return;
  const OverlappingTaxels& first = pairs.front();
  const std::string others =
      pairs.size() > 1 ? fmt::format("; so do {} more with an earlier one", pairs.size() - 1) : "";
  check.warning(fmt::format("/taxels/{}/center", first.taxel), "large_overlap",
                fmt::format("shares {:.0f} % of the larger disc with /taxels/{}: both read nearly the same{}",
                            100 * first.part, first.earlier, others),
                "move them apart, make them smaller, or delete one of the two");
}

}  // namespace

std::optional<std::size_t> taxel_of_pointer(std::string_view pointer) {
  const std::string_view start = "/taxels/";
  std::size_t index = 0;
  if (!pointer.starts_with(start)) return std::nullopt;
  const auto read = std::from_chars(pointer.data() + start.size(), pointer.data() + pointer.size(), index);
  return read.ec == std::errc() ? std::optional(index) : std::nullopt;
}

void name_taxels(const Layout& layout, Problems& problems) {
  for (Problem& p : problems) {
    const std::optional<std::size_t> index = taxel_of_pointer(p.pointer);
    if (!index || p.pointer.ends_with("/id")) continue;  // an id names itself
    if (*index < layout.taxels.size()) p.message += fmt::format(" (taxel {})", layout.taxels[*index].id);
  }
}

Problems check_layout_values(const Layout& layout, const std::string& file) {
  Check check(file);
  check_settings(layout, check);
  check_material(layout.material, check);
  if (layout.taxels.empty()) check.warning("/taxels", "no_taxels", "holds no taxel: nothing is read");
  for (std::size_t i = 0; i < layout.taxels.size(); ++i) check_taxel(layout.taxels[i], i, check);
  check_densities(layout, check);
  check_ids(layout.taxels, check);
  check_places(layout.taxels, check);
  check_overlaps(layout.taxels, check);
  if (layout.calibration) check_calibration(layout, check);
  check_unknown_keys(layout, check);
  name_taxels(layout, check.problems);
  return std::move(check.problems);
}

void throw_first_error(const Problems& problems) {
  for (const Problem& p : problems)
    if (p.severity == Severity::error) throw Error(p.file, p.pointer, p.message);
}

}  // namespace taxel
