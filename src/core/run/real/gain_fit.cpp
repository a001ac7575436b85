#include "core/run/real/gain_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/run/real/align.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

/// Pairs of values of one taxel, and the index of the taxel in the run.
struct Pairs {
  std::size_t in_run = 0;
  std::vector<double> x, y;  // run, real
};

/// Fits y = gain x + offset by the normal equations. With an offset, gain = sum (x-mx)(y-my) / sum (x-mx)^2; without
/// it, gain = sum xy / sum x^2. Does nothing if x is constant.
struct Line {
  double gain = 0, offset = 0;
  bool there = false;
};
Line fit_line(const std::vector<const Pairs*>& all, bool with_offset) {
  double n = 0, mx = 0, my = 0;
  for (const Pairs* pairs : all)
    for (std::size_t i = 0; i < pairs->x.size(); ++i) mx += pairs->x[i], my += pairs->y[i], n += 1;
  if (n < 2) return {};
  mx = with_offset ? mx / n : 0, my = with_offset ? my / n : 0;
  double xx = 0, xy = 0, scale = 0;
  for (const Pairs* pairs : all) {
    for (std::size_t i = 0; i < pairs->x.size(); ++i) {
      xx += (pairs->x[i] - mx) * (pairs->x[i] - mx);
      xy += (pairs->x[i] - mx) * (pairs->y[i] - my);
      scale += pairs->x[i] * pairs->x[i];
    }
  }
  constexpr double kConstant = 1e-20;  // rounding error of a constant, as a fraction of its square
  if (!(xx > kConstant * scale)) return {};
  return {xy / xx, my - xy / xx * mx, true};
}

void judge(const Pairs& pairs, const Line& line, bool with_offset, TaxelFit& fit) {
  double mean = 0, residual = 0, squares = 0;
  for (const double y : pairs.y) mean += y / static_cast<double>(pairs.y.size());
  if (!with_offset) mean = 0;
  for (std::size_t i = 0; i < pairs.y.size(); ++i) {
    const double error = pairs.y[i] - (line.gain * pairs.x[i] + line.offset);
    residual += error * error;
    squares += (pairs.y[i] - mean) * (pairs.y[i] - mean);
    fit.largest_error = std::max(fit.largest_error, std::abs(error));
  }
  fit.gain = line.gain;
  fit.offset = line.offset;
  fit.residual = std::sqrt(residual / static_cast<double>(pairs.y.size()));
  fit.r2 = squares > 0 ? 1 - residual / squares : 0;
}

std::string why_not(const TaxelSeries& run, const Pairs& pairs, double largest) {
  if (range_of(run.values[pairs.in_run]) <= kTaxelResponds * largest) return "does not respond in the run";
  if (pairs.x.size() < 3) return "has no values in the recording while the run lasts";
  double largest_value = 0;
  for (const double y : pairs.y) largest_value = std::max(largest_value, std::abs(y));
  constexpr double kConstant = 1e-12;  // rounding error of a constant, as a fraction of its values
  if (range_of(pairs.y) <= kConstant * largest_value) return "is constant in the recording";
  return "";
}

/// Returns the pairs of the taxels that both series have.
std::vector<Pairs> pair_up(const TaxelSeries& run, const TaxelSeries& real, double shift) {
  std::vector<Pairs> all;
  for (std::size_t k = 0; k < run.taxel_ids.size(); ++k) {
    const int id = run.taxel_ids[k];
    if (std::find(real.taxel_ids.begin(), real.taxel_ids.end(), id) == real.taxel_ids.end()) continue;
    Pairs& pairs = all.emplace_back();
    pairs.in_run = k;
    const std::vector<double> values = on_run_times(run, real, id, shift);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i]) || std::isnan(run.values[k][i])) continue;
      pairs.x.push_back(run.values[k][i]);
      pairs.y.push_back(values[i]);
    }
  }
  return all;
}

}  // namespace

std::vector<double> on_run_times(const TaxelSeries& run, const TaxelSeries& real, int taxel, double shift) {
  const auto found = std::find(real.taxel_ids.begin(), real.taxel_ids.end(), taxel);
  if (found == real.taxel_ids.end())
    return std::vector<double>(run.time.size(), std::numeric_limits<double>::quiet_NaN());
  const Interpolated values(real, static_cast<std::size_t>(found - real.taxel_ids.begin()));
  std::vector<double> out;
  for (const double time : run.time) out.push_back(values.at(time - shift));
  return out;
}

std::vector<TaxelFit> fit_gains(const TaxelSeries& run, const TaxelSeries& real, double shift,
                                const FitOptions& options) {
  const std::vector<Pairs> all = pair_up(run, real, shift);
  double largest = 0;
  for (const Pairs& pairs : all) largest = std::max(largest, range_of(run.values[pairs.in_run]));
  std::vector<TaxelFit> fits;
  std::vector<const Pairs*> able;
  for (const Pairs& pairs : all) {
    TaxelFit& fit = fits.emplace_back();
    fit.taxel = run.taxel_ids[pairs.in_run];
    fit.points = pairs.x.size();
    fit.refused = why_not(run, pairs, largest);
    if (!fit.refused.empty()) continue;
    const Line own = fit_line({&pairs}, options.offset);
    judge(pairs, own, options.offset, fit);
    if (own.there && fit.r2 >= kFollows) {
      able.push_back(&pairs);
    } else {
      const double r2 = fit.r2;
      fit = {fit.taxel, fmt::format("does not follow the run: R^2 {:.3f}", r2), 0, 0, r2, 0, 0, fit.points};
    }
  }
  if (!options.common) return fits;
  const Line line = fit_line(able, options.offset);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].refused.empty()) continue;
    fits[i].largest_error = 0;
    judge(all[i], line, options.offset, fits[i]);
  }
  return fits;
}

std::string aligned_csv(const TaxelSeries& run, const TaxelSeries& real, double shift,
                        const std::vector<TaxelFit>& fits) {
  std::string text = "time";
  std::vector<std::vector<double>> values;
  for (const TaxelFit& fit : fits) {
    text += fmt::format(",taxel_{0},real_{0},fitted_{0}", fit.taxel);
    values.push_back(on_run_times(run, real, fit.taxel, shift));
  }
  text += '\n';
  auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    fmt::format_to(out, "{}", run.time[i]);
    for (std::size_t f = 0; f < fits.size(); ++f) {
      const auto k = static_cast<std::size_t>(std::find(run.taxel_ids.begin(), run.taxel_ids.end(), fits[f].taxel) -
                                              run.taxel_ids.begin());
      const double read = run.values[k][i];
      fmt::format_to(out, ",{},", read);
      if (!std::isnan(values[f][i])) fmt::format_to(out, "{}", values[f][i]);
      text += ',';
      if (fits[f].refused.empty()) fmt::format_to(out, "{}", fits[f].gain * read + fits[f].offset);
    }
    text += '\n';
  }
  return text;
}

}  // namespace taxel
