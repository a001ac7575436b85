#include "app/studio/loader.h"

#include "core/base/error.h"

namespace taxel::studio {

namespace {

LoadResult load(const std::string& file, Progress& progress) {
  try {
    return file.empty() ? built_in_fingertip(progress) : load_document(file, progress);
  } catch (const Cancelled&) {
    return LoadCancelled{};
  } catch (const std::exception& error) {
    return LoadFailed{error.what()};
  }
}

}  // namespace

Loader::~Loader() {
  cancel();
  wait();
}

void Loader::start(const std::string& file) {
  cancel();
  wait();
  file_ = file;
  progress_ = std::make_shared<Progress>();
  began_ = std::chrono::steady_clock::now();
  result_ = std::async(std::launch::async, [file, progress = progress_] { return load(file, *progress); });
}

void Loader::cancel() {
  if (progress_) progress_->cancel();
}

void Loader::wait() const {
  if (result_.valid()) result_.wait();
}

std::optional<LoadResult> Loader::take() {
  if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return result_.get();
}

double Loader::seconds() const {
  return busy() ? std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count() : 0.0;
}

}  // namespace taxel::studio
