#include "app/studio/features/probe/probe_job.h"

#include <memory>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/memo.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::studio {

namespace {

/// Reads a mesh in the unit that the window assumes for meshes. Throws Error.
TriMeshPtr load_probe(const std::string& file) {
  if (file.empty()) throw Error("", "probe", "choose a mesh file");
  const LoadedMesh loaded = load_mesh(file);
  const double unit = guess_unit(*loaded.mesh).scale;
  return unit == 1.0 ? loaded.mesh : load_mesh(file, dvec3(unit)).mesh;
}

/// Presses a probe and retains data for the next press.
class ProbePresser {
 public:
  void operator()(const ProbeInput& input, ui::PressedProbe& out) {
    out.model = input.model;
    out.probe = input.probe;
    Probe probe = input.probe;
    if (auto* shape = std::get_if<ProbeMesh>(&probe.shape))
      shape->mesh = meshes_.get(shape->file, [&] { return load_probe(shape->file); });
    taxel::press(*input.model, probe, press_);
    out.mesh = press_.mesh;
    out.X_MG = press_.X_MG;
    out.state.model = input.model;
    out.state.readings = press_.reading.values;
    out.state.force_W = press_.wrench.force;
    out.state.surfaces = {press_.surface};
    out.state.hits = press_.reading.hits.all();
    out.force = glm::length(press_.wrench.force);
    out.area = press_.surface.area();
    out.largest = press_.surface.max_pressure();
    out.polygons = static_cast<int>(press_.surface.polygons.size());
  }

 private:
  ProbePress press_;
  Memo<std::string, TriMeshPtr> meshes_{4};  ///< loaded meshes by file
};

}  // namespace

ProbeJob::ProbeJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal,
                 [presser = std::make_shared<ProbePresser>()](const ProbeInput& input, ui::PressedProbe& out,
                                                              Progress&) { (*presser)(input, out); }) {}

void ProbeJob::request(std::optional<Probe> probe, const SensorModelPtr& model) {
  request_ = std::move(probe);
  if (!request_) {
    reading_.reset();
    edited_at_.reset();
    edit_latency_.reset();
  }
  press(model, request_);
}

void ProbeJob::note_edit() {
  if (request_) edited_at_ = std::chrono::steady_clock::now();
}

bool ProbeJob::take_result(const SensorModelPtr& model, bool is_compiled) {
  if (reading_ && reading_->model != model) reading_.reset();
  ui::PressedProbePtr pressed = newest();
  if (!pressed || pressed == reading_ || pressed->model != model) return false;
  reading_ = std::move(pressed);
  if (edited_at_ && is_compiled) {
    edit_latency_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - *edited_at_).count();
    edited_at_.reset();
  }
  return true;
}

void ProbeJob::press(const SensorModelPtr& model, const std::optional<Probe>& probe) {
  post(model && probe ? std::optional(ProbeInput{model, *probe}) : std::nullopt);
}

void ProbeJob::model_built(const SensorModelPtr& model) {
  if (const std::optional<ProbeInput> input = posted(); input && model) run_here({model, input->probe});
}

}  // namespace taxel::studio
