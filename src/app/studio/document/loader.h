// The worker thread that loads documents while the window stays live: a document with preview samples first, which can
// be shown and simulated, and then the same on polished ones.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/studio/document/documents.h"

namespace taxel::studio {

struct LoadFailed {
  std::string reason;
};
struct LoadCancelled {};
/// The same layout, its samples polished.
struct Polished {
  SensorModelPtr preview;  ///< what it replaces
  SensorModelPtr model;
};
struct PolishFailed {
  std::string reason;
};
struct PolishCancelled {};
using LoadResult = std::variant<Document, LoadFailed, LoadCancelled, Polished, PolishFailed, PolishCancelled>;

class Loader {
 public:
  /// `cache`: so that a reload of a layout costs what was changed in it; must live longer.
  explicit Loader(SensorCache& cache) : cache_(cache) {}
  ~Loader();  ///< cancels and waits
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Begins to load a file; empty: the built-in fingertip. Gives a Document, and after one with preview samples what
  /// comes of polishing them. What still runs is cancelled, its results are dropped.
  /// `skin`: what a layout of another program leaves open.
  void start(const std::string& file, const SkinChoice& skin = {});
  /// Begins to polish the samples of a document, likewise.
  void polish(const Document& document);
  /// Ends what runs: take() tells so next, whatever the worker has ready by then.
  void cancel();
  void close();       ///< the same, and nothing more is told of it
  void wait() const;  ///< until take() has something, or nothing runs
  /// The next result, once.
  std::optional<LoadResult> take();

  [[nodiscard]] bool busy() const { return job_ || cancelled_; }
  [[nodiscard]] bool cancelled() const { return cancelled_.has_value(); }  ///< take() is to tell so
  [[nodiscard]] bool loading() const;                                      ///< the document is not there yet
  [[nodiscard]] bool polishing() const;  ///< the document was taken, and its samples are polished now
  [[nodiscard]] const std::string& file() const { return file_; }  ///< of the last start()
  [[nodiscard]] double fraction() const;                           ///< of loading, or of polishing
  [[nodiscard]] double seconds() const;                            ///< since it began

 private:
  struct Job;
  void begin(std::shared_ptr<Job> job);
  void retire();  ///< what runs
  void forget_ended();

  std::string file_;
  SensorCache& cache_;
  std::shared_ptr<Job> job_;
  std::vector<std::shared_ptr<Job>> retired_;  ///< cancelled, yet to notice
  std::optional<LoadResult> cancelled_;        ///< what take() tells of them
  std::chrono::steady_clock::time_point began_;
};

}  // namespace taxel::studio
