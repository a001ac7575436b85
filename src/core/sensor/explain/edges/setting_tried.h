// A change of the layout that was tried against a jump, with its effect.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/layout/layout.h"

namespace taxel {

/// A change of one setting of the layout with which the contacts of two steps were read again.
struct SettingTried {
  std::string text;          ///< the setting in words: "rays along the taxel's normal"
  ReceptiveFieldRule field;  ///< rule of the receptive fields
  Readout readout;           ///< readout of the layout
  double radius = 1;         ///< factor of the taxel's radius
  double change = 0;         ///< change of the reading, scaled to the mean of the original readings
  bool cures = false;        ///< true if the change is below the limit with a margin
};

/// Returns the first setting that cures, or the one with the smallest change, or null if no change is below `helpful`.
/// The result is valid as long as `tried`.
inline const SettingTried* best_setting(const std::vector<SettingTried>& tried, double helpful) {
  const SettingTried* best = nullptr;
  for (const SettingTried& setting : tried) {
    if (!(std::abs(setting.change) < helpful)) continue;
    if (setting.cures) return &setting;
    if (best == nullptr || std::abs(setting.change) < std::abs(best->change)) best = &setting;
  }
  return best;
}

}  // namespace taxel
