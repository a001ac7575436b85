// Commands of the Generate panel: previews, and reading the files from which patterns are made.
#include "app/studio/app/values/layout_features.h"
#include "app/studio/app/values/shown.h"
#include "app/studio/document/file_listing.h"
#include "app/studio/features/brush/brush.h"
#include "app/studio/features/generate/generate.h"
#include "app/studio/shell/studio.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/layout/sensor_presets.h"

namespace taxel::studio {

namespace {

std::vector<ui::PresetNote> preset_notes() {
  std::vector<ui::PresetNote> notes;
  for (const std::string& name : sensor_preset_names()) {
    const SensorPreset preset = make_sensor_preset(name);
    notes.push_back({preset.name, preset.layout.name, preset.source, preset.unverified});
  }
  return notes;
}

}  // namespace

void Studio::carry_out(const ui::PreviewPattern&) {
  ui::GenerateState& g = app_.layout->generate;
  const ui::PatternJob& job = g.asked;
  if (!job.skin || !app_.shown->document.model) return;
  if (job.pattern.is<patterns::Preset>() && g.presets.empty()) g.presets = preset_notes();
  PatternRequest request{g.number, job.pattern, {}, job.skin};
  PatternSource& source = request.source;
  source.frame = job.frame;
  source.sensor = job.sensor;
  source.painted = !job.region->empty();
  source.faces = ui::skin_faces(*app_.shown->document.model, *job.region);
  if (job.table) source.table = *job.table;
  source.table_file = job.table_file;
  source.image = job.image;
  session_.patterns().post(std::move(request), Superseded::cancel);
}

/// Returns the preview that the panel waits for, or null if it is not computed yet or is displayed already.
PatternResultPtr Studio::fresh_preview() const {
  const ui::GenerateState& g = app_.layout->generate;
  PatternResultPtr result = session_.patterns().newest();
  return result && g.open && g.waiting() && result->number == g.number ? result : nullptr;
}

bool Studio::take_preview() {
  timing_.executor->run_posted();
  const PatternResultPtr result = fresh_preview();
  if (!result) return false;
  ui::GenerateState& g = app_.layout->generate;
  g.shown = result->number;
  g.problem = result->problem;
  g.left_out = result->made.left_out;
  g.least_distance = result->made.least_distance;
  g.ghosts = result->problem.empty() ? std::make_shared<const std::vector<Taxel>>(result->made.taxels) : nullptr;
  return true;
}

void Studio::carry_out(const ui::ReadPoints& command) {
  ui::GenerateState& g = app_.layout->generate;
  const std::string file = std::filesystem::absolute(command.path).string();
  g.file_problem.clear();
  try {
    if (is_picture(file)) {
      g.image = std::make_shared<const GreyImage>(read_grey_image(file));
      g.image_path = file;
      ui::change_kind<patterns::Image>(g);
    } else {
      g.table = std::make_shared<const std::string>(read_file(file));
      g.table_path = file;
      g.table_file = std::filesystem::path(file).filename().string();
      ui::change_kind<patterns::Table>(g);
    }
  } catch (const Error& error) {
    g.file_problem = shown_message(error);
  }
}

}  // namespace taxel::studio
