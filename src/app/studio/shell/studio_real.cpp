// What the window does with a recording of a real sensor.
#include "app/studio/shell/studio.h"
#include "core/base/files.h"
#include "core/run/real/apply_gains.h"

namespace taxel::studio {

void Studio::carry_out(const ui::ReadRealRecording& command) {
  command.path.empty() ? ask_for_file(ui::FileTask::import_recording, "") : read_real(command.path);
  input_.real = real_.shown();
}

void Studio::carry_out(const ui::ActOnReal& command) {
  act_on_real(command.task);
  input_.real = real_.shown();
}

void Studio::carry_out(const ui::ShiftReal& command) {
  real_.shift(command.seconds);
  input_.real = real_.shown();
}

void Studio::read_real(const std::string& path) {
  std::vector<int> ids;
  if (const SensorModelPtr model = input_.shown_model(ui_))
    for (const Taxel& taxel : model->layout.taxels) ids.push_back(taxel.id);
  try {
    real_.read(path, ids, ui_.real);
  } catch (const Error& error) {
    ui::add_message(ui_, Severity::error, error.what(), ImGui::GetTime());
  }
}

void Studio::act_on_real(ui::RealTask task) {
  ui_.real.applied.clear();
  const bool compared = task == ui::RealTask::overlay || task == ui::RealTask::align || task == ui::RealTask::fit;
  const int sensor = real_.shown() && task != ui::RealTask::overlay ? real_.shown()->sensor : ui_.selection.sensor;
  const TaxelSeries run = compared ? run_series(input_.frame, sensor) : TaxelSeries{};
  try {
    switch (task) {
      case ui::RealTask::look:
        return real_.look(ui_.real);
      case ui::RealTask::overlay:
        if (real_.overlay(ui_.real, run, sensor))
          for (const std::string& note : real_.shown()->recording.notes)
            ui::add_message(ui_, Severity::warning, real_.shown()->file + ": " + note, ImGui::GetTime());
        return;
      case ui::RealTask::save_mapping: {
        const std::string file = mapping_file_of(ui_.real.file);
        check_mapping(ui_.real.mapping, file);
        write_file_atomically(file, mapping_to_json(ui_.real.mapping));
        return ui::add_message(ui_, Severity::note, "Saved " + file, ImGui::GetTime());
      }
      case ui::RealTask::align:
        return real_.align(run);
      case ui::RealTask::fit:
        return real_.fit(run, ui_.real.options);
      case ui::RealTask::apply:
        return apply_gains();
      case ui::RealTask::remove:
        return real_.remove();
    }
  } catch (const Error& error) {
    if (ui_.real.asks)
      ui_.real.problem = error.what();
    else
      ui::add_message(ui_, Severity::error, error.what(), ImGui::GetTime());
  }
}

/// An edit of the layout; why it cannot be made stands in the panel.
void Studio::apply_gains() {
  if (!real_.shown() || !session_.edits().is_open()) return;
  try {
    const std::optional<Calibration>& before = session_.edits().project()->layout.calibration;
    const SetCalibration edit{with_gains(before, real_.shown()->fits, real_.shown()->unit)};
    session_.edits().edit(edit);
  } catch (const Error& error) {
    ui_.real.applied = error.what();
    return;
  }
  session_.after_edit(ui_.mode == ui::Mode::simulate);
}

}  // namespace taxel::studio
