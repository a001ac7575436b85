// Problems of the edited layout, listed by taxel.
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
  ProjectPtr project;     ///< project with the problems, or null if nothing is edited
  SensorModelPtr model;   ///< model with the mesh that the problems refer to
  bool compiled = false;  ///< whether `model` was compiled from `project`, so samples are checked too
  Problems list;
  std::unordered_map<int, std::vector<std::size_t>> of_taxel;  ///< id -> indices in `list`
  std::vector<std::size_t> of_settings;                        ///< indices in `list` of all other problems

  /// Returns the indices in `list` of a taxel's problems; empty if there are none.
  [[nodiscard]] std::vector<std::size_t> of(int id) const;
  [[nodiscard]] Severity worst(int id) const;  ///< worst severity of the taxel, or `note` without problems
};

/// Returns every rule that the project breaks. If `model` was compiled from the project (`compiled`) and its samples
/// are polished, the list includes taxels that got no sample. Costs microseconds per taxel.
LayoutProblems layout_problems(const ProjectPtr& project, const SensorModelPtr& model, bool compiled,
                               const std::string& mesh_sha256);

}  // namespace taxel::ui
