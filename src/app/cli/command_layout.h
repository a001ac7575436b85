// The sensor of a command, a layout file or the fingertip that is built into the program, and the options with which
// several commands change its values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command_line.h"
#include "core/document/batch/job_sources.h"
#include "core/layout/user_choices.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/host/write_recording.h"

namespace taxel::cli {

/// Values that replace those of a layout.
struct LayoutOptions {
  std::optional<double> density;  ///< samples per square metre
  std::optional<std::uint64_t> seed;
  ReadoutChoice readout;
  bool as_in_the_paper = false;  ///< body and samples of the paper's demo, below the values above
  bool preview = false;          ///< samples before they are polished
  SkinChoice skin;
};

// The variables of all options must outlive the parsing.

/// Adds --mesh, --scale and --sensor, which complete the layout of another program.
void add_skin(OptionList& list, SkinChoice& choice);
/// Returns the scale of "0.001" or "1,1,-1". Throws Error naming the command.
dvec3 parse_scale(const std::string& command, const std::string& text);
/// Adds --density and --seed of the samples.
void add_sampling(OptionList& list, LayoutOptions& options);
/// Adds --tactile-state, which needs --out. Add --out first.
void add_extra_files(OptionList& list, ExtraFiles& extra);
/// Adds --error-bars.
void add_error_bars(OptionList& list, bool& error_bars);
/// Adds --aggregate and --method of the readings.
void add_readout(OptionList& list, ReadoutChoice& readout);

/// Returns the built-in fingertip with its mesh.
DefaultLayout default_source();

/// Compiles the model of `layout_file`, or of the built-in fingertip if it is empty. Values of `over` replace those of
/// the layout. Prints notes and warnings of the layout. Throws Error, or Cancelled after a signal.
/// `file_face_of` (optional) receives, for each face of the model's loaded mesh, the number of its triangle in the mesh
/// file. `cache` (optional) retains the parts of the model.
SensorModelPtr load_model(const std::string& layout_file, const LayoutOptions& over, Console& console,
                          std::vector<int>* file_face_of = nullptr, SensorCache* cache = nullptr);

}  // namespace taxel::cli
