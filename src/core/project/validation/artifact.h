// C1: the artifact that the paper describes, readings that jump although the contact goes on smoothly, and what cures
// it. A bar across our fingertip slides along it at constant depth; three taxels read the same poses by a star field or
// a pad, by few samples or many, of equal weight or weighted by their Voronoi areas.
#pragma once

#include <string>
#include <vector>

#include "core/project/validation/closed_form.h"

namespace taxel {

/// One way to read the path.
struct ArtifactRun {
  std::string name;                           ///< "star, few samples"
  std::vector<std::vector<double>> readings;  ///< by pose, by taxel [Pa]
  std::vector<std::vector<double>> exact;     ///< likewise: what the readings become with ever more samples
  /// Largest |change of a reading - change of the exact integral| from one pose to the next, over the largest exact
  /// reading.
  double jump = 0;
};

struct Artifact {
  std::vector<double> travel;     ///< by pose [m]
  std::vector<ArtifactRun> runs;  ///< from the artifact to its cure
};
/// Takes some seconds.
Artifact measure_artifact();

/// C1: each run against the first, and the last at least ten times below it.
ClosedFormChecks validate_artifact(const Artifact& artifact);
ClosedFormChecks validate_artifact();

/// travel_mm, and of each run the reading of the middle taxel and the exact one [kPa], a row a pose.
std::string artifact_for_picture(const Artifact& artifact);

}  // namespace taxel
