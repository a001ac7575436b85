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

void ProbeWorker::press(const SensorModelPtr& model, const std::optional<ui::ProbeWish>& wish) {
  worker_.ask(model && wish ? std::optional(Job{model, *wish}) : std::nullopt);
}

void ProbeWorker::press_now(const SensorModelPtr& model) {
  const std::optional<Job> asked = worker_.asked();
  if (!asked || !model) return;
  const Job job{model, asked->wish};
  worker_.put(job, attempt(job));
}

ui::ProbeWish ProbeWorker::with_mesh(const ui::ProbeWish& wish) {
  ui::ProbeWish loaded = wish;
  if (std::holds_alternative<ProbeMesh>(wish.probe.shape)) {
    loaded.probe.shape = ProbeMesh{meshes_.get(wish.mesh_file, [&] { return load_probe(wish.mesh_file); })};
  }
  return loaded;
}

ui::PressedProbePtr ProbeWorker::attempt(const Job& job) {
  const std::lock_guard one_at_a_time(pressing_);
  auto out = std::make_shared<ui::PressedProbe>();
  out->model = job.model;
  out->wish = job.wish;
  try {
    taxel::press(*job.model, with_mesh(job.wish).probe, press_);
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
