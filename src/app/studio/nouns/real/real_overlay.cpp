#include "app/studio/nouns/real/real_overlay.h"

#include <algorithm>
#include <filesystem>

#include "core/base/files.h"
#include "core/base/text/shown_message.h"
#include "core/layout/words.h"

namespace taxel::studio {

namespace {

constexpr std::size_t kShownRows = 6;  // rows of a table in the dialog

}  // namespace

TaxelSeries run_series(const SimFramePtr& frame, int sensor) {
  if (!frame || !frame->trace || sensor < 0 || sensor >= static_cast<int>(frame->sensors.size())) return {};
  const auto which = static_cast<std::size_t>(sensor);
  const Layout& layout = frame->scene->sensors[which]->layout;
  std::size_t first = 0;
  for (std::size_t s = 0; s < which; ++s) first += frame->sensors[s].readings.size();
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

bool RealOverlay::overlay(ui::RealState& state, const TaxelSeries& run, int sensor) {
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
  if (!run.time.empty()) shown->alignment = taxel::align(run, shown->recording.series);
  // A recording that cannot be aligned yet begins with the run.
  const double begin = run.time.empty() ? 0 : run.time.front();
  shown->shift = shown->alignment ? shown->alignment->shift : begin - shown->recording.series.time.front();
  shown_ = std::move(shown);
  state.asks = false;
  return true;
}

void RealOverlay::align(const TaxelSeries& run) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->alignment = taxel::align(run, shown->recording.series);
  if (!shown->alignment)
    throw Error(shown->file,
                "cannot be aligned: no shift gives an overlap of half of the shorter signal with changing readings; "
                "run the simulation on, or type a shift");
  shown->shift = shown->alignment->shift;
  shown->fits.clear();
  shown_ = std::move(shown);
}

void RealOverlay::shift(double seconds) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->shift = seconds;
  shown->alignment.reset();
  shown->fits.clear();
  shown_ = std::move(shown);
}

void RealOverlay::fit(const TaxelSeries& run, const FitOptions& options) {
  if (!shown_) return;
  auto shown = std::make_shared<ui::RealShown>(*shown_);
  shown->options = options;
  shown->fits = fit_gains(run, shown->recording.series, shown->shift, options);
  if (shown->fits.empty()) throw Error(shown->file, "has none of the sensor's taxels");
  shown_ = std::move(shown);
}

}  // namespace taxel::studio
