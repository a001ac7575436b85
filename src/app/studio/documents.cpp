#include "app/studio/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "core/base/hash.h"
#include "core/layout/layout_json.h"
#include "core/mesh/formats/polygon_soup.h"
#include "core/mesh/mesh_io.h"
#include "core/project/project_json.h"

namespace taxel::studio {

std::string_view embedded_file(std::string_view name);

namespace {

/// Meshes with a larger diagonal, in their own units, are taken for millimetres [m].
constexpr double kLargestSensor = 5.0;
/// Samples of a bare mesh: enough to see, quick to make.
constexpr double kSamplesOfMesh = 20000;

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// "fingertip" of "dir/fingertip.taxels.json".
std::string short_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

std::vector<std::string> warnings_of(const SensorModel& model, bool of_samples) {
  std::vector<std::string> notes;
  for (const Problem& p : model.problems) {
    if (p.severity == Severity::warning && of_samples == (p.code == kFieldWithoutSamples))
      notes.push_back(fmt::format("{}: {}: {}", p.file, p.pointer, p.message));
  }
  return notes;
}

/// The project's layout on its mesh, as read from files.
Document compiled(DocumentKind kind, const std::filesystem::path& file, Project project, LoadedMesh mesh,
                  const SensorBuild& how) {
  const auto source =
      std::make_shared<const SensorSource>(SensorSource{file.string(), project.layout, std::move(mesh)});
  const auto compile = [source](const SensorBuild& build) { return build_sensor_model(*source, build); };
  Document document{kind, file.string(), short_name(file), compile(how), nullptr, source->mesh, {}, compile};
  document.project = std::make_shared<const Project>(std::move(project));
  if (!source->layout.name.empty()) document.name = source->layout.name;
  document.notes = warnings_of(*document.model, false);
  return document;
}

Document load_layout(const std::filesystem::path& file, const SensorBuild& how) {
  SensorSource source = read_sensor_source(file);
  Project project;
  project.layout = std::move(source.layout);
  project.layout.mesh.file = std::filesystem::absolute(mesh_path(project.layout, file)).lexically_normal().string();
  return compiled(DocumentKind::layout, file, std::move(project), std::move(source.mesh), how);
}

Document load_project(const std::filesystem::path& file, const SensorBuild& how) {
  Project project = read_project(file);
  throw_first_error(check_layout_values(project.layout, file.string()));
  LoadedMesh mesh = load_mesh(project.layout.mesh.file, project.layout.mesh.scale);
  return compiled(DocumentKind::project, file, std::move(project), std::move(mesh), how);
}

/// A density of one significant digit that gives a picture's worth of samples, at most the default.
double density_for(double area) {
  const double wanted = kSamplesOfMesh / area;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  return std::min(Sampling{}.density, std::floor(wanted / decade) * decade);
}

ProjectPtr project_of(const Layout& layout) {
  Project project;
  project.layout = layout;
  return std::make_shared<const Project>(std::move(project));
}

Document load_bare_mesh(const std::filesystem::path& file, const SensorBuild& how) {
  LoadedMesh loaded = load_mesh(file);
  const double unit = guessed_unit(loaded.mesh->bounds());
  if (unit != 1.0) loaded = load_mesh(file, dvec3(unit));
  if (how.progress != nullptr) how.progress->check(0.1);
  Layout layout;
  layout.name = short_name(file);
  layout.mesh = {std::filesystem::absolute(file).string(), dvec3(unit), loaded.sha256};
  layout.sampling.density = density_for(loaded.mesh->area());
  layout.material.thickness = 0;  // the default is for a fingertip; here the size decides
  const auto compile = [layout, mesh = loaded.mesh, file = file.string()](const SensorBuild& build) {
    return build_sensor_model(layout, mesh, layout.mesh.sha256, file, build);
  };
  Document document{DocumentKind::mesh, file.string(), layout.name, compile(how), nullptr, loaded, {}, compile};
  document.project = project_of(layout);
  const dvec3 size = 1e3 * loaded.mesh->bounds().extent();
  document.notes.push_back(fmt::format("{}: taken to be in {}: {:.4g} x {:.4g} x {:.4g} mm", file.string(),
                                       unit == 1.0 ? "metres" : "millimetres", size.x, size.y, size.z));
  for (const std::string& note : loaded.notes) document.notes.push_back(file.string() + ": " + note);
  return document;
}

}  // namespace

double guessed_unit(const Aabb& bounds) {
  return bounds.diagonal() > kLargestSensor ? 0.001 : 1.0;
}

DocumentKind document_kind(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (extension == ".json") return DocumentKind::layout;
  if (extension == ".taxelproj") return DocumentKind::project;
  if (extension == ".xml" || extension == ".mjcf") return DocumentKind::scene;
  if (is_mesh_file(file)) return DocumentKind::mesh;
  throw Error(file.string(),
              "cannot be opened: it is no project (.taxelproj), layout (.taxels.json), mesh (.obj .stl .ply .off .gltf "
              ".glb) or "
              "MuJoCo scene (.xml)");
}

Document load_document(const std::filesystem::path& file, const SensorBuild& how) {
  switch (document_kind(file)) {
    case DocumentKind::layout:
      return load_layout(file, how);
    case DocumentKind::project:
      return load_project(file, how);
    case DocumentKind::mesh:
      return load_bare_mesh(file, how);
    case DocumentKind::scene:
      break;
  }
  return {DocumentKind::scene, file.string(), short_name(file), nullptr, nullptr, LoadedMesh(), {}, nullptr};
}

Document built_in_fingertip(const SensorBuild& how) {
  const std::string layout_name = "fingertip.taxels.json";
  const BuiltInMesh obj = built_in_mesh();
  PolygonSoup soup = read_obj(obj.bytes, obj.name);
  LoadedMesh mesh;
  mesh.mesh = std::make_shared<const TriMesh>(std::move(soup.vertices), std::move(soup.triangles));
  mesh.sha256 = sha256_hex(obj.bytes);
  Layout layout = parse_layout(std::string(embedded_file("assets/layouts/" + layout_name)), layout_name);
  layout.mesh.file = obj.name;
  const auto compile = [layout, mesh, layout_name](const SensorBuild& build) {
    return build_sensor_model(layout, mesh.mesh, mesh.sha256, layout_name, build);
  };
  return {DocumentKind::layout, "", "Fingertip sweep", compile(how), project_of(layout), mesh, {}, compile};
}

BuiltInMesh built_in_mesh() {
  return {"fingertip.obj", embedded_file("assets/meshes/fingertip.obj")};
}

std::vector<std::string> notes_of_samples(const SensorModel& model) {
  return warnings_of(model, true);
}

}  // namespace taxel::studio
