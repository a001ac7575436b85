#include "core/project/validation/artifact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"
#include "core/project/validation/press.h"
#include "core/sensor/explain/exact_reading.h"
#include "core/sensor/reading.h"

namespace taxel {
namespace {

constexpr int kTaxels = 3;
constexpr double kBar = 0.002, kDepth = 0.001;  // half its width, and how deep it is pressed [m]
constexpr double kFrom = 0.012, kTo = 0.018;    // along the finger [m]
constexpr double kStep = 0.0001;                // as the paper records [m]
constexpr double kTaxelRadius = 0.004;          // [m]
constexpr double kFew = 2.5e5, kMany = 1e7;     // samples per square metre

/// What tells one run from another.
struct Setting {
  const char* name;
  FieldKind field;
  double density;
  SampleWeights weights;
};
constexpr Setting kSettings[] = {
    {"star, few samples", FieldKind::star, kFew, SampleWeights::equal},
    {"pad, few samples", FieldKind::pad, kFew, SampleWeights::equal},
    {"pad, 40 times the samples", FieldKind::pad, kMany, SampleWeights::equal},
    {"pad, 40 times the samples, by their areas", FieldKind::pad, kMany, SampleWeights::voronoi},
};

/// The skin on the side of the pad, in the plane of symmetry.
SurfacePoint skin_at(const MeshIndex& skin, double z) {
  const Ray ray{dvec3(0, -1, z), dvec3(0, 1, 0)};
  const MeshHit hit = skin.cast(ray).value();
  return skin.closest_point(ray.origin + hit.t * ray.direction);
}

/// On the side of the pad, in a row along the finger.
Layout layout_of(const Setting& setting, const MeshIndex& skin) {
  Layout layout;
  layout.mesh.file = "fingertip";
  layout.material.field = setting.field;
  layout.sampling.density = setting.density;
  layout.sampling.weights = setting.weights;
  layout.readout.aggregate = Aggregate::weighted_mean;
  for (int i = 0; i < kTaxels; ++i) {
    const double z = kFrom + (kTo - kFrom) * i / (kTaxels - 1);
    const SurfacePoint at = skin_at(skin, z);
    layout.taxels.push_back(
        {i, "", at.position, skin.mesh().face_normals()[static_cast<std::size_t>(at.face)], kTaxelRadius, {}});
  }
  return layout;
}

/// X_MB: the middle of the bar's face kDepth below the skin.
std::vector<Pose> path_on(const MeshIndex& skin) {
  std::vector<Pose> path;
  const int poses = static_cast<int>(std::lround((kTo - kFrom) / kStep)) + 1;
  for (int i = 0; i < poses; ++i) {
    path.push_back({{1, 0, 0, 0}, skin_at(skin, kFrom + kStep * i).position + dvec3(0, kDepth - kBar, 0)});
  }
  return path;
}

HydroBodyPtr bar() {
  return make_body({ShapeType::box, dvec3(0.02, kBar, kBar), nullptr, 0}, {}, "bar");
}

std::vector<std::vector<double>> read_path(const SensorModel& model, const std::vector<Pose>& path) {
  Press press(model.body, bar());
  SensorReading reading;
  std::vector<std::vector<double>> readings;
  for (const Pose& X_MB : path) {
    press.at(Pose{}, X_MB);
    const ContactSurface* const surface = &press.surface();
    read_sensor(model, {&surface, 1}, reading);
    readings.push_back(reading.values);
  }
  return readings;
}

std::vector<std::vector<double>> exact_path(const SensorModel& model, const std::vector<Pose>& path) {
  std::vector<std::vector<double>> readings(path.size(), std::vector<double>(kTaxels));
  parallel_chunks(static_cast<int>(path.size()), 8, [&](int begin, int end) {
    Press press(model.body, bar());
    for (int i = begin; i < end; ++i) {
      const auto at = static_cast<std::size_t>(i);
      press.at(Pose{}, path[at]);
      const ContactSurface* const surface = &press.surface();
      for (int k = 0; k < kTaxels; ++k)
        readings[at][static_cast<std::size_t>(k)] = exact_reading(model, k, {&surface, 1}).value.value_or(0);
    }
  });
  return readings;
}

double largest_jump(const std::vector<std::vector<double>>& exact, const std::vector<std::vector<double>>& readings) {
  double jump = 0, largest = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < exact[i].size(); ++k) {
      largest = std::max(largest, exact[i][k]);
      if (i == 0) continue;
      const double change = readings[i][k] - readings[i - 1][k], own = exact[i][k] - exact[i - 1][k];
      jump = std::max(jump, std::abs(change - own));
    }
  }
  return jump / largest;
}

}  // namespace

Artifact measure_artifact() {
  const auto mesh = std::make_shared<const TriMesh>(make_fingertip());
  const MeshIndex skin(mesh);
  const std::vector<Pose> path = path_on(skin);
  Artifact artifact;
  for (std::size_t i = 0; i < path.size(); ++i) artifact.travel.push_back(kStep * static_cast<double>(i));
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  std::vector<SensorModelPtr> models;
  for (const Setting& setting : kSettings)
    models.push_back(build_sensor_model(layout_of(setting, skin), mesh, "", "fingertip", how));
  for (std::size_t m = 0; m < models.size(); ++m) {
    ArtifactRun run{kSettings[m].name, read_path(*models[m], path), {}, 0};
    const bool same_field = m > 0 && kSettings[m].field == kSettings[m - 1].field;  // the integral knows no samples
    run.exact = same_field ? artifact.runs.back().exact : exact_path(*models[m], path);
    run.jump = largest_jump(run.exact, run.readings);
    artifact.runs.push_back(std::move(run));
  }
  return artifact;
}

ClosedFormChecks validate_artifact(const Artifact& artifact) {
  const CheckedCase about{
      "C1", fmt::format(
                "rigid bar {} m wide across our fingertip, {} m deep, {} poses {} m apart, three taxels of {} m; few: "
                "{:g} samples per mm^2",
                2 * kBar, kDepth, artifact.travel.size(), kStep, kTaxelRadius, 1e-6 * kFew)};
  constexpr double kCure = 10;
  const double first = artifact.runs.front().jump, last = artifact.runs.back().jump;
  ClosedFormChecks checks;
  for (const ArtifactRun& run : artifact.runs) {
    const bool ends = &run == &artifact.runs.front();
    const bool cured = &run == &artifact.runs.back();
    checks.push_back(about.limit("largest jump, " + run.name, "1", run.jump,
                                 ends ? Relation::at_least : Relation::at_most,
                                 ends    ? kCure * last
                                 : cured ? first / kCure
                                         : first));
  }
  return checks;
}

ClosedFormChecks validate_artifact() {
  return validate_artifact(measure_artifact());
}

std::string artifact_for_picture(const Artifact& artifact) {
  constexpr std::size_t kShown = kTaxels / 2;
  std::string text = "travel_mm";
  for (const ArtifactRun& run : artifact.runs) text += fmt::format(",\"{}\",exact", run.name);
  text += '\n';
  for (std::size_t i = 0; i < artifact.travel.size(); ++i) {
    text += fmt::format("{:.1f}", 1e3 * artifact.travel[i]);
    for (const ArtifactRun& run : artifact.runs)
      text += fmt::format(",{},{}", 1e-3 * run.readings[i][kShown], 1e-3 * run.exact[i][kShown]);
    text += '\n';
  }
  return text;
}

}  // namespace taxel
