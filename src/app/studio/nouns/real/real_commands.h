// A recording of a real sensor in the window: the commands about it, the table, the meaning of its columns, and the
// alignment with the run.
#pragma once

#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/run/frame.h"

namespace taxel::ui {

enum class RealTask {
  look,          ///< at the table again, by the mapping of the dialog
  overlay,       ///< the recording, as the dialog says
  save_mapping,  ///< next to the table
  align,
  align_at_end,  ///< a recording that waits for the end of the run
  fit,
  apply,  ///< the gains, as the layout's calibration
  remove
};
/// Reads a table of a real sensor and asks for its columns, which are guessed. An empty path asks for the file.
struct ReadRealRecording {
  std::string path;
};
struct ActOnReal {
  RealTask task = RealTask::align;
};
struct ShiftReal {
  double seconds = 0;
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ReadRealRecording& command, Host& host);
void carry_out(const ui::ActOnReal& command, Host& host);
void carry_out(const ui::ShiftReal& command, Host& host);

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
  /// the recording cannot be displayed. With `run_goes_on` it is to be aligned again at the end of the run.
  bool overlay(ui::RealState& state, const TaxelSeries& run, int sensor, bool run_goes_on = false);
  /// Leaves the recording as it is when the run ends.
  void stop_waiting();
  // The functions below throw Error if the recording cannot be aligned, shifted or fitted. They end the waiting.
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
