#include <nlohmann/json.hpp>

#include "app/cli/read_report.h"
#include "app/vector_json.h"
#include "core/layout/tangent_frame.h"
#include "core/layout/words.h"

namespace taxel::cli {
namespace {

using Json = nlohmann::ordered_json;

Json taxel_object(const ReadReport& report, std::size_t i) {
  const SensorModel& model = report.model;
  const std::vector<TaxelSampleReading>& samples = report.behind[i];
  Json taxel;
  taxel["id"] = model.layout.taxels[i].id;
  taxel["name"] = model.layout.taxels[i].name;
  taxel["covered"] = covered(samples);
  const Taxel& layout_taxel = model.layout.taxels[i];
  const TangentFrame frame = tangent_frame(model.layout.frame, layout_taxel.normal);
  taxel["tangents"] = {numbers<Json>(report.X_WM.rotate(frame.e1)), numbers<Json>(report.X_WM.rotate(frame.e2))};
  taxel["normal_force"] = numbers<Json>(report.X_WM.rotate(report.force.normal[i]));
  taxel["samples"] = Json::array();
  for (const TaxelSampleReading& sample : samples) {
    taxel["samples"].push_back({{"sample", sample.sample},
                                {"hit", sample.hit},
                                {"depth", sample.depth},
                                {"pressure", sample.pressure},
                                {"weight", sample.weight},
                                {"share", sample.share}});
  }
  return taxel;
}

Json convergence_object(const SensorModel& model, const Convergence& convergence) {
  Json json;
  json["aggregate"] = to_word(convergence.aggregate);
  json["factors"] = Convergence::kFactors;
  json["samples"] = convergence.samples;
  json["taxels"] = Json::array();
  for (std::size_t k = 0; k < model.layout.taxels.size(); ++k) {
    Json values = Json::array();
    for (const std::vector<double>& of_taxels : convergence.values) values.push_back(of_taxels[k]);
    json["taxels"].push_back(
        {{"id", model.layout.taxels[k].id}, {"values", values}, {"difference", convergence.difference(k)}});
  }
  return json;
}

}  // namespace

std::string read_json(const ReadReport& report) {
  Json json;
  json["force"] = numbers<Json>(report.result.wrench_W.force);
  json["torque"] = numbers<Json>(report.result.wrench_W.torque);
  json["area"] = report.result.surface.area();
  json["polygons"] = report.result.surface.polygons.size();
  json["aggregate"] = to_word(report.model.layout.readout.aggregate);
  json["readings"] = Json::object();
  for (const auto& [how, values] : report.readings) json["readings"][std::string(to_word(how))] = values;
  json["shear"] = Json::array();
  for (const dvec2& s : report.shear) json["shear"].push_back({s.x, s.y});
  json["uncovered"] = {{"force", report.force.uncovered},
                       {"normal_force", numbers<Json>(report.X_WM.rotate(report.force.uncovered_normal))}};
  json["taxels"] = Json::array();
  for (std::size_t i = 0; i < report.behind.size(); ++i) {
    json["taxels"].push_back(taxel_object(report, i));
  }
  if (report.convergence) json["convergence"] = convergence_object(report.model, *report.convergence);
  return text_of(json);
}

}  // namespace taxel::cli
