// `taxel mesh --decimate` and `--subdivide`: the options and the report.
#pragma once

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "core/mesh/topology/subdivide.h"
#include "core/mesh/topology/surface_distance.h"
#include "core/mesh/tri_mesh.h"

namespace taxel::cli {

/// What the options of a change of topology were set to.
struct TopologyOptions {
  std::optional<int> decimate;   ///< number of faces
  std::optional<int> subdivide;  ///< number of times
  std::string scheme = "midpoint";
  [[nodiscard]] bool is_asked() const { return decimate || subdivide; }
};

/// The mesh that the options make of another one, and how far its surface moved.
struct ChangedMesh {
  TriMeshPtr before, after;
  SurfaceDistance distance;
};

/// Adds --decimate, --subdivide and --scheme. `options` must outlive the parsing.
void add_topology_options(CLI::App& app, TopologyOptions& options);

/// Throws Error naming `file`.
ChangedMesh change_topology(const TriMeshPtr& mesh, const TopologyOptions& options, const std::string& file);

std::string topology_text(const ChangedMesh& changed, const TopologyOptions& options);
std::string topology_json(const ChangedMesh& changed, const TopologyOptions& options);

}  // namespace taxel::cli
