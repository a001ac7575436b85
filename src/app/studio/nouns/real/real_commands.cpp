#include "app/studio/nouns/real/real_commands.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>

#include "app/studio/frame/message_list.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/message.h"
#include "core/layout/words.h"
#include "core/run/real/align.h"

namespace taxel::studio {
namespace {

constexpr std::size_t kShownRows = 6;  // rows of a table in the dialog

}  // namespace

TaxelSeries run_series(const SimFramePtr& frame, int sensor) {
  if (!frame || !frame->trace || sensor < 0 || sensor >= static_cast<int>(frame->sensors.size())) return {};
  const auto which = static_cast<std::size_t>(sensor);
  const Layout& layout = frame->scene->sensors[which]->layout;
  const std::size_t first = frame->first_reading(which);
  TaxelSeries series;
  series.unit = reading_unit(layout.readout.aggregate);
  for (const Taxel& taxel : layout.taxels) series.taxel_ids.push_back(taxel.id);
  series.values.resize(series.taxel_ids.size());
  for (const TraceRow& row : frame->trace->rows) {
    const bool later = series.time.empty() || row.time > series.time.back();
    if (!later || row.readings.size() < first + series.values.size()) continue;
    series.time.push_back(row.time);
    for (std::size_t k = 0; k < series.values.size(); ++k) series.values[k].push_back(row.readings[first + k]);
  }
  return series;
}

std::string mapping_file_of(const std::string& table) {
  return std::filesystem::path(table).replace_extension(".recmap.json").string();
}

void RealOverlay::read(const std::string& path, const std::vector<int>& taxel_ids, ui::RealState& state) {
  std::string text = read_file(path);
  const std::string beside = mapping_file_of(path);
  std::error_code ignored;
  const ColumnMapping mapping =
      std::filesystem::exists(beside, ignored) ? read_mapping(beside) : guess_mapping(text, taxel_ids);
  text_ = std::move(text);
  state.file = path;
  state.mapping = mapping;
  state.asks = true;
  look(state);
}

void RealOverlay::look(ui::RealState& state) const {
  state.problem.clear();
  state.look = {};
  try {
    state.look = look_at_table(text_, state.mapping, state.file, kShownRows);
  } catch (const Error& error) {
    state.problem = shown_message(error);
  }
}

bool RealOverlay::overlay(ui::RealState& state, const TaxelSeries& run, int sensor, bool run_goes_on) {
  auto shown = std::make_shared<ui::RealShown>();
  state.problem.clear();
  try {
    shown->recording = parse_real_recording(text_, state.mapping, state.file);
  } catch (const Error& error) {
    state.problem = shown_message(error);
    return false;
  }
  shown->file = state.file;
  shown->sensor = sensor;
  shown->unit = state.mapping.unit;
  shown->mapping = state.mapping;
  shown->awaits_end = run_goes_on;
  if (!run.time.empty()) shown->alignment = taxel::align(run, shown->recording.series);
  // A recording that cannot be aligned yet begins with the run.
  const double begin = run.time.empty() ? 0 : run.time.front();
  shown->shift = shown->alignment ? shown->alignment->shift : begin - shown->recording.series.time.front();
  shown_ = std::move(shown);
  state.asks = false;
  return true;
}

void RealOverlay::stop_waiting() {
  if (!shown_ || !shown_->awaits_end) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->awaits_end = false;
  shown_ = std::move(shown);
}

void RealOverlay::align(const TaxelSeries& run) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->alignment = taxel::align(run, shown->recording.series);
  if (!shown->alignment)
    throw Error(shown->file,
                "cannot be aligned: no shift lets half of the shorter signal overlap with changing readings. Let the "
                "run go on to its end, or type a shift");
  shown->awaits_end = false;
  shown->shift = shown->alignment->shift;
  shown->fits.clear();
  shown_ = std::move(shown);
}

void RealOverlay::shift(double seconds) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->awaits_end = false;
  shown->shift = seconds;
  shown->alignment.reset();
  shown->fits.clear();
  shown_ = std::move(shown);
}

void RealOverlay::fit(const TaxelSeries& run, const FitOptions& options) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->awaits_end = false;
  shown->options = options;
  shown->fits = fit_gains(run, shown->recording.series, shown->shift, options);
  if (shown->fits.empty()) throw Error(shown->file, "has none of the sensor's taxels");
  shown_ = std::move(shown);
}

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

/// Applies the gains as an edit of the layout. Throws Error if they cannot be applied.
void apply_gains(Host& host) {
  if (!host.app.get<RealOverlay>().shown() || !host.edits().is_open()) return;
  const std::optional<Calibration>& before = host.edits().project()->layout.calibration;
  const SetCalibration edit{
      with_gains(before, host.app.get<RealOverlay>().shown()->fits, host.app.get<RealOverlay>().shown()->unit)};
  host.edits().edit(edit);
  after_edit(host);
}

void say(Host& host, Severity severity, const std::string& text) {
  ui::add_message(host.app.get<ui::Messages>(), severity, text, ImGui::GetTime());
}

/// Says at which shift a recording lies, or why it is not aligned.
void report_alignment(Host& host) {
  const ui::RealShown& shown = *host.app.get<RealOverlay>().shown();
  const std::string name = std::filesystem::path(shown.file).filename().string();
  const char* const later =
      shown.awaits_end ? "; it is aligned when the run ends" : ". Run on and press Align, or type a shift";
  if (shown.alignment)
    return say(host, Severity::note,
               fmt::format("{}: aligned with the run: shift {:.4f} s, correlation {:.3f}{}", name, shown.shift,
                           shown.alignment->correlation, shown.awaits_end ? "; aligned again when the run ends" : ""));
  say(host, shown.awaits_end ? Severity::note : Severity::warning,
      fmt::format("{}: not aligned: it does not overlap with enough of the run{}", name, later));
}

void overlay_recording(Host& host, const TaxelSeries& run, int sensor) {
  RealOverlay& real = host.app.get<RealOverlay>();
  const ui::RunView& view = host.app.shown->run;
  const bool has_end = !view.frame || view.frame->scene->duration > 0;
  if (!real.overlay(host.app.get<ui::RealState>(), run, sensor, has_end && !ui::is_over(view))) return;
  for (const bool analyse : {false, true}) host.app.get<ui::PanelsShown>().in(analyse, ui::kReal) = true;
  for (const std::string& text : real.shown()->recording.notes)
    say(host, Severity::warning, real.shown()->file + ": " + text);
  report_alignment(host);
}

void align_at_end(Host& host, const TaxelSeries& run) {
  RealOverlay& real = host.app.get<RealOverlay>();
  real.stop_waiting();  // if it fails, it is not tried in every frame
  real.align(run);
  report_alignment(host);
}

void carry_out_task(Host& host, ui::RealTask task) {
  host.app.get<ui::RealState>().refused.clear();
  const bool compared = task == ui::RealTask::overlay || task == ui::RealTask::align ||
                        task == ui::RealTask::align_at_end || task == ui::RealTask::fit;
  const int sensor = host.app.get<RealOverlay>().shown() && task != ui::RealTask::overlay
                         ? host.app.get<RealOverlay>().shown()->sensor
                         : host.app.viewer->selection.sensor;
  const TaxelSeries run = compared ? run_series(host.app.shown->run.frame, sensor) : TaxelSeries{};
  try {
    switch (task) {
      case ui::RealTask::look:
        return host.app.get<RealOverlay>().look(host.app.get<ui::RealState>());
      case ui::RealTask::overlay:
        return overlay_recording(host, run, sensor);
      case ui::RealTask::save_mapping: {
        const std::string file = mapping_file_of(host.app.get<ui::RealState>().file);
        check_mapping(host.app.get<ui::RealState>().mapping, file);
        write_file_atomically(file, mapping_to_json(host.app.get<ui::RealState>().mapping));
        return ui::add_message(host.app.get<ui::Messages>(), Severity::note, "Saved " + file, ImGui::GetTime());
      }
      case ui::RealTask::align:
        return host.app.get<RealOverlay>().align(run);
      case ui::RealTask::align_at_end:
        return align_at_end(host, run);
      case ui::RealTask::fit:
        return host.app.get<RealOverlay>().fit(run, host.app.get<ui::RealState>().options);
      case ui::RealTask::apply:
        return apply_gains(host);
      case ui::RealTask::remove:
        return host.app.get<RealOverlay>().remove();
    }
  } catch (const Error& error) {
    ui::RealState& real = host.app.get<ui::RealState>();
    (real.asks ? real.problem : real.refused) = shown_message(error);
  }
}

}  // namespace

void carry_out(const ui::ReadRealRecording& command, Host& host) {
  command.path.empty() ? ask_for_file(host.app, ui::FileTask::import_recording, "") : read_real(host, command.path);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

void carry_out(const ui::ActOnReal& command, Host& host) {
  host.app.get<ui::RealState>().comes_to_front = command.task == ui::RealTask::overlay;
  carry_out_task(host, command.task);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

void carry_out(const ui::ShiftReal& command, Host& host) {
  host.app.get<ui::RealState>().refused.clear();
  host.app.get<RealOverlay>().shift(command.seconds);
  host.app.get<ui::RealState>().shown = host.app.get<RealOverlay>().shown();
}

}  // namespace taxel::studio
