// The files around the open document: autosaved edits, changes by other programs, files to recover, and suggested
// names.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/studio/host/document/documents.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "core/base/os/file.h"
#include "core/document/fixes.h"
#include "core/document/project.h"
#include "core/sim/host/recording_journal.h"

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

/// Writes unsaved edits to disk on a worker, atomically, so that a crash loses little, and offers them again at the
/// next start. Each running program writes its document to a file of its own in the folder, NAME.taxelproj, and locks
/// NAME.lock next to it while the program runs. A document whose lock nobody holds was left behind by a program that
/// did not end normally. NAME.origin holds the name of the document and the file from which it was opened.
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
  /// rests. `mesh` is written next to the document if its file is gone. A failed attempt is repeated one interval
  /// later. Never waits. Returns why the last attempt failed, once for all equal failures.
  std::string update(const ProjectPtr& unsaved, std::uint64_t revision, const std::string& name,
                     const std::string& origin, double now, const OpenMeshPtr& mesh = nullptr);
  /// Whether the last attempt failed.
  [[nodiscard]] bool fails() const { return !reported_.empty(); }
  /// Returns the seconds from `now` until update() has something to write, at least 0; empty if nothing is unwritten.
  [[nodiscard]] std::optional<double> seconds_until_due(double now) const;
  /// Writes the unsaved edits on the calling thread and leaves them for the next start. Used when a signal ends the
  /// program: does not wait for other jobs.
  void leave(const ProjectPtr& unsaved, const std::string& name, const std::string& origin,
             const OpenMeshPtr& mesh = nullptr);

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
    OpenMeshPtr mesh = nullptr;  ///< mesh of the project, or null
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

enum class FileChange { changed, deleted };

/// Returns the hash of the file's bytes, or an empty text if the file does not exist or cannot be read.
std::string hash_of(const std::string& file);

/// Watches open files for changes and deletions by other programs: polls their times and sizes, never their contents.
class FileWatch {
 public:
  /// Watches these files from now on. Files that are watched already keep their known state.
  void watch(const std::vector<std::string>& files);
  /// Records the present state of the file as known, because this program has read or written it.
  void accept(const std::string& file);
  /// Returns the changes since the last call, each once, and only if the file did not change between two polls: a
  /// program that replaces a file may delete it first, or take long to write it. `now` [s]: polls no more often than
  /// every half second.
  std::vector<std::pair<std::string, FileChange>> look(double now);

 private:
  struct Stamp {
    bool exists = false;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time;
    bool operator==(const Stamp&) const = default;
  };
  struct Watched {
    std::string file;
    Stamp accepted;  ///< state when the file was opened, written, or last reported
    Stamp last;      ///< state at the last poll
  };
  static Stamp stamp_of(const std::string& file);

  std::vector<Watched> watched_;
  double next_ = 0;
};

struct ComparedMesh {
  MeshRef ref;                            ///< reference with the hash of the file that was read
  OpenMeshPtr mesh;                       ///< the mesh, or null if `problem` is set
  std::shared_ptr<const MeshIndex> skin;  ///< surface that would be sampled
  SurfaceDistances distances;             ///< distances of the taxels when the comparison began
  std::string problem;                    ///< reason why the file cannot be read, or empty
};

/// Compares a mesh that is already read.
ComparedMesh compare_mesh(const MeshRef& ref, const OpenMeshPtr& mesh, const Layout& layout);

/// Reads an open mesh again that was replaced on disk, and compares it with the edited layout, on a worker.
class MeshComparison {
 public:
  explicit MeshComparison(JobExecutor& executor);

  /// Drops a running comparison. Never throws: ComparedMesh::problem is the reason of a failure.
  void start(const Layout& layout);
  /// Whether a comparison runs or was not taken yet.
  [[nodiscard]] bool busy() const { return slot_.posted().has_value(); }
  /// Waits until no comparison runs.
  void wait() const { slot_.wait(); }
  /// The result, once.
  std::optional<ComparedMesh> take();

 private:
  NewestWins<std::shared_ptr<const Layout>, ComparedMesh> slot_;
};

struct DocumentFiles {
  /// `folder` is that of the files that are left for the next start.
  DocumentFiles(JobExecutor& executor, std::filesystem::path folder, double autosave_every)
      : kept_in(std::move(folder)), autosave(executor, autosave_every), comparison(executor) {}

  std::filesystem::path kept_in;
  Autosave autosave;
  FileWatch watch;
  std::string hash;                          ///< hash of the document's file, as it was read or written
  MeshComparison comparison;                 ///< with the mesh that replaced the document's
  std::optional<ComparedMesh> offered_mesh;  ///< mesh that a notice offers
  std::string scene_to_save;                 ///< file of the scene that is written as soon as its layouts are built
  std::vector<LostDocument> lost;            ///< documents to be offered, the first one now
  std::vector<LeftRecording> recordings;     ///< recordings to be offered after the documents
};

/// Returns the project as it can be written to `file`. First writes the mesh into the folder of `file` if the mesh is
/// built into the program, or if the mesh's file is gone and `mesh` was read from it. Throws Error if writing fails.
Project with_mesh_on_disk(Project project, const std::filesystem::path& file, const OpenMeshPtr& mesh = nullptr);

/// Folder and name that the file dialog offers.
struct SuggestedFile {
  std::string folder;  ///< absolute path, or empty for the folder in which the dialog was
  std::string name;
};
/// Returns a suggestion for saving a document. `file` is the file from which it was opened, or empty if it is built in;
/// `name` is the document's name.
SuggestedFile suggested_file(const std::string& file, const std::string& name, const std::string& extension);

/// Returns "screenshot-1.png", or the name with the first number that no file has.
inline std::string free_name(std::string_view begin, std::string_view end) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}{}{}", begin, number, end);
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) return name;
  }
}

}  // namespace taxel::studio
