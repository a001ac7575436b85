#include "app/studio/nouns/real/real_commands.h"

#include <imgui.h>

#include "app/studio/frame/message_list.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/ask_for_file.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/real/real_overlay.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/run/real/apply_gains.h"

namespace taxel::studio {

namespace {

void read_real(Host& host, const std::string& path) {
  std::vector<int> ids;
  if (const SensorModelPtr model = host.app.shown->model(*host.app.viewer))
    for (const Taxel& taxel : model->layout.taxels) ids.push_back(taxel.id);
  try {
    host.app.get<RealOverlay>().read(path, ids, host.app.get<ui::RealState>());
  } catch (const Error& error) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
}

/// Applies the gains as an edit of the layout. If that fails, the panel shows the reason.
void apply_gains(Host& host) {
  if (!host.app.get<RealOverlay>().shown() || !host.edits().is_open()) return;
  try {
    const std::optional<Calibration>& before = host.edits().project()->layout.calibration;
    const SetCalibration edit{
        with_gains(before, host.app.get<RealOverlay>().shown()->fits, host.app.get<RealOverlay>().shown()->unit)};
    host.edits().edit(edit);
  } catch (const Error& error) {
    host.app.get<ui::RealState>().applied = shown_message(error);
    return;
  }
  after_edit(host);
}

void act_on_real(Host& host, ui::RealTask task) {
  host.app.get<ui::RealState>().applied.clear();
  const bool compared = task == ui::RealTask::overlay || task == ui::RealTask::align || task == ui::RealTask::fit;
  const int sensor = host.app.get<RealOverlay>().shown() && task != ui::RealTask::overlay
                         ? host.app.get<RealOverlay>().shown()->sensor
                         : host.app.viewer->selection.sensor;
  const TaxelSeries run = compared ? run_series(host.app.shown->run.frame, sensor) : TaxelSeries{};
  try {
    switch (task) {
      case ui::RealTask::look:
        return host.app.get<RealOverlay>().look(host.app.get<ui::RealState>());
      case ui::RealTask::overlay:
        if (host.app.get<RealOverlay>().overlay(host.app.get<ui::RealState>(), run, sensor))
          for (const std::string& note : host.app.get<RealOverlay>().shown()->recording.notes)
            ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                            host.app.get<RealOverlay>().shown()->file + ": " + note, ImGui::GetTime());
        return;
      case ui::RealTask::save_mapping: {
        const std::string file = mapping_file_of(host.app.get<ui::RealState>().file);
        check_mapping(host.app.get<ui::RealState>().mapping, file);
        write_file_atomically(file, mapping_to_json(host.app.get<ui::RealState>().mapping));
        return ui::add_message(host.app.get<ui::Messages>(), Severity::note, "Saved " + file, ImGui::GetTime());
      }
      case ui::RealTask::align:
        return host.app.get<RealOverlay>().align(run);
      case ui::RealTask::fit:
        return host.app.get<RealOverlay>().fit(run, host.app.get<ui::RealState>().options);
      case ui::RealTask::apply:
        return apply_gains(host);
      case ui::RealTask::remove:
        return host.app.get<RealOverlay>().remove();
    }
  } catch (const Error& error) {
    if (host.app.get<ui::RealState>().asks)
      host.app.get<ui::RealState>().problem = shown_message(error);
    else
      ui::add_message(host.app.get<ui::Messages>(), Severity::error, shown_message(error), ImGui::GetTime());
  }
}

}  // namespace

void carry_out(const ui::ReadRealRecording& command, Host& host) {
  command.path.empty() ? ask_for_file(host.app, ui::FileTask::import_recording, "") : read_real(host, command.path);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

void carry_out(const ui::ActOnReal& command, Host& host) {
  act_on_real(host, command.task);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

void carry_out(const ui::ShiftReal& command, Host& host) {
  host.app.get<RealOverlay>().shift(command.seconds);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

}  // namespace taxel::studio
