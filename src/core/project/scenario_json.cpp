#include "core/project/scenario_json.h"

#include <array>
#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/project/strict_json.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Node = StrictNode<Json>;

enum class Range { positive, not_negative, any };
struct Parameter {
  const char* key;
  double SweepScenario::*value;
  Range range;
};
constexpr std::array<Parameter, 9> kParameters{{{"depth", &SweepScenario::depth, Range::positive},
                                                {"speed", &SweepScenario::speed, Range::positive},
                                                {"before", &SweepScenario::before, Range::not_negative},
                                                {"past", &SweepScenario::past, Range::not_negative},
                                                {"tilt_deg", &SweepScenario::tilt_deg, Range::any},
                                                {"record_every", &SweepScenario::record_every, Range::positive},
                                                {"timestep", &SweepScenario::timestep, Range::positive},
                                                {"finger_mass", &SweepScenario::finger_mass, Range::positive},
                                                {"box_size", &SweepScenario::box_size, Range::positive}}};

void check_range(const Node& node, double value, Range range) {
  if (!std::isfinite(value)) node.fail(fmt::format("must be finite, is {}", value));
  if (range == Range::positive) node.must_be_positive(value);
  if (range == Range::not_negative) node.must_not_be_negative(value);
}

Json to_object(const SweepScenario& scenario) {
  Json object = Json::object();
  for (const Parameter& parameter : kParameters) object[parameter.key] = scenario.*parameter.value;
  object["object"] = scenario.object;
  return object;
}

}  // namespace

std::string scenario_to_json(const SweepScenario& scenario) {
  return to_object(scenario).dump();
}

SweepScenario parse_scenario(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const Node root(json, file);
  root.must_be_object();
  const Node node = root.find("scenario").value_or(root);
  node.only({"depth", "speed", "before", "past", "tilt_deg", "record_every", "timestep", "finger_mass", "box_size",
             "object"});
  SweepScenario scenario;
  for (const Parameter& parameter : kParameters) {
    if (const auto number = node.find(parameter.key)) {
      scenario.*parameter.value = number->number();
      check_range(*number, scenario.*parameter.value, parameter.range);
    }
  }
  if (const auto object = node.find("object")) scenario.object = object->text();
  try {
    check_scenario(scenario);
  } catch (const Error& e) {
    throw Error(file, node.pointer() + e.where(), e.message());
  }
  return scenario;
}

SweepScenario read_scenario(const std::filesystem::path& path) {
  return parse_scenario(read_file(path), path.string());
}

void check_scenario(const SweepScenario& scenario) {
  const Json json = to_object(scenario);
  const std::string file;
  const Node node(json, file);
  for (const Parameter& parameter : kParameters) {
    const Node value = node.at(parameter.key);
    check_range(value, value.number(), parameter.range);
  }
  if (!(scenario.before + scenario.past > 0)) node.fail_at("past", "before and past together must be greater than 0");
}

}  // namespace taxel
