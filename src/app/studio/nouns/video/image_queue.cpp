#include "app/studio/nouns/video/image_queue.h"

#include <utility>

namespace taxel::studio {
namespace {

constexpr std::size_t kMaxWaiting = 4;  // 25 MB of images of 1920 x 1080 pixels

}  // namespace

ImageQueue::~ImageQueue() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  executor_.remove(this);
}

void ImageQueue::add(gl::RgbImage image) {
  {
    const std::lock_guard lock(mutex_);
    if (error_) return;
    waiting_.push_back(std::move(image));
  }
  executor_.post(this, Priority::normal, [this] { work(); });
}

bool ImageQueue::has_room() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size() < kMaxWaiting;
}

bool ImageQueue::is_empty() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && !is_used_;
}

void ImageQueue::check() const {
  const std::lock_guard lock(mutex_);
  if (error_) throw Error(*error_);
}

void ImageQueue::work() {
  std::unique_lock lock(mutex_);
  while (!waiting_.empty()) {
    const gl::RgbImage image = std::move(waiting_.front());
    waiting_.pop_front();
    is_used_ = true;
    lock.unlock();
    std::optional<Error> error;
    try {
      use_(image);
    } catch (const Error& thrown) {
      error = thrown;
    }
    lock.lock();
    is_used_ = false;
    if (!error) continue;
    error_ = std::move(error);
    waiting_.clear();
  }
  lock.unlock();
  executor_.note_end();
}

}  // namespace taxel::studio
