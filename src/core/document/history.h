// Undo and redo of everything, by keeping the projects that there were: no edit has an inverse to get wrong.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "core/document/edit.h"

namespace taxel {

/// Edits of one gesture (a drag, a number being typed) make one step.
struct Gesture {
  std::uint64_t number = 0;  ///< new for each gesture, from 1; 0: the edit is a step of its own
  /// The edit starts from where the gesture began and replaces what it has done so far; otherwise it adds to that.
  /// A drag that replaces ends the same whatever way it took.
  bool from_start = false;
};

struct HistoryLimits {
  std::size_t steps = 1000;
  /// Bytes of all projects kept: each with what it holds on the heap; a painted region that several share once. The
  /// oldest steps go first; one step back is always possible.
  std::size_t bytes = std::size_t{256} << 20U;
};

/// The present project, those before it and those undone. Projects are immutable and may be used from any thread as
/// long as one likes; the history itself belongs to one thread.
class History {
 public:
  /// Begins saved: an opened or empty document.
  explicit History(Project project, HistoryLimits limits = {});

  [[nodiscard]] const ProjectPtr& project() const { return steps_[now_].project; }
  /// Of the present project: another number for every project there was; undo comes back to the number it had.
  [[nodiscard]] std::uint64_t revision() const { return steps_[now_].revision; }

  /// Throws what apply_edit throws; then nothing has changed. An edit that changes nothing is no step. What was
  /// undone is gone. Returns whether the project changed.
  bool apply(const Edit& edit, Gesture gesture = {});
  /// Takes back what the gesture did, bit for bit, and what it cost: undone steps are there again. Nothing where the
  /// gesture is not the last thing that happened.
  void cancel(std::uint64_t gesture);
  /// What follows is another step, whatever its number. Undo and redo end a gesture too.
  void end_gesture();

  [[nodiscard]] bool can_undo() const { return now_ > 0; }
  [[nodiscard]] bool can_redo() const { return now_ + 1 < steps_.size(); }
  void undo();  ///< nothing where nothing is left
  void redo();
  [[nodiscard]] std::string undo_name() const;  ///< "Undo Move taxel 3"; "Undo" where nothing is left
  [[nodiscard]] std::string redo_name() const;
  [[nodiscard]] std::size_t undo_depth() const { return now_; }
  [[nodiscard]] std::size_t redo_depth() const { return steps_.size() - now_ - 1; }

  /// The present project is on disk now. It stays so when it comes back by undo or redo.
  void mark_saved() { saved_revision_ = revision(); }
  /// The revision that is on disk. For a save in the background: mark_saved(revision that was written).
  void mark_saved(std::uint64_t revision) { saved_revision_ = revision; }
  /// Nothing of this document is on disk: a recovered one.
  void mark_unsaved() { saved_revision_ = 0; }
  [[nodiscard]] std::uint64_t saved_revision() const { return saved_revision_; }
  [[nodiscard]] bool dirty() const { return revision() != saved_revision_; }

  [[nodiscard]] std::size_t bytes() const;  ///< as HistoryLimits counts them

 private:
  struct Step {
    ProjectPtr project;
    std::uint64_t revision = 0;
    std::string name;           ///< of the edit that led here
    std::uint64_t gesture = 0;  ///< that it belongs to
    std::size_t bytes = 0;      ///< without the region
  };
  [[nodiscard]] bool continues(std::uint64_t gesture) const;
  void drop_oldest();

  HistoryLimits limits_;
  std::deque<Step> steps_;    ///< oldest first; never empty
  std::size_t now_ = 0;       ///< the present one
  std::vector<Step> undone_;  ///< what the present gesture cut off, for cancel
  std::uint64_t last_revision_ = 0, saved_revision_ = 0;
};

/// Bytes of a project with what it holds on the heap, without the region.
std::size_t bytes_of(const Project& project);
/// Bytes of a region.
std::size_t bytes_of(const FaceSet& region);

}  // namespace taxel
