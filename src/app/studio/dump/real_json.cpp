#include "app/studio/dump/real_json.h"

#include <nlohmann/json.hpp>

namespace taxel::studio {

namespace {

using Json = nlohmann::ordered_json;

Json shown_real_json(const ui::RealShown& real) {
  Json json = {{"file", real.file},      {"rows", real.recording.series.time.size()},
               {"unit", real.unit},      {"shift", real.shift},
               {"correlation", nullptr}, {"notes", real.recording.notes},
               {"fits", Json::array()}};
  if (real.alignment) json["correlation"] = real.alignment->correlation;
  for (const TaxelFit& fit : real.fits)
    json["fits"].push_back({{"taxel", fit.taxel},
                            {"refused", fit.refused},
                            {"gain", fit.gain},
                            {"offset", fit.offset},
                            {"r2", fit.r2},
                            {"residual", fit.residual}});
  return json;
}

}  // namespace

std::string real_to_json(const ui::UiState& ui, const ui::UiInput& input) {
  Json json = {{"asks", ui.real.asks},
               {"problem", ui.real.problem},
               {"applied", ui.real.applied},
               {"columns", ui.real.look.columns},
               {"mapping", Json::parse(mapping_to_json(ui.real.mapping))},
               {"shown", input.real ? shown_real_json(*input.real) : Json(nullptr)},
               {"curves", Json::array()}};
  for (const ui::RealCurves::Curve& curve : ui.real.curves.curves)
    json["curves"].push_back({{"taxel", curve.taxel}, {"points", curve.x.size()}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
