// A recording of a real sensor in the state of the window.
#include <nlohmann/json.hpp>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/nouns/real/real_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

Json shown_real_json(const RealShown& shown) {
  Json json = {{"file", shown.file},
               {"rows", shown.recording.series.time.size()},
               {"unit", shown.unit},
               {"shift", shown.shift},
               {"awaits_end", shown.awaits_end},
               {"correlation", nullptr},
               {"notes", shown.recording.notes},
               {"fits", Json::array()}};
  json["overlap"] = nullptr;
  if (shown.alignment) json["correlation"] = shown.alignment->correlation, json["overlap"] = shown.alignment->overlap;
  for (const TaxelFit& fit : shown.fits)
    json["fits"].push_back({{"taxel", fit.taxel},
                            {"refused", fit.refused},
                            {"gain", fit.gain},
                            {"offset", fit.offset},
                            {"r2", fit.r2},
                            {"residual", fit.residual}});
  return json;
}

}  // namespace

void dump_real(const App& app, nlohmann::ordered_json& state) {
  const RealState& real = app.get<RealState>();
  Json json = {{"asks", real.asks},
               {"problem", real.problem},
               {"refused", real.refused},
               {"columns", real.look.columns},
               {"mapping", Json::parse(mapping_to_json(real.mapping))},
               {"shown", real.shown ? shown_real_json(*real.shown) : Json(nullptr)},
               {"points", real.points},
               {"curves", Json::array()}};
  for (const RealCurves::Curve& curve : real.curves.curves)
    json["curves"].push_back({{"taxel", curve.taxel}, {"points", curve.x.size()}});
  state["real"] = std::move(json);
}

}  // namespace taxel::ui
