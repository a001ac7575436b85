// `taxel mesh --repair`: the options of a repair and its report.
#pragma once

#include <memory>
#include <string>

#include "app/cli/command.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"

namespace taxel::cli {

/// What the options of a repair were set to.
struct RepairOptions {
  std::string level;  ///< empty if no repair is wanted
  RepairRecipe recipe;
};

/// Adds --repair, --edge, --tolerance, --join and --fill. `options` must outlive the parsing.
void add_repair_options(CLI::App& app, RepairOptions& options);

/// Repairs a mesh as the options say, or returns null if they ask for no repair. Throws Error naming `file`.
RepairedMeshPtr repair_as_asked(const LoadedMesh& loaded, const RepairOptions& options, const std::string& file);

/// The report as lines of text.
std::string repair_text(const RepairedMesh& repaired);

}  // namespace taxel::cli
