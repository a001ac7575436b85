// A queue of images that workers use one after the other.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "app/studio/host/jobs/job_executor.h"
#include "core/base/error.h"
#include "ui/gl/rgb_image.h"

namespace taxel::studio {

/// Passes images to a function on workers, in the order in which they were added and one at a time, so that the thread
/// that adds them never waits. After an error the function is not called again.
class ImageQueue {
 public:
  using Use = std::function<void(const gl::RgbImage&)>;
  /// `use` may throw Error. The executor must live longer than the queue.
  ImageQueue(JobExecutor& executor, Use use) : executor_(executor), use_(std::move(use)) {}
  /// Drops the images that wait, and waits for the end of the call that runs.
  ~ImageQueue();
  ImageQueue(const ImageQueue&) = delete;
  ImageQueue& operator=(const ImageQueue&) = delete;

  void add(gl::RgbImage image);
  /// Whether few enough images wait that another one does not fill the memory.
  [[nodiscard]] bool has_room() const;
  /// Whether all images were used.
  [[nodiscard]] bool is_empty() const;
  /// Throws the Error that the function has thrown, if any.
  void check() const;

 private:
  void work();

  JobExecutor& executor_;
  Use use_;
  mutable std::mutex mutex_;  // guards the members below
  std::deque<gl::RgbImage> waiting_;
  bool is_used_ = false;  ///< whether the function runs
  std::optional<Error> error_;
};

}  // namespace taxel::studio
