// The worker thread that makes the preview of a pattern of taxels: the newest request wins, those before are cancelled.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/layout/generators/pattern.h"

namespace taxel::studio {

struct PatternRequest {
  std::uint64_t number = 0;
  Pattern pattern;
  PatternSource source;
  std::shared_ptr<const MeshIndex> skin;
};

struct PatternAnswer {
  std::uint64_t number = 0;  ///< of the request
  PatternTaxels made;
  std::string problem;  ///< why nothing was made; empty: it was
};

class PatternWorker {
 public:
  /// `wake` is called from the worker when there is something to take.
  explicit PatternWorker(std::function<void()> wake);
  ~PatternWorker();  ///< cancels and waits
  PatternWorker(const PatternWorker&) = delete;
  PatternWorker& operator=(const PatternWorker&) = delete;

  void make(PatternRequest request);
  void drop();                          ///< nothing that was asked for is told any more
  std::optional<PatternAnswer> take();  ///< the newest answer, once
  void wait();                          ///< until nothing is to be done
  [[nodiscard]] bool busy() const;      ///< something is made, or lies ready

 private:
  void run();

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable asked_, told_;
  std::optional<PatternRequest> next_;
  std::optional<PatternAnswer> ready_;
  std::shared_ptr<Progress> progress_;  ///< of what is being made; null: nothing is
  bool ending_ = false;
  std::thread thread_;  // last: all else is there when it begins
};

}  // namespace taxel::studio
