#include "app/studio/nouns/compare/layout_reader.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {
namespace {

/// Returns whether a row of the run was skipped between two rows of the comparison.
bool skips_row(const Trace& trace, double before, double time) {
  const std::vector<TraceRow>& rows = trace.rows;
  const auto next =
      std::upper_bound(rows.begin(), rows.end(), before, [](double t, const TraceRow& row) { return t < row.time; });
  return next != rows.end() && next->time < time;
}

}  // namespace

/// Compiles the second layout, unless the request and the first layout are those of the last call.
void LayoutReader::build(const CompareInput& input, const SensorModelPtr& first, Progress& progress) {
  const ui::CompareRequest& request = input.request.second;
  if (request_ == request && first_ == first && (second_ || !problem_.empty())) return;
  request_ = request;
  first_ = first;
  second_.reset();
  taxels_.reset();
  rows_.clear();
  problem_.clear();
  try {
    const Layout layout =
        request.is_paper() ? released_model_of(first->layout) : read_second_layout(request.file, *first);
    if (layout.taxels != first->layout.taxels) taxels_ = std::make_shared<const std::vector<Taxel>>(layout.taxels);
    equal_contact_ = has_equal_contact(first->layout, layout);
    const std::string& name = request.is_paper() ? layout.name : request.file;
    second_ = std::make_unique<const SecondSensor>(first, layout, request.contact, name, &cache_, &progress);
  } catch (const Error& error) {
    problem_ = shown_message(error);
  }
}

/// Drops the rows of another run, and the rows from the first one on that the run has replaced.
void LayoutReader::drop_changed_rows(const SimFrame& frame, std::size_t sensor) {
  if (runs_ != frame.runs || at(sensor_) != sensor) rows_.clear();
  runs_ = frame.runs;
  sensor_ = static_cast<int>(sensor);
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return rows_.clear();
  std::size_t first = 0;
  for (std::size_t s = 0; s < sensor; ++s) first += frame.sensors[s].readings.size();
  const auto is_replaced = [&](const ui::ComparedRowPtr& row) {
    if (row->step < lanes->steps.front().step) return false;  // the run continues after this step
    if (row->step > lanes->steps.back().step) return true;
    const std::span<const double> all = lanes->readings_of(lanes->row_of(row->step));
    const std::vector<double>& ours = row->readings[0];
    return first + ours.size() > all.size() ||
           !std::equal(ours.begin(), ours.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
  };
  rows_.erase(std::find_if(rows_.begin(), rows_.end(), is_replaced), rows_.end());
}

void LayoutReader::add_row(const Step& step, std::size_t sensor, const Trace* trace) {
  if (!rows_.empty() && step.step <= rows_.back()->step) return;
  ui::ComparedRow row{step.step, step.time, step.travel, {step.sensors[sensor].readings, second_->read(step, sensor)}};
  row.after_gap = !rows_.empty() && trace != nullptr && skips_row(*trace, rows_.back()->time, step.time);
  rows_.push_back(std::make_shared<const ui::ComparedRow>(std::move(row)));
}

ui::ComparedRowPtr LayoutReader::displayed_row(const SimFrame& frame, std::size_t sensor) const {
  const auto known =
      std::lower_bound(rows_.begin(), rows_.end(), frame.step,
                       [](const ui::ComparedRowPtr& row, std::uint64_t step) { return row->step < step; });
  if (known != rows_.end() && (*known)->step == frame.step) return *known;
  return std::make_shared<const ui::ComparedRow>(ui::ComparedRow{
      frame.step, frame.time, frame.travel, {frame.sensors[sensor].readings, second_->read(frame, sensor)}});
}

void LayoutReader::read(const CompareInput& input, CompareResult& out, Progress& progress) {
  const SimFrame& frame = *input.frame;
  const std::size_t sensor = at(input.request.sensor);
  out.request = input.request.second;
  out.sensor = input.request.sensor;
  out.a = frame.scene->sensors[sensor];
  build(input, out.a, progress);
  out.equal_contact = equal_contact_;
  out.problem = problem_;
  if (!second_) return;
  out.b = second_->model();
  out.taxels_of_b = taxels_;
  out.reads_recorded = second_->reads_recorded();
  if (generation_ != input.generation) drop_changed_rows(frame, sensor);
  generation_ = input.generation;
  try {
    for (const StepPtr& step : input.recalled ? input.recalled->steps : std::vector<StepPtr>{}) {
      progress.stop_if_cancelled();
      if (step->scene == frame.scene) add_row(*step, sensor, frame.trace.get());
    }
    out.displayed = displayed_row(frame, sensor);
  } catch (const Error& error) {
    out.problem = shown_message(error);
  }
  out.rows = rows_;
}

}  // namespace taxel::studio
