// The shift in time between a simulated run and a real recording, and gains between their readings.
//
// 1. Both are interpolated on an even grid with the finer interval of the two. Of the common taxels those count that
//    respond in both.
// 2. The correlation, Pearson's coefficient over the overlap, is the mean over the taxels; a taxel that cannot be
//    compared counts as 0, so that no shift wins by leaving taxels out. It does not depend on gains and offsets.
// 3. All shifts are tried on means of successive values, about 300 points of the shorter signal, then the shifts around
//    the best one on the fine grid, and a parabola through the best point and its neighbours gives the rest.
//
// Gains are least squares of the aligned pairs, with or without an offset. A taxel that is constant, or that does not
// follow the run, gets the reason instead of a gain. Cost: about ten million products per taxel. Pitfall: differences
// of large sums are rounding where a signal is constant; such signals are refused by a bound relative to their squares.
// Theory: docs/theory/run.md, "Real recordings".
#include "core/run/real/align.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text/table.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

/// Number of points of the shorter signal on the coarse grid, and largest number of points of the longer signal on the
/// fine grid.
constexpr double kCoarsePoints = 300, kFinePoints = 500000;

/// Values of the taxels on an even grid of times.
struct EvenSignals {
  double start = 0, interval = 0;           // [s]
  std::vector<std::vector<double>> values;  // values of each taxel; NaN if missing
  [[nodiscard]] std::size_t points() const { return values.front().size(); }
};

double duration(const TaxelSeries& series) {
  return series.time.empty() ? 0 : series.time.back() - series.time.front();
}

std::vector<int> common_ids(const TaxelSeries& a, const TaxelSeries& b) {
  std::vector<int> ids;
  for (const int id : a.taxel_ids)
    if (std::find(b.taxel_ids.begin(), b.taxel_ids.end(), id) != b.taxel_ids.end()) ids.push_back(id);
  return ids;
}

std::size_t index_of(const TaxelSeries& series, int id) {
  return static_cast<std::size_t>(std::find(series.taxel_ids.begin(), series.taxel_ids.end(), id) -
                                  series.taxel_ids.begin());
}

/// Returns the taxels of `ids` that respond in both signals, or, if there are none, those that respond in one of them.
std::vector<int> responding(const TaxelSeries& a, const TaxelSeries& b, const std::vector<int>& ids) {
  const auto respond = [&](const TaxelSeries& series) {
    std::vector<int> out;
    double largest = 0;
    for (const int id : ids) largest = std::max(largest, range_of(series.values[index_of(series, id)]));
    for (const int id : ids)
      if (range_of(series.values[index_of(series, id)]) > kTaxelResponds * largest) out.push_back(id);
    return out;
  };
  const std::vector<int> in_a = respond(a), in_b = respond(b);
  std::vector<int> both;
  for (const int id : in_a)
    if (std::find(in_b.begin(), in_b.end(), id) != in_b.end()) both.push_back(id);
  return both.empty() ? ids : both;
}

EvenSignals on_grid(const TaxelSeries& series, const std::vector<int>& ids, double interval) {
  EvenSignals grid{series.time.front(), interval, {}};
  const auto points = static_cast<std::size_t>(std::floor(duration(series) / interval * (1 + 1e-12))) + 1;
  for (const int id : ids) {
    const Interpolated taxel(series, index_of(series, id));
    std::vector<double>& values = grid.values.emplace_back(points);
    for (std::size_t i = 0; i < points; ++i) values[i] = taxel.at(grid.start + static_cast<double>(i) * interval);
  }
  return grid;
}

/// Returns the means of `times` successive values; a mean is missing if one of its values is.
EvenSignals coarser(const EvenSignals& fine, std::size_t times) {
  if (times <= 1) return fine;
  const auto width = static_cast<double>(times);
  EvenSignals coarse{fine.start + 0.5 * (width - 1) * fine.interval, width * fine.interval, {}};
  for (const std::vector<double>& values : fine.values) {
    std::vector<double>& means = coarse.values.emplace_back();
    for (std::size_t i = 0; i + times <= values.size(); i += times) {
      double sum = 0;
      for (std::size_t k = 0; k < times; ++k) sum += values[i + k];
      means.push_back(sum / width);
    }
  }
  return coarse;
}

struct Correlation {
  double value = 0;
  double points = 0;  // number of compared points
};

/// Returns Pearson's r = sum (x - mx)(y - my) / sqrt(sum (x - mx)^2 sum (y - my)^2) of x = run[i + lag] and y = real[i]
/// over the points at which both have values. Returns nothing if there are fewer than `least` points or one signal is
/// constant on them.
std::optional<Correlation> correlation_at(const std::vector<double>& run, const std::vector<double>& real,
                                          std::ptrdiff_t lag, double least) {
  const auto n = static_cast<std::ptrdiff_t>(run.size()), m = static_cast<std::ptrdiff_t>(real.size());
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -lag), last = std::min(m, n - lag);
  double sx = 0, sy = 0, xx = 0, yy = 0, xy = 0, count = 0;
  for (std::ptrdiff_t i = first; i < last; ++i) {
    const double x = run[static_cast<std::size_t>(i + lag)], y = real[static_cast<std::size_t>(i)];
    const bool has_both = !std::isnan(x) && !std::isnan(y);
    const double u = has_both ? x : 0, v = has_both ? y : 0;
    sx += u, sy += v, xx += u * u, yy += v * v, xy += u * v, count += has_both ? 1 : 0;
  }
  if (count < std::max(least, 3.0)) return std::nullopt;
  const double vx = xx - sx * sx / count, vy = yy - sy * sy / count;
  constexpr double kConstant = 1e-12;  // rounding error of a constant signal, as a fraction of its square
  if (vx <= kConstant * xx || vy <= kConstant * yy) return std::nullopt;
  return Correlation{(xy - sx * sy / count) / std::sqrt(vx * vy), count};
}

/// Returns the mean correlation over all taxels. A taxel that cannot be compared at this lag counts as 0.
std::optional<Correlation> correlation_at(const EvenSignals& run, const EvenSignals& real, std::ptrdiff_t lag,
                                          double least) {
  Correlation sum;
  bool any = false;
  const auto taxels = static_cast<double>(run.values.size());
  for (std::size_t k = 0; k < run.values.size(); ++k) {
    const std::optional<Correlation> one = correlation_at(run.values[k], real.values[k], lag, least);
    if (!one) continue;
    sum.value += one->value / taxels;
    sum.points = std::max(sum.points, one->points);
    any = true;
  }
  return any ? std::optional(sum) : std::nullopt;
}

struct BestLag {
  std::ptrdiff_t lag = 0;
  Correlation correlation;
};

std::optional<BestLag> best_lag(const EvenSignals& run, const EvenSignals& real, std::ptrdiff_t from,
                                std::ptrdiff_t to) {
  const double least = kLeastOverlap * static_cast<double>(std::min(run.points(), real.points()));
  std::optional<BestLag> best;
  for (std::ptrdiff_t lag = from; lag <= to; ++lag) {
    const std::optional<Correlation> now = correlation_at(run, real, lag, least);
    if (now && (!best || now->value > best->correlation.value)) best = BestLag{lag, *now};
  }
  return best;
}

/// Returns the position of the maximum of the parabola through three even points, from the middle point, in units of
/// their distance.
double parabola_peak(double before, double at, double after) {
  const double curvature = before - 2 * at + after;
  return curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0;
}

/// Returns the lag of the maximum between the points of the grid.
double refined(const EvenSignals& run, const EvenSignals& real, const BestLag& best) {
  const double least = 0.5 * best.correlation.points;
  const std::optional<Correlation> before = correlation_at(run, real, best.lag - 1, least),
                                   after = correlation_at(run, real, best.lag + 1, least);
  const auto lag = static_cast<double>(best.lag);
  return before && after ? lag + parabola_peak(before->value, best.correlation.value, after->value) : lag;
}

}  // namespace

std::optional<Alignment> align(const TaxelSeries& run, const TaxelSeries& real) {
  const std::vector<int> ids = responding(run, real, common_ids(run, real));
  const double longest = std::max(duration(run), duration(real)), shortest = std::min(duration(run), duration(real));
  const double interval =
      std::max(std::min(median_interval(run.time), median_interval(real.time)), longest / kFinePoints);
  if (ids.empty() || !(interval > 0)) return std::nullopt;
  const EvenSignals a = on_grid(run, ids, interval), b = on_grid(real, ids, interval);
  const auto times = std::max<std::size_t>(1, static_cast<std::size_t>(shortest / interval / kCoarsePoints));
  const EvenSignals coarse_a = coarser(a, times), coarse_b = coarser(b, times);
  const std::optional<BestLag> rough = best_lag(coarse_a, coarse_b, -static_cast<std::ptrdiff_t>(coarse_b.points()),
                                                static_cast<std::ptrdiff_t>(coarse_a.points()));
  if (!rough) return std::nullopt;
  const auto step = static_cast<std::ptrdiff_t>(times), around = times > 1 ? 2 * step : 0, middle = rough->lag * step;
  const std::optional<BestLag> best = best_lag(a, b, middle - around, middle + around);
  if (!best) return std::nullopt;
  // run[i + lag] corresponds to real[i], so the time of the first real value in the run is a.start + lag * interval.
  const double overlap = std::min((best->correlation.points - 1) * interval, shortest);
  return Alignment{a.start + refined(a, b, *best) * interval - b.start, best->correlation.value, overlap};
}

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
  bool is_fitted = false;
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
    if (own.is_fitted && fit.r2 >= kFollows) {
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

std::string fits_csv(const std::vector<TaxelFit>& fits, const ColumnMapping& mapping,
                     const std::string& unit_of_reading, double shift) {
  std::string text = "taxel,column,gain,gain_unit,offset,r2,rms,unit,shift_s,points,refused\n";
  const std::string unit = csv_field(mapping.unit),
                    gain_unit = csv_field((mapping.unit.empty() ? "1" : mapping.unit) + "/" + unit_of_reading);
  for (const TaxelFit& fit : fits) {
    const auto column = std::ranges::find(mapping.taxels, fit.taxel, &TaxelColumn::taxel);
    const bool is_fitted = fit.refused.empty();
    const auto number = [&](double value) { return is_fitted ? fmt::format("{}", value) : std::string(); };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", fit.taxel,
                        column == mapping.taxels.end() ? "" : csv_field(column->column), number(fit.gain), gain_unit,
                        number(fit.offset), number(fit.r2), number(fit.residual), unit, shift, fit.points,
                        csv_field(fit.refused));
  }
  return text;
}

Calibration with_gains(const std::optional<Calibration>& before, const std::vector<TaxelFit>& fits,
                       const std::string& unit) {
  Calibration calibration = before.value_or(Calibration{});
  if (!unit.empty()) calibration.unit = unit;
  std::vector<TaxelCalibration>& taxels = calibration.taxels;
  bool any = false;
  for (const TaxelFit& fit : fits) {
    if (!fit.refused.empty() || fit.gain == 0) continue;
    any = true;
    auto own = std::find_if(taxels.begin(), taxels.end(), [&](const TaxelCalibration& t) { return t.id == fit.taxel; });
    if (own == taxels.end()) own = taxels.insert(taxels.end(), TaxelCalibration{fit.taxel, {}, {}, {}, {}});
    own->gain = fit.gain;
    own->tare = fit.offset == 0 ? 0 : -fit.offset / fit.gain;
    own->curve.clear();
  }
  if (!any) throw Error("no taxel has a gain");
  return calibration;
}

}  // namespace taxel
