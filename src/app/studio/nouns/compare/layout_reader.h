// Reads steps with two layouts, and retains the readings. Used by one worker at a time.
#pragma once

#include <memory>
#include <vector>

#include "app/studio/nouns/compare/compare_state.h"
#include "core/run/event.h"
#include "core/run/frame.h"
#include "core/sim/compare/second_sensor.h"

namespace taxel::studio {

/// A second layout for one sensor of the simulation.
struct CompareJobRequest {
  ui::CompareRequest second;
  int sensor = 0;
  bool stopped = false;  ///< only the displayed step is read
  bool operator==(const CompareJobRequest&) const = default;
};

struct CompareInput {
  SimFramePtr frame;
  CompareJobRequest request;
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< steps to read besides the displayed one, or null
  /// Compares the step: frames are created again whenever anything changes.
  bool operator==(const CompareInput& other) const;
};
struct CompareResult : ui::ComparedLayouts {
  std::uint64_t generation = 0;
  std::shared_ptr<const StepsRecalled> recalled;  ///< recalled steps of the input
};

class LayoutReader {
 public:
  /// Reads the displayed and the recalled steps of the input that were not read yet. Sets `out.problem` if the second
  /// layout cannot be read. Throws Cancelled.
  void read(const CompareInput& input, CompareResult& out, Progress& progress);

 private:
  void build(const CompareInput& input, const SensorModelPtr& first, Progress& progress);
  void drop_changed_rows(const SimFrame& frame, std::size_t sensor);
  void add_row(const Step& step, std::size_t sensor, const Trace* trace);
  [[nodiscard]] ui::ComparedRowPtr displayed_row(const SimFrame& frame, std::size_t sensor) const;

  SensorCache cache_;
  ui::CompareRequest request_;  ///< request of `second_` or `problem_`
  SensorModelPtr first_;
  std::unique_ptr<const SecondSensor> second_;
  std::shared_ptr<const std::vector<Taxel>> taxels_;  ///< see ComparedLayouts::taxels_of_b
  bool equal_contact_ = true;
  std::string problem_;  ///< why there is no `second_`, or empty

  int sensor_ = -1;
  std::uint64_t runs_ = 0, generation_ = 0;  ///< run and generation that `rows_` belong to
  std::vector<ui::ComparedRowPtr> rows_;     ///< rows of the run, ascending
};

}  // namespace taxel::studio
