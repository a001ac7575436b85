// The study in the state of the window.
#include <nlohmann/json.hpp>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/vector_json.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_study(const App& app, nlohmann::ordered_json& state) {
  Json runs = Json::array();
  const StudyCurvesPtr& curves = app.get<StudyState>().shown.curves;
  for (const StudyCurve& curve : curves ? curves->runs : std::vector<StudyCurve>{}) {
    double largest = 0;
    for (const std::vector<double>& readings : curve.readings)
      for (const double reading : readings) largest = std::max(largest, reading);
    runs.push_back(
        {{"values", curve.run.values}, {"rows", curve.time.size()}, {"largest", largest}, {"error", curve.error}});
  }
  state["study"] = {{"busy", app.get<StudyState>().shown.busy},
                    {"cancelled", app.get<StudyState>().cancelled},
                    {"problem", curves ? curves->problem : ""},
                    {"runs", runs}};
}

}  // namespace taxel::ui
