#include "app/studio/features/probe/probe_worker.h"

#include <utility>

#include "core/base/error.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::studio {

namespace {

/// In the unit that the window takes meshes for.
TriMeshPtr load_probe(const std::string& file) {
  if (file.empty()) throw Error("", "probe", "choose a mesh file");
  const LoadedMesh loaded = load_mesh(file);
  const double unit = guess_unit(*loaded.mesh).scale;
  return unit == 1.0 ? loaded.mesh : load_mesh(file, dvec3(unit)).mesh;
}

}  // namespace

ProbeWorker::ProbeWorker(std::function<void()> wake)
    : worker_([this](const Job& job, Progress&) { return attempt(job); }, std::move(wake)) {}

void ProbeWorker::press(const SensorModelPtr& model, const std::optional<ui::ProbeRequest>& request) {
  worker_.ask(model && request ? std::optional(Job{model, *request}) : std::nullopt);
}

void ProbeWorker::press_now(const SensorModelPtr& model) {
  const std::optional<Job> asked = worker_.asked();
  if (!asked || !model) return;
  const Job job{model, asked->request};
  worker_.put(job, attempt(job));
}

ui::ProbeRequest ProbeWorker::with_mesh(const ui::ProbeRequest& request) {
  ui::ProbeRequest loaded = request;
  if (std::holds_alternative<ProbeMesh>(request.probe.shape)) {
    loaded.probe.shape = ProbeMesh{meshes_.get(request.mesh_file, [&] { return load_probe(request.mesh_file); })};
  }
  return loaded;
}

ui::PressedProbePtr ProbeWorker::attempt(const Job& job) {
  const std::lock_guard one_at_a_time(pressing_);
  auto out = std::make_shared<ui::PressedProbe>();
  out->model = job.model;
  out->request = job.request;
  try {
    taxel::press(*job.model, with_mesh(job.request).probe, press_);
  } catch (const std::exception& error) {
    out->problem = error.what();
    return out;
  }
  out->mesh = press_.mesh;
  out->X_MG = press_.X_MG;
  out->state.model = job.model;
  out->state.readings = press_.reading.values;
  out->state.force_W = press_.wrench.force;
  out->state.surfaces = {press_.surface};
  out->state.hits = press_.reading.hits.all();
  out->force = glm::length(press_.wrench.force);
  out->area = press_.surface.area();
  out->largest = press_.surface.max_pressure();
  out->polygons = static_cast<int>(press_.surface.polygons.size());
  return out;
}

}  // namespace taxel::studio
