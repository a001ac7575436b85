#include "core/sensor/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "core/base/error.h"

namespace taxel {
namespace {

/// Each part draws from its own streams, so that the numbers of a part do not depend on the other parts.
enum class Part : std::uint64_t { noise = 1, gain, tare, dead };

CounterRng stream_of(const Calibration& settings, Part part, int id) {
  return CounterRng(settings.seed, (static_cast<std::uint64_t>(part) << 32U) | static_cast<std::uint32_t>(id));
}

/// Returns value n of a normal distribution of mean 0 and variance 1: the sum of 12 uniform numbers, less 6 (Irwin,
/// Hall 1927; the variance is 12/12 and the largest value 6). The numbers are summed as integers of 53 bits, without a
/// library's logarithm or cosine, so that the bits are the same on every machine.
double normal(const CounterRng& rng, std::uint64_t n) {
  constexpr std::uint64_t kTerms = 12;
  std::int64_t sum = -static_cast<std::int64_t>(kTerms / 2) * (std::int64_t{1} << 53);
  for (std::uint64_t i = 0; i < kTerms; ++i) sum += static_cast<std::int64_t>(rng.bits(kTerms * n + i) >> 11U);
  return static_cast<double>(sum) * 0x1.0p-53;
}

/// Returns v_i + (x - u_i) (v_i+1 - v_i) / (u_i+1 - u_i) on the segment of x. The outer segments continue beyond the
/// ends.
double piecewise_linear(const Curve& curve, double x) {
  const auto inner = std::upper_bound(curve.begin() + 1, curve.end() - 1, x,
                                      [](double reading, const CurvePoint& p) { return reading < p.reading; });
  const CurvePoint &a = *(inner - 1), &b = *inner;
  return a.value + (x - a.reading) * (b.value - a.value) / (b.reading - a.reading);
}

}  // namespace

Calibrator::Calibrator(const Layout& layout) : settings_(layout.calibration.value()) {
  std::map<int, const TaxelCalibration*> own;
  for (const TaxelCalibration& taxel : settings_.taxels) own.emplace(taxel.id, &taxel);
  const TaxelCalibration nothing;
  for (const Taxel& taxel : layout.taxels) {
    const auto found = own.find(taxel.id);
    const TaxelCalibration& mine = found == own.end() ? nothing : *found->second;
    Channel channel;
    channel.noise = stream_of(settings_, Part::noise, taxel.id);
    // tare_k = tare + s n(id), s the deviation between taxels
    const Tare tare = settings_.tare.value_or(Tare{});
    const double offset = settings_.tare_deviation * normal(stream_of(settings_, Part::tare, taxel.id), 0);
    channel.tare = mine.tare.value_or((tare.first_reading ? 0.0 : tare.value) + offset);
    channel.tare_first_reading = tare.first_reading && !mine.tare;
    // gain_k = gain (1 + s n(id)), s the relative deviation between taxels
    const double spread = 1.0 + settings_.gain_deviation * normal(stream_of(settings_, Part::gain, taxel.id), 0);
    const bool own_gain = mine.gain || !mine.curve.empty();
    channel.curve = own_gain ? mine.curve : settings_.curve;
    channel.gain = own_gain ? mine.gain.value_or(1.0) : settings_.gain.value_or(1.0) * spread;
    channel.dead = mine.dead;
    if (!channel.dead && settings_.dead &&
        stream_of(settings_, Part::dead, taxel.id).uniform(0) < settings_.dead->fraction)
      channel.dead = settings_.dead->value;
    channels_.push_back(std::move(channel));
  }
  if (settings_.crosstalk) make_leaks(layout);
  reset();
}

void Calibrator::make_leaks(const Layout& layout) {
  const std::vector<Taxel>& taxels = layout.taxels;
  std::vector<std::size_t> by_id(taxels.size());
  std::iota(by_id.begin(), by_id.end(), 0U);
  std::sort(by_id.begin(), by_id.end(), [&](std::size_t a, std::size_t b) { return taxels[a].id < taxels[b].id; });
  for (std::size_t k = 0; k < taxels.size(); ++k)
    for (const std::size_t j : by_id) {
      const double distance = glm::distance(taxels[j].center, taxels[k].center);
      // a_kj = a (1 - |c_j - c_k| / reach), 0 from the reach on
      const double fraction = settings_.crosstalk->fraction * (1.0 - distance / settings_.crosstalk->reach);
      if (j != k && fraction > 0.0) channels_[k].leaks.push_back({j, fraction});
    }
}

void Calibrator::reset() {
  for (Channel& channel : channels_) channel.loop = channel.first = 0.0;
  values_.assign(channels_.size(), 0.0);
  started_ = false;
  time_ = 0;
  number_ = readings_ = 0;
}

/// Computes `felt_` by hysteresis, then crosstalk.
void Calibrator::skin(std::span<const double> readings) {
  pressed_.assign(readings.begin(), readings.end());
  if (settings_.hysteresis) {
    const double r = 0.5 * settings_.hysteresis->width;
    for (std::size_t k = 0; k < channels_.size(); ++k) {
      double& loop = channels_[k].loop;
      // The play operator is w = max(x - r, min(x + r, w)), from w = 0 (Visintin 1994, Differential Models of
      // Hysteresis). It acts on a fraction f of the reading: x' = x + f (w - x).
      loop = std::max(pressed_[k] - r, std::min(pressed_[k] + r, loop));
      pressed_[k] += settings_.hysteresis->fraction * (loop - pressed_[k]);
    }
  }
  felt_ = pressed_;
  // x''_k = x'_k + sum_j a_kj x'_j, by ascending id, so that the order of the taxels does not change the bits
  for (std::size_t k = 0; k < channels_.size(); ++k)
    for (const Leak& leak : channels_[k].leaks) felt_[k] += leak.fraction * pressed_[leak.from];
}

/// Returns true if a new value is reported at `time`, and sets its number.
bool Calibrator::tick(double time) {
  if (!settings_.rate) {
    number_ = readings_++;
    return true;
  }
  // Ticks are at k / rate. Times are sums of steps, so a tick may be reached a millionth of a period early.
  const double early = 1e-6;
  const double k = std::floor(time * *settings_.rate + early);
  const auto number = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(k, -0x1p53, 0x1p53)));
  const bool due = !started_ || number != number_;
  number_ = number;
  return due;
}

/// Returns the nearest level low + q min(round((v - low) / q), top), with the low end of the range or 0 without a
/// range, and the highest level `top` inside the range (uniform mid-tread quantiser, Widrow and Kollar 2008). Halfway
/// values are rounded away from `low`.
double Calibrator::quantised(double value) const {
  if (!settings_.quantisation) return value;
  const double infinity = std::numeric_limits<double>::infinity();
  const ValueRange range = settings_.range.value_or(ValueRange{0.0, infinity});
  double q = 0, top = 0;
  if (settings_.quantisation->bits) {
    top = std::ldexp(1.0, *settings_.quantisation->bits) - 1.0;
    q = (range.high - range.low) / top;
  } else {
    const double rounding = 1e-12;  // rounding error of a range that is a multiple of the step
    q = *settings_.quantisation->step;
    top = std::floor((range.high - range.low) / q * (1.0 + rounding));
  }
  const double level = std::round((value - range.low) / q);
  if (!(std::abs(level) < 0x1p52)) return value;  // levels closer than numbers are
  return std::min(range.low + q * std::min(level, top), range.high);
}

double Calibrator::report(const Channel& channel, double reading) const {
  const double x = reading - channel.tare - (channel.tare_first_reading ? channel.first : 0.0);
  double v = channel.gain * (channel.curve.empty() ? x : piecewise_linear(channel.curve, x));
  if (settings_.noise > 0.0) v += settings_.noise * normal(channel.noise, number_);  // v + s n(id, number)
  if (settings_.range) v = std::clamp(v, settings_.range->low, settings_.range->high);
  return quantised(v);
}

const std::vector<double>& Calibrator::advance(double time, std::span<const double> readings) {
  if (readings.size() != channels_.size())
    throw Error("calibration", fmt::format("{} readings for {} taxels", readings.size(), channels_.size()));
  if (!std::isfinite(time) || (started_ && time < time_))
    throw Error("calibration", fmt::format("a reading at {} s after one at {} s", time, time_));
  skin(readings);
  if (!started_)
    for (std::size_t k = 0; k < channels_.size(); ++k) channels_[k].first = felt_[k];
  if (tick(time))  // sample and hold: otherwise all values stay
    for (std::size_t k = 0; k < channels_.size(); ++k) {
      const Channel& channel = channels_[k];
      values_[k] = channel.dead ? *channel.dead : report(channel, felt_[k]);
    }
  started_ = true;
  time_ = time;
  return values_;
}

}  // namespace taxel
