#include "core/run/fit/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace taxel {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameDepth = 0.05;  // of the travel, by which presses of one bell may differ

/// Sums of the values of a taxel or of a recording, and of their errors.
struct ErrorSums {
  double count = 0, sum = 0, squares = 0, errors = 0, worst = 0;
  void add(double measured, double fitted) {
    const double error = measured - fitted;
    ++count, sum += measured, squares += measured * measured, errors += error * error;
    worst = std::max(worst, std::abs(error));
  }
  [[nodiscard]] double r2() const {
    const double about_mean = squares - sum * sum / count;
    return about_mean > 0 ? 1 - errors / about_mean : kNothing;
  }
  [[nodiscard]] double rms() const { return std::sqrt(errors / count); }
};

/// The values of a taxel at the ends of presses of about the same depth, by place.
struct Bell {
  std::vector<double> places, measured, fitted;
};

Bell bell_of(const PressedRecording& recording, const RunAgreement& run, std::size_t taxel, int axis) {
  struct Top {
    double place, depth, measured, fitted;
  };
  std::vector<Top> tops(recording.presses.size(), {0, -1, 0, 0});
  const double rest = recording.displacements.front()[axis];
  double deepest = 0;
  for (const FitPoint& point : run.points) {
    if (point.taxel != taxel) continue;
    const dvec3& at = recording.displacements[point.row];
    const double depth = std::abs(at[axis] - rest);
    if (depth > tops[point.press].depth)
      tops[point.press] = {at[recording.lateral_axis], depth, point.measured, point.fitted};
    deepest = std::max(deepest, depth);
  }
  std::erase_if(tops, [&](const Top& top) { return top.depth < (1 - kSameDepth) * deepest; });
  std::sort(tops.begin(), tops.end(), [](const Top& a, const Top& b) { return a.place < b.place; });
  Bell bell;
  for (const Top& top : tops) {
    bell.places.push_back(top.place);
    bell.measured.push_back(top.measured);
    bell.fitted.push_back(top.fitted);
  }
  return bell;
}

std::string named(const FittedParameter& parameter) {
  return std::string(to_word(parameter.name));
}

/// Returns which measurement would tell two parameters apart.
std::string advice_for(FitName a, FitName b) {
  const auto is = [&](FitName one) { return a == one || b == one; };
  if (is(FitName::radius) && is(FitName::object_radius))
    return "a narrow object and a narrow field look alike: press with an object of another radius as well, or measure "
           "the object and fix it by --fix object.radius=...";
  if (is(FitName::thickness) && is(FitName::k))
    return "a thinner layer and a stiffer law look alike: measure the thickness and fix it by --fix thickness=..., or "
           "press deeper";
  if (is(FitName::thickness) || is(FitName::k))
    return "press deeper, up to half of the thickness, or fix one of both by --fix";
  if (is(FitName::z0)) return "record the approach, so that the first touch is seen, or press to several depths";
  if (is(FitName::x0) || is(FitName::y0)) return "press at more places, on both sides of a taxel";
  return "measure one of both and fix it by --fix";
}

}  // namespace

double half_width(const std::vector<double>& places, const std::vector<double>& values) {
  if (values.size() < 3) return kNothing;
  const auto peak = static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
  const double half = 0.5 * values[peak];
  const auto crossing = [&](std::size_t outer, std::size_t inner) {
    const double part = (half - values[outer]) / (values[inner] - values[outer]);
    return places[outer] + part * (places[inner] - places[outer]);
  };
  double left = kNothing, right = kNothing;
  for (std::size_t i = peak; i-- > 0 && std::isnan(left);)
    if (values[i] <= half) left = crossing(i, i + 1);
  for (std::size_t i = peak + 1; i < values.size() && std::isnan(right); ++i)
    if (values[i] <= half) right = crossing(i, i - 1);
  return right - left;
}

RunAgreement agreement_of(const PressedRecording& recording, const std::vector<FitRow>& rows, const dvec3& zero,
                          const std::vector<double>& simulated, const std::vector<double>& gains, int axis) {
  RunAgreement run;
  run.zero = zero;
  const std::size_t taxels = gains.size();
  std::vector<ErrorSums> of_taxels(taxels);
  ErrorSums all;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t t = 0; t < taxels; ++t) {
      const double measured = measured_at(recording, rows[i], t), reading = simulated[i * taxels + t];
      if (std::isnan(measured)) continue;
      const double fitted = gains[t] * reading;
      run.points.push_back(
          {rows[i].press, rows[i].row, recording.displacements[rows[i].row] + zero, t, measured, fitted});
      run.largest = std::max(run.largest, std::abs(measured));
      run.untouched_points += reading == 0 ? 1 : 0;
      of_taxels[t].add(measured, fitted);
      all.add(measured, fitted);
    }
  run.r2 = all.r2(), run.rms = all.rms() / run.largest, run.worst = all.worst / run.largest;
  for (std::size_t t = 0; t < taxels; ++t) {
    TaxelAgreement one;
    one.taxel = recording.taxel_ids[t];
    one.column = recording.columns[t];
    one.gain = gains[t];
    one.points = static_cast<std::size_t>(of_taxels[t].count);
    one.r2 = of_taxels[t].r2();
    one.rms = of_taxels[t].rms() / run.largest;
    one.worst = of_taxels[t].worst / run.largest;
    const Bell bell = bell_of(recording, run, t, axis);
    one.width_measured = half_width(bell.places, bell.measured);
    one.width_fitted = half_width(bell.places, bell.fitted);
    run.taxels.push_back(std::move(one));
  }
  return run;
}

std::vector<Undecided> undecided_of(const std::vector<FittedParameter>& parameters,
                                    const std::vector<std::vector<double>>& correlations) {
  std::vector<Undecided> out;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!std::isfinite(parameters[i].standard_error))
      out.push_back({{i}, 1, fmt::format("no reading depends on {}: leave it out of --free", named(parameters[i]))});
    for (std::size_t j = i + 1; j < parameters.size(); ++j)
      if (std::abs(correlations[i][j]) > kUndecided)
        out.push_back({{i, j}, correlations[i][j], advice_for(parameters[i].name, parameters[j].name)});
  }
  return out;
}

}  // namespace taxel
