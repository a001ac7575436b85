// What is wrong with the layout that is edited, by taxel, and what would mend it.
#pragma once

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/document/fixes.h"
#include "core/document/project.h"
#include "core/sensor/sensor_model.h"

namespace taxel::ui {

struct LayoutProblems {
  ProjectPtr project;     ///< that they are of; null: nothing is edited
  SensorModelPtr model;   ///< whose mesh they are about
  bool compiled = false;  ///< `model` is of `project`, and its samples are told about as well
  Problems list;
  std::unordered_map<int, std::vector<std::size_t>> of_taxel;  ///< id -> indices in `list`
  std::vector<std::size_t> of_settings;                        ///< all others

  /// Of a taxel; empty: none.
  [[nodiscard]] std::vector<std::size_t> of(int id) const;
  [[nodiscard]] Severity worst(int id) const;  ///< note where there are none
};

/// Every rule that the project breaks; where `model` was `compiled` of it, also taxels that got no sample, once samples
/// are polished. Costs microseconds per taxel.
LayoutProblems layout_problems(const ProjectPtr& project, const SensorModelPtr& model, bool compiled,
                               const std::string& mesh_sha256);

}  // namespace taxel::ui
