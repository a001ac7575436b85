#include "core/run/real/apply_gains.h"

#include <algorithm>

#include "core/base/error.h"

namespace taxel {

Calibration with_gains(const std::optional<Calibration>& before, const std::vector<TaxelFit>& fits,
                       const std::string& unit) {
  Calibration calibration = before.value_or(Calibration{});
  if (!unit.empty()) calibration.unit = unit;
  std::vector<TaxelCalibration>& taxels = calibration.taxels;
  bool any = false;
  for (const TaxelFit& fit : fits) {
    if (!fit.refused.empty() || fit.gain == 0) continue;
    any = true;
    auto own = std::find_if(taxels.begin(), taxels.end(), [&](const TaxelCalibration& t) { return t.id == fit.taxel; });
    if (own == taxels.end()) own = taxels.insert(taxels.end(), TaxelCalibration{fit.taxel, {}, {}, {}, {}});
    own->gain = fit.gain;
    own->tare = fit.offset == 0 ? 0 : -fit.offset / fit.gain;
    own->curve.clear();
  }
  if (!any) throw Error("no taxel has a gain");
  return calibration;
}

}  // namespace taxel
