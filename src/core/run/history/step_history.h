// The latest steps of a run, as they were computed: surfaces, hits and readings are kept, not computed anew from
// MuJoCo's state, which would give other numbers. Belongs to one thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/run/history/ring_memory.h"
#include "core/run/history/step_view.h"

namespace taxel {

class StepHistory {
 public:
  /// Fewer steps than are there: the oldest are forgotten. At least one step is kept, whatever its size.
  void set_limits(const StepHistoryLimits& limits);
  [[nodiscard]] const StepHistoryLimits& limits() const { return limits_; }
  /// Of steps to come.
  void set_breakpoints(const Breakpoints& breakpoints) { breakpoints_ = breakpoints; }
  [[nodiscard]] const Breakpoints& breakpoints() const { return breakpoints_; }

  void clear();
  /// Adds the step of `view`, with the state after it: the one after last(); any other one begins a new history.
  /// Forgets the oldest where a limit is reached, and uses its memory again. Returns what to stop at first.
  std::optional<Stop> record(const StepView& view, const SimState& state);
  /// The newest step was read anew by another layout; all others stay.
  void replace_newest(const StepView& view);
  /// Forgets what came after a step, which becomes the newest. Needs contains(step).
  void cut_after(std::uint64_t step);

  [[nodiscard]] bool empty() const { return steps_.empty(); }
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  [[nodiscard]] std::uint64_t first() const { return steps_.front().state.step; }
  [[nodiscard]] std::uint64_t last() const { return steps_.back().state.step; }
  [[nodiscard]] bool contains(std::uint64_t step) const { return !empty() && step >= first() && step <= last(); }
  [[nodiscard]] std::size_t bytes() const;  ///< memory held; scenes and sensor models are not counted

  /// Fills a step as it was recorded, bit for bit. Needs contains(number).
  void fill_step(std::uint64_t number, Step& step) const;
  /// Returns a copy of a step. Needs contains(number).
  [[nodiscard]] StepPtr step(std::uint64_t number) const;
  [[nodiscard]] const SimState& state(std::uint64_t step) const { return at(step).state; }
  [[nodiscard]] std::uint64_t edition() const { return rows_.edition; }  ///< that of lanes()
  /// A copy of all rows.
  [[nodiscard]] std::shared_ptr<const HistoryLanes> lanes() const;
  /// The same. `lanes` are empty, or an earlier copy of this history's: of those only what is new is copied.
  void copy_lanes(HistoryLanes& lanes) const;

 private:
  struct Entry {
    std::shared_ptr<const SimScene> scene;
    bool finished = false;
    const std::byte* packed = nullptr;  // in memory_
    std::size_t packed_bytes = 0;
    SimState state;
  };
  void pack(const StepView& view, Entry& entry);
  [[nodiscard]] const Entry& at(std::uint64_t step) const { return steps_[static_cast<std::size_t>(step - first())]; }
  void forget_oldest();
  std::optional<Stop> add_row(const StepView& view, bool other_layout);
  /// The largest of all sensors, where it is to stop at it.
  [[nodiscard]] std::optional<Disagreement> disagreement(const StepView& view) const;
  void trim_rows();
  [[nodiscard]] ReadingHistory history_of(std::size_t first, std::size_t count) const;
  void forget_rows(std::size_t count);

  StepHistoryLimits limits_;
  Breakpoints breakpoints_;
  std::deque<Entry> steps_;
  RingMemory memory_;
  std::size_t state_bytes_ = 0;  // of one step, with what the ring itself has of it
  JumpDetector detector_;
  HistoryLanes rows_;                        // of steps_
  std::vector<std::size_t> reading_counts_;  // of each sensor
  std::vector<SensorSignal> signals_;        // scratch
};

}  // namespace taxel
