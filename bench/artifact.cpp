// The artifact of the paper, and its cure. The fingertip sweep is read with few samples of equal weight in a star
// field, with many samples, in a pad, and in a pad with Voronoi weights. Each row of the result has the largest change
// of a reading from step to step that exceeds the change of the exact integral of the same contact, as a fraction of
// the largest reading.
//
//   bench_artifact [FILE.csv [PICTURE.svg]]   prints a section in Markdown for docs/validation.md. FILE gets the
//   travel,
//                                             and for each variant the sampled and the exact reading of each taxel.
//                                             PICTURE gets plots of them.
#include <fmt/format.h>

#include <cstdio>

#include "core/base/files.h"
#include "core/base/page/chart.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/mesh_io.h"
#include "core/run/plot/curve_styles.h"
#include "core/sensor/explain/counterfactual.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/simulator.h"

namespace taxel {
namespace {

struct Variant {
  const char* name;
  FieldKind field;
  double density;
  SampleWeights weights;
};
constexpr Variant kVariants[] = {{"star, few samples", FieldKind::star, 1e6, SampleWeights::equal},
                                 {"star, many samples", FieldKind::star, 4e7, SampleWeights::equal},
                                 {"pad, few samples", FieldKind::pad, 1e6, SampleWeights::equal},
                                 {"pad, default samples, Voronoi weights", FieldKind::pad, 1e7, SampleWeights::voronoi},
                                 {"pad, many samples, Voronoi weights", FieldKind::pad, 4e7, SampleWeights::voronoi}};
constexpr int kTaxels[] = {3, 4, 9, 10};  // taxels that respond

/// One taxel over the sweep.
struct Curve {
  std::vector<double> sampled, exact, even;
};
struct Sweep {
  std::vector<double> travel;
  std::vector<Curve> curves;                                              // by kTaxels
  double largest = 0, worst_step = 0, beyond_exact = 0, beyond_even = 0;  // parts of the largest reading
};

/// Of a curve.
double top(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Changes of a beyond those of scale * b.
double largest_beyond(const std::vector<double>& a, const std::vector<double>& b, double scale) {
  double worst = 0;
  for (std::size_t i = 1; i < a.size(); ++i)
    worst = std::max(worst, std::abs(a[i] - a[i - 1] - scale * (b[i] - b[i - 1])));
  return worst;
}

Sweep sweep(const SensorSource& source, const Variant& variant) {
  SensorSource changed = source;
  changed.layout.material.field = variant.field;
  changed.layout.sampling.density = variant.density;
  changed.layout.sampling.weights = variant.weights;
  const SensorModelPtr model = build_sensor_model(changed);
  const auto simulator = Simulator::make_scenario(model, with_shape({}, ObjectShape::box));
  Sweep out;
  out.curves.resize(std::size(kTaxels));
  while (!simulator->finished()) {
    simulator->step();
    if (!simulator->row_due()) continue;
    const StepView view = simulator->view();
    const auto& surfaces = view.sensors[0].surfaces;
    const OtherSurfaces even = with_even_stiffness(*model, surfaces);
    out.travel.push_back(view.travel);
    for (std::size_t k = 0; k < std::size(kTaxels); ++k) {
      out.curves[k].sampled.push_back(view.sensors[0].readings[static_cast<std::size_t>(kTaxels[k])]);
      out.curves[k].exact.push_back(*exact_reading(*model, kTaxels[k], surfaces).value);
      out.curves[k].even.push_back(*exact_reading(*model, kTaxels[k], even.pointers).value);
    }
  }
  for (const Curve& c : out.curves) {
    out.largest = std::max(out.largest, top(c.sampled));
    out.worst_step = std::max(out.worst_step, largest_beyond(c.sampled, c.exact, 0));
    out.beyond_exact = std::max(out.beyond_exact, largest_beyond(c.sampled, c.exact, 1));
    out.beyond_even = std::max(out.beyond_even, largest_beyond(c.sampled, c.even, top(c.exact) / top(c.even)));
  }
  out.worst_step /= out.largest, out.beyond_exact /= out.largest, out.beyond_even /= out.largest;
  return out;
}

/// Returns a curve of readings in kPa over travel in mm.
ChartCurve curve_of(const std::vector<double>& travel, const std::vector<double>& readings, const LineStyle& style) {
  ChartCurve curve{{travel, readings}, style};
  for (double& x : curve.points.x) x *= 1e3;
  for (double& y : curve.points.y) y *= 1e-3;
  return curve;
}

/// Returns four panels: a star field and a pad, each with few and with many samples.
Chart artifact_chart(const std::vector<Sweep>& all) {
  constexpr std::pair<std::size_t, const char*> kPanels[] = {{0, "star, few samples"},
                                                             {1, "star, many samples"},
                                                             {2, "pad, few samples"},
                                                             {4, "pad, many samples, Voronoi weights"}};
  const LineStyle exact{{0.73, 0.73, 0.73}, 2.2, {}, 0};
  Chart chart;
  chart.title = "The artifact of the paper";
  chart.columns = 2;
  chart.axes = {230, 130};
  for (const auto& [variant, title] : kPanels) {
    const Sweep& s = all[variant];
    const bool is_right = chart.panels.size() % 2 == 1, is_lower = chart.panels.size() >= 2;
    ChartPanel panel;
    panel.title = title;
    panel.x = {7, 24, "travel of the finger (mm)", is_lower};
    panel.y = {0, 1.08e-3 * s.largest, "pressure (kPa)", true};
    for (const Curve& c : s.curves) panel.curves.push_back(curve_of(s.travel, c.exact, exact));
    for (std::size_t k = 0; k < s.curves.size(); ++k)
      panel.curves.push_back(curve_of(s.travel, s.curves[k].sampled, numbered_style(k)));
    if (is_right && !is_lower) {
      panel.legend.push_back({"exact integral", exact});
      for (std::size_t k = 0; k < std::size(kTaxels); ++k)
        panel.legend.push_back({fmt::format("taxel {}", kTaxels[k]), numbered_style(k)});
    }
    chart.panels.push_back(std::move(panel));
  }
  return chart;
}

}  // namespace
}  // namespace taxel

int main(int argc, char** argv) {
  using namespace taxel;
  const SensorSource source =
      read_sensor_source(std::filesystem::path(TAXEL_SOURCE_DIR) / "assets/layouts/fingertip.taxels.json");
  std::vector<Sweep> all;
  fmt::print(
      "\n## The artifact of the paper\n\n"
      "The fingertip sweep with the paper's star field and number of samples, and its cures. The columns have the "
      "largest change of a reading from row to row (0.1 mm), as a fraction of\nthe largest reading: the whole change; "
      "its part beyond the exact integral of the same contact; and its part beyond the exact integral in a field of "
      "uniform stiffness. Taxels 3, 4, 9 and 10.\n"
      "Written by `bench_artifact`, through `scripts/validation`.\n\n"
      "| field, samples | per m^2 | largest step | beyond the exact integral | beyond uniform stiffness |\n"
      "| --- | --- | --- | --- | --- |\n");
  for (const Variant& variant : kVariants) {
    const Sweep& s = all.emplace_back(sweep(source, variant));
    fmt::print("| {} | {:.0e} | {:.2f} % | {:.2f} % | {:.2f} % |\n", variant.name, variant.density, 100 * s.worst_step,
               100 * s.beyond_exact, 100 * s.beyond_even);
    std::fflush(stdout);
  }
  fmt::print(
      "\nThe largest step beyond the exact integral is {:.0f} times smaller in the last variant than in the first. The "
      "four taxels, before (first) and after (last):\n\n"
      "![Readings of four taxels over the sweep, and their exact integrals](pictures/artifact.svg)\n",
      all.front().beyond_exact / all.back().beyond_exact);
  if (argc < 2) return 0;
  std::string csv = "travel";
  for (std::size_t v = 0; v < all.size(); ++v)
    for (const int taxel : kTaxels) csv += fmt::format(",sampled_{0}_{1},exact_{0}_{1}", v, taxel);
  csv += '\n';
  for (std::size_t r = 0; r < all.front().travel.size(); ++r) {
    csv += fmt::format("{}", all.front().travel[r]);
    for (const Sweep& s : all)
      for (const auto& c : s.curves) csv += fmt::format(",{},{}", c.sampled[r], c.exact[r]);
    csv += '\n';
  }
  write_file_atomically(argv[1], csv);
  if (argc > 2) write_file_atomically(argv[2], page_to_svg(chart_page(artifact_chart(all))));
  return 0;
}
