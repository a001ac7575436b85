// The options of `taxel mesh --repair` and the report of a repair.
#pragma once

#include <memory>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"

namespace taxel::cli {

struct RepairOptions {
  std::string level;  ///< word of a RepairLevel, or empty if no repair is requested
  RepairRecipe recipe;
};

/// Adds --repair, --edge, --tolerance, --join and --fill. `options` must outlive the parsing.
void add_repair_options(OptionList& list, RepairOptions& options);

/// Returns the repaired mesh, or null if the options request no repair. Throws Error naming `file`.
RepairedMeshPtr repair_if_requested(const LoadedMesh& loaded, const RepairOptions& options, const std::string& file);

/// Writes all changes of a repair. Lengths in metres, areas in square metres.
void visit_repair(ReportWriter& w, const RepairReport& report);
/// Returns the changes as lines of text.
std::string repair_text(const RepairedMesh& repaired);

}  // namespace taxel::cli
