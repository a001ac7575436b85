#include "core/sensor/layout_file_check.h"

#include <algorithm>

#include "core/hydro/fields/field_report.h"
#include "core/layout/file/layout_json.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

bool has_error(const Problems& problems) {
  return std::any_of(problems.begin(), problems.end(), [](const Problem& p) { return p.severity == Severity::error; });
}

}  // namespace

Problems check_layout_on_loaded_mesh(const Layout& layout, const LoadedMesh& loaded, const std::string& file) {
  SensorCache cache;
  SensorBuild how;
  how.cache = &cache;
  const RepairedMeshPtr repaired = repair_for(layout, loaded.mesh, cache, file);
  const SensorSkinPtr skin = cache.skin(repaired->mesh, layout.sampling.shells);
  Problems problems = check_layout_on_skin(layout, {*loaded.mesh, *repaired, *skin->sensed}, loaded.sha256, file);
  if (has_error(problems)) return problems;
  const SensorModelPtr model = build_sensor_model(layout, loaded.mesh, loaded.sha256, file, how);
  problems = model->problems;
  if (const auto* soft = std::get_if<SoftBody>(&model->body->geometry)) {
    for (Problem& p : field_problems(soft->field->report(), file, "/material")) {
      if (p.severity == Severity::note) problems.push_back(std::move(p));  // the model lists the others
    }
  }
  for (const Problems& found :
       {check_layout_mesh(*model->repaired, file), check_loaded_mesh(*model->loaded, *model->repaired, file)})
    problems.insert(problems.end(), found.begin(), found.end());
  for (const std::string& note : loaded.notes) {
    problems.push_back({file, "/mesh/file", Severity::note, "mesh_repaired", note, ""});
  }
  return problems;
}

Problems check_layout_file(const Layout& layout, const std::string& file) {
  Problems problems = check_layout_values(layout, file);
  LoadedMesh loaded;
  try {
    loaded = load_mesh(mesh_path(layout, file), layout.mesh.scale);
  } catch (const Error& e) {
    problems.push_back({file, "/mesh/file", Severity::error, "mesh_unreadable", e.what(), ""});
    return problems;
  }
  return has_error(problems) ? problems : check_layout_on_loaded_mesh(layout, loaded, file);
}

}  // namespace taxel
