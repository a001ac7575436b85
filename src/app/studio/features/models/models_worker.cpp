#include "app/studio/features/models/models_worker.h"

#include <algorithm>
#include <utility>

#include "core/base/index.h"

namespace taxel::studio {
namespace {

constexpr std::size_t kMostSteps = 120;  // of the history: more are not told apart in a plot
constexpr std::size_t kBatch = 6;        // copied at a time, and read before more are asked for

/// Spread evenly over what is recorded, the newest among them.
std::vector<std::uint64_t> wanted_steps(const SimFrame& frame) {
  std::vector<std::uint64_t> wanted;
  const HistoryLanes* lanes = frame.history.lanes.get();
  if (lanes == nullptr || lanes->rows() == 0) return wanted;
  const std::size_t stride = (lanes->rows() + kMostSteps - 1) / kMostSteps;
  for (std::size_t row = (lanes->rows() - 1) % stride; row < lanes->rows(); row += stride)
    wanted.push_back(lanes->steps[row].step);
  return wanted;
}

/// Whether the history still has the step as it was read.
bool is_recorded(const HistoryLanes& lanes, const SimFrame& frame, int sensor, const ui::ComparedStep& step) {
  if (lanes.rows() == 0 || step.step < lanes.steps.front().step || step.step > lanes.steps.back().step) return true;
  std::size_t first = 0;
  for (std::size_t s = 0; s < at(sensor); ++s) first += frame.sensors[s].readings.size();
  const std::span<const double> all = lanes.readings_of(lanes.row_of(step.step));
  const std::vector<double>& known = step.readings[ReadingModel::reading].values;
  return first + known.size() > all.size() ||
         std::equal(known.begin(), known.end(), all.begin() + std::ptrdiff_t(first));
}

}  // namespace

bool ModelsWorker::Job::operator==(const Job& other) const {
  return frame->step == other.frame->step && frame->scene == other.frame->scene && frame->runs == other.frame->runs &&
         frame->history.first == other.frame->history.first && sensor == other.sensor &&
         generation == other.generation && recalled == other.recalled && due == other.due;
}

ModelsWorker::ModelsWorker(std::function<void()> wake)
    : worker_([this](const Job& job, Progress& progress) { return attempt(job, progress); }, std::move(wake)) {}

ui::ComparedPtr ModelsWorker::newest() const {
  const auto result = worker_.newest();
  return result ? result->shown : nullptr;
}

/// Another scene or sensor, or steps that were simulated anew: all of it is read again.
void ModelsWorker::forget_what_changed(const SimFrame& frame, int sensor) {
  bool changed = frame.scene != scene_ || sensor != sensor_ || frame.runs != run_;
  if (const auto result = worker_.newest(); result && result->generation == generation_ && frame.history.lanes)
    for (const ui::ComparedStep& step : result->shown->steps)
      changed = changed || !is_recorded(*frame.history.lanes, frame, sensor, step);
  std::erase_if(asked_, [&](std::uint64_t step) { return step < frame.history.first || step > frame.history.last; });
  if (!changed) return;
  run_ = frame.runs;
  scene_ = frame.scene;
  sensor_ = sensor;
  ++generation_;
  asked_.clear();
}

std::optional<RecallCommand> ModelsWorker::follow(const SimFramePtr& frame, bool runs) {
  const bool there = wish_ && frame && frame->scene && at(wish_->sensor) < frame->sensors.size() &&
                     frame->scene->sensors[at(wish_->sensor)] &&
                     frame->scene->sensors[at(wish_->sensor)]->taxel_count() > 0;
  if (!there) {
    worker_.ask(std::nullopt);
    complete_ = true;
    return std::nullopt;
  }
  complete_ = complete_ || runs;
  if (runs) return std::nullopt;
  forget_what_changed(*frame, wish_->sensor);
  const std::vector<std::uint64_t> wanted = wanted_steps(*frame);
  const bool answered = recall_ == 0 || (frame->recalled && frame->recalled->number == recall_);
  worker_.ask(Job{frame, wish_->sensor, generation_, answered ? frame->recalled : nullptr, wanted.size()});
  const auto result = worker_.newest();
  const bool read = result && result->generation == generation_ && (recall_ == 0 || result->recalled == recall_);
  complete_ = false;
  if (!answered || !read) return std::nullopt;
  for (const ui::ComparedStep& step : result->shown->steps) asked_.insert(step.step);  // those that were shown
  RecallCommand next;
  for (const std::uint64_t step : wanted) {
    if (next.steps.size() == kBatch) break;
    if (asked_.insert(step).second) next.steps.push_back(step);
  }
  complete_ = next.steps.empty();
  if (complete_) return std::nullopt;
  next.number = ++recall_;
  return next;
}

void ModelsWorker::add(const Step& step) {
  if (known_.contains(step.step)) return;
  ui::ComparedStep& added = known_[step.step] = {step.step, step.time, step.travel, {}};
  added.readings = comparison_->read(step.sensors, step.geom_poses);
}

std::shared_ptr<const ModelsWorker::Result> ModelsWorker::attempt(const Job& job, Progress& progress) {
  auto out = std::make_shared<Result>();
  auto shown = std::make_shared<ui::ComparedSteps>();
  const SimFrame& frame = *job.frame;
  out->generation = job.generation;
  out->recalled = job.recalled ? job.recalled->number : 0;
  shown->sensor = job.sensor;
  shown->model = frame.scene->sensors[at(job.sensor)];
  shown->due = job.due;
  out->shown = shown;
  try {
    if (known_generation_ != job.generation) known_.clear();
    known_generation_ = job.generation;
    if (!comparison_ || comparison_->scene() != frame.scene || comparison_->sensor() != at(job.sensor))
      comparison_ = std::make_unique<ModelComparison>(frame.scene, at(job.sensor), &progress);
    std::erase_if(
        known_, [&](const auto& step) { return step.first < frame.history.first || step.first > frame.history.last; });
    add(frame);
    for (const StepPtr& step : job.recalled ? job.recalled->steps : std::vector<StepPtr>{}) {
      progress.stop_if_cancelled();
      if (step->scene == frame.scene) add(*step);
    }
    for (const auto& [number, step] : known_) shown->steps.push_back(step);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    shown->problem = error.what();
  }
  return out;
}

}  // namespace taxel::studio
