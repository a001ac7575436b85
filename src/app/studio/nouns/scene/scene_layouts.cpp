// Commands about the layouts on the geoms of an open scene.
#include "app/studio/nouns/scene/scene_layouts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/document/document_files.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/files/files_state.h"
#include "app/studio/nouns/files/watched_files.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/probe/probe_state.h"
#include "app/studio/nouns/scene/controls_state.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/formats/layout_format.h"
#include "core/layout/sensor_frame.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::studio {
namespace {

namespace fs = std::filesystem;

/// Returns the scene that the simulation has, or null if the document is no scene.
const SimScene* open_scene(const Host& host) {
  const bool is_open = host.document.kind() == DocumentKind::scene && host.run.frame && host.run.frame->simulated;
  return is_open && host.run.scene.is_of_document ? host.run.frame->simulated.get() : nullptr;
}

const SceneGeom* find_geom(const SimScene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.geoms.begin(), scene.geoms.end(), [&](const SceneGeom& geom) { return geom.name == name; });
  return found == scene.geoms.end() ? nullptr : &*found;
}

bool has_taxels(const SimScene& scene, const SceneGeom& geom) {
  return geom.sensor >= 0 && scene.sensors[at(geom.sensor)]->taxel_count() > 0;
}

SceneAttachment* attachment_of(Run& run, const std::string& geom) {
  const auto found = std::find_if(run.scene.attached.begin(), run.scene.attached.end(),
                                  [&](const SceneAttachment& one) { return one.geom == geom; });
  return found == run.scene.attached.end() ? nullptr : &*found;
}

bool exists(const std::string& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

/// Returns the path of a file next to the scene that does not exist and that no attached layout will be written to:
/// "STEM.taxels.json", "STEM-1.taxels.json" and so on.
std::string free_file(const Host& host, const std::string& name, const std::string& extension) {
  const fs::path folder = fs::absolute(host.document.file()).parent_path();
  const std::string stem = suggested_file("", name, "").name;
  for (int number = 0;; ++number) {
    const std::string number_text = number == 0 ? "" : fmt::format("-{}", number);
    std::string file = (folder / (stem + number_text + extension)).lexically_normal().string();
    const auto& attached = host.run.scene.attached;
    const bool is_taken =
        std::any_of(attached.begin(), attached.end(), [&](const SceneAttachment& one) { return one.layout == file; });
    if (!is_taken && !exists(file)) return file;
  }
}

/// Returns the surface of a geom in the frame of its mesh file.
TriMesh surface_of(const SceneGeom& geom) {
  const RigidTransform X_MG(geom.skin.X_GM.inverse());
  std::vector<dvec3> vertices;
  for (const dvec3& p_G : geom.mesh->vertices()) vertices.push_back(X_MG(p_G));
  return {std::move(vertices), geom.mesh->faces()};
}

/// Returns a mesh that is not in a file as if it were read from the file that saving writes.
OpenMeshPtr mesh_in_memory(const TriMesh& mesh) {
  const std::string bytes = write_obj(mesh);
  LoadedMesh loaded = read_mesh(bytes, "mesh.obj");
  MeshFindings findings = mesh_report(*loaded.mesh, loaded.notes);
  return std::make_shared<const OpenMesh>(OpenMesh{std::move(loaded), std::move(findings)});
}

/// Sets everything about the mesh of a new layout, and returns the mesh if it is not in a file.
OpenMeshPtr put_on(const Host& host, const SceneGeom& geom, Layout& layout) {
  const TriMesh surface = surface_of(geom);
  layout.frame = guess_frame(surface).value_or(layout.frame);
  layout.sampling.density = density_for(surface.area());
  if (!geom.skin.file.empty()) {
    layout.mesh = {geom.skin.file, geom.skin.scale, sha256_hex(read_file(geom.skin.file))};
    return nullptr;
  }
  OpenMeshPtr mesh = mesh_in_memory(surface);
  layout.mesh = {free_file(host, layout.name, ".obj"), dvec3(1), mesh->loaded.sha256};
  return mesh;
}

/// Turns the camera of LAYOUT to the pad, a little from above, so that the middle of the view, where a generated
/// pattern begins, is the middle of the pad.
void turn_to_pad(ui::Viewer& viewer, const dvec3& pad) {
  constexpr double kAbove = 10, kMaxElevation = 80;  // [degrees]
  constexpr double kMinLevelPart = 1e-3;  // below it, the pad faces up or down and gives no direction to look from
  ui::Camera& camera = viewer.cameras[0];
  if (std::hypot(pad.x, pad.y) > kMinLevelPart) camera.azimuth_deg = glm::degrees(std::atan2(pad.y, pad.x));
  const double elevation = glm::degrees(std::asin(std::clamp(pad.z, -1.0, 1.0)));
  camera.elevation_deg = std::clamp(elevation + kAbove, -kMaxElevation, kMaxElevation);
}

/// Displays the layout that is edited from now on. Tools and selections of the previous one end.
void show_layout(Host& host, bool is_guess) {
  ui::App& app = host.app;
  host.handover.forget_request();
  app.ui->fields.refused.reset();
  app.viewer->selection.clear();
  app.viewer->clip.reset();
  app.get<ui::ToolState>() = {};
  app.get<ui::GenerateState>() = {};
  app.get<ui::MeasureState>() = {};
  app.get<ui::MeshState>() = {};
  app.get<ui::MeshState>().frame_is_guess = is_guess;
  static_cast<ui::PlacedProbe&>(app.get<ui::ProbeState>()) = {};
  carry_out(ui::SetMode{ui::Mode::layout}, host);
  turn_to_pad(*app.viewer, host.edits().project()->layout.frame.pad);
  app.get<ui::Framing>().turns[0] = true;
}

/// Ends editing. Edits that are not saved are discarded: the sensors read by the file again, or have no layout.
void leave(Host& host) {
  if (!host.document.scene_layout) return;
  const bool discards = host.edits().dirty();
  const std::vector<std::string> geoms = host.document.scene_layout->geoms;
  leave_layout_of_scene(host.document);
  host.handover.forget_request();
  host.app.get<ui::ToolState>() = {};
  host.app.get<ui::GenerateState>() = {};
  if (!discards) return;
  std::vector<SceneAttachment> attachments = host.run.scene.attached;
  const auto is_of_layout = [&](const SceneAttachment& one) {
    return std::find(geoms.begin(), geoms.end(), one.geom) != geoms.end();
  };
  std::erase_if(attachments, [&](const SceneAttachment& one) {
    return is_of_layout(one) && (one.is_declared || !exists(one.layout));
  });
  for (SceneAttachment& one : attachments)
    if (is_of_layout(one)) one.model = nullptr;
  const bool any_declared =
      std::any_of(geoms.begin(), geoms.end(), [&](const std::string& geom) { return is_declared(host.run, geom); });
  if (any_declared || attachments != host.run.scene.attached)
    build_scene_again(host.run, host.document, std::move(attachments), false);
}

void report_error(Host& host, const Error& error) {
  host.report(Severity::error, shown_message(error));
}

/// Returns the mesh of a sensor that is in the scene: from its file if there is one, so that the faces of the file are
/// known.
OpenMeshPtr mesh_of(const SensorModel& model, const MeshRef& ref) {
  if (exists(ref.file)) return read_open_mesh(ref);
  LoadedMesh loaded;
  loaded.mesh = model.loaded;
  loaded.sha256 = ref.sha256;
  for (int face = 0; face < loaded.mesh->face_count(); ++face) loaded.file_face_of.push_back(face);
  MeshFindings findings = mesh_report(*loaded.mesh, {});
  return std::make_shared<const OpenMesh>(OpenMesh{std::move(loaded), std::move(findings)});
}

/// Returns the geoms of the sensors that read by the layout of `sensor`, whose own geom is the first.
std::vector<std::string> geoms_of_layout(const SimScene& scene, int sensor) {
  const std::string &own = scene.sensor_geoms[at(sensor)], &file = scene.sensor_layouts[at(sensor)];
  std::vector<std::string> geoms{own};
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    const bool is_same_file = !file.empty() && scene.sensor_layouts[i] == file;
    if ((is_same_file || scene.sensors[i] == scene.sensors[at(sensor)]) && scene.sensor_geoms[i] != own)
      geoms.push_back(scene.sensor_geoms[i]);
  }
  return geoms;
}

/// Begins to edit the layout of a sensor. A layout in a format of another program gets a file of its own.
void edit_sensor(Host& host, const SimScene& scene, int sensor) {
  const std::string& geom = scene.sensor_geoms[at(sensor)];
  const SensorModelPtr model = scene.sensors[at(sensor)];
  const SceneAttachment* attached = attachment_of(host.run, geom);
  std::error_code ignored;
  std::string file = attached != nullptr ? fs::absolute(attached->layout, ignored).lexically_normal().string()
                                         : scene.sensor_layouts[at(sensor)];
  Project project;
  project.layout = model->layout;
  MeshRef& mesh = project.layout.mesh;
  const bool is_own = !file.empty() && is_own_layout(file);
  if (is_own) mesh.file = fs::absolute(mesh_path(project.layout, file), ignored).lexically_normal().string();
  if (!is_own) file = free_file(host, project.layout.name.empty() ? geom : project.layout.name, ".taxels.json");
  if (!exists(mesh.file))
    mesh = {free_file(host, geom, ".obj"), dvec3(1), sha256_hex(write_obj(*model->loaded)), mesh.repair};
  const bool is_text = attached == nullptr && scene.sensor_layouts[at(sensor)].empty();
  const std::vector<std::string> geoms = geoms_of_layout(scene, sensor);
  if (geoms.size() > 1)
    host.report(Severity::note, fmt::format("{} have this layout, and change with it.", fmt::join(geoms, ", ")));
  OpenMeshPtr open_mesh = mesh_of(*model, mesh);
  leave(host);
  edit_layout_of_scene(host.document, {file, geoms, exists(file), is_text},
                       std::make_shared<const Project>(std::move(project)), std::move(open_mesh), model);
  host.app.viewer->selection.sensor = sensor;
  show_layout(host, false);
}

/// Returns why there can be no new layout on a geom, or an empty text.
std::string why_no_layout(const SimScene& scene, const std::string& name) {
  if (name.empty())
    return "No geom is chosen: double-click one in the view, or click one in the outliner, then make the layout.";
  const SceneGeom* geom = find_geom(scene, name);
  if (geom == nullptr) return fmt::format("The scene has no geom {}.", name);
  if (geom->skin.problem.empty()) return {};
  return fmt::format(
      "No layout can be on geom {} of body {}: it {}. Choose a mesh, box, sphere, capsule, cylinder or "
      "ellipsoid.",
      name, geom->body, geom->skin.problem);
}

void make_layout(Host& host, const SceneGeom& geom) {
  Project project;
  Layout& layout = project.layout;
  layout.name = geom.body == "world" ? geom.name : geom.body;
  layout.readout.method = ReadingMethod::exact;  // files without the key are read by samples
  layout.material.thickness = 0;                 // the size of the mesh decides
  OpenMeshPtr mesh = put_on(host, geom, layout);
  const std::string file = free_file(host, layout.name, ".taxels.json");
  leave(host);
  edit_layout_of_scene(host.document, {file, {geom.name}, false}, std::make_shared<const Project>(std::move(project)),
                       std::move(mesh), nullptr);
  show_layout(host, true);
  host.report(Severity::note, fmt::format("New layout on {}: Ctrl+click places a taxel, Ctrl+G generates a pattern. "
                                          "SIMULATE feels with it as soon as it has a taxel.",
                                          geom.shown_name()));
}

bool same_surface(const SceneGeom& a, const SceneGeom& b) {
  if (!a.skin.file.empty() || !b.skin.file.empty()) return a.skin.file == b.skin.file && a.skin.scale == b.skin.scale;
  return a.mesh->faces() == b.mesh->faces() && a.mesh->vertices() == b.mesh->vertices();
}

/// Returns one geom for each other body that has a geom with the mesh of `source` and no taxels on such a geom. Of two
/// geoms of one body, the one in the group of `source` is taken.
std::vector<std::string> geoms_with_same_mesh(const SimScene& scene, const SceneGeom& source) {
  std::vector<const SceneGeom*> found;
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.body_index == source.body_index || !geom.skin.problem.empty() || !same_surface(geom, source)) continue;
    const auto of_body = std::find_if(found.begin(), found.end(),
                                      [&](const SceneGeom* one) { return one->body_index == geom.body_index; });
    if (of_body == found.end()) {
      found.push_back(&geom);
    } else if (has_taxels(scene, geom) || ((*of_body)->group != source.group && !has_taxels(scene, **of_body))) {
      *of_body = &geom;
    }
  }
  std::vector<std::string> names;
  for (const SceneGeom* geom : found)
    if (!has_taxels(scene, *geom)) names.push_back(geom->name);
  return names;
}

void add_geom(ui::SceneLayout& layout, const std::string& geom) {
  if (std::find(layout.geoms.begin(), layout.geoms.end(), geom) == layout.geoms.end()) layout.geoms.push_back(geom);
}

/// Adds attachments of the layout of a sensor that is not edited.
void attach_running(Host& host, const SimScene& scene, int sensor, const std::vector<std::string>& geoms) {
  const SceneAttachment* own = attachment_of(host.run, scene.sensor_geoms[at(sensor)]);
  SceneAttachment attachment = own != nullptr ? *own : SceneAttachment{"", scene.sensor_layouts[at(sensor)]};
  if (attachment.layout.empty())
    return host.report(Severity::error, fmt::format("The layout on {} is in no file: edit it first, then attach it.",
                                                    scene.sensor_geoms[at(sensor)]));
  attachment.model = scene.sensors[at(sensor)];
  attachment.skin = {};
  attachment.is_declared = false;
  std::vector<SceneAttachment> attachments = attachments_with_edits(host.run, host.document);
  for (const std::string& geom : geoms) {
    attachment.geom = geom;
    attachments.push_back(attachment);
  }
  build_scene_again(host.run, host.document, std::move(attachments), false);
}

}  // namespace

void carry_out(const ui::NewLayoutOnGeom& command, Host& host) {
  const SimScene* scene = open_scene(host);
  if (scene == nullptr) return;
  const std::vector<std::string>& chosen = host.app.get<ui::ControlsState>().geoms;
  const std::string name = command.geom.empty() && !chosen.empty() ? chosen.front() : command.geom;
  if (const std::string why = why_no_layout(*scene, name); !why.empty())
    return host.report(Severity::error, why, ui::Holds::for_document);
  const SceneGeom& geom = *find_geom(*scene, name);
  try {
    has_taxels(*scene, geom) ? edit_sensor(host, *scene, geom.sensor) : make_layout(host, geom);
  } catch (const Error& error) {
    report_error(host, error);
  }
}

void carry_out(const ui::EditSensorLayout& command, Host& host) {
  const SimScene* scene = open_scene(host);
  const int sensor = command.sensor >= 0 ? command.sensor : host.app.viewer->selection.sensor;
  if (scene == nullptr || sensor < 0 || at(sensor) >= scene->sensors.size()) return;
  if (!leaves_scene_layout(command, host) && host.document.scene_layout)
    return carry_out(ui::SetMode{ui::Mode::layout}, host);
  if (scene->sensors[at(sensor)]->taxel_count() == 0)
    return carry_out(ui::NewLayoutOnGeom{scene->sensor_geoms[at(sensor)]}, host);
  try {
    edit_sensor(host, *scene, sensor);
  } catch (const Error& error) {
    report_error(host, error);
  }
}

void carry_out(const ui::AttachToSameMesh&, Host& host) {
  const SimScene* scene = open_scene(host);
  if (scene == nullptr) return;
  const std::optional<ui::SceneLayout>& edited = host.document.scene_layout;
  const int sensor = host.app.viewer->selection.sensor;
  const bool has_sensor = sensor >= 0 && at(sensor) < scene->sensors.size();
  if (!edited && !has_sensor) return;
  const std::string name = edited ? edited->geoms.front() : scene->sensor_geoms[at(sensor)];
  const SceneGeom* source = find_geom(*scene, name);
  if (source == nullptr) return host.report(Severity::error, fmt::format("The scene has no drawn geom {}.", name));
  const std::vector<std::string> geoms = geoms_with_same_mesh(*scene, *source);
  if (geoms.empty())
    return host.report(Severity::note,
                       fmt::format("No other body has a geom with the mesh of {} and without a layout.", name));
  if (!edited) {
    attach_running(host, *scene, sensor, geoms);
  } else {
    for (const std::string& geom : geoms) add_geom(*host.document.scene_layout, geom);
    std::vector<SceneAttachment> attachments = attachments_with_edits(host.run, host.document);
    if (attachments != host.run.scene.attached)
      build_scene_again(host.run, host.document, std::move(attachments), false);
  }
  const bool is_empty = edited && host.edits().project()->layout.taxels.empty();
  host.report(Severity::note,
              fmt::format("The layout on {} is {} {}.", name, is_empty ? "with its first taxel also on" : "also on",
                          fmt::join(geoms, ", ")));
}

void carry_out(const ui::LeaveLayout&, Host& host) {
  leave(host);
  host.app.get<ui::Framing>().turns[0] = true;
}

bool leaves_scene_layout(const ui::Command& command, const Host& host) {
  const std::optional<ui::SceneLayout>& edited = host.document.scene_layout;
  const SimScene* scene = open_scene(host);
  if (!edited || scene == nullptr) return false;
  const auto is_edited = [&](const std::string& geom) {
    return std::find(edited->geoms.begin(), edited->geoms.end(), geom) != edited->geoms.end();
  };
  if (const auto* edit = command.get_if<ui::EditSensorLayout>()) {
    const int sensor = edit->sensor >= 0 ? edit->sensor : host.app.viewer->selection.sensor;
    return sensor >= 0 && at(sensor) < scene->sensors.size() && !is_edited(scene->sensor_geoms[at(sensor)]);
  }
  return command.is<ui::NewLayoutOnGeom>() || command.is<ui::LeaveLayout>();
}

namespace {

/// Lets the scene's file name a layout file in place of the text of the layout.
void name_layout_in_scene(Host& host, const std::vector<std::string>& geoms, const std::string& file) {
  NameLayoutCommand command{host.document.file(), {}, file};
  for (const std::string& geom : geoms)
    if (is_declared(host.run, geom)) command.geoms.push_back(geom);
  host.document.scene_layout->is_text = false;
  host.run.simulation->send(std::move(command));
}

}  // namespace

bool edits_declared_layout(const Host& host) {
  const std::optional<ui::SceneLayout>& edited = host.document.scene_layout;
  return edited && std::any_of(edited->geoms.begin(), edited->geoms.end(),
                               [&](const std::string& geom) { return is_declared(host.run, geom); });
}

bool save_scene_layout(Host& host) {
  if (!host.document.scene_layout) return false;
  const ui::SceneLayout layout = *host.document.scene_layout;
  std::string file = layout.file;
  if (!layout.is_written && exists(file)) file = free_file(host, host.edits().project()->layout.name, ".taxels.json");
  if (has_notice(host, file)) {
    host.report(
        Severity::error,
        file + " was changed by another program: answer its notice first, or export the layout to another file.");
    return false;
  }
  try {
    const Project written = with_mesh_on_disk(*host.edits().project(), file, host.edits().mesh());
    export_layout(file, written);
    wrote(host, file, written);
    host.files.watch.accept(written.layout.mesh.file);
  } catch (const Error& error) {
    host.report(Severity::error, shown_message(error) + ": File > Export > Export layout writes it elsewhere.");
    return false;
  }
  host.document.scene_layout->file = file;
  host.document.scene_layout->is_written = true;
  host.edits().mark_saved();
  if (layout.is_text) name_layout_in_scene(host, layout.geoms, file);
  for (SceneAttachment& one : host.run.scene.attached)
    if (std::find(layout.geoms.begin(), layout.geoms.end(), one.geom) != layout.geoms.end()) one.layout = file;
  host.report(Severity::note, "Saved " + file);
  return true;
}

void save_scene_when_ready(Host& host) {
  const bool waits_for_model = host.document.scene_layout && host.handover.is_requested();
  if (host.files.scene_to_save.empty() || host.run.pending || waits_for_model || host.handover.is_replacing() ||
      host.edits().models().busy())
    return;
  host.run.simulation->send(SaveSceneCommand{std::exchange(host.files.scene_to_save, {})});
}

}  // namespace taxel::studio
