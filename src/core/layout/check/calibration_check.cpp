#include <map>
#include <set>

#include "core/layout/check/value_check.h"

namespace taxel {
namespace {

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

}  // namespace

void check_calibration(const Layout& layout, Check& check) {
  const Calibration& calibration = layout.calibration.value();
  const Place place{"/calibration", "", check};
  if (calibration.hysteresis) {
    place.not_negative("hysteresis/width", calibration.hysteresis->width, "width_negative");
    place.fraction("hysteresis/fraction", calibration.hysteresis->fraction);
  }
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
  if (calibration.dead) {
    place.fraction("dead/fraction", calibration.dead->fraction);
    place.finite("dead/value", calibration.dead->value);
  }
  check_taxels(layout, check);
}

}  // namespace taxel
