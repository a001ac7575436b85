#include <nlohmann/json.hpp>

#include "app/cli/models_report.h"

namespace taxel::cli {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

std::string models_json(const ModelsReport& report) {
  const Layout& layout = report.model->layout;
  Json models = Json::array(), taxels = Json::array();
  for (const ReadingModel model : kReadingModels) {
    const std::string missing = missing_of(report, model);
    models.push_back({{"model", to_word(model)},
                      {"unit", unit_of(model, layout.readout.aggregate)},
                      {"missing", missing.empty() ? Json(nullptr) : Json(missing)}});
  }
  for (std::size_t k = 0; k < layout.taxels.size(); ++k) {
    const std::vector<double> exact = curve_of(report, ReadingModel::exact, k);
    Json of = Json::object();
    for (const ReadingModel model : kReadingModels) {
      const CurveComparison c = compare_curve(curve_of(report, model, k), exact);
      of[to_word(model)] = {{"peak", c.peak},
                            {"correlation", or_null(c.correlation)},
                            {"rms", or_null(c.rms)},
                            {"largest_step", c.largest_step}};
    }
    taxels.push_back({{"id", layout.taxels[k].id}, {"name", layout.taxels[k].name}, {"models", std::move(of)}});
  }
  return Json{{"sensor", report.geom}, {"rows", report.rows.size()}, {"models", models}, {"taxels", taxels}}.dump(
             1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

}  // namespace taxel::cli
