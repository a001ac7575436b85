#include "core/sensor/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/layout/words.h"

namespace taxel {

const char* to_word(ReadingModel model) {
  switch (model) {
    case ReadingModel::reading:
      return "reading";
    case ReadingModel::star:
      return "star";
    case ReadingModel::weighted_sum:
      return "weighted_sum";
    case ReadingModel::exact:
      return "exact";
    case ReadingModel::tactile:
      return "tactile";
    case ReadingModel::touch:
      return "touch";
    case ReadingModel::finer:
      return "finer";
    case ReadingModel::second:
      return "second";
  }
  return "";
}

const char* unit_of(ReadingModel model, Aggregate aggregate) {
  switch (model) {
    case ReadingModel::weighted_sum:
      return reading_unit(Aggregate::weighted_sum);
    case ReadingModel::tactile:
      return "m";
    case ReadingModel::touch:
      return "N";
    default:
      return reading_unit(aggregate);
  }
}

bool ModelReading::has(std::size_t taxel) const {
  return taxel < values.size() && !std::isnan(values[taxel]);
}

const ModelReading& ModelReadings::operator[](ReadingModel model) const {
  static const ModelReading none;
  const auto found =
      std::find_if(models.begin(), models.end(), [&](const ModelReading& m) { return m.model == model; });
  return found == models.end() ? none : *found;
}

CurveComparison compare_curve(std::span<const double> curve, std::span<const double> exact) {
  CurveComparison out;
  double last = std::nan("");
  double n = 0, c = 0, e = 0, cc = 0, ee = 0, ce = 0, top = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (std::isnan(curve[i])) continue;
    out.peak = std::max(out.peak, curve[i]);
    if (!std::isnan(last)) out.largest_step = std::max(out.largest_step, std::abs(curve[i] - last));
    last = curve[i];
    if (i >= exact.size() || std::isnan(exact[i])) continue;
    ++n, c += curve[i], e += exact[i];
    cc += curve[i] * curve[i], ee += exact[i] * exact[i], ce += curve[i] * exact[i];
    top = std::max(top, exact[i]);
  }
  if (out.peak > 0) out.largest_step /= out.peak;
  // Sums of squares about the means lose digits where the mean is large; readings begin at 0.
  const double var_c = cc - c * c / n, var_e = ee - e * e / n;
  constexpr double kRounding = 1e-12;
  if (n > 1 && var_c > kRounding * cc && var_e > kRounding * ee)
    out.correlation = std::clamp((ce - c * e / n) / std::sqrt(var_c * var_e), -1.0, 1.0);
  if (top > 0) {
    const double gain = cc > 0 ? ce / cc : 0.0;  // least-squares gain through the origin
    out.rms = std::sqrt(std::max(0.0, ee - gain * ce) / n) / top;
  }
  return out;
}

std::vector<double> model_curve(std::span<const ComparedStepPtr> steps, ReadingModel model, std::size_t taxel) {
  std::vector<double> curve;
  for (const ComparedStepPtr& step : steps) {
    const ModelReading& reading = step->readings[model];
    curve.push_back(reading.has(taxel) ? reading.values[taxel] : std::nan(""));
  }
  return curve;
}

CurveComparison compare_with_exact(std::span<const ComparedStepPtr> steps, ReadingModel model, std::size_t taxel) {
  return compare_curve(model_curve(steps, model, taxel), model_curve(steps, ReadingModel::exact, taxel));
}

ModelColumns columns_of(ReadingModel model, const std::string& prefix, const Layout& layout) {
  ModelColumns columns{model, prefix, {}};
  for (const Taxel& taxel : layout.taxels) columns.ids.push_back(taxel.id);
  return columns;
}

std::string readings_to_csv(std::span<const ComparedStepPtr> steps, std::span<const ModelColumns> columns) {
  std::string text = "time,travel";
  auto out = std::back_inserter(text);
  for (const ModelColumns& some : columns)
    for (const int id : some.ids) fmt::format_to(out, ",{}{}", some.prefix, id);
  for (const ComparedStepPtr& step : steps) {
    fmt::format_to(out, "\n{},{}", step->time, step->travel);
    for (const ModelColumns& some : columns) {
      const ModelReading& reading = step->readings[some.model];
      for (std::size_t k = 0; k < some.ids.size(); ++k) {
        text += ',';
        if (reading.has(k)) fmt::format_to(out, "{}", reading.values[k]);
      }
    }
  }
  return text + '\n';
}

}  // namespace taxel
