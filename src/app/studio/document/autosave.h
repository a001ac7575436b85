// Unsaved edits on disk, so that a crash loses little: written by a thread of its own, atomically, and offered again at
// the next start.
//
// Each running program keeps its document in a file of its own in the folder, NAME.taxelproj, beside NAME.lock that it
// holds while it lives: what nobody holds was left behind. NAME.origin says what the document was.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/document/project.h"

namespace taxel::studio {

/// A document that a program left behind.
struct LostDocument {
  std::filesystem::path file;  ///< of the kept project
  std::string name;            ///< of the document
  std::string origin;          ///< file that it was opened from; empty: none
  std::string when;            ///< "2026-11-22 13:05:09", local time
};

/// Time of the steady clock [s], which goes on at rest and never jumps.
[[nodiscard]] double steady_seconds();

class Autosave {
 public:
  /// Keeps nothing before start().
  explicit Autosave(double every_seconds) : every_(every_seconds) {}
  ~Autosave();  ///< leaves what is kept, for the next start
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Throws Error where the folder cannot be written.
  void start(const std::filesystem::path& folder);
  [[nodiscard]] bool started() const { return lock_ >= 0; }

  /// To be called often, at the latest after seconds_until_due(). A project with unsaved edits is written as soon as
  /// its oldest unwritten edit is as old as the interval; without one the written file is removed. `now` is the time of
  /// a steady clock [s], which runs while the window rests too. What could not be written is tried again one interval
  /// later. Never waits. Returns why the last writing failed, once for all that fail alike.
  std::string update(const ProjectPtr& unsaved, std::uint64_t revision, const std::string& name,
                     const std::string& origin, double now);
  /// Seconds from `now` until update() has something to write, at least 0; empty while nothing is unwritten.
  [[nodiscard]] std::optional<double> seconds_until_due(double now) const;
  /// Writes the unsaved edits at once, unless they are written already, waits until they are on disk, and leaves them
  /// for the next start. The program is about to end without being asked to.
  void leave(const ProjectPtr& unsaved, std::uint64_t revision, const std::string& name, const std::string& origin);

  /// The program ends as it should: what is kept is thrown away.
  void end();

  /// What was left behind is edited here now: it is kept with the next update, and only then forgotten.
  void take_over(const LostDocument& lost) { taken_over_ = lost; }

  /// What was left behind, newest first; what nobody holds and holds nothing is cleared away.
  [[nodiscard]] std::vector<LostDocument> lost() const;
  static void forget(const LostDocument& lost);

 private:
  struct Job {
    ProjectPtr project;  ///< null: throw away what is kept
    std::string name, origin;
    std::optional<LostDocument> forget;
  };
  std::string new_failure();
  void stop();
  void run();
  void write(const Job& job) const;
  void send(Job job);

  double every_;
  std::filesystem::path folder_, file_;
  int lock_ = -1;
  std::optional<double> unkept_since_;
  std::uint64_t kept_ = 0;  ///< revision
  bool sent_ = false;       ///< something to keep, since the last time that nothing was unsaved
  std::optional<LostDocument> taken_over_;
  std::string told_;  ///< of the failures

  std::mutex mutex_;  // guards the rest
  std::condition_variable asked_;
  std::optional<Job> next_;
  std::optional<std::string> outcome_;  ///< of the last writing: why it failed, or nothing; empty: not looked at since
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace taxel::studio
