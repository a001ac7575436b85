// The options with which several commands change the values of a layout.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/cli/command_line.h"
#include "core/layout/file/skin_choice.h"
#include "core/layout/readout_choice.h"
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
/// Adds --tactile-state and --mcap, which need --out. Add --out first.
void add_extra_files(OptionList& list, ExtraFiles& extra);
/// Adds --error-bars.
void add_error_bars(OptionList& list, bool& error_bars);
/// Adds --aggregate and --method of the readings.
void add_readout(OptionList& list, ReadoutChoice& readout);

}  // namespace taxel::cli
