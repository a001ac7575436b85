// The latest steps of a run with their surfaces and readings, which could not be computed again from MuJoCo's state
// with the same bits. Belongs to one thread.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/run/history/breakpoints.h"
#include "core/run/history/lanes.h"
#include "core/run/step.h"

namespace taxel {

/// Memory for pieces of any size that are freed oldest first or newest first. Pieces are placed one after the other in
/// large blocks, which are reused when they are empty: a full ring allocates no memory. While the ring grows, a
/// separate thread prepares the next block, because the first access to new memory costs more than filling it and
/// evicts the caches of the thread that fills. Pieces do not move.
class RingMemory {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 21;  ///< a huge page [bytes]

  /// Adds a piece with uninitialized bytes.
  std::byte* push(std::size_t size);
  /// Reduces the newest piece from `size` to `used` bytes.
  void shrink_back(std::size_t size, std::size_t used) { blocks_.back().used -= size - used; }
  /// Frees the oldest piece. Needs a piece.
  void pop_front();
  /// Frees the newest piece, which has `size` bytes. Needs a piece.
  void pop_back(std::size_t size);
  void clear();

  [[nodiscard]] std::size_t bytes() const;  ///< size of all blocks

 private:
  struct Free {
    void operator()(std::byte* block) const { std::free(block); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> data;
    std::size_t size = 0, used = 0, pieces = 0;
  };
  static Block make_block(std::size_t size);
  [[nodiscard]] Block take_block(std::size_t size);
  void retire(Block block);

  std::deque<Block> blocks_;  // blocks with at least one piece
  Block spare_;               // the block that became empty last
  std::future<Block> next_;   // the block that is being prepared
};

/// The rows of the recorded steps, and the events at which the simulation stops.
class HistoryRows {
 public:
  [[nodiscard]] const HistoryLanes& lanes() const { return rows_; }
  [[nodiscard]] std::size_t bytes() const;  ///< allocated memory

  void clear();
  /// Adds the row of a step. Returns the first event at which to stop.
  std::optional<Stop> add(const StepView& view, bool other_layout, const Breakpoints& breakpoints);
  /// Replaces the readings of the newest row, which another layout has read.
  void replace_newest(const StepView& view);
  /// Removes the oldest rows until `retained` are left, and keeps their largest readings and numbers of touched steps.
  void trim_to(std::size_t retained);
  /// Removes the `count` newest rows, of which there are more. Others may replace them, so that the edition changes.
  void cut(std::size_t count);

 private:
  /// The changes of a sensor's readings in one step that were jumps when the step was recorded.
  struct RecordedJumps {
    std::uint64_t step = 0;
    std::size_t sensor = 0;
    bool at_equal_force = false;
    Breakpoints limits;
    double least = 0;                             ///< SensorSignal::least
    std::vector<std::pair<int, double>> changes;  ///< taxels, with their changes
  };
  /// Finds the jumps of a sensor in the newest row, marks the row, and keeps them for mark_jumps().
  void remember_jumps(RecordedJumps jumps);
  /// Marks the rows again in which a taxel has jumped, by the largest readings of the run so far. Returns whether a
  /// mark has changed.
  bool mark_jumps();
  /// Marks one row and sensor. Returns whether the mark has changed.
  bool mark_jump(const RecordedJumps& jumps);
  /// Returns the largest disagreement of all sensors, if it exceeds the breakpoint's threshold.
  [[nodiscard]] std::optional<Disagreement> disagreement(const StepView& view, const Breakpoints& breakpoints) const;
  [[nodiscard]] ReadingHistory history_of(std::size_t first, std::size_t count) const;

  HistoryLanes rows_;
  JumpDetector detector_;
  std::deque<RecordedJumps> jumps_;          // in the order of their steps
  std::vector<std::size_t> reading_counts_;  // by sensor
  std::vector<SensorSignal> signals_;        // scratch
};

class StepHistory {
 public:
  /// Forgets the oldest steps beyond the limits. At least one step is retained, whatever its size.
  void set_limits(const StepHistoryLimits& limits);
  [[nodiscard]] const StepHistoryLimits& limits() const { return limits_; }
  /// Sets the breakpoints for later steps.
  void set_breakpoints(const Breakpoints& breakpoints) { breakpoints_ = breakpoints; }
  [[nodiscard]] const Breakpoints& breakpoints() const { return breakpoints_; }

  void clear();
  /// Adds the step `view` and the state after it. A step other than last() + 1 begins a new history. Forgets the oldest
  /// steps beyond the limits, and reuses their memory. Returns the first event at which to stop.
  std::optional<Stop> record(const StepView& view, const SimState& state);
  /// Replaces the newest step, which was read again with another layout.
  void replace_newest(const StepView& view);
  /// Forgets all steps after `step`. Needs contains(step).
  void cut_after(std::uint64_t step);

  [[nodiscard]] bool empty() const { return steps_.empty(); }
  [[nodiscard]] std::size_t size() const { return steps_.size(); }
  [[nodiscard]] std::uint64_t first() const { return steps_.front().state.step; }
  [[nodiscard]] std::uint64_t last() const { return steps_.back().state.step; }
  [[nodiscard]] bool contains(std::uint64_t step) const { return !empty() && step >= first() && step <= last(); }
  [[nodiscard]] std::size_t bytes() const;  ///< allocated memory, without scenes and sensor models

  /// Fills a step as it was recorded, bit for bit. Needs contains(number).
  void fill_step(std::uint64_t number, Step& step) const;
  /// Returns a copy of a step. Needs contains(number).
  [[nodiscard]] StepPtr step(std::uint64_t number) const;
  [[nodiscard]] const SimState& state(std::uint64_t step) const { return at(step).state; }
  [[nodiscard]] std::uint64_t edition() const { return rows_.lanes().edition; }  ///< edition of lanes()
  /// Returns a copy of all rows.
  [[nodiscard]] std::shared_ptr<const HistoryLanes> lanes() const;
  /// Copies all rows to `lanes`, which is empty or an earlier copy from this history; then only new rows are copied.
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

  StepHistoryLimits limits_;
  Breakpoints breakpoints_;
  std::deque<Entry> steps_;
  RingMemory memory_;
  std::size_t state_bytes_ = 0;  // size of one Entry with its state
  HistoryRows rows_;             // rows of steps_
};

}  // namespace taxel
