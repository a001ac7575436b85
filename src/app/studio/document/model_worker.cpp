#include "app/studio/document/model_worker.h"

#include <utility>

#include "app/studio/document/shown_model.h"
#include "core/base/error.h"

namespace taxel::studio {

ModelWorker::ModelWorker(SensorCache& cache, std::function<void()> wake, Built built)
    : cache_(cache), wake_(std::move(wake)), built_(std::move(built)), thread_([this] { run(); }) {}

ModelWorker::~ModelWorker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    if (preview_) preview_->cancel();
    if (polish_) polish_->cancel();
  }
  asked_.notify_all();
  thread_.join();
}

void ModelWorker::build(ModelJob job) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(job);
    if (preview_ && next_->project->layout.mesh.repair != repair_) preview_->cancel();
    if (polish_) polish_->cancel();
  }
  asked_.notify_all();
}

void ModelWorker::clear() {
  const std::lock_guard lock(mutex_);
  ++dropped_;
  next_.reset();
  ready_.reset();
  if (preview_) preview_->cancel();
  if (polish_) polish_->cancel();
}

std::optional<BuiltModel> ModelWorker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(ready_, std::nullopt);
}

void ModelWorker::wait() {
  std::unique_lock lock(mutex_);
  told_.wait(lock, [this] { return ready_ || (!next_ && !working_); });
}

bool ModelWorker::busy() const {
  const std::lock_guard lock(mutex_);
  return ready_ || next_ || working_;
}

bool ModelWorker::polishing() const {
  const std::lock_guard lock(mutex_);
  return polish_ != nullptr;
}

double ModelWorker::fraction() const {
  const std::lock_guard lock(mutex_);
  return polish_ ? polish_->fraction() : 0.0;
}

void ModelWorker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    asked_.wait(lock, [this] { return next_ || ending_; });
    if (ending_) return;
    const ModelJob job = std::move(*next_);
    next_.reset();
    working_ = true;
    compile(job, lock);
    working_ = false;
    polish_.reset();
    told_.notify_all();
  }
}

void ModelWorker::compile(const ModelJob& job, std::unique_lock<std::mutex>& lock) {
  const std::uint64_t dropped = dropped_;
  const auto stage = [&](SampleQuality quality, Progress& progress) {
    lock.unlock();
    std::optional<BuiltModel> built = attempt(job, quality, progress);
    if (built_ && built && built->model) built_(built->model);
    lock.lock();
    if (!built || dropped != dropped_) return SensorModelPtr{};
    SensorModelPtr model = built->model;
    ready_ = std::move(built);
    told_.notify_all();
    if (wake_) wake_();
    return model;
  };
  repair_ = job.project->layout.mesh.repair;
  preview_ = std::make_shared<Progress>();
  const SensorModelPtr preview = stage(SampleQuality::preview, *preview_);
  preview_.reset();
  if (!preview || preview->quality == SampleQuality::polished || next_ || ending_) return;
  polish_ = std::make_shared<Progress>();
  stage(SampleQuality::polished, *polish_);
}

std::optional<BuiltModel> ModelWorker::attempt(const ModelJob& job, SampleQuality quality, Progress& progress) {
  SensorBuild how(&progress);
  how.cache = &cache_;
  how.quality = quality;
  try {
    const Layout& layout = job.project->layout;
    const OpenMeshPtr mesh = job.meshes->get(layout.mesh);
    ShownModel shown = shown_model(layout, [&](const Layout& compiled) {
      return build_sensor_model(compiled, mesh->loaded.mesh, mesh->loaded.sha256, job.file, how);
    });
    return BuiltModel{job.number, std::move(shown.model), std::move(shown.problem)};
  } catch (const Cancelled&) {
    return std::nullopt;
  } catch (const Error& error) {
    return BuiltModel{job.number, nullptr,
                      error.where().empty() ? error.message() : error.where() + ": " + error.message()};
  } catch (const std::exception& error) {
    return BuiltModel{job.number, nullptr, error.what()};
  }
}

}  // namespace taxel::studio
