#include "app/studio/nouns/inspector/layout_problems.h"

#include <algorithm>

#include "core/layout/check/layout_check.h"

namespace taxel::ui {

std::vector<std::size_t> LayoutProblems::of(int id) const {
  const auto found = of_taxel.find(id);
  return found == of_taxel.end() ? std::vector<std::size_t>{} : found->second;
}

Severity LayoutProblems::worst(int id) const {
  Severity worst = Severity::note;
  for (const std::size_t i : of(id)) worst = std::max(worst, list[i].severity);
  return worst;
}

LayoutProblems layout_problems(const ProjectPtr& project, const SensorModelPtr& model, bool compiled,
                               const std::string& mesh_sha256) {
  LayoutProblems problems;
  problems.project = project;
  problems.model = model;
  problems.compiled = compiled;
  const Layout& layout = project->layout;
  const auto add = [&](Problems found) {
    for (Problem& problem : found) {
      if (problem.code == "no_taxels") continue;  // normal for a layout that is being built
      const std::optional<std::size_t> index = taxel_of_pointer(problem.pointer);
      auto& where =
          index && *index < layout.taxels.size() ? problems.of_taxel[layout.taxels[*index].id] : problems.of_settings;
      where.push_back(problems.list.size());
      problems.list.push_back(std::move(problem));
    }
  };
  add(check_layout_values(layout, ""));
  add(check_layout_on_skin(layout, layout_mesh(*model), mesh_sha256, ""));
  if (!compiled || model->quality == SampleQuality::preview) return problems;
  Problems of_samples;
  for (const Problem& problem : model->problems)
    if (problem.code == kFieldWithoutSamples) of_samples.push_back(problem);
  add(std::move(of_samples));
  return problems;
}

}  // namespace taxel::ui
