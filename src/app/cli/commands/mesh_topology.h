// The options of `taxel mesh --decimate` and `--subdivide` and the report of the change.
#pragma once

#include <optional>
#include <string>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/mesh/topology/surface_distance.h"
#include "core/mesh/tri_mesh.h"

namespace taxel::cli {

struct TopologyOptions {
  std::optional<int> decimate;   ///< requested number of faces
  std::optional<int> subdivide;  ///< requested number of subdivisions
  std::string scheme = "midpoint";
  [[nodiscard]] bool is_requested() const { return decimate || subdivide; }
};

/// A mesh before and after a change of its topology, and the distance between both surfaces.
struct TopologyReport {
  TopologyOptions options;
  TriMeshPtr before, after;
  SurfaceDistance distance;

  void visit(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

/// Adds --decimate, --subdivide and --scheme. `options` must outlive the parsing.
void add_topology_options(OptionList& list, TopologyOptions& options);

/// Decimates or subdivides a mesh. Throws Error naming `file`.
TopologyReport change_topology(const TriMeshPtr& mesh, const TopologyOptions& options, const std::string& file);

}  // namespace taxel::cli
