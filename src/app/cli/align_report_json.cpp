#include <nlohmann/json.hpp>

#include "app/cli/align_report.h"
#include "core/base/text/json_text.h"

namespace taxel::cli {

std::string align_json(const AlignReport& report) {
  using Json = nlohmann::ordered_json;
  Json json = {{"run", report.run},
               {"recording", report.real},
               {"run_unit", report.run_unit},
               {"recording_unit", report.real_unit},
               {"shift", report.shift},
               {"correlation", nullptr},
               {"overlap", nullptr},
               {"common", report.options.common},
               {"with_offset", report.options.offset},
               {"taxels", Json::array()},
               {"notes", report.notes}};
  if (report.alignment) {
    json["correlation"] = report.alignment->correlation;
    json["overlap"] = report.alignment->overlap;
  }
  for (const TaxelFit& fit : report.fits) {
    Json one = {{"id", fit.taxel}, {"values", fit.points}};
    if (fit.refused.empty()) {
      one["gain"] = fit.gain;
      one["offset"] = fit.offset;
      one["r2"] = fit.r2;
      one["residual"] = fit.residual;
      one["largest_error"] = fit.largest_error;
    } else {
      one["refused"] = fit.refused;
    }
    json["taxels"].push_back(std::move(one));
  }
  return json_text(json);
}

}  // namespace taxel::cli
