#include "app/studio/host/document/documents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/limits.h"
#include "core/base/parallel.h"
#include "core/base/text/message.h"
#include "core/document/project.h"
#include "core/document/scenario/scenario.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/sensor_frame.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/run/bundle/frame_bundle.h"
#include "core/run/recording/recording_files.h"
#include "core/sensor/layout_source.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

OpenMeshPtr read_open_mesh(const MeshRef& mesh, Progress* progress) {
  LoadedMesh loaded = load_mesh(mesh.file, mesh.scale, progress);
  MeshFindings findings = mesh_report(*loaded.mesh, loaded.notes);
  if (progress != nullptr) progress->stop_if_cancelled();
  return std::make_shared<const OpenMesh>(OpenMesh{std::move(loaded), std::move(findings)});
}

void OpenMeshes::clear() {
  const std::lock_guard lock(mutex_);
  meshes_.clear();
}

void OpenMeshes::add(const MeshRef& ref, OpenMeshPtr mesh) {
  const std::lock_guard lock(mutex_);
  std::erase_if(meshes_, [&](const auto& entry) { return same_file(entry.first, ref); });
  if (meshes_.size() >= kMost) meshes_.erase(meshes_.begin());
  meshes_.emplace_back(ref, std::move(mesh));
}

OpenMeshPtr OpenMeshes::find(const MeshRef& ref) const {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(meshes_.begin(), meshes_.end(), [&](const auto& entry) { return same_file(entry.first, ref); });
  return found == meshes_.end() ? nullptr : found->second;
}

OpenMeshPtr OpenMeshes::get(const MeshRef& ref) {
  if (OpenMeshPtr mesh = find(ref)) return mesh;
  OpenMeshPtr mesh = read_open_mesh(ref);
  add(ref, mesh);
  return mesh;
}

namespace {

/// Returns the model of a layout on a mesh, for viewing.
SensorModelPtr viewed_model(const Layout& layout, const TriMeshPtr& mesh) {
  SensorModel model = *bare_model(layout.name, mesh, nullptr);
  model.layout = layout;
  return std::make_shared<const SensorModel>(std::move(model));
}

/// Returns the model of a layout that is rigid and on the mesh as loaded, with the values of the layout.
SensorModelPtr rigid_model(const Layout& layout, const std::function<SensorModelPtr(const Layout&)>& compile) {
  Layout rigid = layout;
  rigid.material.modulus = 0;
  rigid.mesh.repair.level = RepairLevel::keep;
  SensorModel model = *compile(rigid);
  model.layout = layout;
  return std::make_shared<const SensorModel>(std::move(model));
}

}  // namespace

ShownModel shown_model(const Layout& layout, const TriMeshPtr& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile) {
  const bool is_soft = layout.material.compliant();
  const int triangles = mesh->face_count();
  if (is_soft && layout.taxels.empty() && triangles > kManySkinTriangles)
    return {viewed_model(layout, mesh),
            fmt::format("{} triangles: the pressure field follows with the first taxel ({:.1f} GiB), or first decimate "
                        "the mesh: taxel mesh --decimate",
                        triangles, triangles * kBytesPerSkinTriangle / (1U << 30U))};
  std::string problem;
  try {
    return {compile(layout), ""};
  } catch (const Error& e) {
    if (!is_soft || !e.where().starts_with("/mesh/")) throw;
    problem = shown_part(e.message());
  }
  return {rigid_model(layout, compile),
          fmt::format("The mesh is not closed: it can be edited, not simulated (Inspector > Mesh): {}", problem)};
}

std::string_view embedded_file(std::string_view name);

namespace {

/// Number of samples of a bare mesh: enough to see the surface, and quick to compute.
constexpr double kSamplesOfMesh = 20000;
/// Density of samples at which the readings of our fingertip jump [1/m^2].
constexpr double kSparseDensity = 1e5;
/// Speed of the sweep in which they jump [m/s]: one step is 0.05 mm, and the worst one takes a fifth of the reading of
/// a taxel. At 0.01 m/s the same fall takes thirty steps.
constexpr double kFastSweep = 0.05;

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Returns the short name "fingertip" of "dir/fingertip.taxels.json".
std::string short_name(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

std::vector<std::string> warnings_of(const SensorModel& model, bool of_samples) {
  std::vector<std::string> notes;
  for (const Problem& p : model.problems) {
    if (p.code == "mesh_changed") continue;       // reported elsewhere, with its remedies
    if (p.code.starts_with("repair_")) continue;  // part of LoadedDocument::repair
    if (p.severity == Severity::warning && of_samples == (p.code == kFieldWithoutSamples))
      notes.push_back(fmt::format("{}: {}: {}", p.file, shown_part(p.pointer), shown_part(p.message)));
  }
  return notes;
}

/// Lowers findings that a repair removes to notes: the mesh in use does not have them.
void tone_down(MeshFindings& findings, const RepairReport& report) {
  const bool united = std::any_of(report.steps.begin(), report.steps.end(), [](const RepairStep& step) {
    return step.code == "repair_united" || step.code == "repair_wrapped";
  });
  for (MeshFinding& finding : findings) {
    if (finding.code == "mesh_open" || finding.code == "mesh_nonmanifold" || finding.code == "mesh_winding" ||
        finding.code == "mesh_inverted")
      finding.severity = Severity::note;
    if (!united || (finding.code != "mesh_self_intersection" && finding.code != "mesh_shells")) continue;
    finding.severity = Severity::note;
    finding.meaning = "A repair unites the parts when the mesh is used (Inspector > Mesh); the file stays as it is.";
  }
}

using Compile = std::function<ShownModel(const SensorBuild&)>;

/// Compiles the layout and inspects the mesh: in parallel, or for a large mesh one after the other, so that both use
/// one tree of the faces.
std::pair<ShownModel, MeshFindings> compiled_and_inspected(const Compile& compile, const LoadedMesh& mesh,
                                                           const SensorBuild& how) {
  ShownModel shown;
  MeshFindings findings;
  if (mesh.mesh->face_count() <= kManySkinTriangles) {
    parallel_all([&] { shown = compile(how); }, [&] { findings = mesh_report(*mesh.mesh, mesh.notes); });
    return {std::move(shown), std::move(findings)};
  }
  shown = compile(how);
  if (how.progress != nullptr) how.progress->stop_if_cancelled();
  const MeshIndex& skin = *shown.model->skin;
  findings = skin.mesh_ptr() == mesh.mesh ? mesh_report(skin, mesh.notes) : mesh_report(*mesh.mesh, mesh.notes);
  return {std::move(shown), std::move(findings)};
}

/// Returns the document of a project on its mesh.
LoadedDocument document_of(DocumentKind kind, const std::filesystem::path& file, Project project, LoadedMesh mesh,
                           const Compile& compile, const SensorBuild& how) {
  LoadedDocument document{kind,    file.string(), project.layout.name, nullptr, nullptr, nullptr, "", {},
                          nullptr, nullptr};
  if (document.name.empty()) document.name = short_name(file);
  auto [shown, findings] = compiled_and_inspected(compile, mesh, how);
  if (how.progress != nullptr) how.progress->stop_if_cancelled();
  document.model = std::move(shown.model);
  document.repair = repair_summary(document.model->repaired->report);
  if (document.model->mesh != document.model->loaded) tone_down(findings, document.model->repaired->report);
  document.problem = std::move(shown.problem);
  document.mesh = std::make_shared<const OpenMesh>(OpenMesh{std::move(mesh), std::move(findings)});
  document.project = std::make_shared<const Project>(std::move(project));
  document.compile = [compile](const SensorBuild& build) { return compile(build).model; };
  return document;
}

/// Returns the document of a project's layout on its mesh, both as read from files.
LoadedDocument compiled(DocumentKind kind, const std::filesystem::path& file, Project project, LoadedMesh mesh,
                        const SensorBuild& how) {
  const auto source = std::make_shared<const SensorSource>(SensorSource{file.string(), project.layout, mesh});
  const Compile compile = [source](const SensorBuild& build) {
    return shown_model(source->layout, source->mesh.mesh, [&](const Layout& layout) {
      return build_sensor_model(SensorSource{source->file, layout, source->mesh}, build);
    });
  };
  LoadedDocument document = document_of(kind, file, std::move(project), std::move(mesh), compile, how);
  document.notes = warnings_of(*document.model, false);
  return document;
}

/// Prepends notes about the data that the document's file lacks to the notes about its mesh.
void add_notes_of(const ImportedSource& read, LoadedDocument& document) {
  const std::string name = std::filesystem::path(document.file).filename().string();
  std::vector<std::string> notes;
  for (const std::string& note : read.notes) notes.push_back(name + ": " + note);
  document.notes.insert(document.notes.begin(), notes.begin(), notes.end());
  document.frame_is_guess = read.frame_is_guess;
}

/// Throws MissingMesh if the mesh of a layout is not there.
void require_mesh(const std::string& mesh, const std::filesystem::path& layout_file) {
  std::error_code ignored;
  if (!std::filesystem::exists(mesh, ignored)) throw MissingMesh(layout_file.string(), mesh);
}

std::string absolute_mesh(const Layout& layout, const std::filesystem::path& file) {
  return std::filesystem::absolute(mesh_path(layout, file)).lexically_normal().string();
}

/// Removes the taxels that errors are about.
void remove_wrong_taxels(Layout& layout, const Problems& problems) {
  std::vector<bool> is_wrong(layout.taxels.size(), false);
  for (const Problem& problem : problems) {
    const std::optional<std::size_t> index = taxel_of_pointer(problem.pointer);
    if (problem.severity == Severity::error && index && *index < is_wrong.size()) is_wrong[*index] = true;
  }
  std::size_t next = 0;
  std::erase_if(layout.taxels, [&](const Taxel&) { return is_wrong[next++]; });
}

/// Returns a layout for viewing: without the taxels that have errors, or without all if that is not enough.
ShownModel model_to_mend(Layout layout, const LoadedMesh& mesh, const std::string& problem, SensorBuild how) {
  SensorCache own;  // the repaired mesh is needed twice
  if (how.cache == nullptr) how.cache = &own;
  try {
    remove_wrong_taxels(layout, check_layout_values(layout, ""));
    throw_first_error(check_layout_values(layout, ""));
    const RepairedMeshPtr repaired = repair_for(layout, mesh.mesh, *how.cache, layout.name);
    const SensorSkinPtr skin = how.cache->skin(repaired->mesh, layout.sampling.shells);
    remove_wrong_taxels(layout,
                        check_layout_on_skin(layout, {*mesh.mesh, *repaired, *skin->sensed}, mesh.sha256, layout.name));
    return {build_sensor_model(layout, mesh.mesh, mesh.sha256, layout.name, how), problem};
  } catch (const Error&) {
    layout.taxels.clear();
    return {viewed_model(layout, mesh.mesh), problem};
  }
}

/// Returns the document of a project whose layout has errors: it can be edited until it has none.
LoadedDocument document_to_mend(DocumentKind kind, const std::filesystem::path& file, Project project,
                                const std::string& problem, const SensorBuild& how) {
  LoadedMesh mesh = load_mesh(project.layout.mesh.file, project.layout.mesh.scale, how.progress);
  const Compile compile = [layout = project.layout, mesh, problem](const SensorBuild& build) {
    return model_to_mend(layout, mesh, problem, build);
  };
  return document_of(kind, file, std::move(project), std::move(mesh), compile, how);
}

/// Returns the text of an error in a layout that is opened all the same.
std::string text_to_mend(const Error& error) {
  return fmt::format("{}: {} (Inspector > Problems)", shown_part(error.where()), shown_part(error.message()));
}

LoadedDocument load_valid_layout(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how) {
  ImportedSource read = read_any_source(file, skin);
  Project project;
  project.layout = std::move(read.source.layout);
  project.layout.mesh.file = absolute_mesh(project.layout, file);
  LoadedDocument document = compiled(DocumentKind::layout, file, std::move(project), std::move(read.source.mesh), how);
  add_notes_of(read, document);
  document.skin = skin;
  return document;
}

/// Loads a layout of our own on its mesh, or on the one that the user chose because its own is missing. A layout with
/// errors is opened to be mended.
LoadedDocument load_layout(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how) {
  if (!is_own_layout(file)) return load_valid_layout(file, skin, how);
  Project project;
  project.layout = read_layout_of_file(file).layout;
  if (!skin.mesh.empty()) project.layout.mesh = {skin.mesh, project.layout.mesh.scale, "", project.layout.mesh.repair};
  project.layout.mesh.file = absolute_mesh(project.layout, file);
  require_mesh(project.layout.mesh.file, file);
  try {
    return load_valid_layout(file, skin, how);
  } catch (const Error& error) {
    if (error.where().empty() || error.where().starts_with("/mesh")) throw;
    LoadedDocument document =
        document_to_mend(DocumentKind::layout, file, std::move(project), text_to_mend(error), how);
    document.skin = skin;
    return document;
  }
}

/// Loads a layout of another program on the mesh that the user chose.
LoadedDocument load_foreign_layout(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how) {
  if (skin.mesh.empty()) throw Error(file.string(), "holds no mesh: drop its mesh file into the window as well");
  ImportedSource read = read_any_source(file, skin);
  Project project;
  project.layout = std::move(read.source.layout);
  LoadedDocument document = compiled(DocumentKind::layout, file, std::move(project), std::move(read.source.mesh), how);
  add_notes_of(read, document);
  document.skin = skin;
  return document;
}

/// Returns warnings about missing files that the project's scenario names and without which it cannot run.
std::vector<std::string> missing_files(const Project& project, const std::filesystem::path& file) {
  Scenario scenario = with_absolute_files(project.scenario, file);
  std::vector<std::string> notes;
  for (const auto& [field, named] : files_of(scenario)) {
    std::error_code ignored;
    if (!named->empty() && !std::filesystem::exists(*named, ignored))
      notes.push_back(
          fmt::format("{}: /scenario/{}: {}: no such file: the scenario cannot run", file.string(), field, *named));
  }
  return notes;
}

/// Loads a mesh as the first part of the work on a document. What follows shares the rest of the progress.
LoadedMesh load_in_part(const std::filesystem::path& file, const dvec3& scale, Progress* progress) {
  const ProgressPart part(progress, 0, fraction_of_loading(file));
  return load_mesh(file, scale, progress);
}

LoadedDocument load_valid_project(const std::filesystem::path& file, Project project, const SensorBuild& how) {
  throw_first_error(check_layout_values(project.layout, file.string()));
  LoadedMesh mesh = load_in_part(project.layout.mesh.file, project.layout.mesh.scale, how.progress);
  const std::vector<std::string> missing = missing_files(project, file);
  LoadedDocument document = compiled(DocumentKind::project, file, std::move(project), std::move(mesh), how);
  document.notes.insert(document.notes.end(), missing.begin(), missing.end());
  return document;
}

/// Loads a project on its mesh, or on the one that the user chose. A project with errors is opened to be mended.
LoadedDocument load_project(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how) {
  Project project = read_project(file);
  if (!skin.mesh.empty()) project.layout.mesh = {skin.mesh, project.layout.mesh.scale, "", project.layout.mesh.repair};
  require_mesh(project.layout.mesh.file, file);
  LoadedDocument document;
  try {
    document = load_valid_project(file, project, how);
  } catch (const Error& error) {
    if (error.where().empty() || error.where().starts_with("/mesh")) throw;
    document = document_to_mend(DocumentKind::project, file, std::move(project), text_to_mend(error), how);
  }
  document.skin = skin;
  return document;
}

/// Returns the mesh that load_mesh() would give with this scale.
LoadedMesh scaled(LoadedMesh mesh, double scale) {
  std::vector<dvec3> vertices = mesh.mesh->vertices();
  for (dvec3& vertex : vertices) vertex = vertex * scale;
  mesh.mesh = std::make_shared<const TriMesh>(std::move(vertices), mesh.mesh->faces());
  return mesh;
}

/// Returns the findings about a mesh, from reading and from inspection, as one line: those that are notes, or the
/// others.
std::string findings_text(const MeshFindings& findings, bool are_notes) {
  std::string text;
  for (const MeshFinding& finding : findings)
    if ((finding.severity == Severity::note) == are_notes) text += (text.empty() ? "" : "; ") + finding.what;
  return text;
}

LoadedDocument load_bare_mesh(const std::filesystem::path& file, const SensorBuild& how) {
  LoadedMesh mesh = load_in_part(file, dvec3(1.0), how.progress);
  const UnitGuess unit = guess_unit(*mesh.mesh);
  if (unit.scale != 1.0) mesh = scaled(std::move(mesh), unit.scale);
  Project project;
  Layout& layout = project.layout;
  layout.name = short_name(file);
  layout.readout.method = ReadingMethod::exact;  // files without the key are read by samples
  layout.mesh = {std::filesystem::absolute(file).lexically_normal().string(), dvec3(unit.scale), mesh.sha256};
  layout.frame = guess_frame(*mesh.mesh).value_or(layout.frame);
  layout.sampling.density = density_for(mesh.mesh->area());
  layout.material.thickness = 0;  // the default is for a fingertip; here the mesh's size decides
  const Compile compile = [whole = layout, ptr = mesh.mesh, name = file.string()](const SensorBuild& build) {
    return shown_model(whole, ptr, [&](const Layout& shown) {
      return build_sensor_model(shown, ptr, whole.mesh.sha256, name, build);
    });
  };
  const dvec3 size = 1e3 * mesh.mesh->bounds().extent();
  LoadedDocument document = document_of(DocumentKind::mesh, file, std::move(project), std::move(mesh), compile, how);
  // The mesh report shows the defects of a mesh that cannot be simulated.
  const bool repaired = document.model->mesh != document.model->loaded;
  document.frame_is_guess = true;
  const bool tells = document.problem.empty() && !repaired;
  const std::string found = tells ? findings_text(document.mesh->findings, false) : "";
  if (const std::string remarks = findings_text(document.mesh->findings, true); tells && !remarks.empty())
    document.remarks.push_back(file.filename().string() + ": " + remarks);
  document.notes.push_back(fmt::format(
      "{}: assumed unit: {}; size {:.4g} x {:.4g} x {:.4g} mm (Inspector > Mesh > Unit){}{}", file.filename().string(),
      unit.scale == 1.0 ? "m" : "mm", size.x, size.y, size.z, found.empty() ? "" : "; ", found));
  return document;
}

LoadedDocument load_frame(const std::filesystem::path& file, const SensorBuild& how) {
  const SimFramePtr frame = read_frame_bundle(file, how);
  const SensorModelPtr model = frame->scene->sensors.empty() ? nullptr : frame->scene->sensors.front();
  return {DocumentKind::frame,
          file.string(),
          short_name(file),
          model,
          nullptr,
          nullptr,
          "",
          {},
          nullptr,
          frame,
          "",
          read_archive_member(file, "state.json")};
}

}  // namespace

double density_for(double area) {
  const double wanted = kSamplesOfMesh / area;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  return std::min(Sampling{}.density, std::floor(wanted / decade) * decade);
}

namespace {

/// Returns the value of "format" near the start of a JSON file, or nothing.
std::string format_word(const std::filesystem::path& file) {
  constexpr std::size_t kStart = 300;
  constexpr std::string_view kKey = "\"format\"";
  const std::string start = read_start(file, kStart);
  const std::size_t key = start.find(kKey), open = start.find('"', key == std::string::npos ? key : key + kKey.size()),
                    end = open == std::string::npos ? open : start.find('"', open + 1);
  return end == std::string::npos ? "" : start.substr(open + 1, end - open - 1);
}

/// Returns the name of the first layout, or else of a scene, in the folder of a file. Empty if there is none.
std::string document_next_to(const std::filesystem::path& file) {
  std::string layout, scene;
  std::error_code error;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    std::string& found = name.ends_with(".taxels.json") ? layout : scene;
    const bool can_be_opened = &found == &layout || name.ends_with(".xml");
    if (can_be_opened && (found.empty() || name < found)) found = name;
  }
  return layout.empty() ? scene : layout;
}

/// Throws Error if a JSON file says that it is no layout.
void expect_layout(const std::filesystem::path& file) {
  const std::string format = format_word(file);
  const bool is_other = format.starts_with("taxel-") || format == "column-mapping" || format == "contact-case";
  if (!is_other || format == "taxel-layout") return;
  const std::string other = document_next_to(file);
  const bool has_scenario = format == "taxel-sweep" || format == "taxel-play" || format == "taxel-scenario";
  throw Error(file.string(), fmt::format("is no layout: its format is \"{}\". {}{}", format,
                                         other.empty() ? "Open the layout" : "Open " + other + " next to it",
                                         has_scenario ? "; --scenario FILE runs its scenario" : ""));
}

}  // namespace

DocumentKind document_kind(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  if (needs_mesh(file)) return DocumentKind::layout;
  if (extension == ".json") {
    expect_layout(file);
    return DocumentKind::layout;
  }
  if (extension == ".taxelproj") return DocumentKind::project;
  if (extension == ".xml" || extension == ".mjcf") return DocumentKind::scene;
  if (extension == kFrameBundleExtension) return DocumentKind::frame;
  if (is_mesh_file(file)) return DocumentKind::mesh;
  throw Error(
      file.string(),
      "cannot be opened: it is no project (.taxelproj), layout (.taxels.json, .yaml, .csv, .urdf, .npz, .txt), mesh (" +
          extensions(can_read) + "), MuJoCo scene (.xml), saved step (.taxelframe) or batch (batch.json)");
}

bool needs_mesh(const std::filesystem::path& file) {
  return is_foreign_layout(file) && !layout_format_of(file)->is_refused;
}

LoadedDocument load_document(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how) {
  switch (document_kind(file)) {
    case DocumentKind::layout:
      return needs_mesh(file) ? load_foreign_layout(file, skin, how) : load_layout(file, skin, how);
    case DocumentKind::project:
      return load_project(file, skin, how);
    case DocumentKind::mesh:
      return load_bare_mesh(file, how);
    case DocumentKind::frame:
      return load_frame(file, how);
    case DocumentKind::scene:
      break;
  }
  return {DocumentKind::scene, file.string(), short_name(file), nullptr, nullptr, nullptr, "", {}, nullptr, nullptr};
}

LoadedDocument document_in_memory(Layout layout, LoadedMesh mesh, const SensorBuild& how) {
  Project project;
  project.layout = std::move(layout);
  const Compile compile = [layout = project.layout, mesh](const SensorBuild& build) {
    return ShownModel{build_sensor_model(layout, mesh.mesh, mesh.sha256, layout.name, build), ""};
  };
  return document_of(DocumentKind::layout, "", std::move(project), std::move(mesh), compile, how);
}

LoadedDocument built_in_fingertip(const SensorBuild& how, bool jumps) {
  const std::string layout_name = "fingertip.taxels.json";
  const BuiltInMesh obj = built_in_mesh();
  Layout layout = parse_layout(std::string(embedded_file("assets/layouts/" + layout_name)), layout_name);
  layout.mesh.file = obj.name;
  if (jumps) {
    layout.name = "Fingertip, few samples";
    layout.sampling.density = kSparseDensity;
    layout.sampling.weights = SampleWeights::equal;
    layout.material.field = FieldKind::star;
  }
  LoadedDocument document = document_in_memory(std::move(layout), read_mesh(obj.bytes, obj.name), how);
  document.name = jumps ? "The jumping taxel" : "Fingertip sweep";
  if (jumps) document.scenario.emplace().as<scenarios::Sweep>().speed = kFastSweep;
  return document;
}

BuiltInMesh built_in_mesh() {
  return {"fingertip.obj", embedded_file("assets/meshes/fingertip.obj")};
}

std::vector<std::string> notes_of_samples(const SensorModel& model) {
  return warnings_of(model, true);
}

std::optional<std::filesystem::path> batch_folder(const std::filesystem::path& path) {
  if (path.empty()) return std::nullopt;
  constexpr const char* kBatchFile = "batch.json";
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored).lexically_normal();
  if (absolute.filename() == kBatchFile) return absolute.parent_path();
  const std::filesystem::path folder = absolute.has_filename() ? absolute : absolute.parent_path();
  for (const char* name : {kBatchFile, ".batch"})
    if (std::filesystem::exists(folder / name, ignored)) return folder;
  return std::nullopt;
}

}  // namespace taxel::studio
