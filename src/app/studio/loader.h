// The worker thread that loads documents while the window stays live.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/studio/documents.h"

namespace taxel::studio {

struct LoadFailed {
  std::string reason;
};
struct LoadCancelled {};
using LoadResult = std::variant<Document, LoadFailed, LoadCancelled>;

class Loader {
 public:
  Loader() = default;
  ~Loader();  ///< cancels and waits
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Begins to load a file; empty: the built-in fingertip. A load that still runs is cancelled, its result dropped.
  void start(const std::string& file);
  void cancel();
  void wait() const;  ///< until take() has something, or nothing is loading
  /// The result of the load, once.
  std::optional<LoadResult> take();

  [[nodiscard]] bool busy() const { return result_.valid(); }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] double fraction() const { return progress_ ? progress_->fraction() : 0.0; }
  [[nodiscard]] double seconds() const;  ///< since it began

 private:
  std::string file_;
  std::shared_ptr<Progress> progress_;
  std::future<LoadResult> result_;
  std::chrono::steady_clock::time_point began_;
};

}  // namespace taxel::studio
