// The result of `taxel read`: a layout's readings in one contact, and where each comes from.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/convergence.h"
#include "core/sensor/explain/samples_behind.h"
#include "core/sensor/readout/reading.h"

namespace taxel::cli {

struct ReadReport {
  const SensorModel& model;
  Pose X_WM;             ///< of the frame of the mesh file
  ContactResult result;  ///< contact of the layout's body, frame M
  RayHits hits;
  ForceReading force;                                               ///< frame M
  std::vector<dvec2> shear;                                         ///< of the layout's aggregate, in layout order
  std::vector<std::pair<Aggregate, std::vector<double>>> readings;  ///< every aggregate, values in layout order
  std::vector<std::vector<TaxelSampleReading>> behind;              ///< per taxel
  std::optional<Convergence> convergence;                           ///< where asked for
};

/// Samples of a taxel whose rays met a contact surface, over all of its samples; 0 without samples.
double covered(const std::vector<TaxelSampleReading>& samples);

std::string read_text(const ReadReport& report);
std::string read_json(const ReadReport& report);

}  // namespace taxel::cli
