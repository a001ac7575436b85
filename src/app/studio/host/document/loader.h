// Loads documents on a worker while the window stays live: a document with preview samples first, which can be
// displayed and simulated, and then the same document with polished samples.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/jobs/newest_wins.h"

namespace taxel::studio {

struct LoadFailed {
  std::string reason;
};
struct LoadCancelled {};
/// The same layout with polished samples.
struct Polished {
  SensorModelPtr preview;  ///< model that is replaced
  SensorModelPtr model;
};
struct PolishFailed {
  std::string reason;
};
struct PolishCancelled {};
using LoadResult = std::variant<LoadedDocument, LoadFailed, LoadCancelled, Polished, PolishFailed, PolishCancelled>;

class Loader {
 public:
  /// Reloading costs only the parts of a layout that changed, because of `cache`, which must live longer.
  Loader(JobExecutor& executor, SensorCache& cache);

  /// Number of frames in which a script sees a preview, long enough to aim at it and to press and release a button.
  static constexpr int kPreviewFrames = 4;

  /// Begins to load a file, or the built-in fingertip if `file` is empty. A running job is cancelled and its results
  /// are dropped. When a document with preview samples is taken, its samples are polished. `skin` chooses the mesh for
  /// a layout of another program. A script sees for `frames` frames that the file is being loaded.
  void start(const std::string& file, const SkinChoice& skin = {}, int frames = 0);
  /// Begins to load an episode of a data set, in the same way.
  void start(const EpisodeChoice& episode);
  /// Begins to polish the samples of a document, whose preview a script sees for kPreviewFrames. A running job is
  /// cancelled and its results are dropped.
  void polish(const LoadedDocument& document);
  /// Cancels the running job, which take() reports next, even if the worker has finished by then.
  void cancel();
  /// Cancels the running job without a report.
  void close();
  /// Waits until take() has a result, or no job runs.
  void wait() const;
  /// Returns the next result, once.
  std::optional<LoadResult> take();

  [[nodiscard]] bool busy() const { return slot_.posted() || cancelled_; }
  [[nodiscard]] bool cancelled() const { return cancelled_.has_value(); }  ///< whether take() will report it
  [[nodiscard]] bool loading() const;                                      ///< whether the document is not there yet
  [[nodiscard]] bool polishing() const;                            ///< whether the samples of a document are polished
  [[nodiscard]] const std::string& file() const { return file_; }  ///< file of the last start()
  /// Returns the finished fraction of loading or of polishing.
  [[nodiscard]] double fraction() const { return slot_.newest() ? 1 : slot_.fraction(); }
  /// Returns the name of the step that loading or polishing is in, as in "Filling holes", or "".
  [[nodiscard]] std::string step() const { return slot_.step(); }
  [[nodiscard]] double seconds() const;  ///< time since it began

 private:
  /// A file or an episode to load, or a document whose samples are to be polished.
  struct Task {
    std::string file;
    SkinChoice skin;
    std::optional<EpisodeChoice> episode;
    std::optional<LoadedDocument> document;
  };
  static void run(const Task& task, SensorCache& cache, LoadResult& out, Progress& progress);
  void begin(Task task, int frames);

  std::string file_;
  std::optional<LoadResult> cancelled_;  ///< report for take()
  std::chrono::steady_clock::time_point began_;
  NewestWins<std::shared_ptr<const Task>, LoadResult> slot_;
};

}  // namespace taxel::studio
