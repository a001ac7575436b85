// Commands about a recording of a real sensor.
#pragma once

#include "app/studio/frame/command.h"

namespace taxel::ui {

enum class RealTask {
  look,          ///< at the table again, by the mapping of the dialog
  overlay,       ///< the recording, as the dialog says
  save_mapping,  ///< next to the table
  align,
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

}  // namespace taxel::studio
