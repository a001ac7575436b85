#include "core/mesh/repair/repair.h"

#include <fmt/format.h>

namespace taxel {

RepairedMeshPtr repair_mesh(const TriMeshPtr& loaded, const RepairRecipe& /*recipe*/, double /*thickness*/,
                            const Progress* progress) {
  if (progress != nullptr) progress->stop_if_cancelled();
  auto repaired = std::make_shared<RepairedMesh>();
  repaired->mesh = loaded;
  RepairReport& report = repaired->report;
  report.closed = loaded->closed();
  report.faces_before = report.faces_after = loaded->face_count();
  report.shells_before = report.shells_after = loaded->shell_count();
  return repaired;
}

Problems repair_problems(const RepairReport& report, const std::string& file) {
  Problems problems;
  for (const RepairStep& step : report.steps)
    problems.push_back({file, "/mesh/file", step.severity, step.code, step.message, ""});
  return problems;
}

std::string repair_summary(const RepairReport& report) {
  std::string text;
  for (const RepairStep& step : report.steps) text += (text.empty() ? "" : "; ") + step.message;
  return text;
}

}  // namespace taxel
