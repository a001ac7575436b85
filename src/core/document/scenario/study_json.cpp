#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/document/scenario/scenario.h"
#include "core/document/scenario/study.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = JsonNode<Json>;

constexpr const char* kStudyFormat = "taxel-study";
constexpr int kStudyVersion = 1;

std::vector<double> read_values(const Node& node) {
  node.only({"parameter", "values", "from", "to", "count"});
  std::vector<double> values;
  if (const auto listed = node.find("values")) {
    for (const char* key : {"from", "to", "count"})
      if (node.find(key)) node.fail_at(key, "is not used together with values");
    for (std::size_t i = 0; i < listed->length(); ++i) values.push_back(listed->item(i).number());
    return values;
  }
  const double from = node.at("from").number(), to = node.at("to").number(), count = node.at("count").number();
  if (!(count >= 2 && count <= static_cast<double>(kMostRuns) && count == std::floor(count)))
    node.at("count").wrong(fmt::format("a whole number from 2 to {}", kMostRuns));
  for (double i = 0; i < count; ++i) {
    const double u = i / (count - 1);
    values.push_back((1 - u) * from + u * to);
  }
  return values;
}

}  // namespace

Study parse_study(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.only({"format", "version", "scenario", "parameters"});
  if (root.at("format").text() != kStudyFormat) root.at("format").wrong(std::string("\"") + kStudyFormat + "\"");
  const double version = root.at("version").number();
  if (version != kStudyVersion)
    root.fail_at("version", fmt::format("{} is unknown, this program reads version {}", version, kStudyVersion));
  const Node scenario = root.at("scenario");
  scenario.must_be_object();
  Study study;
  try {
    study.scenario = parse_scenario(json_line(scenario.json()));
  } catch (const Error& e) {
    throw Error(file, "/scenario" + e.where(), e.message());
  }
  const Node parameters = root.at("parameters");
  for (std::size_t i = 0; i < parameters.length(); ++i) {
    const Node node = parameters.item(i);
    node.must_be_object();
    study.parameters.push_back({node.at("parameter").text(), read_values(node)});
  }
  try {
    check_study(study);
  } catch (const Error& e) {
    throw Error(file, e.where(), e.message());
  }
  return study;
}

Study read_study(const std::filesystem::path& path) {
  Study study = parse_study(read_file(path), path.string());
  study.scenario = with_absolute_files(study.scenario, path);
  return study;
}

std::string study_to_json(const Study& study) {
  Json parameters = Json::array();
  for (const StudyParameter& parameter : study.parameters)
    parameters.push_back({{"parameter", parameter.key}, {"values", parameter.values}});
  return json_text(Json{{"format", kStudyFormat},
                        {"version", kStudyVersion},
                        {"scenario", Json::parse(scenario_to_json(study.scenario))},
                        {"parameters", parameters}});
}

}  // namespace taxel
