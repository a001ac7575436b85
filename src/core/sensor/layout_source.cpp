#include "core/sensor/layout_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/hydro/fields/pressure_field.h"
#include "core/layout/file/imported_layout.h"
#include "core/layout/file/layout_json.h"
#include "core/sensor/sensor_model.h"

namespace taxel {
namespace {

std::string absolute_name(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

/// Reads a layout of the project's own format, on its own mesh or another one.
ImportedSource read_own_source(const std::filesystem::path& file, const SkinChoice& choice) {
  LayoutOfFile own = read_layout_of_file(file);
  ImportedSource read;
  read.notes = std::move(own.notes);
  SensorSource& source = read.source;
  source = {file.string(), std::move(own.layout), {}};
  if (!choice.mesh.empty()) {
    source.layout.mesh = {absolute_name(choice.mesh), source.layout.mesh.scale, "", source.layout.mesh.repair};
    read.notes.push_back("another mesh than the layout's is taken: " + choice.mesh);
  }
  source.layout.mesh.scale = choice.scale.value_or(source.layout.mesh.scale);
  throw_first_error(check_layout_values(source.layout, source.file));
  source.mesh = load_mesh(mesh_path(source.layout, file), source.layout.mesh.scale);
  if (!own.has_frame) {
    read.notes.push_back(take_frame_of(*source.mesh.mesh, source.layout));
    read.frame_is_guess = true;
  }
  return read;
}

}  // namespace

ImportedSource put_on_mesh(ImportedLayout imported, LoadedMesh mesh, const std::string& mesh_file, const dvec3& scale,
                           const std::string& layout_file) {
  put_on_skin(imported, mesh.mesh, layout_file);
  const bool frame_is_guess = !imported.has_frame && !imported.layout.taxels.empty();
  const Material& m = imported.layout.material;
  if (!imported.has_material)
    imported.notes.push_back(fmt::format(
        "the file holds no material: modulus {} Pa, thickness {} m, dissipation {} s/m, friction {} are taken",
        m.modulus, m.thickness, m.dissipation, m.friction));
  imported.layout.mesh = {mesh_file, scale, mesh.sha256};
  throw_first_error(check_layout_values(imported.layout, layout_file));
  return {{layout_file, std::move(imported.layout), std::move(mesh)}, std::move(imported.notes), frame_is_guess};
}

ImportedSource put_on_mesh_file(ImportedLayout imported, const std::filesystem::path& mesh_file,
                                const std::optional<dvec3>& scale, const std::string& layout_file) {
  if (scale)
    return put_on_mesh(std::move(imported), load_mesh(mesh_file, *scale), absolute_name(mesh_file), *scale,
                       layout_file);
  LoadedMesh mesh = load_mesh(mesh_file);
  const double guess = guess_scale(imported, *mesh.mesh);
  if (guess != 1) {
    mesh = load_mesh(mesh_file, dvec3(guess));
    imported.notes.push_back(fmt::format(
        "{} is taken with scale {}: {}", mesh_file.filename().string(), guess,
        imported.layout.taxels.empty() ? "its size is that of a sensor then" : "the taxels are on its surface then"));
  }
  return put_on_mesh(std::move(imported), std::move(mesh), absolute_name(mesh_file), dvec3(guess), layout_file);
}

ImportedSource read_any_source(const std::filesystem::path& layout_file, const SkinChoice& choice) {
  if (is_own_layout(layout_file)) {
    if (!choice.sensor.empty()) import_layout(layout_file, choice.sensor);  // says that there is no choice
    if (choice.unit) import_layout(layout_file, "", choice.unit);           // says that the unit is known
    return read_own_source(layout_file, choice);
  }
  ImportedLayout imported = import_layout(layout_file, choice.sensor, choice.unit);
  if (choice.mesh.empty() && !imported.layout.mesh.file.empty()) {
    const std::filesystem::path mesh = mesh_path(imported.layout, layout_file);
    const dvec3 scale = choice.scale.value_or(imported.layout.mesh.scale);
    return put_on_mesh_file(std::move(imported), mesh, scale, layout_file.string());
  }
  if (choice.mesh.empty())
    throw Error(layout_file.string(),
                "holds no mesh: name it with --mesh FILE, and its unit with --scale S (0.001 for millimetres)");
  return put_on_mesh_file(std::move(imported), choice.mesh, choice.scale, layout_file.string());
}

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
