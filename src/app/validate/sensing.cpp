// Samples, geodesic distances and weighted means: B1 to B3.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/validate/flat_patch.h"
#include "app/validate/sample_score.h"
#include "app/validate/validation.h"
#include "core/base/rng.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/geodesic/geodesic_distance.h"
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

}  // namespace taxel
