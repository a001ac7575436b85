// Undo and redo by keeping the former projects, so no edit needs an inverse.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/document/edit.h"

namespace taxel {

/// A gesture (a drag, typing a number). All edits of one gesture make one step.
struct Gesture {
  std::uint64_t number = 0;  ///< new for each gesture, from 1; 0 if the edit is a step of its own
  /// True if the edit applies to the project before the gesture and replaces earlier edits of the gesture. A drag with
  /// such edits ends with the same project on every way of the pointer. False if the edit adds to earlier edits.
  bool from_start = false;
};

struct HistoryLimits {
  std::size_t steps = 1000;
  /// Largest number of bytes of all kept projects with their heap memory. A painted region that several projects share
  /// counts once. The oldest steps are dropped first; one step back is always possible.
  std::size_t bytes = std::size_t{256} << 20U;
};

/// A step of the history, as it is listed.
struct HistoryStep {
  std::uint64_t revision = 0;  ///< revision of the project after the step
  std::string name;            ///< name of the edit; empty for the document as it was opened
  bool operator==(const HistoryStep&) const = default;
};

/// The present project, the earlier ones and the undone ones. Projects are immutable and may be used from any thread
/// and outlive the history; the history itself belongs to one thread.
class History {
 public:
  /// Begins with an opened or empty document, which counts as saved.
  explicit History(Project project, HistoryLimits limits = {});

  [[nodiscard]] const ProjectPtr& project() const { return steps_[now_].project; }
  /// The revision of the present project. Every project has its own number; undo returns to the former number.
  [[nodiscard]] std::uint64_t revision() const { return steps_[now_].revision; }

  /// Applies an edit and drops the undone steps. An edit that changes nothing makes no step. Returns true if the
  /// project changed. Throws Error as apply_edit() does, without any change.
  bool apply(const Edit& edit, Gesture gesture = {});
  /// Restores the project before the gesture, bit for bit, and the undone steps that the gesture dropped. Does nothing
  /// if the gesture is not the last step.
  void cancel(std::uint64_t gesture);
  /// Ends the gesture: the next edit makes another step, even with the same number. Undo and redo end a gesture too.
  void end_gesture();

  [[nodiscard]] bool can_undo() const { return now_ > 0; }
  [[nodiscard]] bool can_redo() const { return now_ + 1 < steps_.size(); }
  // Do nothing if no step is left.
  void undo();
  void redo();
  /// Undoes or redoes as many steps as it takes until the project has this revision. Does nothing if no step has it.
  void go_to(std::uint64_t revision);
  /// Returns all steps, oldest first. The present step has the index undo_depth().
  [[nodiscard]] std::vector<HistoryStep> steps() const;
  [[nodiscard]] std::string undo_name() const;  ///< "Undo Move taxel 3", or "Undo" if no step is left
  [[nodiscard]] std::string redo_name() const;
  [[nodiscard]] std::size_t undo_depth() const { return now_; }
  [[nodiscard]] std::size_t redo_depth() const { return steps_.size() - now_ - 1; }

  /// Marks the present project as saved. It counts as saved again when undo or redo returns to it.
  void mark_saved() { saved_revision_ = revision(); }
  /// Marks a revision as saved: the revision that a save in the background has written.
  void mark_saved(std::uint64_t revision) { saved_revision_ = revision; }
  /// Marks no revision as saved, as for a recovered document.
  void mark_unsaved() { saved_revision_ = 0; }
  [[nodiscard]] std::uint64_t saved_revision() const { return saved_revision_; }
  [[nodiscard]] bool dirty() const { return revision() != saved_revision_; }

  [[nodiscard]] std::size_t bytes() const;  ///< bytes of all projects, see HistoryLimits

 private:
  struct Step {
    ProjectPtr project;
    std::uint64_t revision = 0;
    std::string name;           ///< name of the edit that made the step
    std::uint64_t gesture = 0;  ///< number of the gesture, or 0
    std::size_t bytes = 0;      ///< bytes of the project without the region
  };
  [[nodiscard]] bool continues(std::uint64_t gesture) const;
  void drop_oldest();

  HistoryLimits limits_;
  std::deque<Step> steps_;    ///< oldest first; never empty
  std::size_t now_ = 0;       ///< index of the present step
  std::vector<Step> undone_;  ///< steps that the present gesture dropped, for cancel()
  std::uint64_t last_revision_ = 0, saved_revision_ = 0;
};

/// Returns the bytes of a project with its heap memory, without the region.
std::size_t bytes_of(const Project& project);
/// Returns the bytes of a region.
std::size_t bytes_of(const FaceSet& region);

}  // namespace taxel
