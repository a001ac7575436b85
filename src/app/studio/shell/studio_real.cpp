// Commands for a recording of a real sensor.
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/nouns/real/real_state.h"
#include "app/studio/shell/studio.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/run/real/apply_gains.h"

namespace taxel::studio {

void Studio::carry_out(const ui::ReadRealRecording& command) {
  command.path.empty() ? ask_for_file(ui::FileTask::import_recording, "") : read_real(command.path);
  app_.get<ui::RealState>().shown = real_.shown();
}

void Studio::carry_out(const ui::ActOnReal& command) {
  act_on_real(command.task);
  app_.get<ui::RealState>().shown = real_.shown();
}

void Studio::carry_out(const ui::ShiftReal& command) {
  real_.shift(command.seconds);
  app_.get<ui::RealState>().shown = real_.shown();
}

void Studio::read_real(const std::string& path) {
  std::vector<int> ids;
  if (const SensorModelPtr model = app_.shown->model(*app_.viewer))
    for (const Taxel& taxel : model->layout.taxels) ids.push_back(taxel.id);
  try {
    real_.read(path, ids, app_.get<ui::RealState>());
  } catch (const Error& error) {
    ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
}

void Studio::act_on_real(ui::RealTask task) {
  app_.get<ui::RealState>().applied.clear();
  const bool compared = task == ui::RealTask::overlay || task == ui::RealTask::align || task == ui::RealTask::fit;
  const int sensor =
      real_.shown() && task != ui::RealTask::overlay ? real_.shown()->sensor : app_.viewer->selection.sensor;
  const TaxelSeries run = compared ? run_series(app_.shown->run.frame, sensor) : TaxelSeries{};
  try {
    switch (task) {
      case ui::RealTask::look:
        return real_.look(app_.get<ui::RealState>());
      case ui::RealTask::overlay:
        if (real_.overlay(app_.get<ui::RealState>(), run, sensor))
          for (const std::string& note : real_.shown()->recording.notes)
            ui::add_message(app_.get<ui::Messages>(), Severity::warning, real_.shown()->file + ": " + note,
                            ImGui::GetTime());
        return;
      case ui::RealTask::save_mapping: {
        const std::string file = mapping_file_of(app_.get<ui::RealState>().file);
        check_mapping(app_.get<ui::RealState>().mapping, file);
        write_file_atomically(file, mapping_to_json(app_.get<ui::RealState>().mapping));
        return ui::add_message(app_.get<ui::Messages>(), Severity::note, "Saved " + file, ImGui::GetTime());
      }
      case ui::RealTask::align:
        return real_.align(run);
      case ui::RealTask::fit:
        return real_.fit(run, app_.get<ui::RealState>().options);
      case ui::RealTask::apply:
        return apply_gains();
      case ui::RealTask::remove:
        return real_.remove();
    }
  } catch (const Error& error) {
    if (app_.get<ui::RealState>().asks)
      app_.get<ui::RealState>().problem = shown_message(error);
    else
      ui::add_message(app_.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
}

/// Applies the gains as an edit of the layout. If that fails, the panel shows the reason.
void Studio::apply_gains() {
  if (!real_.shown() || !session_.edits().is_open()) return;
  try {
    const std::optional<Calibration>& before = session_.edits().project()->layout.calibration;
    const SetCalibration edit{with_gains(before, real_.shown()->fits, real_.shown()->unit)};
    session_.edits().edit(edit);
  } catch (const Error& error) {
    app_.get<ui::RealState>().applied = shown_message(error);
    return;
  }
  session_.after_edit(app_.viewer->mode == ui::Mode::simulate);
}

}  // namespace taxel::studio
