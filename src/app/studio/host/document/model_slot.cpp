#include "app/studio/host/document/model_slot.h"

#include <utility>

#include "app/studio/host/document/shown_model.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

namespace {

/// Throws Error or Cancelled.
void compile_model(const ModelInput& input, SensorCache& cache, BuiltModel& out, Progress& progress) {
  SensorBuild how(&progress);
  how.cache = &cache;
  how.quality = input.quality;
  out.number = input.number;
  const Layout& layout = input.project->layout;
  try {
    const OpenMeshPtr mesh = input.meshes->get(layout.mesh);
    ShownModel shown = shown_model(layout, mesh->loaded.mesh, [&](const Layout& compiled) {
      return build_sensor_model(compiled, mesh->loaded.mesh, mesh->loaded.sha256, input.file, how);
    });
    out.model = std::move(shown.model);
    out.problem = std::move(shown.problem);
  } catch (const Error& error) {  // without the file, which the window names
    out.problem = shown_part(error.where().empty() ? error.message() : error.where() + ": " + error.message());
  }
}

}  // namespace

ModelSlot::ModelSlot(JobExecutor& executor, SensorCache& cache, Built built)
    : slot_(executor, Priority::normal,
            [&cache, built = std::move(built)](const ModelInput& input, BuiltModel& out, Progress& progress) {
              compile_model(input, cache, out, progress);
              if (built && out.model) built(out.model);
            }) {}

void ModelSlot::build(ModelInput input) {
  const std::optional<ModelInput> before = slot_.posted();
  const bool cancels = before && (before->quality == SampleQuality::polished ||
                                  before->project->layout.mesh.repair != input.project->layout.mesh.repair);
  slot_.post(std::move(input), cancels ? Superseded::cancel : Superseded::finish);
}

std::optional<BuiltModel> ModelSlot::take() {
  std::optional<ModelInput> input = slot_.posted();
  const auto built = slot_.take();
  if (!built) return std::nullopt;
  const bool is_preview = built->model && built->model->quality == SampleQuality::preview;
  if (is_preview && input && input->number == built->number && input->quality == SampleQuality::preview) {
    input->quality = SampleQuality::polished;
    slot_.post(std::move(input));
  }
  return *built;
}

bool ModelSlot::polishing() const {
  const std::optional<ModelInput> input = slot_.posted();
  return input && input->quality == SampleQuality::polished;
}

}  // namespace taxel::studio
