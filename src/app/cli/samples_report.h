// `taxel samples` in short: how many samples, and how many each taxel gathers.
#pragma once

#include <string>
#include <vector>

#include "core/sensor/sensor_model.h"

namespace taxel::cli {

struct SamplesReport {
  std::string name;                       ///< of the layout
  int samples = 0, used = 0, shared = 0;  ///< shared: used by several taxels
  double area = 0;                        ///< of what is sampled [m^2]
  double density = 0;                     ///< asked for [1/m^2]
  std::uint64_t seed = 0;
  struct Taxel {
    int id = 0;
    std::string name;
    int samples = 0;
  };
  std::vector<Taxel> taxels;
};

SamplesReport report_samples(const SensorModel& model);
std::string samples_text(const SamplesReport& report);
std::string samples_json(const SamplesReport& report);

}  // namespace taxel::cli
