#include "app/studio/nouns/probe/probe_job.h"

#include <memory>
#include <string>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/probe/probe_state.h"
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

namespace {

class ProbeOfFeature final : public FeatureJob {
 public:
  explicit ProbeOfFeature(JobExecutor& executor) : executor_(executor), probe_(executor) {}

  void request_about_layout(const ui::App& app, const SensorModelPtr& model) override {
    probe_.request(ui::probe_request(*app.viewer, app.get<ui::ProbeState>()), model);
  }
  bool take_about_layout(const SensorModelPtr& model, bool is_compiled) override {
    probe_.post_for(model);
    executor_.run_posted();
    return probe_.take_result(model, is_compiled);
  }
  void fill(ui::App& app) const override {
    app.shown->document.probe = probe_.reading();
    ui::ProbeState& probe = app.get<ui::ProbeState>();
    probe.latency = probe_.edit_latency();
    if (const ui::PressedProbePtr& pressed = probe_.reading()) {
      const std::vector<double>& readings = pressed->state.readings;
      probe.largest = std::max(probe.largest, pressed->largest);
      if (!readings.empty())
        probe.largest_reading = std::max(probe.largest_reading, *std::max_element(readings.begin(), readings.end()));
    }
    app.viewer->readings.probed = probe.largest_reading;
    app.viewer->readings.probed_pressure = probe.largest;
  }
  [[nodiscard]] bool busy() const override { return probe_.busy(); }
  void model_built(const SensorModelPtr& model) override { probe_.model_built(model); }
  void note_edit() override { probe_.note_edit(); }

 private:
  JobExecutor& executor_;
  ProbeJob probe_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_probe_job(JobExecutor& executor) {
  return std::make_unique<ProbeOfFeature>(executor);
}

}  // namespace taxel::studio
