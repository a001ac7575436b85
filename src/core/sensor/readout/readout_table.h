// What each ray counts in each taxel: the receptive fields, turned round and summed once, so that a reading costs what
// was hit.
#pragma once

#include <cstdint>
#include <vector>

namespace taxel {

struct SensorModel;

/// Built from a model's fields, rays and samples.
struct ReadoutTable {
  /// One taxel's entry of a ray.
  struct Use {
    std::int32_t taxel = 0;
    double weight = 0;    ///< of ReceptiveFields::Entry
    double distance = 0;  ///< [m]
  };
  std::vector<std::int32_t> first{0};  ///< uses of ray r: [first[r], first[r + 1])
  std::vector<Use> uses;
  std::vector<double> share;                  ///< by ray: SensorModel::sample_share
  std::vector<double> weight_sum, share_sum;  ///< by taxel, over its whole field
  std::vector<std::int32_t> nearest;          ///< by taxel: the ray of its nearest sample, -1 for an empty field
};

ReadoutTable make_readout_table(const SensorModel& model);

}  // namespace taxel
