#include <nlohmann/json.hpp>

#include "app/cli/samples_report.h"
#include "app/vector_json.h"

namespace taxel::cli {

std::string samples_json(const SamplesReport& report) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["layout"] = report.name;
  json["samples"] = report.samples;
  json["used"] = report.used;
  json["shared"] = report.shared;
  json["area"] = report.area;
  json["density"] = report.density;
  json["seed"] = report.seed;
  json["taxels"] = Json::array();
  for (const SamplesReport::Taxel& taxel : report.taxels) {
    json["taxels"].push_back({{"id", taxel.id}, {"name", taxel.name}, {"samples", taxel.samples}});
  }
  return text_of(json);
}

}  // namespace taxel::cli
