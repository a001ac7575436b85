#include "app/studio/document/loader.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/error.h"

namespace taxel::studio {

/// What one thread does: load a document, polish its samples, or one after the other.
struct Loader::Job {
  std::optional<Document> document;  ///< whose samples are to be polished
  Progress loading, polishing;
  bool document_taken = false;  ///< the main thread's own

  std::mutex mutex;  // guards the next two
  std::condition_variable news;
  std::deque<LoadResult> results;
  std::atomic<bool> ended = false;
  std::thread thread;

  ~Job() {
    if (thread.joinable()) thread.join();
  }
  void cancel() {
    loading.cancel();
    polishing.cancel();
  }
  void post(LoadResult result, bool last) {
    {
      const std::lock_guard lock(mutex);
      results.push_back(std::move(result));
      ended = last;
    }
    news.notify_all();
  }
  void run(const std::string& file, const SkinChoice& skin, SensorCache& cache);
  void run_polish(SensorCache& cache);
};

void Loader::Job::run(const std::string& file, const SkinChoice& skin, SensorCache& cache) {
  SensorBuild how(&loading);
  how.cache = &cache;
  how.quality = SampleQuality::preview;
  try {
    document = file.empty() ? built_in_fingertip(how) : load_document(file, skin, how);
  } catch (const Cancelled&) {
    return post(LoadCancelled{}, true);
  } catch (const std::exception& error) {
    return post(LoadFailed{error.what()}, true);
  }
  const bool complete = !document->previewed();
  post(*document, complete);
  if (!complete) run_polish(cache);
}

void Loader::Job::run_polish(SensorCache& cache) {
  SensorBuild how(&polishing);
  how.cache = &cache;
  try {
    post(Polished{document->model, document->compile(how)}, true);
  } catch (const Cancelled&) {
    post(PolishCancelled{}, true);
  } catch (const std::exception& error) {
    post(PolishFailed{error.what()}, true);
  }
}

Loader::~Loader() {
  retire();
}

void Loader::forget_ended() {
  std::erase_if(retired_, [](const std::shared_ptr<Job>& job) { return job->ended.load(); });
}

void Loader::retire() {
  forget_ended();
  if (!job_) return;
  job_->cancel();
  retired_.push_back(std::move(job_));
}

void Loader::begin(std::shared_ptr<Job> job) {
  retire();
  cancelled_.reset();
  job_ = std::move(job);
  began_ = std::chrono::steady_clock::now();
}

void Loader::start(const std::string& file, const SkinChoice& skin) {
  begin(std::make_shared<Job>());
  file_ = file;
  job_->thread = std::thread([job = job_.get(), file, skin, this] { job->run(file, skin, cache_); });
}

void Loader::polish(const Document& document) {
  begin(std::make_shared<Job>());
  job_->document = document;
  job_->document_taken = true;
  job_->thread = std::thread([job = job_.get(), this] { job->run_polish(cache_); });
}

void Loader::cancel() {
  if (!job_) return;
  if (job_->document_taken) {
    cancelled_.emplace(std::in_place_type<PolishCancelled>);
  } else {
    cancelled_.emplace(std::in_place_type<LoadCancelled>);
  }
  retire();
}

void Loader::close() {
  retire();
  cancelled_.reset();
}

void Loader::wait() const {
  if (!job_ || cancelled_) return;
  std::unique_lock lock(job_->mutex);
  job_->news.wait(lock, [this] { return !job_->results.empty(); });
}

std::optional<LoadResult> Loader::take() {
  forget_ended();
  if (cancelled_) return std::exchange(cancelled_, std::nullopt);
  if (!job_) return std::nullopt;
  LoadResult result;
  {
    const std::lock_guard lock(job_->mutex);
    if (job_->results.empty()) return std::nullopt;
    result = std::move(job_->results.front());
    job_->results.pop_front();
    job_->document_taken = true;
    if (!job_->ended || !job_->results.empty()) return result;
  }
  job_.reset();
  return result;
}

bool Loader::loading() const {
  return job_ && !job_->document_taken;
}

bool Loader::polishing() const {
  return job_ && job_->document_taken;
}

double Loader::fraction() const {
  if (!job_) return 0;
  return job_->document_taken ? job_->polishing.fraction() : job_->loading.fraction();
}

double Loader::seconds() const {
  return busy() ? std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() : 0.0;
}

}  // namespace taxel::studio
