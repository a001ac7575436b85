#include "core/sim/compare/second_sensor.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"
#include "core/document/paper_setting.h"
#include "core/document/project.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/formats/layout_format.h"
#include "core/sensor/layout_source.h"
#include "core/sensor/readout/reading.h"
#include "core/sim/compare/contact_again.h"

namespace taxel {
namespace {

/// Largest distance of two vertices that are the same, as a fraction of the mesh's diagonal. Mesh files store numbers
/// in single precision or as text; a mesh that was moved or scaled differs by much more.
constexpr double kSameVertex = 1e-6;

bool is_same_mesh(const TriMesh& a, const TriMesh& b) {
  if (a.faces() != b.faces() || a.vertices().size() != b.vertices().size()) return false;
  const double limit = kSameVertex * a.bounds().diagonal();
  for (std::size_t i = 0; i < a.vertices().size(); ++i)
    if (!(glm::distance(a.vertices()[i], b.vertices()[i]) <= limit)) return false;
  return true;
}

SensorSource read_source(const std::filesystem::path& file, const SensorModel& first) {
  if (file.extension() == ".taxelproj") {
    Project project = read_project(file);
    throw_first_error(check_layout_values(project.layout, file.string()));
    LoadedMesh mesh = load_mesh(project.layout.mesh.file, project.layout.mesh.scale);
    return {file.string(), std::move(project.layout), std::move(mesh)};
  }
  SkinChoice skin;
  if (is_foreign_layout(file)) {
    skin.mesh = first.layout.mesh.file;
    skin.scale = first.layout.mesh.scale;
  }
  return read_any_source(file, skin).source;
}

}  // namespace

Layout released_model_of(const Layout& layout) {
  Layout paper = as_in_the_paper(layout);
  paper.receptive_field.metric = Metric::euclidean;
  paper.readout = Readout{};
  paper.name = "the paper's released model";
  return paper;
}

Layout read_second_layout(const std::filesystem::path& file, const SensorModel& first) {
  SensorSource source = read_source(file, first);
  if (source.layout.taxels.empty()) throw Error(file.string(), "/taxels", "has no taxels: nothing would be read");
  const TriMesh &ours = *first.loaded, &theirs = *source.mesh.mesh;
  if (!is_same_mesh(ours, theirs))
    throw Error(file.string(), "/mesh/file",
                fmt::format("\"{}\" ({} vertices, {} faces) is another mesh than that of the run ({} vertices, {} "
                            "faces): both layouts must be made for the same mesh, in the same unit",
                            source.layout.mesh.file, theirs.vertices().size(), theirs.faces().size(),
                            ours.vertices().size(), ours.faces().size()));
  if (source.layout.name.empty()) source.layout.name = file.filename().string();
  return std::move(source.layout);
}

bool has_equal_contact(const Layout& first, const Layout& second) {
  const Material &a = first.material, &b = second.material;
  return a.field == b.field && a.modulus == b.modulus && a.thickness == b.thickness && a.faces == b.faces &&
         a.law == b.law && first.mesh.repair == second.mesh.repair;
}

Layout on_contact_of(const Layout& first, Layout second) {
  second.material = first.material;
  second.mesh.repair = first.mesh.repair;
  return second;
}

SecondSensor::SecondSensor(SensorModelPtr first, const Layout& second, SecondContact contact, const std::string& file,
                           SensorCache* cache, Progress* progress)
    : first_(std::move(first)) {
  const Layout& ours = first_->layout;
  reads_recorded_ = contact == SecondContact::recorded || has_equal_contact(ours, second);
  if (!reads_recorded_ && !(ours.material.compliant() && second.material.compliant()))
    throw Error(file, "/material/modulus",
                "a rigid layout has no pressure field: its contact cannot be computed again, only the recorded "
                "contact can be read");
  SensorBuild how(progress);
  how.cache = cache;
  second_ = build_sensor_model(reads_recorded_ ? on_contact_of(ours, second) : second, first_->loaded, "", file, how);
}

ModelReadings SecondSensor::read(const StepView& step, std::size_t sensor) const {
  const SensorView& view = step.sensors[sensor];
  ModelReadings out{{{ReadingModel::reading, {view.readings.begin(), view.readings.end()}, ""}}, {}};
  if (reads_recorded_) {
    SensorReading reading;
    read_sensor(*second_, view.surfaces, reading);
    out.models.push_back({ReadingModel::second, std::move(reading.values), ""});
    return out;
  }
  if (const std::string missing = missing_touched(*step.scene); !missing.empty()) throw Error(missing);
  out.models.push_back(read_in_place(ReadingModel::second, *second_, step.scene->touched[sensor], step, sensor));
  if (const std::string& missing = out.models.back().missing; !missing.empty()) throw Error(missing);
  return out;
}

}  // namespace taxel
