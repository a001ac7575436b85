#include "core/run/real/align.h"

#include <algorithm>
#include <cmath>

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
    const bool there = !std::isnan(x) && !std::isnan(y);
    const double u = there ? x : 0, v = there ? y : 0;
    sx += u, sy += v, xx += u * u, yy += v * v, xy += u * v, count += there ? 1 : 0;
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
  return Alignment{a.start + refined(a, b, *best) * interval - b.start, best->correlation.value,
                   best->correlation.points * interval};
}

}  // namespace taxel
