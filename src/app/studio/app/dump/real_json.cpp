#include "app/studio/app/dump/real_json.h"

#include <nlohmann/json.hpp>

#include "app/studio/app/app.h"
#include "app/studio/app/values/simulate_features.h"

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

std::string real_to_json(const ui::App& app) {
  Json json = {{"asks", app.simulate->real.asks},
               {"problem", app.simulate->real.problem},
               {"applied", app.simulate->real.applied},
               {"columns", app.simulate->real.look.columns},
               {"mapping", Json::parse(mapping_to_json(app.simulate->real.mapping))},
               {"shown", app.simulate->real.shown ? shown_real_json(*app.simulate->real.shown) : Json(nullptr)},
               {"curves", Json::array()}};
  for (const ui::RealCurves::Curve& curve : app.simulate->real.curves.curves)
    json["curves"].push_back({{"taxel", curve.taxel}, {"points", curve.x.size()}});
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace taxel::studio
