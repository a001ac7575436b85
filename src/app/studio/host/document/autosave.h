// Writes unsaved edits to disk on a worker, atomically, so that a crash loses little, and offers them again at the next
// start.
//
// Each running program writes its document to a file of its own in the folder, NAME.taxelproj, and locks NAME.lock next
// to it while the program runs. A document whose lock nobody holds was left behind by a program that did not end
// normally. NAME.origin holds the name of the document and the file from which it was opened.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studio/host/jobs/newest_wins.h"
#include "core/base/os/file.h"
#include "core/document/project.h"

namespace taxel::studio {

/// A document that a program left behind.
struct LostDocument {
  std::filesystem::path file;  ///< file of the kept project
  std::string name;            ///< name of the document
  std::string origin;          ///< file from which the document was opened, or empty
  std::string when;            ///< "2026-11-22 13:05:09", local time
};

/// Returns the time of the steady clock [s], which continues while the window rests and never jumps.
[[nodiscard]] double steady_seconds();

class Autosave {
 public:
  /// Writes nothing before start().
  Autosave(JobExecutor& executor, double every_seconds);
  ~Autosave();  ///< leaves the written file for the next start
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Locks a file in the folder and begins to write. Throws Error if the folder cannot be written.
  void start(const std::filesystem::path& folder);
  [[nodiscard]] bool started() const { return lock_.is_open(); }

  /// Writes or removes the file if necessary. Must be called often, at the latest after seconds_until_due(). A project
  /// with unsaved edits is written as soon as its oldest unwritten edit is as old as the interval; without unsaved
  /// edits the written file is removed. `now` is the time of a steady clock [s], which continues while the window
  /// rests. A failed attempt is repeated one interval later. Never waits. Returns why the last attempt failed, once for
  /// all equal failures.
  std::string update(const ProjectPtr& unsaved, std::uint64_t revision, const std::string& name,
                     const std::string& origin, double now);
  /// Whether the last attempt failed.
  [[nodiscard]] bool fails() const { return !reported_.empty(); }
  /// Returns the seconds from `now` until update() has something to write, at least 0; empty if nothing is unwritten.
  [[nodiscard]] std::optional<double> seconds_until_due(double now) const;
  /// Writes the unsaved edits on the calling thread and leaves them for the next start. Used when a signal ends the
  /// program: does not wait for other jobs.
  void leave(const ProjectPtr& unsaved, const std::string& name, const std::string& origin);

  /// Removes the written file when the program ends normally.
  void end();

  /// Takes over a document that was left behind and is edited now: the next update writes it, and only then is the old
  /// file removed.
  void take_over(const LostDocument& lost) { taken_over_ = lost; }

  /// Returns the documents that were left behind, newest first. Removes files that have neither a lock holder nor a
  /// document.
  [[nodiscard]] std::vector<LostDocument> lost() const;
  static void forget(const LostDocument& lost);

 private:
  struct Task {
    ProjectPtr project;  ///< project to write, or null to remove the written file
    std::string name, origin;
    std::optional<LostDocument> forget;
  };
  struct Outcome {
    std::string problem;  ///< reason for the failure, or empty
  };
  std::string new_failure();
  void stop();
  void carry_out(const Task& task) const;
  [[nodiscard]] Task completed(Task task) const;
  void send(Task task) { slot_.post(std::make_shared<const Task>(completed(std::move(task)))); }

  double every_;
  std::filesystem::path folder_, file_;
  os::File lock_;
  std::optional<double> unkept_since_;
  std::uint64_t kept_ = 0;  ///< revision that was posted last
  bool sent_ = false;       ///< whether a project was posted since the last time that nothing was unsaved
  std::optional<LostDocument> taken_over_;
  std::string reported_;  ///< failure that update() returned last
  NewestWins<std::shared_ptr<const Task>, Outcome> slot_;
};

}  // namespace taxel::studio
