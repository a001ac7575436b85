// Samples, geodesic distances and weighted means: B1 to B3.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/validate/sample_score.h"
#include "app/validate/setups.h"
#include "app/validate/validation.h"
#include "core/base/rng.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/geodesic.h"
#include "core/mesh/make/primitives.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

constexpr int kSamples = 10000;
constexpr std::uint64_t kSeed = 42;

/// The bounds of a uniform set of samples.
struct EvennessBounds {
  double area_cv, gap;
};

void check_evenness(const std::string& name, const TriMesh& mesh, const EvennessBounds& bounds,
                    ClosedFormChecks& checks) {
  const std::vector<SurfaceSample> samples = sample_surface(mesh, kSamples, kSeed);
  const SampleScore score = score_samples(mesh, samples);
  const CheckedCase about{"B1", fmt::format("{}, {} samples asked for, seed {}", name, kSamples, kSeed)};
  Statistic count;
  count.add(static_cast<double>(samples.size()), kSamples);
  ClosedFormCheck exact = count.mean(about, "samples", "1", 0);
  exact.quantity = "samples";
  checks.push_back(exact);
  checks.push_back(about.limit("nearest neighbour, smallest", "1", score.rho_min, Relation::at_least, 0.78));
  checks.push_back(about.limit("nearest neighbour, 5 % are below", "1", score.rho_5_percent, Relation::at_least, 0.85));
  checks.push_back(about.limit("nearest neighbour, mean", "1", score.rho_mean, Relation::at_least, 0.90));
  checks.push_back(about.limit("variation of the areas", "1", score.area_cv, Relation::at_most, bounds.area_cv));
  checks.push_back(about.limit("widest gap", "1", score.gap, Relation::at_most, bounds.gap));
}

/// A regular prism of radius R with `sides` faces, without ends: circumference 2 sides R sin(pi/sides).
struct Tube {
  double radius = 0.01, half_length = 0.02;
  int sides = 48, rings = 24;

  [[nodiscard]] double width() const { return 2.0 * radius * std::sin(kPi / sides); }  // width of a side
  [[nodiscard]] TriMesh mesh() const {
    std::vector<dvec3> vertices;
    std::vector<ivec3> faces;
    for (int j = 0; j <= rings; ++j) {
      for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * kPi * i / sides;
        vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                              half_length * (2.0 * j / rings - 1.0));
      }
    }
    for (int j = 0; j < rings; ++j) {
      for (int i = 0; i < sides; ++i) {
        const int a = j * sides + i, b = j * sides + (i + 1) % sides, c = a + sides, d = b + sides;
        faces.emplace_back(a, b, d);
        faces.emplace_back(a, d, c);
      }
    }
    return {std::move(vertices), std::move(faces)};
  }
  /// Returns the coordinates of a point on the unrolled tube: along the circumference and along the axis.
  [[nodiscard]] dvec2 unrolled(int face, const dvec3& x) const {
    const int side = face / 2 % sides;
    const double angle = 2.0 * kPi * side / sides;
    const dvec2 begins(radius * std::cos(angle), radius * std::sin(angle));
    return {side * width() + glm::distance(dvec2(x), begins), x.z};
  }
};

dvec3 random_point(const TriMesh& mesh, int face, const CounterRng& rng, std::uint64_t i) {
  double u = rng.uniform(2 * i), v = rng.uniform(2 * i + 1);
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const dvec3 &a = mesh.vertex(face, 0), &b = mesh.vertex(face, 1), &c = mesh.vertex(face, 2);
  return a + u * (b - a) + v * (c - a);
}

/// Checks the readings of a FlatPatch with the pressure p = 1 + slope x at the origins of its rays against p at the
/// taxels' centres.
void read_flat_patch(const SensorModel& model, Statistic& statistic) {
  const auto pressure = [](double x) { return 1.0 + FlatPatch::kSlope * x; };
  RayHits hits;
  hits.clear(model.rays.size());
  for (std::size_t r = 0; r < model.rays.size(); ++r)
    hits.offer(static_cast<std::int32_t>(r), {0, 0, 0, pressure(model.rays[r].origin.x)});
  hits.finish();
  std::vector<double> values;
  aggregate(model, hits, Aggregate::weighted_mean, values);
  for (std::size_t k = 0; k < values.size(); ++k) statistic.add(values[k], pressure(model.layout.taxels[k].center.x));
}

}  // namespace

ClosedFormChecks validate_samples() {
  ClosedFormChecks checks;
  check_evenness("our fingertip", make_fingertip(), {0.13, 2.0}, checks);
  check_evenness("a sphere of 5120 faces", make_icosphere(0.01, 4), {0.10, 1.5}, checks);
  return checks;
}

/// Shortest paths are straight lines on the unrolled faces; the distance is the shorter one around the tube.
ClosedFormChecks validate_geodesics() {
  constexpr int kSources = 50, kTargets = 20;
  const Tube tube;
  const auto mesh = std::make_shared<const TriMesh>(tube.mesh());
  GeodesicDistance distance(std::make_shared<const UnfoldedMesh>(mesh));
  const CounterRng rng(kSeed);
  const double around = tube.sides * tube.width();
  Statistic error;
  const auto face_of = [&](std::uint64_t i) {
    return static_cast<int>(rng.uniform(i) * static_cast<double>(mesh->face_count()));
  };
  for (std::uint64_t s = 0; s < kSources; ++s) {
    const std::uint64_t first = 1000 * s;
    const int face = face_of(first);
    const dvec3 source = random_point(*mesh, face, rng, first + 100);
    distance.propagate(face, source, std::numeric_limits<double>::infinity());
    const dvec2 from = tube.unrolled(face, source);
    for (std::uint64_t t = 1; t <= kTargets; ++t) {
      const int to_face = face_of(first + t);
      const dvec3 target = random_point(*mesh, to_face, rng, first + 100 + t);
      dvec2 step = tube.unrolled(to_face, target) - from;
      step.x = std::min(std::abs(step.x), around - std::abs(step.x));
      error.add(distance.to(to_face, target), glm::length(step));
    }
  }
  const CheckedCase about{"B2", fmt::format("a tube of {} sides, {} faces, radius {} m, random points in faces",
                                            tube.sides, mesh->face_count(), tube.radius)};
  return {error.worst(about, "distance", "m", 1e-9)};
}

ClosedFormChecks validate_weighted_mean() {
  constexpr std::uint64_t kSeeds = 5;
  ClosedFormChecks checks;
  for (const auto& [weights, name] :
       {std::pair(SampleWeights::voronoi, "Voronoi areas"), std::pair(SampleWeights::equal, "equal")}) {
    const CheckedCase about{"B3", fmt::format("49 taxels of 3 mm on a plate, p from 0.4 to 1.6 over 20 mm, weights {}, "
                                              "{} seeds",
                                              name, kSeeds)};
    for (const int samples : {25, 100, 400}) {
      Statistic statistic;
      for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
        read_flat_patch(*FlatPatch::model(FlatPatch::layout(samples, seed, weights)), statistic);
      const std::string quantity = fmt::format("mean with {} samples a taxel", samples);
      const double bound = (weights == SampleWeights::voronoi ? 0.005 : 0.01) * (samples < 100 ? 3 : 1);
      checks.push_back(statistic.mean(about, quantity, "1", 0.2 * bound));
      checks.push_back(statistic.worst(about, quantity, "1", bound));
    }
  }
  return checks;
}

// The samples of B1 on the fingertip, as a picture and as a table.

namespace {

/// The samples of one quality and how even they are.
struct ScoredSamples {
  std::vector<SurfaceSample> samples;
  SampleScore score;
};

ScoredSamples scored_samples(SampleQuality quality) {
  const TriMesh mesh = make_fingertip();
  ScoredSamples scored{sample_surface(mesh, kSamples, kSeed, nullptr, quality), {}};
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
