#include "core/document/scenario/scenario.h"

#include <algorithm>

#include "core/base/text/field_spec.h"

namespace taxel {
namespace {

/// Keys of numbers in the order of files. Keys that are not listed follow in the order of the inspector.
constexpr std::string_view kFileOrder[] = {
    "depth",       "speed",    "before",        "past",   "tilt_deg",  "record_every",   "timestep",
    "finger_mass", "box_size", "edge_radius",   "place",  "clearance", "hold",           "angle_deg",
    "rate_deg",    "distance", "direction_deg", "height", "duration",  "record_interval"};

auto file_order(std::string_view key) {
  return std::find(std::begin(kFileOrder), std::end(kFileOrder), key) - std::begin(kFileOrder);
}

bool has_poses(const Scenario& scenario) {
  return std::visit([](const auto& motion) { return std::remove_cvref_t<decltype(motion)>::kHasPoses; },
                    scenario.motion);
}

/// Returns `from` as another kind, with the remaining values of `last`, a scenario of that kind.
Scenario converted(const Scenario& from, const Scenario& last) {
  Scenario usual_from = default_scenario(from.kind()), usual = default_scenario(last.kind()), made = from;
  const bool has_default_object = from.object.empty() && from.shape == usual_from.shape;
  if ((has_default_object && !has_poses(last)) || !has_object(last)) {
    made.shape = usual.shape;
    made.object.clear();
  }
  made.motion = with_shape(last, made.shape).motion;
  for (const ScenarioNumber& number : numbers_of(made)) {
    const std::string_view key = number.field.key;
    const double *value = find_number(from, key), *before = find_number(usual_from, key);
    const double* after = find_number(usual, key);
    if (value != nullptr && before != nullptr && after != nullptr) *number.value = *value == *before ? *after : *value;
  }
  return made;
}

}  // namespace

std::vector<ScenarioNumber> numbers_of(Scenario& scenario) {
  std::vector<ScenarioNumber> numbers;
  visit_fields(scenario, [&](const FieldSpec& field, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>) numbers.push_back({field, &value});
  });
  std::stable_sort(numbers.begin(), numbers.end(), [](const ScenarioNumber& a, const ScenarioNumber& b) {
    return file_order(a.field.key) < file_order(b.field.key);
  });
  return numbers;
}

double* find_number(Scenario& scenario, std::string_view key) {
  for (const ScenarioNumber& number : numbers_of(scenario))
    if (number.field.key == key) return number.value;
  return nullptr;
}

std::vector<std::pair<std::string, std::string*>> files_of(Scenario& scenario) {
  std::vector<std::pair<std::string, std::string*>> files{{"object", &scenario.object}};
  visit_fields(scenario, [&](const FieldSpec& field, auto& value) {
    if constexpr (std::is_same_v<decltype(value), std::string&>) files.emplace_back(field.key, &value);
  });
  return files;
}

bool has_object(const Scenario& scenario) {
  return std::visit([](const auto& motion) { return std::remove_cvref_t<decltype(motion)>::kHasObject; },
                    scenario.motion);
}

ObjectShape default_shape(ScenarioKind kind) {
  return default_scenario(kind).shape;
}

Scenario default_scenario(ScenarioKind kind) {
  Scenario scenario;
  scenario.motion = each_alternative<ScenarioMotion>()[static_cast<std::size_t>(kind)];
  scenario.shape =
      std::visit([](const auto& motion) { return std::remove_cvref_t<decltype(motion)>::kShape; }, scenario.motion);
  return scenario;
}

Scenario with_shape(Scenario scenario, ObjectShape shape) {
  std::visit([&](auto& motion) { motion.follow_shape(scenario.shape, shape); }, scenario.motion);
  scenario.shape = shape;
  scenario.object.clear();
  return scenario;
}

Scenario with_object(Scenario scenario, const std::string& file) {
  scenario = with_shape(std::move(scenario), ObjectShape::box);
  scenario.object = file;
  return scenario;
}

Scenario with_kind(const Scenario& scenario, ScenarioKind kind, LastScenarios& last) {
  for (const auto& word : words_of(kind)) {
    Scenario& of_kind = last.try_emplace(word.value, default_scenario(word.value)).first->second;
    of_kind = word.value == scenario.kind() ? scenario : converted(scenario, of_kind);
  }
  return last.at(kind);
}

Scenario with_kind(const Scenario& scenario, ScenarioKind kind) {
  return kind == scenario.kind() ? scenario : converted(scenario, default_scenario(kind));
}

}  // namespace taxel
