// A recording of a real sensor in the window: its table, what its columns mean, and how it lies over the run.
#pragma once

#include <string>

#include "app/studio/features/real/real_state.h"
#include "core/run/frame.h"

namespace taxel::studio {

/// The readings of a sensor so far, as rows of the plot; empty: there is none.
TaxelSeries run_series(const SimFramePtr& frame, int sensor);

/// FILE.recmap.json beside a table.
std::string mapping_file_of(const std::string& table);

class RealOverlay {
 public:
  /// Reads a table for the dialog: by the mapping beside it, else by one that is guessed. Throws Error.
  void read(const std::string& path, const std::vector<int>& taxel_ids, ui::RealState& state);
  /// What the dialog's mapping makes of it; what is wrong stands in `state.problem`.
  void look(ui::RealState& state) const;
  /// Shows it, aligned where that is possible. False: `state.problem` says why not.
  bool overlay(ui::RealState& state, const TaxelSeries& run, int sensor);
  // Throw Error where that cannot be done.
  void align(const TaxelSeries& run);
  void shift(double seconds);
  void fit(const TaxelSeries& run, const FitOptions& options);
  void remove() { shown_.reset(); }

  [[nodiscard]] const ui::RealShownPtr& shown() const { return shown_; }

 private:
  std::string text_;  ///< of the file that the dialog is about
  ui::RealShownPtr shown_;
};

}  // namespace taxel::studio
