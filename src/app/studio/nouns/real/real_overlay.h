// A recording of a real sensor in the window: the table, the meaning of its columns, and the alignment with the run.
#pragma once

#include <string>

#include "app/studio/nouns/real/real_state.h"
#include "core/run/frame.h"

namespace taxel::studio {

/// Returns the readings of a sensor so far, as rows of the plot. Empty if there are none.
TaxelSeries run_series(const SimFramePtr& frame, int sensor);

/// Returns the path of the mapping file FILE.recmap.json next to a table.
std::string mapping_file_of(const std::string& table);

class RealOverlay {
 public:
  /// Reads a table for the dialog, with the mapping file next to the table, or with a guessed mapping. Throws Error.
  void read(const std::string& path, const std::vector<int>& taxel_ids, ui::RealState& state);
  /// Applies the dialog's mapping to the table. Stores the reason in `state.problem` if the mapping is not valid.
  void look(ui::RealState& state) const;
  /// Displays the recording, aligned with the run if possible. Returns false, with the reason in `state.problem`, if
  /// the recording cannot be displayed.
  bool overlay(ui::RealState& state, const TaxelSeries& run, int sensor);
  // The functions below throw Error if the recording cannot be aligned, shifted or fitted.
  void align(const TaxelSeries& run);
  void shift(double seconds);
  void fit(const TaxelSeries& run, const FitOptions& options);
  void remove() { shown_.reset(); }

  [[nodiscard]] const ui::RealShownPtr& shown() const { return shown_; }

 private:
  std::string text_;  ///< text of the file in the dialog
  ui::RealShownPtr shown_;
};

}  // namespace taxel::studio
