#include "app/cli/commands/mesh_topology.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/mesh/topology/decimate.h"
#include "core/mesh/topology/subdivide.h"

namespace taxel::cli {
namespace {

void visit_mesh(ReportWriter& w, const TriMesh& mesh) {
  w("vertices", mesh.vertex_count());
  w("triangles", mesh.face_count());
  w("closed", mesh.closed());
  w("area", mesh.area());
  w("volume", mesh.volume());
}

}  // namespace

void add_topology_options(OptionList& list, TopologyOptions& options) {
  list.add("--decimate", &options.decimate,
           "Collapse edges until N triangles are left, beginning with the edges that move the surface least",
           {.unit = "N"});
  list.add("--subdivide", &options.subdivide, "Split every triangle into four, N times",
           {.unit = "N", .excludes = {"--decimate"}});
  list.add(
      "--scheme", &options.scheme,
      "Scheme of --subdivide: midpoint does not move the surface, loop smooths and shrinks it (Loop 1987)",
      {.unit = "WORD", .check = one_of({"midpoint", "loop"}), .default_text = "midpoint", .needs = {"--subdivide"}});
}

TopologyReport change_topology(const TriMeshPtr& mesh, const TopologyOptions& options, const std::string& file) {
  TopologyReport report{options, mesh, nullptr, {}};
  try {
    const SubdivisionScheme scheme = options.scheme == "loop" ? SubdivisionScheme::loop : SubdivisionScheme::midpoint;
    report.after = std::make_shared<const TriMesh>(options.decimate ? decimate(*mesh, *options.decimate)
                                                                    : subdivide(*mesh, *options.subdivide, scheme));
  } catch (const Error& e) {
    throw Error(file, e.where(), e.message());
  }
  report.distance = measure_surface_distance(report.before, report.after);
  return report;
}

void TopologyReport::visit(ReportWriter& w) const {
  w("change", options.decimate ? "decimate" : "subdivide");
  w("asked", options.decimate ? *options.decimate : *options.subdivide);
  if (options.subdivide) w("scheme", options.scheme);
  w.object("before", [&](ReportWriter& mesh) { visit_mesh(mesh, *before); });
  w.object("after", [&](ReportWriter& mesh) { visit_mesh(mesh, *after); });
  w("distance_max", distance.largest);
  w("distance_rms", distance.rms);
}

std::string TopologyReport::text() const {
  std::string text = options.decimate
                         ? fmt::format("decimated from {} to {} triangles\n", before->face_count(), after->face_count())
                         : fmt::format("subdivided from {} to {} triangles by {}\n", before->face_count(),
                                       after->face_count(), options.scheme);
  if (options.decimate && after->face_count() > *options.decimate)
    text += fmt::format("{} were requested: removing another edge would fold the mesh or change its topology\n",
                        *options.decimate);
  text +=
      fmt::format("{} before, {} after\n", before->closed() ? "closed" : "open", after->closed() ? "closed" : "open");
  text += fmt::format("largest distance of the surfaces {:.4g} m, rms {:.4g} m\n", distance.largest, distance.rms);
  text += fmt::format("area {:.6g} m^2 before, {:.6g} m^2 after; volume {:.6g} m^3 before, {:.6g} m^3 after\n",
                      before->area(), after->area(), before->volume(), after->volume());
  return text;
}

}  // namespace taxel::cli
