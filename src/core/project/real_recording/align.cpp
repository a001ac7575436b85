#include "core/project/real_recording/align.h"

#include <algorithm>
#include <cmath>

namespace taxel {
namespace {

/// Points of the longer signal on the coarse grid, and at most on the fine one.
constexpr double kCoarsePoints = 2000, kFinePoints = 500000;

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

/// Those of `ids` that respond in both; where none does, those that respond in either.
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

/// Means of as many values as fit into the wider interval.
EvenSignal coarser(const EvenSignal& fine, int times) {
  if (times <= 1) return fine;
  EvenSignal coarse{fine.start + 0.5 * (times - 1) * fine.interval, times * fine.interval, {}};
  const auto n = static_cast<std::size_t>(times);
  for (std::size_t i = 0; i + n <= fine.values.size(); i += n) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += fine.values[i + k];
    coarse.values.push_back(sum / times);  // missing where one of them is
  }
  return coarse;
}

struct Correlation {
  double value = 0;
  std::size_t points = 0;
};

/// Pearson's r = sum (x - mx)(y - my) / sqrt(sum (x - mx)^2 sum (y - my)^2) of run[i + lag] and real[i] over the points
/// where both are there; none: too few, or one is constant there.
std::optional<Correlation> correlation_at(const EvenSignal& run, const EvenSignal& real, std::ptrdiff_t lag,
                                          std::size_t least) {
  const auto n = static_cast<std::ptrdiff_t>(run.values.size()), m = static_cast<std::ptrdiff_t>(real.values.size());
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -lag), last = std::min(m, n - lag);
  double sx = 0, sy = 0, xx = 0, yy = 0, xy = 0, count = 0;
  for (std::ptrdiff_t i = first; i < last; ++i) {
    const double x = run.values[static_cast<std::size_t>(i + lag)], y = real.values[static_cast<std::size_t>(i)];
    const bool there = !std::isnan(x) && !std::isnan(y);
    const double u = there ? x : 0, v = there ? y : 0;
    sx += u, sy += v, xx += u * u, yy += v * v, xy += u * v, count += there ? 1 : 0;
  }
  if (count < static_cast<double>(std::max<std::size_t>(least, 3))) return std::nullopt;
  const double vx = xx - sx * sx / count, vy = yy - sy * sy / count;
  constexpr double kConstant = 1e-12;  // of its own square: what is left by rounding
  if (vx <= kConstant * xx || vy <= kConstant * yy) return std::nullopt;
  return Correlation{(xy - sx * sy / count) / std::sqrt(vx * vy), static_cast<std::size_t>(count)};
}

std::size_t value_count(const EvenSignal& signal) {
  return static_cast<std::size_t>(
      std::count_if(signal.values.begin(), signal.values.end(), [](double v) { return !std::isnan(v); }));
}

struct BestLag {
  std::ptrdiff_t lag = 0;
  Correlation correlation;
};

std::optional<BestLag> best_lag(const EvenSignal& run, const EvenSignal& real, std::ptrdiff_t from, std::ptrdiff_t to) {
  const auto least = static_cast<std::size_t>(kLeastOverlap * static_cast<double>(std::min(value_count(run), value_count(real))));
  std::optional<BestLag> best;
  for (std::ptrdiff_t lag = from; lag <= to; ++lag) {
    const std::optional<Correlation> now = correlation_at(run, real, lag, least);
    if (now && (!best || now->value > best->correlation.value)) best = BestLag{lag, *now};
  }
  return best;
}

/// Where the parabola through three even points is highest, in their distance from the middle one.
double parabola_peak(double before, double at, double after) {
  const double curvature = before - 2 * at + after;
  return curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0;
}

/// Between the points of the grid.
double refined(const EvenSignal& run, const EvenSignal& real, const BestLag& best) {
  const std::size_t least = best.correlation.points / 2;
  const std::optional<Correlation> before = correlation_at(run, real, best.lag - 1, least),
                                   after = correlation_at(run, real, best.lag + 1, least);
  const auto lag = static_cast<double>(best.lag);
  return before && after ? lag + parabola_peak(before->value, best.correlation.value, after->value) : lag;
}

}  // namespace

EvenSignal summed_signal(const TaxelSeries& series, const std::vector<int>& ids, double interval) {
  EvenSignal sum{series.time.empty() ? 0 : series.time.front(), interval, {}};
  sum.values.assign(static_cast<std::size_t>(std::floor(duration(series) / interval * (1 + 1e-12))) + 1, 0.0);
  for (const int id : ids) {
    const std::size_t k = index_of(series, id);
    const double range = range_of(series.values[k]);
    if (range <= 0) continue;
    const Interpolated taxel(series, k);
    for (std::size_t i = 0; i < sum.values.size(); ++i)
      sum.values[i] += taxel.at(sum.start + static_cast<double>(i) * interval) / range;
  }
  return sum;
}

std::optional<Alignment> align(const TaxelSeries& run, const TaxelSeries& real) {
  const double longest = std::max(duration(run), duration(real));
  const std::vector<int> ids = responding(run, real, common_ids(run, real));
  const double interval =
      std::max(std::min(median_interval(run.time), median_interval(real.time)), longest / kFinePoints);
  if (ids.empty() || !(interval > 0)) return std::nullopt;
  const EvenSignal a = summed_signal(run, ids, interval), b = summed_signal(real, ids, interval);
  const int times = std::max(1, static_cast<int>(longest / interval / kCoarsePoints));
  const EvenSignal coarse_a = coarser(a, times), coarse_b = coarser(b, times);
  const std::optional<BestLag> rough =
      best_lag(coarse_a, coarse_b, -static_cast<std::ptrdiff_t>(coarse_b.values.size()),
               static_cast<std::ptrdiff_t>(coarse_a.values.size()));
  if (!rough) return std::nullopt;
  const std::ptrdiff_t around = times > 1 ? 2 * times : 0, middle = rough->lag * times;
  const std::optional<BestLag> best = best_lag(a, b, middle - around, middle + around);
  if (!best) return std::nullopt;
  // run[i + lag] lies over real[i]: a.start + lag * interval is the time of real's first value on the run's clock
  return Alignment{a.start + refined(a, b, *best) * interval - b.start, best->correlation.value,
                   static_cast<double>(best->correlation.points) * interval};
}

}  // namespace taxel
