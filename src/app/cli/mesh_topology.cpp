#include "app/cli/mesh_topology.h"

#include <fmt/format.h>

#include "core/mesh/topology/decimate.h"

namespace taxel::cli {

void add_topology_options(CLI::App& app, TopologyOptions& options) {
  CLI::Option* decimate =
      app.add_option("--decimate", options.decimate,
                     "Collapse edges until N triangles are left, those first that move the surface least");
  decimate->type_name("N");
  CLI::Option* subdivide = app.add_option("--subdivide", options.subdivide, "Split every triangle into four, N times");
  subdivide->type_name("N")->excludes(decimate);
  app.add_option("--scheme", options.scheme,
                 "Of --subdivide: midpoint keeps the surface, loop smooths and shrinks it (Loop 1987)")
      ->check(CLI::IsMember({"midpoint", "loop"}))
      ->needs(subdivide)
      ->type_name("WORD")
      ->default_str("midpoint");
}

ChangedMesh change_topology(const TriMeshPtr& mesh, const TopologyOptions& options, const std::string& file) {
  ChangedMesh changed{mesh, nullptr, {}};
  try {
    const SubdivisionScheme scheme = options.scheme == "loop" ? SubdivisionScheme::loop : SubdivisionScheme::midpoint;
    changed.after = std::make_shared<const TriMesh>(options.decimate ? decimate(*mesh, *options.decimate)
                                                                     : subdivide(*mesh, *options.subdivide, scheme));
  } catch (const Error& e) {
    throw Error(file, e.where(), e.message());
  }
  changed.distance = measure_surface_distance(changed.before, changed.after);
  return changed;
}

std::string topology_text(const ChangedMesh& changed, const TopologyOptions& options) {
  const TriMesh &before = *changed.before, &after = *changed.after;
  std::string text = options.decimate
                         ? fmt::format("decimated from {} to {} triangles\n", before.face_count(), after.face_count())
                         : fmt::format("subdivided from {} to {} triangles by {}\n", before.face_count(),
                                       after.face_count(), options.scheme);
  if (options.decimate && after.face_count() > *options.decimate)
    text += fmt::format("asked for were {}: no further edge can go without a fold or another topology\n",
                        *options.decimate);
  text += fmt::format("{} before, {} after\n", before.closed() ? "closed" : "open", after.closed() ? "closed" : "open");
  text +=
      fmt::format("surfaces apart by at most {:.4g} m, rms {:.4g} m\n", changed.distance.largest, changed.distance.rms);
  text += fmt::format("area {:.6g} m^2 before, {:.6g} m^2 after; volume {:.6g} m^3 before, {:.6g} m^3 after\n",
                      before.area(), after.area(), before.volume(), after.volume());
  return text;
}

}  // namespace taxel::cli
