// The receptive fields by ray instead of by taxel, summed once, so that the cost of a reading depends on the hits only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/layout/field/receptive_field.h"

namespace taxel {

/// The uses of each ray, in compressed rows, and the sums over each taxel's field.
struct ReadoutTable {
  /// A taxel that uses a ray.
  struct Use {
    std::int32_t taxel = 0;
    double weight = 0;    ///< ReceptiveFields::Entry::weight [m^2]
    double distance = 0;  ///< distance of the sample from the taxel's centre [m]
  };
  std::vector<int> ray_of_entry;       ///< ray of each of ReceptiveFields::entries
  std::vector<std::int32_t> first{0};  ///< offsets: the uses of ray r are [first[r], first[r + 1])
  std::vector<Use> uses;
  std::vector<double> share;                  ///< SensorModel::sample_share() of each ray's sample
  std::vector<double> weight_sum, share_sum;  ///< sums over each taxel's whole field
  std::vector<std::int32_t> nearest;          ///< ray of each taxel's nearest sample, -1 for an empty field
};

/// Builds the table of receptive fields. `ray_of_entry` has the ray of each entry, `share` the share of each ray.
ReadoutTable make_readout_table(const ReceptiveFields& fields, std::vector<int> ray_of_entry,
                                std::vector<double> share);

}  // namespace taxel
