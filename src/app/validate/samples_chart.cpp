// The samples of B1 on the fingertip, as a picture and as a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/validate/sample_score.h"
#include "app/validate/validation.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

/// The samples of one quality and how even they are.
struct ScoredSamples {
  std::vector<SurfaceSample> samples;
  SampleScore score;
};

ScoredSamples scored_samples(SampleQuality quality) {
  constexpr int kPictureSamples = 10000;
  constexpr std::uint64_t kPictureSeed = 42;
  const TriMesh mesh = make_fingertip();
  ScoredSamples scored{sample_surface(mesh, kPictureSamples, kPictureSeed, nullptr, quality), {}};
  scored.score = score_samples(mesh, scored.samples);
  return scored;
}

/// Returns the number of values in each bin as a line with steps.
ChartCurve histogram(const std::vector<double>& values, const LineStyle& style) {
  constexpr int kBins = 60;
  constexpr double kBin = 0.01, kFirst = 0.5;  // from 0.5 to 1.1
  std::vector<double> counts(kBins, 0);
  for (const double value : values) {
    const double bin = std::floor((value - kFirst) / kBin);
    if (bin >= 0 && bin < kBins) ++counts[static_cast<std::size_t>(bin)];
  }
  ChartCurve curve{{}, style};
  for (int i = 0; i < kBins; ++i)
    for (const int end : {0, 1}) {
      curve.points.x.push_back(kFirst + kBin * (i + end));
      curve.points.y.push_back(counts[static_cast<std::size_t>(i)]);
    }
  return curve;
}

ChartPanel dots_panel(const ScoredSamples& polished) {
  ChartPanel panel;
  panel.title = "polished samples, pad side";
  ChartDots dots{{}, {}, {}, 0.84, 1, "nearest neighbour / densest packing"};
  for (std::size_t i = 0; i < polished.samples.size(); ++i) {
    const dvec3& p = polished.samples[i].position;
    if (p.y >= 0) continue;
    dots.x.push_back(1e3 * p.x), dots.y.push_back(1e3 * p.z), dots.values.push_back(polished.score.rho[i]);
  }
  const auto [left, right] = std::minmax_element(dots.x.begin(), dots.x.end());
  const auto [low, high] = std::minmax_element(dots.y.begin(), dots.y.end());
  panel.x = {*left - 1, *right + 1, "x (mm)", true};
  panel.y = {*low - 1, *high + 1, "z (mm)", true};
  panel.dots = std::move(dots);
  return panel;
}

}  // namespace

Chart samples_chart() {
  const ScoredSamples polished = scored_samples(SampleQuality::polished),
                      preview = scored_samples(SampleQuality::preview);
  const LineStyle polished_style{{0.13, 0.57, 0.55}, 1.6, {}, 0}, preview_style{{0.84, 0.37, 0}, 1.6, {4, 2}, 0};
  ChartPanel counts;
  counts.title = "how often";
  counts.x = {0.6, 1.05, "nearest neighbour / densest packing", true};
  counts.curves = {histogram(preview.score.rho, preview_style), histogram(polished.score.rho, polished_style)};
  counts.legend = {{"polished", polished_style}, {"preview", preview_style}};
  double most = 1;
  for (const ChartCurve& curve : counts.curves)
    for (const double count : curve.points.y) most = std::max(most, count);
  counts.y = {0, 1.08 * most, "samples", true};
  Chart chart;
  chart.title = "Samples of the fingertip";
  chart.columns = 2;
  chart.panels = {dots_panel(polished), std::move(counts)};
  const ChartPanel& dots = chart.panels.front();
  chart.axes.y = 340;
  chart.axes.x = chart.axes.y * (dots.x.high - dots.x.low) / (dots.y.high - dots.y.low);  // equal scales both ways
  return chart;
}

std::string samples_csv() {
  std::string csv = "x,y,z,rho,area,quality\n";
  for (const auto& [quality, name] :
       {std::pair(SampleQuality::polished, "polished"), std::pair(SampleQuality::preview, "preview")}) {
    const ScoredSamples scored = scored_samples(quality);
    for (std::size_t i = 0; i < scored.samples.size(); ++i) {
      const dvec3& x = scored.samples[i].position;
      csv += fmt::format("{},{},{},{},{},{}\n", x.x, x.y, x.z, scored.score.rho[i], scored.score.area[i], name);
    }
  }
  return csv;
}

}  // namespace taxel
